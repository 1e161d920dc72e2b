// monkey.mjs [PATTERN] - a monkey uses the pages of the site: it taps, drags, turns the wheel, presses keys, types into
// the editor, drops files, resizes the window, goes back and reloads, with a mouse at 1440 pixels and with fingers at
// 390. After any of this, the page must still work (`complaint` lists what that means). A sequence of events that fails
// is shortened and printed.
//
// A seed gives the same sequence each time. By default, a few seeds are tried, and with ALL=1 two for each page.
//   PATTERN   the pages with which the monkey begins
//   SEED      the first seed
//   DURATION  try one seed after the other for this number of seconds
//   REPLAY    a sequence that was printed: only this one is tried
import fs from 'node:fs';
import {check, finish, launch, serve, SITE} from './browser.mjs';

// After this number of milliseconds without an answer, a page counts as frozen. This is the only clock that decides a
// test, and it is long because Mesa compiles and draws a chapter on a processor that may be busy with other tests.
const FROZEN = 120e3;
const LENGTH = 60; // the number of scenes in a sequence; a scene is one to a few events
const RUNS = 200; // the maximum number of runs that shorten a sequence
const QUIET = 'source/shaders/main.glsl.html'; // a page without programs, on which memory is measured
const MEMORY = 3e6, CONTEXTS = 3; // how many bytes, and how many graphics contexts, may remain in use

// ---- A sequence ----

