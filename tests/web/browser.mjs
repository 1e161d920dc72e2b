// browser.mjs - the code that the browser tests share: a server for a folder, Chromium on Mesa's software renderer, a
// page with one program, waits for a state, and TAP output.
//
// No result depends on a clock. A test waits until an expected event has happened. To check that an event does not
// happen, it lets a number of the page's frames pass.
import {execFile} from 'node:child_process';
import fs from 'node:fs';
import {chromium} from '../../build/node/node_modules/playwright-core/index.mjs';
import {folderServer} from '../../docs/web/serve.mjs';

const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>test</title><link rel="icon" href="data:,">
<style>body { margin: 0 } canvas { display: block; width: 320px; height: 180px; touch-action: none }</style>
<canvas id="canvas" tabindex="0" aria-label="picture"></canvas><div id="below" style="height: 3000px"></div>`;

// ---- TAP ----

let count = 0, failed = 0;

export function check(name, right, ...more) {
    count++;
    if (!right) failed++;
    console.log(`${right ? 'ok' : 'not ok'} ${count} - ${name}`);
    if (!right && more.length > 0) console.log(`# ${more.map((x) => typeof x === 'string' ? x : JSON.stringify(x)).join(' ')}`);
    if (!right && name.endsWith(process.env.WEB_UNTIL ?? '\n')) process.exit(1); // WEB_UNTIL names the check that detects a mutation; the other checks are then skipped
    return right;
}

// Print the processor time and the TAP plan. Call this before the browsers are closed, because their time is included.
export function finish() {
    console.log(`# ${(processors() + process.cpuUsage().user / 1e6).toFixed(0)} s of processor time`);
    console.log(`1..${count}`);
    process.exitCode = failed > 0 ? 1 : 0;
}

// ---- The server ----

// The folders under test: the programs alone, and the site. To test a copy of a folder, such as one with a mutation,
// set WEB_FOLDER or SITE_FOLDER.
export const WEB = process.env.WEB_FOLDER || 'build/web', SITE = process.env.SITE_FOLDER || 'build/site';

// Serve a folder to this machine only; /test.html is a page with a canvas. Returns the server's address and a function
// that closes the server.
export async function serve(folder) {
    const server = folderServer(folder, {'/test.html': PAGE});
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    return {at: `http://127.0.0.1:${server.address().port}`, close: () => server.close()};
}

// ---- The browser ----

export const PATIENCE = Number(process.env.WEB_PATIENCE || 180e3); // milliseconds after which a test stops waiting

// Start Chromium without smooth scrolling, because a position measured during a smooth scroll would depend on the
// clock.
//   angle  the renderer: 'gl-egl' is Mesa, 'swiftshader' is Chromium's own, and 'none' disables the GPU
export function launch(angle = 'gl-egl') {
    return chromium.launch({
        executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
        headless: true,
        timeout: PATIENCE,
        env: {...process.env, LIBGL_ALWAYS_SOFTWARE: '1', GALLIUM_DRIVER: 'llvmpipe'},
        args: [...(angle === 'none' ? ['--disable-gpu'] : ['--use-gl=angle', `--use-angle=${angle}`]), '--no-sandbox', '--ignore-gpu-blocklist', '--enable-unsafe-swiftshader',
            '--force-color-profile=srgb', '--disable-smooth-scrolling'],
    });
}

// Run this in a page before its scripts. It imitates a driver that compiles on separate threads, and whose programs are
// ready once window.compiled is true.
export function threads() {
    const {getExtension, getProgramParameter} = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getExtension = function (name) { return name === 'KHR_parallel_shader_compile' ? {} : getExtension.call(this, name); };
    WebGL2RenderingContext.prototype.getProgramParameter = function (program, name) { return name === 0x91B1 ? window.compiled === true : getProgramParameter.call(this, program, name); };
}

// Run this in a page. It loads a program for the page's canvas, stores the program's messages, pictures and events, and
// counts the calls of three WebGL functions.
export async function loadProgram() {
    window.calls = {};
    for (const name of ['drawArrays', 'blitFramebuffer', 'readPixels']) {
        const own = WebGL2RenderingContext.prototype[name];
        window.calls[name] = 0;
        WebGL2RenderingContext.prototype[name] = function (...values) {
            window.calls[name]++;
            return own.apply(this, values);
        };
    }
    const {Program} = await import('/program.js');
    window.lines = [];
    window.pictures = [];
    window.events = [];
    window.program = await Program.load(document.getElementById('canvas'), {
        onLine: (text, isError) => window.lines.push(isError ? `! ${text}` : text),
        onPicture: (data, name) => {
            const canvas = document.createElement('canvas');
            canvas.width = data.width;
            canvas.height = data.height;
            canvas.getContext('2d').putImageData(data, 0, 0);
            window.pictures.push({name, url: canvas.toDataURL('image/png')});
        },
        onEnd: () => window.events.push('end'),
        onLost: () => window.events.push('lost'),
        onFound: () => window.events.push('found'),
    });
}

