// changes.js - keeps track of a reader's changes to the files of the running program, and shows the editor, its buttons
// and its notes.
import * as edits from './edits.js';

const SHADER = /\.(frag|glsl)$/;
const PREFIX = '/course/';
const nameOf = (path) => path.slice(path.lastIndexOf('/') + 1);

export class Changes {
    constructor(stage) {
        const {part} = stage;
        this.stage = stage;
        this.files = {}; // the files that differ from their original texts, {NAME: TEXT}
        this.brought = new Map(); // maps the name of a file that the reader has added to its original text
        this.said = part('span');
        this.line = part('p', {className: 'live-changes', hidden: true}, this.said, ' ', stage.button('Reset all files', () => this.undo(this.named)));
        this.other = part('p', {className: 'live-other', hidden: true});
        this.other.setAttribute('role', 'status');
        this.replaced = part('p', {className: 'live-replaced', hidden: true});
        this.replaced.setAttribute('role', 'status');
        this.place = part('div');
        this.saved = part('span', {className: 'live-saved'});
        this.saved.setAttribute('role', 'status');
        this.download = stage.button('Download my.frag', () => this.hand());
        this.judge = stage.button('Check', () => stage.at.form.requestSubmit(), {className: 'live-judge'}); // of an exercise
        this.bar = part('div', {className: 'live-bar'}, this.judge,
            stage.button('Undo', () => this.editor.back()), stage.button('Reset this file', () => this.undo([this.editor.name])), stage.button('Copy a link', () => this.link()), this.download, this.saved);
        this.element = part('div', {className: 'live-editor', hidden: true}, this.place, this.bar);
        this.open = stage.icon('Edit', () => this.toggle(), {className: 'live-named'});
        this.open.setAttribute('aria-expanded', 'false');
        addEventListener('pagehide', () => this.editor?.flush());
        addEventListener('storage', (event) => { if (edits.isOurs(event) && this.begun) this.elsewhere(edits.kept()); });
    }