// A generator of random numbers (mulberry32), from which all choices are made.
function dice(seed) {
    const next = () => {
        seed = (seed + 0x6d2b79f5) | 0;
        let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
        t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
        return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
    const share = () => Number(next().toFixed(3)), below = (n) => Math.floor(next() * n), of = (list) => list[below(list.length)];
    return {share, below, of, between: (a, b) => a + below(b - a + 1), flips: (chance) => next() < chance};
}

const KEYS = ['Tab', 'Tab', 'Tab', 'Shift+Tab', 'Enter', 'Enter', 'Space', 'Escape', 'Backspace', 'Delete', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'PageUp', 'PageDown', 'Home', 'End', '/',
    'Control+z', 'Control+y', 'Control+a', 'Control+x', 'Control+f', 'Control+Home', 'Control+End', 'Shift+ArrowRight', 'Shift+Enter', ...'wasdrgkhpvcuxoiltnm', ...'0123456789', ...'[],.-=', ...[...'ARGKWUHNP'].map((key) => `Shift+${key}`)];
const SIZES = [[1440, 900], [1440, 900], [390, 844], [390, 844], [844, 390], [1024, 768], [641, 480], [640, 480], [320, 568], [200, 300], [40, 40], [1, 1]];
const WORDS = ['wrong ', '// note\n', '}', '/*', '#include "none.glsl"\n', '0.5', 'é', 'float x = 1.0;\n', '\n', 'shadow', 'sdf'];
const NAMES = ['mine.frag', 'mine.frag', 'two words.glsl', '03_shadows.frag'];
const MEDIA = [{colorScheme: 'dark'}, {colorScheme: 'light'}, {reducedMotion: 'reduce'}, {reducedMotion: 'no-preference'}];

// The scenes, with their weights. A target is [KIND, SHARE]: of the elements of this kind (KINDS), the one at this share
// of the list. It is replaced by the element's path once it has been found.
function scenes(random, pages) {
    const {share, below, of, between, flips} = random;
    const target = (...kinds) => [of(kinds), share()], tap = (...kinds) => ['tap', target(...kinds), share(), share()];
    const key = () => ['key', of(KEYS)], way = () => [of([between(-400, 400), between(-60, 60), of([-3000, 3000])]), of([between(-400, 400), between(-60, 60), of([-3000, 3000])])];
    const text = () => of([`void mainImage(out vec4 c, in vec2 p) { c = vec4(${share()}, ${share()}, 0.5, 1.0); }\n`, 'void mainImage(out vec4 c, in vec2 p) { c = nonsense; }\n', 'a\0b', '']);
    const drag = (...kinds) => [['press', target(...kinds), share(), share(), below(8) === 0 ? 2 : 0], ...Array.from({length: between(1, 4)}, () => flips(0.15) ? key() : ['move', ...way()]), ...flips(0.9) ? [['release']] : []];
    return [
        [10, () => [tap('near')]], [3, () => [tap('any')]],
        [14, () => [tap('program')]],
        [10, () => [tap('start')]],
        [8, () => [tap('studio')]],
        [4, () => [tap('fold'), tap('near')]],
        [10, () => drag('canvas', 'canvas', 'near')],
        [3, () => [['pinch', target('canvas', 'near'), share(), share(), of([0.3, 0.8, 2, 5]), ...way()]]],
        [3, () => [['double', target('near', 'program', 'studio')]]],
        [6, () => [['wheel', share(), share(), of([-2000, -300, 100, 300, 2000])]]],
        [12, () => Array.from({length: between(1, 5)}, key)],
        [12, () => [['focus', target('near', 'program', 'program', 'studio', 'start')], ['key', of(['Enter', 'Space', 'ArrowRight', 'Delete'])]]],
        [3, () => [['down', of(['w', 'd', 'Shift', 'Space'])], tap('near'), ...flips(0.7) ? [['up']] : []]],
        [5, () => [['type', of(WORDS)]]],
        [10, () => [tap('editor'), ['key', of(['Control+Home', 'Control+End', 'Control+a', 'PageDown'])], ['type', of(WORDS)], ['wait', of([0, 1, 30])], ...flips(0.6) ? [['key', 'Control+z'], ['key', 'Control+z']] : []]],
        [4, () => [tap('search'), ['type', of(WORDS)], ['key', of(['ArrowDown', 'Enter', 'Escape'])], ['key', of(['ArrowDown', 'Enter', 'Escape'])]]],
        [4, () => [tap('name'), ['key', 'Control+a'], ['type', of(['mine', 'a b', '/', '03_shadows'])], ['key', of(['Enter', 'Tab'])]]],
        [14, () => [[of(['drop', 'drop', 'choose']), of(NAMES), text()]]],
        [8, () => [tap('draft')]],
        [7, () => [['size', ...of(SIZES)]]],
        [3, () => [['back']]], [2, () => [['forward']]], [2, () => [['reload']]], [2, () => [['go', of(pages)]]],
        [2, () => [['hide'], tap('near'), ['show']]], [2, () => [['blur']]],
        [2, () => [['lose'], ...flips(0.5) ? [tap('program')] : []]],
        [2, () => [['media', of(MEDIA)]]], [1, () => [['print']]],
        [8, () => [['wait', of([0, 1, 5, 40])]]],
    ];
}

function* sequence(seed, pages, begin) {
    const random = dice(seed), all = scenes(random, pages), sum = all.reduce((total, [weight]) => total + weight, 0);
    yield ['open', begin.width, begin.page];
    yield ['tap', ['start', random.share()]];
    for (let i = 0; i < LENGTH; i++) {
        let at = random.below(sum);
        const [, scene] = all.find(([weight]) => (at -= weight) < 0);
        yield* scene();
        if (random.flips(0.7)) yield ['look'];
    }
}

// ---- In the page ----

// This runs in each page before its scripts. window.monkey finds elements and reports what `complaint` needs.
function inPage() {
    const KINDS = {
        near: 'button, input, summary, label, canvas, img, [tabindex], .cm-content, tr', any: 'a[href], button, input, summary, [tabindex]', canvas: '.live-canvas, .scrub, .tap, .sheet-point, input[type=range]',
        program: '.live-on :is(button, input, summary, canvas, [role=tab], tr, .cm-content)', start: '.live-start, .sheet-edit, button.run, form.check button, .scrub, live-chapter:not(.hands) img', fold: 'summary',
        studio: '.drop :is(button, .title)', draft: '.drafts button', editor: '.cm-content, .live-on .live-iconed', search: '.search input', name: '.title',
    };
    const RESETS = /^(Reset this file|Reset all files|Restore|Take the other text|Go back to the previous text|Begin with your changes.*)$/;
    const seen = (one) => one.checkVisibility({visibilityProperty: true}) && one.getBoundingClientRect().width >= 1 && one.getBoundingClientRect().height >= 1;
    const words = (one) => `${one.tagName.toLowerCase()}${one.id ? `#${one.id}` : ''}${one.className && typeof one.className === 'string' ? `.${one.className.trim().replace(/\s+/g, '.')}` : ''}`;
    // A selector that finds an element again. The program's controls move from one element to another.
    function pathOf(one) {
        const steps = [];
        for (; one && one !== document.documentElement; one = one.parentElement) {
            if (one.id) { steps.unshift(`[id=${JSON.stringify(one.id)}]`); break; }
            const fixed = one.matches('.live-controls, .live-notice, .live-canvas') && `.${one.classList[0]}`;
            steps.unshift(fixed || `${one.tagName.toLowerCase()}:nth-child(${[...one.parentElement.children].indexOf(one) + 1})`);
            if (fixed) break;
        }
        return steps.join(' > ');
    }
    const stage = () => [...document.querySelectorAll('live-chapter')].map((one) => one.stage).find(Boolean);
    const read = (start) => { const key = Object.keys(localStorage).find((one) => one.startsWith(`ray marching: ${start}`)); return JSON.parse(localStorage.getItem(key)) ?? {}; };
    const editor = () => { const one = stage()?.changes.editor; return one?.name ? {name: one.name, text: one.text(), waits: one.waits} : null; };
    const contexts = [], own = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        const made = own.call(this, kind, ...more);
        if (made && kind === 'webgl2' && !contexts.some((one) => one.deref() === made)) contexts.push(new WeakRef(made));
        return made;
    };
    // A link to another site would leave the site.
    addEventListener('click', (event) => { const link = event.target.closest?.('a[href]'); if (link && /^http/.test(link.href) && link.origin !== location.origin) event.preventDefault(); }, true);
    // Report what an event may change: the text of a file, or the state of a draft. The element that gets the event
    // counts, because the page may have moved since a target was found.
    const saw = (what) => window.monkeySaw(what);
    for (const type of ['keydown', 'beforeinput', 'click']) addEventListener(type, (event) => {
        const now = editor();
        if (now && event.isTrusted && event.target.closest?.('.cm-editor')) saw(`text ${now.name}`); // also the editor's panel for search and replace
    }, true);
    addEventListener('click', ({target, isTrusted}) => {
        const button = isTrusted && target.closest?.('button'), now = editor();
        if (button && RESETS.test(button.textContent)) for (const name of [...Object.keys(read('changes')), ...now ? [now.name] : []]) saw(`reset ${name}`);
        const [, verb, name] = /^(Delete|Undo: restore) (.*)$/.exec(button?.ariaLabel ?? '') ?? [];
        if (verb) saw(`${verb === 'Delete' ? 'delete' : 'restore'} ${name}`);
    }, true);
    addEventListener('change', ({target}) => {
        const open = target.matches('.title') && document.querySelector('.draft[aria-current=true]')?.textContent.replaceAll(' ', '_');
        if (open) saw(`rename ${open}`);
    }, true);
    let hidden = false;
    Object.defineProperty(document, 'hidden', {get: () => hidden});
    const frame = () => new Promise((done) => requestAnimationFrame(done));

    window.monkey = {
        // Find an element: its path and a point of it on the screen; null if there is none.
        find(target, x, y) {
            let one = null;
            if (typeof target === 'string') one = document.querySelector(target);
            else {
                const all = [...document.querySelectorAll(KINDS[target[0]])].filter((each) => seen(each) && each.type !== 'file'), box = (each) => each.getBoundingClientRect();
                const list = target[0] === 'near' ? all.filter((each) => box(each).bottom > 0 && box(each).top < innerHeight) : all;
                one = list[Math.floor(target[1] * list.length)];
            }
            if (!one || !seen(one)) return null;
            const rect = () => one.getBoundingClientRect();
            if (rect().top < 60 || rect().bottom > innerHeight - 20) one.scrollIntoView({block: 'center', behavior: 'instant'});
            const {left, top, width, height} = rect();
            return {path: pathOf(one), x: Math.round(left + width * (0.1 + 0.8 * x)), y: Math.round(top + height * (0.1 + 0.8 * y))};
        },
        // What is open now.
        //   at    the element that an event activates; undefined for the one that has the focus
        //   keys  is the event one of the keyboard?
        open(at, keys) {
            const one = at ? document.querySelector(at) : document.activeElement;
            return {doc: performance.timeOrigin, editor: editor(), key: keys && one?.matches('button, summary') ? words(one) : ''};
        },
        async look() {
            // A browser takes the focus from a hidden element one frame later. In a tiny window, nothing has a size.
            const active = () => document.activeElement ?? document.body, box = () => active().getBoundingClientRect();
            const lost = () => Math.min(innerWidth, innerHeight) >= 200 && active() !== document.body && (!seen(active()) || box().right + scrollX < 1 || box().bottom + scrollY < 1);
            for (let i = 0; i < 2 || i < 8 && lost(); i++) await frame();
            const drafts = read('drafts');
            const wide = document.documentElement.clientWidth >= 320 && document.documentElement.scrollWidth > document.documentElement.clientWidth + 1;
            const far = wide && [...document.body.querySelectorAll('*')].filter((one) => one.getBoundingClientRect().right > document.documentElement.clientWidth + 1 && seen(one));
            return {
                doc: performance.timeOrigin, address: location.pathname.slice(1), drafts, changes: read('changes'), editor: editor(), body: active() === document.body,
                unfocused: lost() ? words(active()) : '', wide: wide ? `${document.documentElement.scrollWidth} of ${innerWidth} pixels: ${far.slice(0, 2).map(words).join(', ')}` : '',
                gone: document.querySelector('.drafts:not([hidden])') ? Object.keys(drafts).filter((name) => drafts[name].deleted && !document.querySelector(`.drafts [aria-label="Undo: restore ${name}"]`)?.checkVisibility()) : [],
            };
        },
        focus(path) { document.querySelector(path)?.focus({focusVisible: true}); }, // as a reader who presses Tab often enough
        alive: () => contexts.map((one) => one.deref()).filter((one) => one && !one.isContextLost()).length,
        frames: async (count) => { while (count-- > 0) await frame(); },
        drop(name, text) {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([text], name));
            for (const type of ['dragover', 'drop']) (document.querySelector('.drop') ?? document).dispatchEvent(new DragEvent(type, {bubbles: true, cancelable: true, dataTransfer}));
        },
        hide(now) {
            hidden = now;
            document.dispatchEvent(new Event('visibilitychange'));
        },
        blur() {
            for (const one of [document.activeElement, window]) one?.dispatchEvent(new FocusEvent('blur'));
        },
        async lose() {
            const taken = document.querySelector('.live-canvas')?.getContext('webgl2')?.getExtension('WEBGL_lose_context');
            if (!taken) return;
            taken.loseContext();
            for (let i = 0; i < 10; i++) await frame();
            taken.restoreContext();
        },
    };
}

