// program.js - runs a chapter's program in a page. It loads the harness once, gives the harness the files that a
// command line needs, lets it draw frames, and passes on the input on the canvas. It creates no elements.
import loadHarness from './harness.js';

const ROOT = '/course/';
const PRESS = 1, RELEASE = 0, REPEAT = 2;
const CAPTURE = 77; // the key M captures the mouse, or releases it
const FINGER = 30; // the distance, in CSS pixels, within which a finger grabs a handle
const POLL = 20; // milliseconds between two checks of a driver that is compiling
const PIXELS = 1280 * 720; // the maximum number of pixels in the drawing buffer; fewer are used if a frame takes too long

// Maps the position of a key on the keyboard to GLFW's key code. Tab and the function keys are left to the browser.
const KEYS = {
    Space: 32, Quote: 39, Comma: 44, Minus: 45, Period: 46, Slash: 47, Semicolon: 59, Equal: 61, BracketLeft: 91, Backslash: 92,
    BracketRight: 93, Backquote: 96, Escape: 256, Enter: 257, Backspace: 259, Insert: 260, Delete: 261, ArrowRight: 262,
    ArrowLeft: 263, ArrowDown: 264, ArrowUp: 265, PageUp: 266, PageDown: 267, Home: 268, End: 269, ShiftLeft: 340, ShiftRight: 344,
};
const CODES = Object.fromEntries(Object.entries(KEYS).map(([code, key]) => [key, code]));
const CURSORS = {0x36002: 'text', 0x36003: 'crosshair', 0x36004: 'pointer', 0x36005: 'ew-resize', 0x36006: 'ns-resize'};

// GLFW's code for the key of an event; 0 for a key that is left to the browser. Every combination with Ctrl, Alt or
// Command is left to the browser: Ctrl+W closes the page.
function keyOf(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return 0;
    const match = /^(?:Key([A-Z])|Digit([0-9]))$/.exec(event.code);
    return match ? (match[1] || match[2]).charCodeAt(0) : KEYS[event.code] || 0;
}

function codeOf(key) {
    return key >= 48 && key <= 57 ? `Digit${key - 48}` : key >= 65 && key <= 90 ? `Key${String.fromCharCode(key)}` : CODES[key];
}

// If the system asks for reduced motion, the time is paused until the reader resumes it.
export const calm = matchMedia('(prefers-reduced-motion: reduce)');

// The labels of the keyboard's keys, if the browser provides them.
let labels = null;
navigator.keyboard?.getLayoutMap?.().then((map) => { labels = map; }, () => {});

