// stage.js - a running program with its controls: canvas, views, time, values, the ray of a pixel, and the editor. A
// page has only one stage, in the <live-chapter> that was used last.
import {calm, Program} from './program.js';
import {Changes} from './changes.js';
import {shownBy, withChanges} from './edits.js';
import {Values} from './values.js';
import {Ray} from './ray.js';

const HALVES = 'This device keeps frames in numbers of 16 bits: a mean stops after 64 frames, and simulations differ from those on a desktop.';
const LOOK = 200; // milliseconds between two updates from the program's state
const LONG = 2000; // milliseconds of compiling after which the reader is told
const PRESS = 1, RELEASE = 0;
const PAD = [['◀', 65, 'left'], ['▲', 87, 'forwards'], ['▼', 83, 'backwards'], ['▶', 68, 'right'], ['⤒', 32, 'up'], ['⤓', 67, 'down']];
const RESTART = 82, SHIFT = 1, NEXT_HANDLE = 257, TAKE_BACK = 85;
// The icons of the buttons, as SVG paths within 24 by 24 units. On a wide page, named buttons show their names instead.
const ICONS = {
    'Pause': 'M8 5v14M16 5v14', 'Resume': 'M8 5l11 7-11 7z', 'Restart': 'M5 12a7 7 0 1 0 2-5M5 3v5h5', 'Undo stroke': 'M9 4L4 9l5 5M4 9h10a5 5 0 0 1 0 10H9', 'Views': 'M2 12q10-14 20 0q-10 14-20 0zM12 9a3 3 0 1 0 .1 0',
    'Values': 'M4 6h16M4 12h16M4 18h16M9 4v4M15 10v4M7 16v4', 'Ray': 'M12 3v6M12 15v6M3 12h6M15 12h6M12 11.5v1', 'Move': 'M12 3v18M3 12h18M9 6l3-3 3 3M9 18l3 3 3-3M6 9l-3 3 3 3M18 9l3 3-3 3',
    'Reset camera': 'M4 8h3l2-3h6l2 3h3v11H4zM12 10a3.5 3.5 0 1 0 .1 0', 'Edit': 'M4 20l1-5L16 4l4 4L9 19z', 'Full screen': 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5', 'Close': 'M5 5l14 14M19 5L5 19',
};

export class Stage {
    static async load(part) {
        const stage = new Stage();
        stage.narrow = matchMedia('(max-width: 640px)');
        stage.part = part;
        stage.build();
        stage.program = await Program.load(stage.canvas, {
            onLine: (text, isError) => stage.heard(text, isError),
            onPicture: (data, name) => stage.show(data, name),
            onSize: (width, height) => { stage.asked = [width, height]; },
            onDraw: () => stage.drew(),
            onEnd: () => stage.ended(),
            onLost: () => stage.note('The graphics driver stopped drawing this picture. It will be drawn again as soon as the browser allows.', ...stage.undoing()),
            onFound: (fails) => stage.found(fails),
        });
        setInterval(() => stage.look(), LOOK);
        return stage;
    }

    button(text, act, more = {}) {
        const button = this.part('button', {type: 'button', textContent: text, ...more});
        button.addEventListener('click', () => { act(); this.look(); });
        return button;
    }

    // A button that shows an icon.
    icon(text, act, more = {}) {
        return this.name(this.button('', act, {...more, className: `live-iconed ${more.className ?? ''}`}), text);
    }

    name(button, text) {
        if (button.textContent === text) return button;
        button.title = text;
        button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${ICONS[text]}"/></svg><span>${text}</span>`;
        return button;
    }

    // A button that shows or hides a part.
    //   shows  toggles the part, and returns true if it is now visible
    //   where  live-toggle for a button of narrow pages, live-named for one that shows its name on a wide page
    toggle(text, shows, where = 'live-toggle') {
        const button = this.icon(text, () => button.setAttribute('aria-expanded', shows()), {className: where});
        button.setAttribute('aria-expanded', 'false');
        return button;
    }

    // A button that opens or closes a fold. A closed fold is not shown, so the button then gets the focus.
    unfolds(text, {element}) {
        const button = this.toggle(text, () => {
            element.open = !element.open;
            if (element.open && this.at.matches('.live-editing')) element.scrollIntoView({block: 'nearest'}); // the text may be in between
            return element.open;
        }, 'live-named');
        element.addEventListener('toggle', () => button.setAttribute('aria-expanded', element.open));
        element.firstElementChild.addEventListener('click', () => { if (element.open) button.focus({preventScroll: true}); });
        return button;
    }

