// play.mjs - the page Play: a text for Shadertoy is dropped, drawn, edited and exported, and the export is dropped
// again; the course's own file; a file that is not a shader.
import fs from 'node:fs';
import {blankPage, check, finish, frames, launch, PATIENCE, serve, SITE} from './browser.mjs';

const server = await serve(SITE), browser = await launch();
const {page, said} = await blankPage(browser, {context: {viewport: {width: 1280, height: 900}, acceptDownloads: true}});
await page.goto(`${server.at}/play.html`);
await page.waitForSelector('live-chapter .live-start');

const drop = (name, text) => page.evaluate(([name, text]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    for (const type of ['dragover', 'drop']) document.querySelector('.drop').dispatchEvent(new DragEvent(type, {bubbles: true, cancelable: true, dataTransfer}));
}, [name, text]);
const state = () => page.evaluate(() => document.querySelector('live-chapter').program?.state() ?? null);
async function until(right) {
    for (const begun = Date.now(); ;) {
        const now = await state();
        if (now && right(now) || Date.now() - begun > PATIENCE) return now;
        await frames(page, 2);
    }
}
// The displayed colour in the middle of the canvas.
async function middle() {
    const shot = await page.locator('.live-canvas').screenshot();
    return page.evaluate(async (bytes) => {
        const picture = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
        const canvas = new OffscreenCanvas(picture.width, picture.height), context = canvas.getContext('2d');
        context.drawImage(picture, 0, 0);
        return [...context.getImageData(picture.width >> 1, picture.height >> 1, 1, 1).data].slice(0, 3);
    }, [...shot]);
}
const near = (colour, right) => colour.every((c, i) => Math.abs(c - right[i]) <= 2);
async function exported() {
    const [download] = await Promise.all([page.waitForEvent('download'), page.locator('button.export').click()]);
    return {name: download.suggestedFilename(), text: fs.readFileSync(await download.path(), 'utf8')};
}

