// play.js - the Play page, a studio: templates to start from, named drafts with pictures that are stored on this device,
// files that are dropped or chosen, a copy under another name, and one file for Shadertoy.
import {keep as store, kept, show as address, unpack} from './edits.js';
import {gather, shaders} from './dropped.js';

const box = document.querySelector('.drop'), chapter = box.querySelector('live-chapter'), said = box.querySelector('.said'), list = box.querySelector('.drafts');
const studio = box.querySelector('.studio'), field = box.querySelector('.title'), tools = [...box.querySelectorAll('.studio button, .title')];
const LIMIT = 1 << 20; // the maximum size of a file in bytes; a shader has a few thousand
const KEY = `ray marching: drafts in ${new URL('.', location.href).pathname}`, STEM = chapter.getAttribute('stem'), SIZE = [320, 180], LOOK = 2000;
const BLANK = 'void mainImage(out vec4 colour, in vec2 pixel)\n{\n    colour = vec4(pixel / iResolution.xy, 0.5, 1.0);\n}\n';
let at = ''; // the name of the open draft; '' if none is open
let pictured = null; // the draft's text when its picture was taken
const {type: visit} = performance.getEntriesByType('navigation')[0] ?? {};

const say = (text) => { said.textContent = text; };
const make = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
};

// ---- Stored drafts ----

// {NAME: {base, stem, from, options, good, picture, deleted}}: the text with which a draft began, the chapter whose camera
// it uses, the template, the options with which it was last shown, the last text that was drawn, a small picture of that
// text, and whether the reader has deleted the draft, which can then still be restored. edits.js stores the changes of a
// draft.
let unstored = null; // the drafts, if the browser does not store them
function drafts() { try { return unstored ?? JSON.parse(localStorage.getItem(KEY)) ?? {}; } catch { return {}; } }
function keep(all) {
    unstored = null;
    try { localStorage.setItem(KEY, JSON.stringify(all)); } catch {
        unstored = all;
        say('This browser cannot store drafts: download those that you want to keep.');
    }
    show();
}

// A name that the program's file system and its messages can represent, and that no chapter has.
const slug = (name) => name.replace(/\.\w+$/, '').replace(/[^\w-]+/g, '_').slice(0, 60).replace(/^_+|_+$/g, '').replace(/^(?=\d\d_)/, 'my_') || 'shader';
const fileOf = (name) => `chapters/${name}.frag`;
const shows = (name) => chapter.program?.state().files?.[0] === `/course/${fileOf(name)}`;
const textOf = (name) => shows(name) ? chapter.stage.changes.text(fileOf(name)) : kept()[fileOf(name)] ?? drafts()[name].base;
const typed = () => chapter.stage?.changes.editor?.flush(); // store what has been typed into the editor

// A name that no draft has. A deleted draft keeps its name.
function free(name) {
    const all = drafts();
    for (let i = 1; ; i++) {
        const one = i === 1 ? name : `${name}_${i}`;
        if (!all[one]) return one;
    }
}

let leaves = false; // while the page is being left, its policy refuses new pictures
function show() {
    if (leaves) return;
    const focus = list.contains(document.activeElement) && document.activeElement.id;
    list.replaceChildren(...Object.entries(drafts()).map(([name, {picture, deleted}]) => {
        const open = make('button', {type: 'button', id: `open-${name}`, className: 'draft', disabled: deleted}, ...(picture ? [make('img', {src: picture, alt: '', width: SIZE[0], height: SIZE[1]})] : []), name.replaceAll('_', ' '));
        const drop = make('button', {type: 'button', id: dropOf(name), textContent: deleted ? 'Undo' : 'Delete', ariaLabel: deleted ? `Undo: restore ${name}` : `Delete ${name}`});
        open.addEventListener('click', () => reopen(name));
        drop.addEventListener('click', () => deleted ? restore(name) : forget(name));
        open.setAttribute('aria-current', name === at);
        return make('li', {}, open, drop);
    }));
    list.hidden = list.childElementCount === 0;
    if (focus) document.getElementById(focus)?.focus({preventScroll: true});
}
const dropOf = (name) => `drop-${name}`;

// Remove a draft for good.
function remove(name) {
    const {[name]: gone, ...rest} = drafts();
    if (chapter.stage) chapter.stage.changes.forget(fileOf(name));
    else store(fileOf(name), null);
    keep(rest);
}

// Delete a draft. It remains in the list, where Undo replaces Delete, and is stored until a draft is deleted in a later
// visit to this page.
let before = Object.keys(drafts()).filter((name) => drafts()[name].deleted); // the drafts that were deleted in earlier visits
async function forget(name) {
    await typed();
    for (const one of before) if (drafts()[one]?.deleted) remove(one);
    before = [];
    if (!drafts()[name]) return show(); // another tab has removed it
    keep({...drafts(), [name]: {...drafts()[name], deleted: true}});
    if (name === at) {
        remember();
        opened('');
        chapter.stage?.close();
        chapter.hidden = studio.hidden = true;
        document.getElementById(dropOf(name)).focus();
    }
    say(`${name} is deleted. Undo restores it.`);
}

