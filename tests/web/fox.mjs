// fox.mjs - drives Debian's Firefox for the tests through WebDriver BiDi. A Page has the functions that browser.mjs
// needs. Firefox offers WebGL only if there is a display, so tests/run starts a virtual one. Playwright requires
// features that this Firefox does not have yet, so the tests have their own driver.
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {WebSocket} from '../../build/node/node_modules/ws/wrapper.mjs';

const PREFERENCES = {
    'webgl.force-enabled': true, 'browser.shell.checkDefaultBrowser': false, 'browser.aboutwelcome.enabled': false,
    'datareporting.policy.dataSubmissionEnabled': false, 'app.normandy.enabled': false, 'network.captive-portal-service.enabled': false,
    'network.connectivity-service.enabled': false, 'services.settings.server': 'data:,', 'browser.topsites.contile.enabled': false,
};
const KEYS = {Escape: '\uE00C', Tab: '\uE004', Enter: '\uE006', ArrowRight: '\uE014'};

export class Page {
    static async open(viewport = {width: 640, height: 500}) {
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
            page.child.on('exit', (status) => lost(new Error(`Firefox exited with status ${status}: ${log.slice(-500)}`)));
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
        await page.send('browsingContext.setViewport', {context: page.context, viewport});
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

    // Drag from one position in the page to another. If the positions are equal, this is a click.
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
