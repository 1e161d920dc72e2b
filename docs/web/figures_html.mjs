// figures_html.mjs OUT - writes each interactive figure as one file, OUT/NAME.html, which loads nothing, for slides and
// learning platforms, and OUT/index.html, which lists them. If ADDRESS is set, the line below a figure is a link to it.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import {escaped} from './colour.mjs';
import {pictures} from './commands.mjs';
import {isSheet, partsOf, scriptOf, sheetOf, textureOf} from './sheets.mjs';

const {transformSync} = createRequire(new URL('../../build/node/', import.meta.url))('esbuild');
const [out] = process.argv.slice(2), ADDRESS = process.env.ADDRESS?.replace(/\/?$/, '/');
const COURSE = 'Ray marching, step by step';
const small = (name) => transformSync(fs.readFileSync(`docs/web/${name}`, 'utf8'), {minify: true, loader: name.endsWith('.css') ? 'css' : 'js'}).code.trim();
const css = small('sheet.css'), js = small('sheet.js');
const STYLE = 'body{margin:0;font-family:system-ui,sans-serif;color:light-dark(#1d1c1a,#e4e0d7)}.sheet-screen{aspect-ratio:16/9}figure-sheet:not(.still) img{visibility:hidden}p{margin:.4rem 0 0;font-size:.75rem;opacity:.8}a{color:inherit}';

// The title of a chapter's page, and the alternative text of a picture in it.
const pages = new Map();
function pageOf(stem) {
    if (!pages.has(stem)) pages.set(stem, fs.readFileSync(`docs/${stem}.md`, 'utf8'));
    return pages.get(stem);
}
const titleOf = (stem) => /^# (.*)/m.exec(pageOf(stem))[1];
const altOf = (stem, picture) => new RegExp(`!\\[([^\\]]*)\\]\\(\\.\\./tests/references/${picture}\\)`).exec(pageOf(stem))?.[1] ?? titleOf(stem);

const made = new Map(); // the first picture of each figure, which shows the figure's own values
for (const [picture, {stem, line}] of pictures) {
    const name = /(\w+)\.frag/.exec(line)?.[1] ?? stem, own = picture.replace(/\.\w+$/, '');
    if (!isSheet(own, line) || made.has(name)) continue;
    const alt = escaped(altOf(stem, picture)), html = sheetOf(stem, line, own, `<img alt="${alt}" width="640" height="360">`, false), script = scriptOf(html, true);
    const textures = [...new Set([...script.matchAll(/sheets\/textures\/\w+\.js/g)].map(([file]) => file))];
    const embed = `<iframe src="${name}.html" width="640" height="${400 + 32 * (html.match(/<label/g) ?? []).length}" style="border:0" title="${alt}"></iframe>`;
    const scripts = [script, ...partsOf(html, script).map(small), ...textures.map(textureOf), js];
    const course = `${COURSE}, chapter ${escaped(titleOf(stem))}`;
    fs.writeFileSync(`${out}/${name}.html`, `<!doctype html>
<!-- To show this figure in a page, put the file beside the page and add:
${embed.replaceAll('--', '&#45;&#45;')}
With ${name}.html#dark, the figure is dark. -->
<html lang="en-GB" class="js" style="color-scheme:light">
<meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>${course}</title>
<style>${css}${STYLE}</style>
<script>if(location.hash==='#dark')document.documentElement.style.colorScheme='dark'</script>
${html}
<p>${ADDRESS ? `<a href="${ADDRESS}${stem}.html" target="_top">${course}</a>` : course}</p>
${scripts.map((text) => `<script>${text.trim()}</script>`).join('\n')}
`);
    made.set(name, {alt, embed, course});
}
fs.writeFileSync(`${out}/index.html`, `<!doctype html>
<html lang="en-GB">
<meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Figures of ${COURSE}</title>
<style>body{max-width:50rem;margin:1rem auto;padding:0 1rem;font-family:system-ui,sans-serif}pre{white-space:pre-wrap}</style>
<h1>The figures of ${COURSE}</h1>
<p>Each figure is one file. The line below its name shows it in a page or on a slide beside which the file is.</p>
${[...made].map(([name, {alt, embed, course}]) => `<h2><a href="${name}.html">${name}</a></h2>\n<p>${course}. ${alt}.</p>\n<pre>${escaped(embed)}</pre>`).join('\n')}
`);
