// twice.mjs - links the module and builds the site twice, and tests that the files and the archives have the same bytes.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish} from './browser.mjs';

const FOLDER = 'build/web-test/twice';
const run = (command, words, more) => spawnSync(command, words, {encoding: 'utf8', env: {...process.env, ...more}});
const archives = ['1', '2'].map((name) => {
    const site = `${FOLDER}/${name}/site`, web = `${FOLDER}/${name}/web`;
    fs.rmSync(`${FOLDER}/${name}`, {recursive: true, force: true});
    fs.mkdirSync(web, {recursive: true});
    for (const file of ['js', 'wasm']) fs.rmSync(`build/web/objects/harness.${file}`);
    const made = [ // Emscripten's tools are in Python, whose sets have another order with another seed
        run('make', ['-s', 'WEB=1', 'module'], {PYTHONHASHSEED: name}),
        run('.make/web.sh', [], {WEB_FOLDER: web}),
        run('.make/site.sh', [], {WEB_FOLDER: web, SITE_FOLDER: site}),
    ];
    check(`build ${name} of the site succeeds`, made.every(({status}) => status === 0), made.map(({stderr}) => stderr).join(''));
    return {site, zip: `${site}.zip`};
});
const names = (folder) => fs.readdirSync(folder, {recursive: true}).filter((name) => fs.statSync(`${folder}/${name}`).isFile()).sort();
const [one, two] = archives, all = names(one.site);
check('both sites have the same files', all.length > 500 && names(two.site).join() === all.join(), all.length);
const different = all.filter((name) => !fs.existsSync(`${two.site}/${name}`) || !fs.readFileSync(`${one.site}/${name}`).equals(fs.readFileSync(`${two.site}/${name}`)));
check('the files of both sites have the same bytes', different.length === 0, different.slice(0, 8));
check('the archives of both sites have the same bytes', fs.readFileSync(one.zip).equals(fs.readFileSync(two.zip)));
fs.rmSync(FOLDER, {recursive: true});
finish();
