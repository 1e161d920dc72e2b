// site.mjs OUT PAGE... - makes a static site from the pages of docs/. `make site` calls it after the module is built.
//   OUT   the folder of the site, which must exist
//   PAGE  the pages in reading order, as files
// The script also writes the front page, the Play page, a page for each file that pages link to, the search index, the
// pictures, and the fonts. OUT.parts/ is for intermediate files. The variable ADDRESS is the address at which the site will
// be; without it, other sites show no picture beside a link to a page.
import {createHash} from 'node:crypto';
import {execFile} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {promisify} from 'node:util';
import {bodyOf, read, sectionsOf} from './body.mjs';
import {escaped, plain} from './colour.mjs';
import {writeFigures} from './figures.mjs';
import {subset} from './fonts.mjs';
import {smallOf, writePictures} from './pictures.mjs';
import {questionsOf} from './questions.mjs';
import {partsOf, scriptOf, textureOf, texturesIn} from './sheets.mjs';
import {Sources, root} from './sources.mjs';

const run = promisify(execFile);
const [out, ...files] = process.argv.slice(2);
const HERE = 'docs/web/';
const TITLE = 'Ray marching, step by step';
const ADDRESS = (process.env.ADDRESS ?? '').replace(/\/?$/, '/');
const template = read(`${HERE}template.html`);
const sources = new Sources(), pictures = new Map();

// ---- Pages ----

const NAMES = {README: 'reading', front: 'index'};
const addressOf = (name) => `${NAMES[name] ?? name}.html`;

