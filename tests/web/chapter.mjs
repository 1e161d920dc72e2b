// chapter.mjs - tests the live chapter in a page that is made for this test: before and after the click on Run, the
// controls, a ray, the editor with its drafts and links, commands beside the text, exercises, comparisons, printing, a
// reader's own file, accessibility, reduced motion and a phone.
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {check, finish, frames, launch, PATIENCE, serve, WEB} from './browser.mjs';

const STEM = '03_shadows', FILE = `chapters/${STEM}.frag`, ANSWER = 'chapters/exercises/03_2/my.frag';
const command = (line, more = '') => `<div class="command"><pre><code>build/${STEM} ${line}</code></pre><button type="button" class="run" data-stem="${STEM}" data-line="${line}" ${more}>Run</button></div>`;
const PAIR = ['--size 320x180 --output right.png', '--size 320x180 --set shadowOffset=0.5 --output wrong.png'];
const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">
<title>03 Shadows</title><link rel="icon" href="data:,"><link rel="stylesheet" href="live.css">
<style>body { max-width: 760px; margin: auto; padding: 0 16px } pre { overflow: auto }</style><script type="module" src="live.js"></script>
<main><h1>03 Shadows</h1><live-chapter stem="${STEM}"><img src="poster.png" alt="Shadows on a stage" width="640" height="360"></live-chapter>
${command('--view normals')}${command('--probe 397,87')}${command('--probe 397,87', 'data-tail="1"')}${command('--probe 397,87', 'data-head="1"')}${command('--output dark.png --size 64x36')}${command('--nonsense')}
<p>In the text <span class="command"><code>build/${STEM} --time 3</code><button type="button" class="run" data-stem="${STEM}" data-line="--time 3">Run</button></span>.</p>
<form class="check" data-exercise="03-2" data-stem="${STEM}"><button>Check</button></form>
${command(PAIR[0], `data-other="${PAIR[1]}"`)}</main></html>`;

const server = await serve(WEB), browser = await launch(), said = [], text = fs.readFileSync(FILE, 'utf8');

// Open the test's page, in a new browser context unless one is given, and record the page's requests and errors.
async function open(options = {}, fragment = '', context = null) {
    context ??= await browser.newContext({viewport: {width: 1280, height: 800}, permissions: ['clipboard-read', 'clipboard-write'], ...options});
    const page = await context.newPage(), asked = [];
    page.setDefaultTimeout(PATIENCE); // ends only tests that hang; it is long because a busy machine is slow
    page.on('console', (message) => { if (message.type() === 'error') said.push(message.text()); });
    page.on('pageerror', (error) => said.push(error.message));
    page.on('request', (request) => asked.push(path.basename(new URL(request.url()).pathname)));
    await page.route('**/live.html*', (route) => route.fulfill({contentType: 'text/html', body: PAGE}));
    await page.route('**/poster.png', (route) => route.fulfill({path: 'tests/references/03_shadows-smooth.png'}));
    await page.goto(`${server.at}/live.html${fragment}`);
    return {page, asked, context};
}

const first = (page) => page.locator('live-chapter').first();
const on = '.live-on';
const state = (page) => page.evaluate(() => document.querySelector('.live-on').program.state());
const value = async (page, name) => (await state(page)).parameters.find((p) => p.name === name).value[0];
const press = (page, name) => page.locator(on).getByRole('button', {name, exact: true}).click();

// Wait until the program's state satisfies a condition, or until time runs out. Returns the state, which the caller
// must check.
async function comes(page, right, ...values) {
    await page.waitForFunction(([right, values]) => {
        const program = document.querySelector('.live-on')?.program;
        return program?.call('live_runs') && new Function('s', 'v', `return ${right}`)(program.state(), values);
    }, [right, values]).catch(() => {});
    return state(page);
}

async function run(page) {
    await first(page).locator('.live-start').click();
    await page.waitForSelector('.live-window');
    return comes(page, 's.rate > 0');
}

// ---- Before and after the click ----

const {page, asked, context} = await open();
await page.waitForSelector('.live-start');
check('before the click on Run, only the page and its poster are loaded, and nothing of the program', asked.sort().join() === 'live.css,live.html,live.js,poster.png', asked);
// The test delays the script that runs the program until the chapter's text has been requested.
const together = page.waitForRequest(`**/${STEM}.frag`, {timeout: PATIENCE / 3}).then(() => true, () => false);
await page.route('**/stage.js', async (route) => { await together; await route.continue(); });
const begun = Date.now();
let now = await run(page);
check('a click on Run requests the chapter\'s text without waiting for the program', await together);
await page.unroute('**/stage.js');
console.log(`# from the click to the first picture and its frame rate: ${Date.now() - begun} ms`);
check('a click on Run runs the chapter, with a picture in 16:9 that is more than 600 pixels wide', now.runs && now.size[0] > 600 && Math.abs(now.size[0] / now.size[1] - 16 / 9) < 0.02, now.size);
check('a click on Run loads no editor, solution or exercise', !asked.some((name) => /editor|exercises|solution|_\d\.frag/.test(name)), asked);
check('the page keeps the keyboard focus until the reader clicks the picture', await page.evaluate(() => document.activeElement === document.body));

