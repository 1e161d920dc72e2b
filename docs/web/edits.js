// edits.js - stores a reader's changes to the course's files in the browser, so that a reload loses nothing, and packs
// the changes into an address, so that a link shows them to somebody else.
const HERE = `ray marching: changes in ${new URL('.', import.meta.url).pathname}`;
const MARK = '#edit=';
const NAME = /^(chapters|shaders)\/[\w./-]+\.(frag|glsl)$/; // the files that may be changed
const LONGEST = 1 << 20; // the maximum size of unpacked changes, in bytes

// The file of a reader's answer to an exercise, "03_2". It begins as a copy of the chapter's shader.
export const draftOf = (exercise) => `chapters/exercises/${exercise}/my.frag`;
export const exerciseOf = (name) => /^chapters\/exercises\/(\d\d_\d+)\/my\.frag$/.exec(name)?.[1];

// Does a storage event report that another tab has changed or cleared the stored files?
export const isOurs = (event) => event.key === HERE || event.key === null;

// The stored files, {NAME: TEXT}.
export function kept() {
    try {
        return clean(JSON.parse(localStorage.getItem(HERE) || '{}'));
    } catch {
        return {}; // the browser refuses access, or the stored text is malformed
    }
}

// Store a file's text; null removes it. Returns false if the browser stores nothing.
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

// Select the files that the picture of a command line may show: its shader, and all files of the library, because the
// options do not tell which of those the shader includes.
export function shownBy(names, stem, line) {
    const shader = /--shader[ =](\S+)/.exec(line)?.[1] ?? `chapters/${stem}.frag`;
    return names.filter((name) => name === shader || name.startsWith('shaders/'));
}

// The note on a page about changed files.
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
        if (size > most) throw new Error('they are too long');
    }
    return new Uint8Array(await new Blob(parts).arrayBuffer());
}

// Pack changes into the fragment of an address.
//   stem, line  the program that shows them, and its command line
//   files       {NAME: TEXT}
export async function pack(stem, line, files) {
    const bytes = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(JSON.stringify({stem, line, files})));
    let text = '';
    for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
    return MARK + btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

// The changes in this page's address: {stem, line, files}, or null if there are none.
export async function unpack(fragment = location.hash) {
    if (!fragment.startsWith(MARK)) return null;
    const text = atob(fragment.slice(MARK.length).replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = await through(new DecompressionStream('deflate-raw'), Uint8Array.from(text, (c) => c.charCodeAt(0)), LONGEST);
    const {stem, line, files} = JSON.parse(new TextDecoder().decode(bytes));
    return {stem: String(stem), line: String(line), files: clean(files)};
}

// Put changes into this page's address; '' removes them.
export function show(fragment) {
    if (fragment !== '' || location.hash.startsWith(MARK)) history.replaceState(null, '', fragment || location.pathname + location.search);
}
