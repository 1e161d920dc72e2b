// sheets.mjs - prepares the interactive figures of chapters/figures/ for a page: their elements, and the script with
// their shaders (sheet.js).
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {escaped} from './colour.mjs';
import {isFigure, wordsOf} from './commands.mjs';
import {DARK} from './figures.mjs';
import {shrink} from './shrink.mjs';

// The folder of the programs, which print the texts of the shaders.
const PROGRAMS = process.env.PROGRAM_FOLDER || 'build';

// ---- The pens ----

// The colours of the pens in shaders/figure.glsl, each as GLSL for a light page and for a dark one.
const OWN = {NIGHT: '#0d1433', CHALK: '#fffbf2', GLOW: '#fce1b8', SHADE: '#050608'}; // where figures.mjs has the colour of another pen
const PENS = /^const vec3 (?:[A-Z]+ = vec3\([^)]*\)(?:, )?)+;$/gm;
const hex = (numbers) => `#${numbers.map((x) => Math.round(255 * x).toString(16).padStart(2, '0')).join('')}`;
const short = (x) => String(Number(x.toFixed(3))).replace(/^0\./, '.');
function pensOf(text) {
    const found = {};
    for (const [line] of text.matchAll(PENS)) {
        for (const [, name, numbers] of line.matchAll(/([A-Z]+) = vec3\(([^)]*)\)/g)) {
            const light = numbers.split(',').map(Number), dark = OWN[name] ?? DARK[hex(light)];
            if (!dark) throw new Error(`shaders/figure.glsl: ${name} is ${hex(light)}, for which docs/web/figures.mjs has no dark colour`);
            found[name] = [light, [1, 3, 5].map((i) => parseInt(dark.slice(i, i + 2), 16) / 255)].map((colour) => colour.map(short).join());
        }
    }
    return found;
}
const pens = pensOf(fs.readFileSync('shaders/figure.glsl', 'utf8'));

// ---- Parameters ----

const PARAMETER = /^(?:\(([^)]*)\)|(true|false|-?[\d.e+-]+(?:, ?-?[\d.e+-]+)*))(?: in \[([^,]+),([^\]]+)\])?(?: step (\*?)([\d.e-]+))?,?( handle\b(?: x[yz]\b)?)?,?([^:]*): (.*)$/;

// The parameters that a printed shader declares, with their comments (common/shader/parameter.h).
function parametersOf(text) {
    return [...text.matchAll(/^uniform\s+(vec[234]|float|int|bool)\s+(\w+);\s*\/\/ (.*)$/gm)].map(([, type, name, comment]) => {
        const [, inside, plain, low, high, multiplies, step, handle, unit, meaning] = PARAMETER.exec(comment) ?? [];
        if (!meaning) throw new Error(`${name}: this comment is not understood: ${comment}`);
        const value = (inside ?? plain).split(',').map((one) => type === 'bool' ? Number(one === 'true') : Number(one)), size = Number(/\d/.exec(type)?.[0] ?? 1);
        const [minimum, maximum] = low ? [Number(low), Number(high)] : type === 'bool' ? [0, 1] : [-10, 10];
        return {
            name, type, value: value.length === size ? value : Array(size).fill(value[0]), minimum, maximum, multiplies: Boolean(multiplies) && minimum > 0,
            step: Number(step) || (type === 'int' ? 1 : (maximum - minimum) / 200), handle: Boolean(handle), unit: unit.trim(), meaning,
        };
    });
}

const texturesOf = (text) => [...text.matchAll(/^uniform sampler2D (\w+);\s*\/\/ "([^"]+)" (sRGB|linear) (repeat|clamp)/gm)]
    .map(([, name, file, colour, edge]) => ({name, file: `sheets/textures/${file.replace('.png', '.js')}`, srgb: colour === 'sRGB', repeat: edge === 'repeat'}));

// The script with a texture, sheets/textures/NAME.js. Its picture is without loss, because a figure shows numbers that it
// has computed from the texels: a loss that is hard to see moves the light of a cloud from 0.68 to 0.65.
export function textureOf(file) {
    const data = execFileSync('cwebp', ['-quiet', '-lossless', '-z', '6', '-exact', `shaders/textures/${path.basename(file, '.js')}.png`, '-o', '-'], {maxBuffer: 1 << 24});
    return `sheetParts.textures["${file}"]="data:image/webp;base64,${data.toString('base64')}";\n`;
}

