// body.mjs - completes the HTML that pandoc and filter.lua make from a page: its formulas, listings, commands, pictures
// and tables.
import fs from 'node:fs';
import path from 'node:path';
import {coloured, escaped, plain, sizeOf} from './colour.mjs';
import {commandOf, isCommand, isFigure, piecesOf, pictureOf as commandOfPicture} from './commands.mjs';
import {nameOf, smallOf} from './pictures.mjs';
import {isSheet, parametersIn, sheetOf, valuesIn} from './sheets.mjs';

export const read = (file) => fs.readFileSync(file, 'utf8');
const temml = (await import(new URL('../../build/node/node_modules/temml/dist/temml.mjs', import.meta.url))).default;

// ---- Formulas ----

// Remove the markup that a browser does not need: default attributes of operators, and groups of one element.
function compact(mathml) {
    return mathml.replaceAll(' separator="true"', '').replaceAll(' fence="true"', '').replaceAll('></mspace>', '/>')
        .replace(/(?<=<mrow>|<math>)<mo form="prefix" stretchy="false">/g, '<mo stretchy="false">').replace(/<mo form="prefix" stretchy="false">(?=[([{⌈⌊])/g, '<mo stretchy="false">')
        .replace(/<mo form="postfix" stretchy="false">([^<]*<\/mo>)(?=<\/mrow>)/g, '<mo stretchy="false">$1')
        .replace(/<mo form="postfix" stretchy="false">(?=[)\]}⌉⌋])/g, '<mo stretchy="false">').replace(/<mo stretchy="false">(?=[−+±])/g, '<mo>')
        .replace(/<mrow>(<(m[in])(?: [^>]*)?>[^<]*<\/\2>)<\/mrow>/g, '$1').replace(/ class="tml-display" style="display:block math;"/, '')
        // Pagella's prime is already raised, so it is not set as a superscript.
        .replace(/<msup>(<(m[in])(?: [^>]*)?>[^<]*<\/\2>)<mo [^>]*tml-prime[^>]*>([^<]*)<\/mo><\/msup>/g, '<mrow>$1<mo lspace="0" rspace="0">$3</mo></mrow>');
}

// TeX puts no space around operators in a subscript or superscript, but browsers add some.
function tightened(mathml) {
    const open = []; // for each open element: whether it has scripts, whether it is in a script, its number of children
    return mathml.replace(/<(\/?)(\w+)([^>]*?)(\/?)>/g, (tag, end, name, attributes, empty) => {
        if (end) { open.pop(); return tag; }
        const parent = open.at(-1), inside = Boolean(parent && (parent.inside || (parent.script && parent.count > 0)));
        if (parent) parent.count++;
        if (!empty) open.push({script: /^msu/.test(name), inside, count: 0});
        return name === 'mo' && inside && !attributes ? '<mo lspace="0" rspace="0">' : tag;
    });
}

// The top-level elements of some MathML, each as a string.
function childrenOf(mathml) {
    const children = [];
    let depth = 0, from = 0;
    for (const tag of mathml.matchAll(/<(\/?)[^>]*?(\/?)>/g)) {
        if (depth === 0) from = tag.index;
        depth += tag[1] ? -1 : tag[2] ? 0 : 1;
        if (depth === 0) children.push(mathml.slice(from, tag.index + tag[0].length));
    }
    return children;
}

const ungrouped = (child) => child.startsWith('<mrow>') ? child.slice(6, -7) : child;
const UNSTYLED = / class="(?:tml-(?:prime|\w+-pad) ?)+"/g; // Temml's class names that site.css does not style
const LONG = 24; // an inline formula with more characters may not fit on one line of a phone

// If a displayed formula has several statements, separated by \qquad or by a comma and \quad, each becomes a separate
// <math>, so that a narrow page can place them below one another.
function statements(whole) {
    const [, open, inside] = /^(<math[^>]*>)(.*)<\/math>$/s.exec(whole);
    const all = childrenOf(inside), children = all.length === 1 && all[0].startsWith('<mrow>') ? childrenOf(ungrouped(all[0])) : all;
    const parts = [[]];
    for (const child of children) {
        if (child === '<mspace width="2em"/>' || (child === '<mspace width="1em"/>' && parts.at(-1).at(-1) === '<mo>,</mo>')) parts.push([]);
        else parts.at(-1).push(child);
    }
    return parts.length === 1 ? whole : parts.map((part) => `${open}<mrow>${part.join('')}</mrow></math>`).join('');
}

