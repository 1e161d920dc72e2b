// look.mjs [PATTERN] - tests pages of the site in Chromium: axe-core finds no violations, in the light and the dark
// theme; no page scrolls sideways on a phone 320 or 390 pixels wide; when a page is printed, no part is wider than the
// paper, and the answers are at the end; there is no error in the console; no request fails or leaves the site, and
// none asks for the module, the editor or the course's files before a click. One page is opened as a file. By default,
// the test looks at the front page, the Play page and every third of the others; with ALL=1, at all of them; with
// PATTERN, at those that match.
import fs from 'node:fs';
import {pathToFileURL} from 'node:url';
import {blankPage, check, finish, launch, serve, SITE, whole} from './browser.mjs';

const AXE = fs.readFileSync('build/node/node_modules/axe-core/axe.min.js', 'utf8');
const LATER = /harness|course|stage\.js|program\.js|editor\.js|check\.js|exercises|search/; // loaded only after a click or for a search
const pattern = new RegExp(process.argv[2] || '');
const server = await serve(SITE), browser = await launch('none');
// The pages of the source files differ only in their texts, so a few of them suffice.
const sources = fs.readdirSync(`${SITE}/source`, {recursive: true}).filter((name) => name.endsWith('.html')).map((name) => `source/${name}`).sort();
const names = [...fs.readdirSync(SITE).filter((name) => name.endsWith('.html')), ...sources.filter((_, i) => i % 40 === 0)].filter((name, i) => pattern.test(name) &&
    (process.argv[2] || process.env.ALL || i % 3 === 0 || /^(index|play)\.html$/.test(name)));
check('enough pages are tested', names.length > (process.argv[2] ? 0 : 15), names.length);

// Run axe-core. Returns each violated rule with the number of its elements and the first two of them. Formulas are left
// out: they are MathML, have the colour of the text and contain no controls, and their thousands of elements would take
// most of the time. In the light theme, all rules are run; in the dark theme, only the rules on colour, because the
// results of the others cannot change.
//   only  the rules to run; undefined for all
const findings = (page, only) => page.evaluate(async (only) => {
    const found = await window.axe.run({exclude: [['math']]}, {resultTypes: ['violations'], ...(only && {runOnly: only})});
    return found.violations.map((one) => `${one.id}: ${one.nodes.length}: ${one.nodes.slice(0, 2).map((node) => node.target.join(' ')).join(', ')}`);
}, only);

