// each_figure.mjs - the tests of every interactive figure, for any browser (figures.mjs, firefox_figures.mjs): without a
// press before, it is drawn when it is seen, equal to its reference picture; the mouse, a finger and the arrow keys move
// each of its points, and a swipe beside its points scrolls the page. A figure in space turns if it is dragged anywhere.
import fs from 'node:fs';
import {check, PATIENCE, SITE} from './browser.mjs';

// The pages with figures whose names match a pattern.
export const pagesWith = (pattern) => fs.readdirSync(`${SITE}/sheets`).filter((name) => name.endsWith('.js')).map((name) => name.replace('.js', '.html')).filter((name) => new RegExp(pattern || '').test(name)).sort();

// Run these in a page before its scripts, and in a page.
export function record() {
    window.shifted = 0;
    if (!PerformanceObserver.supportedEntryTypes.includes('layout-shift')) return;
    window.shifts = new PerformanceObserver((list) => { for (const {value, sources} of list.getEntries()) if (!window.unfolds && sources.some(({node}) => node?.parentElement?.closest('main'))) window.shifted += value; });
    window.shifts.observe({type: 'layout-shift', buffered: true});
}
const find = async (i) => {
    const sheet = document.querySelectorAll('figure-sheet')[i];
    window.unfolds = true; // what a fold moves is no fault
    let opened = false;
    for (let fold = sheet; (fold = fold.parentElement.closest('details'));) {
        opened ||= !fold.open;
        fold.open = true;
    }
    for (let left = opened ? 3 : 0; left > 0; left--) await new Promise(requestAnimationFrame);
    if (opened) window.shifts?.takeRecords();
    window.unfolds = false;
    sheet.scrollIntoView({block: 'center', behavior: 'instant'});
};
const look = (i) => {
    const sheet = document.querySelectorAll('figure-sheet')[i], own = sheet.querySelector('canvas'), {left, top, width, height} = own.getBoundingClientRect();
    const points = [...sheet.querySelectorAll('.sheet-point')].filter((one) => !one.hidden).map((one) => {
        const box = one.getBoundingClientRect();
        return {name: one.dataset.name, x: box.left + box.width / 2, y: box.top + box.height / 2, label: one.getAttribute('aria-label'), value: one.getAttribute('aria-valuetext'), role: one.getAttribute('role')};
    });
    return {name: sheet.getAttribute('name'), drawn: sheet.matches('.drawn'), points, box: [left, top, width, height], picture: sheet.matches('.drawn') ? own.toDataURL() : '', scroll: scrollY, runs: sheet.querySelector('.sheet-play')?.textContent === 'Pause', turned: sheet.matches('.turns') && own.getAttribute('aria-valuetext')};
};
// The share of the pixels that differ from the reference picture, in percent, at the size of that picture.
const differs = async ([i, patience]) => {
    const sheet = document.querySelectorAll('figure-sheet')[i], img = sheet.querySelector('img'), own = sheet.querySelector('canvas'), screen = sheet.querySelector('.sheet-screen');
    const [w, h] = [640, 360], begun = performance.now(), sized = async (right) => {
        while (!right() && performance.now() - begun < patience) await new Promise(requestAnimationFrame);
        await new Promise(requestAnimationFrame); // the observer of the size is called after the frame's callbacks
    };
    sheet.querySelector('.sheet-reset').click();
    sheet.scrollIntoView({block: 'center', behavior: 'instant'});
    img.loading = 'eager';
    await img.decode();
    Object.assign(screen.style, {width: `${w / devicePixelRatio}px`, height: `${h / devicePixelRatio}px`});
    await sized(() => own.width === w && own.height === h);
    const pen = Object.assign(document.createElement('canvas'), {width: w, height: h}).getContext('2d');
    pen.drawImage(img, 0, 0);
    const [right, found] = [pen, own.getContext('2d')].map((one) => one.getImageData(0, 0, w, h).data);
    Object.assign(screen.style, {width: '', height: ''});
    await sized(() => own.width === Math.round(screen.clientWidth * devicePixelRatio));
    let count = 0;
    for (let k = 0; k < right.length; k += 4) count += Math.max(...[0, 1, 2].map((c) => Math.abs(right[k + c] - found[k + c]))) > 8;
    return 100 * count / (w * h);
};
// Whether a page permits a finger at a position to scroll it: '' or what refuses it.
const listen = () => document.addEventListener('pointerdown', (event) => setTimeout(() => { window.refused = event.defaultPrevented; }), {once: true});
const allows = ([x, y]) => {
    for (let one = document.elementFromPoint(x, y); one; one = one.parentElement) if (!/auto|pan-y|manipulation/.test(getComputedStyle(one).touchAction)) return `the touch-action of ${one.className}`;
    return window.refused === false ? '' : 'the press';
};
const focus = ([i, what]) => document.querySelectorAll('figure-sheet')[i].querySelector(what).focus({preventScroll: true});

// The digits of a figure are elements of the page, and those that remain in the picture are in another font.
const DIGITS = 0.4; // percent of the pixels