    // Before the program first starts, load the changes in this page's address and those that the browser has stored.
    //   at  the element that is started
    // Returns the command line in that address, or null if the address has none for this element's program.
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
            if (text !== await this.original(name)) this.files[name] = text;
        }
        this.write();
        this.tell();
        return link?.stem === at.stem ? link.line : null;
    }

    // The text to which a file can be reset: the original text of a file that the reader has added, the chapter's
    // shader for an answer to an exercise, and otherwise the course's own text. Null if there is none.
    async original(name) {
        const {program} = this.stage, exercise = edits.exerciseOf(name);
        const chapter = exercise && [...program.course].find((one) => one.startsWith(`chapters/${exercise.slice(0, 2)}_`));
        return this.brought.get(name) ?? program.original(chapter || name);
    }

    // Write a reader's answer to an exercise into the program's files.
    //   text  the new text of the answer; if null, an existing answer keeps its text, and a new one begins as a copy of
    //         the chapter's shader
    async draft(at, name, text = null) {
        await this.begin(at);
        if (text !== null) await this.change(name, text);
        else if (this.files[name] === undefined) this.stage.program.write(name, await this.original(name));
        if (text !== null) this.editor?.renew(name);
    }

    // Add a file that the course does not have, and remove all traces of an earlier file with the same name.
    //   base  the text that Reset restores
    async bring(at, name, base, text) {
        await this.begin(at);
        this.brought.set(name, base);
        await this.change(name, text);
        this.editor?.renew(name);
    }

    // Remove a file that the reader has added.
    forget(name) {
        delete this.files[name];
        this.brought.delete(name);
        edits.keep(name, null);
        this.tell();
    }

    // Another tab has stored other texts. Files that are not shown here take over the other tab's texts; for files that
    // are shown, the reader decides.
    async elsewhere(all) {
        const shown = this.stage.state?.files ?? [], differ = Object.keys({...all, ...this.files}).filter((name) => all[name] !== this.files[name]);
        const take = async (names) => {
            for (const name of names) {
                const text = all[name] ?? await this.original(name);
                if (text !== null) await this.put(name, text);
            }
        };
        const asked = differ.filter((name) => shown.includes(PREFIX + name));
        await take(differ.filter((name) => !asked.includes(name)));
        this.other.hidden = asked.length === 0;
        this.other.replaceChildren(`Another tab has changed ${asked.join(', ')}. If you go on typing here, its text is lost. `,
            this.stage.button('Take the other text', async () => { await this.replace(asked, take); this.other.hidden = true; }));
    }

    write() {
        for (const [name, text] of Object.entries(this.files)) this.stage.program.write(name, text);
    }

    // If `original` is true, write the original texts, because the reader's changes have kept the program from running;
    // otherwise write the changes.
    async lay(original) {
        const {program} = this.stage;
        if (!original) return this.write();
        for (const name of Object.keys(this.files)) {
            const text = await this.original(name);
            if (text !== null) program.write(name, text);
        }
    }

    // The current text of a file. While `lay` holds, the program's file has another text.
    text(name) { return this.files[name] ?? this.stage.program.read(name); }

    get any() { return Object.keys(this.files).length > 0; }

    async change(name, text) {
        const {program} = this.stage;
        program.write(name, text); // the program notices that the file has changed, and reloads it
        const later = [...program.later].some((one) => text.includes(`"${nameOf(one)}"`));
        if (later && this.stage.at) program.fetchFiles(this.stage.at.stem, this.stage.line).catch(() => {}); // the text may include files that were not needed before
        this.files[name] = text;
        let stored = edits.keep(name, text); // at once, because the reader may be leaving the page
        edits.show('');
        document.dispatchEvent(new CustomEvent('changed', {detail: name}));
        if (text === await this.original(name).catch(() => null) && this.files[name] === text) {
            delete this.files[name];
            stored = edits.keep(name, null);
        }
        this.saved.textContent = stored ? '' : 'This browser cannot store your changes: copy a link to save them.';
        this.tell();
    }

    // Give a file a text that the reader did not type.
    async put(name, text) {
        this.editor?.put(name, text);
        if (this.editor?.name !== name) await this.change(name, text);
    }

    async undo(names) {
        await this.replace(names, async () => {
            for (const name of names) {
                const text = await this.original(name);
                if (text !== null) await this.put(name, text);
            }
        });
        edits.show('');
    }

    // Carry out a press that replaces the reader's texts of files, and offer to restore them.
    async replace(names, act) {
        await this.editor?.flush();
        const texts = Object.fromEntries(names.filter((name) => this.files[name] !== undefined).map((name) => [name, this.files[name]]));
        const focused = [this.line, this.other].some((one) => one.contains(document.activeElement));
        await act(names);
        this.offer(texts);
        if (focused) this.replaced.querySelector('button')?.focus({preventScroll: true});
    }

    // Offer to restore texts, until the reader goes on typing.
    offer(texts) {
        const names = Object.keys(texts);
        this.replaced.hidden = names.length === 0;
        this.replaced.replaceChildren(`Your text of ${names.join(', ')} has been replaced. `, this.stage.button('Restore', async () => {
            if (this.replaced.querySelector(':focus-visible')) this.stage.canvas.focus({preventScroll: true});
            this.offer({});
            for (const name of names) await this.put(name, texts[name]);
        }));
    }

    // Show which files of the running shader have been changed.
    tell() {
        const running = this.stage.state?.files;
        this.named = Object.keys(this.files).filter((name) => !running || running.includes(PREFIX + name));
        const text = edits.withChanges(this.named);
        if (this.said.textContent !== text) this.said.textContent = text;
        this.line.hidden = this.named.length === 0;
    }

    // ---- The editor ----

    async toggle(open = this.element.hidden) {
        this.open.setAttribute('aria-expanded', String(open));
        this.element.hidden = !open;
        this.stage.at.classList.toggle('live-editing', open);
        this.judge.hidden = !this.stage.at.form;
        if (!open) return this.editor?.flush();
        const {Editor} = await import('./editor.js');
        this.editor ??= new Editor(this.place, {
            read: (name) => this.text(name),
            changed: (name, text) => {
                this.offer({});
                this.other.hidden = true; // the reader has decided
                return this.change(name, text);
            },
            bottom: () => this.stage.error.hidden ? Infinity : Math.min(...[this.bar, this.stage.error].map((one) => one.getBoundingClientRect().top)),
        });
        this.show(this.stage.state);
        if (document.activeElement.matches('input:not([type=file])')) return; // the reader is already typing elsewhere, for example the name of a draft
        this.editor.view.focus();
        this.element.scrollIntoView({block: 'start'}); // scrolls the editor to just below the picture, which remains visible
    }

    show(state) {
        this.tell();
        if (!this.editor || this.element.hidden || !state) return;
        const [own, ...parts] = state.files.filter((path) => path.startsWith(PREFIX) && SHADER.test(path)).map((path) => path.slice(PREFIX.length));
        const named = new Set([...this.text(own).matchAll(/^\s*#\s*include\s+"([^"\n]*)"/gm)].map(([, name]) => nameOf(name))), isNamed = (name) => named.has(nameOf(name));
        this.editor.open([own, ...parts.filter(isNamed), ...parts.filter((name) => !isNamed(name))]); // what the shader itself includes comes first
        this.editor.complain(state.error.replaceAll(PREFIX, ''));
        const mine = this.editor.name === own && this.stage.program.course.has(own); // a chapter's shader becomes the reader's answer to an exercise
        this.download.textContent = `Download ${mine ? 'my.frag' : nameOf(this.editor.name)}`;
    }

    hand() {
        const name = this.download.textContent.slice('Download '.length);
        const url = URL.createObjectURL(new Blob([this.editor.text()], {type: 'text/plain'}));
        this.stage.part('a', {href: url, download: name}).click();
        setTimeout(() => URL.revokeObjectURL(url), 10000);
        const others = Object.keys(this.files).filter((one) => one !== this.editor.names[0]);
        this.saved.textContent = name === 'my.frag' && others.length > 0 ? `You have also changed ${others.join(', ')}, which my.frag does not contain.` : '';
    }

    async link() {
        await this.editor.flush();
        const {at, program} = this.stage, [own] = this.editor.names; // a text of the reader's own belongs to the link even if it has not been changed
        edits.show(await edits.pack(at.stem, this.stage.line + this.stage.settings, program.course.has(own) ? this.files : {[own]: this.text(own), ...this.files}));
        try {
            await navigator.clipboard.writeText(location.href);
            this.saved.textContent = 'Copied. The address of this page now contains your changes.';
        } catch {
            this.saved.textContent = 'The address of this page now contains your changes. Copy it.';
        }
    }
}
