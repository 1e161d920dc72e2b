// site.js - the script of every page. It handles the theme, the search, the section that is being read, and the
// position where the reader stopped. It is not a module, because browsers run no modules from file://.
(() => {
    const root = document.documentElement;
    const store = (() => { try { return localStorage; } catch { return {}; } })(); // a browser may refuse access
    const page = location.pathname.split('/').pop() || 'index.html';
    const idOf = (hash) => { try { return decodeURIComponent(hash.slice(1)); } catch { return ''; } }; // #100% is malformed, and names nothing
    const inFiles = document.body.classList.contains('file');

    // ---- Theme ----

    const theme = document.querySelector('.theme');
    // The name of each theme, and its icon as an SVG path within 24 by 24 units.
    const themes = {
        '': ['set by the system', 'M12 4a8 8 0 1 0 .1 0zM12 5.5a6.5 6.5 0 1 0 0 13z'],
        light: ['light', 'M12 8a4 4 0 1 0 .1 0zM12 3v1.5M12 19.5V21M3 12h1.5M19.5 12H21M5.6 5.6l1 1M17.4 17.4l1 1M5.6 18.4l1-1M17.4 6.6l1-1'],
        dark: ['dark', 'M19 14.5A7.5 7.5 0 0 1 9.5 5a7.5 7.5 0 1 0 9.5 9.5z'],
    };
    function showTheme(name) {
        const [words, path] = themes[name] || themes[''];
        root.dataset.theme = name;
        theme.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${path}"/></svg>`;
        theme.title = `The theme is ${words}`;
        theme.setAttribute('aria-label', `Theme: ${words}`);
    }
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

    const field = document.querySelector('.search input');
    function load() {
        if (load.begun) return;
        load.begun = true;
        const script = document.createElement('script');
        script.src = field.dataset.index.replace('search.js', 'find.js');
        document.head.append(script);
    }
    field.addEventListener('focus', load);
    field.addEventListener('input', load);
    document.addEventListener('keydown', (event) => {
        const typing = /^(INPUT|TEXTAREA|SELECT|CANVAS)$/.test(document.activeElement.tagName) || document.activeElement.isContentEditable;
        if (event.key === '/' && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) { event.preventDefault(); field.focus(); }
    });

    // ---- The section that is being read ----

    const links = new Map([...document.querySelectorAll('.sections a')].map((link) => [idOf(link.hash), link]));
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

    // ---- When a phone is turned, the line that is being read stays where it is ----

    let line = null, across = innerWidth; // line: the block at the top of the screen, and the share of it that is above
    function mark() {
        for (const top of [60, 75, 90, 120, 150]) {
            const block = document.elementFromPoint(innerWidth / 2, top)?.closest('main :is(p, li, pre, h1, h2, h3, figure, table, live-chapter, summary)');
            const box = block?.getBoundingClientRect();
            if (box) { line = {block, top, share: (top - box.top) / box.height}; return; }
        }
    }
    document.addEventListener('scroll', mark, {passive: true});
    addEventListener('resize', () => {
        if (innerWidth === across || !line?.block.isConnected) return;
        across = innerWidth;
        const {top, height} = line.block.getBoundingClientRect();
        scrollBy({top: top + line.share * height - line.top, behavior: 'instant'});
    });

    // If the target of a link is in a closed fold, open the fold.
    function unfold() {
        const target = location.hash && document.getElementById(idOf(location.hash));
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

    // ---- The position where the reader stopped ----

    const saved = (key) => { try { return JSON.parse(store[key]); } catch { return null; } };
    const words = (heading) => heading.textContent.trim();
    function keep() {
        const here = reading();
        if (inFiles || !here || here.tagName === 'H1') return;
        try {
            store[`read ${page}`] = JSON.stringify({id: here.id, words: words(here)});
            store.last = JSON.stringify({page, title: document.querySelector('h1').textContent, id: here.id, words: words(here)});
        } catch {} // the browser stores nothing
    }
    function offer(text, href, label) {
        const line = document.createElement('p'), link = document.createElement('a'), close = document.createElement('button');
        line.className = 'resume';
        close.type = 'button';
        close.textContent = 'Close';
        link.onclick = () => line.remove();
        close.onclick = () => { line.remove(); document.querySelector('main').focus({preventScroll: true}); };
        link.href = href;
        link.textContent = label;
        line.append(text, link, '.', close);
        document.querySelector('main').prepend(line); // the line floats over the page, so nothing moves
    }
    const last = saved('last'), own = saved(`read ${page}`);
    const again = performance.getEntriesByType('navigation')[0]?.type !== 'navigate'; // after a reload or a return, the browser restores the position
    if (page === 'index.html' && last && last.page !== page) offer('You were reading ', `${last.page}#${last.id}`, `${last.title}, ${last.words}`);
    else if (page !== 'index.html' && own && !location.hash && !again && document.getElementById(own.id)) offer('You stopped at ', `#${own.id}`, own.words);
    document.addEventListener('scrollend', keep);
    addEventListener('pagehide', keep);

    // ---- A film shows one button until it is played. Without this script, it has the browser's buttons. ----

    for (const film of document.querySelectorAll('video')) {
        const button = Object.assign(document.createElement('button'), {type: 'button', className: 'live-start', textContent: '▶ Play', ariaLabel: 'Play the film'});
        film.controls = false;
        film.after(button);
        button.onclick = () => {
            film.controls = true;
            film.focus();
            button.remove();
            film.play();
        };
    }

    // ---- Progress: the chapters that are read, and the exercises that are solved ----

    // A chapter is read when most sections of its story, and its summary, have been at the top of the screen.
    const story = headings.slice(0, headings.findIndex(({id}) => id === 'what-to-remember') + 1).filter(({tagName}) => tagName === 'H2');
    const MOST = 0.7;
    const progress = () => ({read: {}, solved: [], ...saved('progress')});
    function keepProgress(more) {
        try { store.progress = JSON.stringify({...progress(), ...more}); } catch {} // the browser stores nothing
        showProgress();
    }
    const isRead = (stem) => progress().read[stem] === true;
    function visit() {
        const stem = page.replace('.html', ''), line = headings.indexOf(reading()), here = story.filter((one) => headings.indexOf(one) <= line).at(-1);
        if (!here || isRead(stem)) return;
        const {read} = progress(), seen = new Set(read[stem]).add(here.id);
        keepProgress({read: {...read, [stem]: seen.has('what-to-remember') && seen.size >= MOST * story.length || [...seen]}});
    }
    function showProgress() {
        const {solved} = progress();
        for (const link of document.querySelectorAll('.contents [data-exercises]')) {
            const stem = link.getAttribute('href').replace(/^.*\//, '').replace('.html', ''), all = Number(link.dataset.exercises), right = solved.filter((one) => one.slice(0, 2) === stem.slice(0, 2)).length;
            link.querySelector('.done')?.remove();
            const words = [isRead(stem) && 'read', right > 0 && `${right} of ${all} exercises solved`].filter(Boolean).join(', ');
            if (words) link.append(Object.assign(document.createElement('span'), {className: 'done', title: words, innerHTML: `<span aria-hidden="true">${[right > 0 && `${right}/${all}`, isRead(stem) && '✓'].filter(Boolean).join(' ')}</span><span class="unseen">, ${words}</span>`}));
        }
        for (const form of document.querySelectorAll('form.check')) form.classList.toggle('solved', solved.includes(form.dataset.exercise.replace('-', '_')));
    }
    document.addEventListener('scrollend', visit);
    document.addEventListener('solved', ({detail}) => keepProgress({solved: [...new Set([...progress().solved, detail])].sort()}));
    addEventListener('storage', showProgress);
    showProgress();

    // ---- Boxes that scroll sideways can be reached with the keyboard ----

    const wide = new ResizeObserver((seen) => {
        const overflows = seen.map(({target}) => target.scrollWidth > target.clientWidth + 1); // measure all boxes before the first one changes
        seen.forEach(({target}, i) => { if (overflows[i]) target.tabIndex = 0; else target.removeAttribute('tabindex'); });
    });
    for (const box of document.querySelectorAll('main pre, .table, .formula')) wide.observe(box);

    // ---- In print, the folds are at the end, as in the book, so that a question is not followed by its answer ----

    const made = (name, ...children) => {
        const element = document.createElement(name);
        element.append(...children);
        return element;
    };
    // The name of the exercise or section that a fold belongs to.
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
        for (const one of copy.querySelectorAll('live-chapter')) one.replaceWith(...one.querySelectorAll(':is(.live-screen, .sheet-screen) > img'));
        for (const one of copy.querySelectorAll('summary, form, .live-verdict')) one.remove();
        for (const one of copy.querySelectorAll('[id]')) one.removeAttribute('id');
        return [made('h4', `${number}. ${ownerOf(fold)}`), ...copy.childNodes];
    }
    let atEnd = null;
    addEventListener('beforeprint', () => {
        const folds = [...document.querySelectorAll('main details:not(live-chapter *, .question *)')];
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

    // ---- Figures ----

    // What a page does while it rests is loaded last.
    if (document.querySelector('figure-sheet')) addEventListener('load', () => document.head.append(Object.assign(document.createElement('script'), {src: 'sheet_rest.js'})));
})();
