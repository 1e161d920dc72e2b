// colour.mjs - turns listings into coloured HTML, using the same grammars as the page's editor.
import fs from 'node:fs';

const modules = new URL('../../build/node/node_modules/', import.meta.url);
const {StreamLanguage} = await import(new URL('@codemirror/language/dist/index.js', modules));
const {c, shader} = await import(new URL('@codemirror/legacy-modes/mode/clike.js', modules));
const {shell} = await import(new URL('@codemirror/legacy-modes/mode/shell.js', modules));
const {highlightCode, tagHighlighter, tags} = await import(new URL('@lezer/highlight/dist/index.js', modules));

const LANGUAGES = Object.fromEntries(Object.entries({c, glsl: shader, sh: shell}).map(([name, mode]) => [name, StreamLanguage.define(mode)]));
const CLASSES = tagHighlighter([
    {tag: tags.comment, class: 'c'}, {tag: tags.meta, class: 'm'}, {tag: tags.keyword, class: 'k'}, {tag: tags.typeName, class: 't'},
    {tag: tags.standard(tags.name), class: 'b'}, {tag: tags.number, class: 'n'}, {tag: tags.string, class: 's'}, {tag: tags.atom, class: 'n'},
]);

export const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
export const plain = (html) => html.replace(/<[^>]*>/g, '').replace(/&#(\d+);/g, (_, code) => String.fromCodePoint(code)).replaceAll('&lt;', '<')
    .replaceAll('&gt;', '>').replaceAll('&quot;', '"').replaceAll('&amp;', '&');

// The HTML of a listing. Neighbouring pieces of one colour are joined, so that screen readers read them as one word.
export function coloured(text, name) {
    const language = LANGUAGES[name];
    if (!language) return escaped(text);
    const pieces = [];
    const put = (part, style) => {
        if (pieces.length > 0 && pieces.at(-1).style === style) pieces.at(-1).part += part;
        else pieces.push({part, style});
    };
    highlightCode(text, language.parser.parse(text), CLASSES, put, () => put('\n', ''));
    return pieces.map(({part, style}) => style ? `<i class="${style}">${escaped(part)}</i>` : escaped(part)).join('');
}

export function languageOf(file) {
    return /\.(frag|glsl|vert)$/.test(file) ? 'glsl' : /\.[ch]$/.test(file) ? 'c' : /\.sh$|\.ci\/run$/.test(file) ? 'sh' : 'text';
}

// The width and height of a PNG or SVG file.
export function sizeOf(file) {
    if (file.endsWith('.svg')) return /<svg[^>]* width="(\d+)" height="(\d+)"/.exec(fs.readFileSync(file, 'utf8')).slice(1, 3);
    const data = fs.readFileSync(file);
    return [data.readUInt32BE(16), data.readUInt32BE(20)];
}