// Find the faults of a page printed on A4, in a viewport the size of the paper without its margins: visible parts other
// than the text, parts that are cut off, colours of the dark theme, and answers below their questions.
async function onPaper(page) {
    await page.setViewportSize({width: 658, height: 971});
    await page.emulateMedia({media: 'print', colorScheme: 'dark'});
    const wrong = await page.evaluate(() => {
        document.documentElement.dataset.theme = 'dark';
        for (const one of document.querySelectorAll('details')) one.open = false;
        dispatchEvent(new Event('beforeprint'));
        const seen = (one) => one.checkVisibility() && one.getClientRects().length > 0, main = document.querySelector('main');
        const all = (selector) => [...document.querySelectorAll(selector)].filter(seen), says = (what, many) => many.slice(0, 3).map((one) => `${what}: ${one.outerHTML.slice(0, 80)}`);
        const wide = all('main :is(pre, code, img, table, math, p)').filter((one) => one.getBoundingClientRect().right > innerWidth + 1 || one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX === 'auto');
        const dark = all('main :is(p, h1, img, figcaption)').filter((one) => getComputedStyle(one).colorScheme !== 'light' || /rgb\((1[5-9]|2\d)\d/.test(getComputedStyle(one).color));
        const folds = document.querySelectorAll('main details:not(.question *)').length, end = main.lastElementChild;
        const told = folds === 0 ? end.matches('section') : end.querySelectorAll('h4').length !== folds || all('main details > :not(summary)').length > 0 || all('main > section:last-child > :not(h2, h3, h4)').length < folds;
        const left = [...says('seen', all('button:not(.sheet-word), form, nav, input, .top, .foot')), ...says('cut', wide), ...says('dark', dark), ...(told ? [`folds: ${folds}`] : [])];
        dispatchEvent(new Event('afterprint'));
        return main.lastElementChild === end && folds > 0 ? [...left, 'after printing, the answers are still at the end'] : left;
    });
    await page.emulateMedia({media: 'screen', colorScheme: 'light'});
    return wrong;
}

async function look(work) {
    const {page, said} = await blankPage(browser, {context: {viewport: {width: 390, height: 844}, colorScheme: 'light', reducedMotion: 'reduce'}});
    const asked = [], failed = [];
    page.on('request', (request) => { if (!request.url().startsWith('data:') && !request.url().startsWith('blob:')) asked.push(request.url()); });
    page.on('response', (answer) => { if (answer.status() >= 400) failed.push(answer.url()); });
    for (let name; (name = work.pop()) !== undefined;) {
        said.length = asked.length = failed.length = 0;
        await page.emulateMedia({colorScheme: 'light'});
        await page.setViewportSize({width: 390, height: 844});
        await page.goto(`${server.at}/${name}`);
        await whole(page);
        await page.evaluate(() => { for (const one of document.querySelectorAll('details')) one.open = true; });
        const wide = [];
        for (const width of [320, 390]) {
            await page.setViewportSize({width, height: 844});
            wide.push(...await page.evaluate(() => {
                const most = document.documentElement.clientWidth;
                if (document.documentElement.scrollWidth <= most) return [];
                return [document.documentElement.scrollWidth, ...[...document.body.querySelectorAll('*')].filter((one) => one.getBoundingClientRect().right > most + 1).slice(0, 4).map((one) => `${one.tagName}.${one.className}`)];
            }));
        }
        check(`${name}: the page does not scroll sideways at 320 and at 390 pixels`, wide.length === 0, wide);
        const small = await page.evaluate(() => [...document.querySelectorAll('img[src$=".svg"]')].filter((one) => one.width < 640).map((one) => [one.src, one.width]));
        check(`${name}: at 390 pixels, letters of 13 units in a diagram 760 units wide are at least 10.9 pixels high`, small.length === 0, small);
        const across = await page.evaluate(() => document.querySelector('main').getBoundingClientRect().width);
        check(`${name}: the text fills the width of the phone`, across >= 380, across);
        await page.setViewportSize({width: 1280, height: 900});
        await page.evaluate(AXE);
        const light = await findings(page);
        await page.emulateMedia({colorScheme: 'dark'});
        const dark = await findings(page, ['color-contrast', 'link-in-text-block']);
        check(`${name}: axe-core finds no violations, in the light and the dark theme`, light.length + dark.length === 0, light, 'dark:', dark);
        const printed = await onPaper(page);
        check(`${name}: the printed page is complete and in light colours, with the answers at the end`, printed.length === 0, printed);
        check(`${name}: the console reports no error, and no request fails or leaves the site`, said.length === 0 && failed.length === 0 && asked.every((url) => url.startsWith(server.at)), said, failed, asked.filter((url) => !url.startsWith(server.at)));
        check(`${name}: nothing is loaded that is needed only after a click`, !asked.some((url) => LATER.test(new URL(url).pathname.replace(/^\/source\//, ''))) || /^(index|play)\.html$/.test(name) && !asked.some((url) => /harness/.test(url)), asked.filter((url) => LATER.test(url)));
    }
}
const work = [...names];
await Promise.all([look(work), look(work)]);

// In a page that is opened as a file, browsers refuse to load the programs, but the fonts, the pictures and the search
// work.
const {page} = await blankPage(browser);
await page.goto(`${pathToFileURL(SITE)}/01_normal_colouring.html`);
await page.getByRole('searchbox').fill('normal');
await page.locator('.results a').first().waitFor();
const found = await page.evaluate(async () => {
    await document.fonts.ready;
    const seen = (selector) => [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility()).length;
    return {told: seen('.note.opened'), asks: seen(':is(.run, .check, .live-start)'), poster: document.querySelector('live-chapter img').naturalWidth, letters: document.fonts.check('1rem "Course Pagella"')};
});
check('a page that is opened as a file says that no program can run there, and is readable', found.told === 1 && found.asks === 0 && found.poster > 0 && found.letters, found);
finish();
await browser.close();
server.close();
