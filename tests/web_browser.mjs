// web_browser.mjs - what the tests of the browser share: a server of build/web/, Chromium on Mesa's software
// renderer, a page with one program, and TAP.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import {chromium} from '../build/node/node_modules/playwright-core/index.mjs';

const TYPES = {
    '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm',
    '.json': 'application/json', '.png': 'image/png',
};
const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><title>test</title><link rel="icon" href="data:,">
<style>body { margin: 0 } canvas { display: block; width: 320px; height: 180px }</style>
<canvas id="canvas" tabindex="0" aria-label="picture"></canvas><div id="below" style="height: 3000px"></div>`;

// ---- TAP ----

let count = 0, failed = 0;

export function check(name, right, ...more) {
    count++;
    if (!right) failed++;
    console.log(`${right ? 'ok' : 'not ok'} ${count} - ${name}`);
    if (!right && more.length > 0) console.log(`# ${more.map((x) => typeof x === 'string' ? x : JSON.stringify(x)).join(' ')}`);
    return right;
}

export function finish() {
    console.log(`1..${count}`);
    process.exitCode = failed > 0 ? 1 : 0;
}

// ---- The server ----

// Serve a folder on this machine alone; /test.html is a page with a canvas. Returns its address and what ends it.
export async function serve(folder) {
    const server = http.createServer((request, answer) => {
        const name = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
        const file = path.join(folder, path.normalize(name));
        if (name === '/test.html') {
            answer.writeHead(200, {'content-type': TYPES['.html']});
            answer.end(PAGE);
        } else if (fs.existsSync(file) && fs.statSync(file).isFile()) {
            answer.writeHead(200, {'content-type': TYPES[path.extname(file)] || 'application/octet-stream'});
            fs.createReadStream(file).pipe(answer);
        } else {
            answer.writeHead(404);
            answer.end();
        }
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    return {at: `http://127.0.0.1:${server.address().port}`, close: () => server.close()};
}

// ---- The browser ----

export function launch() {
    return chromium.launch({
        executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
        headless: true,
        env: {...process.env, LIBGL_ALWAYS_SOFTWARE: '1', GALLIUM_DRIVER: 'llvmpipe'},
        args: ['--no-sandbox', '--ignore-gpu-blocklist', '--use-gl=angle', '--use-angle=gl-egl', '--force-color-profile=srgb'],
    });
}

// A page with one program, window.program, that has started nothing. What it says is gathered in said: errors of the
// console and of the page; the program's own lines are in window.lines, its pictures in window.pictures.
//   before  is evaluated in the page before any script of it
export async function openPage(browser, at, before = () => {}) {
    const page = await browser.newPage({viewport: {width: 640, height: 500}});
    const said = [];
    page.on('console', (message) => { if (message.type() === 'error') said.push(message.text()); });
    page.on('pageerror', (error) => said.push(error.message));
    await page.addInitScript(before);
    await page.goto(`${at}/test.html`);
    await page.evaluate(async () => {
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
    });
    return {page, said};
}

// Start a chapter and wait until it has drawn. Returns its exit status.
export async function start(page, stem, line = '') {
    const status = await page.evaluate(([stem, line]) => window.program.start(stem, line), [stem, line]);
    if (status === 0) await page.waitForFunction(() => window.program.state().rate > 0 || !window.program.state().runs);
    return status;
}

export const state = (page) => page.evaluate(() => window.program.state());

// Wait until the program's state is what is asked of it. Returns the last state: the caller judges it.
export async function until(page, right) {
    for (let i = 0; i < 100; i++) {
        const now = await state(page);
        if (right(now)) return now;
        await page.waitForTimeout(50);
    }
    return state(page);
}

// ---- Processes ----

// Write a picture that a page has drawn.
export function keep(picture, file) {
    fs.writeFileSync(file, Buffer.from(picture.url.split(',')[1], 'base64'));
}
