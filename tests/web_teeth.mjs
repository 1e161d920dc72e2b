// web_teeth.mjs [PATTERN] - plants the mistakes of tests/mistakes_web.txt whose file or words PATTERN picks, one after the
// other, each in a copy of the site, and sees that the test which it names fails there. With `find` it only sees that
// each finds its place.
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish} from './web_browser.mjs';

const SITE = 'build/web-test/planted';
const SOURCES = 'build/web-test/sources'; // of the module
const SCRIPTS = 'build/web-planted'; // of docs/web/, and as deep, for it imports what lies in build/
const only = process.argv[2] === 'find', pattern = new RegExp(only ? '' : process.argv[2] || '');
const rows = fs.readFileSync('tests/mistakes_web.txt', 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).map((line) => {
    const [what, test, file, expression] = /^([^|]*)\|([^|]*)\|([^|]*)\|(.*)$/.exec(line).slice(1).map((part) => part.trim());
    return {what, test, file: file.includes('/') ? file : `docs/web/${file}`, expression};
}).filter(({what, file}) => pattern.test(`${file}: ${what}`));

// The script that has a test; Firefox would want a display.
const scripts = fs.readdirSync('tests').filter((name) => /^web_.*\.mjs$/.test(name) && !/_(teeth|firefox)\./.test(name));
const scriptOf = (test) => scripts.find((name) => fs.readFileSync(`tests/${name}`, 'utf8').includes(test.replaceAll('\'', '\\\'')));

const run = (program, values, env = {}) => spawnSync(program, values, {encoding: 'utf8', env: {...process.env, MAKEFLAGS: '', ...env}});

// Make the module anew, beside a copy of what it was built of, and lay it into the site.
function makeModule(file, text) {
    if (!fs.existsSync(SOURCES))
        execFileSync('bash', ['-c', 'mkdir -p "$0/tests" "$0/build/web" && cp -Rp Makefile common chapters shaders "$0" && cp -Rp tests/*.[ch] "$0/tests" && cp -Rp build/web/objects build/web/harness.* "$0/build/web"', SOURCES]);
    fs.writeFileSync(`${SOURCES}/${file}`, text);
    const made = run('make', ['-C', SOURCES, 'WEB=1', 'module']);
    for (const name of ['harness.js', 'harness.wasm']) fs.copyFileSync(`${SOURCES}/build/web/${name}`, `${SITE}/${name}`);
    fs.copyFileSync(file, `${SOURCES}/${file}`);
    return made;
}

// What a page loads is laid into the copy; what makes pages makes all of them, unless the test does that itself.
function plant(file, text, script) {
    if (file.startsWith('common/')) return makeModule(file, text);
    const name = file.slice('docs/web/'.length);
    fs.writeFileSync(`${SCRIPTS}/${name}`, text);
    const env = {SITE_SOURCE: SCRIPTS, SITE_FOLDER: SITE, WEB_FOLDER: SITE};
    if (/^(site|play)\.(js|css)$/.test(name)) fs.writeFileSync(`${SITE}/${name}`, text);
    else if (/\.(js|css)$|^pack/.test(name)) return run('.make/web.sh', [], env);
    else if (script !== 'web_twice.mjs') return run('.make/site.sh', [], env);
    return {status: 0};
}

fs.rmSync(SOURCES, {recursive: true, force: true});
for (const {what, test, file, expression} of rows) {
    const text = execFileSync('sed', ['-e', expression, file], {encoding: 'utf8'}), script = scriptOf(test);
    const changed = text !== fs.readFileSync(file, 'utf8');
    if (only || !changed || !script) {
        check(`${what}: it finds its place and its test`, changed && script);
        continue;
    }
    for (const folder of [SITE, SCRIPTS]) fs.rmSync(folder, {recursive: true, force: true});
    fs.cpSync('build/site', SITE, {recursive: true});
    fs.cpSync('docs/web', SCRIPTS, {recursive: true});
    const built = plant(file, text, script);
    const tried = built.status === 0 ? run('node', [`tests/${script}`], {
        WEB_PATIENCE: '15000', WEB_UNTIL: test, WEB_FOLDER: SITE,
        ...(script === 'web_twice.mjs' ? {SITE_SOURCE: SCRIPTS} : {SITE_FOLDER: SITE}),
    }) : {stdout: '', stderr: built.stderr};
    const failed = tried.stdout.split('\n').filter((line) => line.startsWith('not ok '));
    check(`${what}: seen`, failed.some((line) => line.endsWith(test)), failed.slice(0, 6), tried.stderr.slice(0, 300));
}
for (const folder of [SITE, `${SITE}.zip`, SOURCES, SCRIPTS]) fs.rmSync(folder, {recursive: true, force: true});
finish();
