// web_pictures.mjs [PATTERN] - every picture of tests/images.txt, drawn in the browser, against its reference.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish, keep, launch, openPage, serve} from './web_browser.mjs';

const OUT = 'build/web-test/pictures';
const pattern = new RegExp(process.argv[2] || '');
const rows = fs.readFileSync('tests/images.txt', 'utf8').split('\n').filter((line) => /^[0-9]/.test(line)).map((line) => {
    const [stem, variant, ...options] = line.trim().split(/\s+/);
    return {stem, name: variant === '-' ? stem : `${stem}-${variant}`, line: options.join(' ')};
}).filter((row) => pattern.test(row.name));

fs.mkdirSync(OUT, {recursive: true});
const server = await serve('build/web'), browser = await launch();
let {page, said} = await openPage(browser, server.at);
check('the list names pictures', rows.length > (process.argv[2] ? 0 : 300), rows.length);
for (const row of rows) {
    const got = await page.evaluate(async ({stem, line}) => {
        window.lines.length = window.pictures.length = 0;
        const status = await window.program.start(stem, `${line} --output picture.png`);
        return {status, picture: window.pictures[0], lines: window.lines};
    }, row);
    const file = `${OUT}/${row.name}.png`;
    if (got.picture) keep(got.picture, file);
    const compared = got.picture ? spawnSync('build/tests/compare', [`tests/references/${row.name}.png`, file], {encoding: 'utf8'}) : null;
    if (check(row.name, got.status === 0 && compared?.status === 0, got.status, compared?.stdout.trim() ?? '', got.lines.slice(0, 4).join(' | '), said.slice(-2).join(' | ')))
        fs.rmSync(file);
}
check('the browser reports no error', said.length === 0, said.slice(0, 5));
finish();
await browser.close();
server.close();
