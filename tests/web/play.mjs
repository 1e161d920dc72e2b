// play.mjs - tests the Play page: a Shadertoy shader is dropped, drawn and exported, and the export is dropped again; a
// file of the course, and a file that is not a shader, are dropped; drafts are edited, stored, copied and deleted.
import fs from 'node:fs';
import {shaders} from '../../docs/web/dropped.js';
import {blankPage, check, finish, frames, launch, PATIENCE, serve, SITE} from './browser.mjs';

const server = await serve(SITE), browser = await launch();
const {page, said} = await blankPage(browser, {context: {viewport: {width: 1280, height: 900}, acceptDownloads: true}});
await page.goto(`${server.at}/play.html`);
await page.waitForSelector('.starter');

const drop = (...namesAndTexts) => page.evaluate((list) => {
    const dataTransfer = new DataTransfer();
    for (let i = 0; i < list.length; i += 2) dataTransfer.items.add(new File([list[i + 1]], list[i]));
    for (const type of ['dragover', 'drop']) document.querySelector('.drop').dispatchEvent(new DragEvent(type, {bubbles: true, cancelable: true, dataTransfer}));
}, namesAndTexts);
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

check('before a file is opened, the page shows ways to begin, and no picture of another shader', await page.locator('button.export').isHidden() && await page.locator('live-chapter').isHidden());
await drop('Green sky (1).glsl', '// iTime\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(0.2, p.x > 0.0 ? 0.8 : 0.0, 0.4, 1.0); }\n');
let now = await until((s) => s.rate > 0);
await page.waitForSelector('.cm-content');
check('a dropped Shadertoy shader runs', now?.runs && now.error === '' && now.files[0].endsWith('/chapters/Green_sky_1.frag'), now?.error, now?.files);
check('the page says that the dropped file runs', await page.locator('.said').textContent() === 'Green_sky_1.frag runs.');
check('the dropped shader\'s colour is shown', near(await middle(), [51, 204, 102]), await middle());
check('the dropped shader is in the editor', (await page.locator('.cm-content').innerText()).includes('mainImage'));
await page.waitForSelector('button.export:not(:disabled)');
const toy = await exported();
check('the dropped shader is exported as a file for Shadertoy', toy.name === 'shadertoy.glsl' && toy.text.includes('void mainImage') && !toy.text.includes('#include'), toy.text.slice(0, 300));
await page.waitForFunction(() => /is written/.test(document.querySelector('.said').textContent));
check('the program in the page continues after an export', (await state())?.runs === true);
await drop('again.txt', toy.text);
now = await until((s) => s.files?.[0]?.endsWith('/again.frag') && s.rate > 0);
check('the exported file runs when it is dropped', now?.runs && now.error === '' && near(await middle(), [51, 204, 102]), now?.error);
await drop('lit.frag', fs.readFileSync('chapters/02_lighting.frag', 'utf8'));
now = await until((s) => s.files?.[0]?.endsWith('/lit.frag') && s.rate > 0);
check('a file of the course runs, with its parameters', now.runs && now.parameters.length > 3, now.error);
const own = await exported();
check('a file of the course is exported with the files that it includes', own.text.includes('void mainImage') && own.text.includes('sceneDistance') && !/^#include/m.test(own.text));
await drop('unset.glsl', 'uniform float speed;\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(speed, 0.8, 0.4, 1.0); }\n');
now = await until((s) => s.files?.[0]?.endsWith('/unset.frag') && s.rate > 0);
await page.waitForFunction(() => /uniform float speed is 0: nothing sets it/.test(document.querySelector('live-chapter').innerText));
check('a uniform that nothing sets is reported', now.unset.startsWith('uniform float speed is 0'), now.unset);
await drop('wrong.glsl', 'void mainImage(out vec4 c, in vec2 p) { c = nonsense; }\n');
await page.waitForFunction(() => /cannot be drawn/.test(document.querySelector('.said').textContent));
check('a compilation error is reported with its line number', /chapters\/wrong\.frag:1: /.test(await page.locator('live-chapter').innerText()), await page.locator('live-chapter').innerText());
check('a file that does not compile cannot be exported', await page.locator('button.export').isDisabled());
await page.locator('.live-result').getByRole('button', {name: 'Close'}).press('Enter');
check('when the error is closed with the keyboard, the focus goes to a button that starts the program', await page.evaluate(() => document.activeElement.matches('.live-start') && document.activeElement.checkVisibility()));
await drop('picture.frag', 'a\0b');
await page.waitForFunction(() => /not a text file/.test(document.querySelector('.said').textContent));
check('a file that is not text is refused', true);

// Several files: the parts that a shader includes become part of its draft, each once.
const texts = {
    '/deck/cards/one.frag': '#include "../lib/fill.glsl"\n# include "../lib/more.glsl" // again\nvoid main() {}\n', '/deck/cards/two.frag': '#include "none.glsl"\nvoid mainImage() {}\n',
    '/deck/lib/fill.glsl': 'float fill();\n', '/deck/lib/more.glsl': '#include "fill.glsl"\nfloat more();\n', '/deck/readme.md': '# a deck\n',
};
const dealt = shaders(texts);
check('the shaders of a folder are those that no file includes', dealt.map(({path}) => path).join(' ') === '/deck/cards/one.frag /deck/cards/two.frag', dealt);
check('a shader gets its parts, each once', dealt[0].text === '// #include "../lib/fill.glsl"\nfloat fill();\n\n// # include "../lib/more.glsl" // again\n// #include "fill.glsl"\nfloat more();\n\nvoid main() {}\n', dealt[0].text);
check('an include of a file that is missing stays', dealt[1].text === texts['/deck/cards/two.frag']);
check('a single file is taken whatever it contains', shaders({'/a.txt': 'float x;\n'})[0].text === 'float x;\n');
await drop('card.frag', '#include "../lib/fill.glsl"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(fill(), 0.8, 0.4, 1.0); }\n', 'fill.glsl', 'float fill() { return 0.2; }\n',
    'other.frag', 'void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n', 'photo.jpg', 'a\0b');
now = await until((s) => s.files?.[0]?.endsWith('/card.frag') && s.rate > 0);
check('a shader that is dropped with a part of its own is drawn', now?.error === '' && near(await middle(), [51, 204, 102]), now?.error, await middle());
await page.waitForFunction(() => /1 more shader is a draft/.test(document.querySelector('.said').textContent));
check('another shader that is dropped with it is a draft', (await page.locator('.draft').allTextContents()).includes('other'));
await drop('alone.frag', '#include "../lib/fill.glsl"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(fill()); }\n');
await page.waitForFunction(() => /cannot be drawn/.test(document.querySelector('.said').textContent));
check('a shader that is dropped without its part is refused, with what to do', /alone\.frag:1: #include "\.\.\/lib\/fill\.glsl": .*drop the folder that has it/.test(await page.locator('live-chapter').innerText()), await page.locator('live-chapter').innerText());

// ---- The studio ----

const text = () => page.evaluate(() => document.querySelector('.live-on').stage.changes.editor.text());
const drafts = () => page.locator('.draft').allTextContents();
const stored = () => page.evaluate(() => JSON.parse(localStorage[Object.keys(localStorage).find((key) => key.startsWith('ray marching: changes'))] ?? '{}')); // the changed texts of all files
const flat = (colour) => `void mainImage(out vec4 c, in vec2 p) { c = vec4(${colour}, 1.0); }\n`;
await drop('mine.frag', flat('0.0, 0.0, 1.0'));
now = await until((s) => s.files?.[0]?.endsWith('/mine.frag') && s.rate > 0);
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// older\n');
await page.waitForSelector('.live-changes:not([hidden])');
await drop('mine.frag', flat('1.0, 0.0, 0.0'));
await page.waitForFunction((newer) => document.querySelector('.live-on')?.stage.changes.editor.text() === newer, flat('1.0, 0.0, 0.0'));
await page.waitForFunction(() => document.querySelector('.said').textContent === 'mine_2.frag runs. The draft mine is still there.');
check('a dropped file with the name of a draft becomes another draft', (await drafts()).includes('mine') && (await drafts()).includes('mine 2') && await page.locator('.live-changes').isHidden(), await drafts());
check('the draft with that name keeps its text', (await stored())['chapters/mine.frag'] === `// older\n${flat('0.0, 0.0, 1.0')}`, await stored());
await drop('first.frag', flat('0.0, 1.0, 1.0'), 'mine.frag', flat('1.0, 1.0, 0.0'));
await page.waitForFunction(() => /1 more shader is a draft/.test(document.querySelector('.said').textContent));
check('a file that is dropped beside another one overwrites no draft, and is kept', (await drafts()).includes('mine 3'), await drafts());
await drop('mine.frag', flat('1.0, 0.0, 0.0'));
await page.waitForFunction((newer) => document.querySelector('.live-on')?.stage.changes.editor.text() === newer, flat('1.0, 0.0, 0.0'));
const many = await page.locator('.draft').count();
await drop('mine.frag', flat('1.0, 0.0, 0.0'));
await frames(page, 30);
check('a file that is dropped again is the same draft', await page.locator('.draft').count() === many && await text() === flat('1.0, 0.0, 0.0'), await drafts());
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// newer\n');
await page.waitForSelector('.live-changes:not([hidden])');
await page.getByRole('button', {name: 'Reset this file'}).click();
await page.waitForSelector('.live-changes', {state: 'hidden'});
check('Reset this file restores the text that was dropped last', await text() === flat('1.0, 0.0, 0.0'));
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// kept\n');
await page.waitForSelector('.live-changes:not([hidden])');
await page.waitForFunction(() => document.querySelector('.draft[aria-current=true] img')?.src.startsWith('data:image/jpeg'));
await page.waitForFunction(() => JSON.stringify({...localStorage}).split('// kept').length > 2); // stored both as a change and as the last text that was drawn
// While a file that does not compile is tried, the program has the original texts (`lay`). The editor keeps the reader's.
const during = await page.evaluate(async () => {
    const {changes} = document.querySelector('.live-on').stage, {editor} = changes;
    await changes.lay(true);
    editor.renew(editor.name);
    const shown = editor.text();
    await changes.lay(false);
    return shown;
});
check('while the program has the original texts, the editor has the reader\'s', during.includes('// kept'), during);
check('a draft has a name and a picture', (await drafts()).includes('mine') && await page.locator('.draft').count() >= 4, await drafts());
const thumb = await page.evaluate(async () => {
    const picture = await createImageBitmap(await new Promise((done) => { const img = document.querySelector('.draft[aria-current=true] img'), canvas = Object.assign(document.createElement('canvas'), {width: 320, height: 180}); canvas.getContext('2d').drawImage(img, 0, 0); canvas.toBlob(done); }));
    const context = new OffscreenCanvas(320, 180).getContext('2d');
    context.drawImage(picture, 0, 0);
    return [...context.getImageData(160, 90, 1, 1).data].slice(0, 3);
});
check('the picture of a draft that does not move shows what it draws', thumb[0] > 245 && thumb[1] < 10 && thumb[2] < 10, thumb);
await page.reload();
now = await until((s) => s.files?.[0]?.endsWith('/mine_2.frag') && s.rate > 0);
await page.waitForSelector('.cm-content');
check('after a reload, the draft that was open runs, with its changes', now?.runs && (await text()).includes('// kept'), await text());
await page.getByRole('button', {name: 'Remix'}).click();
await until((s) => s.files?.[0]?.endsWith('/mine_2_2.frag') && s.rate > 0);
check('Remix copies the text under another name', (await drafts()).includes('mine 2 2') && (await text()).includes('// kept'), await drafts());
await page.waitForFunction(() => !document.querySelector('.studio .title').disabled);
await page.getByLabel('Name').fill('red sky');
await page.getByLabel('Name').press('Enter');
await until((s) => s.files?.[0]?.endsWith('/red_sky.frag') && s.rate > 0);
await page.waitForFunction(() => ![...document.querySelectorAll('.draft')].some((one) => one.textContent === 'mine 2 2'));
check('the name of a draft can be changed', (await drafts()).includes('red sky') && !(await drafts()).includes('mine 2 2'), await drafts());

// ---- Delete and Undo ----

const red = page.getByRole('button', {name: 'red sky', exact: true}), drop_red = page.getByRole('button', {name: 'Delete red_sky'}), undo_red = page.getByRole('button', {name: 'Undo: restore red_sky'});
const focus = () => page.evaluate(() => document.activeElement.ariaLabel);
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// just now\n');
const last = await text();
await drop_red.click(); // before the text is stored
await undo_red.waitFor();
check('a deleted draft is closed, and Undo has the focus', await red.isDisabled() && await page.locator('.live-window').count() === 0 && await focus() === 'Undo: restore red_sky', await focus());
check('the page says that the draft is deleted', await page.locator('.said[role=status]').textContent() === 'red_sky is deleted. Undo restores it.');
await page.keyboard.press('Enter');
check('Undo restores the draft, and the focus stays', await red.isEnabled() && await focus() === 'Delete red_sky', await focus());
await red.click();
const asked = page.getByRole('button', {name: 'Run it'});
await page.locator('.cm-content').or(asked).first().waitFor();
if (await asked.isVisible()) await asked.click(); // the text was stored, but the draft was deleted before it was drawn
await until((s) => s.files?.[0]?.endsWith('/red_sky.frag') && s.rate > 0);
await page.waitForSelector('.cm-content');
check('a restored draft has its text', await text() === last && last.startsWith('// just now'), await text());
await page.keyboard.press('Escape');
await drop_red.focus();
await page.keyboard.press('Space');
await undo_red.waitFor();
await page.reload();
check('after a reload, a deleted draft can still be restored', await red.isDisabled() && await undo_red.isVisible());
await page.getByRole('button', {name: 'Delete again'}).click();
await undo_red.waitFor({state: 'detached'});
check('a draft that is deleted in a later visit removes it for good', await page.evaluate(() => !JSON.stringify({...localStorage}).includes('red_sky')));
await page.getByRole('button', {name: 'Undo: restore again'}).click();
check('the one that was deleted last can be restored', await page.getByRole('button', {name: 'again', exact: true}).isEnabled());
await drop('03_shadows.glsl', flat('0.0, 1.0, 0.0'));
await until((s) => s.files?.[0]?.endsWith('/my_03_shadows.frag') && s.rate > 0);
check('a dropped file with the name of a chapter does not become the chapter\'s shader', (await drafts()).includes('my 03 shadows'), await drafts());
// A name is typed while the next draft is opened.
await page.waitForFunction(() => !document.querySelector('.studio .title').disabled);
await page.evaluate(() => {
    document.querySelector('.draft').click();
    document.querySelector('.title').focus();
});
await page.waitForFunction(() => document.querySelector('.live-on .live-editor:not([hidden])') && !document.querySelector('live-chapter[aria-busy]'));
await frames(page, 30);
check('opening a draft does not take the focus from its name, which the reader types', await page.evaluate(() => document.activeElement.matches('.title')), await page.evaluate(() => document.activeElement.className));
// The text is replaced while the mouse selects the end of a longer one.
await page.locator('.cm-content').click();
await page.keyboard.press('Control+End');
const line = await page.locator('.cm-line').last().boundingBox();
await page.mouse.move(line.x + 3, line.y + 3);
await page.mouse.down();
await page.mouse.move(line.x + 30, line.y + 3, {steps: 3});
await page.evaluate(() => {
    const {changes} = document.querySelector('.live-on').stage, {editor} = changes;
    editor.read = () => '1';
    editor.renew(editor.name);
    editor.read = (name) => changes.text(name);
});
await page.mouse.move(line.x + 60, line.y + 30, {steps: 3});
await page.mouse.up();
check('a text that is replaced while the mouse selects is not selected beyond its end', said.length === 0, said);

// ---- What a draft keeps, and a second tab ----

await page.locator('.starter', {hasText: 'Ball'}).click();
await until((s) => s.files?.[0]?.endsWith('/ball.frag') && s.rate > 0);
await page.waitForFunction(() => !document.querySelector('.studio .title').disabled);
check('the files that a shader names come first in the editor', await page.evaluate(() => [...document.querySelectorAll('[role=tab]')].slice(0, 6).map((tab) => tab.textContent).join(' ')) === 'ball.frag main.glsl camera.glsl march.glsl normal.glsl primitives.glsl', await page.evaluate(() => [...document.querySelectorAll('[role=tab]')].map((tab) => tab.textContent).join(' ')));
await page.evaluate(() => {
    const {stage} = document.querySelector('live-chapter');
    stage.call('live_set', 'radius', 0, 1.5);
});
const ball = await page.locator('.live-canvas').boundingBox();
await page.mouse.move(ball.x + 200, ball.y + 100);
await page.mouse.down();
await page.mouse.move(ball.x + 260, ball.y + 120, {steps: 3});
await page.mouse.up();
const turned = (await state()).camera.join(), keeps = (s) => s.camera?.join() === turned && s.parameters.find(({name}) => name === 'radius')?.value[0] === 1.5;
await page.getByRole('button', {name: 'ball', exact: true}).click();
await frames(page, 30);
check('a click on the draft that is open changes nothing', keeps(await state()), turned, (await state()).camera);
await page.getByLabel('Name').fill('round');
await page.getByLabel('Name').press('Enter');
now = await until((s) => s.files?.[0]?.endsWith('/round.frag') && s.rate > 0);
check('a draft that gets another name keeps its values and its camera', keeps(now), turned, now.camera);
await drop('between.frag', flat('0.0, 0.5, 0.0'));
await until((s) => s.files?.[0]?.endsWith('/between.frag') && s.rate > 0);
await page.getByRole('button', {name: 'round', exact: true}).click();
now = await until((s) => s.files?.[0]?.endsWith('/round.frag') && s.rate > 0);
check('a draft that is opened again has the values and the camera that it had', keeps(now), turned, now.camera);
const [second] = await Promise.all([page.context().waitForEvent('page'), page.evaluate(() => { window.open(location.href, '', 'noopener'); })]);
await second.getByRole('button', {name: 'round', exact: true}).click();
await second.waitForFunction(() => /^round\.frag runs/.test(document.querySelector('.said').textContent) && document.querySelector('.live-drawn'));
await page.bringToFront();
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('// of the first tab\n');
await page.waitForFunction(() => JSON.stringify({...localStorage}).split('// of the first tab').length > 2); // stored both as a change and as the last text that was drawn
await second.reload();
await second.waitForFunction(() => document.querySelector('.live-drawn') || document.querySelector('.said').textContent);
check('a draft that another tab has changed and drawn runs after a reload', await second.getByRole('button', {name: 'Run it'}).count() === 0, await second.locator('.said').textContent());
await second.close();

// ---- A link, and a browser that stores nothing ----

const packed = (stem, name, options, text) => page.evaluate(async ([stem, name, options, text]) => (await import('./edits.js')).pack(stem, `--shader chapters/${name}.frag${options}`, {[`chapters/${name}.frag`]: text}), [stem, name, options, text]);
const link = await packed('01_normal_colouring', 'mine', '', flat('1.0, 1.0, 0.0'));
const mine = (await stored())['chapters/mine.frag'];
await page.goto('about:blank');
await page.goto(`${server.at}/play.html${link}`);
const press = page.getByRole('button', {name: 'Run the shader in this link'});
await press.waitFor();
check('a link shows a button on the first screen, and runs nothing before it is pressed', await press.evaluate((one) => one.getBoundingClientRect().bottom < innerHeight) && await page.locator('canvas').count() === 0);
await press.click();
await page.waitForFunction(() => /^mine_\d\.frag runs/.test(document.querySelector('.said').textContent));
check('a link whose file has the name of a draft becomes another draft', mine.startsWith('// older') && (await stored())['chapters/mine.frag'] === mine && await text() === flat('1.0, 1.0, 0.0'), await stored());
// A link carries the values, the camera and the view, and the chapter whose program runs the shader.
await page.goto('about:blank');
await page.goto(`${server.at}/play.html`);
await page.locator('.starter', {hasText: 'Shadows'}).click();
await until((s) => s.files?.[0]?.endsWith('/shadows.frag') && s.rate > 0);
await page.waitForSelector('.cm-content');
await page.evaluate(() => {
    const {stage} = document.querySelector('live-chapter');
    stage.call('live_set', 'lampHeight', 0, 2.5);
    stage.call('live_view', 3);
    stage.call('live_pause', 1);
    stage.call('live_time', 4.25);
});
const sent = await state();
await page.getByRole('button', {name: 'Copy a link'}).click();
await page.waitForFunction(() => location.hash.startsWith('#edit='));
const other = await blankPage(browser, {context: {viewport: {width: 390, height: 844}}});
await other.page.goto(page.url());
const pressed = Date.now();
await other.page.getByRole('button', {name: 'Run the shader in this link'}).click();
await other.page.waitForFunction(() => document.querySelector('.live-drawn')?.program.state().rate >= 0 && document.querySelector('.cm-content'));
const got = await other.page.evaluate(() => document.querySelector('.live-on').program.state());
const latest = 4.25 + (Date.now() - pressed) / 1000; // the picture moves on after the press
check('a link carries the sender\'s values, camera, view and time, also if the text was not changed', got.title.startsWith('03') && got.view === sent.view && got.view !== 'picture' && got.time >= 4.25 && got.time <= latest && got.parameters.find(({name}) => name === 'lampHeight').value[0] === 2.5 && String(got.camera) === String(sent.camera), got.title, got.view, got.time, got.camera);
check('on a phone, the picture of a link is on the first screen', await other.page.evaluate(() => { const {top, bottom} = document.querySelector('.live-canvas').getBoundingClientRect(); return top >= 0 && bottom < innerHeight; }));
check('the console reports no error', other.said.length === 0, other.said);
await other.page.close();

// The steps of the first ball are beside its text.
await page.goto('about:blank');
await page.goto(`${server.at}/play.html#new=ball`);
await page.waitForSelector('.guide');
await page.waitForSelector('.cm-content');
const boxes = async () => [await page.locator('.live-canvas').boundingBox(), await page.locator('.guide').boundingBox(), await page.locator('.live-editor').boundingBox()];
let [shown, beside, written] = await boxes();
check('the four steps of the first ball are below its picture and beside its text', await page.locator('.guide li:visible').count() === 4 && beside.y >= shown.y + shown.height && written.x > beside.x + beside.width, shown, beside, written);
await page.setViewportSize({width: 390, height: 844});
await frames(page, 5);
[shown, beside, written] = await boxes();
check('on a phone, the steps are between the picture and the text', beside.y >= shown.y && written.y > beside.y + beside.height - 1, shown, beside, written);
await page.setViewportSize({width: 1280, height: 900});
const deaf = await blankPage(browser, {context: {acceptDownloads: true}, before: () => { Storage.prototype.setItem = () => { throw new Error('full'); }; }});
await deaf.page.goto(`${server.at}/play.html`);
await deaf.page.getByRole('button', {name: 'Blank sheet'}).click();
await deaf.page.locator('.cm-content').click();
await deaf.page.keyboard.press('Control+Home');
await deaf.page.keyboard.type('// unstored\n');
const [download] = await Promise.all([deaf.page.waitForEvent('download'), deaf.page.locator('button.save').click()]);
check('if the browser stores nothing, the changed text can still be downloaded', fs.readFileSync(await download.path(), 'utf8').startsWith('// unstored') && deaf.said.length === 0, deaf.said);
await deaf.page.close();
await page.goto(`${server.at}/play.html`);
check('there are ten templates to start from', await page.locator('.starter[data-file]').count() === 10);
await page.getByRole('button', {name: 'Blank sheet'}).click();
now = await until((s) => s.files?.[0]?.endsWith('/blank.frag') && s.rate > 0);
check('Blank sheet starts a picture that is grey in the middle', now?.error === '' && near(await middle(), [128, 128, 128]), await middle());
await page.waitForFunction(() => document.querySelector('.draft[aria-current=true] img'));
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
// The test imitates a reader who leaves the page when the text has been stored but the program has not read it yet.
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
await page.getByRole('button', {name: 'Run it'}).waitFor();
check('a draft whose last text was not drawn does not run automatically', await page.getByRole('button', {name: 'Run it'}).isVisible() && await page.locator('.live-window').count() === 0);
await page.getByRole('button', {name: 'Go back to the previous text'}).click();
now = await until((s) => s.files?.[0]?.endsWith('/blank.frag') && s.rate > 0);
check('a draft whose last text was not drawn runs with the previous text', now?.error === '' && now.runs);
await page.waitForSelector('.cm-content');
await page.locator('.starter', {hasText: 'Shadows'}).click();
now = await until((s) => s.files?.[0]?.endsWith('/shadows_2.frag') && s.rate > 0);
check('one of the templates is the chapter Shadows', now.runs && now.error === '' && now.title.startsWith('03'), now.title, now.error);
check('the console reports no error', said.length === 0, said);
finish();
await browser.close();
server.close();
