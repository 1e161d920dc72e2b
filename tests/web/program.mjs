// program.mjs - tests the program in a page: the command line, keys, mouse and fingers, a captured mouse, a hidden page,
// a lost context, and the peculiarities of WebGL.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish, frames, launch, openPage, rest, serve, start, state, threads, until, WEB} from './browser.mjs';

const server = await serve(WEB), browser = await launch();
const {page, said} = await openPage(browser, server.at);
const canvas = page.locator('#canvas');
const parameter = (now, name) => now.parameters.find((p) => p.name === name).value;

// The mean of the colour bytes in a screenshot of the canvas, and the width and height of the screenshot.
async function shown(of = page) {
    const png = await of.locator('#canvas').screenshot();
    return of.evaluate(async (data) => {
        const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
        const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
        context.drawImage(picture, 0, 0);
        const bytes = context.getImageData(0, 0, picture.width, picture.height).data;
        let sum = 0;
        for (let i = 0; i < bytes.length; i += 4) sum += bytes[i] + bytes[i + 1] + bytes[i + 2];
        return {mean: sum / (0.75 * bytes.length), width: picture.width, height: picture.height};
    }, png.toString('base64'));
}

const calls = () => page.evaluate(() => ({...window.calls}));

// ---- Command lines ----

check('a wrong option is refused with status 2', await start(page, '03_shadows', '--nonsense') === 2);
check('the program reports a wrong option in one line', (await page.evaluate(() => window.lines.filter((line) => line.startsWith('! ')))).length === 1);
check('an unknown chapter is refused', await start(page, '77_nothing') === 2);
await page.evaluate(() => { window.lines.length = 0; });
check('--help ends with status 0', await start(page, '03_shadows', '--help') === 0);
check('--help prints the same text as the native program', (await page.evaluate(() => window.lines.join('\n'))).trim() ===
    execFileSync('build/03_shadows', ['--help'], {encoding: 'utf8'}).replaceAll('build/03_shadows', '03_shadows').trim());
check('a word of the command line may be in quotes', await start(page, '03_shadows', `--set "lampHeight=2.5" --size '320x180'`) === 0);
check('a value in the command line sets its parameter', parameter(await state(page), 'lampHeight')[0] === 2.5);

// Compare the output of --probe with that of the native program, number by number.
const probe = (text) => text.trim().split('\n').map((line) => line.split(/[ ,;:]+/));
let worst = 0, compared = 0;
for (const [stem, place] of [['01_normal_colouring', '340,140'], ['03_shadows', '320,180'], ['12_textures', '300,120'], ['16_fewer_steps', '200,150']]) {
    await page.evaluate(() => { window.lines.length = 0; });
    await start(page, stem, `--probe ${place}`);
    const here = probe((await page.evaluate(() => window.lines)).join('\n'));
    const there = probe(execFileSync(`build/${stem}`, ['--probe', place], {encoding: 'utf8', env: {...process.env, LIBGL_ALWAYS_SOFTWARE: '1'}}));
    check(`${stem}: the table of a ray has as many lines and columns as in the native program`, here.length === there.length && here.every((line, i) => line.length === there[i].length), here.at(-1), there.at(-1));
    there.forEach((line, i) => line.forEach((word, k) => {
        const [a, b] = [Number(here[i]?.[k]), Number(word)];
        if (Number.isNaN(b)) return;
        compared++;
        worst = Math.max(worst, Math.abs(a - b) / Math.max(1, Math.abs(b)));
    }));
}
console.log(`# ${compared} numbers of --probe: the largest difference, relative to the number or to 1, whichever is larger, is ${worst.toExponential(1)}`);
check('the numbers of --probe agree with those of the native program', compared > 200 && worst < 5e-6, worst);

// ---- The files of a shader ----

// Every request waits until the test lets all of them go, so a file that is requested later shows a second round trip.
for (const [stem, line] of [['21_a_landscape', ''], ['01_normal_colouring', '--shader chapters/figures/20_light.frag']]) {
    const {page: other} = await openPage(browser, server.at), asked = [], held = [];
    await other.route('**/course/**', (route) => { asked.push(route.request().url().split('/course/')[1]); held.push(route); });
    const status = other.evaluate(([stem, line]) => window.program.start(stem, `${line} --size 32x18 --output picture.png`), [stem, line]);
    for (let before = -1; asked.length !== before;) {
        before = asked.length;
        await frames(other, 10);
    }
    const first = [...asked];
    for (const route of held.splice(0)) await route.continue();
    await other.unroute('**/course/**');
    other.on('request', (request) => asked.push(request.url()));
    check(`${line || stem}: all files of the shader are requested at once`, await status === 0 && first.length > 6 && asked.length === first.length, first, asked.slice(first.length));
    await other.close();
}