function restore(name) {
    if (drafts()[name]) keep({...drafts(), [name]: {...drafts()[name], deleted: false}});
    say(`${name} is restored.`);
}

// ---- Running ----

const still = make('img', {alt: '', hidden: true}); // the last picture, which is shown when the program is closed
chapter.screen.prepend(still);

// Note which draft is open, in this tab, because it runs again after a reload.
function opened(name) {
    at = name;
    try { sessionStorage.setItem(KEY, name); } catch {} // the browser stores nothing
}
const lastOpen = () => { try { return sessionStorage.getItem(KEY); } catch { return null; } };

// The steps for a first ball, which are beside the editor while a draft that began as the ball is open.
const steps = document.querySelector('main > ol'), guide = make('div', {className: 'guide', tabIndex: 0, ariaLabel: 'A ball in two minutes'}, steps.cloneNode(true));
guide.setAttribute('role', 'group');

// Run a draft.
//   base     the text that Reset restores
//   text     the current text
//   options  more options for the program
//   from     the id of the template's button
async function play(name, base, text = base, {stem = STEM, options = '', from = drafts()[name]?.from} = {}) {
    remember();
    opened(name);
    field.value = name.replaceAll('_', ' ');
    keep({...drafts(), [name]: {...drafts()[name], base, stem, from}});
    chapter.hidden = studio.hidden = false;
    chapter.button.textContent = '▶ Run';
    still.hidden = true;
    if (from === 'new=ball') chapter.append(guide);
    else guide.remove();
    const status = await chapter.play(`${name}.frag`, base, text, stem, options);
    if (at !== name) return; // meanwhile, the reader has opened another draft, or deleted this one
    for (const tool of tools) tool.disabled = tool.matches('.export') && status !== 0;
    pictured = null; // take a picture once the text is drawn
    say(status === 0 ? `${name}.frag runs.` : `${name}.frag cannot be drawn; see the error above.`);
}