// ---- Controls ----

check('the parameters are folded until the reader asks for them', await page.locator('.live-rows').isHidden());
await press(page, 'Values');
const lamp = page.locator('.live-row', {hasText: 'lampHeight'});
check('the help for a parameter includes its unit', (await lamp.locator('.live-help').textContent()) === 'height of the lamp above the stage; in scene units');
check('each parameter has a row', await page.locator('.live-row').count() === now.parameters.length);
await lamp.locator('input[type=range]').fill('2');
check('a slider sets its parameter', await value(page, 'lampHeight') === 2);
await lamp.locator('input[type=number]').fill('3.25');
await lamp.locator('input[type=number]').press('Enter');
check('a number field sets its parameter', await value(page, 'lampHeight') === 3.25);
await lamp.getByRole('button').click();
check('the button in a row resets its parameter', await value(page, 'lampHeight') === 4.6);
const shadows = page.locator('.live-row', {hasText: 'check whether the light is visible from the surface'}).locator('input');
await shadows.uncheck();
check('a checkbox switches its parameter off', await value(page, 'shadows') === 0);
await press(page, 'Reset all');
check('Reset all resets a parameter', await value(page, 'shadows') === 1);
const steps = page.locator('.live-row', {hasText: 'hitThreshold'}).locator('input[type=range]');
await steps.fill(String(Math.log(0.01)));
check('the slider of a parameter that key presses multiply is logarithmic', Math.abs(await value(page, 'hitThreshold') - 0.01) < 0.001, await value(page, 'hitThreshold'));
await press(page, 'Reset all');
await press(page, 'steps');
check('a button selects a view', (await state(page)).view === 'steps' && await page.locator('.live-views [aria-pressed=true]').textContent() === 'steps');
await press(page, 'picture');
await press(page, 'Pause');
await page.locator('.live-time').fill('7.5');
await page.locator('.live-time').press('Enter');
check('the clock can be paused and set', (await state(page)).paused && (await state(page)).time === 7.5);
await frames(page, 30);
check('a paused clock does not advance', (await state(page)).time === 7.5);

// ---- A ray ----

await page.locator('.live-canvas').click({position: {x: 400, y: 260}});
now = await comes(page, 's.probe');
await page.waitForFunction((steps) => document.querySelectorAll('.live-table tbody tr').length === steps, now.probe.steps);
check('a click on the picture lists the steps of a ray', now.probe.steps > 1 && (await page.locator('.live-table tbody tr').last().locator('td').first().textContent()) === String(now.probe.steps - 1));
await press(page, 'First step');
check('First step shows the first step', (await comes(page, 's.shown === 1')).shown === 1);
await press(page, 'Forward');
check('Forward shows the second step', (await comes(page, 's.shown === 2')).shown === 2);
await page.waitForFunction(() => document.querySelector('.live-at')?.sectionRowIndex === 1);
await page.locator('.live-table tbody tr').nth(3).locator('td').first().click();
check('a click on a row of the table shows its step', (await comes(page, 's.shown === 4')).shown === 4);
await press(page, 'Back one step');
check('Back one step shows the step before', (await comes(page, 's.shown === 3')).shown === 3);
await press(page, 'Slice');
check('Slice shows the slice of the ray', (await comes(page, 's.view === "slice"')).view === 'slice');
await press(page, 'Slice');
await press(page, 'Deselect');
check('Deselect removes the ray and its table', (await comes(page, 's.pixel[0] < 0')).pixel[0] === -1 && await page.locator('.live-table').isHidden());