async function pageOf(file) {
    const name = path.basename(file, '.md');
    const {stdout} = await run('pandoc', ['-f', 'gfm+tex_math_dollars+smart', '-t', 'html5', '--mathjax', '--no-highlight', '--wrap=none',
        '--lua-filter', `${HERE}filter.lua`, file], {maxBuffer: 1 << 26});
    const stem = /^\d\d_/.test(name) ? name : undefined;
    const address = addressOf(name);
    const page = {address, stem, title: plain(/<h1[^>]*>(.*?)<\/h1>/s.exec(stdout)[1])};
    for (const [, source] of stdout.matchAll(/(?:data-file="|href="source:)([^"#]*)/g)) sources.mention(source, page);
    try {
        page.body = bodyOf(stdout, {stem, sources, pictures}).replace(/(<h1[^>]*>)(\d\d) /, '$1<span class="number">$2</span> ');
        page.body = hinted(page) + (stem ? questionsOf(stem) : '');
    } catch (error) {
        throw new Error(`${file}: ${error.message}`, {cause: error});
    }
    page.sections = sectionsOf(page.body);
    return page;
}

// Convert only one page at a time per processor, because each pandoc uses a whole processor.
async function pagesOf(names) {
    const pages = [];
    let next = 0;
    await Promise.all(os.cpus().map(async () => {
        while (next < names.length) {
            const i = next++;
            pages[i] = await pageOf(names[i]);
        }
    }));
    return pages;
}

// The note below the first chapter's first command. It is needed because the pages speak of a terminal, which a reader may
// not have.
const HERE_TOO = '<p class="note">You need no terminal on these pages: <b>Run</b> runs the command beside it, a picture becomes a running program when you click or tap it, and <b>Edit</b>, below the program, opens its shader. '
    + '<a href="pages.html">How these pages work</a></p>';
const hinted = (page) => page.stem?.startsWith('00_') ? page.body.replace(/<\/live-chapter>(?:(?:(?!<h2).)*?<div class="commands">.*?<\/button><\/div><\/div>)?/s, (program) => `${program}\n${HERE_TOO}`) : page.body;

// ---- Proofs ----

// Including the navigation around its body, a page has at most 150 KB of HTML, because a phone takes too long to load
// and lay out more. If a body is larger than HEAVY bytes, its proofs become a separate page.
const HEAVY = 140e3;

const idsOf = (html) => new Set([...html.matchAll(/\sid="([^"]*)"/g)].map(([, id]) => id));

// Move the proofs of a heavy page to a separate page, and leave a list of links to them. Returns the new page, or
// undefined if the page is not heavy.
function proofsOf(page) {
    if (Buffer.byteLength(page.body) <= HEAVY) return undefined;
    const [whole, heading, body] = /(<h2 id="proofs">.*?<\/h2>)(.*?)(?=<h2|$(?![^]))/s.exec(page.body) ?? [];
    if (!whole) throw new Error(`${page.address}: ${Buffer.byteLength(page.body)} bytes, and no section of proofs that could become a separate page`);
    const address = page.address.replace('.html', '-proofs.html');
    const items = [...body.matchAll(/<h3 id="([^"]*)">(.*?)<\/h3>/gs)].map(([, id, title]) => `<li><a href="${address}#${id}">${title.replace(/<\/?a[^>]*>/g, '')}</a></li>`);
    page.body = page.body.replace(whole, () => `${heading}<p>The proofs are on <a href="${address}">a separate page</a>:</p><ul>${items.join('')}</ul>`);
    return {
        address, of: page, title: `${page.title}: proofs`, stem: page.stem,
        body: `<h1 id="${page.stem}-proofs">${page.title.replace(/^\d\d /, '<span class="number">$&</span>')}: proofs</h1>\n<p>These are the proofs of the claims in <a href="${page.address}">the chapter</a>.</p>\n`
            + body.replace(/<(\/?)h([34])/g, (_, end, level) => `<${end}h${level - 1}`),
    };
}

// Insert each page of proofs after the page that it belongs to, and update every link to a target that has moved.
function parted(pages) {
    const all = pages.flatMap((page) => [page, proofsOf(page)].filter(Boolean));
    for (const proofs of all.filter(({of}) => of)) {
        const {of} = proofs, moved = idsOf(proofs.body), at = (address, id) => `href="${address}#${id}"`;
        for (const page of all) {
            page.body = page.body.replaceAll(new RegExp(`href="${of.address}#([^"]*)"`, 'g'), (link, id) => moved.has(id) ? at(proofs.address, id) : link);
            if (page === of) page.body = page.body.replace(/href="#([^"]*)"/g, (link, id) => moved.has(id) ? at(proofs.address, id) : link);
        }
        proofs.body = proofs.body.replace(/href="#([^"]*)"/g, (link, id) => moved.has(id) ? link : at(of.address, id));
        proofs.body = proofs.body.replaceAll(`href="${proofs.address}#`, 'href="#');
        for (const page of [of, proofs]) page.sections = sectionsOf(page.body);
    }
    return all;
}

// ---- The surroundings of a page ----

// The parts of the course, from docs/README.md: [{name, title, from, to}], where from and to are chapter numbers.
const parts = [...read('docs/README.md').matchAll(/^\| ([IV]+), ([^|]*) \| (\d\d) (?:to|and) (\d\d) \|/gm)].map(([, name, title, from, to]) => ({name: `Part ${name}`, title, from, to}));
const partOf = (page) => page.stem && parts.find(({from, to}) => page.stem.slice(0, 2) >= from && page.stem.slice(0, 2) <= to);
const BUILDING = ['teaching', 'architecture', 'contributing'];

function groupOf(page) {
    if (page.stem) return partOf(page)?.name ?? 'Chapters';
    const name = path.basename(page.address, '.html');
    return ['index', 'reading', 'pages', 'play'].includes(name) ? '' : BUILDING.includes(name) ? 'Teaching and contributing' : 'Reference';
}

const short = (page) => page.address === 'index.html' ? 'Front page' : page.title;
const numbered = (title) => escaped(title).replace(/^(\d\d) /, '<span class="number">$1</span> ');

function contents(pages, here, up = '') {
    const groups = Map.groupBy ? Map.groupBy(pages, groupOf) : pages.reduce((map, page) => map.set(groupOf(page), [...map.get(groupOf(page)) ?? [], page]), new Map());
    const headed = (name, {title} = parts.find((part) => part.name === name) ?? {}) => name && `<h2>${name}${title ? ` <small>${title}</small>` : ''}</h2>`;
    // site.js shows which chapters are read, and how many of their exercises are solved.
    const exercises = ({stem, of, body}) => stem && !of ? ` data-exercises="${(body.match(/class="check"/g) ?? []).length}"` : '';
    return [...groups].map(([name, group]) => `${headed(name)}<ul>${group.map((page) =>
        `<li${page.of ? ' class="under"' : ''}><a href="${up}${page.address}"${exercises(page)}${page === here ? ' aria-current="page"' : ''}>${page.of ? 'Proofs' : numbered(short(page))}</a></li>`)
        .join('')}</ul>`).join('\n');
}

// The list of sections on the right; subsections are shown only for the section that is being read.
function sectionList(page) {
    const items = [];
    for (const section of page.sections.filter(({level}) => level > 1)) {
        const text = section.html.replace(/<a [^>]*>|<\/a>/g, '');
        const link = `<a href="#${section.id}"${section.lang ? ` lang="${section.lang}"` : ''}>${text}</a>`;
        if (section.level === 2 || items.length === 0 || !items.at(-1).two) items.push({two: section.level === 2, link, more: []});
        else items.at(-1).more.push(link);
    }
    return items.map(({link, more}) => `<li>${link}${more.length > 0 ? `<ul>${more.map((each) => `<li>${each}</li>`).join('')}</ul>` : ''}</li>`).join('');
}

function turn(pages, page) {
    // A reader who follows the order of the chapters skips pages of proofs; on such a page, 'previous' is its chapter.
    const i = pages.indexOf(page), before = pages.slice(0, i).findLast(({of}) => !of), after = pages.slice(i + 1).find(({of}) => !of);
    if (i < 0 || (!before && !after)) return '';
    return `<nav class="turn" aria-label="Previous and next page">${before ? `<a rel="prev" href="${before.address}"><small>Previous</small> ${numbered(short(before))}</a>` : '<span></span>'}`
        + `${after ? `<a rel="next" href="${after.address}"><small>Next</small> ${numbered(short(after))}</a>` : ''}</nav>`;
}

// The content security policy of a page names the hash of the one script that the page contains.
const hash = `sha256-${createHash('sha256').update(/<script>(.*?)<\/script>/s.exec(template)[1]).digest('base64')}`;

function fill(values) {
    return template.replace(/\{\{(\w+)\}\}/g, (_, name) => ({hash, ...values})[name] ?? '');
}

function write(page, pages) {
    const list = page.sections.length > 3 && page.address !== 'index.html' ? sectionList(page) : '';
    const alive = /<live-chapter|class="run"/.test(page.body), sheets = scriptOf(page.body), script = `sheets/${page.address.replace('.html', '.js')}`;
    if (sheets) fs.writeFileSync(`${out}/${script}`, sheets);
    const first = /<p(?: class="lead")?>(.*?)<\/p>/s.exec(page.body)?.[1] ?? '';
    const words = plain(first.replace(/<math.*?<\/math>/gs, '…')).replace(/\s+/g, ' ');
    const shown = /<live-chapter[^>]*><img src="([^"]*)"/.exec(page.body)?.[1] ?? `pictures/${smallOf('21_a_landscape-smooth.png')}`;
    fs.writeFileSync(`${out}/${page.address}`, fill({
        root: '', kind: `${page.stem ? 'chapter' : page.address.replace('.html', '')}${list ? ' three' : ''}`,
        fonts: /<math/.test(page.body) ? '\n<link rel="preload" href="fonts/formula.woff2" as="font" type="font/woff2" crossorigin>' : '',
        title: escaped(page.address === 'index.html' ? TITLE : `${page.title} · ${TITLE}`),
        description: escaped(words.length > 155 ? `${words.slice(0, words.lastIndexOf(' ', 155))} …` : words),
        preview: ADDRESS === '/' ? '' : `\n<meta property="og:title" content="${escaped(page.title)}">\n<meta property="og:type" content="article">\n<meta property="og:url" content="${escaped(ADDRESS + page.address)}">\n<meta property="og:image" content="${escaped(ADDRESS + shown)}">`,
        head: (sheets ? `\n<link rel="stylesheet" href="sheet.css">\n<script src="${script}" defer></script>${partsOf(page.body, sheets).map((part) => `\n<script src="${part}" defer></script>`).join('')}\n<script src="sheet.js" defer></script>` : '') + (!alive ? '' : '\n<link rel="stylesheet" href="live.css">\n<script type="module" src="live.js"></script>' + (page.address === 'play.html' ? '\n<script type="module" src="play.js"></script>' : '')) + (page.body.includes('class="progress"') ? '\n<script src="progress.js" defer></script>' : ''),
        answers: ['guess', 'question'].filter((name) => page.body.includes(`class="${name}"`)).map((name) => `<script src="${name}.js" defer></script>\n`).join(''),
        menu: list ? '<button type="button" class="menu at" popovertarget="sections">Sections</button>\n' : '',
        contents: contents(pages, page), body: page.body,
        note: alive ? '<noscript><p class="note">Without JavaScript the programs do not run, but all text, formulas and pictures are here.</p></noscript>\n' : '',
        sections: list ? `<nav id="sections" class="sections" aria-label="On this page" popover>\n<h2>On this page</h2><ul>${list}</ul>\n</nav>` : '',
        turn: turn(pages, page),
    }));
}

// ---- The front page and Play ----

// The rows of the table of chapters in README.md: for each, the picture, its alternative text, the chapter's title and
// stem, and what a reader can do afterwards.
const rows = () => [...read('README.md').matchAll(/^\| !\[([^\]]*)\]\(([^)]*)\) \| \[([^\]]*)\]\(docs\/([^)]*)\.md\) \| (.*) \|$/gm)]
    .map(([, alt, picture, title, stem, can]) => ({alt, picture, title, stem, can}));