// ---- The window ----

check('a chapter starts', await start(page, '03_shadows') === 0);
let now = await state(page);
check('the program draws at the size of the canvas', now.size[0] === 320 && now.size[1] === 180, now.size);
check('the picture is not black', (await shown()).mean > 20, await shown());
const attributes = await page.evaluate(() => document.getElementById('canvas').getContext('webgl2').getContextAttributes());
check('the canvas has no antialiasing, no alpha channel and no depth buffer', !attributes.antialias && !attributes.alpha && !attributes.depth, attributes);

await canvas.focus();
await page.keyboard.press('Escape');
check('Escape pauses the program', (await until(page, (s) => s.paused)).paused);
await page.keyboard.press('Digit4');
check('key 4 shows the steps view', (await until(page, (s) => s.view === 'steps')).view === 'steps');
await page.keyboard.press('Digit1');
check('key 1 shows the picture view', (await until(page, (s) => s.view === 'picture')).view === 'picture');

const eye = (await state(page)).camera;
await page.keyboard.down('KeyW');
await until(page, (s) => Math.abs(s.camera[2] - eye[2]) > 0.05);
await page.keyboard.up('KeyW');
await rest(page);
now = await state(page);
check('key W moves the camera', Math.hypot(...now.camera.slice(0, 3).map((x, i) => x - eye[i])) > 0.05, eye, now.camera);
const moved = now.camera;
await page.evaluate(() => document.activeElement.blur());
await page.keyboard.press('KeyW');
await page.keyboard.press('Digit4');
await frames(page, 20);
now = await state(page);
check('without the focus, the program ignores the keys', now.view === 'picture' && now.camera.every((x, i) => x === moved[i]), now.view, now.camera);

// The program does not intercept the browser's keys.
await canvas.focus();
const taken = await page.evaluate(() => ['KeyW,ctrl', 'KeyR,ctrl', 'Tab', 'F5', 'F11', 'KeyW'].map((word) => {
    const [code, ctrl] = word.split(',');
    const event = new KeyboardEvent('keydown', {code, key: code, ctrlKey: ctrl !== undefined, cancelable: true});
    document.getElementById('canvas').dispatchEvent(event);
    document.getElementById('canvas').dispatchEvent(new KeyboardEvent('keyup', {code, key: code}));
    return event.defaultPrevented;
}));
check('Ctrl+W, Ctrl+R, Tab and the function keys are left to the browser', taken.join() === 'false,false,false,false,false,true', taken);
await page.keyboard.press('Tab');
check('Tab moves the focus away from the canvas', await page.evaluate(() => document.activeElement.id !== 'canvas'));

await canvas.focus();
const before = (await state(page)).camera;
await page.mouse.move(200, 90);
await page.mouse.down();
await page.mouse.move(240, 100, {steps: 5});
await page.mouse.up();
now = await until(page, (s) => s.camera[3] !== before[3]);
check('a drag turns the camera', now.camera[3] !== before[3] && now.camera[4] !== before[4], before, now.camera);
await page.mouse.click(160, 110);
now = await until(page, (s) => s.probe !== undefined);
check('a click selects the ray of the clicked pixel', now.probe?.steps > 0 && now.pixel.join() === '160,69', now.pixel, now.probe?.steps);

// ---- A captured mouse ----

