// site.mjs OUT PAGE... - the pages of docs/ as a static site: `make site` calls it after the module is built.
//   OUT   the folder, which is there
//   PAGE  pages in the order of reading
// Beside them it writes the front page, Play, the files that pages link to, what search.js reads, the pictures, and the
// fonts. OUT.parts/ is for what comes between.
import {execFile} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {promisify} from 'node:util';
import {bodyOf, read, sectionsOf} from './body.mjs';
import {escaped, plain} from './colour.mjs';
import {writeFigures} from './figures.mjs';
import {subset} from './fonts.mjs';
import {Sources, root} from './sources.mjs';

const run = promisify(execFile);
const [out, ...files] = process.argv.slice(2);
const HERE = 'docs/web/';
const TITLE = 'Ray marching, step by step';
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
        page.body = bodyOf(stdout, {stem: name === 'front' ? '00_first_scene' : stem, sources, pictures}).replace(/(<h1[^>]*>)(\d\d) /, '$1<span class="number">$2</span> ');
        page.body = hinted(page);
    } catch (error) {
        throw new Error(`${file}: ${error.message}`, {cause: error});
    }
    page.sections = sectionsOf(page.body);
    return page;
}

// Some at a time: pandoc takes a processor for each.
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

// Below a chapter's program: a page speaks of a terminal, and its reader has none.
const HERE_TOO = '<p class="note">You need no terminal here: <b>Run</b> does what the command beside it says, <b>Edit</b>, below the picture, changes its shader. '
    + '<a href="index.html#in-these-pages">How these pages work</a></p>';
const hinted = (page) => page.stem ? page.body.replace(/<\/live-chapter>(?:\s*<div class="commands">.*?<\/button><\/div><\/div>)?/s, (program) => `${program}\n${HERE_TOO}`) : page.body;

// ---- Proofs ----

// A page has at most 150 KB of text, with what stands around it: a telephone loads and lays out no more in good time. The
// proofs of a heavier one are a page beside it.
const HEAVY = 140e3;

const idsOf = (html) => new Set([...html.matchAll(/\sid="([^"]*)"/g)].map(([, id]) => id));

// The page of a heavy page's proofs, which keeps a list of them; nothing for a page that is light.
function proofsOf(page) {
    if (Buffer.byteLength(page.body) <= HEAVY) return undefined;
    const [whole, heading, body] = /(<h2 id="proofs">.*?<\/h2>)(.*?)(?=<h2|$(?![^]))/s.exec(page.body) ?? [];
    if (!whole) throw new Error(`${page.address}: ${Buffer.byteLength(page.body)} bytes, and no proofs to take out`);
    const address = page.address.replace('.html', '-proofs.html');
    const items = [...body.matchAll(/<h3 id="([^"]*)">(.*?)<\/h3>/gs)].map(([, id, title]) => `<li><a href="${address}#${id}">${title.replace(/<\/?a[^>]*>/g, '')}</a></li>`);
    page.body = page.body.replace(whole, () => `${heading}<p>They are <a href="${address}">a page of their own</a>:</p><ul>${items.join('')}</ul>`);
    return {
        address, of: page, title: `${page.title}: proofs`, stem: page.stem,
        body: `<h1 id="${page.stem}-proofs">${page.title.replace(/^\d\d /, '<span class="number">$&</span>')}: proofs</h1>\n<p>What <a href="${page.address}">the chapter</a> states, proved.</p>\n`
            + body.replace(/<(\/?)h([34])/g, (_, end, level) => `<${end}h${level - 1}`),
    };
}

// Put the pages of proofs behind those that they belong to, and lead every link to where its place is now.
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

// ---- What stands around a page ----

// The parts of the course as docs/README.md has them: [{name, from, to}], by the numbers of chapters.
const parts = [...read('docs/README.md').matchAll(/^\| (I+) \| (\d\d) to (\d\d) \|/gm)].map(([, name, from, to]) => ({name: `Part ${name}`, from, to}));
const partOf = (page) => page.stem && parts.find(({from, to}) => page.stem.slice(0, 2) >= from && page.stem.slice(0, 2) <= to);
const BUILDING = ['teaching', 'architecture', 'contributing'];

function groupOf(page) {
    if (page.stem) return partOf(page)?.name ?? 'Chapters';
    const name = path.basename(page.address, '.html');
    return ['index', 'reading', 'play'].includes(name) ? '' : BUILDING.includes(name) ? 'To teach and to build on' : 'To look things up';
}

const short = (page) => page.address === 'index.html' ? 'Front page' : page.title;
const numbered = (title) => escaped(title).replace(/^(\d\d) /, '<span class="number">$1</span> ');

function contents(pages, here, up = '') {
    const groups = Map.groupBy ? Map.groupBy(pages, groupOf) : pages.reduce((map, page) => map.set(groupOf(page), [...map.get(groupOf(page)) ?? [], page]), new Map());
    return [...groups].map(([name, group]) => `${name ? `<h2>${name}</h2>` : ''}<ul>${group.map((page) =>
        `<li${page.of ? ' class="under"' : ''}><a href="${up}${page.address}"${page === here ? ' aria-current="page"' : ''}>${page.of ? 'Proofs' : numbered(short(page))}</a></li>`)
        .join('')}</ul>`).join('\n');
}

// The sections at the right: those of a section only where it is being read.
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
    // Who reads the chapters in order goes past a page of proofs; from there the chapter is before.
    const i = pages.indexOf(page), before = pages.slice(0, i).findLast(({of}) => !of), after = pages.slice(i + 1).find(({of}) => !of);
    if (i < 0 || (!before && !after)) return '';
    return `<nav class="turn" aria-label="Previous and next page">${before ? `<a rel="prev" href="${before.address}"><small>Previous</small> ${numbered(short(before))}</a>` : '<span></span>'}`
        + `${after ? `<a rel="next" href="${after.address}"><small>Next</small> ${numbered(short(after))}</a>` : ''}</nav>`;
}

