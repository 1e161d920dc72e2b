// faults.mjs - tests for errors that readers have found in pages of the site: which wheel and key events scroll, a
// draft for each exercise, two tabs, unusual addresses, a lost context, the search, a browser without WebGL 2, loading
// and print.
import {blankPage, check, finish, frames, launch, serve, SITE, whole} from './browser.mjs';

const server = await serve(SITE), browser = await launch();
const PHONE = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true, deviceScaleFactor: 2};

async function open(name, context = {viewport: {width: 1440, height: 900}}, more = {}) {
    const opened = await blankPage(browser, {context, ...more});
    await opened.page.goto(`${server.at}/${name}`);
    await whole(opened.page);
    return opened;
}
const runs = (page) => page.waitForFunction(() => document.querySelector('.live-window')?.program?.state().rate > 0);
const scrolled = (page, from) => page.waitForFunction((from) => scrollY > from + 50, from).then(() => true, () => false);

// ---- The wheel and the keyboard before and after a click on the picture ----

const both = await browser.newContext({viewport: {width: 1440, height: 900}}); // shared by two tabs
let {page, said} = await blankPage(both);
await page.goto(`${server.at}/00_first_scene.html`);
await page.locator('.live-start').first().click();
await runs(page);
const box = await page.locator('.live-canvas').boundingBox();
await page.mouse.move(box.x + box.width / 2, box.y + 40);
let from = await page.evaluate(() => scrollY);
await page.mouse.wheel(0, 200);
check('the wheel scrolls the page when the pointer is over a program that has just started', await scrolled(page, from));
for (const key of ['Space', 'PageDown']) {
    await page.evaluate(() => scrollTo(0, 0));
    await page.keyboard.press(key);
    check(`${key} scrolls the page when a program has just started`, await scrolled(page, 0));
}
await page.evaluate(() => scrollTo(0, 0));
await page.locator('.live-canvas').click();
check('a click gives the picture the keyboard focus', await page.evaluate(() => document.activeElement.className === 'live-canvas'));

// ---- A lost context ----

await page.evaluate(() => new Promise((found) => {
    const canvas = document.querySelector('.live-canvas'), taken = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
    canvas.addEventListener('webglcontextlost', () => setTimeout(() => taken.restoreContext(), 300), {once: true});
    canvas.addEventListener('webglcontextrestored', found, {once: true});
    taken.loseContext();
    document.querySelector('.live-on').program.call('live_turn'); // an iteration of the main loop that the loss interrupts
}));
await runs(page);
await frames(page, 40);
check('once a lost context is restored, no message covers the picture', await page.locator('.live-notice').isHidden(), await page.locator('.live-notice').textContent());
check('the console reports no error', said.length === 0, said);

// ---- An answer to each exercise ----

const answer = (number) => page.locator(`form.check[data-exercise="00-${number}"]`);
await answer(1).locator('.answer').click();
await page.waitForSelector('.live-beside .cm-content');
await page.evaluate(() => { const {changes} = document.querySelector('.live-on').stage; return changes.change(changes.editor.name, 'void main() { nonsense; }'); });
check('the editor shows an exercise as a separate file, my.frag, as make check calls it', await page.evaluate(() => document.querySelector('[role=tab]').textContent) === 'my.frag' && await page.getByRole('button', {name: 'Download my.frag'}).count() === 1);
await answer(2).locator('button').first().click();
await page.waitForFunction(() => document.querySelectorAll('.live-open').length > 0);
check('a change to one exercise does not appear in another', (await answer(2).locator('.live-verdict').textContent()).startsWith('You have not changed'));
await answer(1).locator('button').first().click();
await page.waitForFunction(() => /Wrong/.test(document.querySelector('.live-beside > .live-verdict')?.textContent));
check('the check of the changed exercise judges the change', /^Wrong: does not run: my\.frag:1:/.test(await page.locator('.live-beside > .live-verdict').textContent()), await page.locator('.live-beside > .live-verdict').textContent());

