// look.mjs [PATTERN] - every page of the site in Chromium: what axe-core finds, in light and in dark; nothing to scroll
// sideways on a phone's 390 pixels; nothing wider than a printed page, whose answers are at its end; no error in the
// console, no request that fails or leaves the site, and none before a click for the module, the editor or the course's
// files. One page is opened as a file. By default it looks at the front page, the page Play and every third
// of the others; with ALL=1 at all of them; with PATTERN at those that match.
import fs from 'node:fs';
import {pathToFileURL} from 'node:url';
import {blankPage, check, finish, launch, serve, SITE, whole} from './browser.mjs';

const AXE = fs.readFileSync('build/node/node_modules/axe-core/axe.min.js', 'utf8');
const LATER = /harness|course|stage\.js|program\.js|editor\.js|check\.js|exercises|search\.js/; // loaded only by a click or a search
const pattern = new RegExp(process.argv[2] || '');
const server = await serve(SITE), browser = await launch('none');
// The pages of the source files differ only in their texts, so a few of them suffice.
const sources = fs.readdirSync(`${SITE}/source`, {recursive: true}).filter((name) => name.endsWith('.html')).map((name) => `source/${name}`).sort();
const names = [...fs.readdirSync(SITE).filter((name) => name.endsWith('.html')), ...sources.filter((_, i) => i % 40 === 0)].filter((name, i) => pattern.test(name) &&
    (process.argv[2] || process.env.ALL || i % 3 === 0 || /^(index|play)\.html$/.test(name)));
check('there are pages', names.length > (process.argv[2] ? 0 : 15), names.length);

// What axe-core finds: [rule: the elements]. Formulas are left out: they are MathML, have the text's colour and nothing
// to press, and their thousands of elements take most of the time. In light, every rule; in dark, only the rules on
// colour, which alone can change.
const findings = (page, only) => page.evaluate(async (only) => {
    const found = await window.axe.run({exclude: [['math']]}, {resultTypes: ['violations'], ...(only && {runOnly: only})});
    return found.violations.map((one) => `${one.id}: ${one.nodes.length}: ${one.nodes.slice(0, 2).map((node) => node.target.join(' ')).join(', ')}`);
}, only);

// The faults of a page on A4, without its margins: visible parts other than the text, cut-off parts, colours of the
// dark theme, answers below their questions.
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
        const left = [...says('seen', all('button, form, nav, input, .top, .foot')), ...says('cut', wide), ...says('dark', dark), ...(told ? [`folds: ${folds}`] : [])];
        dispatchEvent(new Event('afterprint'));
        return main.lastElementChild === end && folds > 0 ? [...left, 'the answers stay at the end'] : left;
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
        const wide = await page.evaluate(() => {
            for (const one of document.querySelectorAll('details')) one.open = true;
            const most = document.documentElement.clientWidth;
            if (document.documentElement.scrollWidth <= most) return [];
            return [document.documentElement.scrollWidth, ...[...document.body.querySelectorAll('*')].filter((one) => one.getBoundingClientRect().right > most + 1).slice(0, 4).map((one) => `${one.tagName}.${one.className}`)];
        });
        check(`${name}: nothing to scroll sideways at 390 pixels`, wide.length === 0, wide);
        const small = await page.evaluate(() => [...document.querySelectorAll('img[src$=".svg"]')].filter((one) => one.width < 640).map((one) => [one.src, one.width]));
        check(`${name}: the letters of its diagrams, 13 of 760 units, are at least 10.9 pixels high there`, small.length === 0, small);
        const across = await page.evaluate(() => document.querySelector('main').getBoundingClientRect().width);
        check(`${name}: the text has the telephone's width`, across >= 380, across);
        await page.setViewportSize({width: 1280, height: 900});
        await page.evaluate(AXE);
        const light = await findings(page);
        await page.emulateMedia({colorScheme: 'dark'});
        const dark = await findings(page, ['color-contrast', 'link-in-text-block']);
        check(`${name}: axe-core finds nothing, in light and in dark`, light.length + dark.length === 0, light, 'dark:', dark);
        const printed = await onPaper(page);
        check(`${name}: on paper it is complete, in light colours, with the answers at the end`, printed.length === 0, printed);
        check(`${name}: no error, no request that fails or leaves the site`, said.length === 0 && failed.length === 0 && asked.every((url) => url.startsWith(server.at)), said, failed, asked.filter((url) => !url.startsWith(server.at)));
        check(`${name}: nothing is loaded that only a click needs`, !asked.some((url) => LATER.test(new URL(url).pathname.replace(/^\/source\//, ''))) || /^(index|play)\.html$/.test(name) && !asked.some((url) => /harness/.test(url)), asked.filter((url) => LATER.test(url)));
    }
}
const work = [...names];
await Promise.all([look(work), look(work)]);

// In a page that is opened as a file, browsers refuse the programs; its fonts, its pictures and the search work.
const {page} = await blankPage(browser);
await page.goto(`${pathToFileURL(SITE)}/01_normal_colouring.html`);
await page.getByRole('searchbox').fill('normal');
await page.locator('.results a').first().waitFor();
const found = await page.evaluate(async () => {
    await document.fonts.ready;
    const seen = (selector) => [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility()).length;
    return {told: seen('.note.opened'), asks: seen(':is(.run, .check, .live-start)'), poster: document.querySelector('live-chapter img').naturalWidth, letters: document.fonts.check('1rem "Course Pagella"')};
});
check('a page that is opened as a file says that no program runs there, and can be read', found.told === 1 && found.asks === 0 && found.poster > 0 && found.letters, found);
finish();
await browser.close();
server.close();
