// firefox.mjs - tests the program in Firefox (fox.mjs): each chapter's picture, compared with its reference; the keys,
// the mouse, the wheel and a finger; and the clock of a picture that is scrolled out of view.
import fs from 'node:fs';
import {PATIENCE, check, compare, draw, finish, frames, keep, loadProgram, pictures, rest, serve, start, state, until, WEB} from './browser.mjs';
import {Page} from './fox.mjs';

// ---- Pictures ----

const server = await serve(WEB);
const page = await Page.open();
await page.goto(`${server.at}/test.html`);
await page.evaluate(loadProgram);
console.log(`# Firefox ${page.version}`);
const OUT = 'build/web-test/firefox';
fs.mkdirSync(OUT, {recursive: true});
for (const row of pictures().filter((row) => row.name === row.stem)) {
    const got = await draw(page, row.stem, row.line), file = `${OUT}/${row.name}.png`;
    if (got.picture) keep(got.picture, file);
    const compared = got.picture ? await compare(row.name, file) : {same: false, says: ''};
    check(`${row.name} is drawn correctly in Firefox`, compared.same, got.status, compared.says, got.lines.slice(0, 4).join(' | '));
}

// ---- Input ----

const parameter = (now, name) => now.parameters.find((p) => p.name === name).value[0];
check('a chapter starts', await start(page, '03_shadows') === 0);
await page.evaluate(() => { document.getElementById('canvas').focus(); });
await page.press('Escape');
let now = await until(page, (s) => s.paused);
check('Escape pauses the program', now.paused);
await page.press('4');
now = await until(page, (s) => s.view === 'steps');
check('key 4 shows the steps view', now.view === 'steps');
const eye = now.camera;
await page.drag([100, 90], [160, 100]);
now = await until(page, (s) => s.camera[3] !== eye[3]);
check('a drag turns the camera', now.camera[3] !== eye[3] && now.camera[4] !== eye[4], eye, now.camera);
await page.drag([160, 110], [160, 110]);
now = await until(page, (s) => s.probe !== undefined);
check('a click selects the ray of the clicked pixel', now.probe?.steps > 0 && now.pixel.join() === '160,69', now.pixel);
const length = parameter(now, 'focalLength');
await page.wheel(160, 90, -300);
now = await until(page, (s) => parameter(s, 'focalLength') > length);
check('the wheel zooms the picture and does not scroll the page', parameter(now, 'focalLength') > length && await page.evaluate(() => window.scrollY) === 0);
await rest(page);
const before = now.camera;
await page.drag([100, 90], [150, 90], 'touch');
now = await until(page, (s) => s.camera[3] !== before[3]);
check('a finger that is dragged over the picture turns the camera', now.camera[3] !== before[3], before, now.camera);
await page.press('Tab');
check('Tab moves the focus away from the canvas', await page.evaluate(() => document.activeElement.id !== 'canvas'));
await page.wheel(160, 90, 120);
await page.evaluate(() => new Promise((done) => { const turn = () => window.scrollY > 0 ? done() : requestAnimationFrame(turn); turn(); }));
check('the wheel scrolls the page when the canvas does not have the focus', await page.evaluate(() => window.scrollY) > 0);

// ---- Out of view ----

await page.evaluate(() => { window.program.call('live_pause', 0); window.scrollTo(0, 2000); });
await page.evaluate(() => new Promise((done) => { const turn = () => window.program.visible ? requestAnimationFrame(turn) : done(); turn(); }));
const away = await state(page);
await frames(page, 25);
check('the clock stops while the picture is scrolled out of view', (await state(page)).time === away.time);
check('the console reports no error', page.said.length === 0, page.said.slice(0, 5));
finish();
await page.close();
server.close();