check('nothing can be exported before a file is opened', await page.locator('button.export').isDisabled());
await drop('Green sky (1).glsl', '// iTime\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(0.2, p.x > 0.0 ? 0.8 : 0.0, 0.4, 1.0); }\n');
let now = await until((s) => s.rate > 0);
await page.waitForSelector('.cm-content');
check('a dropped file for Shadertoy runs', now?.runs && now.error === '' && now.files[0].endsWith('/chapters/Green_sky_1.frag'), now?.error, now?.files);
check('the page says so', await page.locator('.said').textContent() === 'Green_sky_1.frag runs.');
check('its colour is shown', near(await middle(), [51, 204, 102]), await middle());
check('it is in the editor', (await page.locator('.cm-content').innerText()).includes('mainImage'));
await page.waitForSelector('button.export:not(:disabled)');
const toy = await exported();
check('it is exported as a file for Shadertoy', toy.name === 'shadertoy.glsl' && toy.text.includes('void mainImage') && !toy.text.includes('#include'), toy.text.slice(0, 300));
await page.waitForFunction(() => /is written/.test(document.querySelector('.said').textContent));
check('while the program in the page continues', (await state())?.runs === true);
await drop('again.txt', toy.text);
now = await until((s) => s.files?.[0]?.endsWith('/again.frag') && s.rate > 0);
check('what was exported runs again', now?.runs && now.error === '' && near(await middle(), [51, 204, 102]), now?.error);
await drop('lit.frag', fs.readFileSync('chapters/02_lighting.frag', 'utf8'));
now = await until((s) => s.files?.[0]?.endsWith('/lit.frag') && s.rate > 0);
check('a file of the course runs, with its values', now.runs && now.parameters.length > 3, now.error);
const own = await exported();
check('and is exported with what it includes', own.text.includes('void mainImage') && own.text.includes('sceneDistance') && !/^#include/m.test(own.text));
await drop('unset.glsl', 'uniform float speed;\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(speed, 0.8, 0.4, 1.0); }\n');
now = await until((s) => s.files?.[0]?.endsWith('/unset.frag') && s.rate > 0);
await page.waitForFunction(() => /uniform float speed is 0: nothing sets it/.test(document.querySelector('live-chapter').innerText));
check('a value that nothing sets is reported', now.unset.startsWith('uniform float speed is 0'), now.unset);
await drop('wrong.glsl', 'void mainImage(out vec4 c, in vec2 p) { c = nonsense; }\n');
await page.waitForFunction(() => /cannot be drawn/.test(document.querySelector('.said').textContent));
check('a mistake is reported with its line', /chapters\/wrong\.frag:1: /.test(await page.locator('live-chapter').innerText()), await page.locator('live-chapter').innerText());
check('and cannot be exported', await page.locator('button.export').isDisabled());
await drop('picture.frag', 'a\0b');
await page.waitForFunction(() => /not a text file/.test(document.querySelector('.said').textContent));
check('a file that is not text is refused', true);

// ---- A studio ----

const text = () => page.evaluate(() => document.querySelector('.live-on').stage.changes.editor.text());
const drafts = () => page.locator('.draft').allTextContents();
const flat = (colour) => `void mainImage(out vec4 c, in vec2 p) { c = vec4(${colour}, 1.0); }\n`;
await drop('mine.frag', flat('0.0, 0.0, 1.0'));
now = await until((s) => s.files?.[0]?.endsWith('/mine.frag') && s.rate > 0);
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// older\n');
await page.waitForSelector('.live-changes:not([hidden])');
await drop('mine.frag', flat('1.0, 0.0, 0.0'));
await page.waitForFunction((newer) => document.querySelector('.live-on')?.stage.changes.editor.text() === newer, flat('1.0, 0.0, 0.0'));
check('a file of the same name replaces the text in the editor', await text() === flat('1.0, 0.0, 0.0') && await page.locator('.live-changes').isHidden());
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// newer\n');
await page.waitForSelector('.live-changes:not([hidden])');
await page.getByRole('button', {name: 'Reset this file'}).click();
await page.waitForSelector('.live-changes', {state: 'hidden'});
check('and is the text to which Reset returns', await text() === flat('1.0, 0.0, 0.0'));
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// kept\n');
await page.waitForSelector('.live-changes:not([hidden])');
await page.waitForFunction(() => document.querySelector('.draft[aria-current=true] img')?.src.startsWith('data:image/jpeg'));
await page.waitForFunction(() => JSON.stringify({...localStorage}).split('// kept').length > 2); // as a change, and as drawn
check('a draft has its name and its picture', (await drafts()).includes('mine') && await page.locator('.draft').count() >= 4, await drafts());
await page.reload();
await page.getByRole('button', {name: 'mine', exact: true}).click();
now = await until((s) => s.files?.[0]?.endsWith('/mine.frag') && s.rate > 0);
await page.waitForSelector('.cm-content');
check('a reload keeps it, with its changes', (await text()).includes('// kept'), await text());
await page.getByRole('button', {name: 'Remix'}).click();
await until((s) => s.files?.[0]?.endsWith('/mine_2.frag') && s.rate > 0);
check('a copy has the text under another name', (await drafts()).includes('mine 2') && (await text()).includes('// kept'), await drafts());
await page.waitForFunction(() => !document.querySelector('.studio .title').disabled);
await page.getByLabel('Name').fill('red sky');
await page.getByLabel('Name').press('Enter');
await until((s) => s.files?.[0]?.endsWith('/red_sky.frag') && s.rate > 0);
await page.waitForFunction(() => ![...document.querySelectorAll('.draft')].some((one) => one.textContent === 'mine 2'));
check('the name can be changed', (await drafts()).includes('red sky') && !(await drafts()).includes('mine 2'), await drafts());
await page.getByRole('button', {name: 'Delete red_sky'}).click();
await page.waitForFunction(() => ![...document.querySelectorAll('.draft')].some((one) => one.textContent === 'red sky'));
check('and the draft deleted', await page.evaluate(() => !JSON.stringify({...localStorage}).includes('red_sky')));
check('there are ten sheets to begin with', await page.locator('.starter[data-file]').count() === 10);
await page.getByRole('button', {name: 'Blank sheet'}).click();
now = await until((s) => s.files?.[0]?.endsWith('/blank.frag') && s.rate > 0);
check('and a blank one', now?.error === '' && near(await middle(), [128, 128, 128]), await middle());
await page.waitForFunction(() => document.querySelector('.draft[aria-current=true] img'));
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
// The page is left at the moment when the text has been stored and the program has not read it yet.
await page.evaluate(() => {
    const store = Storage.prototype.setItem;
    Storage.prototype.setItem = function (name, value) {
        store.call(this, name, value);
        if (!value.includes('nonsense')) return;
        Storage.prototype.setItem = store;
        dispatchEvent(new Event('pagehide'));
    };
});
await page.keyboard.type('nonsense ');
await page.waitForSelector('.live-error:not([hidden])');
await page.reload();
await page.getByRole('button', {name: 'blank', exact: true}).click();
check('a draft whose last text was not drawn does not run by itself', await page.getByRole('button', {name: 'Run it'}).isVisible() && await page.locator('.live-window').count() === 0);
await page.getByRole('button', {name: 'Go back to the previous text'}).click();
now = await until((s) => s.files?.[0]?.endsWith('/blank.frag') && s.rate > 0);
check('and is undone before it runs', now?.error === '' && now.runs);
await page.waitForSelector('.cm-content');
await page.locator('.starter', {hasText: 'Shadows'}).click();
now = await until((s) => s.files?.[0]?.endsWith('/shadows.frag') && s.rate > 0);
check('one of the sheets is a chapter, with its camera', now.runs && now.error === '' && now.title.startsWith('03'), now.title, now.error);
check('no error in the console', said.length === 0, said);
finish();
await browser.close();
server.close();
