// sources.mjs - makes a coloured page, source/FILE.html, for each file that the pages link to.
import fs from 'node:fs';
import path from 'node:path';
import {coloured, escaped, languageOf} from './colour.mjs';

const root = (file) => '../'.repeat(file.split('/').length);

export class Sources {
    constructor() {
        this.texts = new Map();
        this.shownBy = new Map();
    }

    // The address of a file's page, relative to the top of the site, with the line where `text` begins; '' if the file
    // is not a text file of the project.
    place(file, text = '') {
        if (!fs.existsSync(file) || !fs.statSync(file).isFile() || /\.(png|svg)$/.test(file)) return '';
        if (!this.texts.has(file)) {
            this.texts.set(file, fs.readFileSync(file, 'utf8'));
            for (const [, name] of this.texts.get(file).matchAll(/^#include "([^"]+)"/gm)) this.included(file, name);
        }
        const at = text ? this.texts.get(file).indexOf(text.split('\n')[0]) : -1;
        const line = at > 0 ? `#L${this.texts.get(file).slice(0, at).split('\n').length}` : '';
        return `source/${file}.html${line}`;
    }

    // The file that an #include refers to, found as common/shader/source.c and the compiler find it.
    included(file, name) {
        const found = [path.join(path.dirname(file), name), `shaders/${name}`, `chapters/${name}`, `common/${name}`].find((each) => fs.existsSync(each));
        return found && this.place(found) ? found : undefined;
    }

    // Record that a page shows a file.
    mention(file, page) {
        const pages = this.shownBy.get(file) ?? new Map();
        this.shownBy.set(file, pages.set(page.address, page.title));
    }

    // The body of a file's page: numbered lines, links for its includes, and a list of the pages that show it.
    body(file) {
        const up = root(file);
        const lines = coloured(this.texts.get(file).replace(/\n$/, ''), languageOf(file)).split('\n');
        let open = '';
        const html = lines.map((line, i) => {
            const whole = open + line; // a comment may continue on the next line
            const tags = [...whole.matchAll(/<i class="\w">|<\/i>/g)].map(([tag]) => tag);
            open = tags.length > 0 && tags.at(-1) !== '</i>' ? tags.at(-1) : '';
            return `<span id="L${i + 1}">${whole}${open ? '</i>' : ''}</span>`;
        }).join('\n').replace(/#include (?:<\/i><i class="\w">)?&quot;([^&]*)&quot;/g, (whole, name) => {
            const found = this.included(file, name);
            return found ? whole.replace(`&quot;${name}&quot;`, `<a href="${up}source/${found}.html">&quot;${name}&quot;</a>`) : whole;
        });
        const pages = [...this.shownBy.get(file) ?? []].sort().map(([address, title]) => `<a href="${up}${address}">${escaped(title)}</a>`);
        return `<h1 class="file">${escaped(file)}</h1>${pages.length > 0 ? `<p>Shown in ${pages.join(', ')}.</p>` : ''}`
            + `<div class="listing source"><pre><code>${html}</code></pre></div>`;
    }
}

export {root};
