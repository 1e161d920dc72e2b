// stage.js - a running program with its controls: canvas, views, time, values, the ray of a pixel, the editor. There is
// one in a page; it stands in the <live-chapter> that asked for it last.
import {calm, Program} from './program.js';
import {Changes} from './changes.js';
import {shownBy, withChanges} from './edits.js';
import {Values} from './values.js';
import {Ray} from './ray.js';

const LOOK = 200; // milliseconds between two looks at the program's state
const PRESS = 1, RELEASE = 0;
const PAD = [['◀', 65, 'left'], ['▲', 87, 'forwards'], ['▼', 83, 'backwards'], ['▶', 68, 'right'], ['⤒', 32, 'up'], ['⤓', 67, 'down']];
const RESTART = 82, SHIFT = 1;

export class Stage {
    static async load(part) {
        const stage = new Stage();
        stage.part = part;
        stage.build();
        stage.program = await Program.load(stage.canvas, {
            onLine: (text, isError) => stage.heard(text, isError),
            onPicture: (data, name) => stage.show(data, name),
            onSize: (width, height) => { stage.asked = [width, height]; },
            onEnd: () => stage.ended(),
            onLost: () => stage.note('The graphics driver gave up on this picture; it is made again as soon as the browser allows.'),
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

    build() {
        const {part} = this;
        this.canvas = part('canvas', {className: 'live-canvas', tabIndex: 0});
        this.canvas.setAttribute('role', 'img');
        this.canvas.addEventListener('pointerdown', (event) => { if (event.pointerType === 'touch') this.controls.classList.add('live-touched'); });
        this.canvas.setAttribute('aria-label', 'The running program. Drag to look, W A S D to move, click for a ray, Escape to pause.');
        this.status = part('p', {className: 'live-status'});
        this.notice = part('p', {className: 'live-notice', hidden: true});
        this.notice.setAttribute('role', 'status');
        this.pad = part('div', {className: 'live-pad'});
        this.pad.setAttribute('role', 'group');
        this.pad.setAttribute('aria-label', 'Move');
        for (const [sign, key, where] of PAD) this.pad.append(this.held(sign, key, `Move ${where}`));
        this.views = part('span', {className: 'live-views'});
        this.views.setAttribute('role', 'group');
        this.views.setAttribute('aria-label', 'View');
        this.pause = this.button('Pause', () => this.call('live_pause', this.state.paused ? 0 : 1));
        this.time = part('input', {type: 'number', step: 'any', className: 'live-time'});
        this.time.setAttribute('aria-label', 'Time, seconds');
        this.time.addEventListener('change', () => this.call('live_time', Number(this.time.value)));
        this.back = this.button('Camera back', () => this.press(RESTART, SHIFT), {title: 'and the time to its start'});
        this.still = part('small', {className: 'live-still', textContent: 'time is held: this system asks for little motion', hidden: true});
        this.changes = new Changes(this);
        this.bar = part('div', {className: 'live-bar'}, this.views,
            part('span', {className: 'live-clock'}, this.pause, this.button('Restart', () => this.press(RESTART)), this.back, part('label', {}, this.time, ' s'), this.still),
            part('span', {className: 'live-tools'}, this.changes.open, this.button('Full screen', () => this.full(), {className: 'live-full'}), this.button('Close', () => this.close())));
        this.bar.setAttribute('role', 'toolbar');
        this.bar.setAttribute('aria-label', 'The program');
        this.error = part('pre', {className: 'live-error', hidden: true});
        this.error.setAttribute('role', 'alert');
        this.values = new Values(this);
        this.ray = new Ray(this);
        this.controls = part('div', {className: 'live-controls'}, this.changes.line, this.pad, this.bar, this.changes.element, this.error, this.values.element, this.ray.element);
    }

    // A button that is a key for as long as it is held.
    held(sign, key, label) {
        const button = this.part('button', {type: 'button', textContent: sign});
        button.setAttribute('aria-label', label);
        const up = () => { this.program.module._live_key(key, RELEASE, 0); };
        button.addEventListener('pointerdown', (event) => {
            event.preventDefault(); // the press stays a press: no selection, no menu
            button.setPointerCapture(event.pointerId);
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

    // Run one in an element, which gets the program. Returns its exit status.
    async start(at, line, shown = {}) {
        const turn = this.turn = Symbol(line), asked = at.opener ?? at, top = asked.getBoundingClientRect().top;
        this.move(at);
        this.lines = [];
        this.pictures = [];
        this.asked = null;
        this.note('');
        this.starting = true;
        at.result?.remove();
        at.said?.remove();
        scrollBy({top: asked.getBoundingClientRect().top - top, behavior: 'instant'}); // what stood above may be gone
        // The browser paints what is said before the program takes the processor.
        at.classList.add('live-waits');
        await new Promise((painted) => requestAnimationFrame(() => setTimeout(painted)));
        this.line = await this.changes.begin(at) ?? line;
        const status = this.turn === turn ? await this.carry(at.stem, this.line, shown.still) : 0;
        if (this.turn !== turn) return 0;
        at.classList.remove('live-waits');
        this.starting = false;
        this.shown = shown;
        this.tell(at, status);
        return status;
    }

    // Carry out a command line. Where a reader's changes let nothing start, the picture is the one without them, and
    // the error is that of a change to a program that runs.
    async carry(stem, line, still) {
        const status = await this.program.start(stem, line, still);
        if (status !== 1 || !this.changes.any) return status;
        const lines = this.lines;
        this.lines = [];
        await this.changes.lay(true);
        const without = await this.program.start(stem, line, still);
        if (!this.program.call('live_runs')) this.lines = lines; // no window: what they say is the result
        await this.changes.lay(false);
        return this.program.call('live_runs') ? without : status;
    }

    // The context is back. Where a reader's changes load no more, the picture is the one without them, as at a start.
    async found(fails) {
        const {turn} = this;
        this.note('');
        if (!fails) return;
        await this.changes.lay(true);
        if (this.turn === turn) this.program.restore();
        await this.changes.lay(false);
        if (this.turn === turn && !this.program.call('live_runs')) this.ended();
    }

    // Stand in an element; the one before goes back to its poster.
    move(at) {
        if (this.at === at) return;
        this.leave();
        this.at = at;
        at.screen.append(this.canvas, this.status, this.notice);
        at.screen.after(this.controls);
        at.classList.add('live-on');
        at.classList.toggle('live-editing', !this.changes.element.hidden);
    }

    // What an element without a poster has printed or drawn stays; else it goes.
    leave() {
        const {at} = this;
        if (!at) return;
        this.program?.stop();
        at.classList.remove('live-on', 'live-window', 'live-waits', 'live-editing', 'live-wide');
        this.controls.remove();
        for (const made of [this.canvas, this.status, this.notice]) made.remove();
        this.at = null;
        if (at.opener && !at.result?.isConnected) at.remove();
    }

    // What there is to see after a start.
    tell(at, status) {
        const runs = this.program.call('live_runs') === 1;
        at.classList.toggle('live-window', runs);
        this.controls.hidden = !runs;
        const [width, height] = runs && this.asked || [16, 9];
        at.style.setProperty('--ratio', width / height);
        if (runs) {
            this.program.fit();
            this.canvas.focus({preventScroll: true});
        } else {
            at.result = this.result(at, status);
            at.append(at.result);
            this.leave();
        }
        this.look();
    }

    // What a command line has printed and drawn, which stays where it was asked for.
    result(at, status) {
        const {part} = this;
        const result = part('div', {className: 'live-result'}, ...this.pictures);
        const {head, tail} = this.shown, lines = head > 0 ? this.lines.slice(0, head) : tail > 0 ? this.lines.slice(-tail) : this.lines;
        if (this.lines.length > 0 || this.pictures.length === 0) {
            const printed = part('pre', {className: 'live-printed', tabIndex: 0, textContent: lines.join('\n').replaceAll('/course/', '') || '(it prints nothing)'});
            printed.setAttribute('role', 'group'); // no landmark: there may be several
            printed.setAttribute('aria-label', 'What the program prints');
            printed.classList.toggle('live-wrong', status !== 0);
            printed.classList.toggle('live-few', lines.length < 3);
            result.append(printed);
        }
        const changed = shownBy(Object.keys(this.changes.files), at.stem, this.line);
        if (changed.length > 0) result.append(part('p', {textContent: withChanges(changed)}));
        result.append(this.button('Close', () => {
            result.remove();
            if (!at.opener || this.at === at) return;
            at.remove();
            at.opener.focus();
        }));
        result.setAttribute('role', 'status');
        return result;
    }

    heard(text, isError) {
        if (this.starting) this.lines.push(text);
        else if (isError) this.wrong = text;
    }

    // A picture that the program has written: of its command line it stands on the page, of a key it is saved.
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

    // The program has ended, by Backspace or because it could not draw.
    ended() {
        const {error} = this.program.state(), at = this.at;
        this.close();
        if (error && at) at.say(error);
    }

    close() {
        const {at} = this;
        if (document.fullscreenElement) document.exitFullscreen();
        at?.classList.remove('live-wide');
        this.leave();
        (at?.opener || at?.button)?.focus();
    }

    note(text) {
        this.notice.textContent = text;
        this.notice.hidden = text === '';
    }

    full() {
        const at = this.at;
        if (document.fullscreenElement) document.exitFullscreen();
        else if (at.requestFullscreen) at.requestFullscreen();
        else at.classList.toggle('live-wide'); // a telephone that has none
        this.canvas.focus({preventScroll: true});
    }

    // What runs as a file for Shadertoy, by a program of its own; the one in the page goes on.
    async exported() {
        const lines = [], names = this.state.files.map((path) => path.replace('/course/', ''));
        const other = await Program.load(this.part('canvas'), {onLine: (text) => lines.push(text)});
        for (const name of names) if (/\.(frag|glsl)$/.test(name)) other.write(name, this.program.read(name));
        const status = await other.start(this.at.stem, `--shader ${names[0]} --print-shader=shadertoy`);
        if (status !== 0) throw new Error(lines.join('\n').replaceAll('/course/', ''));
        return lines.join('\n') + '\n';
    }

    // ---- The state ----

    look() {
        if (!this.at || this.starting || !this.program || this.program.lost || !this.program.call('live_runs')) return;
        const state = this.state = this.program.state();
        if (this.views.childElementCount !== state.views.length)
            this.views.replaceChildren(...state.views.map((name, view) => this.button(name, () => this.call('live_view', view))));
        // A text with a main of its own has no camera, no views and no trace of a ray.
        this.views.hidden = this.pad.hidden = this.back.hidden = this.ray.element.hidden = state.views.length === 1;
        state.views.forEach((name, view) => this.views.children[view].setAttribute('aria-pressed', name === state.view));
        this.pause.textContent = state.paused ? 'Go on' : 'Pause';
        this.still.hidden = !(state.paused && calm.matches);
        if (document.activeElement !== this.time) this.time.value = state.time.toFixed(state.paused ? 3 : 1);
        const size = state.divisor > 1 ? ` (drawn at 1/${Number(state.divisor.toFixed(1))})` : '';
        this.status.textContent = `${state.size.join(' × ')}${size} · ${state.milliseconds.toFixed(0)} ms · ${state.rate.toFixed(0)} a second`;
        const error = state.error.replaceAll('/course/', '');
        if (this.error.textContent !== error) this.error.textContent = error;
        this.error.hidden = error === '';
        if (this.wrong && error === '') this.note(this.wrong.replaceAll('/course/', ''));
        this.wrong = '';
        this.changes.show(state);
        this.values.show(state.parameters);
        this.ray.show(state);
    }
}
