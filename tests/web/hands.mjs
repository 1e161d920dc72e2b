// hands.mjs - tests pages that respond to the mouse, a finger and the keys: a picture that becomes a program, the
// points of an interactive figure, clay, numbers in sentences, guesses, a phone and the front page. The pages are 1440
// or 390 pixels wide; figures and clay are tested at both widths.
import {blankPage, check, finish, frames, holds, launch, PATIENCE, serve, SITE, whole} from './browser.mjs';

const server = await serve(SITE), browser = await launch();
const DESK = {viewport: {width: 1440, height: 900}}, PHONE = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true, deviceScaleFactor: 2};

async function open(name, context = DESK, before = undefined) {
    const opened = await blankPage(browser, {context, before});
    await opened.page.goto(`${server.at}/${name}`);
    await whole(opened.page);
    return opened;
}
const state = (page) => page.evaluate(() => document.querySelector('.live-window')?.program?.state() ?? null);
async function comes(page, right, ...values) {
    await page.waitForFunction(([right, values]) => {
        const state = document.querySelector('.live-drawn')?.program?.state();
        return state?.runs && new Function('s', 'v', `return ${right}`)(state, values);
    }, [right, values], {timeout: PATIENCE}).catch(() => {});
    return state(page);
}
// The position on the screen of one of the figure's points.
async function handle(page, name) {
    const box = await page.locator('.live-canvas').boundingBox(), {x, y} = (await state(page)).handles.find((one) => one.name === name);
    return [box.x + x * box.width, box.y + y * box.height];
}
const value = async (page, name) => (await state(page)).parameters.find((one) => one.name === name).value;

// ---- A picture that becomes a program ----

let {page, said} = await open('01_normal_colouring.html', {...DESK, bypassCSP: true}); // the test evaluates strings as code, which the site's policy forbids
const picture = page.locator('.in-place:has(img[src*="slice-silhouette"])');
await picture.scrollIntoViewIfNeeded();
const before = await picture.locator('.live-screen').boundingBox();
await page.evaluate(() => { // record whether the still picture is visible until the first frame
    window.seen = [];
    const at = document.querySelector('.in-place:has(img[src*="slice-silhouette"])'), look = () => {
        window.seen.push(at.classList.contains('live-drawn') || getComputedStyle(at.querySelector('.live-screen > img')).display !== 'none');
        if (!at.classList.contains('live-drawn')) requestAnimationFrame(look);
    };
    look();
});
const begun = Date.now();
await picture.locator('img').click();
await page.waitForSelector('.live-drawn');
console.log(`# from the click to the first frame, including loading the module: ${Date.now() - begun} ms`);
let now = await comes(page, 's.probe');
check('a click on a picture runs its program, with the view and the ray that the picture shows', now.view === 'slice' && now.paused && Math.abs(now.pixel[0] / now.size[0] - 340 / 640) < 0.01, now.view, now.pixel, now.size);
const after = await picture.locator('.live-screen').boundingBox();
check('the program has the same position and size as the picture that it replaces', ['x', 'y', 'width', 'height'].every((side) => Math.abs(before[side] - after[side]) < 2), before, after);
check('the still picture stays visible until the first frame', await page.evaluate(() => window.seen.length > 1 && window.seen.every(Boolean)));
const other = page.locator('.in-place:has(img[src*="normals"])').first();
await other.scrollIntoViewIfNeeded();
await other.locator('.live-start').click();
await page.waitForFunction(() => document.querySelector('.live-drawn img')?.src.includes('normals'));
check('the page\'s program moves to a second picture, and the first becomes a still picture again', await page.locator('.live-canvas').count() === 1 && await picture.locator('img').isVisible());
check('the console reports no error', said.length === 0, said);
await page.close();

// ---- The start of a program ----

