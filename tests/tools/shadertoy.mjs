// shadertoy.mjs FOLDER - draws the Shadertoy exports of a folder (its *.json files) with build/00_first_scene, and in
// Chromium with the text that Shadertoy itself puts around a shader, in the order in which it draws buffers, and compares
// the pictures, which have 96x54 pixels and no inputs but the time; of exports with buffers, frame 60. A line for each
// export gives a verdict, the mean difference in 255ths, the share of pixels that differ by more than one, the number of
// passes, the file's name, and what the program says:
//
//   equal      the mean difference is at most 0.5; with buffers, at most 1 % of the pixels differ by more than one
//   differs    it is larger
//   refused    the program refuses what Chromium draws
//   needs      a cube map that a pass draws: not counted
//   invalid    Chromium does not draw it either: not counted
//
// Succeeds if at least 98 % of those that Chromium draws are equal, 95 % of those with buffers, and if no picture has one
// colour without a warning unless it has one colour in Chromium too. `make web` installs what it needs.
import {execFile} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {launch} from '../web/browser.mjs';

const WIDTH = 96, HEIGHT = 54, TIME = 1.3, EQUAL = 0.5, SHARE = 0.98, PATIENCE = 300e3; // milliseconds for a picture
const FRAME = 60, OFF = 0.01, KEPT_SHARE = 0.95; // of exports with buffers
const folder = process.argv[2], picture = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'shadertoy-')), 'picture.png');
const [before, behind] = fs.readFileSync('tests/lib/shadertoy.glsl', 'utf8').split('// ---- the shader ----\n');
const TYPES = {cubemap: 'samplerCube', volume: 'sampler3D'};

// The passes of an export in the order in which Shadertoy draws them, the picture last: {text, reads, keeps}, where
// keeps is the index of the buffer that a pass draws, and reads lists which buffer a channel reads, how, and the place
// of the pass in the file (at). Returns null if a cube map is drawn. As on the graphics cards of desktops, mediump and
// lowp are highp: Mesa's renderer for WebGL gives such numbers only 16 bits.
function passesOf(json) {
    const [root] = [json].flat(), row = (root.Shader ?? root).renderpass ?? [], all = (type) => row.filter((pass) => pass.type === type);
    if (all('image').length === 0 || row.some(({type}) => !['buffer', 'image', 'common', 'sound'].includes(type))) return null;
    const ids = [...new Set(all('buffer').map(({outputs}) => String(outputs[0].id)))];
    return [...all('buffer'), all('image')[0]].map((pass) => {
        const {type, code, inputs, outputs} = pass;
        let head = before;
        for (const {channel, ctype, type} of inputs ?? []) head = head.replace(`sampler2D iChannel${channel};`, `${TYPES[ctype ?? type] ?? 'sampler2D'} iChannel${channel};`);
        const end = type === 'buffer' ? behind.replace('vec4(0.0, 0.0, 0.0, 1.0)', 'vec4(0.0)').replace('vec4(c.rgb, 1.0)', 'c') : behind;
        return {text: `${head}${all('common')[0]?.code ?? ''}\n${code}\n${end}`.replace(/\b(mediump|lowp)\b/g, 'highp'),
            keeps: type === 'buffer' ? ids.indexOf(String(outputs[0].id)) : -1,
            reads: (inputs ?? []).filter((input) => (input.ctype ?? input.type) === 'buffer').map(({channel, id, sampler}) => ({channel, buffer: ids.indexOf(String(id)), at: row.indexOf(pass), ...sampler}))};
    });
}

// Draw a picture with the program. Returns {status, said}.
//   options  that choose the time or the frame
const drawn = (file, options) => new Promise((done) => {
    fs.rmSync(picture, {force: true});
    const {DISPLAY, WAYLAND_DISPLAY, ...env} = process.env;
    execFile('build/00_first_scene', ['-f', file, '-s', `${WIDTH}x${HEIGHT}`, ...options, '-o', picture], {timeout: PATIENCE, env: {...env, LIBGL_ALWAYS_SOFTWARE: '1', GALLIUM_DRIVER: 'llvmpipe'}},
        (error, stdout, said) => done({status: error ? error.code ?? 'late' : 0, said: said.trim().replaceAll(file, path.basename(file)).split('\n')[0]}));
});