// Take what was dropped or chosen: each shader with its parts becomes a draft, and the first one runs. Of several files,
// those that are no texts are left out.
async function take(from) {
    const files = await gather(from), texts = {};
    for (const {path, file} of files) {
        const one = files.length === 1, large = file.size > LIMIT, text = large ? '' : await file.text();
        if (large && one) return say(`${file.name}: ${Math.round(file.size / 1e6)} MB is too large for a shader; the limit is 1 MB`);
        if (text.includes('\0') && one) return say(`${file.name}: this is not a text file`);
        if (!large && !text.includes('\0')) texts[path] = text;
    }
    const [first, ...more] = shaders(texts);
    if (!first) return;
    await typed();
    for (const {path, text} of more) {
        const name = slug(path.replace(/.*\//, ''));
        if (!drafts()[name] || textOf(name) !== text) keep({...drafts(), [free(name)]: {base: text, stem: STEM}});
    }
    await begin(slug(first.path.replace(/.*\//, '')), first.text);
    if (more.length > 0) said.append(` ${more.length} more ${more.length === 1 ? 'shader is a draft' : 'shaders are drafts'}.`);
}

// Run a text as the draft with a name, or as another draft if there is one with this name and another text.
async function begin(name, text, more = {}) {
    const own = free(name);
    const same = Object.entries(drafts()).find(([one, {deleted}]) => !deleted && (one === name || one.startsWith(`${name}_`)) && textOf(one) === text);
    if (same) return reopen(same[0], more);
    await play(own, text, text, more);
    if (own !== name && at === own) said.append(` The draft ${name} is still there.`);
}

// If the last text of a draft was never drawn, it may block the browser. Then the reader chooses between this text and
// the last one that was drawn.
async function reopen(name, more = {}) {
    await typed();
    if (!drafts()[name]) return show(); // another tab has removed it
    if (name === at && draws() && Object.keys(more).length === 0) return chapter.scrollIntoView({block: 'nearest'}); // it is open
    const {base, stem, options, good} = drafts()[name], text = textOf(name), button = (words, run) => {
        const made = make('button', {type: 'button', textContent: words});
        made.addEventListener('click', async () => {
            await play(name, base, run, {stem});
            if (run !== text && at === name) chapter.stage.changes.offer({[fileOf(name)]: text});
        });
        return made;
    };
    if (good === undefined || text === good) return play(name, base, text, {stem, options, ...more});
    said.replaceChildren(`The last change to ${name} was not drawn. `, button('Go back to the previous text', good), ' ', button('Run it', text));
}

// Is there a picture of the open draft, perhaps of an older text?
const isDrawn = () => at && drafts()[at] && chapter.classList.contains('live-drawn') && !chapter.program?.lost && shows(at);

// Has the text of the open draft been drawn?
function draws() {
    if (!isDrawn()) return false;
    const {error, compiles} = chapter.program.state();
    return error === '' && !compiles && chapter.program.reread;
}
// Store more about the open draft, whose text has been drawn. If another tab has stored another text, that tab knows more.
function note(more) {
    const all = drafts(), text = textOf(at);
    if (unstored || (kept()[fileOf(at)] ?? all[at].base) === text) keep({...all, [at]: {...all[at], ...more, ...draws() && {good: text}}});
}

// Keep the values, the camera and the view of the open draft.
const remember = () => { if (isDrawn()) note({options: chapter.stage.settings}); };

// Draw the picture again, also if nothing has changed, and take a small picture of the canvas at once, before the browser
// clears the canvas.
function picture() {
    const {program} = chapter;
    if (document.hidden) return;
    program.call('live_time', program.state().time);
    if (!program.module._live_turn()) return;
    const canvas = make('canvas', {width: SIZE[0], height: SIZE[1]});
    canvas.getContext('2d').drawImage(program.canvas, 0, 0, ...SIZE);
    const taken = canvas.toDataURL('image/jpeg', 0.7);
    still.src = taken;
    still.hidden = false;
    note({picture: taken});
}
setInterval(() => {
    if (!draws() || textOf(at) === pictured) return;
    pictured = textOf(at);
    picture();
}, LOOK);
addEventListener('pagehide', () => {
    leaves = true;
    remember();
    leaves = false;
});

// ---- Input ----

for (const button of box.querySelectorAll('.starter')) button.addEventListener('click', async () => {
    const text = button.dataset.file ? await fetch(`course/${button.dataset.file}`).then((answer) => answer.text()) : BLANK;
    await play(free(button.id.replace('new=', '')), text, text, {stem: button.dataset.stem, from: button.id});
});
box.querySelector('input[type=file]').addEventListener('change', (event) => take(event.target));
box.addEventListener('dragover', (event) => { event.preventDefault(); box.classList.add('over'); });
box.addEventListener('dragleave', () => box.classList.remove('over'));
// Without these two listeners, a file that is dropped outside the box would replace the page.
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
    event.preventDefault();
    box.classList.remove('over');
    take(event.dataTransfer);
});
field.addEventListener('change', async () => {
    const old = at, name = slug(field.value); // another draft may be opened meanwhile
    await typed();
    if (!drafts()[old] || name === old) return;
    remember();
    const {base, stem, from, options} = drafts()[old], text = textOf(old), own = free(name);
    await play(own, base, text, {stem, from, options});
    if (drafts()[own] && [old, own].every((one) => textOf(one) === text)) remove(old); // otherwise, the reader was typing meanwhile
});
box.querySelector('.remix').addEventListener('click', async () => {
    await typed();
    remember();
    if (drafts()[at]) await play(free(at), textOf(at), textOf(at), drafts()[at]);
});
function save(text, name) {
    const url = URL.createObjectURL(new Blob([text], {type: 'text/plain'}));
    make('a', {href: url, download: name}).click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
}
box.querySelector('.save').addEventListener('click', async () => {
    await typed();
    if (at) save(textOf(at), `${at}.frag`);
});
box.querySelector('.export').addEventListener('click', async () => {
    save(await chapter.exported(), 'shadertoy.glsl');
    say('shadertoy.glsl is written. Paste its text into a new shader on Shadertoy.');
});

// ---- The address ----

// A shader in the address of this page runs when the reader presses a button, because it is somebody else's and may block
// the browser. It becomes a draft.
const isLink = () => location.hash.startsWith('#edit=');
async function invite() {
    if (!isLink()) return;
    await typed();
    opened('');
    chapter.stage?.close();
    chapter.hidden = false;
    studio.hidden = true;
    chapter.button.textContent = '▶ Run the shader in this link';
    still.hidden = true;
}
async function accept() {
    try {
        const {stem, line, files} = await unpack(), name = /--shader[ =]chapters\/([\w-]+)\.frag/.exec(line)?.[1], text = files[fileOf(name)];
        if (text === undefined) throw new Error('there is none');
        await begin(slug(name), text, {stem, options: line.replace(/--shader[ =]\S+/, '')});
    } catch (error) {
        chapter.hidden = true;
        say(`The shader in this link cannot be read: ${error.message}.`);
    }
    address('');
}
chapter.addEventListener('click', (event) => {
    if (event.target !== chapter.button || !isLink()) return;
    event.stopPropagation();
    accept();
}, {capture: true});
addEventListener('hashchange', invite);

show();
const own = visit === 'reload' && drafts()[lastOpen()];
if (own && !own.deleted) reopen(lastOpen());
else invite();
// The button on the front page opens this page with #new=ball, which starts a draft of a ball.
if (location.hash.startsWith('#new=')) {
    document.getElementById(location.hash.slice(1))?.click();
    history.replaceState(null, '', location.pathname); // so that a reload does not start another draft
}
