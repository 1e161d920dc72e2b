// twice.mjs - builds the site twice from the same module and tests that the files and the archives have the same bytes.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish} from './browser.mjs';

const FOLDER = 'build/web-test/twice';
const archives = ['one', 'two'].map((name) => {
    const site = `${FOLDER}/${name}/site`;
    fs.rmSync(`${FOLDER}/${name}`, {recursive: true, force: true});
    fs.mkdirSync(site, {recursive: true});
    const made = spawnSync('.make/site.sh', {encoding: 'utf8', env: {...process.env, SITE_FOLDER: site}});
    check(`build ${name} of the site succeeds`, made.status === 0, made.stderr);
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