// A displayed formula that is wider than the page scrolls in its own box. A long inline formula may break after its
// operators: no browser breaks a <math>, so each part that TeX would not break becomes a separate <math>.
function mathml(tex, display) {
    const render = (wrap) => tightened(compact(temml.renderToString(tex, {displayMode: display, wrap, throwOnError: true}))).replace(UNSTYLED, '');
    const whole = render('none');
    if (display) return `<span class="formula">${statements(whole)}</span>`;
    const [, inside] = /^<math>(.*)<\/math>$/s.exec(whole);
    const children = childrenOf(inside);
    if (plain(inside).length <= LONG) return `<math>${children.length === 1 ? ungrouped(inside) : inside}</math>`;
    const parts = childrenOf(/^<math>(.*)<\/math>$/s.exec(render('tex'))[1]);
    return parts.every((part) => !part.startsWith('<mspace')) ? parts.map((part) => `<math>${ungrouped(part)}</math>`).join('') : `<math>${inside}</math>`;
}

// A column heading that is only a formula also gets a version in words, because screen readers expect text there.
const heads = (html) => html.replace(/<th([^>]*)><span class="math inline">\\\((.*?)\\\)<\/span><\/th>/gs, (whole, more, tex) => {
    const words = tex.replace(/\\[lr]vert/g, '|').replace(/\\sqrt\{([^}]*)\}/g, 'root of ($1)').replace(/\\(?:left|right|math\w+|[,;! ])/g, '').replace(/[\\{}]/g, '');
    return whole.replace(`<th${more}>`, `<th${more}><span class="unseen">${words.replace(/\s+/g, ' ').trim()}</span>`).replace('class="math inline"', 'aria-hidden="true" class="math inline"');
});

// Punctuation after an inline formula stays on the line of the formula.
const formulas = (html) => heads(html).replace(/<span (?:aria-hidden="true" )?class="math (inline|display)">\\[[(](.*?)\\[\])]<\/span>([.,;:)?!’”]?)/gs,
    (whole, kind, tex, sign) => mathml(plain(tex), kind === 'display').replaceAll('<math>', whole.includes('aria-hidden') ? '<math aria-hidden="true">' : '<math>') + (sign && kind === 'inline' ? `\u2060${sign}` : sign));

// ---- Listings and commands ----

const button = ({stem, line, still, other, head, tail}, command) => `<button type="button" class="run" data-stem="${stem}" data-line="${escaped(line)}"`
    + `${other ? ` data-other="${escaped(other)}"` : ''}${still ? ' data-still' : ''}${head ? ` data-head="${head}"` : tail ? ` data-tail="${tail}"` : ''} aria-label="Run ${escaped(command.replace(/\s+/g, ' '))}">Run</button>`;

function commandBlock({text, command}, i, pieces) {
    const listing = `<pre><code>${escaped(text).replace(/^#.*$| # .*$/gm, '<i class="c">$&</i>')}</code></pre>`;
    if (!command) return `<div class="command">${listing}</div>`;
    const above = (at) => pieces.slice(0, at).map((piece) => piece.command);
    const what = commandOf(command, above(i));
    if (what.check) {
        const exercise = what.check.replace('_', '-');
        return `<div class="command">${listing}<form class="check" data-exercise="${exercise}" data-stem="${what.stem}"><button type="submit" aria-label="Check exercise ${exercise}">Check</button> `
            + `<button type="button" class="answer" aria-label="Write your answer to exercise ${exercise}">Your answer</button></form></div>`;
    }
    if (!what.reason) return `<div class="command">${listing}${button(what, command)}</div>`;
    // If consecutive commands have the same reason, only the last one shows it.
    const next = pieces[i + 1]?.command, said = next && commandOf(next, above(i + 1)).reason === what.reason;
    return `<div class="command">${listing}<p class="reason"${said ? ' hidden' : ''}>For a terminal only: ${escaped(what.reason)}.</p></div>`;
}

const NARROW = 84; // how many characters of a listing fit into the width of the text column

// A listing, below the name of the file that it comes from, if there is one. The name links to the file's page, at the
// listing's first line.
function listing(language, text, file, symbol, sources) {
    const code = `<pre><code>${coloured(text, language)}</code></pre>`;
    const kind = text.split('\n').some((line) => line.length > NARROW) ? 'listing broad' : 'listing';
    if (!file) return `<div class="${kind}">${code}</div>`;
    const address = sources.place(file, text);
    const name = symbol === '*' ? '' : ` <span class="symbol">${escaped(symbol)}</span>`;
    return `<figure class="${kind}"><figcaption><a href="${address}">${escaped(file)}</a>${name}</figcaption>${code}</figure>`;
}

