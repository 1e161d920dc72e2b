// live.js - <live-chapter stem="03_shadows" line="--time 3">: a chapter's program in a page. At first it shows only a
// poster and a button; a click loads the program and its controls.
//
// A button.run opens another such element below its command, and a form.check judges an exercise. A page has only one
// program, which moves to the element that was used last.

import {draftOf} from './edits.js';
import {Scrub} from './scrub.js';

let stage = null; // a promise of the page's Stage, once a program has been requested

const part = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
};

// Request all these files at once, instead of each only when another file names it.
const PARTS = ['stage', 'program', 'harness'], DATA = ['harness.wasm', 'course.json'];

//   text  the name of a shader to request as well; '' if there is none
async function load(text) {
    const from = (name) => new URL(name, import.meta.url).href;
    document.head.append(...PARTS.map((name) => part('link', {rel: 'modulepreload', href: from(`${name}.js`)})),
        ...[...DATA, ...(text ? [`course/${text}`] : [])].map((name) => part('link', {rel: 'preload', as: 'fetch', crossOrigin: 'anonymous', href: from(name)})));
    const {Stage} = await import('./stage.js');
    return Stage.load(part);
}

// Does this browser support WebGL 2? The check is made once.
const draws = () => draws.said ??= Boolean(document.createElement('canvas').getContext('webgl2'));

class LiveChapter extends HTMLElement {
    connectedCallback() {
        if (this.screen) return; // the element was only moved
        const poster = this.querySelector('img');
        if (this.hasSheet) this.besideSheet(this.querySelector('figure-sheet'));
        else this.behindPoster(poster);
        // On a touch screen, creating a graphics context while a finger goes down would turn the tap into a long press.
        this.screen.addEventListener('pointerenter', (event) => { if (event.pointerType === 'mouse') this.expect(); }, {once: true});
        if (poster) this.style.setProperty('--across', poster.classList.contains('wide') ? '100%' : `${poster.getAttribute('width')}px`);
        this.prepare();
    }

    // A picture, which a click replaces with the program.
    behindPoster(poster) {
        this.button = part('button', {type: 'button', className: 'live-start', textContent: this.closest('td') ? '▶' : '▶ Run'});
        this.button.setAttribute('aria-label', this.isInPlace ? `Run this picture: ${poster.alt}` : `Run the program of chapter ${this.stem.slice(0, 2)}`);
        this.button.addEventListener('click', () => { if (!this.hasAttribute('aria-busy')) this.run(); }); // a disabled button would lose the focus
        this.screen = part('div', {className: 'live-screen'}, ...(poster ? [poster] : []));
        if (this.isInPlace) poster.addEventListener('click', () => this.run());
        this.prepend(this.screen);
        const isBelow = this.parentElement.matches('figure');
        this.button.classList.toggle('live-quiet', isBelow);
        (isBelow ? this : this.screen).append(this.button);
    }

    // An interactive figure (sheet.js), which needs no program. Its button Edit replaces it with the program, opens the
    // figure's shader in the editor, and passes on what the reader has moved.
    besideSheet(sheet) {
        this.sheet = sheet;
        this.button = sheet.querySelector('.sheet-edit');
        this.button.addEventListener('click', async () => {
            if (this.hasAttribute('aria-busy')) return;
            await this.run(this.getAttribute('line') + sheet.settings);
            if (this.program?.call('live_runs')) await this.stage.changes.toggle(true);
        });
        this.screen = part('div', {className: 'live-screen'});
        sheet.after(this.screen);
    }

    // Set the text of the button if the address contains changes.
    prepare() {
        if (this.isFirst && location.hash.startsWith('#edit=')) {
            this.button.textContent = '▶ Run the changes in this link';
            this.button.removeAttribute('aria-label');
        }
    }

    get stem() { return this.getAttribute('stem') || ''; }
    get isInPlace() { return this.classList.contains('in-place'); }
    get hasSheet() { return this.classList.contains('hands'); } // an interactive figure
    get hasHands() { return this.hasSheet && !this.classList.contains('turned'); } // one with points to drag
    get isFirst() { return document.querySelector('live-chapter') === this; }

    // Load the program, before the click if the mouse enters the picture. Returns a promise of the stage, or null if
    // this browser cannot draw.
    expect(line = this.getAttribute('line') || '') {
        if (!draws()) return null;
        stage ??= load(/(?:--shader|-f)[ =](\S+)/.exec(line)?.[1] ?? `chapters/${this.stem}.frag`);
        stage.catch(() => { stage = null; }); // if loading fails, the click tries again and shows the reason
        return stage;
    }

    // Run a command line in this element, to which the page's program moves. The line is the text after the program's
    // name (options.h). Returns the exit status once the command is done or its window is open.
    //   shown  {head: N} shows only the first N lines of the output, {tail: N} only the last N; {still} pauses the time
    //          until the reader resumes it; {probe} is the pixel whose ray is shown, "0.5,0.5" for the middle of the
    //          picture, and {step} the step up to which the ray is shown
    async run(line = this.getAttribute('line') || '', shown = {still: this.isInPlace && !this.hasHands, probe: this.getAttribute('probe'), step: this.getAttribute('step')}) {
        if (!draws()) {
            this.say('This browser has no WebGL 2, so no program can run here; all text and pictures are shown.');
            return 1;
        }
        this.setAttribute('aria-busy', 'true');
        try {
            this.stage = await this.expect(line);
            return await this.stage.start(this, line, shown);
        } catch (error) {
            stage = null;
            this.say(`The program cannot be loaded: ${error.message}`);
            return 1;
        } finally {
            this.removeAttribute('aria-busy');
        }
    }

