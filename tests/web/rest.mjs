// rest.mjs - tests what the pages do while they rest: the figures that are not near the screen yet are compiled one after
// the other, the nearest first, without blocking the page, and never while the reader scrolls, presses or drags.
//
// In these pages, the clock and the driver are the test's own. The page's time passes only if the test says so, so no
// pause of the machine counts as rest, and a program is compiled when the test lets the driver go on.
import {blankPage, check, finish, frames, holds, launch, serve, SITE, whole} from './browser.mjs';

const server = await serve(SITE), browser = await launch();
const DESK = {viewport: {width: 1440, height: 900}, reducedMotion: 'reduce'};
const PHONE = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true, deviceScaleFactor: 2, reducedMotion: 'reduce'};

// Run this in a page before its scripts. It notes the figures in the order in which they are linked, and what a driver is
// asked about a figure that is not near the screen while it is still busy, which would block the page.
//   driver  'own' is the browser's, 'threads' one that compiles on separate threads, 'fences' one that does not
//   more    {saves, memory, idle}: what the browser says of its reader, and whether it has requestIdleCallback
function watch({driver, saves, memory, idle}) {
    window.linked = [];
    window.blocked = [];
    window.drawings = [];
    window.goes = driver === 'own'; // does the driver go on?
    window.clock = driver === 'own' ? null : 0;
    const {now} = performance;
    performance.now = () => window.clock ?? now.call(performance);
    if (saves) Object.defineProperty(navigator, 'connection', {value: {saveData: true}});
    Object.defineProperty(navigator, 'deviceMemory', {value: memory});
    if (!idle) delete window.requestIdleCallback;
    const gl = WebGL2RenderingContext.prototype, {linkProgram, useProgram, drawArrays, getExtension, getProgramParameter, getSyncParameter} = gl;
    const busy = new Set(), ahead = new Set(), sheetOf = (program) => [...document.querySelectorAll('figure-sheet')].findIndex((one) => one.program === program);
    let used = null;
    window.goOn = () => busy.clear();
    gl.linkProgram = function (program) {
        const all = [...document.querySelectorAll('figure-sheet')], i = sheetOf(program);
        // How many other figures are being prepared, and is a figure near the screen not drawn yet?
        window.linked.push({i, near: all[i].near, others: all.filter((one) => one.program && one.program !== program && !one.ready).length, first: all.every((one) => !one.near || one.drawn)});
        if (!window.goes) busy.add(program);
        if (!all[i].near) ahead.add(program);
        linkProgram.call(this, program);
    };
    gl.useProgram = function (program) {
        used = program;
        useProgram.call(this, program);
    };
    gl.drawArrays = function (...values) {
        window.drawings.push(sheetOf(used));
        if (busy.has(used) && ahead.has(used)) window.blocked.push('a draw');
        drawArrays.apply(this, values);
    };
    if (driver === 'own') return;
    gl.getExtension = function (name) { return name !== 'KHR_parallel_shader_compile' ? getExtension.call(this, name) : driver === 'threads' ? {COMPLETION_STATUS_KHR: 0x91B1} : null; };
    gl.getProgramParameter = function (program, name) {
        if (name === 0x91B1) return !busy.has(program);
        if (busy.has(program) && ahead.has(program)) window.blocked.push('whether it is linked');
        return getProgramParameter.call(this, program, name);
    };
    gl.getSyncParameter = function (fence, name) { return busy.size > 0 ? this.UNSIGNALED : getSyncParameter.call(this, fence, name); };
}

