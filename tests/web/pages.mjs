// pages.mjs - tests the site's files without a browser: every page exists, no link is dead, every formula is converted,
// no file comes from another site or is unused, every command has a button or a reason for having none, no page is too
// large, and the programs have the same bytes when they are written again.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import zlib from 'node:zlib';
import {check, finish, serve, SITE, WEB} from './browser.mjs';

const walk = (folder) => fs.readdirSync(folder, {withFileTypes: true}).flatMap((one) => one.isDirectory() ? walk(`${folder}/${one.name}`) : [`${folder}/${one.name}`]);
const files = new Set(walk(SITE).map((file) => path.relative(SITE, file)));
const pages = [...files].filter((name) => name.endsWith('.html')).sort();
const plain = (html) => html.replace(/<[^>]*>/g, '').replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&quot;', '"').replaceAll('&#39;', '\'').replaceAll('&amp;', '&');
const text = new Map(pages.map((name) => [name, fs.readFileSync(`${SITE}/${name}`, 'utf8')]));
const top = pages.filter((name) => !name.includes('/'));
check('the site has at least 30 pages', top.length >= 30, top.length);
const lacking = fs.readdirSync('docs').filter((name) => name.endsWith('.md') && name !== 'README.md' && !text.has(name.replace(/md$/, 'html')));
check('every page of docs/ is in the site', lacking.length === 0, lacking);

// ---- A site whose address is known ----

const abroad = 'build/web-test/address', ADDRESS = 'https://example.org/course';
fs.rmSync(abroad, {recursive: true, force: true});
fs.mkdirSync(`${abroad}/fonts`, {recursive: true});
execFileSync('node', ['docs/web/site.mjs', abroad, 'docs/00_first_scene.md'], {env: {...process.env, ADDRESS}});
const shown = fs.readFileSync(`${abroad}/00_first_scene.html`, 'utf8'), preview = (html, name) => plain(new RegExp(`<meta property="og:${name}" content="([^"]*)">`).exec(html)?.[1] ?? '');
const pictured = preview(shown, 'image');
check('a link to a page is previewed with the page\'s title and a picture that is in the site', preview(shown, 'title').includes('A first scene') && preview(shown, 'url') === `${ADDRESS}/00_first_scene.html` &&
    pictured.startsWith(`${ADDRESS}/pictures/00_first_scene`) && files.has(pictured.slice(ADDRESS.length + 1)), pictured, preview(shown, 'url'));
check('without an address there is no preview, because it would need whole addresses', !text.get('00_first_scene.html').includes('og:'));

// ---- Links and loaded files ----

