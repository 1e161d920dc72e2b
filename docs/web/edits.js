// edits.js - what a reader has changed in the course's files: kept in the browser, so that a reload loses nothing, and
// packed into an address, so that a link shows it to somebody else.
const HERE = `ray marching: changes in ${new URL('.', import.meta.url).pathname}`;
const MARK = '#edit=';
const NAME = /^(chapters|shaders)\/[\w./-]+\.(frag|glsl)$/; // what may be changed
const LONGEST = 1 << 20; // letters that an address may unpack to

// {NAME: TEXT} of what is kept.
export function kept() {
    try {
        return clean(JSON.parse(localStorage.getItem(HERE) || '{}'));
    } catch {
        return {}; // the browser keeps nothing
    }
}

// Keep a file's text, or with null nothing of it. Returns false where the browser keeps nothing.
export function keep(name, text) {
    const all = kept();
    if (text === null) delete all[name];
    else all[name] = text;
    try {
        if (Object.keys(all).length > 0) localStorage.setItem(HERE, JSON.stringify(all));
        else localStorage.removeItem(HERE);
        return true;
    } catch {
        return false;
    }
}

// Of files those that a command line shows, as far as its words tell: its shader, and the library.
export function shownBy(names, stem, line) {
    const shader = /--shader[ =](\S+)/.exec(line)?.[1] ?? `chapters/${stem}.frag`;
    return names.filter((name) => name === shader || name.startsWith('shaders/'));
}

// What a page says of files that are changed.
export const withChanges = (names) => `With your changes in ${names.join(', ')}.`;

function clean(files) {
    return Object.fromEntries(Object.entries(files ?? {}).filter(([name, text]) => NAME.test(name) && !name.includes('..') && typeof text === 'string'));
}

// ---- The address ----

async function through(stream, bytes, most = Infinity) {
    const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
    const parts = [];
    let size = 0;
    for (;;) {
        const {done, value} = await reader.read();
        if (done) break;
        parts.push(value);
        size += value.length;
        if (size > most) throw new Error('it is too long');
    }
    return new Uint8Array(await new Blob(parts).arrayBuffer());
}

// The fragment of an address that holds changes.
//   stem, line  of the program that shows them
//   files       {NAME: TEXT}
export async function pack(stem, line, files) {
    const bytes = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(JSON.stringify({stem, line, files})));
    let text = '';
    for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
    return MARK + btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

// What this page's address holds: {stem, line, files}, or null where it holds none.
export async function unpack(fragment = location.hash) {
    if (!fragment.startsWith(MARK)) return null;
    const text = atob(fragment.slice(MARK.length).replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = await through(new DecompressionStream('deflate-raw'), Uint8Array.from(text, (c) => c.charCodeAt(0)), LONGEST);
    const {stem, line, files} = JSON.parse(new TextDecoder().decode(bytes));
    return {stem: String(stem), line: String(line), files: clean(files)};
}

// Put changes into this page's address, or with '' take them out.
export function show(fragment) {
    if (fragment !== '' || location.hash.startsWith(MARK)) history.replaceState(null, '', fragment || location.pathname + location.search);
}