// Test the figures of a page.
//   driver  {evaluate, drag, key, scrolls}: drag moves the mouse, or a finger if `touch`, from one position to another;
//           scrolls is true if such a finger scrolls the page. If it does not, the test checks what the page permits
//   name    the name of the page
//   where   the browser and the width, for the names of the checks
export async function testFigures(driver, name, where, touch) {
    const {evaluate} = driver, wrong = [];
    const comes = async (i, right) => {
        for (const begun = Date.now(); ;) {
            const now = await evaluate(look, i);
            if (right(now) || Date.now() - begun > PATIENCE) return now;
            await evaluate(() => new Promise(requestAnimationFrame));
        }
    };
    // Wait until the page no longer scrolls, and has drawn what has changed.
    const rest = () => evaluate(async () => {
        for (let still = 0, before = -1; still < 6; still = scrollY === before ? still + 1 : 0) {
            before = scrollY;
            await new Promise(requestAnimationFrame);
        }
    });
    const count = await evaluate(() => document.querySelectorAll('figure-sheet').length);
    let points = 0, turns = 0;
    for (let i = 0; i < count; i++) {
        await evaluate(find, i);
        await rest();
        let now = await comes(i, ({drawn}) => drawn);
        const blame = (why) => wrong.push(`${now.name}: ${why}`);
        if (!now.drawn) { blame('it is not drawn'); continue; }
        now = await comes(i, ({points, turned}) => points.length > 0 || turned);
        if (now.points.length === 0 && !now.turned) { blame('it has no point'); continue; }
        for (const {name, label, value, role} of now.points) if (role !== 'slider' || !label?.startsWith(`${name}, `) || !/^x −?\d/.test(value)) blame(`${name} has no name or no value: ${label}, ${value}`);
        for (const {name} of now.points) {
            now = await evaluate(look, i);
            const before = now, [left, top, width, height] = now.box, {x, y} = now.points.find((one) => one.name === name);
            const by = [left + width / 2 > x ? 18 : -18, top + height / 2 > y ? 12 : -12];
            await driver.drag([x, y], [x + by[0], y + by[1]], touch);
            const there = ({points}) => { const point = points.find((one) => one.name === name); return point && Math.hypot(point.x - x - by[0], point.y - y - by[1]) < 3; };
            now = await comes(i, (one) => there(one) && one.picture !== before.picture);
            if (!there(now)) blame(`${name} does not follow`);
            else if (now.picture === before.picture) blame(`${name} moves, and the picture stays the same`);
            if (now.scroll !== before.scroll) blame(`dragging ${name} scrolls the page`);
            points++;
        }
        // The position in the picture that is farthest from all points.
        const [left, top, width, height] = now.box, grid = [0.1, 0.3, 0.5, 0.7, 0.9].flatMap((u) => [0.2, 0.5, 0.8].map((v) => [left + u * width, top + v * height]));
        const far = ([x, y]) => Math.min(1e9, ...now.points.map((one) => Math.hypot(one.x - x, one.y - y))), farthest = () => [...grid].sort((a, b) => far(b) - far(a))[0];
        if (now.turned) {
            const still = await evaluate(look, i), [x, y] = farthest();
            await driver.drag([x, y], [x + (x > left + width / 2 ? -40 : 40), y + 4], touch);
            now = await comes(i, (one) => one.turned !== still.turned && one.picture !== still.picture);
            if (now.turned === still.turned || now.picture === still.picture) blame('a drag does not turn it');
            if (now.scroll !== still.scroll) blame('turning it scrolls the page');
            turns++;
        }
        for (const [what, does, told] of [['.sheet-point', 'move its first point', ({points: [point]}) => point?.value], ['canvas', 'turn it', ({turned}) => turned]]) {
            if (!told(now)) continue;
            await evaluate(focus, [i, what]);
            const before = await evaluate(look, i);
            await driver.key('ArrowRight');
            now = await comes(i, (one) => told(one) !== told(before) && one.picture !== before.picture);
            if (told(now) === told(before)) blame(`an arrow key does not ${does}`);
            if (now.scroll !== before.scroll) blame('an arrow key scrolls the page');
            await driver.key('Escape');
            await rest();
        }
        if (!touch) continue;
        const from = farthest(), {points: stood, scroll} = await evaluate(look, i);
        await evaluate(listen);
        await driver.drag(from, [from[0], from[1] - 150], touch);
        const after = driver.scrolls ? await comes(i, (one) => Math.abs(one.scroll - scroll) > 30) : await evaluate(look, i);
        if (driver.scrolls && Math.abs(after.scroll - scroll) <= 30) blame('a swipe beside its points does not scroll the page');
        const refused = await evaluate(allows, from);
        if (!driver.scrolls && refused) blame(`a swipe beside its points would not scroll the page: ${refused}`);
        if (after.points.some(({value}, k) => value !== stood[k].value) && !after.turned) blame('a swipe beside its points moves one');
    }
    const shifted = await evaluate(() => window.shifted ?? 0);
    if (shifted > 0) wrong.push(`the page shifts by ${shifted}`);
    for (let i = 0; i < count && !touch; i++) {
        const {name, runs} = await evaluate(look, i), share = await evaluate(differs, [i, PATIENCE]);
        if (share > DIGITS && !runs) wrong.push(`${name}: after Reset, ${share.toFixed(2)} % of its pixels differ from its reference picture`);
    }
    check(`${where}: ${name}: ${count} figures are drawn when they are seen, and ${points} points${turns > 0 ? ` and ${turns} views` : ''} follow ${touch ? 'a finger' : 'the mouse'} and the arrow keys`, count > 0 && wrong.length === 0, wrong);
    return {count, points, turns};
}