// ---- What must hold ----

// The text with which a file begins.
function originalOf(name, drafts) {
    const exercise = /^chapters\/exercises\/(\d\d)_/.exec(name), draft = /^chapters\/([\w-]+)\.frag$/.exec(name);
    if (draft && drafts[draft[1]]) return drafts[draft[1]].base;
    const file = exercise ? `chapters/${fs.readdirSync('chapters').find((one) => one.startsWith(`${exercise[1]}_`) && one.endsWith('.frag'))}` : name;
    return fs.existsSync(file) ? fs.readFileSync(file, 'utf8') : undefined;
}

// Where two texts differ.
function differ(a = '', b = '') {
    let from = 0;
    while (from < a.length && a[from] === b[from]) from++;
    return JSON.stringify([a, b].map((text) => `${text.length} characters: ${text.slice(from, from + 40)}`));
}

// Compare what a page reports with what it reported before. Returns what is wrong, or ''.
//   before  {now: the last report, may: what events since then may have changed, left: the editor of a page that was
//           left, key: the button that a key pressed}
function complaint(now, before) {
    const {now: old, may, left} = before, has = (what) => may.has(what), typed = (name) => has(`text ${name}`) || has(`reset ${name}`);
    if (now.unfocused) return `the focus is not visible: ${now.unfocused}`;
    if (now.wide) return `the page is too wide: ${now.wide}`;
    if (before.key && now.doc === before.doc && now.body) return `a key took the focus away: ${before.key}`;
    if (now.gone.length > 0) return `a deleted draft has no Undo: ${now.gone}`;
    const textOf = ({changes, drafts}, name) => changes[name] ?? originalOf(name, drafts), file = (name) => `chapters/${name}.frag`;
    if (left && textOf(now, left.name) !== left.text) return `what was typed is lost: ${left.name}`;
    if (now.editor && !now.editor.waits && textOf(now, now.editor.name) !== now.editor.text && originalOf(now.editor.name, now.drafts) !== undefined) return `the editor and the stored text differ: ${now.editor.name}`;
    if (!old) return '';
    for (const [name, draft] of Object.entries(old.drafts)) {
        const text = textOf(old, file(name)), same = now.drafts[name];
        if (!same && !draft.deleted && !(has(`rename ${name}`) && Object.keys(now.drafts).some((one) => textOf(now, file(one)) === text || typed(file(one))))) return `a draft is gone: ${name}`;
        if (same?.deleted && !draft.deleted && !has(`delete ${name}`)) return `a draft is deleted: ${name}`;
        if (same && textOf(now, file(name)) !== text && !typed(file(name))) return `the text of a draft has changed: ${name}: ${differ(text, textOf(now, file(name)))}`;
    }
    for (const [name, text] of Object.entries(old.changes)) {
        if (textOf(now, name) !== text && !typed(name) && !Object.keys(old.drafts).some((one) => file(one) === name)) return `a changed text is replaced: ${name}: ${differ(text, textOf(now, name))}`;
    }
    return '';
}

