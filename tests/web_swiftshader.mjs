// web_swiftshader.mjs [PATTERN] - the pictures on SwiftShader, Chromium's own rasteriser for machines without a
// graphics card: how far each is from its reference, told and not judged. PATTERN picks others than one of each chapter.
import fs from 'node:fs';
import {check, compare, draw, finish, keep, launch, openPage, pictures, serve} from './web_browser.mjs';

const OUT = 'build/web-test/swiftshader';
const pattern = process.argv[2] ? new RegExp(process.argv[2]) : null;
const rows = pictures().filter((row) => pattern ? pattern.test(row.name) : row.name === row.stem);
fs.mkdirSync(OUT, {recursive: true});
const server = await serve('build/web'), browser = await launch('swiftshader');
const {page, said} = await openPage(browser, server.at);
const renderer = await page.evaluate(() => {
    const context = document.createElement('canvas').getContext('webgl2');
    return context.getParameter(context.getExtension('WEBGL_debug_renderer_info').UNMASKED_RENDERER_WEBGL);
});
check('SwiftShader draws', /SwiftShader/.test(renderer), renderer);
let same = 0, drawn = 0;
for (const row of rows) {
    const got = await draw(page, row.stem, row.line), file = `${OUT}/${row.name}.png`;
    if (!got.picture) {
        console.log(`# ${row.name}: no picture: ${got.lines.slice(0, 2).join(' | ')}`);
        continue;
    }
    drawn++;
    keep(got.picture, file);
    const compared = await compare(row.name, file);
    if (compared.same) same++;
    else console.log(`# ${row.name}: ${compared.says}`);
}
check('every picture is drawn', drawn === rows.length, drawn, rows.length);
console.log(`# on ${renderer}: ${same} of ${rows.length} within tolerance`);
check('the browser reports no error', said.length === 0, said.slice(0, 5));
finish();
await browser.close();
server.close();
