// pack.mjs LATER OUT FILE... - the texts of the course in one file of JSON.
//   LATER  a list of files that are loaded when something asks for them, one a line
import fs from 'node:fs';

const [later, out, ...names] = process.argv.slice(2);
const files = Object.fromEntries(names.map((name) => [name, fs.readFileSync(name, 'utf8')]));
fs.writeFileSync(out, JSON.stringify({files, later: fs.readFileSync(later, 'utf8').trim().split('\n')}));