    build() {
        const {part} = this;
        this.canvas = part('canvas', {className: 'live-canvas', tabIndex: 0});
        this.canvas.setAttribute('role', 'img');
        this.canvas.addEventListener('pointerdown', (event) => { if (event.pointerType === 'touch') for (const one of [this.controls, this.free]) one.classList.add('live-touched'); });
        this.status = part('p', {className: 'live-status'});
        this.free = part('button', {type: 'button', textContent: 'Swipes act on the picture ✕', className: 'live-free', tabIndex: -1, title: 'Let swipes scroll the page'});
        this.free.addEventListener('pointerdown', (event) => {
            event.preventDefault(); // otherwise, the tap would select the picture below again
            this.canvas.blur();
        });
        this.free.addEventListener('mousedown', (event) => event.preventDefault()); // the end of the tap on the picture that has shown this button
        this.notice = part('p', {className: 'live-notice', hidden: true});
        this.notice.setAttribute('role', 'status');
        this.pad = part('div', {className: 'live-pad'});
        this.pad.setAttribute('role', 'group');
        this.pad.setAttribute('aria-label', 'Move');
        for (const [sign, key, where] of PAD) this.pad.append(this.held(sign, key, `Move ${where}`));
        this.views = part('span', {className: 'live-views'});
        this.views.setAttribute('role', 'group');
        this.views.setAttribute('aria-label', 'View');
        this.canvas.addEventListener('focus', () => this.takeHandle());
        this.pause = this.icon('Pause', () => this.call('live_pause', this.state.paused ? 0 : 1));
        this.time = part('input', {type: 'number', step: 'any', className: 'live-time'});
        this.time.setAttribute('aria-label', 'Time in seconds');
        this.time.addEventListener('change', () => this.call('live_time', Number(this.time.value)));
        this.back = this.icon('Reset camera', () => this.press(RESTART, SHIFT), {className: 'live-back'});
        this.undo = this.icon('Undo stroke', () => this.press(TAKE_BACK));
        this.still = part('small', {className: 'live-still', textContent: 'time is paused, because your system asks for reduced motion', hidden: true});
        this.changes = new Changes(this);
        this.values = new Values(this);
        this.ray = new Ray(this);
        const flips = (name) => () => this.controls.classList.toggle(name);
        this.bar = part('div', {className: 'live-bar'}, this.views,
            this.clock = part('span', {className: 'live-clock'}, this.pause, this.icon('Restart', () => this.press(RESTART)), this.back, this.undo, part('label', {}, this.time, ' s'), this.still),
            part('span', {className: 'live-tools'}, this.viewer = this.toggle('Views', flips('live-more')), this.unfolds('Values', this.values), this.rays = this.unfolds('Ray', this.ray), this.mover = this.toggle('Move', flips('live-moves')),
                this.changes.open, this.icon('Full screen', () => this.full(), {className: 'live-full'}), this.icon('Close', () => this.close())));
        this.bar.setAttribute('role', 'toolbar');
        this.bar.setAttribute('aria-label', 'The program');
        this.error = part('pre', {className: 'live-error', hidden: true});
        this.error.setAttribute('role', 'alert');
        this.controls = part('div', {className: 'live-controls', hidden: true}, this.pad, this.bar, this.changes.element, this.changes.line, this.changes.replaced, this.changes.other, this.error, this.values.element, this.ray.element);
        this.values.element.append(this.status);
    }

    // A button that acts as a key for as long as it is held down.
    held(sign, key, label) {
        const button = this.part('button', {type: 'button', textContent: sign});
        button.setAttribute('aria-label', label);
        const up = () => { this.program.module._live_key(key, RELEASE, 0); };
        button.addEventListener('pointerdown', (event) => {
            event.preventDefault(); // otherwise the browser would select text or open a menu
            if (!document.pointerLockElement) button.setPointerCapture(event.pointerId);
            this.program.module._live_key(key, PRESS, 0);
        });
        for (const name of ['pointerup', 'pointercancel', 'blur']) button.addEventListener(name, up);
        button.addEventListener('keydown', (event) => { if (event.code === 'Enter' || event.code === 'Space') this.program.module._live_key(key, PRESS, 0); });
        button.addEventListener('keyup', up);
        button.addEventListener('contextmenu', (event) => event.preventDefault());
        return button;
    }

