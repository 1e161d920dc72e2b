// shadertoy.mjs FOLDER - draws the Shadertoy exports of a folder (its *.json files) with build/00_first_scene, and in
// Chromium with the text that Shadertoy itself puts around a shader, and compares the pictures, which have 96x54 pixels
// and no inputs but the time. A line for each export gives a verdict, the mean difference in 255ths, the file's name,
// and what the program says:
//
//   equal      the mean difference is at most 0.5
//   differs    it is larger
//   refused    the program refuses what Chromium draws
//   needs      a buffer, without which no picture is right: not counted
//   invalid    Chromium does not draw it either: not counted
//
// Succeeds if at least 98 % of those that Chromium draws are equal, and if no picture has one colour without a warning
// unless it has one colour in Chromium too. `make web` installs what it needs.
import {execFile} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {launch} from '../web/browser.mjs';

const WIDTH = 96, HEIGHT = 54, TIME = 1.3, EQUAL = 0.5, SHARE = 0.98, PATIENCE = 100e3; // milliseconds for a picture
const folder = process.argv[2], picture = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'shadertoy-')), 'picture.png');
const [before, behind] = fs.readFileSync('tests/lib/shadertoy.glsl', 'utf8').split('// ---- the shader ----\n');
const TYPES = {cubemap: 'samplerCube', volume: 'sampler3D'};

// The text that Shadertoy compiles for an export's image pass, or null if there is a buffer. As on the graphics cards of
// desktops, mediump and lowp are highp: Mesa's renderer for WebGL gives such numbers only 16 bits.
function textOf(json) {
    const [root] = [json].flat(), passes = (root.Shader ?? root).renderpass ?? [], one = (type) => passes.find((pass) => pass.type === type);
    if (!one('image') || passes.some(({type}) => !['image', 'common', 'sound'].includes(type))) return null;
    let head = before;
    for (const {channel, ctype, type} of one('image').inputs ?? []) head = head.replace(`sampler2D iChannel${channel};`, `${TYPES[ctype ?? type] ?? 'sampler2D'} iChannel${channel};`);
    return `${head}${one('common')?.code ?? ''}\n${one('image').code}\n${behind}`.replace(/\b(mediump|lowp)\b/g, 'highp');
}

// Draw a picture with the program. Returns {status, said}.
const drawn = (file) => new Promise((done) => {
    fs.rmSync(picture, {force: true});
    const {DISPLAY, WAYLAND_DISPLAY, ...env} = process.env;
    execFile('build/00_first_scene', ['-f', file, '-s', `${WIDTH}x${HEIGHT}`, '-t', TIME, '-o', picture], {timeout: PATIENCE, env: {...env, LIBGL_ALWAYS_SOFTWARE: '1', GALLIUM_DRIVER: 'llvmpipe'}},
        (error, stdout, said) => done({status: error ? error.code ?? 'late' : 0, said: said.trim().replaceAll(file, path.basename(file)).split('\n')[0]}));
});

// Run this in a page: draw a text with WebGL and compare it with a PNG. Returns {log} if WebGL refuses the text,
// otherwise the mean difference, if there is a PNG, and whether each picture has one colour.
async function compare({text, png, width, height, time}) {
    const canvas = Object.assign(document.createElement('canvas'), {width, height}), gl = canvas.getContext('webgl2', {alpha: false, antialias: false});
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, '#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }'], [gl.FRAGMENT_SHADER, text]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) return {log: gl.getShaderInfoLog(shader)};
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return {log: gl.getProgramInfoLog(program)};
    gl.useProgram(program);
    const at = (name) => gl.getUniformLocation(program, name);
    gl.uniform3f(at('iResolution'), width, height, 1);
    gl.uniform1f(at('iTime'), time);
    gl.uniform1f(at('iFrameRate'), 60);
    gl.uniform1f(at('iSampleRate'), 44100);
    gl.uniform4f(at('iDate'), 1970, 0, 1, time);
    for (let i = 0; i < 4; i++) gl.uniform1i(at(`iChannel${i}`), i); // samplers of different types need different units
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const own = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, own);
    const flat = (data) => data.every((c, i) => c === data[i % 4]);
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    if (!png) return {flat: flat(own)};
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(png)]), {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const other = context.getImageData(0, 0, width, height).data;
    let sum = 0;
    for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) for (let c = 0; c < 3; c++) sum += Math.abs(own[4 * ((height - 1 - y) * width + x) + c] - other[4 * (y * width + x) + c]);
    return {mean: sum / (3 * width * height), flat: flat(own), otherFlat: flat(other)};
}

let browser = null, page = null;
async function browsed(argument) {
    page ??= await (browser = await launch()).newPage();
    const late = new Promise((done) => setTimeout(() => done(null), PATIENCE).unref());
    const answer = await Promise.race([page.evaluate(compare, argument).catch(() => null), late]);
    if (answer) return answer;
    await browser.close().catch(() => {});
    page = null;
    return {log: 'Chromium does not answer'};
}

const count = {equal: 0, differs: 0, refused: 0, needs: 0, invalid: 0};
let silent = 0; // pictures of one colour without a warning, which have several in Chromium
for (const name of fs.readdirSync(folder).filter((name) => name.endsWith('.json')).sort()) {
    const file = path.join(folder, name), text = textOf(JSON.parse(fs.readFileSync(file, 'utf8')));
    const {status, said} = text === null ? {status: 1, said: ''} : await drawn(file);
    const png = status === 0 ? [...fs.readFileSync(picture)] : null;
    const answer = text === null ? {} : await browsed({text, png, width: WIDTH, height: HEIGHT, time: TIME});
    const verdict = text === null ? 'needs' : answer.log !== undefined ? 'invalid' : status !== 0 ? 'refused' : answer.mean <= EQUAL ? 'equal' : 'differs';
    const bare = verdict === 'differs' && answer.otherFlat && !answer.flat && said === '';
    count[verdict]++;
    silent += bare;
    console.log(`${verdict}\t${answer.mean?.toFixed(3) ?? '-'}\t${name}\t${bare ? 'one colour' : said || (answer.log ?? '').split('\n')[0]}`);
}
await browser?.close();
fs.rmSync(path.dirname(picture), {recursive: true});
const all = count.equal + count.differs + count.refused, share = all > 0 ? count.equal / all : 0;
console.log(`# ${Object.entries(count).map(([verdict, n]) => `${n} ${verdict}`).join(', ')}; ${(100 * share).toFixed(1)} % of those that Chromium draws are equal; ${silent} of one colour without a warning`);
process.exitCode = share >= SHARE && silent === 0 ? 0 : 1;