for (const [width, context] of [['1440 pixels', DESK], ['390 pixels', PHONE]]) {
    for (const [what, selector] of [['the chapter\'s program', 'main > live-chapter'], ['a picture', 'figure > .in-place:not(.hands)']]) {
        ({page, said} = await open('01_normal_colouring.html', context));
        await page.evaluate((selector) => { // record, in each frame, where the text below is, and whether there are buttons
            const at = document.querySelector(selector), below = at.nextElementSibling;
            at.scrollIntoView({block: 'center', behavior: 'instant'});
            window.tops = new Set();
            window.early = false;
            const look = () => {
                window.tops.add(below.getBoundingClientRect().top);
                window.early ||= !at.classList.contains('live-drawn') && at.querySelector('.live-bar')?.checkVisibility({visibilityProperty: true});
                requestAnimationFrame(look);
            };
            look();
        }, selector);
        await page.locator(selector).first().locator('.live-start').click();
        await page.locator(selector).first().locator('.live-bar').getByRole('button', {name: 'Edit'}).waitFor();
        await frames(page, 10);
        check(`${width}: when ${what} starts, the text below does not move, and no button appears before the first frame`, await page.evaluate(() => window.tops.size === 1 && !window.early), await page.evaluate(() => [[...window.tops], window.early]));
        check('the console reports no error', said.length === 0, said);
        await page.close();
    }
}

// ---- A figure and its program ----

for (const [name, context] of [['1440 pixels', DESK], ['390 pixels', PHONE]]) {
    ({page, said} = await open('index.html', {...context, bypassCSP: true}));
    const loaded = [];
    page.on('request', (request) => loaded.push(request.url().split('/').at(-1)));
    const figure = page.locator('.hands').first(), ball = figure.locator('[data-name=ball]'), edit = figure.locator('.sheet-edit');
    await figure.scrollIntoViewIfNeeded();
    await page.waitForSelector('.hands .drawn');
    const screen = await figure.locator('.sheet-screen').boundingBox();
    await ball.focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Tab');
    const next = await page.evaluate(() => document.activeElement.className);
    check(`${name}: the points come before the buttons when a reader presses Tab`, next === 'sheet-reset', next);
    check(`${name}: a figure needs no program`, !loaded.some((file) => /^(harness|stage|program)/.test(file)), loaded);
    await edit[context === PHONE ? 'tap' : 'click']();
    await page.waitForSelector('.live-window.live-editing.live-drawn .cm-content');
    now = await comes(page, 's.handles.length > 2');
    const moved = await value(page, 'ball'), box = await page.locator('.live-canvas').boundingBox();
    check(`${name}: Edit opens the figure's program with the point where the reader has moved it`, Math.abs(moved[0] + 0.29) < 1e-3, moved);
    check(`${name}: Edit opens the figure's shader`, /uniform vec2 ball/.test(await page.locator('.cm-content').textContent()));
    const beside = context === DESK ? Math.abs(box.y - screen.y) < 2 && box.x + box.width <= (await page.locator('.cm-editor').boundingBox()).x : Math.abs(box.x + box.width / 2 - screen.x - screen.width / 2) < 2;
    check(`${name}: the program is where the figure was, ${context === DESK ? 'beside its text' : 'above its text'}`, beside && !await figure.locator('.sheet-screen').isVisible(), box, screen);
    await page.locator('.live-tools').getByRole('button', {name: 'Close'}).click();
    await page.waitForSelector('.hands:not(.live-on)');
    check(`${name}: after Close, the figure is there again, and its button has the focus`, await figure.locator('.sheet-screen').isVisible() && await page.evaluate(() => document.activeElement.className) === 'sheet-edit', await page.evaluate(() => document.activeElement.className));
    check(`${name}: the page does not scroll sideways`, await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    check(`${name}: the console reports no error`, said.length === 0, said);
    await page.close();
}

// ---- A picture that a reader turns ----

{
    ({page, said} = await open('05_transforms.html', {...DESK, bypassCSP: true}));
    const pair = page.locator('table .turns'), told = () => pair.locator('canvas').evaluateAll((all) => all.map((one) => one.getAttribute('aria-valuetext')));
    await pair.first().scrollIntoViewIfNeeded();
    await page.waitForSelector('table .turns.drawn');
    const {x, y, width, height} = await pair.first().boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 100, y + height / 2 + 20, {steps: 4});
    await page.mouse.up();
    const [first, second] = await told(), wanted = await pair.first().evaluate((one) => one.camera[0]);
    check('both pictures of a comparison turn together', first === 'turned by 40°, tilted by 8°' && second === first, first, second);
    await pair.first().locator('.sheet-edit').click();
    now = await comes(page, 's.camera');
    check('Edit opens the program with the camera that the reader has chosen', now && wanted.every((one, i) => Math.abs(one - now.camera[i]) < 1e-4), wanted, now?.camera);
    check('with a picture that turns, the console reports no error', said.length === 0, said);
    await page.close();
}