    call(name, ...values) {
        const done = this.program.call(name, ...values);
        this.look();
        return done;
    }

    press(key, modifiers = 0) {
        this.program.module._live_key(key, PRESS, modifiers);
        this.program.module._live_key(key, RELEASE, modifiers);
    }

    // ---- A command line ----

    // Run a command line in an element, to which the program moves. Returns the exit status.
    async start(at, line, shown = {}) {
        const turn = this.turn = Symbol(line), asked = at.opener ?? at, top = asked.getBoundingClientRect().top;
        this.move(at);
        this.lines = [];
        this.pictures = [];
        this.asked = null;
        this.note(this.unset = '');
        this.starting = true;
        at.result?.remove();
        at.said?.remove();
        scrollBy({top: asked.getBoundingClientRect().top - top, behavior: 'instant'}); // elements above may have been removed
        // Let the browser paint 'Compiling …' (live.css) before the program uses the processor.
        this.compiles(false);
        this.compiles(true);
        this.again = () => this.start(at, line, shown);
        await new Promise((painted) => requestAnimationFrame(() => setTimeout(painted)));
        this.line = await this.changes.begin(at) ?? line;
        const status = this.turn === turn ? await this.carry(at.stem, this.line, shown.still) : 0;
        if (this.turn !== turn) return 0;
        this.compiles(false);
        this.again = null;
        this.starting = false;
        this.shown = shown;
        this.tell(at, status);
        return status;
    }

    // Execute a command line. If it fails because of the reader's changes, show the picture without them, together with
    // the error, as if the program had been running when they were made.
    async carry(stem, line, still) {
        const status = await this.program.start(stem, line, still);
        if (status !== 1 || !this.changes.any) return status;
        const lines = this.lines;
        this.lines = [];
        await this.changes.lay(true);
        const without = await this.program.start(stem, line, still);
        if (!this.program.call('live_runs')) this.lines = lines; // without a window, the messages are the result
        await this.changes.lay(false);
        return this.program.call('live_runs') ? without : status;
    }

    // The browser has restored the graphics context. If the reader's changes can no longer be loaded, show the picture
    // without them, as `carry` does.
    async found(fails) {
        const {turn} = this;
        this.note('');
        this.wrong = '';
        if (!fails) return;
        await this.changes.lay(true);
        if (this.turn === turn) this.program.restore();
        await this.changes.lay(false);
        if (this.turn === turn && !this.program.call('live_runs')) this.ended();
    }

    // Show whether the driver is compiling. If compiling takes long, offer to undo the reader's changes.
    compiles(does) {
        this.at?.classList.toggle('live-waits', does);
        if (does) this.patience ??= setTimeout(() => { this.slow = true; this.note('The graphics driver is still compiling.', ...this.undoing()); }, LONG);
        else {
            clearTimeout(this.patience);
            this.patience = null;
            if (this.slow) this.note('');
            this.slow = false;
        }
    }

    undoing() {
        const undo = async () => {
            await this.changes.undo(Object.keys(this.changes.files));
            this.note('');
            this.again?.();
        };
        return this.changes.any ? [' Does your change contain an endless loop? ', this.button('Reset all files', undo)] : [];
    }

    // Move to an element; the previous one shows its poster again.
    move(at) {
        if (this.at === at) return;
        this.leave();
        this.at = at;
        at.screen.append(this.canvas, this.free, this.notice);
        this.controls.hidden = true; // until the picture is drawn
        at.screen.after(this.controls);
        at.classList.add('live-on');
        this.values.element.open = at.hasAttribute('play') && !this.narrow.matches; // on the Play page, the steps of the first shader use a slider
        this.ray.element.open = false;
        at.classList.toggle('live-editing', !this.changes.element.hidden);
    }

    // Leave the element. An element that a command opened is removed, unless it still shows printed or drawn results.
    leave() {
        const {at} = this;
        if (!at) return;
        const focused = [this.canvas, this.controls, this.notice].some((one) => one.contains(document.activeElement));
        this.program?.stop();
        at.classList.remove('live-on', 'live-window', 'live-drawn', 'live-waits', 'live-editing', 'live-wide');
        this.controls.remove();
        for (const made of [this.canvas, this.free, this.notice]) made.remove();
        this.at = null;
        if (focused) (at.opener ?? at.button).focus({preventScroll: true});
        if (at.opener && !at.result?.isConnected) at.remove();
    }

