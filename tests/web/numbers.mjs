// numbers.mjs [PATTERN] - tests the numbers in the sentences of all chapters: each page has at least three; the mouse, a
// finger and the arrow keys change each of them, and the picture that follows is in sight and looks different. A swipe
// that begins on a number scrolls the page. The numbers that change a figure are tried in all pages, those that change a
// program in every third page (with ALL=1 or a PATTERN: in all), 1440 pixels wide only.
import fs from 'node:fs';
import {blankPage, check, finish, frames, holds, launch, serve, SITE, whole} from './browser.mjs';

const server = await serve(SITE), browser = await launch();
const DESK = {viewport: {width: 1440, height: 900}, reducedMotion: 'reduce'}; // so that no picture moves by itself
const PHONE = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true, deviceScaleFactor: 2, reducedMotion: 'reduce'};
const FEW = 3; // the numbers of a chapter, at least
const WAY = 70, MORE = [40, 40, 40]; // the length of a drag in CSS pixels, and those of the next ones while the picture is still the same

const names = fs.readdirSync(SITE).filter((name) => /^\d\d_\w*\.html$/.test(name) && new RegExp(process.argv[2] || '').test(name)).sort();

// The number, in the middle of the screen, with the folds open in which it is.
const find = (i) => {
    const code = document.querySelectorAll('.scrub')[i];
    for (let fold = code; (fold = fold.parentElement.closest('details'));) fold.open = true;
    code.scrollIntoView({block: 'center', behavior: 'instant'});
};
const look = (i) => {
    const code = document.querySelectorAll('.scrub')[i], number = code.querySelector('data'), {left, top, width, height} = number.getClientRects()[0], {at, name, value} = code.scrub;
    const parameter = at && code.scrub.parameter(at), box = at?.screen.getBoundingClientRect();
    const seen = box && Math.max(0, Math.min(box.right, innerWidth) - Math.max(box.left, 0)) * Math.max(0, Math.min(box.bottom, innerHeight) - Math.max(box.top, 0)) / (box.width * box.height);
    const over = box && box.left < left + width && left < box.right && box.top < top + height && top < box.bottom;
    return {name, value, text: number.textContent, says: code.getAttribute('aria-valuetext'), x: left + width / 2, y: top + height / 2, scroll: scrollY, seen, over,
        minimum: Number(code.getAttribute('aria-valuemin') ?? NaN), maximum: Number(code.getAttribute('aria-valuemax')), shown: parameter && [parameter.value].flat()[0]};
};
const isFigure = (i) => document.querySelectorAll('.scrub')[i].scrub.picture().matches('figure-sheet');

// A picture of the picture that follows a number, once it no longer changes.
async function shot(page, i) {
    const once = async () => {
        const box = await page.evaluate((i) => {
            const {left, top, right, bottom} = document.querySelectorAll('.scrub')[i].scrub.at.screen.getBoundingClientRect(), [x, y] = [Math.max(left, 0), Math.max(top, 0)];
            return {x, y, width: Math.min(right, innerWidth) - x, height: Math.min(bottom, innerHeight) - y};
        }, i);
        return (await page.screenshot({clip: box})).toString('base64');
    };
    let before = '', now = await once();
    await holds(page, async () => {
        before = now;
        await frames(page, 20);
        now = await once();
        return now === before;
    });
    return now;
}