// ---- Events ----

// Play a sequence. Returns {events, wrong}: the events that were carried out, and what was wrong, or ''.
async function play(browser, server, source) {
    const first = source.next().value, [, width, address] = first, touch = width < 640;
    const context = await browser.newContext({viewport: {width, height: touch ? 844 : 900}, ...touch && {hasTouch: true, isMobile: true, deviceScaleFactor: 2}});
    const events = [first], said = [], before = {now: null, may: new Set(), left: null, key: '', doc: 0, editor: null};
    await context.exposeFunction('monkeySaw', (what) => before.may.add(what));
    await context.addInitScript(inPage);
    const page = await context.newPage(), cdp = await context.newCDPSession(page);
    page.setDefaultTimeout(FROZEN);
    page.on('console', (message) => { if (message.type() === 'error' || /Too many active WebGL/.test(message.text())) said.push(`the console reports: ${message.text()}`); });
    page.on('pageerror', (error) => said.push(`the page throws: ${error.message}`));
    page.on('crash', () => said.push('the page has crashed'));
    context.on('page', (other) => other.close().catch(() => {})); // a link that opens another window

    // Call a function of window.monkey. If the page is being left, it is called again in the next page.
    async function ask(name, ...values) {
        for (let tries = 0; ; tries++) {
            let timer;
            const late = new Promise((_, fail) => { timer = setTimeout(() => fail(new Error('frozen')), FROZEN); });
            try {
                return await Promise.race([page.evaluate(([name, values]) => window.monkey[name](...values), [name, values]), late]);
            } catch (error) {
                if (tries > 50 || !/context was destroyed|navigat|Cannot find context|monkey/i.test(error.message)) throw error;
                await page.waitForLoadState('domcontentloaded').catch(() => {});
            } finally {
                clearTimeout(timer);
            }
        }
    }
    const heap = async () => {
        await cdp.send('HeapProfiler.collectGarbage');
        return (await cdp.send('Runtime.getHeapUsage')).usedSize;
    };
    let held = null, down = '', fingers = null; // where the pointer was pressed, the key that is held down, the fingers on the screen
    const fingersAt = (type, points) => cdp.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
    const clamp = ({x, y}) => { const {width, height} = page.viewportSize(); return [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1)]; };

    async function release(type = 'touchEnd') {
        if (touch && fingers) await fingersAt(type, []);
        else if (held) await page.mouse.up({button: held.button});
        held = fingers = null;
    }
    async function press(at, button = 0) {
        await release();
        held = {...at, button: button === 2 ? 'right' : 'left'};
        if (touch) await fingersAt('touchStart', fingers = [clamp(at)]);
        else {
            await page.mouse.move(at.x, at.y);
            await page.mouse.down({button: held.button});
        }
    }
    async function move(dx, dy) {
        if (!held) return;
        if (touch) await fingersAt('touchMove', fingers = [[held.x + dx, held.y + dy]]);
        else await page.mouse.move(held.x + dx, held.y + dy, {steps: 2});
    }
    const verbs = {
        look: async () => {}, focus: (at) => ask('focus', at.path), press, move, release,
        tap: async (at) => { await press(at); await release(); },
        double: async (at) => { await press(at); await release(); await press(at); await release(); },
        pinch: async (at, factor, dx, dy) => {
            await release();
            const pair = (by, x, y) => [[x - 30 * by, y], [x + 30 * by, y + 10]];
            if (!touch) return press(at);
            await fingersAt('touchStart', pair(1, at.x, at.y));
            await fingersAt('touchMove', pair(factor, at.x, at.y));
            await fingersAt('touchMove', pair(factor, at.x + dx, at.y + dy));
            await fingersAt('touchEnd', []);
        },
        wheel: async (x, y, by) => {
            const {width, height} = page.viewportSize();
            await page.mouse.move(x * width, y * height);
            await page.mouse.wheel(0, by);
        },
        key: (key) => page.keyboard.press(key),
        down: async (key) => { await page.keyboard.down(down = key); },
        up: async () => { if (down) await page.keyboard.up(down); down = ''; },
        type: (text) => page.keyboard.type(text),
        drop: (name, text) => ask('drop', name, text),
        choose: async (name, text) => { if (await page.locator('#file').count() > 0) await page.locator('#file').setInputFiles({name, mimeType: 'text/plain', buffer: Buffer.from(text)}); },
        size: (width, height) => page.setViewportSize({width, height}),
        back: () => page.goBack({waitUntil: 'commit'}),
        forward: () => page.goForward({waitUntil: 'commit'}),
        reload: () => page.reload({waitUntil: 'commit'}),
        go: (address) => page.goto(`${server.at}/${address}`, {waitUntil: 'commit'}),
        hide: () => ask('hide', true), show: () => ask('hide', false), blur: () => ask('blur'), lose: () => ask('lose'),
        media: (media) => page.emulateMedia(media),
        print: async () => {
            await page.emulateMedia({media: 'print'});
            await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
            await page.evaluate(() => dispatchEvent(new Event('afterprint')));
            await page.emulateMedia({media: 'screen'});
        },
        wait: (count) => ask('frames', count),
    };
    const TARGETED = ['tap', 'double', 'press', 'pinch', 'focus'];

    // Carry out one event.
    async function act(event) {
        let [verb, ...values] = event, at = null;
        if (TARGETED.includes(verb)) {
            const [target, x = 0.5, y = 0.5, ...more] = values;
            at = await ask('find', target, x, y);
            if (!at) return;
            event[1] = at.path;
            values = [at, ...more];
        }
        events.push(event);
        const {doc, editor, key} = await ask('open', at?.path, ['key', 'type', 'down'].includes(verb));
        if (before.doc === doc || !before.doc) Object.assign(before, {doc, editor});
        before.key = verb === 'key' && /^(Enter|Space)$/.test(values[0]) ? key : verb === 'look' || verb === 'wait' ? before.key : '';
        await verbs[verb](...values).catch((error) => { if (!/ERR_ABORTED|interrupted by another navigation/.test(error.message)) throw error; }); // a link was faster
    }
    async function look() {
        const now = await ask('look');
        if (before.doc && now.doc !== before.doc) before.left = before.editor; // the page has been left
        const wrong = complaint(now, before) || said[0] || '';
        const settled = (name) => now.editor?.name === name && !now.editor.waits;
        Object.assign(before, {now, doc: now.doc, editor: now.editor, left: null, key: ''});
        before.may = new Set([...before.may].filter((what) => /^(rename|reset) /.test(what) || what.startsWith('text ') && !settled(what.slice(5)))); // what loads a file first comes later
        return wrong;
    }
    // At the end, Undo restores each deleted draft, and the page's memory and graphics contexts are freed.
    async function end(quiet) {
        const {drafts, address} = before.now ?? {drafts: {}};
        for (const name of address === 'play.html' ? Object.keys(drafts).filter((name) => drafts[name].deleted) : []) {
            before.may.add(`restore ${name}`);
            await page.evaluate((name) => document.getElementById(`drop-${name}`)?.click(), name);
            const wrong = await look();
            if (wrong || before.now.drafts[name]?.deleted) return wrong || `Undo does not restore a draft: ${name}`;
        }
        await heap();
        const alive = await ask('alive');
        if (alive > CONTEXTS) return `${alive} graphics contexts are in use`;
        await verbs.go(QUIET);
        const wrong = await look(), more = await heap() - quiet;
        return wrong || (more > MEMORY ? `${(more / 1e6).toFixed(1)} MB of memory remain in use` : '');
    }

    let wrong = '';
    try {
        // The browser's blank page must not remain in the history, because a swipe leads back to it.
        await Promise.all([page.waitForURL(`${server.at}/${QUIET}`), page.evaluate((address) => location.replace(address), `${server.at}/${QUIET}`)]);
        const quiet = await heap();
        await page.goto(`${server.at}/${address}`);
        for (const event of source) {
            await act(event);
            if (event[0] === 'look') wrong = await look();
            if (wrong ||= said[0] ?? '') break;
        }
        wrong ||= await look() || await end(quiet);
    } catch (error) {
        wrong = said[0] ?? (/frozen|Timeout/.test(error.message) ? `the page is frozen: ${error.message.split('\n')[0]}` : `the test fails: ${error.message.split('\n')[0]}`);
    }
    await context.close();
    return {events, wrong};
}