    // Show the result of a start.
    tell(at, status) {
        const runs = this.program.call('live_runs') === 1;
        const keyed = document.activeElement === at.button; // a key has pressed the button, which the picture replaces
        at.classList.toggle('live-window', runs);
        if (runs && keyed) this.canvas.focus({preventScroll: true});
        this.controls.hidden = !runs;
        const [width, height] = runs && this.asked || [16, 9];
        at.style.setProperty('--ratio', width / height);
        if (runs) {
            this.program.fit();
            this.canvas.setAttribute('aria-label', at.hasHands ? 'The running figure. Drag its points, or press Enter for the next point and the arrow keys to move it.'
                : 'The running program. Drag to look around, press W A S D to move, click to select a ray, press Escape to pause.');
            this.follow(this.shown);
        } else {
            at.result = this.result(at, status);
            at.append(at.result);
            this.leave();
        }
        this.look();
    }

    // Select the ray that the replaced picture shows.
    follow({probe}) {
        if (!probe) return;
        const {size} = this.program.state(), [x, y] = probe.split(',').map((share, i) => Math.floor(share * size[i]));
        this.call('live_pixel', x, y);
    }

    // The first frame has been drawn, and replaces the still picture. The selected ray has been marched, so one of its
    // steps can be selected.
    drew() {
        if (this.shown?.step) this.call('live_step', Number(this.shown.step));
        this.at?.classList.add('live-drawn');
        if (document.activeElement === this.canvas) this.takeHandle();
    }

    // The printed and drawn results of a command line, which stay where they were requested.
    result(at, status) {
        const {part} = this;
        const result = part('div', {className: 'live-result'}, ...this.pictures);
        const {head, tail} = this.shown, lines = head > 0 ? this.lines.slice(0, head) : tail > 0 ? this.lines.slice(-tail) : this.lines;
        if (this.lines.length > 0 || this.pictures.length === 0) {
            const printed = part('pre', {className: 'live-printed', tabIndex: 0, textContent: lines.join('\n').replaceAll('/course/', '') || '(no output)'});
            printed.setAttribute('role', 'group'); // not a landmark, because there may be several
            printed.setAttribute('aria-label', 'Output of the program');
            printed.classList.toggle('live-wrong', status !== 0);
            printed.classList.toggle('live-few', lines.length < 3);
            result.append(printed);
        }
        const changed = shownBy(Object.keys(this.changes.files), at.stem, this.line);
        if (changed.length > 0) result.append(part('p', {textContent: withChanges(changed)}));
        result.append(this.button('Close', () => {
            result.remove();
            if (at.opener && this.at !== at) at.remove();
            (at.opener ?? at.button).focus();
        }));
        result.setAttribute('role', 'status');
        return result;
    }

    heard(text, isError) {
        if (this.starting) this.lines.push(text);
        else if (isError && !this.canvas.getContext('webgl2')?.isContextLost()) this.wrong = text;
    }

    // The program has written a picture. If a command line asked for it, show it on the page; if a key did, save it.
    show(data, name) {
        const {part} = this, {starting} = this;
        const canvas = part('canvas', {width: data.width, height: data.height});
        canvas.getContext('2d').putImageData(data, 0, 0);
        const file = name.slice(name.lastIndexOf('/') + 1);
        canvas.setAttribute('role', 'img');
        canvas.setAttribute('aria-label', `The picture ${file}`);
        if (starting) this.pictures.push(canvas);
        canvas.toBlob((blob) => {
            const link = part('a', {href: URL.createObjectURL(blob), download: file, textContent: `Save ${file}`});
            if (starting) canvas.after(part('p', {}, `${data.width} × ${data.height} · `, link));
            else link.click();
        });
    }

    // The program has ended, after Backspace or because it could not draw.
    ended() {
        const {error} = this.program.state(), at = this.at;
        this.close();
        if (error && at) at.say(error);
    }

    close() {
        const {at} = this;
        this.turn = null;
        this.compiles(false);
        if (document.fullscreenElement) document.exitFullscreen();
        at?.classList.remove('live-wide');
        this.leave();
        (at?.opener || at?.button)?.focus();
    }

    note(text, ...more) {
        if (this.notice.contains(document.activeElement)) this.canvas.focus({preventScroll: true});
        this.notice.replaceChildren(text, ...more);
        this.notice.hidden = text === '';
    }