function blocks(html, sources) {
    return html.replace(/<pre(?: class="(\w+)")?([^>]*)><code>(.*?)<\/code><\/pre>/gs, (_, language, more, code) => {
        const text = plain(code).replace(/\n$/, '');
        if (language === 'sh') return `<div class="commands">${piecesOf(text).map(commandBlock).join('')}</div>`;
        return listing(language, text, /data-file="([^"]*)"/.exec(more)?.[1], plain(/data-symbol="([^"]*)"/.exec(more)?.[1] ?? ''), sources);
    });
}

// ---- Guesses and numbers in sentences ----

const GUESSES = read(new URL('guesses.txt', import.meta.url)).split('\n').filter((line) => line && !line.startsWith('#')).map((line) => {
    const [page, words, kind, ...right] = line.split('|').map((part) => part.trim());
    return {page, words, kind, right};
});

// The fields of the form below a question, and the form's attributes, which contain the right answer.
function fieldsOf({kind, right} = {}, pictures) {
    const choice = (text, i) => `<label><input type="radio" name="guess" value="${i}"> ${escaped(text.replace(/^\*/, ''))}</label>`;
    if (kind === 'choice') return {data: ` data-kind="choice" data-right="${right.findIndex((one) => one.startsWith('*'))}"`, fields: right.map(choice).join(' ')};
    if (kind === 'number') return {data: ` data-kind="number" data-right="${right[0]}"`, fields: '<label>Your guess: <input type="number" step="any" name="guess"></label>'};
    if (kind === 'tap') {
        const img = `<img ${pictureOf(`../tests/references/${right[0]}.png`, pictures)} alt="" loading="lazy" decoding="async">`;
        return {
            data: ` data-kind="tap" data-right="${right[1]}"`,
            fields: `<button type="button" class="tap" aria-label="Mark a point in the picture; the arrow keys move the mark">${img}<i hidden></i></button><input type="hidden" name="guess">`,
        };
    }
    return {data: '', fields: '<label>Your guess: <input name="guess" maxlength="200" autocomplete="off"></label>'};
}

// Insert a form below each question that begins with 'Predict.' and is followed by an answer. Commands may precede the
// answer.
const guesses = (html, stem, pictures) => html.replace(/(<p><em>Predict\.<\/em>)((?:(?!<\/p>).)*)(<\/p>)(?=\s*(?:<div class="commands">(?:(?!<details>|<h\d|<p>).)*)?<details>)/gs, (whole, begin, question, end) => {
    const words = plain(question.replace(/<[^>]*>/g, '')).replace(/\s+/g, ' ').trim();
    const {data, fields} = fieldsOf(GUESSES.find((one) => one.page === stem && words.startsWith(one.words)), pictures);
    return `${begin}${question}${end}<form class="guess"${data}>${fields} <button type="submit">Keep my guess</button> <output></output></form>`;
});