// Key M captures the mouse. The browser releases it when the reader presses Escape, without telling the program.
const locks = (held) => page.waitForFunction((held) => (document.pointerLockElement?.id === 'canvas') === held, held).catch(() => {});
const turns = async (move) => {
    const {camera} = await state(page);
    await move();
    await rest(page);
    return (await state(page)).camera.slice(3).some((angle, i) => Math.abs(angle - camera[3 + i]) > 0.01);
};
await page.keyboard.press('KeyM');
await locks(true);
await page.mouse.move(160, 110);
check('when the mouse is captured, moving it turns the camera', await turns(() => page.mouse.move(200, 110, {steps: 4})));
await page.mouse.click(200, 110);
check('a click of a captured mouse selects no ray, and is no error', (await state(page)).pixel.join() === now.pixel.join() && said.length === 0, said);
await page.evaluate(() => document.exitPointerLock());
await locks(false);
check('when the browser has released the mouse, moving it does not turn the camera', !await turns(() => page.mouse.move(160, 90, {steps: 4})));
check('when the browser has released the mouse, a drag turns the camera', await turns(async () => {
    await page.mouse.down();
    await page.mouse.move(200, 90, {steps: 4});
    await page.mouse.up();
}));
await page.keyboard.press('KeyM');
await locks(true);
await start(page, '03_shadows');
await locks(false);
check('a program that starts has a free mouse', await page.evaluate(() => document.pointerLockElement) === null);
await page.evaluate(() => { HTMLCanvasElement.prototype.requestPointerLock = () => { document.dispatchEvent(new Event('pointerlockerror')); return Promise.reject(new Error('refused')); }; });
await canvas.focus();
await page.keyboard.press('Escape');
await page.mouse.move(200, 110);
await page.keyboard.press('KeyM');
check('if the browser refuses to capture the mouse, moving it does not turn the camera, and the console reports no error', !await turns(() => page.mouse.move(160, 90, {steps: 4})) && said.length === 0, said);

// ---- The wheel ----

await page.evaluate(() => document.activeElement.blur());
await page.mouse.move(160, 90);
await page.mouse.wheel(0, 120);
await page.waitForFunction((before) => window.scrollY > 0 || window.program.state().parameters.find((p) => p.name === 'focalLength').value[0] !== before, parameter(await state(page), 'focalLength')[0]).catch(() => {});
check('the wheel scrolls the page when the canvas does not have the focus', await page.evaluate(() => window.scrollY) > 0);
await page.evaluate(() => window.scrollTo(0, 0));
await canvas.focus();
const length = parameter(await state(page), 'focalLength')[0];
await page.mouse.wheel(0, -300);
now = await until(page, (s) => parameter(s, 'focalLength')[0] > length);
check('when the canvas has the focus, the wheel zooms the picture and does not scroll the page', parameter(now, 'focalLength')[0] > length && await page.evaluate(() => window.scrollY) === 0, length);

// ---- Fingers ----

const phone = await openPage(browser, server.at, {context: {hasTouch: true, isMobile: true, viewport: {width: 390, height: 700}, deviceScaleFactor: 2}});
const fingers = await phone.page.context().newCDPSession(phone.page);
const touch = (type, ...points) => fingers.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
await start(phone.page, '03_shadows');
now = await state(phone.page);
check('a phone\'s canvas has the resolution of its screen', now.size.join() === '640,360', now.size);
await phone.page.evaluate(() => window.program.call('live_pause', 1));
await rest(phone.page);
const turned = (await state(phone.page)).camera;
await touch('touchStart', [100, 90]);
for (let x = 105; x <= 150; x += 5) await touch('touchMove', [x, 90]);
await touch('touchEnd');
now = await until(phone.page, (s) => s.camera[3] !== turned[3]);
check('a finger that is dragged over the picture turns the camera', now.camera[3] !== turned[3] && now.pixel[0] < 0, turned, now.camera, now.pixel);
await rest(phone.page);
const spread = await state(phone.page);
await touch('touchStart', [150, 90], [170, 90]);
for (let x = 0; x <= 60; x += 6) await touch('touchMove', [150 - x, 90], [170 + x, 90]);
now = await until(phone.page, (s) => parameter(s, 'focalLength')[0] !== parameter(spread, 'focalLength')[0]);
check('two fingers that move apart zoom in', parameter(now, 'focalLength')[0] > parameter(spread, 'focalLength')[0]);
for (let x = 60; x >= 0; x -= 6) await touch('touchMove', [150 - x, 90], [170 + x, 90]);
await touch('touchEnd');
await rest(phone.page);
const nearer = parameter(now, 'focalLength')[0];
now = await state(phone.page);
check('two fingers that move together zoom out', parameter(now, 'focalLength')[0] < nearer, nearer, parameter(now, 'focalLength'));
check('two fingers select no ray', now.pixel[0] < 0, now.pixel);
check('two fingers do not move the camera', now.camera.every((x, i) => x === spread.camera[i]), spread.camera, now.camera);
await touch('touchStart', [160, 110]);
await touch('touchEnd');
now = await until(phone.page, (s) => s.probe !== undefined);
check('a tap selects the ray of the tapped pixel', now.probe?.steps > 0 && Math.abs(now.pixel[0] - 320) <= 1 && Math.abs(now.pixel[1] - 139) <= 1, now.pixel);
check('the fingers have neither scrolled nor zoomed the page', await phone.page.evaluate(() => window.scrollY === 0 && visualViewport.scale === 1));
check('the phone\'s console reports no error', phone.said.length === 0, phone.said);
await phone.page.close();

