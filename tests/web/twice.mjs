// twice.mjs - the site is built twice from the same module: the files and the archive have the same bytes.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {check, finish} from './browser.mjs';

const FOLDER = 'build/web-test/twice';
const archives = ['one', 'two'].map((name) => {
    const site = `${FOLDER}/${name}/site`;
    fs.rmSync(`${FOLDER}/${name}`, {recursive: true, force: true});
    fs.mkdirSync(site, {recursive: true});
    const made = spawnSync('.make/site.sh', {encoding: 'utf8', env: {...process.env, SITE_FOLDER: site}});
    check(`the site is built, ${name}`, made.status === 0, made.stderr);
    return {site, zip: `${site}.zip`};
});
const names = (folder) => fs.readdirSync(folder, {recursive: true}).filter((name) => fs.statSync(`${folder}/${name}`).isFile()).sort();
const [one, two] = archives, all = names(one.site);
check('both have the same files', all.length > 500 && names(two.site).join() === all.join(), all.length);
const different = all.filter((name) => !fs.existsSync(`${two.site}/${name}`) || !fs.readFileSync(`${one.site}/${name}`).equals(fs.readFileSync(`${two.site}/${name}`)));
check('which have the same bytes', different.length === 0, different.slice(0, 8));
check('and so does the archive', fs.readFileSync(one.zip).equals(fs.readFileSync(two.zip)));
fs.rmSync(FOLDER, {recursive: true});
finish();
