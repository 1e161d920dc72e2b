// buffers.mjs - tests pictures that keep frames in a page: the exports of tests/shaders/buffers/ and other tools' files
// give the bytes of the native program; a mean runs until its last frame, begins again when something changes, and is
// kept in 32 bits, or in 16 on a device that has no more.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {check, finish, frames, holds, launch, openPage, rest, serve, start, state, until, WEB} from './browser.mjs';

const server = await serve(WEB), browser = await launch();
// A picture that takes long is drawn at a lower resolution. So that no busy machine decides what is compared, the clock
// of the page is slow.
const SLOW_CLOCK = 'const own = performance.now.bind(performance); performance.now = () => 0.02 * own();';
const {page, said} = await openPage(browser, server.at, {before: SLOW_CLOCK});
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'buffers-'));
const FLOAT = 0x8814;

// Write a shader for the program in a page and for the native one. Returns its path for both.
const write = async (name, text, of = page) => {
    fs.writeFileSync(path.join(folder, name), text);
    await of.evaluate(([name, text]) => window.program.write(`chapters/${name}`, text), [name, text]);
    return {here: `chapters/${name}`, there: path.join(folder, name)};
};

// The bytes of a picture that the program in a page has written, and of one from the native program.
const bytesOf = (url, of = page) => of.evaluate(async (url) => {
    const picture = await createImageBitmap(await (await fetch(url)).blob());
    const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d', {willReadFrequently: true});
    context.drawImage(picture, 0, 0);
    return [...context.getImageData(0, 0, picture.width, picture.height).data].join();
}, url);
const drawHere = async ({here}, line, of = page) => {
    const drawn = await of.evaluate(async (line) => {
        window.pictures.length = window.lines.length = 0;
        const status = await window.program.start('01_normal_colouring', `${line} --output picture.png`);
        return {status, url: window.pictures[0]?.url, lines: window.lines};
    }, `--shader ${here} ${line}`);
    return drawn.status === 0 ? bytesOf(drawn.url, of) : drawn.lines.join('\n');
};
const drawThere = ({there}, line) => {
    const picture = path.join(folder, 'picture.png'), {DISPLAY, WAYLAND_DISPLAY, ...env} = process.env;
    execFileSync('build/01_normal_colouring', ['--shader', there, ...line.split(' '), '--output', picture], {env: {...env, LIBGL_ALWAYS_SOFTWARE: '1', GALLIUM_DRIVER: 'llvmpipe'}});
    return bytesOf(`data:image/png;base64,${fs.readFileSync(picture).toString('base64')}`);
};

// ---- The same bytes as natively ----

for (const name of fs.readdirSync('tests/shaders/buffers')) {
    const shader = await write(name, fs.readFileSync(`tests/shaders/buffers/${name}`, 'utf8')), line = '--size 64x32 --frame 60';
    check(`frame 60 of ${name} is that of the native program`, await drawHere(shader, line) === await drawThere(shader, line));
}

const SANDBOX = 'precision highp float;\nuniform sampler2D backbuffer;\nuniform vec2 resolution;\nvoid main() { gl_FragColor = texture2D(backbuffer, gl_FragCoord.yx / resolution) * 0.75 + vec4(gl_FragCoord.xy / resolution, 1.0, 1.0) * 0.3; }\n';
const VIEWER = 'uniform sampler2D u_buffer0, u_doubleBuffer0;\nuniform vec2 u_resolution;\nvoid main() { vec2 st = gl_FragCoord.xy / u_resolution;\n#ifdef BUFFER_0\ngl_FragColor = vec4(st, floor(gl_FragCoord.x), 1.0);\n#elif defined(DOUBLE_BUFFER_0)\ngl_FragColor = 0.5 * texture2D(u_doubleBuffer0, st) + texture2D(u_buffer0, st);\n#else\ngl_FragColor = texture2D(u_doubleBuffer0, st) / vec4(2.0, 2.0, 64.0, 1.0);\n#endif\n}\n';
for (const [name, text] of [['sandbox.frag', SANDBOX], ['viewer.frag', VIEWER]]) {
    const shader = await write(name, text), line = '--size 64x32 --frame 9';
    check(`frame 9 of ${name} is that of the native program`, await drawHere(shader, line) === await drawThere(shader, line));
}