await page.evaluate(() => window.program.call('live_set', 'lampHeight', 0, 1e9));
const lamp = (await state(page)).parameters.find((p) => p.name === 'lampHeight');
check('a value that the page sets is clamped to the range of its parameter', lamp.value[0] === lamp.maximum, lamp.value);

// ---- WebGL's pitfalls ----

// When the overlay of a paused picture is hidden or shown, the program draws only the overlay again, over a copy of the
// stored picture, because the browser has already cleared the canvas.
await page.evaluate(() => window.program.call('live_pause', 1));
await rest(page);
const whole = (await shown()).mean;
await page.evaluate(() => window.program.call('live_key', 72, 1, 0)); // the key H hides the overlay or shows it
await rest(page);
const listed = (await shown()).mean;
await page.evaluate(() => window.program.call('live_key', 72, 1, 0));
await rest(page);
const again = (await shown()).mean;
check('an overlay that is drawn again leaves the picture unchanged', Math.abs(again - whole) < 1 && again > 20 && listed > 0.2 * whole, whole, listed, again);

// The cost of a picture is known only after one of its pixels has been read, because WebGL's finish does not wait. A
// selected ray would read other pixels, so the test deselects it.
await page.evaluate(() => window.program.call('live_pixel', -1, -1));
await rest(page);
const drawnAt = await calls();
await page.evaluate(() => window.program.call('live_pause', 0));
await page.waitForFunction((at) => window.calls.drawArrays > at + 12, drawnAt.drawArrays);
const drawn = await calls();
for (const name in drawn) drawn[name] -= drawnAt[name];
check('the program waits for each picture by reading a pixel', drawn.readPixels >= 0.3 * drawn.drawArrays, drawn);

// ---- A hidden page ----

const hide = (hidden) => page.evaluate((hidden) => {
    Object.defineProperty(document, 'hidden', {value: hidden, configurable: true});
    document.dispatchEvent(new Event('visibilitychange'));
    return window.program.state().time;
}, hidden);
const hiddenTime = await hide(true), drawnThen = await calls();
await frames(page, 45);
check('a hidden page draws nothing', (await calls()).drawArrays === drawnThen.drawArrays, drawnThen, await calls());
check('the clock of a hidden page does not advance', (await state(page)).time === hiddenTime);
// The page seems to have been hidden for a week, far longer than the test may take to see it again.
await page.evaluate(() => {
    const now = performance.now.bind(performance);
    performance.now = () => now() + 6048e5;
});
await hide(false);
now = await until(page, (s) => s.time > hiddenTime);
check('the clock does not make up for the time during which the page was hidden', now.time - hiddenTime < 3600, hiddenTime, now.time);
await page.evaluate(() => window.scrollTo(0, 2000));
await page.waitForFunction(() => !window.program.visible).catch(() => {});
const away = await calls();
await frames(page, 25);
check('a picture that is scrolled out of view is not drawn', (await calls()).drawArrays === away.drawArrays);
await page.evaluate(() => window.scrollTo(0, 0));
await page.waitForFunction(() => window.program.visible);

// ---- A lost context ----

const take = async () => {
    await page.evaluate(() => {
        window.events.length = 0;
        window.taken = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
        window.taken.loseContext();
    });
    await page.waitForFunction(() => window.events.includes('lost'));
};
const giveBack = async () => {
    await page.evaluate(() => window.taken.restoreContext());
    await page.waitForFunction(() => window.events.includes('found'));
    await rest(page);
    return state(page);
};
await page.evaluate(() => {
    window.program.call('live_pause', 1);
    window.program.call('live_set', 'lampHeight', 0, 2);
});
await rest(page);
const kept = await state(page), keptMean = (await shown()).mean;
await take();
check('a lost context is reported', await page.evaluate(() => window.program.lost));
now = await giveBack();
check('after a lost context, the picture has the same values, camera and time', now.runs && parameter(now, 'lampHeight')[0] === 2 && now.time === kept.time && now.camera.every((x, i) => x === kept.camera[i]), now.error);
check('after a lost context, the picture looks the same', Math.abs((await shown()).mean - keptMean) < 1, keptMean, await shown());