async function tryNumber(page, i, finger, blame) {
    await page.evaluate(find, i);
    await frames(page, 3);
    const touch = (type, ...points) => finger.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y]) => ({x, y}))});
    let now = await page.evaluate(look, i);
    const {name, text, x, y, value: first} = now, until = (right) => holds(page, async () => right(now = await page.evaluate(look, i)));
    const says = (what) => blame(`${name}=${text}: ${what}`);
    if (finger) {
        await touch('touchStart', [x, y]);
        for (let up = 20; up <= 100; up += 20) await touch('touchMove', [x, y - up]);
        await frames(page, 12);
        await touch('touchMove', [x, y - 100]);
        await touch('touchEnd');
        await frames(page, 3);
        const after = await page.evaluate(look, i);
        if (after.scroll <= now.scroll || after.text !== text) says(`a swipe does not scroll the page, or changes the number: ${after.scroll - now.scroll}, ${after.text}`);
        await page.evaluate(find, i);
        await frames(page, 3);
        now = await page.evaluate(look, i);
        await touch('touchStart', [now.x, now.y]);
        await touch('touchEnd');
    } else {
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.up();
    }
    if (!await until(({shown, minimum}) => shown === first && !Number.isNaN(minimum))) return says(`a press sets ${now.shown}`);
    const still = now.y, before = await shot(page, i), way = now.value > (now.minimum + now.maximum) / 2 ? -1 : 1;
    async function drag(length) {
        const to = finger ? Math.min(Math.max(now.x + way * length, 4), 386) : now.x + way * length;
        if (finger) {
            await touch('touchStart', [now.x, now.y]);
            for (let step = 1; step <= 4; step++) await touch('touchMove', [now.x + (to - now.x) * step / 5, now.y]);
            await frames(page, 3);
            const {value, minimum, maximum} = await page.evaluate(look, i);
            await touch('touchMove', [to, now.y]);
            await frames(page, 3);
            const last = (await page.evaluate(look, i)).value; // a number that counts may need more
            if (last === value && !Number.isInteger(value) && value > minimum && value < maximum) says(`the finger loses the number at ${value}`);
            await touch('touchEnd');
        } else {
            await page.mouse.move(now.x, now.y);
            await page.mouse.down();
            await page.mouse.move(to, now.y, {steps: 4});
            await page.mouse.up();
        }
        return until((one) => one.text !== text && Math.abs(one.shown - one.value) < 1e-5 * Math.abs(one.value) + 1e-9);
    }
    if (!await drag(WAY)) return says(`a drag shows ${now.text}, and sets ${now.shown}`);
    let same = await shot(page, i) === before;
    for (const length of MORE) if (same && await drag(length)) same = await shot(page, i) === before;
    if (same) says('the picture stays the same');
    now = await page.evaluate(look, i);
    if (Math.abs(now.y - still) > 2) says(`the text moves by ${now.y - still} pixels`);
    if (now.seen < 0.6 || now.over) says(`${Math.round(100 * now.seen)} % of the picture is in sight${now.over ? ', over the number' : ''}`);
    const dragged = now.text;
    await page.keyboard.press(way > 0 ? 'ArrowRight' : 'ArrowLeft');
    if (!await until((one) => one.text !== dragged || one.value === one.minimum || one.value === one.maximum)) says('an arrow key does not change it');
    await page.keyboard.press('Escape');
    if (!await until((one) => one.text === text && one.says === text)) says(`Escape gives ${now.text}`);
    await page.evaluate(() => document.activeElement.blur());
}

let tried = 0;
for (const [width, context] of [[1440, DESK], [390, PHONE]]) {
    for (const [k, name] of names.entries()) {
        const {page, said} = await blankPage(browser, {context}), finger = context === PHONE && await page.context().newCDPSession(page), wrong = [];
        await page.goto(`${server.at}/${name}`);
        await whole(page);
        await page.waitForFunction(() => [...document.querySelectorAll('.scrub')].every((one) => one.scrub));
        const count = await page.locator('.scrub').count(), programs = !finger && (process.argv[2] || process.env.ALL || k % 3 === 0);
        let here = 0;
        if (!finger && !/-proofs/.test(name)) check(`${name}: at least three numbers in its sentences can be dragged`, count >= FEW, count);
        for (let i = 0; i < count; i++) {
            await page.evaluate(find, i);
            if (!programs && !await page.evaluate(isFigure, i)) continue;
            await tryNumber(page, i, finger, (why) => wrong.push(why));
            here++;
        }
        tried += here;
        check(`${width} pixels: ${name}: ${here} numbers change their pictures`, wrong.length === 0, wrong);
        check(`${width} pixels: ${name}: the console reports no error`, said.length === 0, said);
        await page.close();
    }
}
console.log(`# ${tried} numbers were tried`);
finish();
await browser.close();
server.close();
