// swiftshader.mjs [PATTERN] - draws pictures with SwiftShader, Chromium's rasteriser for machines without a graphics
// card, and prints how far each is from its reference, and how large the errors of SwiftShader's functions are, next to
// Mesa's. These numbers are not judged; docs/architecture.md has the reasons. By default, it draws one picture of each
// chapter; PATTERN selects others.
import fs from 'node:fs';
import {check, compare, draw, finish, keep, launch, openPage, pictures, serve, WEB} from './browser.mjs';

const OUT = 'build/web-test/swiftshader';
const pattern = process.argv[2] ? new RegExp(process.argv[2]) : null;
const rows = pictures().filter((row) => pattern ? pattern.test(row.name) : row.name === row.stem);
fs.mkdirSync(OUT, {recursive: true});
const server = await serve(WEB), browser = await launch('swiftshader');
const {page, said} = await openPage(browser, server.at);
// Occasionally, the browser offers no context at first and restarts its renderer, so the test waits for a context.
const renderer = await (await page.waitForFunction(() => {
    const context = document.createElement('canvas').getContext('webgl2');
    return context?.getParameter(context.getExtension('WEBGL_debug_renderer_info').UNMASKED_RENDERER_WEBGL);
})).jsonValue();
check('the renderer is SwiftShader', /SwiftShader/.test(renderer), renderer);

// The largest error of each of four functions in a fragment shader, at 4096 points, relative to the value or to 1,
// whichever is larger.
function errors() {
    const gl = document.createElement('canvas').getContext('webgl2'), program = gl.createProgram(), N = 64;
    gl.getExtension('EXT_color_buffer_float');
    const stage = (type, text) => {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${text}`);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    };
    stage(gl.VERTEX_SHADER, 'void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }');
    stage(gl.FRAGMENT_SHADER, `out vec4 o; void main() { float x = (floor(gl_FragCoord.x) + ${N}.0 * floor(gl_FragCoord.y) + 0.5) / 256.0; o = vec4(exp(-x), pow(x, 0.4375), sin(x), inversesqrt(x)); }`);
    gl.linkProgram(program);
    gl.useProgram(program);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, N, N);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
    gl.viewport(0, 0, N, N);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const got = new Float32Array(4 * N * N), worst = [0, 0, 0, 0];
    gl.readPixels(0, 0, N, N, gl.RGBA, gl.FLOAT, got);
    for (let i = 0; i < N * N; i++) {
        const x = (i + 0.5) / 256;
        [Math.exp(-x), x ** 0.4375, Math.sin(x), 1 / Math.sqrt(x)].forEach((right, k) => {
            worst[k] = Math.max(worst[k], Math.abs(got[4 * i + k] - right) / Math.max(1, Math.abs(right)));
        });
    }
    return ['exp', 'pow', 'sin', 'inversesqrt'].map((name, k) => `${name} ${worst[k].toExponential(1)}`).join(', ');
}
console.log(`# largest errors on SwiftShader: ${await page.evaluate(errors)}`);
const mesa = await launch();
console.log(`# largest errors on Mesa: ${await (await openPage(mesa, server.at)).page.evaluate(errors)}`);
await mesa.close();

let same = 0, drawn = 0;
for (const row of rows) {
    const got = await draw(page, row.stem, row.line), file = `${OUT}/${row.name}.png`;
    if (!got.picture) {
        console.log(`# ${row.name}: no picture: ${got.lines.slice(0, 2).join(' | ')}`);
        continue;
    }
    drawn++;
    keep(got.picture, file);
    const compared = await compare(row.name, file);
    if (compared.same) same++;
    else console.log(`# ${row.name}: ${compared.says}`);
}
check('every picture is drawn', drawn === rows.length, drawn, rows.length);
console.log(`# on ${renderer}: ${same} of ${rows.length} within tolerance`);
check('the browser reports no error', said.length === 0, said.slice(0, 5));
finish();
await browser.close();
server.close();
