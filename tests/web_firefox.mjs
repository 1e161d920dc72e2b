// web_firefox.mjs - the program in Debian's Firefox, driven by WebDriver BiDi: a picture of each chapter against its
// reference, the hands, the clock of a hidden page. It gives WebGL only where there is a display, so tests/web.sh
// starts a virtual one. Playwright asks of it what this Firefox does not know yet; hence a driver of our own.
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {WebSocket} from '../build/node/node_modules/ws/wrapper.mjs';
import {PATIENCE, check, compare, draw, finish, frames, keep, loadProgram, pictures, rest, serve, start, state, until, WEB} from './web_browser.mjs';

const PREFERENCES = {
    'webgl.force-enabled': true, 'browser.shell.checkDefaultBrowser': false, 'browser.aboutwelcome.enabled': false,
    'datareporting.policy.dataSubmissionEnabled': false, 'app.normandy.enabled': false, 'network.captive-portal-service.enabled': false,
    'network.connectivity-service.enabled': false, 'services.settings.server': 'data:,', 'browser.topsites.contile.enabled': false,
};
const KEYS = {Escape: '\uE00C', Tab: '\uE004'};

// ---- A page, as far as web_browser.mjs asks for one ----

class Page {
    static async open() {
        const page = new Page();
        page.home = fs.mkdtempSync(path.join(os.tmpdir(), 'web-firefox-'));
        fs.writeFileSync(`${page.home}/user.js`, Object.entries(PREFERENCES).map(([name, value]) => `user_pref("${name}", ${JSON.stringify(value)});\n`).join(''));
        page.child = spawn(process.env.FIREFOX || ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find(fs.existsSync), ['--remote-debugging-port=0', '--no-remote', '--profile', page.home], {
            env: {...process.env, HOME: page.home, MOZ_CRASHREPORTER_DISABLE: '1', LIBGL_ALWAYS_SOFTWARE: '1', GALLIUM_DRIVER: 'llvmpipe'},
            stdio: ['ignore', 'ignore', 'pipe'],
        });
        const at = await new Promise((found, lost) => {
            let log = '';
            page.child.stderr.on('data', (text) => {
                log += text;
                const match = /BiDi listening on (ws:\S+)/.exec(log);
                if (match) found(match[1]);
            });
            page.child.on('exit', (status) => lost(new Error(`Firefox ended with ${status}: ${log.slice(-500)}`)));
        });
        page.socket = new WebSocket(`${at}/session`);
        await new Promise((opened, failed) => page.socket.on('open', opened).on('error', failed));
        page.waiting = new Map();
        page.last = 0;
        page.said = [];
        page.socket.on('message', (text) => page.hear(JSON.parse(text)));
        page.version = (await page.send('session.new', {capabilities: {}})).capabilities.browserVersion;
        await page.send('session.subscribe', {events: ['log.entryAdded']});
        page.context = (await page.send('browsingContext.create', {type: 'tab'})).context;
        await page.send('browsingContext.setViewport', {context: page.context, viewport: {width: 640, height: 500}});
        return page;
    }

    hear(message) {
        if (message.method === 'log.entryAdded' && message.params.level === 'error') this.said.push(message.params.text);
        const wait = this.waiting.get(message.id);
        this.waiting.delete(message.id);
        if (message.type === 'error') wait?.[1](new Error(`${message.error}: ${message.message}`));
        else wait?.[0](message.result);
    }

    send(method, params) {
        return new Promise((done, failed) => {
            this.waiting.set(++this.last, [done, failed]);
            this.socket.send(JSON.stringify({id: this.last, method, params}));
        });
    }

    async goto(url) {
        await this.send('browsingContext.navigate', {context: this.context, url, wait: 'complete'});
    }

    async evaluate(work, value) {
        const answer = await this.send('script.callFunction', {
            functionDeclaration: `async (text) => JSON.stringify([await (${work})(JSON.parse(text)[0])])`,
            arguments: [{type: 'string', value: JSON.stringify([value])}], awaitPromise: true, target: {context: this.context},
        });
        if (answer.type === 'exception') throw new Error(answer.exceptionDetails.text);
        return JSON.parse(answer.result.value)[0];
    }

    act(type, actions, parameters = {}) {
        return this.send('input.performActions', {context: this.context, actions: [{type, id: type, actions, ...parameters}]});
    }