// ---- Words in a sentence ----

for (const [name, context] of [['1440 pixels', DESK], ['390 pixels', PHONE]]) {
    ({page, said} = await open('09_sky_and_sunset.html', context));
    const sun = page.locator('.sheet-word[data-name=sun]').nth(1), capped = page.locator('.sheet-word[data-name=capped]');
    const lit = () => page.evaluate(() => [...document.querySelectorAll('.sheet-point.lit')].map((one) => `${one.closest('figure-sheet').getAttribute('name')} ${one.dataset.name}`).join());
    await sun.scrollIntoViewIfNeeded();
    if (context === DESK) {
        await sun.hover();
        check(`${name}: under the mouse, a word lights the point of the nearest figure, and of no other`, await lit() === '09_scattered sun', await lit());
        await page.mouse.move(5, 5);
        check(`${name}: the point is no longer lit when the mouse leaves the word`, await lit() === '', await lit());
    }
    await sun[context === DESK ? 'click' : 'tap']();
    check(`${name}: a press on a word lights the point`, await lit() === '09_scattered sun', await lit());
    const value = () => page.evaluate(() => document.querySelector('figure-sheet[name="09_towers"]').parameter('capped').value[0]);
    const before = await value();
    await capped.focus();
    await page.keyboard.press('Enter');
    check(`${name}: a word with a value sets it in the figure, which is then in sight`, before === 1 && await holds(page, async () => await value() === 0 && await page.evaluate(() => {
        const {top, bottom} = document.querySelector('figure-sheet[name="09_towers"] .sheet-screen').getBoundingClientRect();
        return top >= 0 && bottom <= innerHeight && !document.querySelector('figure-sheet[name="09_towers"] input').checked;
    })));
    check(`${name}: the console reports no error`, said.length === 0, said);
    await page.close();
}

// ---- Sculpted clay ----

for (const [name, context] of [['mouse', DESK], ['finger', PHONE]]) {
    ({page, said} = await open('23_stored_distances.html', {...context, bypassCSP: true}));
    const finger = context === PHONE;
    const hat = page.locator('.in-place:has(img[src*="-hat"])');
    await hat.scrollIntoViewIfNeeded();
    await hat.locator('.live-start')[finger ? 'tap' : 'click']();
    await comes(page, 's.parameters.some((p) => p.name === "tool")');
    await page.evaluate(() => {
        const {program} = document.querySelector('.live-window');
        program.call('live_set', 'turnSpeed', 0, 0);
        program.call('live_set', 'tool', 0, 0.1);
    });
    now = await comes(page, 's.tool');
    await page.getByRole('button', {name: 'Undo stroke'}).waitFor({timeout: PATIENCE}).catch(() => {}); // the page shows the button after the state has changed
    check(`${name}: a sculpting tool has a button that undoes its last stroke`, now.tool === true && await page.getByRole('button', {name: 'Undo stroke'}).count() === 1);
    await page.evaluate(() => document.querySelector('.live-screen:has(.live-canvas)').scrollIntoView({block: 'center', behavior: 'instant'}));
    const shot = async () => (await page.locator('.live-canvas').screenshot({style: '.live-free { visibility: hidden }'})).toString('base64');
    let bare = ''; // the picture before the stroke, once it no longer changes
    await holds(page, async () => {
        const last = bare;
        await frames(page, 30); // by then, a picture at rest has been sharpened
        bare = await shot();
        return bare === last;
    });
    const box = await page.locator('.live-canvas').boundingBox();
    const at = (share) => [box.x + (0.42 + share) * box.width, box.y + 0.5 * box.height];
    if (finger) {
        const fingers = await page.context().newCDPSession(page), touch = (type, ...points) => fingers.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y]) => ({x, y}))});
        await touch('touchStart', at(0));
        for (let i = 1; i <= 4; i++) await touch('touchMove', at(0.02 * i));
        await touch('touchEnd');
    } else {
        await page.mouse.move(...at(0));
        await page.mouse.down();
        await page.mouse.move(...at(0.08), {steps: 4});
        await page.mouse.up();
    }
    check(`${name}: a drag over the clay adds clay`, await holds(page, async () => await shot() !== bare));
    await page.evaluate(() => [...document.querySelectorAll('button')].find((one) => one.textContent.trim() === 'Undo stroke' || one.title === 'Undo stroke' || one.ariaLabel === 'Undo stroke').click());
    check(`${name}: the button Undo stroke restores the picture`, await holds(page, async () => await shot() === bare));
    check(`${name}: the console reports no error`, said.length === 0, said);
    await page.close();
}

