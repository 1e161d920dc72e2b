// firefox.mjs - the program in Firefox (fox.mjs): a picture of each chapter compared with its reference, mouse, wheel
// and touch, the clock of a hidden page.
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
    check(`${row.name} in Firefox`, compared.same, got.status, compared.says, got.lines.slice(0, 4).join(' | '));
}

// ---- Input ----

const parameter = (now, name) => now.parameters.find((p) => p.name === name).value[0];
check('a chapter starts', await start(page, '03_shadows') === 0);
await page.evaluate(() => { document.getElementById('canvas').focus(); });
await page.press('Escape');
let now = await until(page, (s) => s.paused);
check('Escape pauses', now.paused);
await page.press('4');
now = await until(page, (s) => s.view === 'steps');
check('4 shows the steps', now.view === 'steps');
const eye = now.camera;
await page.drag([100, 90], [160, 100]);
now = await until(page, (s) => s.camera[3] !== eye[3]);
check('a drag turns the eye', now.camera[3] !== eye[3] && now.camera[4] !== eye[4], eye, now.camera);
await page.drag([160, 110], [160, 110]);
now = await until(page, (s) => s.probe !== undefined);
check('a click marches the ray of its pixel', now.probe?.steps > 0 && now.pixel.join() === '160,69', now.pixel);
const length = parameter(now, 'focalLength');
await page.wheel(160, 90, -300);
now = await until(page, (s) => parameter(s, 'focalLength') > length);
check('the wheel belongs to the program', parameter(now, 'focalLength') > length && await page.evaluate(() => window.scrollY) === 0);
await rest(page);
const before = now.camera;
await page.drag([100, 90], [150, 90], 'touch');
now = await until(page, (s) => s.camera[3] !== before[3]);
check('a finger that is dragged over the picture turns the eye', now.camera[3] !== before[3], before, now.camera);
await page.press('Tab');
check('Tab leaves the canvas', await page.evaluate(() => document.activeElement.id !== 'canvas'));
await page.wheel(160, 90, 120);
await page.evaluate(() => new Promise((done) => { const turn = () => window.scrollY > 0 ? done() : requestAnimationFrame(turn); turn(); }));
check('without the focus the wheel scrolls the page', await page.evaluate(() => window.scrollY) > 0);

// ---- Out of view ----

await page.evaluate(() => { window.program.call('live_pause', 0); window.scrollTo(0, 2000); });
await page.evaluate(() => new Promise((done) => { const turn = () => window.program.visible ? requestAnimationFrame(turn) : done(); turn(); }));
const away = await state(page);
await frames(page, 25);
check('a picture that is scrolled out of view does not continue', (await state(page)).time === away.time);
check('no error in the console', page.said.length === 0, page.said.slice(0, 5));
finish();
await page.close();
server.close();
