// pictures.mjs - writes the reference pictures for the site, as WebP, which takes 15 MB instead of 56.
import {createHash} from 'node:crypto';
import {execFile} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {promisify} from 'node:util';
import {isTurned} from './sheets.mjs';

const run = promisify(execFile);
const KEPT = 'build/webp'; // pictures that were converted before, because all of them take a minute
const NEAR = ['-near_lossless', '60', '-z', '2'], FINE = ['-q', '92', '-sharp_yuv'], SMALL = ['-q', '82', '-m', '6'];
const LARGE = 30e3; // bytes

// The name of a picture on the site, and of its smaller copy, which a page shows first or in a gallery.
export const nameOf = (file) => path.basename(file).replace('.png', '.webp');
export const smallOf = (file) => path.basename(file).replace(/(-smooth)?\.png$/, '-small.webp');

// Convert a picture. Returns the file with the result.
async function converted(file, options) {
    const kept = `${KEPT}/${createHash('sha256').update(options.join()).update(fs.readFileSync(file)).digest('hex')}.webp`;
    if (!fs.existsSync(kept)) {
        const now = `${kept}.${process.pid}`;
        await run('cwebp', ['-quiet', ...options, file, '-o', now]);
        fs.renameSync(now, kept);
    }
    return kept;
}

// A picture with sharp edges, such as a figure, is small without loss of them. Others, such as clouds, are large, and
// nobody sees what they lose. A figure loses nothing, because the live figure takes the place of its still picture.
async function write(name, file, folder) {
    let from = file;
    if (name.endsWith('-small.webp')) from = await converted(file, SMALL);
    else if (file.endsWith('.png')) {
        from = await converted(file, NEAR);
        if (fs.statSync(from).size > LARGE && !name.includes('-figure-') && !isTurned(path.basename(name, '.webp'))) from = await converted(file, FINE);
    }
    fs.copyFileSync(from, `${folder}/${name}`);
}

// Write pictures into a folder.
//   pictures  [[name, file]]
export async function writePictures(pictures, folder) {
    fs.mkdirSync(KEPT, {recursive: true});
    let next = 0;
    await Promise.all(os.cpus().map(async () => { while (next < pictures.length) await write(...pictures[next++], folder); }));
}
