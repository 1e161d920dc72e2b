// web_play.mjs - the page Play: a text for Shadertoy dropped and drawn, edited, exported, and the export dropped again;
// the course's own file; what is no shader.
import fs from 'node:fs';
import {blankPage, check, finish, frames, launch, PATIENCE, serve, SITE} from './web_browser.mjs';

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
// The colour in the middle of the canvas, as it is shown.
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

check('before a file comes nothing can be exported', await page.locator('button.export').isDisabled());
await drop('Green sky (1).glsl', '// iTime\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(0.2, p.x > 0.0 ? 0.8 : 0.0, 0.4, 1.0); }\n');
let now = await until((s) => s.rate > 0);
await page.waitForSelector('.cm-content');
check('a dropped file for Shadertoy runs', now?.runs && now.error === '' && now.files[0].endsWith('/chapters/Green_sky_1_.frag'), now?.error, now?.files);
check('the page says so', await page.locator('.said').textContent() === 'Green sky (1).glsl runs.');
check('its colour is shown', near(await middle(), [51, 204, 102]), await middle());
check('it stands in the editor', (await page.locator('.cm-content').innerText()).includes('mainImage'));
await page.waitForSelector('button.export:not(:disabled)');
const toy = await exported();
check('it is exported as a file for Shadertoy', toy.name === 'shadertoy.glsl' && toy.text.includes('void mainImage') && !toy.text.includes('#include'), toy.text.slice(0, 300));
await page.waitForFunction(() => /is written/.test(document.querySelector('.said').textContent));
check('while the program in the page goes on', (await state())?.runs === true);
await drop('again.txt', toy.text);
now = await until((s) => s.files?.[0]?.endsWith('/again.frag') && s.rate > 0);
check('what was exported runs again', now?.runs && now.error === '' && near(await middle(), [51, 204, 102]), now?.error);
await drop('lit.frag', fs.readFileSync('chapters/02_lighting.frag', 'utf8'));
now = await until((s) => s.files?.[0]?.endsWith('/lit.frag') && s.rate > 0);
check('a file of the course runs, with its values', now.runs && now.parameters.length > 3, now.error);
const own = await exported();
check('and is exported with what it includes', own.text.includes('void mainImage') && own.text.includes('sceneDistance') && !/^#include/m.test(own.text));
await drop('wrong.glsl', 'void mainImage(out vec4 c, in vec2 p) { c = nonsense; }\n');
await page.waitForFunction(() => /cannot be drawn/.test(document.querySelector('.said').textContent));
check('a mistake is told with its line', /chapters\/wrong\.frag:1: /.test(await page.locator('live-chapter').innerText()), await page.locator('live-chapter').innerText());
check('and cannot be exported', await page.locator('button.export').isDisabled());
await drop('picture.frag', 'a\0b');
await page.waitForFunction(() => /no text/.test(document.querySelector('.said').textContent));
check('what is no text is refused', true);
check('no error in the console', said.length === 0, said);
finish();
await browser.close();
server.close();