// ---- Numbers in sentences ----

({page, said} = await open('03_shadows.html', {...DESK, bypassCSP: true}));
await page.evaluate(() => {
    const line = document.createElement('p');
    line.innerHTML = 'With <code class="scrub" data-name="lampHeight">lampHeight=<data value="2">2</data></code>.';
    document.querySelector('live-chapter').after(line);
    return import('./live.js').then((live) => { live.scrub(line.firstElementChild); });
});
const code = page.locator('code.scrub').first();
let box = await code.boundingBox();
await page.mouse.move(box.x + 40, box.y + 8);
await page.mouse.down();
now = await comes(page, 's.parameters.find((p) => p.name === "lampHeight").value[0] === 2');
check('a press on a number sets that value in the nearest picture', (await value(page, 'lampHeight'))[0] === 2);
await page.mouse.move(box.x + 100, box.y + 8, {steps: 5});
await page.mouse.up();
let height;
check('dragging a number to the right increases the value, in the sentence and in the picture', await holds(page, async () => {
    [height] = await value(page, 'lampHeight');
    return height > 2.5 && await code.textContent() === `lampHeight=${Number(height.toPrecision(3))}`;
}), height, await code.textContent());
await page.keyboard.press('ArrowLeft');
now = await comes(page, 's.parameters.find((p) => p.name === "lampHeight").value[0] < v[0]', height);
check('the arrow keys change a number in a sentence', (await value(page, 'lampHeight'))[0] < height && Number(await code.getAttribute('aria-valuenow')) < height);
await page.evaluate(() => {
    const number = document.querySelector('code.scrub');
    scrollBy({top: number.getBoundingClientRect().top - 100, behavior: 'instant'});
    number.focus({preventScroll: true});
});
await page.keyboard.press('ArrowRight');
await page.waitForSelector('.live-afloat');
box = await page.locator('.live-canvas').boundingBox();
check('a picture that is scrolled out of view becomes visible while its number is changed', box.y >= 0 && box.y + box.height <= 900, box);
await page.evaluate(() => scrollBy({top: 1500, behavior: 'instant'}));
await page.waitForSelector('.live-afloat', {state: 'detached'});
check('it floats no longer than its number is on the screen', (await page.locator('.live-canvas').boundingBox()).y < 0);
check('the console reports no error', said.length === 0, said);
await page.close();

// ---- Predict first ----

