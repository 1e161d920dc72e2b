// changes.js - a reader's changes to the files of the program that runs: the editor with what stands around it.
import * as edits from './edits.js';

const SHADER = /\.(frag|glsl)$/;
const PREFIX = '/course/';

export class Changes {
    constructor(stage) {
        const {part} = stage;
        this.stage = stage;
        this.files = {}; // what is not as the course has it
        this.said = part('span');
        this.line = part('p', {className: 'live-changes', hidden: true}, this.said, ' ', stage.button('Undo all', () => this.undo(this.named)));
        this.place = part('div');
        this.saved = part('span', {className: 'live-saved'});
        this.saved.setAttribute('role', 'status');
        this.download = stage.button('Download my.frag', () => this.hand());
        this.element = part('div', {className: 'live-editor', hidden: true}, this.place, part('div', {className: 'live-bar'},
            stage.button('Reset this file', () => this.undo([this.editor.name])), stage.button('Copy a link', () => this.link()), this.download, this.saved));
        this.open = stage.button('Edit', () => this.toggle());
        this.open.setAttribute('aria-expanded', 'false');
        addEventListener('pagehide', () => this.editor?.flush());
    }

    // Before the first start: what this page's address holds, else what the browser has kept.
    //   at  the element that starts
    // Returns the link's command line, or null.
    async begin(at) {
        if (this.begun) return null;
        this.begun = true;
        let link = null;
        try {
            link = at.isFirst ? await edits.unpack() : null;
        } catch (error) {
            this.stage.note(`The changes in this page's address cannot be read: ${error.message}`);
        }
        const files = {...edits.kept(), ...link?.files};
        for (const [name, text] of Object.entries(files)) {
            const original = await this.stage.program.original(name);
            if (text !== original) this.files[name] = text;
        }
        this.write();
        this.tell();
        return link?.stem === at.stem ? link.line : null;
    }

    write() {
        for (const [name, text] of Object.entries(this.files)) this.stage.program.write(name, text);
    }

    // Lay out the files as the course has them: what a reader has changed may not even start.
    async lay(original) {
        const {program} = this.stage;
        if (!original) return this.write();
        for (const name of Object.keys(this.files)) {
            const text = await program.original(name);
            if (text !== null) program.write(name, text);
        }
    }

    get any() { return Object.keys(this.files).length > 0; }

    async change(name, text) {
        const {program} = this.stage;
        program.write(name, text); // the program looks at its files, and loads them again
        const original = await program.original(name);
        if (text === original) delete this.files[name];
        else this.files[name] = text;
        edits.show('');
        this.saved.textContent = edits.keep(name, text === original ? null : text) ? '' : 'This browser keeps nothing: copy a link.';
        this.tell();
    }

    async undo(names) {
        for (const name of names) {
            const text = await this.stage.program.original(name);
            if (text === null) continue;
            if (this.editor?.name === name) this.editor.put(name, text);
            else {
                this.editor?.put(name, text);
                await this.change(name, text);
            }
        }
        edits.show('');
    }

    // Say which files of the shader that runs are changed.
    tell() {
        const running = this.stage.state?.files;
        this.named = Object.keys(this.files).filter((name) => !running || running.includes(PREFIX + name));
        const text = edits.withChanges(this.named), top = this.element.getBoundingClientRect().top;
        if (this.said.textContent !== text) this.said.textContent = text;
        if (this.line.hidden === (this.named.length === 0)) return;
        this.line.hidden = this.named.length === 0;
        if (!this.element.hidden) scrollBy({top: this.element.getBoundingClientRect().top - top, behavior: 'instant'}); // what is typed stays in its place
    }

    // ---- The editor ----

    async toggle(open = this.element.hidden) {
        this.open.setAttribute('aria-expanded', String(open));
        this.element.hidden = !open;
        this.stage.at.classList.toggle('live-editing', open);
        if (!open) return this.editor?.flush();
        const {Editor} = await import('./editor.js');
        this.editor ??= new Editor(this.place, {
            read: (name) => this.stage.program.read(name),
            changed: (name, text) => this.change(name, text),
            bottom: () => this.stage.error.hidden ? Infinity : this.stage.error.getBoundingClientRect().top,
        });
        this.show(this.stage.state);
        this.editor.view.focus();
        this.element.scrollIntoView({block: 'start'}); // below the picture, which stays in sight
    }

    show(state) {
        this.tell();
        if (!this.editor || this.element.hidden || !state) return;
        this.editor.open(state.files.filter((path) => path.startsWith(PREFIX) && SHADER.test(path)).map((path) => path.slice(PREFIX.length)));
        this.editor.complain(state.error.replaceAll(PREFIX, ''));
        const first = this.editor.name === this.editor.names[0];
        this.download.textContent = `Download ${first ? 'my.frag' : this.editor.name.slice(this.editor.name.lastIndexOf('/') + 1)}`;
    }

    hand() {
        const name = this.download.textContent.slice('Download '.length);
        const url = URL.createObjectURL(new Blob([this.editor.text()], {type: 'text/plain'}));
        this.stage.part('a', {href: url, download: name}).click();
        setTimeout(() => URL.revokeObjectURL(url), 10000);
        const others = Object.keys(this.files).filter((one) => one !== this.editor.names[0]);
        this.saved.textContent = name === 'my.frag' && others.length > 0 ? `You have changed ${others.join(', ')} too: my.frag alone is not what you see.` : '';
    }

    async link() {
        await this.editor.flush();
        const {at} = this.stage;
        edits.show(await edits.pack(at.stem, this.stage.line, this.files));
        try {
            await navigator.clipboard.writeText(location.href);
            this.saved.textContent = 'Copied: the address of this page now holds your changes.';
        } catch {
            this.saved.textContent = 'The address of this page now holds your changes: copy it.';
        }
    }
}
