// dropped.js - several files at once on the Play page: the files of a dropped folder, and the text of a shader with the
// parts that it includes.

const COUNT = 1000; // the maximum number of files that are read from dropped folders

// All files of a drop or of a file field, as a list of {path, file}. Call it within the event, after which the browser
// forgets what was dropped.
export async function gather({items, files}) {
    const found = [], waiting = [...items ?? []].map((item) => item.webkitGetAsEntry?.()).filter((entry) => entry);
    if (waiting.length === 0) return [...files].map((file) => ({path: `/${file.name}`, file}));
    const told = (entry, what) => new Promise((right, wrong) => entry[what](right, wrong));
    while (waiting.length > 0 && found.length < COUNT) {
        const entry = waiting.shift();
        if (entry.isFile) {
            found.push({path: entry.fullPath, file: await told(entry, 'file')});
            continue;
        }
        const reader = entry.createReader();
        for (let more; (more = await told(reader, 'readEntries')).length > 0;) waiting.push(...more);
    }
    return found.sort((a, b) => a.path < b.path ? -1 : 1);
}

const INCLUDE = /^([ \t]*#[ \t]*include[ \t]*"([^"\n]+)".*)$/gm;

// The file that an include names, of several files whose texts are given by their paths: first the one at that path, then
// one with that name, because files that were chosen without their folders have no other. Returns undefined if none does.
function named(texts, from, name) {
    const path = decodeURIComponent(new URL(encodeURI(name), `file://${encodeURI(from)}`).pathname);
    const base = path.replace(/.*\//, '/');
    return path in texts ? path : Object.keys(texts).find((one) => one.endsWith(base));
}

// The text of a file with those that it includes. As in the program, each is inserted once, and the line that includes it
// stays as a comment.
function joined(texts, path, done = new Set([path])) {
    return texts[path].replace(INCLUDE, (line, whole, name) => {
        const part = named(texts, path, name), first = part !== undefined && !done.has(part);
        if (first) done.add(part);
        return part === undefined ? line : first ? `// ${whole}\n${joined(texts, part, done)}` : `// ${whole}`;
    });
}

// The shaders among several files, as a list of {path, text}: those that define main or mainImage, and that no other file
// includes; or all files if there is none.
export function shaders(texts) {
    const paths = Object.keys(texts), parts = new Set();
    for (const path of paths) for (const [, , name] of texts[path].matchAll(INCLUDE)) parts.add(named(texts, path, name));
    const own = paths.filter((path) => !parts.has(path) && (paths.length === 1 || /\bmain(Image)?\b|\bpixelRay\b/.test(texts[path])));
    return (own.length > 0 ? own : paths).map((path) => ({path, text: joined(texts, path)}));
}
