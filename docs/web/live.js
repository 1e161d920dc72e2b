// live.js - <live-chapter stem="03_shadows" line="--time 3">: a chapter's program in a page. Before a reader asks for
// it there is its poster and a button; the module, the controls and the editor are loaded by the click.
//
// Beside the elements that a page has, a button.run opens one below its command, and a form.check judges an exercise.
// A page has one program: it moves to where it was asked for last.

let stage = null; // the one that runs, once it was asked for

const part = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
};

// Ask for all that a program needs at once, not one after what names it.
const PARTS = ['stage', 'program', 'harness'], DATA = ['harness.wasm', 'course.json'];

//   stem  of the chapter whose text is asked for too; '' for none
async function load(stem) {
    const from = (name) => new URL(name, import.meta.url).href;
    document.head.append(...PARTS.map((name) => part('link', {rel: 'modulepreload', href: from(`${name}.js`)})),
        ...[...DATA, ...(stem ? [`course/chapters/${stem}.frag`] : [])].map((name) => part('link', {rel: 'preload', as: 'fetch', crossOrigin: 'anonymous', href: from(name)})));
    const {Stage} = await import('./stage.js');
    return Stage.load(part);
}

class LiveChapter extends HTMLElement {
    connectedCallback() {
        if (this.screen) return; // it was moved
        const poster = this.querySelector('img');
        this.button = part('button', {type: 'button', className: 'live-start', textContent: '▶ Run'});
        this.button.setAttribute('aria-label', `Run the program of chapter ${this.stem.slice(0, 2)}`);
        this.button.addEventListener('click', () => this.run());
        this.screen = part('div', {className: 'live-screen'}, ...(poster ? [poster] : []), this.button);
        this.prepend(this.screen);
        this.prepare();
    }

    // What the button says where there are changes to see.
    prepare() {
        if (this.isFirst && location.hash.startsWith('#edit=')) {
            this.button.textContent = '▶ Run what this link holds';
            this.button.removeAttribute('aria-label');
        }
    }

    get stem() { return this.getAttribute('stem') || ''; }
    get isFirst() { return document.querySelector('live-chapter') === this; }

    // Run a command line here: what options.c reads behind the program's name. Returns the exit status once it is
    // done, or the window's first picture is there. The page's program moves here if it is elsewhere.
    //   shown  {head} how many of the first lines that it prints are shown, {tail} how many of the last; else all;
    //          {still} the time is held until it is let run
    async run(line = this.getAttribute('line') || '', shown = {}) {
        this.button.disabled = true;
        this.setAttribute('aria-busy', 'true');
        try {
            stage ??= load(this.stem);
            this.stage = await stage;
            return await this.stage.start(this, line, shown);
        } catch (error) {
            stage = null;
            this.say(`The program cannot be loaded: ${error.message}`);
            return 1;
        } finally {
            this.button.disabled = false;
            this.removeAttribute('aria-busy');
        }
    }

    // A line in place of the program.
    say(text) {
        this.said ??= part('p', {className: 'live-said'});
        this.said.setAttribute('role', 'alert');
        this.said.textContent = text;
        this.append(this.said);
    }

    // Put a text into the course's files as chapters/NAME and run it, in the editor. Returns the exit status.
    async play(name, text) {
        stage ??= load('');
        const {program} = this.stage = await stage;
        this.scrollIntoView({block: 'nearest'}); // a file may be dropped anywhere in the page
        program.write(`chapters/${name}`, text);
        const status = await this.run(`--shader chapters/${name}`);
        if (program.call('live_runs')) await this.stage.changes.toggle(true);
        return status;
    }

    // The text that runs as a file for Shadertoy; '' where it runs none. Nothing else changes.
    async exported() { return this.program ? this.stage.exported() : ''; }

    // The program in it, once it runs: for pages with files of their own.
    get program() { return this.stage?.at === this ? this.stage.program : null; }
}

customElements.define('live-chapter', LiveChapter);

// ---- Beside the text ----

const beside = new WeakMap(); // a command's button: the chapter below it

// The one that belongs to a button, below the button's block.
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

// Compare the two pictures of a button, below it: what runs in the page goes on.
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
        box.textContent = `What compares them cannot be loaded: ${error.message}`;
    } finally {
        button.removeAttribute('aria-busy');
    }
}

document.addEventListener('click', (event) => {
    const button = event.target.closest?.('button.run');
    if (button?.dataset.other) compare(button);
    else if (button) chapterOf(button, button.dataset.stem).run(button.dataset.line || '', {head: Number(button.dataset.head), tail: Number(button.dataset.tail), still: 'still' in button.dataset});
});

// The chapter's file in the editor, below a form.
async function edit(form, stem) {
    const chapter = chapterOf(form.querySelector('button'), stem);
    if (await chapter.run('') === 0) chapter.stage.changes.toggle(true);
}

document.addEventListener('submit', async (event) => {
    const form = event.target.closest?.('form.check');
    if (!form) return;
    event.preventDefault();
    const [{check}, running] = await Promise.all([import('./check.js'), stage]);
    check(form, running, part, edit);
});