    press(key) {
        const value = KEYS[key] || key;
        return this.act('key', [{type: 'keyDown', value}, {type: 'keyUp', value}]);
    }

    // From one place of the page to another, with the button down; a click where they are the same.
    drag(from, to, type = 'mouse') {
        const actions = [{type: 'pointerMove', x: from[0], y: from[1]}, {type: 'pointerDown', button: 0}];
        for (let i = 1; i <= 8 && (from[0] !== to[0] || from[1] !== to[1]); i++)
            actions.push({type: 'pointerMove', x: Math.round(from[0] + (to[0] - from[0]) * i / 8), y: Math.round(from[1] + (to[1] - from[1]) * i / 8)});
        return this.act('pointer', [...actions, {type: 'pointerUp', button: 0}], {parameters: {pointerType: type}});
    }

    wheel(x, y, deltaY) {
        return this.act('wheel', [{type: 'scroll', x, y, deltaX: 0, deltaY}]);
    }

    async close() {
        const ended = new Promise((done) => { this.child.removeAllListeners('exit').on('exit', done); });
        await this.send('browser.close', {}).catch(() => {});
        await ended;
        fs.rmSync(this.home, {recursive: true, force: true, maxRetries: 10});
    }
}

// ---- Pictures ----

const server = await serve(WEB);
const page = await Page.open();
await page.goto(`${server.at}/test.html`);
await page.evaluate(loadProgram);
console.log(`# Firefox ${page.version}`);
const OUT = 'build/web-test/firefox';
fs.mkdirSync(OUT, {recursive: true});
for (const row of pictures().filter((row) => row.name === row.stem)) {
    const got = await draw(page, row.stem, row.line), file = `${OUT}/${row.name}.png`;
    if (got.picture) keep(got.picture, file);
    const compared = got.picture ? await compare(row.name, file) : {same: false, says: ''};
    check(`${row.name} in Firefox`, compared.same, got.status, compared.says, got.lines.slice(0, 4).join(' | '));
}

// ---- The hands ----

const parameter = (now, name) => now.parameters.find((p) => p.name === name).value[0];
check('a chapter starts', await start(page, '03_shadows') === 0);
await page.evaluate(() => { document.getElementById('canvas').focus(); });
await page.press('Escape');
let now = await until(page, (s) => s.paused);
check('Escape pauses', now.paused);
await page.press('4');
now = await until(page, (s) => s.view === 'steps');
check('4 shows the steps', now.view === 'steps');
const eye = now.camera;
await page.drag([100, 90], [160, 100]);
now = await until(page, (s) => s.camera[3] !== eye[3]);
check('a drag turns the eye', now.camera[3] !== eye[3] && now.camera[4] !== eye[4], eye, now.camera);
await page.drag([160, 110], [160, 110]);
now = await until(page, (s) => s.probe !== undefined);
check('a click marches the ray of its pixel', now.probe?.steps > 0 && now.pixel.join() === '160,69', now.pixel);
const length = parameter(now, 'focalLength');
await page.wheel(160, 90, -300);
now = await until(page, (s) => parameter(s, 'focalLength') > length);
check('the wheel is the program\'s', parameter(now, 'focalLength') > length && await page.evaluate(() => window.scrollY) === 0);
await rest(page);
const before = now.camera;
await page.drag([100, 90], [150, 90], 'touch');
now = await until(page, (s) => s.camera[3] !== before[3]);
check('a finger that is drawn over the picture turns the eye', now.camera[3] !== before[3], before, now.camera);
await page.press('Tab');
check('Tab leaves the canvas', await page.evaluate(() => document.activeElement.id !== 'canvas'));
await page.wheel(160, 90, 120);
await page.evaluate(() => new Promise((done) => { const turn = () => window.scrollY > 0 ? done() : requestAnimationFrame(turn); turn(); }));
check('without the focus the wheel scrolls the page', await page.evaluate(() => window.scrollY) > 0);

// ---- Away ----

await page.evaluate(() => { window.program.call('live_pause', 0); window.scrollTo(0, 2000); });
await page.evaluate(() => new Promise((done) => { const turn = () => window.program.visible ? requestAnimationFrame(turn) : done(); turn(); }));
const away = await state(page);
await frames(page, 25);
check('one that is scrolled away stands still', (await state(page)).time === away.time);
check('no error in the console', page.said.length === 0, page.said.slice(0, 5));
finish();
await page.close();
server.close();
