// pack.mjs OUT - packs the files of the course, whose names are the lines of standard input, for a browser.
// OUT/course.json contains the texts of the files that many chapters need. The other files are copied into OUT/course/, to
// be loaded when a command line needs them: course.json lists their names (`later`), and which of them each shader needs
// (`needs`), so that a page can request all of them at once.
import fs from 'node:fs';
import path from 'node:path';

const MANY = 5; // chapters that need a file
const [out] = process.argv.slice(2), names = fs.readFileSync(0, 'utf8').trim().split('\n');
const known = new Set(names), isShader = (name) => name.endsWith('.frag');

// The files that a file names, in the order of common/shader/expand.c: beside it, in shaders/ and in chapters/.
function namedBy(name) {
    if (name.endsWith('.png')) return [];
    const text = fs.readFileSync(name, 'utf8');
    const included = [...text.matchAll(/^#include "([^"]+)"/gm)].map(([, one]) => [path.dirname(name), 'shaders', 'chapters'].map((folder) => path.join(folder, one)).find((file) => known.has(file)));
    const textures = [...text.matchAll(/^uniform u?sampler2D .*\/\/ "([^"]+)"/gm)].map(([, one]) => `shaders/textures/${one}`);
    return [...included, ...textures].filter((file) => known.has(file));
}

// A file and all files that it needs.
function neededBy(name) {
    const all = new Set([name]);
    for (const one of all) for (const other of namedBy(one)) all.add(other); // grows while it is read
    return all;
}

const needed = new Map(names.filter(isShader).map((name) => [name, neededBy(name)]));
const chapters = [...needed].filter(([name]) => /^chapters\/\d\d_/.test(name)).map(([, files]) => files);
const isCommon = (name) => name.endsWith('.vert') || (name.startsWith('shaders/') && !name.endsWith('.png') && chapters.filter((files) => files.has(name)).length >= MANY);
const later = names.filter((name) => !isCommon(name));
const needs = Object.fromEntries([...needed].map(([name, files]) => [name, [...files].map((file) => later.indexOf(file)).filter((i) => i >= 0)]));
fs.writeFileSync(`${out}/course.json`, JSON.stringify({files: Object.fromEntries(names.filter(isCommon).map((name) => [name, fs.readFileSync(name, 'utf8')])), later, needs}));
for (const name of later) {
    fs.mkdirSync(`${out}/course/${path.dirname(name)}`, {recursive: true});
    fs.copyFileSync(name, `${out}/course/${name}`);
}