// ---- 32 bits ----

const COURSE = '#include "main.glsl"\n#include "march.glsl"\n#include "random.glsl"\nuniform sampler2D history; // the last frame\nRay pixelRay(vec2 screen) { return Ray(vec3(screen, 4.0), vec3(0.0, 0.0, -1.0)); }\nfloat sceneDistance(vec3 p) { return p.z; }\n';
// A constant would have the sampler's precision; iFrame, which is 1, has the highest.
const GREEN = 'vec3 rayColour(Ray ray) { return texelFetch(history, iPixel, 0).r == float(8190 + iFrame) ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0); }\n';
const NUMBER = `${COURSE}vec4 frameKept(vec2 pixel) { return iFrame == 0 ? vec4(8191.0) : textureLod(history, pixel / iResolution.xy, 0.0); }\n${GREEN}`;
const PATTERN = `${COURSE}vec4 frameKept(vec2 pixel) {\n    uint own = 0x7fc00000u + uint(iPixel.x);\n    uvec4 last = floatBitsToUint(texelFetch(history, iPixel, 0));\n    return uintBitsToFloat(iFrame == 0 ? uvec4(own) : last + 1u);\n}\nvec3 rayColour(Ray ray) { return floatBitsToUint(texelFetch(history, iPixel, 0).r) == 0x7fc00003u + uint(iPixel.x) ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0); }\n`;
const allGreen = (bytes) => bytes.split(',').every((byte, i) => byte === (i % 4 % 2 === 1 ? '255' : '0'));
check('the number 8191 survives a frame', allGreen(await drawHere(await write('number.frag', NUMBER), '--size 32x18 --frame 1')));
check('patterns of bits that are stored as floats survive three frames', allGreen(await drawHere(await write('pattern.frag', PATTERN), '--size 32x18 --frame 3')));

// ---- A mean that runs live ----

const MEAN = `${COURSE}uniform float gain; // 1 in [0, 4]: brightness\nuniform float seed; // 3 in [0, 100]: other numbers\nvec4 frameKept(vec2 pixel) { return mix(texelFetch(history, iPixel, 0), vec4(pixelRandom(int(seed)), iCameraPosition), 1.0 / float(iFrame + 1)); }\nvec3 rayColour(Ray ray) {\n    march(ray, 0.0, 9.0, 0.001, 64);\n    return gain * texelFetch(history, iPixel, 0).rgb;\n}\n`;
const mean = await write('mean.frag', MEAN), RUN = `--shader ${mean.here} --frame 30`;
const reaches = (frame, of = page) => until(of, (now) => now.kept?.frame === frame);
const call = (...values) => page.evaluate((values) => window.program.call(...values), values);
const drawn = () => page.evaluate(() => window.calls.drawArrays);

check('a mean starts', await start(page, '01_normal_colouring', RUN) === 0);
let now = await reaches(30);
check('it stops at the frame of its command line', now.kept?.frame === 30 && now.kept.last === 30, now.kept);
await rest(page);
const before = await drawn();
await frames(page, 30);
check('then nothing is drawn any more', await drawn() === before && (await state(page)).kept.frame === 30, before, await drawn());
check('it is kept in 32 bits', !now.kept.halves && !now.halves, now);
check('it is not at a lower resolution', now.divisor === 1, now.divisor);

// What a screenshot of the stopped picture contains.
const shot = async () => {
    await page.evaluate(() => { window.pictures.length = 0; });
    await call('live_key', 80, 1, 0);
    await page.waitForFunction(() => window.pictures.length > 0);
    return bytesOf(await page.evaluate(() => window.pictures[0].url));
};
const still = await shot();
check('a screenshot is frame 30 of the native program', still === await drawThere(mean, '--size 320x180 --frame 30'));
await call('live_pixel', 100, 90);
now = await until(page, (s) => s.probe !== undefined);
check('a ray of the stopped picture has a march', now.probe?.steps > 0 && now.kept.frame === 30, now.kept, now.probe);
await call('live_pixel', -1, -1);