// Open an empty page. Returns {page, said}, where said collects the errors of the page's console and scripts.
//   context  Playwright's options for a browser context
//   before   a function that is evaluated in the page before any of the page's scripts
export async function blankPage(browser, {context = {}, before = () => {}} = {}) {
    const page = await browser.newPage({viewport: {width: 640, height: 500}, ...context});
    page.setDefaultTimeout(PATIENCE);
    const said = [];
    page.on('console', (message) => { if (message.type() === 'error') said.push(message.text()); });
    page.on('pageerror', (error) => said.push(error.message));
    await page.addInitScript(before);
    return {page, said};
}

// Open a page with one program, window.program, which has not started a chapter yet. The lines that the program prints
// are in window.lines, its pictures in window.pictures, and the counts of WebGL calls in window.calls.
export async function openPage(browser, at, options = {}) {
    const opened = await blankPage(browser, options);
    await opened.page.goto(`${at}/test.html`);
    await opened.page.evaluate(loadProgram);
    return opened;
}

// Draw a picture with the options of a line of tests/pictures/images.txt. Returns {status, picture, lines}; picture is
// undefined if none was drawn.
export const draw = (page, stem, line) => page.evaluate(async ([stem, line]) => {
    window.lines.length = window.pictures.length = 0;
    const status = await window.program.start(stem, `${line} --output picture.png`);
    return {status, picture: window.pictures[0], lines: window.lines};
}, [stem, line]);

// ---- Waits ----

export const state = (page) => page.evaluate(() => window.program.state());

// Start a chapter and wait until it has drawn a frame. Returns the exit status of the start.
export async function start(page, stem, line = '') {
    const status = await page.evaluate(([stem, line]) => window.program.start(stem, line), [stem, line]);
    if (status === 0) await until(page, (now) => now.rate > 0 || !now.runs);
    return status;
}

// Wait until the program's state satisfies a condition, or until time runs out. Returns the last state, which the
// caller must check.
export async function until(page, right) {
    const begun = Date.now();
    for (;;) {
        const now = await state(page);
        if (right(now) || Date.now() - begun > PATIENCE) return now;
        await frames(page, 2);
    }
}

// Wait until a condition, which may query the page, is true. Returns false if time runs out.
export async function holds(page, condition) {
    const begun = Date.now();
    while (!await condition()) {
        if (Date.now() - begun > PATIENCE) return false;
        await frames(page, 2);
    }
    return true;
}

// Wait until a page of the site is laid out completely, including the part below the first screen.
export const whole = (page) => page.waitForFunction(() => !document.querySelector('.quick, .later'));

// Let a number of frames of the page pass.
export const frames = (page, count) => page.evaluate((count) => new Promise((done) => {
    const turn = () => count-- > 0 ? requestAnimationFrame(turn) : done();
    turn();
}), count);

// Wait until a paused program has drawn everything, or until time runs out. The program has drawn everything when
// nothing is drawn for 45 frames, which is longer than the pause before a picture is sharpened.
export const rest = (page) => page.evaluate((patience) => new Promise((done) => {
    const begun = performance.now();
    let still = 0, before = -1;
    const turn = () => {
        const now = window.calls.drawArrays + window.calls.blitFramebuffer;
        still = now === before ? still + 1 : 0;
        before = now;
        if (still < 45 && performance.now() - begun < patience) requestAnimationFrame(turn);
        else done();
    };
    turn();
}), PATIENCE);

// ---- Files and processes ----

// The processor time of all running processes that descend from this one, in seconds.
export function processors() {
    const all = fs.readdirSync('/proc').filter((name) => /^\d+$/.test(name)).flatMap((name) => {
        try {
            const text = fs.readFileSync(`/proc/${name}/stat`, 'utf8');
            const field = text.slice(text.lastIndexOf(')') + 2).split(' ');
            return [{process: Number(name), parent: Number(field[1]), seconds: (Number(field[11]) + Number(field[12])) / 100}];
        } catch {
            return []; // the process has just ended
        }
    });
    const ours = new Set([process.pid]);
    for (let size = 0; size !== ours.size;) {
        size = ours.size;
        for (const one of all) if (ours.has(one.parent)) ours.add(one.process);
    }
    ours.delete(process.pid);
    return all.reduce((sum, one) => sum + (ours.has(one.process) ? one.seconds : 0), 0);
}

// Write a picture that a page has drawn to a file.
export function keep(picture, file) {
    fs.writeFileSync(file, Buffer.from(picture.url.split(',')[1], 'base64'));
}

// Compare a picture with its reference, using build/tests/compare in a separate process, so that other pictures can be
// drawn in the meantime. Returns a promise of {same, says}.
export function compare(name, file) {
    return new Promise((done) => execFile('build/tests/compare', [`tests/references/${name}.png`, file],
        (error, output, errors) => done({same: !error, says: (output + errors).trim()})));
}

// The pictures of tests/pictures/images.txt, as {stem, name, line}; line contains the options.
export function pictures() {
    return fs.readFileSync('tests/pictures/images.txt', 'utf8').split('\n').filter((line) => /^[0-9]/.test(line)).map((line) => {
        const [stem, variant, ...options] = line.trim().split(/\s+/);
        return {stem, name: variant === '-' ? stem : `${stem}-${variant}`, line: options.join(' ')};
    });
}