function fill(values) {
    return template.replace(/\{\{(\w+)\}\}/g, (_, name) => values[name] ?? '');
}

function write(page, pages) {
    const list = page.sections.length > 3 ? sectionList(page) : '';
    const alive = /<live-chapter|class="run"/.test(page.body);
    const first = /<p>(.*?)<\/p>/s.exec(page.body)?.[1] ?? '';
    const words = plain(first.replace(/<math.*?<\/math>/gs, '…')).replace(/\s+/g, ' ');
    fs.writeFileSync(`${out}/${page.address}`, fill({
        root: '', kind: page.stem ? 'chapter' : page.address.replace('.html', ''),
        title: escaped(page.address === 'index.html' ? TITLE : `${page.title} · ${TITLE}`),
        description: escaped(words.length > 155 ? `${words.slice(0, words.lastIndexOf(' ', 155))} …` : words),
        head: alive ? '\n<link rel="stylesheet" href="live.css">\n<script type="module" src="live.js"></script>' + (page.address === 'play.html' ? '\n<script type="module" src="play.js"></script>' : '') : '',
        menu: list ? '<button type="button" class="menu at" popovertarget="sections">Sections</button>\n' : '',
        contents: contents(pages, page), body: page.body,
        note: alive ? '<noscript><p class="note">Without JavaScript the programs stand still; text, formulas and pictures are all here.</p></noscript>\n' : '',
        sections: list ? `<nav id="sections" class="sections" aria-label="On this page" popover>\n<h2>On this page</h2><ul>${list}</ul>\n</nav>` : '',
        turn: turn(pages, page),
    }));
}

// ---- The front page and Play ----

// The table of README.md's chapters: picture, its words, page, title, what you can do afterwards.
const rows = () => [...read('README.md').matchAll(/^\| !\[([^\]]*)\]\(([^)]*)\) \| \[([^\]]*)\]\(docs\/([^)]*)\.md\) \| (.*) \|$/gm)]
    .map(([, alt, picture, title, stem, can]) => ({alt, picture, title, stem, can}));

function gallery() {
    const card = ({alt, picture, title, stem, can}) => {
        const name = path.basename(picture).replace('-smooth.png', '.webp');
        pictures.set(name, picture);
        return `<li><a href="${stem}.html"><img src="pictures/${name}" alt="${escaped(alt)}" width="640" height="360" loading="lazy" decoding="async">`
            + `<strong>${numbered(title)}</strong></a><p>${escaped(can[0].toUpperCase() + can.slice(1))}.</p></li>`;
    };
    const all = rows();
    return parts.map(({name, from, to}) => `<h3 id="${name.toLowerCase().replace(' ', '-')}">${name}</h3>\n<ul class="gallery">${all.filter(({stem}) =>
        stem.slice(0, 2) >= from && stem.slice(0, 2) <= to).map(card).join('\n')}</ul>`).join('\n');
}

