// pictures.mjs [PATTERN] - compares pictures of tests/pictures/images.txt, drawn in the browser, with their references:
// each chapter's own picture and every fifth of the others; with ALL=1, all of them; with PATTERN, those that match.
// Two browsers draw, each with a separate driver, so that one can draw while the other compiles.
import fs from 'node:fs';
import {check, compare, draw, finish, keep, launch, openPage, pictures, serve, WEB} from './browser.mjs';

const OUT = 'build/web-test/pictures';
const pattern = new RegExp(process.argv[2] || '');
const rows = pictures().filter((row, index) => pattern.test(row.name) &&
    (process.argv[2] || process.env.ALL || row.name === row.stem || index % 5 === 0));
fs.mkdirSync(OUT, {recursive: true});
const server = await serve(WEB);
check('enough pictures are selected', rows.length > (process.argv[2] ? 0 : 100), rows.length);

// The pictures of a chapter are drawn one after another in the same browser, which caches the programs that they share.
const chapters = Object.values(rows.reduce((all, row) => {
    (all[row.stem] ??= []).push(row);
    return all;
}, {}));
const judged = [];
async function judge(row, got, said) {
    const file = `${OUT}/${row.name}.png`;
    if (got.picture) keep(got.picture, file);
    const compared = got.picture ? await compare(row.name, file) : {same: false, says: ''};
    if (check(row.name, got.status === 0 && compared.same, got.status, compared.says, got.lines.slice(0, 4).join(' | '), said.slice(-2).join(' | ')))
        fs.rmSync(file);
}
async function work() {
    const browser = await launch();
    const {page, said} = await openPage(browser, server.at);
    for (let chapter; (chapter = chapters.pop()) !== undefined;)
        for (const row of chapter) judged.push(judge(row, await draw(page, row.stem, row.line), said));
    check('the browser reports no error', said.length === 0, said.slice(0, 5));
    return browser;
}
const browsers = await Promise.all([work(), work()]);
await Promise.all(judged);
finish();
for (const browser of browsers) await browser.close();
server.close();