// A reader's change that makes the shader run for ever also ends in a lost context.
await page.evaluate(() => {
    window.taken = document.querySelector('.live-canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
    window.taken.loseContext();
});
await page.waitForSelector('.live-notice:not([hidden])');
check('the message about a lost context has a button that undoes the reader\'s changes', await page.locator('.live-notice').getByRole('button', {name: 'Reset all files'}).isVisible());
await page.evaluate(() => window.taken.restoreContext());
await page.waitForSelector('.live-notice', {state: 'hidden'});

// ---- Two tabs ----

const other = await both.newPage();
await other.goto(`${server.at}/00_first_scene.html`);
await other.evaluate(() => {
    const key = Object.keys(localStorage).find((one) => one.startsWith('ray marching'));
    localStorage.setItem(key, JSON.stringify({'chapters/exercises/00_1/my.frag': '// of the other tab\n'}));
});
await page.waitForFunction(() => /Another tab/.test(document.body.innerText));
check('a change in another tab is reported', true);
await page.getByRole('button', {name: 'Take the other text'}).click();
await page.waitForFunction(() => document.querySelector('.cm-content').textContent.includes('of the other tab'));
check('the reader can take the text of the other tab', await page.getByText('Another tab has changed').isHidden());
await both.close();

// ---- The focus of a reader who uses the keyboard ----

({page, said} = await open('03_shadows.html'));
const focus = () => page.evaluate(() => document.activeElement.className);
await page.locator('.live-start').first().focus();
await page.keyboard.press('Enter');
await runs(page);
check('Enter on the button of a picture gives the focus to the program', await focus() === 'live-canvas', await focus());
await page.keyboard.press('Backspace');
await page.waitForSelector('.live-window', {state: 'detached'});
check('when the program ends, its button has the focus again', await focus() === 'live-start', await focus());
await page.close();

// ---- A page that is left while the reader types ----

({page, said} = await open('00_first_scene.html'));
await page.locator('.live-start').first().click();
await runs(page);
await page.getByRole('button', {name: 'Edit', exact: true}).click();
await page.locator('.cm-content').click();
await page.keyboard.type('// last words');
await page.reload();
check('what was typed just before the page is left is stored', await page.evaluate(() => JSON.stringify({...localStorage}).includes('// last words')));
await page.close();

// ---- Addresses ----

for (const hash of ['#100%', '#edit=%%%']) {
    ({page, said} = await open(`00_first_scene.html${hash}`));
    check(`${hash} in the address breaks nothing`, said.length === 0 && /set by the system/.test(await page.locator('.theme').getAttribute('aria-label')) && await page.evaluate(() => document.querySelector('.sections .here, .sections a') !== null), said);
    await page.close();
}

// ---- The button on the poster ----

({page} = await open('00_first_scene.html', {viewport: {width: 1440, height: 900}, colorScheme: 'light'}));
const start = page.locator('.live-start').first();
await start.hover();
const contrast = await start.evaluate((one) => {
    const light = (colour) => colour.match(/[\d.]+/g).slice(0, 3).map((x) => x / 255).map((x) => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4).reduce((sum, x, i) => sum + x * [0.2126, 0.7152, 0.0722][i], 0);
    const [a, b] = [getComputedStyle(one).color, getComputedStyle(one).backgroundColor].map(light);
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
});
check('the start button is legible while the pointer is over it', contrast > 4.5, contrast);
const [picture, button] = [await page.locator('.live-screen').first().boundingBox(), await start.boundingBox()];
check('the start button is at the bottom left of the picture', button.x + button.width < picture.x + picture.width / 3 && button.y > picture.y + picture.height * 0.75, picture, button);
check('all buttons have the font of the lists of pages', await page.evaluate(() => new Set(['.live-start', '.run', '.sheet-edit', '.contents'].map((one) => getComputedStyle(document.querySelector(one)).fontFamily)).size) === 1);
await page.close();

// ---- Full screen, and the search ----

({page, said} = await open('03_shadows.html'));
await page.evaluate(() => scrollTo({top: 1500, behavior: 'instant'}));
await page.getByRole('searchbox').click();
await page.keyboard.type('shadow', {delay: 20});
await page.waitForFunction(() => document.querySelector('.found').textContent !== '');
check('typing into the search field does not scroll the page', await page.evaluate(() => scrollY) === 1500, await page.evaluate(() => scrollY));
await page.keyboard.press('Escape');
await page.evaluate(() => scrollTo({top: 0, behavior: 'instant'}));
await page.locator('.live-start').first().click();
await runs(page);
for (const name of ['Values', 'Full screen']) await page.getByRole('button', {name, exact: true}).click();
await page.waitForFunction(() => document.fullscreenElement);
await frames(page, 10);
const [shown, values] = [await page.locator('.live-canvas').boundingBox(), await page.locator('.live-controls').boundingBox()];
check('in full screen, the values are below the picture', shown.y + shown.height <= values.y + 1 && shown.height > 300, shown, values);
await page.close();

({page, said} = await open('00_first_scene.html', PHONE));
const search = async (words) => {
    await page.getByRole('searchbox').fill(words);
    await page.waitForFunction(() => document.querySelector('.found').textContent !== ''); // the texts have arrived
    return page.locator('.results a').evaluateAll((all) => all.map((one) => one.textContent));
};
let held = null;
await page.route('**/search_text.js', (route) => { held = route; }, {times: 1});
await page.getByRole('searchbox').fill('shadow');
await page.locator('.results a').first().waitFor();
check('before the texts are loaded, a search finds headings', /^03 Shadows/.test(await page.locator('.results a').first().textContent()) && await page.locator('.results mark').count() === 0);
await held.continue();
let results = await search('shadow');
check('a search for a word of a page\'s title finds that page first', /^03 Shadows/.test(results[0]), results.slice(0, 3));
const list = await page.locator('.results').boundingBox();
check('the list of results fits the width of the phone\'s screen', list.x >= 0 && list.x + list.width <= 390, list);
const cut = await page.evaluate(() => {
    const texts = [...document.querySelectorAll('.results a > small:last-child')].map((one) => one.textContent);
    const index = document.createElement('script');
    return new Promise((done) => {
        window.searchText = (all) => done(texts.filter((text) => !` ${all.join(' ')} `.includes(` ${text.replace(/^… | …$/g, '')} `)));
        index.src = 'search_text.js';
        document.head.append(index);
    });
});
check('an excerpt in the results begins and ends with a whole word', cut.length === 0, cut);
await page.reload();
results = await search('shadoow');
check('a search for a mistyped word finds the intended word', results.length > 3 && /shadow/i.test(results[0]), results.slice(0, 3));
results = await search('sdf torus');
check('a result need not contain every word of a query, and the word sdf finds signed distances', results.length > 3 && /torus/i.test(results[0]), results.slice(0, 3));
check('the console reports no error', said.length === 0, said);
await page.close();

// ---- A browser without WebGL 2 ----

({page} = await open('00_first_scene.html', {}, {before: () => {
    const own = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind === 'webgl2' ? null : own.call(this, kind, ...more); };
}}));
await page.locator('.live-start').first().click();
check('without WebGL 2, the page says what it still shows', await page.locator('.live-said').textContent() === 'This browser has no WebGL 2, so no program can run here; all text and pictures are shown.');
await page.close();