// Run this in a page: draw the frames of an export with WebGL, as Shadertoy does, and compare the last one with a PNG.
// Returns {log} if WebGL refuses a pass, otherwise the mean difference and the share of the pixels that differ by more
// than 1, if there is a PNG, and whether each picture has one colour.
async function compare({passes, png, width, height, time, frame}) {
    const canvas = Object.assign(document.createElement('canvas'), {width, height}), gl = canvas.getContext('webgl2', {alpha: false, antialias: false, preserveDrawingBuffer: true});
    gl.getExtension('EXT_color_buffer_float');
    gl.getExtension('OES_texture_float_linear');
    const target = () => {
        const texture = gl.createTexture(), framebuffer = gl.createFramebuffer();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, null);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        gl.clear(gl.COLOR_BUFFER_BIT);
        return {texture, framebuffer};
    };
    const reads = passes.flatMap((pass) => pass.reads).filter(({buffer}) => buffer >= 0).sort((a, b) => a.at - b.at); // in the order of the file
    const buffers = [0, 1, 2, 3, 4, 5, 6, 7].map(() => ({pair: null, last: 0}));
    for (const {keeps} of passes) if (keeps >= 0) buffers[keeps].pair ??= [target(), target()];
    const level = (buffer) => reads.some((read) => read.buffer === buffer && read.filter === 'mipmap') && gl.generateMipmap(gl.TEXTURE_2D);
    buffers.forEach(({pair}, k) => pair?.forEach(({texture}) => {
        const edge = reads.findLast(({buffer}) => buffer === k)?.wrap === 'repeat' ? gl.REPEAT : gl.CLAMP_TO_EDGE;
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, edge);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, edge);
        level(k);
    }));
    for (const pass of passes) {
        const program = pass.program = gl.createProgram();
        for (const [type, source] of [[gl.VERTEX_SHADER, '#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }'], [gl.FRAGMENT_SHADER, pass.text]]) {
            const shader = gl.createShader(type);
            gl.shaderSource(shader, source);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) return {log: gl.getShaderInfoLog(shader)};
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return {log: gl.getProgramInfoLog(program)};
    }
    for (let k = 0; k <= frame; k++) for (const {program, reads, keeps} of passes) {
        const own = buffers[keeps], sizes = new Float32Array(12), at = (name) => gl.getUniformLocation(program, name);
        if (keeps < 0 && k < frame) continue;
        gl.bindFramebuffer(gl.FRAMEBUFFER, own ? own.pair[1 - own.last].framebuffer : null);
        gl.useProgram(program);
        for (let i = 0; i < 4; i++) { // samplers of different types need different units
            gl.activeTexture(gl.TEXTURE0 + i);
            gl.bindTexture(gl.TEXTURE_2D, null);
            gl.uniform1i(at(`iChannel${i}`), i);
        }
        for (const {channel, buffer, filter} of reads.toSorted((a, b) => a.channel - b.channel)) {
            if (buffer < 0) continue;
            gl.activeTexture(gl.TEXTURE0 + channel);
            gl.bindTexture(gl.TEXTURE_2D, buffers[buffer].pair[buffers[buffer].last].texture);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter === 'nearest' ? gl.NEAREST : gl.LINEAR);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter === 'nearest' ? gl.NEAREST : filter === 'mipmap' ? gl.LINEAR_MIPMAP_LINEAR : gl.LINEAR);
            sizes.set([width, height, 1], 3 * channel);
        }
        const now = time + k / 60;
        gl.uniform3f(at('iResolution'), width, height, 1);
        gl.uniform3fv(at('iChannelResolution'), sizes);
        gl.uniform1f(at('iTime'), now);
        gl.uniform1f(at('iTimeDelta'), k > 0 ? 1 / 60 : 0);
        gl.uniform1i(at('iFrame'), k);
        gl.uniform1f(at('iFrameRate'), 60);
        gl.uniform1f(at('iSampleRate'), 44100);
        gl.uniform4f(at('iDate'), 1970, 0, 1, now);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        if (!own) continue;
        own.last = 1 - own.last;
        gl.bindTexture(gl.TEXTURE_2D, own.pair[own.last].texture);
        level(keeps);
    }
    const own = new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, own);
    const flat = (data) => data.every((c, i) => c === data[i % 4]);
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    if (!png) return {flat: flat(own)};
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(png)]), {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const other = context.getImageData(0, 0, width, height).data;
    let sum = 0, off = 0;
    for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) {
        const apart = [0, 1, 2].map((c) => Math.abs(own[4 * ((height - 1 - y) * width + x) + c] - other[4 * (y * width + x) + c]));
        sum += apart[0] + apart[1] + apart[2];
        off += Math.max(...apart) > 1;
    }
    return {mean: sum / (3 * width * height), off: off / (width * height), flat: flat(own), otherFlat: flat(other)};
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

// Verdicts of the exports without buffers, and of those with.
const count = [0, 1].map(() => ({equal: 0, differs: 0, refused: 0, needs: 0, invalid: 0}));
let silent = 0; // pictures of one colour without a warning, which have several in Chromium
for (const name of fs.readdirSync(folder).filter((name) => name.endsWith('.json')).sort()) {
    const file = path.join(folder, name), passes = passesOf(JSON.parse(fs.readFileSync(file, 'utf8'))), kept = passes?.length > 1;
    const {status, said} = passes === null ? {status: 1, said: ''} : await drawn(file, kept ? ['--frame', FRAME] : ['-t', TIME]);
    const png = status === 0 ? [...fs.readFileSync(picture)] : null;
    const answer = passes === null ? {} : await browsed({passes, png, width: WIDTH, height: HEIGHT, time: kept ? 0 : TIME, frame: kept ? FRAME : 0});
    const equal = kept ? answer.off <= OFF : answer.mean <= EQUAL;
    const verdict = passes === null ? 'needs' : answer.log !== undefined ? 'invalid' : status !== 0 ? 'refused' : equal ? 'equal' : 'differs';
    const bare = verdict === 'differs' && answer.otherFlat && !answer.flat && said === '';
    count[Number(kept)][verdict]++;
    silent += bare;
    console.log(`${verdict}\t${answer.mean?.toFixed(3) ?? '-'}\t${answer.off?.toFixed(4) ?? '-'}\t${passes?.length ?? '-'}\t${name}\t${bare ? 'one colour' : said || (answer.log ?? '').split('\n')[0]}`);
}
await browser?.close();
fs.rmSync(path.dirname(picture), {recursive: true});
const shares = count.map(({equal, differs, refused}) => equal + differs + refused > 0 ? equal / (equal + differs + refused) : 1);
count.forEach((verdicts, kept) => console.log(`# ${kept ? 'with' : 'without'} buffers: ${Object.entries(verdicts).map(([verdict, n]) => `${n} ${verdict}`).join(', ')}; ${(100 * shares[kept]).toFixed(1)} % of those that Chromium draws are equal`));
console.log(`# ${silent} of one colour without a warning`);
process.exitCode = shares[0] >= SHARE && shares[1] >= KEPT_SHARE && silent === 0 ? 0 : 1;
