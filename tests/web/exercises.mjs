// exercises.mjs - tests the exercises of the site's pages as a reader does them: in a phone's window, the first exercise
// of three chapters; beside the text on a wide page; and what the contents and a file say of the reader's progress.
import fs from 'node:fs';
import {blankPage, check, finish, frames, launch, serve, SITE, whole} from './browser.mjs';

const server = await serve(SITE), browser = await launch();
const PHONE = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true, deviceScaleFactor: 2};
async function open(address, context) {
    const opened = await blankPage(browser, {context});
    await opened.page.goto(`${server.at}/${address}`);
    await whole(opened.page);
    return opened;
}
const answer = async (page, name) => {
    await page.getByRole('button', {name: `Write your answer to exercise ${name}`}).click();
    await page.waitForSelector('.live-editing .cm-content');
    await page.waitForSelector('.live-drawn');
};
async function write(page, text) {
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(text);
}
const seen = (page, selector) => page.evaluate((selector) => {
    const {top, bottom} = document.querySelector(selector).getBoundingClientRect();
    return top >= 0 && bottom <= innerHeight;
}, selector);
const done = (page, name) => page.locator(`.contents a[href="${name}.html"] .done`).textContent().catch(() => '');

// ---- On a phone ----

// While the text is edited, select a ray, deselect it, and look at the picture in full screen.
async function tryRay(page) {
    const {x, y, width, height} = await page.locator('.live-canvas').boundingBox(), top = (selector) => page.evaluate((one) => document.querySelector(one).getBoundingClientRect().top, selector);
    await page.touchscreen.tap(x + width / 2, y + height / 2);
    await page.waitForSelector('.live-chosen[open]');
    await frames(page, 3);
    const steps = await page.locator('.live-ray').boundingBox(), picture = await page.locator('.live-canvas').boundingBox();
    check('the steps of a ray are below the picture and on the screen', steps.y >= picture.y + picture.height - 1 && steps.y < 600, steps, picture);
    await page.getByRole('button', {name: 'Deselect'}).tap();
    await page.waitForSelector('.live-ray:not(.live-chosen)', {state: 'attached'});
    await frames(page, 3);
    check('without the ray, the text is on the screen again', await top('.live-editor') >= 0 && await top('.live-editor') < 700, await top('.live-editor'));
    const bar = await top('.live-controls > .live-bar');
    for (const full of [true, false]) {
        await page.getByRole('button', {name: 'Full screen'}).tap();
        await page.waitForFunction((full) => Boolean(document.fullscreenElement) === full, full);
        await frames(page, 6);
    }
    check('after full screen, the page is where it was', Math.abs(await top('.live-controls > .live-bar') - bar) < 3, await top('.live-controls > .live-bar'), bar);
}

for (const stem of ['00_first_scene', '01_normal_colouring', '03_shadows']) {
    const {page, said} = await open(`${stem}.html#exercises`, PHONE), number = stem.slice(0, 2);
    await answer(page, `${number}-1`);
    const [words, below] = [await page.locator('.guide').boundingBox(), await page.locator('.live-editor').boundingBox()];
    check(`${number}: the words of the exercise are above the editor`, /^1\. \(easy\)/.test(await page.locator('.guide').innerText()) && words.y < below.y && await page.locator('.guide :is(form, button, [id])').count() === 0, words, below);
    await write(page, fs.readFileSync(`chapters/solutions/${stem}_1.frag`, 'utf8'));
    await page.evaluate(() => {
        const judge = document.querySelector('.live-judge');
        window.labels = [];
        new MutationObserver(() => window.labels.push(judge.textContent)).observe(judge, {childList: true});
    });
    await page.locator('.live-judge').tap();
    await page.waitForSelector('.live-verdict strong');
    await page.waitForFunction(() => window.labels.length > 1);
    check(`${number}: the button says that it is checking`, await page.evaluate(() => window.labels.join()) === 'Checking …,Check', await page.evaluate(() => window.labels));
    check(`${number}: the button below the text checks the answer, and the verdict is seen`, await page.locator('.live-verdict').innerText().then((verdict) => verdict.startsWith('Right: ')) && await seen(page, '.live-verdict'), await page.locator('.live-verdict').innerText());
    check(`${number}: the contents count the exercise`, /^1\/\d+, 1 of \d+ exercises solved$/.test(await done(page, stem)), await done(page, stem));
    const text = page.locator('.cm-content'), before = await text.innerText();
    await text.press('Control+End');
    await page.keyboard.insertText('// more');
    await page.getByText('This is about an earlier text:').waitFor();
    check(`${number}: a verdict on an earlier text says so`, await page.locator('.live-earlier').count() === 1);
    await page.getByRole('button', {name: 'Undo', exact: true}).tap();
    check(`${number}: a button undoes the last change`, await text.innerText() === before, (await text.innerText()).slice(-60));
    if (number === '03') await tryRay(page);
    await page.reload();
    await whole(page);
    check(`${number}: after a reload, the exercise is still solved`, await page.locator('.solved').count() === 1 && (await done(page, stem)).startsWith('1/'));
    check('the console reports no error', said.length === 0, said);
    await page.close();
}

// ---- Picture and text ----

