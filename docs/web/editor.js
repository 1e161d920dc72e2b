// editor.js - an editor for the files of the running shader, one per tab, with errors marked at their lines. esbuild
// bundles this module and CodeMirror into one file, which is loaded when a reader opens the editor.
import {EditorState} from '@codemirror/state';
import {EditorView, keymap, lineNumbers, highlightActiveLine, highlightActiveLineGutter, drawSelection} from '@codemirror/view';
import {defaultKeymap, history, historyKeymap, undo} from '@codemirror/commands';
import {HighlightStyle, StreamLanguage, bracketMatching, indentUnit, syntaxHighlighting} from '@codemirror/language';
import {searchKeymap, highlightSelectionMatches} from '@codemirror/search';
import {lintGutter, lintKeymap, setDiagnostics} from '@codemirror/lint';
import {shader} from '@codemirror/legacy-modes/mode/clike';
import {tags} from '@lezer/highlight';

const REST = 300; // milliseconds from the last change to the moment when the text is tried

const colours = syntaxHighlighting(HighlightStyle.define([
    {tag: [tags.keyword, tags.controlKeyword, tags.modifier], class: 'live-keyword'},
    {tag: [tags.typeName, tags.standard(tags.variableName), tags.standard(tags.name)], class: 'live-type'},
    {tag: tags.comment, class: 'live-comment'},
    {tag: [tags.meta, tags.processingInstruction], class: 'live-meta'},
    {tag: [tags.number, tags.bool, tags.atom, tags.string], class: 'live-number'},
]));

// Parse the program's lines "FILE:LINE: error: TEXT" into {name, line, severity, message}.
export function problemsOf(error) {
    const found = [];
    for (const text of error.split('\n')) {
        const match = /^(\S+?):(\d+): (?:(error|warning): )?(.*)$/.exec(text);
        if (match) found.push({name: match[1], line: Number(match[2]), severity: match[3] || 'error', message: match[4]});
    }
    return found;
}

function diagnostics(state, name, problems) {
    return problems.filter((problem) => problem.name === name).map(({line, severity, message}) => {
        const at = state.doc.line(Math.max(1, Math.min(line, state.doc.lines)));
        const from = at.from + /^\s*/.exec(at.text)[0].length;
        return {from, to: Math.max(from, at.to), severity, message};
    });
}

export class Editor {
    //   parent   receives the tabs and the text
    //   read     returns the text of a file, given its name
    //   changed  is called with a file's name and its new text, when the reader stops typing
    //   bottom   returns the position on the screen, in pixels from the top, below which the text is covered; Infinity
    //            if nothing covers the text
    constructor(parent, {read, changed, bottom}) {
        this.read = read;
        this.changed = changed;
        this.bottom = bottom;
        this.states = new Map(); // the editor's state for each file that has been shown
        this.places = new Map(); // how far each of these files was scrolled
        this.problems = [];
        this.timer = 0;
        this.tabs = document.createElement('div');
        this.tabs.className = 'live-tabs';
        this.tabs.setAttribute('role', 'tablist');
        this.tabs.setAttribute('aria-label', 'Files of the shader');
        this.tabs.addEventListener('keydown', (event) => this.walk(event));
        this.page = document.createElement('div');
        this.page.id = 'live-text';
        this.page.setAttribute('role', 'tabpanel');
        parent.append(this.tabs, this.page);
        this.view = new EditorView({parent: this.page});
    }

    // Replace the text. A selection by mouse ends, because CodeMirror would apply its positions to the new text; a
    // movement without a button ends it.
    replace(state) {
        document.dispatchEvent(new MouseEvent('mousemove'));
        this.view.setState(state);
    }