// Each change makes the frames begin again, and the mean arrive at its last frame once more.
let least = 0;
const begins = async (what, change) => {
    await page.evaluate(() => {
        window.least = 1e9;
        const look = () => {
            const {kept, runs} = window.program.state();
            if (runs && kept) window.least = Math.min(window.least, kept.frame);
            window.looking = requestAnimationFrame(look);
        };
        look();
    });
    await change();
    await holds(page, () => page.evaluate(() => window.least < 25));
    await reaches(30);
    least = await page.evaluate(() => { cancelAnimationFrame(window.looking); return window.least; });
    check(`${what} lets the frames begin again`, least < 25, least, (await state(page)).kept);
};
await begins('a parameter that frameKept reads', () => call('live_set', 'seed', 0, 4));
check('then the picture is another one', await shot() === await drawThere(mean, '--size 320x180 --frame 30 --set seed=4'));
await begins('the key R', () => call('live_key', 82, 1, 0));
await begins('the camera', async () => { await call('live_key', 87, 1, 0); await until(page, (s) => s.kept.frame < 25); await call('live_key', 87, 0, 0); });
await begins('another size', () => page.evaluate(() => { document.getElementById('canvas').style.width = '300px'; }));
now = await state(page);
check('the size is the canvas\'s', now.size.join() === '300,180', now.size);
await begins('a saved shader', () => write('mean.frag', `${MEAN}\n`));
await begins('another time', () => call('live_time', 2));
await begins('a lost context', async () => {
    await page.evaluate(() => { window.taken = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context'); window.taken.loseContext(); });
    await page.waitForFunction(() => window.events.includes('lost'));
    await page.evaluate(() => window.taken.restoreContext());
    await page.waitForFunction(() => window.events.includes('found'));
});
now = await state(page);
check('after a lost context, the values are the same', now.parameters.find(({name}) => name === 'seed').value[0] === 4 && now.error === '', now.parameters, now.error);
await call('live_set', 'gain', 0, 2);
await frames(page, 20);
check('a parameter that only the picture reads leaves the frames', (await state(page)).kept.frame === 30);

// ---- When it stops ----

const kept = async (line, stillAsked = false, of = page) => {
    await of.evaluate(([line, stillAsked]) => window.program.start('01_normal_colouring', line, stillAsked), [line, stillAsked]);
    return until(of, (s) => s.kept === undefined || s.kept.frame > 3 || s.paused);
};
now = await kept(`--shader ${mean.here}`);
check('without --frame, a mean stops after 1024 frames', now.kept.last === 1023, now.kept);
now = await kept(`--shader ${(await write('waves.frag', MEAN.replace('pixelRandom(int(seed))', 'sin(iTime)'))).here}`);
check('what changes with time does not stop', now.kept.last === -1, now.kept);
now = await kept('--shader chapters/AB.json');
check('an export does not stop', now.kept.last === -1, now.kept);
check('a picture without kept frames says nothing of them', (await kept('')).kept === undefined);
now = await kept(RUN, true);
check('a picture of a later frame is not paused in a page that shows it', !now.paused && (await reaches(30)).kept.frame === 30, now.kept);
now = await kept(`--shader ${mean.here}`, true);
check('a picture of frame 0 is', now.paused && now.kept.frame === 0, now.kept);
await kept('--shader chapters/AB.json --frame 12');
check('an export stops at the frame of its command line', (await reaches(12)).kept.frame === 12);
check('the screenshot of an export is that frame', await shot() === await drawThere({there: path.join(folder, 'AB.json')}, '--size 300x180 --frame 12'));
check('the console reports no error', said.length === 0, said);

// ---- Devices without some extensions ----

// A page on a device that lacks extensions.
const without = (...names) => openPage(browser, server.at, {before: `${SLOW_CLOCK}
    const lacks = ${JSON.stringify(names)};
    const {getExtension, getSupportedExtensions, texImage2D} = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getExtension = function (name) { return lacks.includes(name) ? null : getExtension.call(this, name); };
    WebGL2RenderingContext.prototype.getSupportedExtensions = function () { return getSupportedExtensions.call(this).filter((name) => !lacks.includes(name)); };
    window.forms = [];
    WebGL2RenderingContext.prototype.texImage2D = function (...values) { window.forms.push(values[2]); return texImage2D.apply(this, values); };`});

const unblended = await without('EXT_float_blend');
const own = await write('mean.frag', MEAN, unblended.page), number = await write('number.frag', NUMBER, unblended.page);
now = await kept(`--shader ${own.here} --frame 200`, false, unblended.page);
check('a device that cannot blend floats still keeps 32 bits', now.halves && !now.kept.halves && now.kept.last === 200 && (await unblended.page.evaluate(() => window.forms)).includes(FLOAT), now.halves, now.kept);
check('there, too, the number 8191 survives a frame', allGreen(await drawHere(number, '--size 32x18 --frame 1', unblended.page)));
await unblended.page.close();

const poor = await without('EXT_float_blend', 'EXT_color_buffer_float');
await write('mean.frag', MEAN, poor.page);
await write('number.frag', NUMBER, poor.page);
now = await kept(`--shader ${own.here} --frame 200`, false, poor.page);
check('a device without 32-bit targets keeps half floats, and the state says so', now.kept.halves && now.error === '', now.kept, now.error);
now = await reaches(63, poor.page);
await frames(poor.page, 20);
now = await state(poor.page);
check('there, a mean stops after 64 frames', now.kept.frame === 63 && now.kept.last === 63, now.kept);
// Such a device cannot blit its pictures to the canvas, but the canvas shows them.
const canvasOf = async (of) => {
    await start(of, '03_shadows', '--size 320x180');
    await of.evaluate(() => { document.getElementById('canvas').style.width = '320px'; window.program.call('live_pause', 1); window.program.call('live_time', 1); });
    await until(of, (s) => s.size[0] === 320);
    await rest(of);
    return (await bytesOf(`data:image/png;base64,${(await of.locator('#canvas').screenshot()).toString('base64')}`, of)).split(',').map(Number);
};
const [right, got] = [await canvasOf(page), await canvasOf(poor.page)];
const far = right.reduce((most, byte, i) => Math.max(most, Math.abs(byte - got[i])), 0);
check('there, the canvas shows the same picture', right.length === 4 * 320 * 180 && got.length === right.length && far <= 2 && new Set(right).size > 100, right.length, got.length, far);
check('there, the number 8191 does not survive', !allGreen(await drawHere(number, '--size 32x18 --frame 1', poor.page)));
// ---- What a page says ----

// Run a mean in a chapter of a page, until its status contains some words. Returns {status, notice}.
const tells = async (of, words) => {
    await of.route('**/live.html', (route) => route.fulfill({contentType: 'text/html', body: '<!doctype html><html lang="en"><meta charset="utf-8"><title>test</title><link rel="icon" href="data:,"><link rel="stylesheet" href="live.css"><script type="module" src="live.js"></script><main><live-chapter stem="01_normal_colouring"></live-chapter></main></html>'}));
    await of.goto(`${server.at}/live.html`);
    await of.evaluate(async (text) => {
        await customElements.whenDefined('live-chapter');
        const chapter = document.querySelector('live-chapter');
        await chapter.run('--size 64x36');
        chapter.program.write('chapters/mean.frag', text);
        await chapter.run('--shader chapters/mean.frag --frame 90 --size 64x36', {still: true});
    }, MEAN);
    const look = () => of.evaluate(() => ({status: document.querySelector('.live-status').textContent, notice: document.querySelector('.live-notice').textContent}));
    await holds(of, async () => (await look()).status.includes(words));
    return look();
};
let told = await tells(page, 'frame 90 of 90');
check('a page says which frame is shown, and runs to the last one', told.status.includes('frame 90 of 90') && told.notice === '', told);
told = await tells(poor.page, 'frame 63 of 63');
check('on a device with half floats, it says so', told.status.includes('frame 63 of 63') && told.notice.includes('16 bits'), told);
check('the console of that device reports no error', poor.said.length === 0, poor.said);

fs.rmSync(folder, {recursive: true});
finish();
await browser.close();
server.close();