    // Show a message instead of the program.
    say(text) {
        this.said ??= part('p', {className: 'live-said'});
        this.said.setAttribute('role', 'alert');
        this.said.textContent = text;
        this.append(this.said);
    }

    // Write a text into the course's files as chapters/NAME, open it in the editor and run it. Returns the exit status.
    //   base     the text that Reset restores
    //   stem     the chapter whose program runs the shader, with its camera
    //   options  more options for the program
    async play(name, base, text = base, stem = this.stem, options = '') {
        this.setAttribute('stem', stem);
        this.setAttribute('line', `--shader chapters/${name}${options}`);
        stage ??= load('');
        const {program, changes} = this.stage = await stage;
        this.scrollIntoView({block: 'nearest'}); // a file may be dropped anywhere in the page
        await changes.bring(this, `chapters/${name}`, base, text);
        const status = await this.run();
        if (program.call('live_runs')) await this.stage.changes.toggle(true);
        return status;
    }

    // The running shader, converted for Shadertoy; '' if no shader is running. The program continues unchanged.
    async exported() { return this.program ? this.stage.exported() : ''; }

    // The page's program if it is in this element; otherwise null.
    get program() { return this.stage?.at === this ? this.stage.program : null; }
}

customElements.define('live-chapter', LiveChapter);

// ---- Beside the text ----

const beside = new WeakMap(); // maps a command's button to the chapter below it

// The <live-chapter> that belongs to a button, created below the button's block if necessary.
function chapterOf(button, stem) {
    let chapter = beside.get(button);
    if (!chapter?.isConnected) {
        chapter = part('live-chapter', {className: 'live-beside'});
        chapter.setAttribute('stem', stem || document.querySelector('live-chapter')?.stem || '');
        chapter.opener = button;
        const block = button.closest('div.command') || button.closest('form, table, p, li, dd') || button;
        if (block.matches('li, dd')) block.append(chapter);
        else block.after(chapter);
        beside.set(button, chapter);
    }
    return chapter;
}

// Compare the two pictures of a button, and show the result below the button; the running program continues.
async function compare(button) {
    if (button.getAttribute('aria-busy') === 'true' && beside.get(button)?.isConnected) return;
    button.setAttribute('aria-busy', 'true');
    const chapter = chapterOf(button, button.dataset.stem), box = part('div', {className: 'live-verdict'});
    const close = part('button', {type: 'button', textContent: 'Close'});
    close.addEventListener('click', () => { chapter.remove(); button.focus(); });
    box.setAttribute('role', 'status');
    chapter.result?.remove();
    chapter.result = part('div', {className: 'live-result'}, box, close);
    chapter.append(chapter.result);
    try {
        const [{compareIn}, running] = await Promise.all([import('./check.js'), stage]);
        await compareIn(box, button, running, part);
    } catch (error) {
        box.textContent = `The comparison cannot be loaded: ${error.message}`;
    } finally {
        button.removeAttribute('aria-busy');
    }
}

document.addEventListener('click', (event) => {
    const button = event.target.closest?.('button.run, .answer');
    if (event.detail > 0 && event.target.closest?.('button.run, .live-start')) event.target.blur(); // so that Space and Page Down scroll the page
    if (button?.matches('.answer')) return edit(button.form);
    if (button?.dataset.other) compare(button);
    else if (button) chapterOf(button, button.dataset.stem).run(button.dataset.line || '', {head: Number(button.dataset.head), tail: Number(button.dataset.tail), still: 'still' in button.dataset});
});

// The words of an exercise, from the paragraph with its number to its form.
function wordsOf(form) {
    const words = part('div', {className: 'guide', tabIndex: 0, ariaLabel: 'The exercise'});
    words.setAttribute('role', 'group');
    for (let one = form.closest('.commands'); (one = one?.previousElementSibling) && !one.matches('h2, h3, details, .commands');) {
        words.prepend(one.cloneNode(true));
        if (/^\d+\./.test(one.querySelector('strong')?.textContent)) break;
    }
    for (const one of words.querySelectorAll('[id]')) one.removeAttribute('id');
    for (const one of words.querySelectorAll('button')) one.remove();
    return words;
}

// Open a reader's answer to an exercise in the editor, below the form of the exercise.
//   text  the new text of the answer; if undefined, an existing answer keeps its text, and a new one begins as a copy
//         of the chapter's shader
async function edit(form, text) {
    const chapter = chapterOf(form.querySelector('button'), form.dataset.stem), name = draftOf(form.dataset.exercise.replace('-', '_'));
    chapter.form = form;
    form.chapter = chapter;
    stage ??= load('');
    const {changes} = await stage;
    await changes.draft(chapter, name, text);
    if (await chapter.run(`--shader ${name}`) !== 0) return;
    chapter.words ??= chapter.appendChild(wordsOf(form));
    await changes.toggle(true);
}

// Run a <live-chapter> for a number in a sentence.
//   own  if true, run the chapter's own shader, because the picture's shader does not have the parameter
async function runIn(at, own = false) {
    await (own ? at.run('') : at.run());
}
export const scrub = (code) => new Scrub(code, runIn);
document.querySelectorAll('.scrub').forEach(scrub);

document.addEventListener('submit', async (event) => {
    const form = event.target.closest?.('form.check');
    if (!form) return;
    event.preventDefault();
    const [{check}, running] = await Promise.all([import('./check.js'), stage]);
    check(form, running, part, edit);
});