    state(name) {
        return EditorState.create({
            doc: this.read(name),
            extensions: [
                // With the focus elsewhere, a browser's Ctrl+Z would change this text, even while the editor is closed.
                EditorView.domEventHandlers({beforeinput: (event, view) => /^history/.test(event.inputType) && !view.hasFocus}),
                lineNumbers(), history(), drawSelection(), bracketMatching(), highlightActiveLine(), highlightActiveLineGutter(), highlightSelectionMatches(),
                StreamLanguage.define(shader), colours, lintGutter(), EditorState.tabSize.of(4), indentUnit.of('    '),
                // Tab is left to the page, so that a reader who uses only the keyboard can leave the editor.
                keymap.of([...searchKeymap, ...historyKeymap, ...lintKeymap, ...defaultKeymap]),
                EditorView.lineWrapping,
                EditorView.contentAttributes.of({'aria-label': `Text of ${name}`, 'tabindex': '0', 'spellcheck': 'false', 'autocapitalize': 'off'}),
                EditorView.updateListener.of((update) => {
                    if (!update.docChanged) return;
                    this.uncover();
                    clearTimeout(this.timer);
                    this.timer = setTimeout(() => this.flush(), REST);
                    this.waits = true;
                }),
            ],
        });
    }

    // Pass on a change that is still waiting for a pause in typing. Resolves when the change has been passed on.
    async flush() {
        clearTimeout(this.timer);
        if (!this.waits) return;
        this.waits = false;
        await this.changed(this.name, this.text());
    }

    // Take back the last change, for those whose keyboard has no Ctrl+Z.
    back() {
        undo(this.view);
        this.view.focus();
    }

    text() { return this.view.state.doc.toString(); }

    // Show tabs for these files, and select the first file if none of them is shown now.
    open(names) {
        const list = names.join();
        if (list === this.list) return;
        this.list = list;
        this.names = names;
        this.tabs.replaceChildren(...names.map((name) => {
            const tab = document.createElement('button');
            tab.type = 'button';
            tab.textContent = name.slice(name.lastIndexOf('/') + 1);
            tab.title = name;
            tab.setAttribute('role', 'tab');
            tab.setAttribute('aria-controls', 'live-text');
            tab.addEventListener('click', () => this.show(name));
            return tab;
        }));
        this.show(names.includes(this.name) ? this.name : names[0]);
        this.mark();
    }

    show(name) {
        if (name !== this.name) {
            this.flush();
            if (this.name) {
                this.states.set(this.name, this.view.state);
                this.places.set(this.name, this.view.scrollSnapshot());
            }
            this.name = name;
            this.replace(this.states.get(name) || this.state(name));
            this.view.dispatch({effects: this.states.has(name) && this.places.get(name) || EditorView.scrollIntoView(0, {y: 'start'})});
        }
        this.names.forEach((one, i) => {
            this.tabs.children[i].setAttribute('aria-selected', one === name);
            this.tabs.children[i].tabIndex = one === name ? 0 : -1;
        });
        this.lint();
    }

    walk(event) {
        const way = {ArrowRight: 1, ArrowLeft: -1}[event.key];
        if (!way) return;
        event.preventDefault();
        const at = (this.names.indexOf(this.name) + way + this.names.length) % this.names.length;
        this.show(this.names[at]);
        this.tabs.children[at].focus();
    }

    // Show a file's new text and forget the old one, so that undo cannot restore it.
    renew(name) {
        this.states.delete(name);
        if (name !== this.name) return;
        clearTimeout(this.timer);
        this.waits = false;
        this.replace(this.state(name));
        this.lint();
    }

    // Give a file a text that the reader did not type. If the file is shown, undo restores its old text.
    put(name, text) {
        if (name === this.name) {
            this.view.dispatch({changes: {from: 0, to: this.view.state.doc.length, insert: text}});
            this.flush();
        } else {
            this.states.delete(name);
        }
    }

    // Mark the lines with errors, and the tabs of their files.
    complain(error) {
        if (error === this.error) return;
        this.error = error;
        this.problems = problemsOf(error);
        this.lint();
        this.mark();
        this.uncover();
    }

    // Scroll the page until the line that is being edited is fully visible.
    uncover() {
        this.view.requestMeasure({
            key: this,
            read: (view) => view.hasFocus ? (view.coordsAtPos(view.state.selection.main.head)?.bottom ?? 0) + 4 - this.bottom() : 0,
            write: (hidden) => { if (hidden > 0) scrollBy({top: hidden, behavior: 'instant'}); },
        });
    }

    lint() {
        if (this.name) this.view.dispatch(setDiagnostics(this.view.state, diagnostics(this.view.state, this.name, this.problems)));
    }

    mark() {
        this.names?.forEach((name, i) => this.tabs.children[i].classList.toggle('live-faulty', this.problems.some((problem) => problem.name === name)));
    }
}