// ---- A figure ----

// The camera, which the text contains as constants: its position and its axes, right, up and forward.
const CAMERA = /^const vec3 +(iCamera\w+) = vec3\(([^)]*)\);/gm;
const cameraOf = (text) => [...text.matchAll(CAMERA)].map(([, , numbers]) => numbers.split(',').map(Number));

// The functions of positions.glsl that find a point in space in the picture.
const projection = () => /^\/\/ The offset from a pixel.*?(?=^#endif)/ms.exec(fs.readFileSync('shaders/positions.glsl', 'utf8'))[0];

const printed = (file, stem, options = []) => execFileSync(`${PROGRAMS}/${stem}`, ['--root', '.', '--shader', file, ...options, '--print-shader=page'], {encoding: 'utf8'});

// What sheet.js needs to draw a figure.
//   file   the shader
//   stem   the chapter whose camera the figure has
//   turns  a reader turns it in space, so the camera becomes an input
function dataOf(file, stem, turns) {
    let text = printed(file, stem);
    const labels = [], found = parametersOf(text), textures = texturesOf(text), inSpace = found.some(({handle, type}) => handle && type === 'vec3');
    const axes = cameraOf(text).slice(1), isSheet = text.match(PENS)?.some((line) => /^const vec3 PAPER/.test(line));
    if (turns) text = text.replace(CAMERA, 'uniform vec3 $1;');
    // A number with a label is written by the page.
    text = text.replace(PENS, (line) => /[A-Z]+ =/.exec(line)[0].slice(0, -2) in pens ? '' : line).replace(/\bnumber\(\w[^,]*, (.*)\);\s*\/\/ (.*#.*)$/gm, (_, values, label) => `tell(${labels.push(label) - 1}, ${values});`);
    if (inSpace) text += projection();
    const {shader, names} = shrink(text, ['mainImage', ...(inSpace ? ['projectedPixel'] : [])]);
    const data = {shader, parameters: found.filter(({name}) => names.has(name)), labels, textures: textures.filter(({name}) => names.has(name)), axes: inSpace && axes, own: !isSheet};
    return Object.fromEntries(Object.entries(data).filter(([, value]) => value && value.length !== 0));
}

const all = new Map();

// The pictures that a reader turns in space, {NAME: {sliders, away}}.
const TURNED = new Map(fs.readFileSync(new URL('turned.txt', import.meta.url), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'))
    .map((line) => line.split('|').map((part) => part.trim())).map(([name, parameters, away]) => [name, {sliders: parameters.split(' ').filter(Boolean), away}]));

// Does a reader turn this picture in space, and does a page draw it without the program?
//   name  the name of the picture, without its ending
export const isTurned = (name) => TURNED.has(name);
export const isSheet = (name, line) => isFigure(line) || isTurned(name);

// The figure that a command line draws: {name, file, values, camera, data}, where values are those of the line's options,
// and camera is that of a figure that a reader turns.
function figureOf(stem, line, picture) {
    const words = wordsOf(line), after = (...options) => words.flatMap((word, i) => options.includes(words[i - 1]) ? [word] : []);
    const [file = `chapters/${stem}.frag`] = after('-f', '--shader'), name = file.replace(/.*\/|\.frag$/g, ''), turns = isTurned(picture);
    if (!all.has(name)) all.set(name, dataOf(file, stem, turns));
    return {name, file, values: after('-p', '--set'), time: after('-t', '--time')[0], camera: turns && cameraOf(printed(file, stem, after('-c', '--camera').flatMap((one) => ['--camera', one]))), data: all.get(name)};
}

// ---- Its element ----

const LINEAR = 1000; // the positions of a slider

function slider(one) {
    const {name, type, value, unit, meaning} = one, says = escaped(meaning + (unit ? `, in ${unit}` : '')), letters = /colour$/i.test(name) ? 'rgb' : 'xyz';
    if (type === 'bool') return `<label title="${says}"><input type="checkbox" data-name="${name}" data-component="0"><code>${name}</code></label>`;
    const most = type === 'int' ? one.maximum - one.minimum : one.multiplies ? LINEAR : Math.round((one.maximum - one.minimum) / Math.min(one.step, (one.maximum - one.minimum) / 100));
    return value.map((_, i) => `<label title="${says}"><code>${name}${value.length > 1 ? ` ${letters[i]}` : ''}</code><input type="range" min="0" max="${most}" data-name="${name}" data-component="${i}"><output></output></label>`)
        .slice(one.handle ? 2 : 0).join('');
}

// The element of a figure.
//   picture  the name of its picture, without the ending
//   img      the still picture
//   inPage   the page has the program, which a button opens in the editor
export function sheetOf(stem, line, picture, img, inPage = true) {
    const {name, file, values, time, camera, data} = figureOf(stem, line, picture), given = new Map(values.map((one) => one.split('=')));
    const [, width, height] = /width="(\d+)" height="(\d+)"/.exec(img);
    const points = (data.parameters ?? []).filter(({handle}) => handle).map(({name, type, value}) => {
        const [x, y] = given.get(name)?.split(',').map(Number) ?? value;
        return `<i class="sheet-point" data-name="${name}"${type === 'vec2' ? ` style="left:${(50 + 50 * x * height / width).toFixed(2)}%;top:${(50 - 50 * y).toFixed(2)}%"` : ' style="left:50%;top:50%" hidden'}></i>`;
    });
    const own = fs.readFileSync(file, 'utf8'), chosen = TURNED.get(picture); // the other parameters of a figure are those of the camera and of the march
    const sliders = (data.parameters ?? []).filter(({name, handle, type}) => (!handle || type === 'vec3') && (chosen ? chosen.sliders.includes(name) : new RegExp(`^uniform +\\w+ +${name};`, 'm').test(own))).map(slider);
    return `<figure-sheet name="${name}"${values.length > 0 ? ` values="${escaped(values.join(' '))}"` : ''}${camera ? ` camera="${camera.map((one) => one.map((x) => Number(x.toFixed(7)))).join(' ')}"${chosen?.away ? ` away="${chosen.away}"` : ''}` : ''}${time && chosen ? ` time="${time}"` : ''}><div class="sheet-screen">${img}${points.join('')}</div>`
        + `<div class="sheet-bar">${sliders.join('')}<span>${/\biTime\b/.test(data.shader) && !chosen ? '<button type="button" class="sheet-play">Play</button>' : ''}<button type="button" class="sheet-reset">Reset</button>`
        + `${inPage ? `<button type="button" class="sheet-edit">Edit</button>` : ''}</span></div></figure-sheet>`;
}

const namesIn = (html) => [...new Set([...html.matchAll(/<figure-sheet name="(\w+)"/g)].map(([, name]) => name))];

// The names of the parameters and points of a page's figures, and of those that are single numbers.
const valuesOf = (html) => namesIn(html).flatMap((name) => all.get(name).parameters);
export const valuesIn = (html) => valuesOf(html).map(({name}) => name);
export const parametersIn = (html) => valuesOf(html).filter(({type}) => type === 'float' || type === 'int').map(({name}) => name);

// The script with the figures of a page, or '' if the page has none.
//   alone  the page consists of a figure, and no sentence sets what no slider and no point sets
export function scriptOf(html, alone = false) {
    const names = namesIn(html);
    // Only what sheet.js reads: a number is a float unless a type is given, and only a point has a step and says its meaning.
    const known = (name) => !alone || html.includes(` data-name="${name}"`);
    const short = (key, one) => one?.type ? {
        name: one.name, type: one.type === 'float' ? undefined : one.type, value: one.value,
        ...known(one.name) && {minimum: one.minimum, maximum: one.maximum, multiplies: one.multiplies || undefined, unit: one.unit},
        ...one.handle && {step: one.step, meaning: one.meaning},
    } : one;
    return names.length > 0 ? `sheets=${JSON.stringify({colours: names.every((name) => all.get(name).own) ? {} : pens, ...Object.fromEntries(names.map((name) => [name, all.get(name)]))}, short)};\n` : '';
}

// The scripts with the textures that all figures read.
export const texturesIn = () => new Set([...all.values()].flatMap(({textures = []}) => textures.map(({file}) => file)));

// The files that a page loads before sheet.js.
//   script  the script with the page's figures
export const partsOf = (html, script) => [
    ...(/class="sheet-word"/.test(html) || /"textures":|\biSigns\b/.test(script) ? ['sheet_parts.js'] : []),
    ...(/<figure-sheet[^>]* camera=/.test(html) || script.includes('"axes":') ? ['sheet_space.js'] : []),
];