async function fetched(url) {
    const answer = await fetch(url);
    if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}`);
    return answer;
}

export class Program {
    // Load the module for a canvas that no other program uses. Hooks:
    //   onLine(text, isError)   the program prints a line
    //   onPicture(data, name)   the program writes a picture, an ImageData
    //   onSize(width, height)   the program asks for a window or a picture of that size
    //   onDraw()                the first picture after a start has been drawn
    //   onEnd()                 the program has ended; state().error is the reason, or '' if the reader closed it
    //   onLost()                the browser has taken the graphics context away
    //   onFound(fails)          the browser has given the context back; `fails` is true if the shader that was running
    //                           can no longer be loaded
    static async load(canvas, hooks = {}) {
        const program = new Program();
        program.canvas = canvas;
        program.hooks = hooks;
        program.visible = program.near = true;
        program.later = new Set();
        program.originals = new Map();
        const [course, module] = await Promise.all([
            fetched(new URL('course.json', import.meta.url)).then((answer) => answer.json()),
            loadHarness({
                canvas,
                print: (text) => program.line(text, false),
                printErr: (text) => program.line(text, true),
                locateFile: (name) => new URL(name, import.meta.url).href,
            }),
        ]);
        program.module = module;
        Object.assign(module, {
            onPicture: (data, name) => hooks.onPicture?.(data, name),
            onSize: (width, height) => hooks.onSize?.(width, height),
            onTitle: (text) => { program.title = text; },
            onCapture: (captured) => program.capture(captured),
            onCursor: (shape) => { canvas.style.cursor = CURSORS[shape] || ''; },
            keyLabel: (key) => labels?.get(codeOf(key)) || '',
        });
        for (const [name, text] of Object.entries(course.files)) {
            program.originals.set(name, text);
            program.write(name, text);
        }
        program.later = new Set(course.later);
        program.course = new Set([...Object.keys(course.files), ...course.later]);
        program.needs = (name) => (course.needs[name] ?? []).map((i) => course.later[i]);
        module.FS.chdir(ROOT);
        program.hear();
        program.watch();
        return program;
    }

    line(text, isError) {
        if (!this.quiet) this.hooks.onLine?.(text, isError);
    }

    // ---- Files ----

    // Write a file of the course; the running shader is reloaded if it uses this file.
    write(name, data) {
        const path = ROOT + name, folder = path.slice(0, path.lastIndexOf('/'));
        this.module.FS.mkdirTree(folder);
        this.module.FS.writeFile(path, data);
        this.written = performance.now();
        this.later.delete(name);
    }

    read(name) {
        return this.module.FS.readFile(ROOT + name, {encoding: 'utf8'});
    }

    // The course's own text of a file; null if the course has no such file.
    async original(name) {
        if (!this.course.has(name)) return null;
        if (!this.originals.has(name)) this.originals.set(name, await fetched(new URL(`course/${name}`, import.meta.url)).then((answer) => answer.text()));
        return this.originals.get(name);
    }

    // Load the missing files that a command line needs. All files of the course's shaders are requested at once; then,
    // one after the other, what a changed text includes and its textures.
    async fetchFiles(stem, line) {
        let asked = [...(/(^| )(--shader|-f)[ =]/.test(line) ? [] : [`chapters/${stem}.frag`]), ...line.split(/[ =]/)].flatMap(this.needs);
        for (;;) {
            const missing = [...new Set(asked)].filter((name) => this.later.has(name));
            await Promise.all(missing.map(async (name) => {
                const answer = await fetched(new URL(`course/${name}`, import.meta.url));
                this.write(name, new Uint8Array(await answer.arrayBuffer()));
            }));
            this.quiet = true;
            asked = JSON.parse(this.call('live_files', stem, line)).map((path) => path.startsWith(ROOT) ? path.slice(ROOT.length) : path);
            this.quiet = false;
            if (!asked.some((name) => this.later.has(name))) return;
        }
    }

    // ---- A command line ----

    // Call a function of live.h. Returned strings are copied from the program's memory.
    call(name, ...values) {
        const texts = ['live_files', 'live_state', 'live_report', 'live_version'];
        return this.module.ccall(name, texts.includes(name) ? 'string' : 'number', values.map((value) => typeof value), values);
    }

    // Execute a command line as the chapter's program would. Returns the exit status.
    //   still  pause the time of a window, unless it keeps frames and stops at that of the command line
    async start(stem, line = '', still = false) {
        const turn = this.starting = Symbol(stem);
        await this.fetchFiles(stem, line);
        if (this.starting !== turn) return 0; // another start or a stop was requested meanwhile
        this.quiet = true; // live_start reports the same errors again
        this.call('live_begin', stem, line);
        this.quiet = false;
        while (!this.call('live_ready')) {
            await new Promise((done) => setTimeout(done, POLL));
            if (this.starting !== turn) return 0;
        }
        const status = this.call('live_start', stem, line);
        const stops = /(^| )--frame[ =]/.test(line) && this.state().kept !== undefined;
        if ((still || calm.matches) && !stops) this.call('live_pause', 1);
        this.fresh = true;
        this.fit();
        this.run();
        return status;
    }

    state() {
        return JSON.parse(this.call('live_state'));
    }

    // Has the program read all files since the last one was written? The program looks for changes every 0.1 s.
    get reread() { return this.turned - this.written > 200; }

    stop() {
        this.starting = null;
        this.call('live_stop');
    }

    // Draw frames as long as the canvas is visible.
    run() {
        const turn = () => {
            this.asked = 0;
            this.turned = performance.now();
            if (!this.visible || this.lost || !this.call('live_runs')) return;
            const goes = this.module._live_turn();
            if (goes && this.fresh) this.hooks.onDraw?.();
            this.fresh = false;
            if (goes) this.asked = requestAnimationFrame(turn);
            else if (!this.canvas.getContext('webgl2').isContextLost()) this.hooks.onEnd?.();
        };
        if (!this.asked) this.asked = requestAnimationFrame(turn);
    }

    // ---- The page ----

    fit() {
        const {canvas} = this, width = canvas.clientWidth, height = canvas.clientHeight;
        if (width < 1 || height < 1) return;
        const ratio = Math.min(devicePixelRatio, Math.sqrt(PIXELS / (width * height)));
        const across = Math.max(1, Math.round(width * ratio)), down = Math.max(1, Math.round(height * ratio));
        if (canvas.width !== across) canvas.width = across;
        if (canvas.height !== down) canvas.height = down;
        this.module._live_size(width, height, across, down);
    }

    show() {
        const visible = !document.hidden && this.near;
        if (visible === this.visible) return;
        this.visible = visible;
        this.module._live_hide(visible ? 0 : 1);
        if (visible) this.run();
    }

    watch() {
        const {canvas} = this;
        new ResizeObserver(() => this.fit()).observe(canvas);
        new IntersectionObserver((entries) => { this.near = entries.at(-1).isIntersecting; this.show(); }).observe(canvas);
        document.addEventListener('visibilitychange', () => this.show());
        canvas.addEventListener('webglcontextlost', (event) => {
            event.preventDefault(); // otherwise the context would never be restored
            this.lost = true;
            this.hooks.onLost?.();
        });
        canvas.addEventListener('webglcontextrestored', () => {
            this.lost = false;
            const ran = this.call('live_runs') === 1;
            if (ran) this.restore();
            this.hooks.onFound?.(ran && !this.call('live_runs'));
        });
    }

    // Create everything again after the context was lost. If the shader can no longer be loaded, there is no window
    // until the files have been changed and this function has been called again.
    restore() {
        this.call('live_restore');
        this.run();
    }

    // ---- Input ----

    hear() {
        const {canvas, module} = this;
        const modifiers = (event) => (event.shiftKey ? 1 : 0) | (event.ctrlKey ? 2 : 0) | (event.altKey ? 4 : 0);
        const key = (event, action) => {
            const number = keyOf(event);
            if (number === 0) return;
            event.preventDefault();
            module._live_key(number, action, modifiers(event));
            if (action !== RELEASE && [...event.key].length === 1) module._live_type(event.key.codePointAt(0));
        };
        canvas.addEventListener('keydown', (event) => key(event, event.repeat ? REPEAT : PRESS));
        canvas.addEventListener('keyup', (event) => key(event, RELEASE));
        canvas.addEventListener('focus', () => module._live_focus(1));
        // A finger on a handle drags the handle; elsewhere, it scrolls the page unless the picture has the focus. While
        // a tool is active, a single finger acts on the picture everywhere.
        canvas.addEventListener('touchstart', (event) => { if (event.touches.length === 1 && this.toHandle(event.touches[0])) event.preventDefault(); }, {passive: false});
        canvas.addEventListener('blur', () => module._live_focus(0));
        // The wheel scrolls the page unless the picture has the focus.
        canvas.addEventListener('wheel', (event) => {
            if (document.activeElement !== canvas) return;
            event.preventDefault();
            module._live_wheel(-event.deltaY / (event.deltaMode === 0 ? 100 : 3));
        }, {passive: false});
        for (const name of ['pointerlockchange', 'pointerlockerror']) document.addEventListener(name, () => this.agree());
        this.hearPointer(modifiers);
    }

    // Capture the mouse, or release it, as the program asks.
    capture(captured) {
        this.captured = captured;
        if (captured) this.canvas.requestPointerLock()?.catch(() => {}); // a refusal is also the event pointerlockerror
        else this.agree();
    }

    // The browser captures the mouse some time after the program has asked for it, or refuses. It releases the mouse
    // when the reader presses Escape or leaves the page. The program is told by its own key.
    agree() {
        const has = document.pointerLockElement === this.canvas;
        if (has && !this.captured) document.exitPointerLock();
        if (has || !this.captured) return;
        this.module._live_key(CAPTURE, PRESS, 0);
        this.module._live_key(CAPTURE, RELEASE, 0);
    }

    // The vector from a finger to the handle that it grabs, in CSS pixels, or null if no handle is near. While a tool
    // is active, the finger grabs no handle and the vector is zero.
    toHandle({clientX, clientY}) {
        const {left, top, width, height} = this.canvas.getBoundingClientRect();
        const {handles = [], tool} = this.state();
        if (tool) return [0, 0];
        const ways = handles.map(({x, y}) => [left + x * width - clientX, top + y * height - clientY]);
        const near = ways.sort((a, b) => Math.hypot(...a) - Math.hypot(...b))[0];
        return near && Math.hypot(...near) <= FINGER ? near : null;
    }

    // One finger or the mouse drags and clicks; two fingers act as the wheel. A touch away from any handle counts as a
    // press only once the finger moves or is lifted, because a second finger may follow: putting two fingers down and
    // lifting them is not a click. The picture gets the keyboard focus, and with it the wheel and all swipes, once the
    // reader has clicked, tapped or dragged it.
    hearPointer(modifiers) {
        const {canvas, module} = this;
        const fingers = new Map(), locked = [0, 0];
        let spread = 0, held = null, away = [0, 0]; // away is the vector from the finger to the handle that it drags
        const between = () => {
            const [a, b] = [...fingers.values()];
            return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
        };
        const place = (event) => {
            const box = canvas.getBoundingClientRect();
            module._live_pointer(event.clientX - box.left + away[0], event.clientY - box.top + away[1]);
        };
        const button = (event) => [0, 2, 1][event.button] ?? 0;
        const press = (event) => {
            held = null;
            canvas.focus({preventScroll: true});
            place(event);
            module._live_button(button(event), 1, modifiers(event));
        };
        canvas.addEventListener('pointerdown', (event) => {
            fingers.set(event.pointerId, event);
            if (!document.pointerLockElement) canvas.setPointerCapture(event.pointerId); // which is an error while the mouse is captured
            if (fingers.size === 2) {
                spread = between();
                if (!held) module._live_button(0, 0, 0);
                held = null;
            } else if (fingers.size === 1) {
                const handle = event.pointerType === 'touch' && this.toHandle(event);
                away = handle || [0, 0];
                if (event.pointerType === 'touch' && !handle) held = event;
                else press(event);
            }
        });
        canvas.addEventListener('pointermove', (event) => {
            if (document.pointerLockElement === canvas) {
                locked[0] += event.movementX;
                locked[1] += event.movementY;
                module._live_pointer(...locked);
                return;
            }
            if (fingers.has(event.pointerId)) fingers.set(event.pointerId, event);
            if (fingers.size === 2) {
                const now = between();
                if (spread > 0 && now > 0) module._live_wheel(12 * Math.log(now / spread));
                spread = now;
            } else {
                const way = held ? [event.clientX - held.clientX, event.clientY - held.clientY].map(Math.abs) : [0, 0];
                if (Math.hypot(...way) > 3) {
                    if (way[1] > way[0] && getComputedStyle(canvas).touchAction !== 'none') fingers.delete(event.pointerId); // the page scrolls
                    else press(held);
                }
                if (!held) place(event);
            }
        });
        const up = (event) => {
            if (!fingers.delete(event.pointerId)) return;
            if (held) press(held);
            module._live_button(button(event), 0, modifiers(event));
        };
        canvas.addEventListener('pointerup', up);
        canvas.addEventListener('pointercancel', (event) => { held = null; up(event); });
        canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    }
}