// The names of the parameters of a shader, including those of the files that it includes. Only parameters that are single
// numbers count.
function parametersOf(file, found = new Set(), seen = new Set()) {
    if (seen.has(file) || !fs.existsSync(file)) return found;
    seen.add(file);
    const text = read(file);
    for (const [, name] of text.matchAll(/^uniform (?:float|int) (\w+);\s*\/\//gm)) found.add(name);
    for (const [, name] of text.matchAll(/^#include "([^"]+)"/gm)) for (const folder of ['chapters', 'shaders']) parametersOf(`${folder}/${name}`, found, seen);
    return found;
}
const parametersOfLine = (stem, line = '') => parametersOf(/(?:--shader|-f)[ =](\S+)/.exec(line)?.[1] ?? `chapters/${stem}.frag`);

// A number that a reader can change, in a sentence: code such as `shadowOffset=0.25`, or a link with a value that its text
// contains, [12 steps](#most=12). After an @, a link names the picture that follows, [12 steps](#most=12@figure-march),
// or @chapter; otherwise the nearest picture follows that has the parameter, so each program's picture gets a note of what it has.
const scrub = (tag, text, name, value, at) => `<${tag} class="scrub" data-name="${name}"${at ? ` data-at="${at}"` : ''}>${text.replace(new RegExp(`(?<![\\w.−-])${value.replaceAll('.', '\\.').replace('-', '[−-]')}(?![\\w]|\\.\\d)`), `<data value="${value}">$&</data>`)}</${tag}>`;
function scrubs(html, stem) {
    const parameters = new Set([...parametersOf(`chapters/${stem}.frag`), ...parametersIn(html)]), used = new Set();
    const shown = html.replace(/<a href="#(\w+)=(-?\d+(?:\.\d+)?)(?:@([\w-]+))?">(.*?)<\/a>/gs, (whole, name, value, at, text) => {
        const number = parameters.has(name) ? scrub('span', text, name, value, at && at !== 'chapter' ? `${stem}-${at}` : at) : '';
        return number.includes('<data') ? number : whole;
    }).replace(/(?<!<pre>)<code>(\w+)=(-?\d+(?:\.\d+)?)<\/code>/g, (whole, name, value) => parameters.has(name) ? scrub('code', `${name}=${value}`, name, value) : whole);
    for (const [, name, at] of shown.matchAll(/ class="scrub" data-name="(\w+)"(?: data-at="([\w-]+)")?/g)) {
        used.add(name);
        if (at && at !== 'chapter' && !new RegExp(`<live-chapter[^>]*>(?:<figure-sheet[^>]*><div class="sheet-screen">)?<img src="pictures/${at}\\.`).test(html)) throw new Error(`docs/${stem}.md: a number that changes ${name} names ${at}, which the page does not show`);
    }
    return used.size === 0 ? shown : shown.replace(/<live-chapter(?: class="([^"]*)")? stem="(\w+)"(?: line="([^"]*)")?[^>]*/g, (whole, kind, own, line) => {
        const names = /\bhands\b/.test(kind) ? [] : [...parametersOfLine(own, plain(line ?? ''))].filter((name) => used.has(name));
        return names.length > 0 ? `${whole} numbers="${names.join(' ')}"` : whole;
    });
}

// Inline code is not broken across lines; in long code, only the options are kept whole. A command that can run in the
// page is followed by its button.
const LONG_CODE = 24;
const inline = (html) => html.replace(/(?<!<pre>)<code>([^<]*)<\/code>/g, (whole, code) => {
    const command = plain(code);
    const shown = command.length > LONG_CODE ? `<code class="long">${code.replace(/--\w[\w-]*/g, '<span>$&</span>')}</code>` : whole;
    const what = isCommand(command) ? commandOf(command) : {};
    return what.stem ? `<span class="command">${shown} ${button(what, command)}</span>` : shown;
});

// ---- Pictures, tables, links ----

// Add a picture to `pictures`, and return the attributes of its <img>. The source is relative to docs/.
function pictureOf(source, pictures) {
    const file = path.join('docs', source);
    const name = nameOf(file);
    pictures.set(name, file);
    const [width, height] = sizeOf(file);
    return `src="pictures/${name}" width="${width}" height="${height}"${width >= 600 ? ' class="wide"' : ''}`;
}

// A picture that a program has drawn becomes the running program when a reader clicks or taps it. An interactive figure
// needs no program; the program is there for its editor.
const images = (html, pictures) => html.replace(/<img src="(?!pictures\/)([^"]*)"([^>]*?) ?\/?>/g, (_, source, more) => {
    const img = `<img ${pictureOf(source, pictures)}${more} loading="lazy" decoding="async">`;
    const {stem, line, probe, step} = commandOfPicture(path.basename(source)) ?? {}, picture = path.basename(source, '.png');
    if (!stem) return img;
    return `<live-chapter class="in-place${isFigure(line) ? ' hands' : isSheet(picture, line) ? ' hands turned' : ''}" stem="${stem}"${line ? ` line="${escaped(line)}"` : ''}${probe ? ` probe="${probe}"` : ''}${step ? ` step="${step}"` : ''}>`
        + `${isSheet(picture, line) ? sheetOf(stem, line, picture, img) : img}</live-chapter>`;
});

// The first picture of a chapter becomes the poster of its program, which is not running yet. The page waits for this
// picture, so the gallery's smaller file is used.
const live = (html, stem, pictures) => html.replace(/<figure>\s*<img src="([^"]*)"([^>]*?) ?\/?>.*?<\/figure>/s, (_, source, more) => {
    const whole = pictureOf(source, new Map()), small = smallOf(source), poster = whole.replace(/pictures\/[^"]*"/, `pictures/${small}" fetchpriority="high"`);
    pictures.set(small, path.join('docs', source));
    return `<live-chapter stem="${stem}"><img ${poster}${more} decoding="async"></live-chapter>`;
});

// Is this a table of text with named columns? A narrow page shows such a table row by row.
function wordy(table) {
    const [head, ...rows] = table.split('</tr>').map((row) => [...row.matchAll(/<t[dh][^>]*>(.*?)<\/t[dh]>/gs)].map(([, cell]) => plain(cell).trim())).filter((row) => row.length > 0);
    return head.length > 2 && head[0] !== '' && rows.join('').length > 45 * rows.length;
}

