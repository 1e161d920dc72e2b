// find.js - searches all pages. Like the index of headings, this script is loaded when the search field is first used. It is a
// classic script, because browsers run no modules from file://.
(() => {
    const field = document.querySelector('.search input'), list = document.querySelector('.results'), found = document.querySelector('.found');
    const up = field.dataset.index.replace('search.js', '');
    const MOST = 12, LENGTH = 150; // the maximum numbers of results, and of characters in an excerpt
    const MEANT = {sdf: 'signed distance', sdfs: 'signed distance', ao: 'occlusion', dof: 'depth of field', aa: 'antialiasing', fov: 'field of view', raymarching: 'ray marching', color: 'colour'};
    const folded = (text) => text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
    const wordsOf = (text) => folded(text).split(/[^\p{L}\p{N}_]+/u).filter((word) => word.length > 1);
    let entries = null, vocabulary = null, asked = false, complete = false;

    window.searchIndex = (pages) => {
        entries = pages.flatMap(([address, title, sections]) => sections.map(([id, heading], i) =>
            ({address: `${up}${address}#${id}`, title, heading, text: '', first: i === 0, low: '', head: folded(heading), page: folded(title)})));
        search();
    };
    // The texts are loaded after the first letter is typed; until they arrive, only headings are searched.
    window.searchText = (texts) => {
        entries.forEach((entry, i) => Object.assign(entry, {text: texts[i], low: folded(texts[i])}));
        complete = true;
        search();
    };
    function load(name) {
        const script = document.createElement('script');
        script.src = field.dataset.index.replace('search.js', name);
        script.onerror = () => { found.textContent = 'The search index could not be loaded.'; };
        document.head.append(script);
    }
    load('search.js');

    // ---- Words ----

    // Can a word become another one in at most this many edits? An edit removes, adds or replaces a letter, or swaps
    // two neighbours.
    function near(a, b, most) {
        if (Math.abs(a.length - b.length) > most) return false;
        let before = [], row = [...Array(b.length + 1).keys()];
        for (let i = 1; i <= a.length; i++) {
            const next = [i];
            for (let j = 1; j <= b.length; j++) {
                next[j] = Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] !== b[j - 1]));
                if (a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1]) next[j] = Math.min(next[j], before[j - 2] + 1);
            }
            [before, row] = [row, next];
        }
        return row[b.length] <= most;
    }

    // Replace a word that occurs nowhere with the most common of the similar words in the pages.
    function mended(word) {
        if (!complete || word.length < 4 || entries.some((entry) => entry.low.includes(word) || entry.head.includes(word))) return word;
        if (!vocabulary) {
            vocabulary = new Map();
            for (const entry of entries) for (const one of wordsOf(`${entry.heading} ${entry.text}`)) vocabulary.set(one, (vocabulary.get(one) ?? 0) + 1);
        }
        const most = word.length > 7 ? 2 : 1;
        return [...vocabulary].filter(([one]) => one.length > 3 && near(word, one, most)).sort((a, b) => b[1] - a[1])[0]?.[0] ?? word;
    }

    // ---- Sections ----

    const begins = (text, at) => at === 0 || !/[\p{L}\p{N}]/u.test(text[at - 1]);

    // The weight of a word, which is greater if fewer sections contain it.
    const rarity = (word) => Math.log(1 + entries.length / (1 + entries.filter((entry) => entry.low.includes(word) || entry.head.includes(word)).length));

    // How well a section fits: the more of the words it contains, in any order, the better. A match in the title of the
    // page counts most, but only for the page's first section; a match in a heading counts more than one in the text,
    // and a match at the beginning of a word more than one inside it.
    //   words  the words and their weights, [{word, rare}]
    function scoreOf(entry, words) {
        let sum = 0, has = 0;
        for (const {word, rare} of words) {
            let own = 0;
            const inPage = entry.page.indexOf(word), inHead = entry.head.indexOf(word), inText = entry.low.indexOf(word);
            if (inPage < 0 && inHead < 0 && inText < 0) continue;
            has++;
            if (inPage >= 0 && begins(entry.page, inPage)) own += entry.first ? 60 + 60 * word.length / entry.page.length : 8; // the larger the word's share of the title, the better
            if (inHead >= 0) own += begins(entry.head, inHead) ? 30 : 10;
            if (inText >= 0) own += Math.min(entry.low.split(word).length - 1, 6) + (begins(entry.low, inText) ? 3 : 0);
            sum += rare * own;
        }
        return sum * 4 ** (has - words.length);
    }

    // The text around the first of the words that the section contains; no word is cut.
    function excerpt(entry, words) {
        const small = document.createElement('small'), at = words.map((word) => entry.low.indexOf(word)).find((i) => i >= 0) ?? 0;
        const from = at < 60 ? 0 : entry.text.indexOf(' ', at - 60) + 1, end = entry.text.length - from <= LENGTH ? entry.text.length : entry.text.lastIndexOf(' ', from + LENGTH);
        const text = entry.text.slice(from, end), low = folded(text);
        const word = low.length === text.length && words.find((each) => low.includes(each)), i = word ? low.indexOf(word) : text.length;
        const mark = document.createElement('mark');
        mark.textContent = text.slice(i, i + (word || '').length);
        small.append(from > 0 ? '… ' : '', text.slice(0, i), ...(word ? [mark, text.slice(i + word.length)] : []), end < entry.text.length ? ' …' : '');
        return small;
    }

    function item(entry, words) {
        const made = document.createElement('li'), link = document.createElement('a');
        link.href = entry.address;
        link.append(entry.heading);
        if (entry.heading !== entry.title) {
            const where = document.createElement('small');
            where.textContent = entry.title;
            link.append(where);
        }
        link.append(excerpt(entry, words));
        made.append(link);
        return made;
    }

    function search() {
        const typed = wordsOf(field.value), words = [...new Set(typed.flatMap((word) => (MEANT[word] ?? word).split(' ')))];
        if (!entries || words.length === 0) { list.hidden = true; found.textContent = ''; return; }
        if (!asked) load('search_text.js');
        asked = true;
        const weighed = words.map(mended).map((word) => ({word, rare: rarity(word)})).sort((a, b) => b.rare - a.rare), meant = weighed.map(({word}) => word);
        const hits = entries.map((entry) => [scoreOf(entry, weighed), entry]).filter(([score]) => score > 0).sort((a, b) => b[0] - a[0]).slice(0, MOST);
        list.replaceChildren(...hits.map(([, entry]) => item(entry, meant)));
        found.textContent = !complete ? '' : hits.length === 0 ? 'Nothing found' : `${hits.length} ${hits.length === 1 ? 'section' : 'sections'} found`;
        if (hits.length === 0) list.innerHTML = `<li class="none">${complete ? 'Nothing found.' : 'Searching …'}</li>`;
        list.hidden = false;
    }
    field.addEventListener('input', search);

    const close = () => { list.hidden = true; };
    document.querySelector('.search').addEventListener('keydown', (event) => {
        const links = [...list.querySelectorAll('a')], at = links.indexOf(document.activeElement);
        if (event.key === 'Escape') { close(); field.focus(); }
        else if (event.key === 'Enter' && at < 0 && !list.hidden && links.length > 0) links[0].click();
        else if ((event.key === 'ArrowDown' || event.key === 'ArrowUp') && !list.hidden) {
            event.preventDefault();
            (links[at + (event.key === 'ArrowDown' ? 1 : -1)] || field).focus();
        }
    });
    document.addEventListener('click', (event) => { if (!event.target.closest('.search') || event.target.closest('.results a')) close(); });
})();