// ---- The editor ----

const words = () => page.locator('.live-error').textContent();
const eye = (await state(page)).camera;
await press(page, 'Edit');
await page.waitForSelector('.cm-content');
check('the editor shows the chapter\'s file', (await page.locator('.cm-content').textContent()).startsWith(text.split('\n')[0]));
check('an included file has a tab in the editor', await page.getByRole('tab', {name: 'march.glsl'}).count() === 1);
await page.locator('.cm-content').click();
await page.keyboard.press('Control+End');
await page.keyboard.type('float wasd() { return vec3(1.0); }');
await page.waitForSelector('.live-error:not([hidden])');
const line = text.split('\n').length;
check('an error is reported with its line number', (await words()).includes(`${FILE}:${line}: error:`), await words());
check('the line with the error and the tab of its file are marked', await page.locator('.cm-lint-marker-error').count() === 1 && await page.locator('.live-faulty').count() === 1);
now = await state(page);
check('the error is visible below the picture', await page.evaluate(() => { const box = document.querySelector('.live-error').getBoundingClientRect(); return box.height > 0 && box.top >= document.querySelector('.live-canvas').getBoundingClientRect().bottom - 1 && box.bottom <= innerHeight + 1; }));
check('the buttons below the text are above the error', await page.evaluate(() => { const [bar, error] = ['.live-editor > .live-bar', '.live-error'].map((one) => document.querySelector(one).getBoundingClientRect()); return bar.top > 0 && bar.bottom <= error.top + 1; }));
check('typing in the editor does not move the camera or change the view', now.camera.every((x, i) => x === eye[i]) && now.view === 'picture', eye, now.camera);
check('the picture stays visible above the editor', await page.evaluate(() => { const box = document.querySelector('.live-canvas').getBoundingClientRect(); return box.top >= 0 && box.bottom < innerHeight; }));

// A broken edit is kept. Until the reader corrects it, the course's picture is shown.
await page.reload();
await page.waitForSelector('.live-start');
await run(page);
await page.waitForSelector('.live-error:not([hidden])');
check('after a reload, the broken edit, its error and a picture are still there', (await words()).includes('error') && (await state(page)).runs);
// A context that is lost while the edit is broken is restored in the same way.
await press(page, 'Values');
await lamp.locator('input[type=number]').fill('3.25');
await lamp.locator('input[type=number]').press('Enter');
await page.evaluate(() => new Promise((found) => {
    const canvas = document.querySelector('.live-canvas'), taken = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
    canvas.addEventListener('webglcontextlost', () => setTimeout(() => taken.restoreContext()), {once: true});
    canvas.addEventListener('webglcontextrestored', found, {once: true});
    taken.loseContext();
}));
now = await comes(page, 's.error !== "" && s.rate > 0');
check('after a lost context, the broken edit, its error, a picture and the parameters\' values are still there', now.runs && now.error !== '' && await value(page, 'lampHeight') === 3.25, now.error);
check('the page says which file contains the reader\'s changes', (await page.locator('.live-changes').textContent()).startsWith(`With your changes in ${FILE}.`));
await press(page, 'Edit');
await page.waitForSelector('.cm-content');
await press(page, 'Reset this file');
await page.waitForSelector('.live-error', {state: 'hidden'});
check('Reset this file removes the edit and its error', await page.locator('.live-changes').isHidden() && await page.evaluate(() => Object.keys(localStorage).length) === 0);
await page.locator('.cm-content').click();
await page.keyboard.press('Control+Home');
await page.keyboard.type('uniform float mine; // 3 in [0, 9]: of my own\n');
await page.waitForSelector('.live-row code:text-is("mine")');
check('a uniform that the reader types becomes a parameter with a row', await value(page, 'mine') === 3);
const [download] = await Promise.all([page.waitForEvent('download'), press(page, 'Download my.frag')]);
check('the downloaded my.frag contains the edited text', download.suggestedFilename() === 'my.frag' && fs.readFileSync(await download.path(), 'utf8') === `uniform float mine; // 3 in [0, 9]: of my own\n${text}`);
const typed = await page.evaluate(() => document.querySelector('.live-on').stage.changes.editor.text());
await press(page, 'Edit'); // closes the editor
await page.keyboard.press('Control+z');
await page.locator('.live-canvas').focus();
await page.keyboard.press('Control+z');
await frames(page, 2);
check('Ctrl+Z outside the closed editor does not change its text', await page.evaluate(() => document.querySelector('.live-on').stage.changes.editor.text()) === typed && typed.startsWith('uniform float mine'));
await press(page, 'Edit');
await press(page, 'Copy a link');
await page.waitForFunction(() => location.hash.startsWith('#edit='));
const link = await page.evaluate(() => location.hash);
const friend = await open({}, link);
await friend.page.waitForSelector('.live-start');
check('a link with an edit does not load the program before the click', !friend.asked.includes('stage.js'));
await run(friend.page);
check('a link with an edit shows the edit to a friend', await value(friend.page, 'mine') === 3);
check('a link with an edit stores nothing in the friend\'s browser', await friend.page.evaluate(() => Object.keys(localStorage).length) === 0);
await friend.context.close();
const torn = await open({}, link.slice(0, 60));
await run(torn.page);
check('a broken link is reported, and the chapter still runs', (await torn.page.locator('.live-notice').textContent()).includes('cannot be read'));
await torn.context.close();
await press(page, 'Reset all files');
await page.waitForSelector('.live-changes', {state: 'hidden'});
check('Reset all files also removes the edits from the address', await page.evaluate(() => location.hash) === '');
await page.getByRole('button', {name: 'Restore'}).press('Enter');
await page.waitForSelector('.live-changes:not([hidden])');
check('Restore brings back the texts that Reset all files has removed', await page.evaluate(() => JSON.stringify({...localStorage}).includes('of my own')) && await page.locator('.live-replaced').isHidden());
await page.locator('.live-changes').getByRole('button', {name: 'Reset all files'}).press('Enter');
await page.waitForSelector('.live-changes', {state: 'hidden'});
await page.waitForFunction(() => document.activeElement.textContent === 'Restore', null, {timeout: PATIENCE / 3}).catch(() => {});
check('after Reset all files, Restore has the focus of the keyboard', await page.evaluate(() => document.activeElement.textContent) === 'Restore');
await press(page, 'Edit');

