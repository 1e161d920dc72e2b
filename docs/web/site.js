// site.js - what every page does: its theme, search, the section that is being read, and the place where a reader stopped.
// A script of the old kind: browsers run no modules from file://.
(() => {
    const root = document.documentElement;
    const store = (() => { try { return localStorage; } catch { return {}; } })(); // a browser may refuse to keep anything
    const page = location.pathname.split('/').pop() || 'index.html';
    const inFiles = document.body.classList.contains('file');

    // ---- Theme ----

    const theme = document.querySelector('.theme');
    const themes = {'': ['Auto', 'as the system'], light: ['Light', 'light'], dark: ['Dark', 'dark']};
    function showTheme(name) {
        const [short, long] = themes[name] || themes[''];
        root.dataset.theme = name;
        theme.textContent = short;
        theme.title = `The theme is ${long}`;
        theme.setAttribute('aria-label', `${short}: the theme is ${long}`);
    }
    theme.hidden = false;
    theme.onclick = () => {
        const names = Object.keys(themes), next = names[(names.indexOf(root.dataset.theme) + 1) % names.length];
        store.theme = next;
        showTheme(next);
    };
    showTheme(root.dataset.theme in themes ? root.dataset.theme : '');

    if (location.protocol === 'file:') {
        root.classList.add('opened-as-file');
        const note = document.querySelector('.note.opened');
        if (note && document.querySelector('live-chapter, .run')) note.hidden = false;
    }

    // ---- Search ----

    const field = document.querySelector('.search input'), list = document.querySelector('.results'), found = document.querySelector('.found');
    const up = field.dataset.index.replace('search.js', '');
    const folded = (text) => text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
    let entries = null;
    window.searchIndex = (pages) => {
        entries = pages.flatMap(([address, title, sections]) => sections.map(([id, heading, text]) =>
            ({address: `${up}${address}#${id}`, title, heading, text, low: folded(text), head: folded(heading)})));
        search();
    };
    function load() {
        if (load.begun) return;
        load.begun = true;
        const script = document.createElement('script');
        script.src = field.dataset.index;
        script.onerror = () => { found.textContent = 'The list of words could not be loaded.'; load.begun = false; };
        document.head.append(script);
    }
    // Every word must be there; in a heading it counts more, and at the beginning of a word.
    function scoreOf(entry, words) {
        let sum = 0;
        for (const word of words) {
            const inHead = entry.head.indexOf(word), inText = entry.low.indexOf(word);
            if (inHead < 0 && inText < 0) return 0;
            if (inHead >= 0) sum += inHead === 0 || entry.head[inHead - 1] === ' ' ? 30 : 10;
            if (inText >= 0) sum += Math.min(entry.low.split(word).length - 1, 6) + (inText === 0 || /\W/.test(entry.low[inText - 1]) ? 3 : 0);
        }
        return sum;
    }
    function excerpt(entry, words) {
        const at = Math.max(0, ...words.map((word) => entry.low.indexOf(word)).filter((i) => i >= 0).slice(0, 1));
        const begin = at < 60 ? 0 : entry.text.indexOf(' ', at - 60) + 1, text = entry.text.slice(begin, begin + 150);
        const small = document.createElement('small');
        if (begin > 0) small.append('… ');
        const word = words.find((each) => folded(text).includes(each));
        if (word && folded(text).length === text.length) {
            const i = folded(text).indexOf(word), mark = document.createElement('mark');
            mark.textContent = text.slice(i, i + word.length);
            small.append(text.slice(0, i), mark, text.slice(i + word.length));
        } else {
            small.append(text);
        }
        return small;
    }
    function search() {
        const words = folded(field.value).split(/\s+/).filter((word) => word.length > 1);
        if (!entries || words.length === 0) { list.hidden = true; found.textContent = ''; return; }
        const hits = entries.map((entry) => [scoreOf(entry, words), entry]).filter(([score]) => score > 0).sort((a, b) => b[0] - a[0]).slice(0, 12);
        list.replaceChildren(...hits.map(([, entry]) => {
            const item = document.createElement('li'), link = document.createElement('a');
            link.href = entry.address;
            link.append(entry.heading === entry.title ? entry.title : `${entry.heading} `);
            if (entry.heading !== entry.title) {
                const where = document.createElement('small');
                where.textContent = entry.title;
                link.append(where);
            }
            link.append(excerpt(entry, words));
            item.append(link);
            return item;
        }));
        found.textContent = hits.length === 0 ? 'Nothing found' : `${hits.length} ${hits.length === 1 ? 'place' : 'places'} found`;
        if (hits.length === 0) list.innerHTML = '<li class="none">Nothing found.</li>';
        list.hidden = false;
    }
    field.addEventListener('focus', load);
    field.addEventListener('input', () => { load(); search(); });
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
    document.addEventListener('keydown', (event) => {
        const typing = /^(INPUT|TEXTAREA|SELECT|CANVAS)$/.test(document.activeElement.tagName) || document.activeElement.isContentEditable;
        if (event.key === '/' && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) { event.preventDefault(); field.focus(); }
    });

    // ---- Where one is ----

    const links = new Map([...document.querySelectorAll('.sections a')].map((link) => [decodeURIComponent(link.hash.slice(1)), link]));
    const headings = [...document.querySelectorAll('main :is(h1, h2, h3)[id]')];
    const reading = () => headings.filter((heading) => heading.offsetParent && heading.getBoundingClientRect().top < 120).at(-1);
    let shown = null;
    function follow() {
        const here = reading();
        if (here === shown) return;
        shown = here;
        for (const link of links.values()) {
            link.classList.remove('here');
            link.closest('li').classList.remove('open');
            link.closest('ul').closest('li')?.classList.remove('open');
        }
        const link = here && links.get(here.id);
        if (!link) return;
        link.classList.add('here');
        link.closest('li').classList.add('open');
        link.closest('ul').closest('li')?.classList.add('open');
        link.scrollIntoView({block: 'nearest'});
    }
    document.addEventListener('scroll', follow, {passive: true});
    follow();

    // What a link leads to may be folded.
    function unfold() {
        const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
        const fold = target && target.closest('details:not([open])');
        if (fold) { fold.open = true; target.scrollIntoView(); }
    }
    addEventListener('hashchange', unfold);
    unfold();
    for (const nav of document.querySelectorAll('[popover]')) {
        const show = () => { const here = nav.querySelector('[aria-current], .here'); if (here) nav.scrollTop += Math.max(0, here.getBoundingClientRect().bottom - nav.getBoundingClientRect().bottom + 40); };
        nav.addEventListener('click', (event) => { if (event.target.closest('a') && nav.matches(':popover-open')) nav.hidePopover(); });
        nav.addEventListener('toggle', show);
        show();
    }

    // ---- Where one stopped ----

    const saved = (key) => { try { return JSON.parse(store[key]); } catch { return null; } };
    const words = (heading) => heading.textContent.trim();
    function keep() {
        const here = reading();
        if (inFiles || !here || here.tagName === 'H1') return;
        try {
            store[`read ${page}`] = JSON.stringify({id: here.id, words: words(here)});
            store.last = JSON.stringify({page, title: document.querySelector('h1').textContent, id: here.id, words: words(here)});
        } catch {} // nothing may be kept here
    }
    function offer(text, href, label) {
        const line = document.createElement('p'), link = document.createElement('a');
        line.className = 'resume';
        link.href = href;
        link.textContent = label;
        line.append(text, link, '.');
        document.querySelector('main h1').after(line);
    }
    const last = saved('last'), own = saved(`read ${page}`);
    const again = performance.getEntriesByType('navigation')[0]?.type !== 'navigate'; // then the browser itself goes back there
    if (page === 'index.html' && last && last.page !== page) offer('You were reading ', `${last.page}#${last.id}`, `${last.title}, ${last.words}`);
    else if (page !== 'index.html' && own && !location.hash && !again && document.getElementById(own.id)) offer('You stopped at ', `#${own.id}`, own.words);
    document.addEventListener('scrollend', keep);
    addEventListener('pagehide', keep);

    // ---- What scrolls sideways is reached by the keyboard ----

    const wide = new ResizeObserver((seen) => {
        for (const {target} of seen) {
            if (target.scrollWidth > target.clientWidth + 1) target.tabIndex = 0;
            else target.removeAttribute('tabindex');
        }
    });
    for (const box of document.querySelectorAll('main pre, .table, .formula')) wide.observe(box);

    // ---- On paper the folds stand at the end, as in the book: who asks is not answered at once ----

    const made = (name, ...children) => {
        const element = document.createElement(name);
        element.append(...children);
        return element;
    };
    // The exercise or the section that a fold belongs to.
    function ownerOf(fold) {
        let number = '';
        for (let one = fold.previousElementSibling; one; one = one.previousElementSibling) {
            if (one.matches('h2, h3')) return number && /^E.*s$/.test(one.textContent) ? `${one.textContent.slice(0, -1)} ${number}` : one.textContent;
            number ||= one.matches('p:has(> strong:first-child)') && /^(\d+)\./.exec(one.textContent)?.[1];
        }
        return '';
    }
    function unfolded(fold, number) {
        const copy = fold.cloneNode(true);
        for (const one of copy.querySelectorAll('summary, live-chapter, .live-verdict')) one.remove();
        for (const one of copy.querySelectorAll('[id]')) one.removeAttribute('id');
        return [made('h4', `${number}. ${ownerOf(fold)}`), ...copy.childNodes];
    }
    let atEnd = null;
    addEventListener('beforeprint', () => {
        const folds = [...document.querySelectorAll('main details:not(live-chapter *)')];
        if (atEnd || folds.length === 0) return;
        atEnd = made('section', made('h2', 'Hints, answers and solutions'));
        for (const kind of ['Hint', 'Answer', 'Solution']) {
            const own = folds.filter((fold) => fold.firstElementChild.textContent === kind);
            if (own.length > 0) atEnd.append(made('h3', `${kind}s`));
            own.forEach((fold, i) => {
                fold.firstElementChild.dataset.number = ` ${i + 1}: at the end`;
                atEnd.append(...unfolded(fold, i + 1));
            });
        }
        document.querySelector('main').append(atEnd);
    });
    addEventListener('afterprint', () => { atEnd?.remove(); atEnd = null; });
})();