function gallery() {
    const card = ({alt, picture, title, stem, can}) => {
        const name = smallOf(picture);
        pictures.set(name, picture);
        return `<li><a href="${stem}.html"><img src="pictures/${name}" alt="${escaped(alt)}" width="640" height="360" loading="lazy" decoding="async">`
            + `<strong>${numbered(title)}</strong></a><p>${escaped(can[0].toUpperCase() + can.slice(1))}.</p></li>`;
    };
    const all = rows();
    return parts.map(({name, title, from, to}) => `<h3 id="${name.toLowerCase().replace(' ', '-')}">${name}: ${title}</h3>\n<ul class="gallery">${all.filter(({stem}) =>
        stem.slice(0, 2) >= from && stem.slice(0, 2) <= to).map(card).join('\n')}</ul>`).join('\n');
}

// The section "Where it comes from" of README.md, with its links relative to docs/.
function whereFrom() {
    const section = /^## Where it comes from\n(.*?)(?=\n## |$(?![^]))/ms.exec(read('README.md'))[0];
    return section.replaceAll('](docs/', '](').trim();
}

// The templates with which a reader may begin on the Play page: for each, the name, the file in chapters/, and the
// reference picture that shows the template.
const STARTERS = [
    ['Ball', 'first_steps/play', '00_first_scene-step-5'], ['Rings', 'first_steps/2_distance', '00_first_scene-step-2'],
    ...[['Normals', '01_normal_colouring'], ['Lamps', '02_lighting'], ['Shadows', '03_shadows'], ['Colours', '04_hue_colour'], ['Fractal', '06_sierpinski_symmetry'],
        ['City', '07_repetition'], ['Sunset', '09_sky_and_sunset'], ['Landscape', '21_a_landscape']].map(([title, stem]) => [title, stem, `${stem}-smooth`]),
];