({page, said} = await open('00_first_scene.html', DESK));
const guess = page.locator('form.guess').first(), answer = page.locator('form.guess ~ details').first();
await answer.locator('summary').click();
check('an answer asks for a guess before it opens', !await answer.evaluate((one) => one.open) && /Guess first/.test(await guess.locator('output').textContent()));
await guess.getByLabel('the one that just misses').check();
await guess.getByRole('button').click();
check('after a guess, the answer opens and says whether the guess is right', await answer.evaluate((one) => one.open) && await answer.locator('.guessed').textContent() === 'Your guess: the one that just misses. That is right.', await answer.textContent());
await page.reload();
check('a guess is still there after a reload', await answer.locator('.guessed').textContent() === 'Your guess: the one that just misses. That is right.');
const counted = page.locator('form.guess[data-kind=number]').first();
await counted.locator('input').fill('3');
await counted.getByRole('button').click();
check('if the guess is a number, the page says how close it was', await page.getByText('Your guess: 3. It is 1: you were off by a factor of 3.0.').isVisible());
const second = page.locator('form.guess:not([data-kind])').first();
await second.evaluate((form) => { let next = form; while (!next.matches('details')) next = next.nextElementSibling; next.id = 'second'; });
await page.locator('#second summary').click();
await page.locator('#second summary').click();
check('an answer opens on the second click, even without a guess', await page.locator('#second').evaluate((one) => one.open));
const question = page.locator('form.question').first();
await question.getByRole('radio').first().check();
check('a question says why an answer is wrong', /^The steps have no fixed size/.test(await question.locator('output').textContent()));
await question.getByRole('radio').nth(1).check();
check('a question says that the right answer is right', await question.locator('output').textContent() === 'That is right.');
check('the console reports no error', said.length === 0, said);
await page.close();

// In some questions, the guess is a point in a picture. On page 03, the question is where the stripes are; the answer
// is the near part of the stage.
({page, said} = await open('03_shadows.html', PHONE));
const pointed = page.locator('form.guess[data-kind=tap]').first(), tapped = pointed.locator('.tap'), area = await tapped.boundingBox();
await tapped.tap({position: {x: 0.15 * area.width, y: 0.8 * area.height}});
await pointed.getByRole('button', {name: 'Keep my guess'}).tap();
check('if the tap misses the correct area, the page says how far off it was', await page.getByText('Your guess: the mark. You were off by 20 %').isVisible());
await tapped.focus();
for (let i = 0; i < 12; i++) await page.keyboard.press('ArrowRight');
await pointed.getByRole('button', {name: 'Keep my guess'}).tap();
check('the arrow keys can move the mark to the correct area', await page.getByText('Your guess: the mark. That is right.').isVisible());
check('the console reports no error', said.length === 0, said);
await page.close();

// ---- A phone ----

({page, said} = await open('01_normal_colouring.html', {...PHONE, bypassCSP: true}));
await page.locator('.live-start').first().tap();
await comes(page, 's.rate > 0');
const free = page.locator('.live-free');
await page.locator('.live-canvas').tap({position: {x: 190, y: 20}});
check('a picture that keeps every swipe says so', await free.isVisible() && await page.evaluate(() => getComputedStyle(document.querySelector('.live-canvas')).touchAction) === 'none');
await free.tap();
check('a tap on that sign lets swipes scroll the page again', await free.isHidden() && await page.evaluate(() => getComputedStyle(document.querySelector('.live-canvas')).touchAction) === 'pan-y pinch-zoom');
const icons = await page.locator('.live-iconed:visible').evaluateAll((all) => all.map((one) => one.getBoundingClientRect()).map(({top, height, width}) => [Math.round(top), height, width]));
check('the controls are a single row of icons, large enough for a thumb', icons.length === 9 && new Set(icons.map(([top]) => top)).size === 1 && icons.every(([, height, width]) => height >= 44 && width >= 32), icons);
await page.locator('.live-canvas').tap({position: {x: 190, y: 120}});
await page.waitForSelector('.live-slice:not([hidden])');
await page.waitForFunction(() => document.querySelector('.live-slice').width > 0);
const [canvas, slice] = [await page.locator('.live-canvas').boundingBox(), await page.locator('.live-slice').boundingBox()];
check('the slice of the ray opens below the picture', slice.y > canvas.y + canvas.height && slice.y < canvas.y + canvas.height + 80 && slice.width > 340, canvas, slice);
const orange = await page.locator('.live-slice').evaluate((one) => [...one.getContext('2d').getImageData(one.width / 4, one.height / 4, 1, 1).data]);
check('the slice of the ray is drawn, while the program stays in the picture view', orange[0] > orange[2] && (await state(page)).view === 'picture', orange);
await page.getByRole('button', {name: 'Move', exact: true}).tap();
check('Move shows the arrow buttons', await page.getByRole('button', {name: 'Move forwards'}).isVisible());
check('the console reports no error', said.length === 0, said);
await page.close();

