// figures.mjs [PATTERN] - tests every interactive figure in Chromium, in pages 1440 pixels wide with the mouse and 390
// pixels wide with a finger (each_figure.mjs), and as a single file. In continuous integration (CI without ALL), every
// second page is wide, and the others are narrow.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import {pathToFileURL} from 'node:url';
import zlib from 'node:zlib';
import {blankPage, check, finish, frames, launch, PATIENCE, serve, SITE, whole} from './browser.mjs';
import {pagesWith, record, testFigures} from './each_figure.mjs';

const server = await serve(SITE), browser = await launch();

async function driverOf(page, phone) {
    const fingers = phone && await page.context().newCDPSession(page), touch = (type, ...at) => fingers.send('Input.dispatchTouchEvent', {type, touchPoints: at.map(([x, y]) => ({x, y}))});
    const slide = async ([x, y], [toX, toY], steps) => {
        await touch('touchStart', [x, y]);
        for (let i = 1; i <= steps; i++) await touch('touchMove', [x + (toX - x) * i / steps, y + (toY - y) * i / steps]);
        await frames(page, 12); // a finger that rests before it is lifted does not throw the page
        await touch('touchMove', [toX, toY]);
        await touch('touchEnd');
    };
    return {
        evaluate: (...all) => page.evaluate(...all),
        drag: async (from, to) => {
            if (phone) return slide(from, to, 6);
            await page.mouse.move(...from);
            await page.mouse.down();
            await page.mouse.move(...to, {steps: 4});
            await page.mouse.up();
        },
        scrolls: true,
        key: (name) => page.keyboard.press(name),
    };
}

// Most of a page's time is spent waiting for frames, so several pages are tested side by side.
const LANES = 4;
// The dense screen of a telephone, on which each figure has four times as many pixels, is that of hands.mjs.
const screens = [[1440, {viewport: {width: 1440, height: 900}}], [390, {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true}]];
const all = {count: 0, points: 0, turns: 0}, inBoth = process.env.ALL || !process.env.CI;
const tasks = screens.flatMap(([width, context], s) => pagesWith(process.argv[2]).map((name) => ({width, context, name})).filter((_, k) => inBoth || k % 2 === s));
async function work() {
    for (let task; (task = tasks.shift()) !== undefined;) {
        const {width, context, name} = task, {page, said} = await blankPage(browser, {context, before: record});
        await page.goto(`${server.at}/${name}`);
        await whole(page);
        const found = await testFigures(await driverOf(page, width === 390), name, `${width} pixels`, width === 390);
        check(`${width} pixels: ${name}: the console reports no error`, said.length === 0, said);
        for (const key of Object.keys(all)) all[key] += found[key];
        await page.close();
    }
}
await Promise.all(Array.from({length: LANES}, work));

// ---- Figures as single files ----

if (!process.argv[2]) {
    const folder = 'build/web-test/figures', {page, said} = await blankPage(browser), asked = [], wrong = [], unnamed = [], sizes = [];
    fs.rmSync(folder, {recursive: true, force: true});
    fs.mkdirSync(folder, {recursive: true});
    execFileSync('node', ['docs/web/figures_html.mjs', folder], {env: {...process.env, ADDRESS: 'https://example.org/course'}});
    page.on('request', (request) => { if (!/^(data|blob):/.test(request.url())) asked.push(request.url()); });
    const files = fs.readdirSync(folder).filter((name) => /^\d/.test(name));
    for (const name of files) {
        const text = fs.readFileSync(`${folder}/${name}`);
        const [, chapter] = /<a href="https:\/\/example\.org\/course\/(\w+\.html)" target="_top">/.exec(text) ?? [];
        if (!chapter?.startsWith(name.slice(0, 2)) || !fs.existsSync(`${SITE}/${chapter}`)) unnamed.push(name);
        if (!text.includes('image/webp')) sizes.push(zlib.gzipSync(text, {level: 9}).length);
        await page.goto(`${pathToFileURL(folder)}/${name}`);
        await page.locator('figure-sheet.drawn').waitFor({timeout: PATIENCE}).catch(() => wrong.push(name));
    }
    check('each figure is also one file, which is drawn without a server and loads nothing', files.length > 80 && wrong.length === 0 && said.length === 0 && asked.length === files.length, files.length, wrong, said, asked.slice(0, 4));
    check('each file of a figure links to its chapter on the course\'s site', unnamed.length === 0, unnamed.slice(0, 4));
    console.log(`# the largest of these files without a texture: ${(Math.max(...sizes) / 1e3).toFixed(1)} KB compressed`);
    check('a file of a figure without textures has at most 12 KB, compressed', Math.max(...sizes) <= 12e3, sizes);
    await page.close();
}

console.log(`# ${all.count} figures, ${all.points} drags`);
if (!process.argv[2]) check('at least ten figures are turned in space', all.turns >= (inBoth ? 20 : 10), all.turns);
finish();
await browser.close();
server.close();