function starter([title, shader, picture]) {
    const file = `tests/references/${picture}.png`, name = smallOf(file);
    pictures.set(name, file);
    return `<button type="button" class="starter" id="new=${title.toLowerCase()}" data-file="chapters/${shader}.frag" data-stem="${shader.includes('/') ? '01_normal_colouring' : shader}"><img src="pictures/${name}" alt="" width="160" height="90" loading="lazy">${title}</button>`;
}

// The studio: the running shader, its name and what can be done with it, and the ways to begin.
const drop = () => '<div class="drop"><live-chapter stem="01_normal_colouring" play hidden></live-chapter>'
    + '<p class="studio" hidden><label>Name <input class="title" disabled></label> <button type="button" class="remix" disabled>Remix</button> <button type="button" class="save" disabled>Download</button> '
    + '<button type="button" class="export" disabled>Export for Shadertoy</button></p><p class="said" role="status"></p>'
    + `<div class="starters" role="group" aria-label="Begin with"><button type="button" class="starter" id="new=blank">Blank sheet</button>${STARTERS.map(starter).join('')}</div><ul class="drafts" aria-label="Your drafts" hidden></ul>`
    + '<p class="files"><label for="file">Choose files, or drop them or a folder here:</label> <input type="file" id="file" multiple accept=".frag,.glsl,.fs,.txt,.json"></p></div>';

// The landscape over a day. A reader who does not play the film does not load it.
function film() {
    const file = 'tests/references/21_a_landscape-smooth.png', name = smallOf(file);
    pictures.set(name, file).set('day.mp4', `${HERE}day.mp4`);
    return `<figure><div class="film"><video src="pictures/day.mp4" poster="pictures/${name}" width="640" height="360" preload="none" controls muted loop playsinline aria-label="A lake between mountains, as the hours of a day pass"></video></div>`
        + '<figcaption>The lake of <a href="21_a_landscape.html">chapter 21</a>, from dawn until night.</figcaption></figure>';
}

// A page of docs/web/, with the text from README.md inserted.
function prepared(name) {
    const text = read(`${HERE}${name}.md`).replace('<div data-insert="where"></div>', () => whereFrom());
    const file = `${out}.parts/${name}.md`;
    fs.mkdirSync(path.dirname(file), {recursive: true});
    fs.writeFileSync(file, text);
    return file;
}

// ---- The whole site ----