// On its side, a phone is wide but has no room for the contents beside the text.
({page, said} = await open('03_shadows.html', PHONE));
const read = page.locator('main > p').nth(12), where = async () => Math.round((await read.boundingBox()).y);
await read.evaluate((one) => scrollTo({top: one.getBoundingClientRect().top - 75, behavior: 'instant'}));
await frames(page, 3);
const upright = await where();
await page.setViewportSize({width: 844, height: 390});
await frames(page, 3);
const flat = await where();
await page.setViewportSize({width: 390, height: 844});
await frames(page, 3);
check('the paragraph at the top of the screen stays there when a phone is turned, and turned back', [flat, await where()].every((top) => Math.abs(top - upright) < 15), upright, flat, await where());
await page.setViewportSize({width: 844, height: 390});
check('on its side, a phone shows the text over its whole width', !await page.locator('.contents').isVisible() && (await page.locator('main').boundingBox()).x < 60);
check('the console reports no error', said.length === 0, said);
await page.close();

// ---- The front page ----

({page, said} = await open('index.html', DESK));
const asked = [], film = page.locator('video');
page.on('request', (request) => asked.push(request.url()));
check('the first screen of the front page shows a figure that is drawn', await page.locator('.drawn > .sheet-screen').first().waitFor().then(() => page.evaluate(() => document.querySelector('.sheet-screen').getBoundingClientRect().bottom <= innerHeight)));
await film.scrollIntoViewIfNeeded();
await frames(page, 20);
check('the film of a day is not loaded before a reader plays it', asked.every((url) => !/day/.test(url)) && await film.evaluate((one) => one.paused), asked);
await page.getByRole('button', {name: 'Play the film'}).press('Enter');
await page.waitForFunction(() => document.querySelector('video').currentTime > 0.2);
await page.keyboard.press('Space');
check('the film plays, and the keyboard pauses it', await film.evaluate((one) => one.paused && one.controls));
await page.locator('a.begin').click();
await page.waitForSelector('.live-window.live-editing .cm-content');
check('the button on the front page starts the program of a ball and opens it in the editor', new URL(page.url()).pathname === '/play.html' && /sdSphere/.test(await page.locator('.cm-content').textContent()));
const [left, right] = [await page.locator('.live-canvas').boundingBox(), await page.locator('.live-editor').boundingBox()];
check('the editor is to the right of the picture', right.x >= left.x + left.width, left, right);
check('the button that selects a file has the font of the other buttons', await page.evaluate(() => getComputedStyle(document.querySelector('#file'), '::file-selector-button').fontFamily === getComputedStyle(document.querySelector('.starter')).fontFamily));
check('the console reports no error', said.length === 0, said);
await page.close();
({page} = await open('index.html', DESK));
await page.evaluate(() => { localStorage.last = JSON.stringify({page: '03_shadows.html', title: 'Shadows', id: 'the-lamp', words: 'The lamp'}); });
await page.reload();
await page.locator('.resume').getByRole('button', {name: 'Close'}).press('Enter');
check('the front page offers to go on reading, and when the offer is closed with the keyboard, the focus goes to the text', await page.evaluate(() => document.activeElement.matches('main')) && await page.locator('.resume').count() === 0);
await page.close();

finish();
await browser.close();
server.close();
