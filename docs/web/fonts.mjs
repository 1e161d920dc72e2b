// fonts.mjs - writes the fonts of the site: subsets of this machine's fonts, with only the letters that the site uses.
import {execFile} from 'node:child_process';
import {promisify} from 'node:util';

const run = promisify(execFile);

// Turn the ranges of fontconfig, such as "20-7e a0 2019", into a function that tells whether they contain a letter.
function holder(charset) {
    const ranges = charset.split(' ').map((range) => range.split('-').map((code) => parseInt(code, 16)));
    return (letter) => ranges.some(([first, last = first]) => letter.codePointAt(0) >= first && letter.codePointAt(0) <= last);
}

// Write a subset of a font.
//   font      as fontconfig names it, "TeX Gyre Pagella:style=Italic"
//   letters   the letters to keep
//   features  the OpenType features to keep, "kern,liga"
//   file      the woff2 file to write
// Returns the letters that the font lacks. Throws if the font is missing.
export async function subset(font, letters, features, file) {
    const [family, source, charset] = (await run('fc-match', ['-f', '%{family}\n%{file}\n%{charset}', font])).stdout.split('\n');
    if (!family.split(',').includes(font.split(':')[0])) throw new Error(`the font ${font} is missing; fontconfig would use ${source} instead`);
    const codes = [...letters].map((letter) => letter.codePointAt(0).toString(16)).sort();
    await run('pyftsubset', [source, `--unicodes=${codes.join()}`, '--flavor=woff2', `--layout-features=${features}`, '--drop-tables+=FFTM', `--output-file=${file}`]);
    const holds = holder(charset);
    return [...letters].filter((letter) => !holds(letter));
}