// ---- A failure ----

const kindOf = (wrong) => wrong.replace(/[\d.]+/g, '0').slice(0, 60);

// Drop as many events of a failing sequence as possible. Returns the shortest sequence that was found to fail in the
// same way, or null if the failure did not happen again.
async function shorten(browser, server, failure) {
    let [first, ...events] = failure.events, runs = 0;
    const fails = async (some) => ++runs <= RUNS && kindOf((await play(browser, server, structuredClone([first, ...some])[Symbol.iterator]())).wrong) === kindOf(failure.wrong);
    if (!await fails(events) && !await fails(events)) return null;
    for (let size = Math.ceil(events.length / 2), dropped = false; size > 0; dropped = false) {
        for (let from = 0; from < events.length;) {
            const fewer = events.toSpliced(from, size);
            if (await fails(fewer)) { events = fewer; dropped = true; } else from += size;
        }
        if (size === 1 && !dropped) break;
        size = Math.max(1, size >> 1);
    }
    return [first, ...events];
}

const shell = (events) => `REPLAY='${JSON.stringify(events).replaceAll('\'', '\'\\\'\'')}' node tests/web/monkey.mjs`;

// ---- The run ----

const server = await serve(SITE), browser = await launch();
const {SEED, DURATION, REPLAY, ALL} = process.env, pattern = new RegExp(process.argv[2] || ''), begun = Date.now();
const pages = fs.readdirSync(SITE).filter((name) => name.endsWith('.html')).sort(), chosen = pages.filter((name) => pattern.test(name));
const FEW = ['play.html', 'play.html', '23_stored_distances.html', '03_shadows.html'];
const begins = (process.argv[2] || ALL || DURATION ? [...chosen, ...chosen.map(() => 'play.html').slice(0, chosen.includes('play.html') ? chosen.length / 4 : 0)] : FEW);

async function session(name, source) {
    const found = await play(browser, server, source);
    check(`${name}: the page still works after ${found.events.length} events`, !found.wrong, found.wrong);
    if (!found.wrong || REPLAY) return;
    const short = await shorten(browser, server, found);
    console.log(short ? `# ${short.length} events suffice:` : '# this did not happen again; the events were:');
    console.log(`# ${shell(short ?? found.events)}`);
}

if (REPLAY) await session('REPLAY', JSON.parse(REPLAY)[Symbol.iterator]());
else {
    const from = Number(SEED || 1), most = DURATION ? Infinity : process.argv[2] || ALL ? 2 * begins.length : begins.length;
    for (let i = 0; i < most && (!DURATION || Date.now() - begun < 1000 * DURATION); i++) {
        // A seed determines the page and the width, so that it can be tried alone.
        const seed = from + i, begin = {width: seed % 2 === 1 ? 1440 : 390, page: begins[(seed >> (begins === FEW ? 0 : 1)) % begins.length]};
        await session(`seed ${seed}, ${begin.page}, ${begin.width} pixels`, sequence(seed, pages, begin));
    }
}
finish();
await browser.close();
server.close();
