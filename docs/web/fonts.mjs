// fonts.mjs - the fonts of the site: of fonts that this machine has, the letters that are used and no more.
import {execFile} from 'node:child_process';
import {promisify} from 'node:util';

const run = promisify(execFile);

// The ranges of fontconfig, "20-7e a0 2019", as a test of a letter.
function holder(charset) {
    const ranges = charset.split(' ').map((range) => range.split('-').map((code) => parseInt(code, 16)));
    return (letter) => ranges.some(([first, last = first]) => letter.codePointAt(0) >= first && letter.codePointAt(0) <= last);
}

// Write a subset of a font.
//   font      as fontconfig names it, "TeX Gyre Pagella:style=Italic"
//   letters   what it is to have
//   features  what it keeps of OpenType's, "kern,liga"
//   file      the woff2 to write
// Returns the letters that the font lacks. Throws where the font is missing.
export async function subset(font, letters, features, file) {
    const [family, source, charset] = (await run('fc-match', ['-f', '%{family}\n%{file}\n%{charset}', font])).stdout.split('\n');
    if (!family.split(',').includes(font.split(':')[0])) throw new Error(`the font ${font} is missing: ${source} would stand in its place`);
    const codes = [...letters].map((letter) => letter.codePointAt(0).toString(16)).sort();
    await run('pyftsubset', [source, `--unicodes=${codes.join()}`, '--flavor=woff2', `--layout-features=${features}`, '--drop-tables+=FFTM', `--output-file=${file}`]);
    const holds = holder(charset);
    return [...letters].filter((letter) => !holds(letter));
}