// Compare two pictures, with the divider dragged to the left.
await start(page, '00_first_scene', '--time 1 --shader chapters/experiments/00_factor.frag --compare --set factor=1.5');
await page.evaluate(() => {
    window.program.call('live_pause', 1);
    window.program.call('live_set', 'factor (right)', 0, 0.3);
});
await page.mouse.move(160, 60);
await page.mouse.down();
await page.mouse.move(60, 60, {steps: 4});
await page.mouse.up();
await rest(page);
const both = await state(page), bothMean = (await shown()).mean;
await take();
now = await giveBack();
check('after a lost context, both pictures of a comparison have the same values', JSON.stringify(now.parameters) === JSON.stringify(both.parameters) && parameter(now, 'factor (right)')[0] === 0.3, now.parameters, now.error);
check('after a lost context, the divider of a comparison is in the same place', Math.abs((await shown()).mean - bothMean) < 0.1, bothMean, await shown());

// ---- Files from other sources ----

const drawText = (name, shader) => page.evaluate(async ([name, shader]) => {
    window.program.write(name, shader);
    window.pictures.length = window.lines.length = 0;
    const status = await window.program.start('00_first_scene', `--shader '${name}' --output picture.png --size 64x36`);
    return {status, drawn: window.pictures.length, lines: window.lines};
}, [name, shader]);
for (const [name, shader] of Object.entries({
    'a file with medium precision is drawn': '#version 300 es\nprecision mediump float;\nin vec2 FragCoord;\nin float Time;\nuniform float iTime;\nuniform vec3 iResolution;\nout vec4 colour;\nvoid main() { colour = vec4(FragCoord, Time + iTime + iResolution.x, 1.0); }\n',
    'a file for desktop OpenGL is drawn': '#version 330 core\nin vec2 FragCoord;\nout vec4 colour;\nvoid main() { colour = vec4(FragCoord, 0.0, 1.0); }\n',
    'a Shadertoy shader is drawn': 'precision lowp float;\nvoid mainImage(out vec4 c, in vec2 p) { float t; c = vec4(p / iResolution.xy, t, 1.0); }\n',
    'a shader that tests GL_ES is drawn': 'void mainImage(out vec4 c, in vec2 p) {\n#ifdef GL_ES\nc = vec4(0, 1, 0, 1);\n#else\nc = nothing;\n#endif\n}\n',
})) {
    const got = await drawText(`x ${name}.frag`, shader);
    check(name, got.status === 0 && got.drawn === 1, got.lines);
}
const implicit = await drawText('x_implicit.frag', 'void mainImage(out vec4 c, in vec2 p) {\n    int n = 1;\n    float x = n;\n    c = vec4(x);\n}\n');
check('code that GLSL ES refuses is reported with its line number', implicit.status === 1 && /x_implicit\.frag:3/.test(implicit.lines.join('\n')), implicit.lines);
check('the console reports no error', said.length === 0, said);

// ---- A device that cannot blend float targets ----

const poor = await openPage(browser, server.at, {before: () => {
    const own = WebGL2RenderingContext.prototype.getExtension, all = WebGL2RenderingContext.prototype.getSupportedExtensions;
    WebGL2RenderingContext.prototype.getExtension = function (name) { return name === 'EXT_float_blend' ? null : own.call(this, name); };
    WebGL2RenderingContext.prototype.getSupportedExtensions = function () { return all.call(this).filter((name) => name !== 'EXT_float_blend'); };
    const image = WebGL2RenderingContext.prototype.texImage2D;
    window.forms = [];
    WebGL2RenderingContext.prototype.texImage2D = function (...values) { window.forms.push(values[2]); return image.apply(this, values); };
}});
await start(poor.page, '03_shadows');
now = await state(poor.page);
const forms = await poor.page.evaluate(() => window.forms);
check('without EXT_float_blend, render targets use half floats, and the state says so', now.halves && forms.includes(0x881A) && !forms.includes(0x8814), now.halves, forms);
check('without EXT_float_blend, the picture is not black', (await shown(poor.page)).mean > 20);
check('with EXT_float_blend, render targets use floats', !kept.halves);

const none = await openPage(browser, server.at, {before: () => {
    const own = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...values) { return kind === 'webgl2' ? null : own.call(this, kind, ...values); };
}});
check('without WebGL 2, starting a chapter fails with status 3', await start(none.page, '03_shadows') === 3);
check('without WebGL 2, a line says why a chapter does not start', (await none.page.evaluate(() => window.lines.join('\n'))).includes('this browser has no WebGL 2'));

