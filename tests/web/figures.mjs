// figures.mjs [PATTERN] - tests the interactive figures of the chapters' pages: each starts in place, and its first
// point can be dragged. Every other figure is dragged with the mouse in a page 1440 pixels wide, the rest with a finger
// in a page 390 pixels wide. The time until a point responds is printed but not judged. Two figures of every third
// chapter are tested; with PATTERN, two of each chapter that matches; with ALL=1, all figures of all chapters.
import fs from 'node:fs';
import {blankPage, check, finish, launch, PATIENCE, serve, SITE, whole} from './browser.mjs';

const pattern = new RegExp(process.argv[2] || '');
const MOST = process.env.ALL ? Infinity : 2; // the largest number of figures tested per page
const names = fs.readdirSync(SITE).filter((name) => /^\d\d_\w+\.html$/.test(name) && pattern.test(name)).sort()
    .filter((_, i) => process.argv[2] || process.env.ALL || i % 3 === 0);
const server = await serve(SITE), browser = await launch(), waits = [];

const state = (page) => page.evaluate(() => {
    const at = document.querySelector('.live-drawn'), now = at?.program?.state();
    if (!now?.runs) return null;
    const {left, top, width, height} = at.querySelector('.live-canvas').getBoundingClientRect();
    return {values: JSON.stringify(now.parameters.map(({value}) => value)), middle: [left + width / 2, top + height / 2],
        points: now.handles.map(({x, y}) => [left + x * width, top + y * height])};
});
async function comes(page, right) {
    for (const begun = Date.now(); ;) {
        const now = await state(page);
        if (now && right(now) || Date.now() - begun > PATIENCE) return now;
        await page.evaluate(() => new Promise(requestAnimationFrame));
    }
}

// Run a figure, and drag its first point a little towards the middle of the picture. Returns what is wrong, or '' if
// the point has moved.
async function answers(page, figure, phone) {
    await figure.evaluate((one) => { for (let fold = one; (fold = fold.parentElement.closest('details'));) fold.open = true; one.scrollIntoView({block: 'center', behavior: 'instant'}); });
    await figure.locator('.live-start')[phone ? 'tap' : 'click']();
    let now = await comes(page, ({points}) => points.length > 0);
    if (!now?.points.length) return 'it has no point';
    await page.evaluate(() => document.querySelector('.live-screen:has(.live-canvas)').scrollIntoView({block: 'center', behavior: 'instant'}));
    now = await state(page);
    const [x, y] = now.points[0], to = [x + (now.middle[0] > x ? 24 : -24), y + (now.middle[1] > y ? 16 : -16)];
    const begun = performance.now();
    if (phone) {
        const fingers = await page.context().newCDPSession(page);
        for (const [type, ...at] of [['touchStart', [x, y]], ['touchMove', to], ['touchEnd']]) await fingers.send('Input.dispatchTouchEvent', {type, touchPoints: at.map(([x, y]) => ({x, y}))});
    } else {
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(...to);
        await page.mouse.up();
    }
    const before = now.values;
    now = await comes(page, ({values}) => values !== before);
    waits.push(performance.now() - begun);
    return now.values === before ? 'its first point does not move' : '';
}

for (const name of names) {
    const wrong = [];
    let count = 0;
    for (const phone of [false, true]) {
        const {page, said} = await blankPage(browser, {context: phone ? {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true} : {viewport: {width: 1440, height: 900}}});
        await page.goto(`${server.at}/${name}`);
        await whole(page);
        const figures = page.locator('.hands');
        count = await figures.count();
        for (let i = phone ? 1 : 0; i < Math.min(count, MOST); i += 2) {
            const why = await answers(page, figures.nth(i), phone);
            if (why) wrong.push(`${await figures.nth(i).getAttribute('line')}: ${why}`);
        }
        wrong.push(...said);
        await page.close();
    }
    check(`${name}: at least two figures respond to the pointer`, count >= 2 && wrong.length === 0, count, wrong);
}
waits.sort((a, b) => a - b);
if (waits.length > 0) console.log(`# time from the press to the new value in ${waits.length} drags: median ${waits[waits.length >> 1].toFixed(0)} ms, at most ${waits.at(-1).toFixed(0)} ms; load average ${fs.readFileSync('/proc/loadavg', 'utf8').split(' ')[0]}`);
finish();
await browser.close();
server.close();