// README.md's own section, seen from docs/.
function whereFrom() {
    const section = /^## Where it comes from\n(.*?)(?=\nHow the house is built|\n## |$(?![^]))/ms.exec(read('README.md'))[0];
    return section.replaceAll('](docs/', '](').trim();
}

const drop = (poster) => `<div class="drop"><p><label for="file">Choose a file, or drop one here:</label> <input type="file" id="file" accept=".frag,.glsl,.fs,.txt"></p>`
    + `<live-chapter stem="00_first_scene" play><img ${poster}></live-chapter><p><button type="button" class="export" disabled>Export for Shadertoy</button> <span class="said" role="status"></span></p></div>`;

// A page of docs/web/ with what the project says elsewhere put in.
function prepared(name) {
    const text = read(`${HERE}${name}.md`).replace('<div data-insert="where"></div>', () => whereFrom());
    const file = `${out}.parts/${name}.md`;
    fs.mkdirSync(path.dirname(file), {recursive: true});
    fs.writeFileSync(file, text);
    return file;
}

// ---- All ----

// The letters that each font needs, {text, formula}: a browser makes single letters of a formula italic by itself.
function letters(pages) {
    const text = new Set(), formula = new Set('0123456789𝜕𝜖𝜗𝜙√'); // a root's sign is drawn, and stands in no text
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

// ssty, half as much again, is what no browser asks for by itself.
async function writeFonts({text, formula}) {
    const write = (name, font, letters, features) => subset(font, letters, features, `${out}/fonts/${name}.woff2`);
    await write('formula', 'TeX Gyre Pagella Math', formula, 'kern');
    for (const style of ['Regular', 'Italic', 'Bold']) await write(style.toLowerCase(), `TeX Gyre Pagella:style=${style}`, text, 'kern,liga,tnum');
}

const front = prepared('front'), play = prepared('play');
const order = [front, files[0], ...files.slice(1).filter((file) => /\/\d\d_/.test(file)), play, ...files.slice(1).filter((file) => !/\/\d\d_/.test(file))];
const pages = parted(await pagesOf(order));
const at = (address) => pages.find((page) => page.address === address);
at('index.html').body = at('index.html').body.replace('<div data-insert="gallery"></div>', gallery);
at('index.html').sections = sectionsOf(at('index.html').body);
at('play.html').body = at('play.html').body.replace('<div data-insert="play"></div>',
    drop(/<live-chapter[^>]*><img ([^>]*)>/.exec(at('00_first_scene.html').body)[1]));
for (const page of pages) write(page, pages);

for (const file of sources.texts.keys()) {
    const address = `source/${file}.html`;
    fs.mkdirSync(path.dirname(`${out}/${address}`), {recursive: true});
    fs.writeFileSync(`${out}/${address}`, fill({
        root: root(file), kind: 'file', title: escaped(`${file} · ${TITLE}`), description: escaped(`${file}, a source of the course`),
        contents: contents(pages, undefined, root(file)), body: sources.body(file),
    }));
}

const index = pages.map(({address, title, sections}) => [address, title, sections.map(({id, html, text}) => [id, plain(html.replace(/<[^>]*>/g, '')), text])]);
fs.writeFileSync(`${out}/search.js`, `searchIndex(${JSON.stringify(index)});\n`);
await writeFonts(letters(pages));

fs.mkdirSync(`${out}/pictures`, {recursive: true});
const small = [], figures = [];
for (const [name, file] of [...pictures].sort()) {
    if (name.endsWith('.svg')) figures.push({name, file});
    else if (name.endsWith('.webp')) small.push(run('cwebp', ['-quiet', '-q', '82', '-m', '6', file, '-o', `${out}/pictures/${name}`]));
    else fs.copyFileSync(file, `${out}/pictures/${name}`);
}
await Promise.all(small);
await writeFigures(figures, `${out}/pictures`, `${out}.parts`);

const commands = pages.map(({body}) => [/class="run"/g, /class="reason"/g, /class="check"/g].map((each) => (body.match(each) ?? []).length))
    .reduce((sum, each) => sum.map((count, i) => count + each[i]));
console.log(`${pages.length} pages, ${sources.texts.size} files, ${pictures.size} pictures; commands: ${commands[0]} with a button, `
    + `${commands[2]} checks, ${commands[1]} with a reason`);
