// checks.mjs [PATTERN] - tests the check of exercises in a page: the course's solution is accepted and the unsolved
// chapter rejected, each with a sentence. In every chapter that PATTERN selects, the exercise with the fewest pictures
// is tested. Without PATTERN, a few chapters are tested; with ALL=1, every chapter. `make test SUITE=check` tests every
// exercise in the same way in the terminal.
import fs from 'node:fs';
import {blankPage, check, finish, launch, serve, WEB} from './browser.mjs';

const pattern = new RegExp(process.argv[2] || (process.env.ALL ? '' : '^(00|06|12|17)'));
const exercises = new Map();
for (const line of fs.readFileSync(`${WEB}/exercises.txt`, 'utf8').trim().split('\n')) {
    const [name, stem] = line.split('|');
    exercises.set(name, {name, stem, pictures: (exercises.get(name)?.pictures ?? 0) + 1});
}
const fewest = new Map();
for (const one of exercises.values())
    if (pattern.test(one.stem) && one.pictures < (fewest.get(one.stem)?.pictures ?? Infinity)) fewest.set(one.stem, one);

const server = await serve(WEB), browser = await launch(), {page, said} = await blankPage(browser);
await page.goto(`${server.at}/test.html`);
const judge = (name, text) => page.evaluate(async ([name, text]) => {
    const {right, words} = await (await import('/check.js')).judge(name, text);
    return {right, words};
}, [name, text]);
for (const {name, stem} of fewest.values()) {
    const read = (file) => fs.readFileSync(`chapters/${file}.frag`, 'utf8');
    const solution = await judge(name, read(`solutions/${stem}_${name.slice(3)}`));
    check(`${name}: the solution is accepted`, solution.right && solution.words.startsWith('matches the solution in '), solution);
    const untouched = await judge(name, read(stem));
    check(`${name}: the unsolved chapter is rejected`, !untouched.right && untouched.words !== '', untouched);
}
check('at least one exercise is tested', fewest.size > 0);
check('the console reports no error', said.length === 0, said);
finish();
await browser.close();
server.close();