for (const width of [1181, 1440]) {
    const {page, said} = await open('03_shadows.html#exercises', {viewport: {width, height: 800}});
    await answer(page, '03-1');
    const box = (selector) => page.locator(selector).boundingBox();
    let [picture, text, words] = await Promise.all(['.live-canvas', '.live-editor', '.guide'].map(box));
    check(`${width} pixels: picture and text are beside each other, at least 400 pixels wide, and the words are below the picture`, picture.x + picture.width < text.x && Math.min(picture.width, text.width) >= 400 && words.y >= picture.y + picture.height - 1 && text.x + text.width <= width, picture, text, words);
    await page.evaluate(() => scrollBy({top: 300, behavior: 'instant'}));
    await frames(page, 3);
    [picture, text, words] = await Promise.all(['.live-canvas', '.live-editor', '.guide'].map(box));
    check(`${width} pixels: the picture and the words stay while the text scrolls`, picture.y >= 0 && words.y >= picture.y + picture.height - 1, picture, words);
    check('the console reports no error', said.length === 0, said);
    await page.close();
}

// While the page scrolls, an error is never behind the picture that stays.
for (const context of [PHONE, {viewport: {width: 1000, height: 700}}]) {
    const {page} = await open('03_shadows.html', context), {width} = context.viewport;
    await page.locator('.live-start').first().click();
    await page.waitForSelector('.live-drawn');
    await page.getByRole('button', {name: 'Values'}).click();
    await page.getByRole('button', {name: 'Edit', exact: true}).click();
    await write(page, 'nonsense');
    await page.waitForSelector('.live-error:not([hidden])');
    const hidden = [];
    for (let i = 0; i < 12; i++) {
        await page.evaluate(() => scrollBy({top: 90, behavior: 'instant'}));
        await frames(page, 2);
        hidden.push(...await page.evaluate(() => {
            const error = document.querySelector('.live-error').getBoundingClientRect(), picture = document.querySelector('.live-canvas').getBoundingClientRect(), all = document.querySelector('.live-window').getBoundingClientRect();
            return all.bottom > picture.bottom + error.height && error.top < picture.bottom - 1 ? [[Math.round(error.top), Math.round(picture.bottom), scrollY]] : [];
        }));
    }
    check(`${width} pixels: an error is never behind the picture`, hidden.length === 0, hidden);
    await page.close();
}

// ---- Progress ----

const {page, said} = await open('03_shadows.html', {viewport: {width: 1280, height: 900}, acceptDownloads: true});
const to = async (id) => {
    await page.evaluate((id) => new Promise((still) => {
        addEventListener('scrollend', still, {once: true});
        document.getElementById(id).scrollIntoView({block: 'start', behavior: 'instant'});
    }), id);
    await frames(page, 3);
};
await to('exercises');
check('a chapter whose sections have been skipped is not read', await page.locator('.done').count() === 0);
for (const id of await page.evaluate(() => [...document.querySelectorAll('main h2[id]')].map((one) => one.id).filter((id, i, all) => i <= all.indexOf('what-to-remember')))) await to(id);
check('a chapter whose sections have been at the top of the screen is read', await done(page, '03_shadows') === '✓, read', await done(page, '03_shadows'));
await page.evaluate(() => document.dispatchEvent(new CustomEvent('solved', {detail: '03_2'})));
check('the contents show that a chapter is read and how many of its exercises are solved', await done(page, '03_shadows') === '1/4 ✓, read, 1 of 4 exercises solved', await done(page, '03_shadows'));
await page.goto(`${server.at}/pages.html`);
const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', {name: 'Save it in a file'}).click()]);
const file = JSON.parse(fs.readFileSync(await download.path(), 'utf8'));
check('a file contains what is read and solved', file.remembered.progress.read['03_shadows'] === true && file.remembered.progress.solved.join() === '03_2', file);
const {page: other} = await open('pages.html', {viewport: {width: 1280, height: 900}});
await other.evaluate(() => {
    localStorage.progress = JSON.stringify({read: {'03_shadows': ['exercises'], '02_lighting': true}, solved: ['03_1']});
    localStorage[`ray marching: changes in ${new URL('.', location.href).pathname}`] = JSON.stringify({'chapters/exercises/03_1/my.frag': 'mine'});
});
const theirs = {course: file.course, remembered: {...file.remembered, 'ray marching: changes': {'chapters/exercises/03_1/my.frag': 'theirs', 'chapters/exercises/03_2/my.frag': 'theirs'}, 'theme': {dark: true}}};
await other.locator('#file').setInputFiles({name: 'progress.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(theirs))});
await other.getByText('progress.json has been read.').waitFor();
check('a file that is read adds to what the browser has', await done(other, '03_shadows') === '2/4 ✓, read, 2 of 4 exercises solved' && await done(other, '02_lighting') === '✓, read', await done(other, '03_shadows'));
check('a file that is read replaces none of the reader\'s texts', await other.evaluate(() => { const {'chapters/exercises/03_1/my.frag': one, 'chapters/exercises/03_2/my.frag': two} = JSON.parse(localStorage[`ray marching: changes in ${new URL('.', location.href).pathname}`]); return `${one} ${two} ${localStorage.theme}`; }) === 'mine theirs undefined');
await other.locator('#file').setInputFiles({name: 'notes.txt', mimeType: 'text/plain', buffer: Buffer.from('{')});
check('another file is refused', await other.getByText('notes.txt is not a file that this page has saved.').waitFor().then(() => true, () => false));
check('the console reports no error', said.length === 0, said);
finish();
await browser.close();
server.close();