const ids = new Map([...text].map(([name, html]) => [name, new Set([...html.matchAll(/\sid="([^"]*)"/g)].map((match) => plain(match[1])))]));
const dead = [], foreign = [], doubled = [];
for (const [name, html] of text) {
    const all = [...html.matchAll(/\sid="([^"]*)"/g)].map((match) => match[1]);
    if (new Set(all).size !== all.length) doubled.push(`${name}: ${all.find((id, i) => all.indexOf(id) !== i)}`);
    for (const [, tag, attributes] of html.matchAll(/<(\w[\w-]*)((?:\s[\w-]+(?:="[^"]*")?)*)\s*\/?>/g)) {
        for (const [, attribute, value] of attributes.matchAll(/\s(href|src|data-index|poster)="([^"]*)"/g)) {
            const address = plain(value);
            if (/^(data|mailto):/.test(address)) continue;
            if (/^[a-z]+:|^\/\//i.test(address)) {
                if (tag !== 'a') foreign.push(`${name}: ${address}`);
                continue;
            }
            const [file, id] = address.split('#');
            const target = file === '' ? name : file.startsWith('/') ? file.slice(1) : path.join(path.dirname(name), file.split('?')[0]);
            if (!files.has(target) || (id && ids.has(target) && !ids.get(target).has(decodeURIComponent(id)))) dead.push(`${name}: ${address}`);
        }
    }
}
for (const name of [...files].filter((name) => name.endsWith('.css')))
    for (const [, address] of fs.readFileSync(`${SITE}/${name}`, 'utf8').matchAll(/url\(["']?([^"')]+)/g))
        if (!address.startsWith('data:') && !files.has(path.join(path.dirname(name), address.split(/[?#]/)[0]))) dead.push(`${name}: ${address}`);
check('no link is dead', dead.length === 0, dead.length, dead.slice(0, 8));
check('no page loads a file from another site', foreign.length === 0, foreign.slice(0, 8));
check('no page has two elements with the same id', doubled.length === 0, doubled.slice(0, 8));

const said = [...files].filter((name) => /\.(html|js|css|json|txt|frag|glsl)$/.test(name)).map((name) => fs.readFileSync(`${SITE}/${name}`, 'utf8')).join('');
const idle = [...files].filter((name) => !said.includes(path.basename(name)) && !['fonts/LICENSE.txt', '404.html'].includes(name));
check('the site contains no unused files', idle.length === 0, idle.length, idle.slice(0, 8));

// ---- Formulas ----

const failed = [...text].filter(([, html]) => /<merror|temml-error|katex-error|class="math (inline|display)"/.test(html)).map(([name]) => name);
check('every formula is converted', failed.length === 0, failed);
const formulas = [...text.values()].reduce((sum, html) => sum + html.split('<math').length - 1, 0);
check('the site has more than 3000 formulas', formulas > 3000, formulas);

// ---- Figures ----

// A figure cannot load other files, so each of its letters must be in a font that the figure contains, in the same
// style: upright, italic or bold.
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'web_pages-')), charsets = new Map();
function charsetOf(data) {
    if (!charsets.has(data)) {
        fs.writeFileSync(`${folder}/font.woff2`, data, 'base64');
        charsets.set(data, execFileSync('fc-query', ['-f', '%{charset}', `${folder}/font.woff2`], {encoding: 'utf8'}).split(' ')
            .map((range) => range.split('-').map((code) => parseInt(code, 16))));
    }
    return charsets.get(data);
}
const holds = (ranges, letter) => (ranges ?? []).some(([first, last = first]) => letter.codePointAt(0) >= first && letter.codePointAt(0) <= last);
const decoded = (words) => plain(words).replace(/&#(\d+);/g, (_, code) => String.fromCodePoint(code));
const svgs = [...files].filter((name) => /^pictures\/.*\.svg$/.test(name)), homeless = [];
for (const name of svgs) {
    const svg = fs.readFileSync(`${SITE}/${name}`, 'utf8'), faces = {};
    for (const [, family, style, data] of svg.matchAll(/@font-face\{font-family:"([^"]*)";(?:font-(?:style|weight):(\w+);)?src:url\(data:font\/woff2;base64,([^)]*)\)/g))
        faces[family === 'Course Signs' ? 'signs' : style ?? 'upright'] = charsetOf(data);
    for (const [, text] of svg.matchAll(/<text[^>]*>(.*?)<\/text>/g)) {
        let upright = text;
        for (const [whole, style, words] of text.matchAll(/<tspan font-(?:style|weight)='(\w+)'>([^<]*)<\/tspan>/g)) {
            upright = upright.replace(whole, '');
            for (const letter of decoded(words)) if (!holds(faces[style], letter) && !holds(faces.signs, letter)) homeless.push(`${name}: ${style} ${letter}`);
        }
        for (const letter of decoded(upright)) if (!holds(faces.upright, letter) && !holds(faces.signs, letter)) homeless.push(`${name}: ${letter}`);
    }
    if (!/prefers-color-scheme: dark/.test(svg) || !svg.includes('svg{font-family:"Course Heros","Course Signs"')) homeless.push(name);
}
fs.rmSync(folder, {recursive: true});
check('every figure contains its fonts, and has a dark theme', svgs.length > 15 && homeless.length === 0, svgs.length, homeless.slice(0, 8));

const uneven = [...text].filter(([, html]) => /<div class="table"><table>(?:(?!<\/table>).)*<td[^>]*>\s*<(?:img|live-chapter)/s.test(html)).map(([name]) => name);
check('pictures in one row of a table share the width of the row', uneven.length === 0, uneven);

// ---- Commands ----

// The commands are read from the sources, not from the builder's output. Each command of a shell block must be in the
// page, in a block with a button, a form or a reason why it has neither.
const squeezed = (words) => words.replace(/\s+/g, ' ').trim();
const mute = [];
let commands = 0;
for (const name of top.filter((name) => fs.existsSync(`docs/${name.replace(/html$/, 'md')}`))) {
    const blocks = (text.get(name) + (text.get(name.replace('.html', '-proofs.html')) ?? '')).split('<div class="command">').slice(1).map((html) => {
        const [listing, rest] = [html.slice(0, html.indexOf('</pre>')), html.slice(html.indexOf('</pre>'), html.indexOf('</div>'))];
        return {shown: squeezed(plain(listing)), answered: /<button[^>]*class="run"|<form class="check"|class="reason"/.test(rest)};
    });
    const source = fs.readFileSync(`docs/${name.replace(/html$/, 'md')}`, 'utf8');
    for (const [, block] of source.matchAll(/^[ >]*```sh\n([\s\S]*?)^[ >]*```/gm)) {
        for (const line of block.replace(/\\\n/g, '\\ ').split('\n').map((line) => squeezed(line)).filter((line) => /^(make|build\/)/.test(line))) {
            commands++;
            if (text.get(name).includes(`<figure-sheet name="${/^make run FIGURE=(\w+)$/.exec(line)?.[1]}"`)) continue; // the figure runs above
            if (!blocks.some((one) => one.answered && one.shown.includes(line))) mute.push(`${name}: ${line}`);
        }
    }
}
check('every command has a button or a reason for having none', commands > 400 && mute.length === 0, commands, mute.slice(0, 8));

// If a question is reworded, its line in guesses.txt no longer matches it, and its form accepts any text.
const right = fs.readFileSync('docs/web/guesses.txt', 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split('|')[0].trim());
const asked = [...new Set(right)].filter((stem) => ((text.get(`${stem}.html`) ?? '').match(/<form class="guess" data-kind/g) ?? []).length !== right.filter((one) => one === stem).length);
check('every line of guesses.txt matches a question', right.length > 10 && asked.length === 0, asked);

// Each chapter ends with exit questions.
const asking = [...text].filter(([, html]) => (html.match(/<form class="question"/g) ?? []).length === 5).map(([name]) => name);
check('every chapter asks five exit questions', asking.length === fs.readdirSync('docs').filter((name) => /^\d\d_.*md$/.test(name)).length, asking);

// ---- The server ----

const server = await serve(SITE), sent = await fetch(`${server.at}/index.html`), still = await fetch(`${server.at}/pictures/21_a_landscape-small.webp`), none = await fetch(`${server.at}/source/nothing.html`);
check('make serve compresses a page but not a picture', sent.headers.get('content-encoding') === 'gzip' && await sent.text() === text.get('index.html') && still.ok && still.headers.get('content-encoding') === null, [...sent.headers]);
await still.arrayBuffer();
const missing = await none.text();
check('an address that does not exist shows a page whose links work at any depth', none.status === 404 && /<h1>There is no such page/.test(missing) && [...missing.matchAll(/ (?:href|src|data-index)="([^"]*)"/g)].every(([, link]) => /^[/#]/.test(link)));
server.close();

// ---- Weight ----

const packed = (data) => zlib.gzipSync(data, {level: 9}).length;
const weight = (name) => packed(fs.readFileSync(`${SITE}/${name}`));
const weights = top.map((name) => {
    const loaded = [...text.get(name).matchAll(/<(?:script|link)[^>]*\s(?:src|href)="([^"]*\.(?:js|css))"/g)].map((match) => match[1]);
    return {name, raw: Buffer.byteLength(text.get(name)), sent: weight(name) + loaded.reduce((sum, file) => sum + weight(file), 0)};
}).sort((a, b) => b.sent - a.sent);
const fonts = [...files].filter((name) => name.endsWith('.woff2')).reduce((sum, name) => sum + fs.statSync(`${SITE}/${name}`).size, 0);
const kilo = (bytes) => (bytes / 1000).toFixed(0);
console.log(`# the heaviest pages, with scripts and styles, compressed: ${weights.slice(0, 3).map((one) => `${one.name} ${kilo(one.sent)} KB`).join(', ')}; the fonts add ${kilo(fonts)} KB, once`);
const texts = [...weights].sort((a, b) => b.raw - a.raw);
const zip = fs.existsSync(`${SITE}.zip`) ? fs.statSync(`${SITE}.zip`).size : 0;
check('the archive of the site has at most 25 MB', zip <= 25e6, zip);
const index = weight('find.js') + weight('search.js');
check('the search field loads at most 25 KB when it gets the focus, compressed', index <= 25e3, index);
console.log(`# the largest pages without scripts and styles, uncompressed: ${texts.slice(0, 3).map((one) => `${one.name} ${kilo(one.raw)} KB`).join(', ')}`);
check('no page has more than 150 KB of HTML, uncompressed', texts[0].raw <= 150e3, texts[0]);
check('no page has more than 150 KB with its scripts and styles, compressed', weights[0].sent <= 150e3, weights[0]);
const alive = ['01_normal_colouring.html', 'sheets/01_normal_colouring.js', 'sheet.js'].reduce((total, name) => total + weight(name), 0);
check('page 01 with its five figures has at most 42 KB, compressed', alive <= 42e3, alive);
const module = ['harness.wasm', 'harness.js', 'program.js', 'stage.js', 'live.js', 'values.js', 'ray.js', 'course.json'].filter((name) => files.has(name));
const sum = module.reduce((total, name) => total + weight(name), 0);
console.log(`# size of the files that a click on Run loads: ${kilo(sum)} KB compressed`);
check('a click on Run loads at most 275 KB, compressed', sum <= 275e3, sum);

// ---- The same bytes ----

// A reader's second `make site` writes the programs over the first ones. twice.mjs also links them again.
const again = 'build/web-test/again';
fs.rmSync(again, {recursive: true, force: true});
fs.cpSync(WEB, again, {recursive: true, filter: (name) => !name.startsWith(`${WEB}/objects`)});
execFileSync('.make/web.sh', {env: {...process.env, WEB_FOLDER: again}});
const changed = walk(again).filter((name) => !fs.readFileSync(name).equals(fs.readFileSync(name.replace(again, WEB)))).map((name) => path.relative(again, name));
check('the programs have the same bytes when they are written again', changed.length === 0, changed);
fs.rmSync(again, {recursive: true});

finish();