// Each picture that is not part of a program or a question becomes a link to its file, so that a reader can enlarge it.
const enlarged = (html) => html.replace(/(<live-chapter[^>]*>|<div class="sheet-screen">|<button type="button" class="tap"[^>]*>)?(<img src="([^"]*)"[^>]*>)/g, (whole, inside, img, source) => inside ? whole : `<a class="picture" href="${source}">${img}</a>`);

// In a table of pictures, the cells share the width; a table of numbers scrolls if it is wider than the page.
const tables = (html) => html.replace(/<table>(.*?)<\/table>/gs, (whole, inside) => {
    const kind = /<td[^>]*>\s*<(?:img|live-chapter)/.test(inside) ? ' pictures' : wordy(inside) ? ' words' : '';
    const clean = inside.replace(/<tr class="[^"]*">/g, '<tr>').replace(/<th([^>]*)><\/th>/g, '<td$1></td>');
    return `<div class="table${kind}"><table>${clean}</table></div>`;
});

const links = (html, sources) => html.replace(/<a href="source:([^"#]*)(#[^"]*)?"([^>]*)>(.*?)<\/a>/gs, (_, file, id, more, text) => {
    const address = sources.place(file);
    return address ? `<a href="${address}"${more}>${text}</a>` : text;
});

// A link to a point of a figure on the page, [the ball](#ball), becomes a word that lights the point, and a link with a
// value, [12 steps](#most=12), one that sets a parameter.
function words(html) {
    const known = new Set(valuesIn(html)), ids = new Set([...html.matchAll(/\sid="([^"]*)"/g)].map(([, id]) => id));
    return html.replace(/<a href="#(\w+)(?:=([-\w.,]+))?">(.*?)<\/a>/gs, (whole, name, value, text) => ids.has(name) || !known.has(name) ? whole
        : `<button type="button" class="sheet-word" data-name="${name}"${value ? ` data-value="${value}"` : ''}>${text}</button>`);
}

// A command that opens a figure of the page in a window is left out, because the figure already runs.
const withoutRun = (html) => html.replace(/<div class="commands"><div class="command"><pre><code>make run FIGURE=(\w+)<\/code><\/pre><button[^>]*>Run<\/button><\/div><\/div>/g,
    (whole, name) => html.includes(`<figure-sheet name="${name}"`) ? '' : whole);

// The exercises tell how to work with files; in a page, nobody needs any.
const HERE = '<p class="note">Here you need no file: <em>Your answer</em>, below an exercise, opens a copy of its shader in this page, and <em>Check</em> compares it with the solution.</p>';
const withHere = (html) => html.includes('class="check"') ? html.replace(/<h2 id="exercises">.*?<\/h2>/s, (heading) => heading + HERE) : html;

// The body of a page from pandoc's HTML.
//   stem      the stem of the page's chapter; undefined if the page does not belong to a chapter
//   sources   the pages that show files of the project (sources.mjs)
//   pictures  receives the pictures that the page shows, a map from the name on the site to the file
export function bodyOf(html, {stem, sources, pictures}) {
    html = inline(blocks(formulas(html), sources));
    if (stem) html = live(guesses(html, stem, pictures), stem, pictures);
    html = withoutRun(links(images(html, pictures), sources));
    if (stem) html = scrubs(html, stem);
    html = withHere(words(html));
    html = tables(html).replaceAll(' />', '>');
    // Third-level headings above the first section become small second-level headings, so that no level is skipped.
    html = html.replace(/^.*?(?=<h2|$(?![^]))/s, (head) => head.replace(/<h3( [^>]*)>(.*?)<\/h3>/gs, '<h2 class="minor"$1>$2</h2>'));
    return enlarged(html);
}

// The sections of a body: [{level, id, html, lang, text}], where html is the content of the heading and text is the
// text below it.
export function sectionsOf(html) {
    const parts = html.split(/<h([1-3])((?: [\w-]+="[^"]*")*)>(.*?)<\/h\1>/s);
    const sections = [];
    for (let i = 1; i < parts.length; i += 4) {
        const words = parts[i + 3].replace(/<math.*?<\/math>|<pre.*?<\/pre>|<figcaption.*?<\/figcaption>|<button.*?<\/button>|<summary>.*?<\/summary>|<form.*?<\/form>|<p class="note">.*?<\/p>/gs, ' ')
            .replace(/<\/?(?:p|li|t[hdr]|div|h\d|[uo]l|br)\b[^>]*>/g, ' ');
        sections.push({
            level: Number(parts[i]), id: /id="([^"]*)"/.exec(parts[i + 1])[1], html: parts[i + 2],
            lang: /lang="(\w+)"/.exec(parts[i + 1])?.[1], text: plain(words).replace(/\s+/g, ' ').trim(),
        });
    }
    return sections;
}

