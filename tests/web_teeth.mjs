// web_teeth.mjs [PATTERN] - plants the mistakes of tests/mistakes_web.txt whose file or words PATTERN picks, one after the
// other, and sees that the test which each names fails. With `find` it only sees that each finds its place.
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish} from './web_browser.mjs';

const PLANTED = 'build/web-test/planted';
const BUILDER = 'build/web-planted'; // as deep as docs/web/, whose imports it has
const only = process.argv[2] === 'find', pattern = new RegExp(only ? '' : process.argv[2] || '');
const scripts = fs.readdirSync('tests').filter((name) => /^web_.*\.mjs$/.test(name));
const rows = fs.readFileSync('tests/mistakes_web.txt', 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).map((line) => {
    const [what, test, file, expression] = /^([^|]*)\|([^|]*)\|([^|]*)\|(.*)$/.exec(line).slice(1).map((part) => part.trim());
    return {what, test, file, expression};
}).filter(({what, file}) => pattern.test(`${file}: ${what}`));
fs.rmSync(PLANTED, {recursive: true, force: true});
fs.cpSync('build/web', PLANTED, {recursive: true, filter: (name) => !name.startsWith('build/web/objects')});
for (const {what, test, file, expression} of rows) {
    const text = execFileSync('sed', ['-e', expression, `docs/web/${file}`], {encoding: 'utf8'});
    const changed = text !== fs.readFileSync(`docs/web/${file}`, 'utf8');
    if (only || !changed) {
        check(`${what}: its place is found`, changed);
        continue;
    }
    // The script that has the test of this name. A file of the builder makes another site, which the script looks at.
    const script = scripts.find((name) => fs.readFileSync(`tests/${name}`, 'utf8').includes(`check('${test.replaceAll("'", "\\'")}'`));
    const builds = file.endsWith('.mjs'), env = {...process.env, WEB_PATIENCE: '15000'};
    const place = builds ? BUILDER : PLANTED;
    if (builds) {
        fs.cpSync('docs/web', BUILDER, {recursive: true});
        Object.assign(env, {SITE_SOURCE: BUILDER, SITE_FOLDER: `${BUILDER}/site`});
    } else {
        env.WEB_FOLDER = PLANTED;
    }
    fs.writeFileSync(`${place}/${file}`, text);
    const built = builds && script !== 'web_twice.mjs' ? spawnSync('.make/site.sh', {encoding: 'utf8', env}) : {status: 0};
    const run = built.status === 0 && script ? spawnSync('node', [`tests/${script}`], {encoding: 'utf8', env}) : {stdout: '', stderr: built.stderr ?? 'no script has this test'};
    const failed = run.stdout.split('\n').filter((line) => line.startsWith('not ok '));
    check(`${what}: seen`, failed.some((line) => line.endsWith(` - ${test}`)), failed.slice(0, 6), run.stderr.slice(0, 300));
    if (builds) fs.rmSync(BUILDER, {recursive: true});
    else fs.copyFileSync(`build/web/${file}`, `${PLANTED}/${file}`);
}
finish();