// ---- A driver that compiles on separate threads ----

const apart = await openPage(browser, server.at, {before: threads});
await apart.page.evaluate(() => { window.started = window.program.start('03_shadows'); });
await frames(apart.page, 60);
check('a chapter does not start while the driver is still compiling', !(await state(apart.page)).runs);
await apart.page.evaluate(() => { window.compiled = true; });
check('a chapter starts when the driver has compiled it', await apart.page.evaluate(() => window.started) === 0 && (await until(apart.page, (s) => s.rate > 0)).runs);
const rewrite = (more) => apart.page.evaluate((more) => {
    window.compiled = false;
    window.program.write('chapters/03_shadows.frag', `${window.program.read('chapters/03_shadows.frag')}${more}\n`);
}, more);
await rewrite('//');
await until(apart.page, (s) => s.compiles);
const drawings = await apart.page.evaluate(() => window.calls.drawArrays), at = (await state(apart.page)).time;
now = await until(apart.page, (s) => s.time > at + 0.2);
check('while a change compiles, the old picture keeps running', now.compiles && now.error === '' && await apart.page.evaluate(() => window.calls.drawArrays) > drawings);
await rewrite('wrong');
await frames(apart.page, 60);
check('a second change starts to compile while the first is compiling', (await state(apart.page)).compiles);
await apart.page.evaluate(() => { window.compiled = true; });
now = await until(apart.page, (s) => !s.compiles);
check('if a second change replaces one that is still compiling, the reported errors are those of the second', /03_shadows\.frag:\d+: error/.test(now.error), now.error);
await apart.page.close();

// ---- A slow driver ----

// Each pixel that is drawn appears to take 0.1 ms, so the picture is drawn coarsely and then sharpened row by row, in many
// more frames than the ten that are looked at.
const slow = await openPage(browser, server.at, {before: () => {
    const now = performance.now.bind(performance), {drawArrays} = WebGL2RenderingContext.prototype;
    let more = 0;
    performance.now = () => now() + more;
    WebGL2RenderingContext.prototype.drawArrays = function (...values) {
        const [, , width, height] = this.getParameter(this.SCISSOR_BOX);
        more += this.isEnabled(this.SCISSOR_TEST) ? 0.1 * width * height : 0;
        drawArrays.apply(this, values);
    };
}});
await start(slow.page, '01_normal_colouring');
const rows = await slow.page.evaluate(() => new Promise((done) => {
    const canvas = document.getElementById('canvas'), to = new OffscreenCanvas(320, 180).getContext('2d', {willReadFrequently: true});
    let blits = window.calls.blitFramebuffer, looks = 0, black = 0, frames = 0;
    const turn = () => {
        if (window.calls.blitFramebuffer > blits) { // drawn in this frame, which the browser has not shown yet
            to.drawImage(canvas, 0, 0, 320, 180);
            looks++;
            black += to.getImageData(160, 178, 1, 1).data.slice(0, 3).every((byte) => byte === 0);
        }
        blits = window.calls.blitFramebuffer;
        if (looks < 10 && frames++ < 300) requestAnimationFrame(turn);
        else done({looks, black});
    };
    window.program.call('live_set', 'focalLength', 0, 1.9); // on a busy machine, the first picture may be sharp by now
    requestAnimationFrame(turn);
}));
check('while rows are sharpened, the other rows show the coarse picture', rows.looks === 10 && rows.black === 0 && (await state(slow.page)).divisor > 1, rows);
await slow.page.close();

// ---- Size ----

// The size after gzip, in bytes, of the files that the first picture of any chapter loads, and of the texts of all
// chapters.
const packed = (files) => files.reduce((sum, file) => sum + Number(execFileSync('bash', ['-c', `gzip -9c '${file}' | wc -c`], {encoding: 'utf8'})), 0);
const module = packed(['harness.wasm', 'harness.js', 'program.js', 'course.json'].map((name) => `${WEB}/${name}`));
const chapters = packed(fs.readdirSync(`${WEB}/course/chapters`).filter((name) => /\.(frag|glsl)$/.test(name)).map((name) => `${WEB}/course/chapters/${name}`));
console.log(`# the module takes ${module} bytes compressed, and the texts of all chapters, compressed one by one, ${chapters} more`);
check('the module\'s wasm, scripts and data take at most 260 KB, compressed', module <= 260e3, module);

finish();
await browser.close();
server.close();
