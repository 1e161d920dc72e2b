// pack.mjs LATER OUT FILE... - packs the texts of the course into one JSON file.
//   LATER  a file that lists the files to load only when they are needed, one per line
import fs from 'node:fs';

const [later, out, ...names] = process.argv.slice(2);
const files = Object.fromEntries(names.map((name) => [name, fs.readFileSync(name, 'utf8')]));
fs.writeFileSync(out, JSON.stringify({files, later: fs.readFileSync(later, 'utf8').trim().split('\n')}));