async function open(name, {context = DESK, ...more} = {}) {
    const opened = await blankPage(browser, {context});
    await opened.page.addInitScript(watch, {driver: 'own', saves: false, memory: 8, idle: true, ...more});
    await opened.page.goto(`${server.at}/${name}`);
    await whole(opened.page);
    return opened;
}
const look = (page) => page.evaluate(() => ({
    linked: window.linked, drawings: window.drawings, blocked: window.blocked, clock: window.clock, scroll: scrollY,
    sheets: [...document.querySelectorAll('figure-sheet')].map((one) => {
        let box = one;
        for (let fold = one; (fold = fold.parentElement.closest('details'));) if (!fold.open) box = fold;
        return {near: one.near, drawn: Boolean(one.drawn), isReady: Boolean(one.program && one.ready), isLinked: Boolean(one.places), top: box.getBoundingClientRect().top};
    }),
}));
// Show a figure, also one in a fold.
const show = (i) => {
    const sheet = document.querySelectorAll('figure-sheet')[i];
    for (let fold = sheet; (fold = fold.parentElement.closest('details'));) fold.open = true;
    sheet.scrollIntoView({block: 'center', behavior: 'instant'});
};
const until = (page, right) => holds(page, async () => right(await look(page)));
const allReady = ({sheets}) => sheets.length > 0 && sheets.every(({isReady}) => isReady);
const pass = (page, time = 1e3) => page.evaluate((time) => { window.clock += time; }, time);

// ---- A page that rests ----

for (const [name, more] of [['08_orthographic_view.html', {}], ['01_normal_colouring.html', {idle: false}]]) {
    const {page, said} = await open(name, more), where = more.idle === false ? `${name}, without requestIdleCallback` : name;
    check(`${where}: all figures of a page that rests are compiled before the reader scrolls`, await until(page, allReady), (await look(page)).sheets);
    const {linked, drawings, sheets, scroll} = await look(page), ahead = linked.filter(({near}) => !near), tops = ahead.map(({i}) => sheets[i].top);
    check(`${where}: those of the first screen are drawn before`, scroll === 0 && ahead.length > 3 && linked.length > ahead.length && linked.length === sheets.length && ahead.every(({first}) => first) && sheets.every(({near, drawn}) => near === drawn), linked, sheets);
    check(`${where}: each has drawn, because some drivers finish a program only then`, sheets.every((_, i) => drawings.includes(i)), drawings);
    check(`${where}: they are compiled one after the other, the nearest first`, ahead.every(({others}) => others === 0) && tops.every((top, k) => k === 0 || top >= tops[k - 1]), ahead, tops);
    for (let i = 0; i < sheets.length; i++) {
        await page.evaluate(show, i);
        await until(page, (now) => now.sheets[i].drawn);
    }
    const after = await look(page);
    check(`${where}: then each is drawn when it is seen, and none is compiled again`, after.sheets.every(({drawn}) => drawn) && after.linked.length === sheets.length, after);
    check('the console reports no error', said.length === 0, said);
    await page.close();
}

{
    const {page, said} = await open('01_normal_colouring.html');
    await until(page, allReady);
    const count = (await look(page)).linked.length;
    await page.evaluate(() => { document.documentElement.dataset.theme = 'light'; });
    await frames(page, 30);
    check('in a theme with the same colours, none is compiled again', (await look(page)).linked.length === count, (await look(page)).linked);
    await page.evaluate(() => { document.documentElement.style.colorScheme = document.documentElement.dataset.theme = 'dark'; });
    check('in another theme, all are compiled again', await until(page, (now) => now.linked.length === 2 * count && allReady(now)), (await look(page)).sheets);
    await page.evaluate(() => new Promise((done) => {
        const {canvas, gl} = document.querySelector('figure-sheet').pen, taken = gl.getExtension('WEBGL_lose_context');
        canvas.addEventListener('webglcontextrestored', done, {once: true});
        canvas.addEventListener('webglcontextlost', () => setTimeout(() => taken.restoreContext()), {once: true});
        taken.loseContext();
    }));
    check('after a lost context, all are compiled again', await until(page, (now) => now.linked.length === 3 * count && allReady(now)), (await look(page)).sheets);
    check('the console reports no error', said.length === 0, said);
    await page.close();
}

// ---- What the reader does meanwhile ----