// ---- Loading ----

({page} = await open('01_normal_colouring.html', {viewport: {width: 1440, height: 900}}, {before: () => {
    window.shift = 0;
    new PerformanceObserver((list) => { for (const one of list.getEntries()) if (!one.hadRecentInput) window.shift += one.value; }).observe({type: 'layout-shift', buffered: true});
}}));
await page.evaluate(() => document.fonts.ready);
await frames(page, 30);
const shift = await page.evaluate(() => window.shift);
console.log(`# layout shift of 01: ${shift.toFixed(4)}`);
check('the layout hardly shifts while a page loads', shift < 0.02, shift);
await page.close();
// Only the first screen of a long page is laid out before the page is shown; the rest is laid out later, with timers.
const LONG = '10_distance_in_the_plane.html', there = (page) => page.waitForFunction(() => Math.abs(document.getElementById('exit-questions').getBoundingClientRect().top - 64) < 8).then(() => true, () => false);
({page} = await open(LONG, PHONE, {before: () => {
    addEventListener('DOMContentLoaded', () => { window.first = document.querySelector('main').innerText.length; });
}}));
const [first, all] = await page.evaluate(() => [window.first, document.querySelector('main').innerText.length]);
check('a long page is shown before all of it is laid out', first > 1000 && first < all / 10, first, all);
await page.close();
const never = () => { window.setTimeout = () => 0; };
({page} = await blankPage(browser, {context: {viewport: {width: 1440, height: 900}}, before: never}));
await page.goto(`${server.at}/${LONG}`);
check('without timers, the rest of a long page is not laid out', !await page.locator('#exit-questions').isVisible());
await page.locator('.sections a[href="#exit-questions"]').click();
check('a link to a part that is not laid out yet is followed', await there(page));
await page.goto(`${server.at}/index.html`);
await page.goto(`${server.at}/${LONG}#exit-questions`);
check('an address of a part that is not laid out yet is followed', await there(page));
await page.goto(`${server.at}/index.html`);
await page.goto(`${server.at}/${LONG}#:~:text=A%20star%20in%20one%20stroke`);
check('an address with a text fragment is followed into a part that is not laid out yet', await page.getByText('A star in one stroke').first().isVisible());
await page.close();
({page} = await open('01_normal_colouring.html'));
const policy = await page.evaluate(() => new Promise((told) => {
    document.addEventListener('securitypolicyviolation', (event) => told(event.violatedDirective), {once: true});
    const script = document.createElement('script');
    script.textContent = 'window.injected = true';
    document.head.append(script);
}));
check('a script that is not part of the site does not run', policy.startsWith('script-src') && await page.evaluate(() => window.injected === undefined));
await page.emulateMedia({media: 'print'});
const sizes = await page.evaluate(() => ['figcaption', 'main > p:not(.note)'].map((one) => parseFloat(getComputedStyle(document.querySelector(one)).fontSize)));
check('in print, captions are smaller than the text', sizes[0] < sizes[1] && Math.abs(sizes[1] - 14) < 0.2, sizes);
await page.emulateMedia({media: 'screen'});
const bleeding = await page.evaluate(() => [...document.querySelectorAll('main > .listing')].filter((one) => one.getBoundingClientRect().width > document.querySelector('main > p:not(.note)').getBoundingClientRect().width + 1
    && one.querySelector('code').textContent.split('\n').every((line) => line.length <= 84)).length);
check('a listing of short lines is no wider than the text', bleeding === 0, bleeding);
await page.close();

finish();
await browser.close();
server.close();
