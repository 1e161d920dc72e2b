// figures.mjs - prepares the figures of docs/figures/ for a page. Their colours follow the theme of the page. They
// contain their fonts, because a picture cannot load a font, and the reader's machine may not have that font.
import fs from 'node:fs';
import {plain} from './colour.mjs';
import {subset} from './fonts.mjs';

// In a dark theme the colours of the pen change (docs/figures/svg.h), and so do the other colours that figures use for
// text and backgrounds. A picture follows the colour scheme of the page that shows it.
export const DARK = {'#0d1433': '#e9e5dc', '#9aa0b5': '#7f8494', '#d9731a': '#f2954a', '#fce1b8': '#5d4420', '#2f6fc0': '#7fb2f5', '#cfe0f5': '#22395a',
    '#0b7f73': '#4cc4b5', '#fffbf2': '#1e2024', '#ffffff': '#141518', '#e4e2dd': '#34363c', '#f0c9a8': '#6b4628', '#b3261e': '#f0776c',
    '#1b7f3b': '#5cc47f', '#2446b8': '#8aa2ff'};

const FAMILY = 'Course Heros', SIGNS = 'Course Signs'; // Pagella Math has the primes and brackets that Heros lacks
const STYLES = {Regular: '', Italic: 'font-style:italic;', Bold: 'font-weight:bold;'};

// The letters in the text of a figure: {Regular, Italic, Bold}, each a set.
function lettersOf(svg) {
    const sets = Object.fromEntries(Object.keys(STYLES).map((style) => [style, new Set()]));
    for (const [, words] of svg.matchAll(/<text[^>]*>(.*?)<\/text>/gs)) {
        const open = ['Regular'];
        for (const [, end, attributes, letters] of words.matchAll(/<(\/?)tspan([^>]*)>|([^<]+)/g)) {
            if (letters) for (const letter of plain(letters)) sets[open.at(-1)].add(letter);
            else if (end) open.pop();
            else open.push(/italic/.test(attributes) ? 'Italic' : /bold/.test(attributes) ? 'Bold' : open.at(-1));
        }
    }
    return sets;
}

// Write figures into a folder.
//   figures  [{name, file}]
//   parts    a folder for intermediate files
export async function writeFigures(figures, folder, parts) {
    const all = figures.map(({name, file}) => ({name, svg: fs.readFileSync(file, 'utf8')})).map((one) => ({...one, letters: lettersOf(one.svg)}));
    const faces = {}, lacking = new Set();
    const face = async (name, family, more, font, letters) => {
        const file = `${parts}/figure-${name}.woff2`, without = await subset(font, letters, 'kern', file);
        faces[name] = `@font-face{font-family:"${family}";${more}src:url(data:font/woff2;base64,${fs.readFileSync(file, 'base64')})}`;
        return without;
    };
    for (const [style, more] of Object.entries(STYLES)) {
        const letters = new Set(all.flatMap((one) => [...one.letters[style]]));
        for (const letter of await face(style, FAMILY, more, `TeX Gyre Heros:style=${style}`, letters)) lacking.add(letter);
    }
    const none = await face('Signs', SIGNS, '', 'TeX Gyre Pagella Math', lacking);
    if (none.length > 0) throw new Error(`the fonts of the figures lack ${none.join(' ')}`);
    for (const {name, svg, letters} of all) {
        const used = Object.keys(STYLES).filter((style) => letters[style].size > 0);
        if (used.some((style) => [...letters[style]].some((letter) => lacking.has(letter)))) used.push('Signs');
        const rules = Object.entries(DARK).filter(([light]) => svg.includes(`"${light}"`)).map(([light, dark]) => `[fill="${light}"]{fill:${dark}}[stroke="${light}"]{stroke:${dark}}`);
        const style = `${used.map((each) => faces[each]).join('')}svg{font-family:"${FAMILY}","${SIGNS}",Helvetica,Arial,sans-serif}@media (prefers-color-scheme: dark){${rules.join('')}}`;
        fs.writeFileSync(`${folder}/${name}`, svg.replace(/<svg[^>]*>/, `$&\n<style>${style}</style>`));
    }
}