for (const driver of ['threads', 'fences']) {
    const where = driver === 'threads' ? 'a driver with threads' : 'a driver without threads', {page, said} = await open('01_normal_colouring.html', {driver}), ahead = ({linked}) => linked.filter(({near}) => !near).length;
    await until(page, ({linked}) => linked.length > 0);
    if (driver === 'threads') {
        await frames(page, 30);
        check(`${where}: while the first screen is not drawn, no other figure is compiled`, ahead(await look(page)) === 0, (await look(page)).linked);
        await page.evaluate(() => window.goOn());
    }
    await until(page, (now) => ahead(now) > 0);
    await frames(page, 30);
    check(`${where}: then one is`, ahead(await look(page)) === 1, (await look(page)).linked);

    // The figure on the first screen is dragged while the driver compiles another. For each movement, count the frames
    // until the figure has been drawn; in the first of them, it has not been drawn yet.
    await page.evaluate(show, 0);
    await frames(page, 3);
    const point = page.locator('figure-sheet.drawn .sheet-point:visible').first(), box = await point.boundingBox(), [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.evaluate(() => {
        let frame = 0, moved = null;
        window.late = [];
        const turn = () => {
            frame++;
            if (moved !== null && window.drawings.includes(0)) {
                window.late.push(frame - moved);
                moved = null;
            }
            window.drawings.length = 0;
            requestAnimationFrame(turn);
        };
        requestAnimationFrame(turn);
        addEventListener('pointermove', (event) => { if (event.buttons > 0) moved ??= frame; });
    });
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 8; i++) {
        await page.mouse.move(x + 4 * i, y + 2 * i);
        await frames(page, 3);
    }
    const late = await page.evaluate(() => window.late);
    check(`${where}: meanwhile, a drag is drawn in the next frame`, late.length >= 6 && late.every((count) => count <= 2), late);
    check(`${where}: nothing that would wait for the driver is asked`, (await look(page)).blocked.length === 0, (await look(page)).blocked);
    await page.evaluate(() => window.goOn());
    await pass(page);
    await until(page, ({sheets}) => sheets.filter(({isReady}) => isReady).length > 1);
    await frames(page, 45);
    check(`${where}: while the mouse is pressed, no other figure is compiled`, ahead(await look(page)) === 1, (await look(page)).linked);
    await page.mouse.up();
    await frames(page, 45);
    check(`${where}: nor soon after`, ahead(await look(page)) === 1, (await look(page)).linked);
    await pass(page);
    check(`${where}: when the page rests again, the next one is`, await until(page, (now) => ahead(now) === 2), (await look(page)).linked);
    await page.evaluate(() => window.goOn());
    await page.evaluate(() => scrollBy({top: 40, behavior: 'instant'}));
    await frames(page, 45);
    check(`${where}: soon after a page has scrolled, no other is`, ahead(await look(page)) === 2, (await look(page)).linked);
    await pass(page);
    check(`${where}: when it rests, the next one is`, await until(page, (now) => ahead(now) === 3), (await look(page)).linked);

    // The reader is faster than the driver.
    await page.evaluate(() => { window.goes = true; });
    await page.evaluate(show, 4);
    await page.evaluate(() => window.goOn());
    check(`${where}: a figure to which a reader scrolls at once is drawn`, await until(page, ({sheets}) => sheets[4].drawn), (await look(page)).sheets);
    await pass(page);
    check(`${where}: then all are ready`, await until(page, allReady), (await look(page)).sheets);
    check('the console reports no error', said.length === 0, said);
    await page.close();
}

// ---- A reader who saves data ----

for (const [where, name, more] of [['a reader who saves data', '19_moon_and_stars.html', {saves: true}], ['a telephone with 2 GB', '01_normal_colouring.html', {context: PHONE, memory: 2}]]) {
    const {page, said} = await open(name, more), below = ({sheets}) => sheets.filter(({near, top}) => !near && top > 0).sort((a, b) => a.top - b.top), two = (now) => below(now).length > 1 && below(now).slice(0, 2).every(({isReady}) => isReady);
    check(`${where}: the next two figures are compiled`, await until(page, two), (await look(page)).sheets);
    await frames(page, 45);
    const now = await look(page), loaded = await page.evaluate(() => document.querySelectorAll('script[src*="/textures/"]').length);
    check(`${where}: no other is, and no texture is loaded`, below(now).length > 2 && below(now).slice(2).every(({isLinked}) => !isLinked) && loaded === 0, now.sheets, loaded);
    await page.evaluate(show, now.sheets.findIndex(({near, isReady}) => !near && isReady));
    check(`${where}: further down, the next two are`, await until(page, (after) => after.linked.length > now.linked.length && two(after)), (await look(page)).sheets);
    check('the console reports no error', said.length === 0, said);
    await page.close();
}

finish();
await browser.close();
server.close();