    full() {
        const at = this.at, top = () => this.bar.getBoundingClientRect().top, isFull = () => document.fullscreenElement === at || at.matches('.live-wide');
        if (!isFull()) this.barTop = top();
        const back = () => { if (!isFull()) scrollBy({top: top() - this.barTop, behavior: 'instant'}); }; // to where the reader was
        at.onfullscreenchange = () => requestAnimationFrame(back);
        if (document.fullscreenElement) document.exitFullscreen();
        else if (at.requestFullscreen) at.requestFullscreen();
        else {
            at.classList.toggle('live-wide'); // for phones without a full-screen mode
            back();
        }
        this.canvas.focus({preventScroll: true});
    }

    // The running shader, converted for Shadertoy by a separate program; the program in the page continues.
    async exported() {
        const lines = [], names = this.state.files.map((path) => path.replace('/course/', ''));
        const other = await Program.load(this.part('canvas'), {onLine: (text) => lines.push(text)});
        for (const name of names) if (/\.(frag|glsl)$/.test(name)) other.write(name, this.changes.text(name));
        const status = await other.start(this.at.stem, `--shader ${names[0]} --print-shader=shadertoy`);
        if (status !== 0) throw new Error(lines.join('\n').replaceAll('/course/', ''));
        return lines.join('\n') + '\n';
    }

    // The options with which another program shows the reader's values, camera, view and, if it is paused, time.
    get settings() {
        const {parameters, camera, views, view, time, paused} = this.program.state(), moved = parameters.filter(({name, value, initial}) => !name.includes(' ') && String(value) !== String(initial));
        return [...moved.map(({name, type, value}) => ` --set ${name}=${type === 'bool' ? value[0] !== 0 : value}`),
            ...(views.length > 1 ? [` --camera ${camera}`, ` --view ${view}`] : []), ...(paused ? [` --time ${time}`] : [])].join('');
    }

    // With the keyboard, an interactive figure begins with one of its points selected; Enter selects the next one.
    takeHandle() {
        const {handles} = this.at?.hasHands ? this.program.state() : {};
        if (handles?.length > 0 && this.canvas.matches(':focus-visible') && !handles.some((one) => one.focused)) this.press(NEXT_HANDLE);
    }

    // ---- The state ----

    look() {
        if (!this.at || this.starting || !this.program || this.program.lost || !this.program.call('live_runs')) return;
        const state = this.state = this.program.state();
        if (this.views.childElementCount !== state.views.length)
            this.views.replaceChildren(...state.views.map((name, view) => this.button(name, () => this.call('live_view', view))));
        // A shader that is not in the course's dialect has no camera, no views and no recorded rays. An interactive
        // figure needs none of these, and no clock.
        this.views.hidden = this.pad.hidden = this.mover.hidden = this.back.hidden = this.rays.hidden = this.ray.element.hidden = state.views.length === 1 || this.at.hasHands;
        this.viewer.hidden = this.clock.hidden = this.status.hidden = this.at.hasHands;
        this.undo.hidden = !state.tool;
        state.views.forEach((name, view) => this.views.children[view].setAttribute('aria-pressed', name === state.view));
        this.name(this.pause, state.paused ? 'Resume' : 'Pause');
        this.still.hidden = !(state.paused && calm.matches);
        if (document.activeElement !== this.time) this.time.value = state.time.toFixed(state.paused ? 3 : 1);
        const size = state.divisor > 1 ? ` (drawn at 1/${Number(state.divisor.toFixed(1))})` : '';
        const {kept} = state, frame = kept ? ` · frame ${kept.frame}${kept.last >= 0 ? ` of ${kept.last}` : ''}` : '';
        this.status.textContent = `${state.size.join(' × ')}${size} · ${state.milliseconds.toFixed(0)} ms · ${state.rate.toFixed(0)} fps${frame}`;
        const error = state.error.replaceAll('/course/', '');
        if (this.error.textContent !== error) this.error.textContent = error;
        this.error.hidden = error === '';
        this.controls.style.setProperty('--error', `${this.error.offsetHeight}px`);
        // An input that nothing sets is reported over the picture until there is a more serious message.
        const unset = state.unset || (kept?.halves ? HALVES : '');
        if (error === '' && unset !== this.unset) this.note(unset);
        this.unset = unset;
        if (this.wrong && error === '') this.note(this.wrong.replaceAll('/course/', ''));
        this.wrong = '';
        this.compiles(state.compiles);
        this.changes.show(state);
        this.values.show(state.parameters);
        this.ray.show(state);
    }
}