// The letters that each font needs, {text, formula}. Browsers set single letters of a formula in italics by themselves.
function letters(pages) {
    const text = new Set(), formula = new Set('0123456789𝜕𝜖𝜗𝜙√'); // the radical sign is drawn, but is not in the text
    const add = (set, html) => { for (const letter of plain(html)) if (letter > ' ') set.add(letter); };
    for (const {body} of pages) {
        for (const [found] of body.matchAll(/<math.*?<\/math>/gs)) add(formula, found);
        add(text, body.replace(/<math.*?<\/math>|<pre.*?<\/pre>/gs, ''));
    }
    for (let code = 33; code < 127; code++) text.add(String.fromCharCode(code));
    for (const letter of [...formula]) {
        for (const [first, last, italic] of [['a', 'z', 0x1d44e], ['A', 'Z', 0x1d434], ['α', 'ω', 0x1d6fc], ['Α', 'Ω', 0x1d6e2]]) {
            if (letter >= first && letter <= last) formula.add(letter === 'h' ? 'ℎ' : String.fromCodePoint(italic + letter.codePointAt(0) - first.codePointAt(0)));
        }
    }
    return {text, formula};
}

// The feature ssty would make the fonts half as large again, and Chromium does not use that feature by itself.
async function writeFonts({text, formula}) {
    const write = (name, font, letters, features) => subset(font, letters, features, `${out}/fonts/${name}.woff2`);
    await write('formula', 'TeX Gyre Pagella Math', formula, 'kern');
    for (const style of ['Regular', 'Italic', 'Bold']) await write(style.toLowerCase(), `TeX Gyre Pagella:style=${style}`, text, 'kern,liga,tnum');
}

const [front, manual, play] = ['front', 'pages', 'play'].map(prepared);
const order = [front, files[0], manual, ...files.slice(1).filter((file) => /\/\d\d_/.test(file)), play, ...files.slice(1).filter((file) => !/\/\d\d_/.test(file))];
const pages = parted(await pagesOf(order));
const at = (address) => pages.find((page) => page.address === address);
at('index.html').body = at('index.html').body.replace('<div data-insert="film"></div>', film).replace('<div data-insert="gallery"></div>', gallery);
at('index.html').sections = sectionsOf(at('index.html').body);
at('play.html').body = at('play.html').body.replace('<div data-insert="play"></div>', drop);
fs.mkdirSync(`${out}/sheets/textures`, {recursive: true});
for (const page of pages) write(page, pages);
for (const file of texturesIn()) fs.writeFileSync(`${out}/${file}`, textureOf(file));

for (const file of sources.texts.keys()) {
    const address = `source/${file}.html`;
    fs.mkdirSync(path.dirname(`${out}/${address}`), {recursive: true});
    fs.writeFileSync(`${out}/${address}`, fill({
        root: root(file), kind: 'file', title: escaped(`${file} · ${TITLE}`), description: escaped(`${file}, a source file of the course`),
        contents: contents(pages, undefined, root(file)), body: sources.body(file),
    }));
}

// Servers show this page for an address that does not exist, at any depth, so its links begin with the site's path.
const {pathname} = new URL(ADDRESS, 'http://localhost');
fs.writeFileSync(`${out}/404.html`, fill({
    root: pathname, kind: 'file', title: escaped(`Not found · ${TITLE}`), description: 'There is no such page', contents: contents(pages, undefined, pathname),
    body: `<h1>There is no such page</h1>\n<p>The address may have been mistyped. The <a href="${pathname}index.html">front page</a> lists all chapters, and the field above searches all pages.</p>`,
}));

// The headings are loaded with the search field, and the texts, which take twenty times as long, with the first letter.
const index = pages.map(({address, title, sections}) => [address, title, sections.map(({id, html}) => [id, plain(html.replace(/<[^>]*>/g, ''))])]);
fs.writeFileSync(`${out}/search.js`, `searchIndex(${JSON.stringify(index)});\n`);
fs.writeFileSync(`${out}/search_text.js`, `searchText(${JSON.stringify(pages.flatMap(({sections}) => sections.map(({text}) => text)))});\n`);
await writeFonts(letters(pages));

fs.mkdirSync(`${out}/pictures`, {recursive: true});
const all = [...pictures].sort(), isDiagram = ([name]) => name.endsWith('.svg');
await writePictures(all.filter((one) => !isDiagram(one)), `${out}/pictures`);
await writeFigures(all.filter(isDiagram).map(([name, file]) => ({name, file})), `${out}/pictures`, `${out}.parts`);

const commands = pages.map(({body}) => [/class="run"/g, /class="reason"/g, /class="check"/g].map((each) => (body.match(each) ?? []).length))
    .reduce((sum, each) => sum.map((count, i) => count + each[i]));
console.log(`${pages.length} pages, ${sources.texts.size} files, ${pictures.size} pictures; commands: ${commands[0]} with a button, `
    + `${commands[2]} checks, ${commands[1]} with a reason`);