// ---- Commands beside the text ----

const buttons = page.locator('button.run');
await buttons.nth(0).click();
await page.waitForSelector('.live-beside.live-window');
check('the button of a command opens its program below the command', (await state(page)).view === 'normals' && await page.evaluate(() => document.querySelector('.command').nextElementSibling.matches('.live-beside.live-on')));
check('while a command runs, the chapter at the top shows its poster again', await first(page).locator('.live-start').isVisible() && await first(page).locator('canvas').count() === 0);
await press(page, 'Close');
check('Close removes the program and gives the focus to the command\'s button', await page.locator('.live-beside').count() === 0 && await page.evaluate(() => document.activeElement === document.querySelector('button.run')));
await buttons.nth(1).click();
const printed = page.locator('.live-printed');
await printed.waitFor();
check('the output of a command is shown below the command', /^step,t,distance.*# hit; steps: 9/s.test(await printed.textContent()), await printed.textContent());
await buttons.nth(2).click();
await printed.nth(1).waitFor();
check('a command with data-tail shows only the last lines of its output', /^# hit; steps: 9;[^\n]*$/.test(await printed.nth(1).textContent()));
await buttons.nth(3).click();
await printed.nth(2).waitFor();
check('a command with data-head shows only the first lines of its output', /^step,t,distance[^\n]*$/.test(await printed.nth(2).textContent()), await printed.nth(2).textContent());
await buttons.nth(4).click();
await page.waitForSelector('.live-result canvas');
check('a picture that a command writes is shown', await page.locator('.live-result canvas').evaluate((c) => c.width === 64 && c.height === 36));
await buttons.nth(5).click();
await page.waitForSelector('.live-wrong');
check('a command\'s error is shown as the program reports it', (await page.locator('.live-wrong').textContent()).includes('--nonsense'));
check('the output of earlier commands is still shown', await printed.count() === 4);
await buttons.nth(6).click();
await page.waitForSelector('.live-beside.live-window');
check('a command in the text opens its program below the paragraph', await page.evaluate(() => document.querySelector('main > p').nextElementSibling.matches('.live-on')));

// ---- Exercises ----

const verdict = page.locator('.live-verdict');
const judged = async (text) => {
    await page.evaluate(async ([file, text]) => {
        document.querySelector('.live-verdict')?.replaceChildren();
        await document.querySelector('.live-on').stage.changes.change(file, text);
    }, [ANSWER, text]);
    await page.locator('form.check > button').click();
    await page.waitForSelector('.live-verdict strong');
    return verdict.textContent();
};
await page.locator('form.check > button').click();
await page.waitForSelector('.live-open');
check('a reader without changes is offered the editor, and no solution is loaded', !asked.some((name) => /_2\.frag/.test(name)));
await page.locator('.live-open').click();
await page.waitForSelector('form + .live-beside.live-window .cm-content');
check('the offered editor opens below the exercise', true);
const solution = fs.readFileSync(`chapters/solutions/${STEM}_2.frag`, 'utf8');
check('the solution is accepted in the words of make check', await judged(solution) === 'Right: matches the solution in 3 pictures: no pixel differs by more than 2 of 255.', await verdict.textContent());
const wrong = await judged(`${text}\n`);
check('the unsolved chapter is rejected in the words of make check', /^Wrong: 0\.21 % of the pixels differ by more than 2 of 255, by at most \d+, most around 431,132, on the right\./.test(wrong), wrong);
check('a wrong answer is shown with a picture of the difference', await page.locator('.live-two canvas').count() === 2);
check('a compilation error in an answer is reported with its line number', /^Wrong: does not run: my\.frag:1: error: /.test(await judged('void main() { nonsense; }')), await verdict.textContent());
check('the program beside the exercise still runs', (await state(page)).runs);
await page.evaluate(([file, text]) => document.querySelector('.live-on').stage.changes.change(file, text), [ANSWER, text]);

// ---- A comparison of two pictures ----

const comparison = page.locator('button.run[data-other]'), compared = page.locator('.live-beside .live-result .live-verdict');
const comparedNow = async () => {
    await comparison.click();
    await page.waitForFunction(() => document.querySelector('button.run[data-other]').getAttribute('aria-busy') === null && document.querySelector('.live-beside .live-verdict'));
    return compared.locator('p').first().textContent();
};
for (const line of PAIR) execFileSync(`build/${STEM}`, [...line.split(' ').slice(0, -1), `build/web-test/${line.split(' ').at(-1)}`]);
const native = spawnSync('build/tests/compare', ['--words', 'build/web-test/right.png', 'build/web-test/wrong.png'], {encoding: 'utf8'}).stdout.trim();
const inPage = await comparedNow();
check('two pictures are compared in the words of make compare', /^[1-9].* % of the pixels differ/.test(native) && inPage === `${native}.`, inPage, native);
check('both compared pictures are shown with their difference', await compared.locator('canvas').evaluateAll((all) => all.map((c) => `${c.width}x${c.height}`).join()) === '320x180,320x180,320x180');
check('the running program continues after a comparison, and a picture\'s caption is its file name', (await state(page)).runs && await page.locator('.live-result .live-two figcaption').first().textContent() === 'right.png');
const edit = (text) => page.evaluate(([file, text]) => document.querySelector('.live-on').stage.changes.change(file, text), [FILE, text]);
await edit(text.replace('rayColour(Ray ray)\n{', 'rayColour(Ray ray)\n{\n    return vec3(0.5);'));
check('a comparison uses the reader\'s changes, and the page says so', await comparedNow() === 'the pictures are the same: no pixel differs.' && await compared.getByText(`With your changes in ${FILE}.`).isVisible(), await compared.textContent());
await buttons.nth(2).click();
check('the output of a command uses the reader\'s changes, and the page says so', await page.locator('.live-result > p', {hasText: `With your changes in ${FILE}.`}).waitFor().then(() => true, () => false));
await first(page).locator('.live-start').click();
await page.waitForSelector('live-chapter:first-of-type.live-window');
await edit('void main() { nonsense; }');
check('a change that does not compile is reported with its line number', /^The pictures cannot be compared: right\.png does not run: chapters\/03_shadows\.frag:1: error: /.test(await comparedNow()), await compared.textContent());
await edit(text);
await page.locator('.live-result').filter({has: page.locator('.live-verdict')}).getByRole('button', {name: 'Close'}).click();
check('Close removes a comparison and gives the focus to its button', await compared.count() === 0 && await comparison.evaluate((one) => document.activeElement === one));

// ---- Print ----

await press(page, 'Close');
await first(page).locator('.live-start').click();
await page.waitForSelector('.live-window');
await page.emulateMedia({media: 'print'});
check('in print, a running program is replaced with its poster', await first(page).locator('img').isVisible() && await page.locator(':is(.live-canvas, .live-controls, .live-status, button):visible').count() === 0);
await page.emulateMedia({media: 'screen'});

// ---- A reader's own file ----

const toy = 'void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, 0.5, 1.0); }\n';
// On a busy machine, the browser may report late that the canvas is visible again. The test imitates such a report: a
// ray that is selected before the report must stay selected.
await page.waitForFunction(() => document.querySelector('.live-on').program.near);
const seen = (near) => page.evaluate((near) => {
    const {program} = document.querySelector('.live-on');
    program.near = near;
    program.show();
}, near);
await seen(false);
check('a page can run a shader that is not a file of the course', await page.evaluate((toy) => document.querySelector('live-chapter').play('play.frag', toy), toy) === 0);
await page.evaluate(() => document.querySelector('.live-on').stage.call('live_pixel', 5, 5));
await seen(true);
check('the program says why it shows no ray of a Shadertoy shader', (await comes(page, 's.why')).why.startsWith('no march'));
await page.evaluate(() => document.querySelector('live-chapter').run(''));
check('a chapter can be exported for Shadertoy', (await page.evaluate(() => document.querySelector('live-chapter').exported())).includes('void mainImage'));

// ---- Accessibility ----

await page.addScriptTag({path: 'build/node/node_modules/axe-core/axe.min.js'});
const audit = () => page.evaluate(async () => (await window.axe.run(document)).violations.map(({id, nodes}) => `${id}: ${nodes.map((n) => n.target).join(' ')}`));
await page.locator('.live-ray').evaluate((one) => { one.open = true; });
await press(page, 'Select the middle pixel');
await page.waitForSelector('.live-table tbody tr');
const violations = await audit();
check('axe-core finds no violations', violations.length === 0, violations);
await context.close();

// ---- Reduced motion ----

const calm = await open({reducedMotion: 'reduce'});
now = await run(calm.page);
check('with reduced motion, the first picture is paused, and the page says so', now.paused && now.time === 0 && await calm.page.locator('.live-still').isVisible());
await press(calm.page, 'Resume');
check('with reduced motion, Resume starts the clock', (await comes(calm.page, 's.time > 0.1')).time > 0.1 && !(await state(calm.page)).paused && await calm.page.locator('.live-still').isHidden());
await calm.context.close();

// ---- A phone ----

const phone = await open({viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true, deviceScaleFactor: 2});
now = await run(phone.page);
check('a page 390 pixels wide does not scroll sideways', await phone.page.evaluate(() => document.documentElement.scrollWidth) === 390);
check('on a phone, the sections for the values and the ray are collapsed', await phone.page.locator('details[open]').count() === 0);
const from = (await state(phone.page)).camera;
await phone.page.getByRole('button', {name: 'Move', exact: true}).tap();
const pad = await phone.page.getByRole('button', {name: 'Move forwards'}).boundingBox();
const touch = await phone.context.newCDPSession(phone.page);
await touch.send('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: [{x: pad.x + pad.width / 2, y: pad.y + pad.height / 2}]});
now = await comes(phone.page, 'Math.abs(s.camera[2] - v[2]) > 0.05', ...from);
await touch.send('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
check('holding a button of the movement pad moves the camera', Math.abs(now.camera[2] - from[2]) > 0.05, from, now.camera);
check('the buttons of the movement pad are large enough for a thumb', pad.height >= 44 && pad.width >= 44, pad);
await phone.page.locator('.live-canvas').tap({position: {x: 200, y: 130}});
now = await comes(phone.page, 's.probe');
check('a tap on the picture selects a ray', now.probe?.steps > 0);
await phone.page.waitForSelector('.live-table tbody tr');
check('the table of the ray opens, and does not widen the page', await phone.page.evaluate(() => document.documentElement.scrollWidth) === 390);
await phone.page.getByRole('button', {name: 'Values', exact: true}).tap();
check('the values do not widen the page', await phone.page.evaluate(() => document.documentElement.scrollWidth) === 390);
await phone.context.close();

check('the console reports no error', said.length === 0, said);
finish();
await browser.close();
server.close();
