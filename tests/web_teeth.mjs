// web_teeth.mjs [find] - plants the mistakes of tests/mistakes_web.txt, one after the other, and sees that the test which
// each names fails. With `find` it only sees that each finds its place.
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish} from './web_browser.mjs';

const PLANTED = 'build/web-test/planted';
const only = process.argv[2] === 'find';
const rows = fs.readFileSync('tests/mistakes_web.txt', 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).map((line) => {
    const [what, test, file, expression] = /^([^|]*)\|([^|]*)\|([^|]*)\|(.*)$/.exec(line).slice(1).map((part) => part.trim());
    return {what, test, file, expression};
});
fs.rmSync(PLANTED, {recursive: true, force: true});
fs.cpSync('build/web', PLANTED, {recursive: true, filter: (name) => !name.startsWith('build/web/objects')});
for (const {what, test, file, expression} of rows) {
    const text = execFileSync('sed', ['-e', expression, `docs/web/${file}`], {encoding: 'utf8'});
    const changed = text !== fs.readFileSync(`docs/web/${file}`, 'utf8');
    if (only || !changed) {
        check(`${what}: its place is found`, changed);
        continue;
    }
    fs.writeFileSync(`${PLANTED}/${file}`, text);
    const run = spawnSync('node', ['tests/web_program.mjs'], {encoding: 'utf8', env: {...process.env, WEB_FOLDER: PLANTED, WEB_PATIENCE: '15000'}});
    const failed = run.stdout.split('\n').filter((line) => line.startsWith('not ok '));
    check(`${what}: seen`, failed.some((line) => line.endsWith(` - ${test}`)), failed.slice(0, 6), run.stderr.slice(0, 300));
    fs.copyFileSync(`build/web/${file}`, `${PLANTED}/${file}`);
}
finish();
