// play.js - the Play page, a studio: templates to start from, named drafts with pictures that are stored on this device,
// files that are dropped or chosen, a copy under another name, and one file for Shadertoy.
import {kept} from './edits.js';

const box = document.querySelector('.drop'), chapter = box.querySelector('live-chapter'), said = box.querySelector('.said'), list = box.querySelector('.drafts');
const field = box.querySelector('.title'), tools = [...box.querySelectorAll('.studio button, .title')];
const LIMIT = 1 << 20; // the maximum size of a file in bytes; a shader has a few thousand
const KEY = `ray marching: drafts in ${new URL('.', location.href).pathname}`, STEM = chapter.getAttribute('stem'), SIZE = [160, 90], LOOK = 2000;
const BLANK = 'void mainImage(out vec4 colour, in vec2 pixel)\n{\n    colour = vec4(pixel / iResolution.xy, 0.5, 1.0);\n}\n';
let at = ''; // the name of the open draft; '' if none is open
let pictured = null; // the draft's text when its picture was taken

const say = (text) => { said.textContent = text; };
const make = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
};

// ---- Stored drafts ----

// {NAME: {base, stem, good, picture}}: the text with which a draft began, the chapter whose camera it uses, the last
// text that was drawn, and a small picture of that text. edits.js stores the changes of a draft.
function drafts() { try { return JSON.parse(localStorage.getItem(KEY)) ?? {}; } catch { return {}; } }
function keep(all) {
    try { localStorage.setItem(KEY, JSON.stringify(all)); } catch { say('This browser cannot store drafts: download those that you want to keep.'); }
    show();
}

// A name that the program's file system and its messages can represent.
const slug = (name) => name.replace(/\.\w+$/, '').replace(/[^\w-]+/g, '_').replace(/^_+|_+$/g, '') || 'shader';
const fileOf = (name) => `chapters/${name}.frag`;
const textOf = (name) => kept()[fileOf(name)] ?? drafts()[name].base;

// A name that no draft has.
function free(name) {
    const all = drafts();
    for (let i = 1; ; i++) {
        const one = i === 1 ? name : `${name}_${i}`;
        if (!all[one]) return one;
    }
}

function show() {
    list.replaceChildren(...Object.entries(drafts()).map(([name, {picture}]) => {
        const open = make('button', {type: 'button', className: 'draft'}, ...(picture ? [make('img', {src: picture, alt: '', width: SIZE[0], height: SIZE[1]})] : []), name.replaceAll('_', ' '));
        const drop = make('button', {type: 'button', textContent: 'Delete', ariaLabel: `Delete ${name}`});
        open.addEventListener('click', () => reopen(name));
        drop.addEventListener('click', () => forget(name));
        open.setAttribute('aria-current', name === at);
        return make('li', {}, open, drop);
    }));
    list.hidden = list.childElementCount === 0;
}

async function forget(name) {
    const {[name]: gone, ...rest} = drafts();
    await chapter.stage?.changes.change(fileOf(name), gone.base);
    if (!chapter.stage) (await import('./edits.js')).keep(fileOf(name), null);
    keep(rest);
    if (name !== at) return;
    at = '';
    chapter.stage?.close();
    for (const tool of tools) tool.disabled = true;
}

// ---- Running ----

// Run a draft: `base` is the text that Reset restores, and `text` is the current text.
async function play(name, base, text = base, stem = STEM) {
    at = name;
    field.value = name.replaceAll('_', ' ');
    keep({...drafts(), [name]: {...drafts()[name], base, stem}});
    const status = await chapter.play(`${name}.frag`, base, text, stem);
    for (const tool of tools) tool.disabled = tool.matches('.export') && status !== 0;
    pictured = null; // take a picture once the text is drawn
    say(status === 0 ? `${name}.frag runs.` : `${name}.frag cannot be drawn; see the error above.`);
}

async function take(file) {
    if (!file) return;
    if (file.size > LIMIT) return say(`${file.name}: ${Math.round(file.size / 1e6)} MB is too large for a shader; the limit is 1 MB`);
    const text = await file.text();
    if (text.includes('\0')) return say(`${file.name}: this is not a text file`);
    await play(slug(file.name), text);
}

// If the last text of a draft was never drawn, it may block the browser. Then the reader chooses between this text and
// the last one that was drawn.
function reopen(name) {
    const {base, stem, good} = drafts()[name], text = textOf(name), button = (words, run) => {
        const made = make('button', {type: 'button', textContent: words});
        made.addEventListener('click', () => play(name, base, run, stem));
        return made;
    };
    if (good === undefined || text === good) return play(name, base, text, stem);
    said.replaceChildren(`The last change to ${name} was not drawn. `, button('Go back to the previous text', good), ' ', button('Run it', text));
}

// Has the text of the open draft been drawn?
function draws() {
    if (!at || !drafts()[at] || !chapter.classList.contains('live-drawn') || !chapter.program || chapter.program.lost) return false;
    const {error, compiles} = chapter.program.state();
    return error === '' && !compiles && chapter.program.reread;
}
const note = (more) => { const all = drafts(); keep({...all, [at]: {...all[at], ...more, good: textOf(at)}}); };

// Draw a frame and take a small picture of the canvas at once, before the browser clears the canvas.
function picture() {
    const {program} = chapter;
    if (document.hidden || !program.module._live_turn()) return;
    const canvas = make('canvas', {width: SIZE[0], height: SIZE[1]});
    canvas.getContext('2d').drawImage(program.canvas, 0, 0, ...SIZE);
    note({picture: canvas.toDataURL('image/jpeg', 0.7)});
}
setInterval(() => {
    if (!draws() || textOf(at) === pictured) return;
    pictured = textOf(at);
    picture();
}, LOOK);
addEventListener('pagehide', () => { if (draws()) note(); });

// ---- Input ----

for (const button of box.querySelectorAll('.starter')) button.addEventListener('click', async () => {
    const text = button.dataset.file ? await fetch(`course/${button.dataset.file}`).then((answer) => answer.text()) : BLANK;
    await play(free(button.id.replace('new=', '')), text, text, button.dataset.stem);
});
box.querySelector('input[type=file]').addEventListener('change', (event) => take(event.target.files[0]));
box.addEventListener('dragover', (event) => { event.preventDefault(); box.classList.add('over'); });
box.addEventListener('dragleave', () => box.classList.remove('over'));
// Without these two listeners, a file that is dropped outside the box would replace the page.
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
    event.preventDefault();
    box.classList.remove('over');
    take(event.dataTransfer.files[0]);
});
field.addEventListener('change', async () => {
    const before = at, text = textOf(at), {base} = drafts()[at], name = slug(field.value), {stem} = drafts()[at];
    if (name === before) return;
    await play(free(name), base, text, stem);
    await forget(before);
});
box.querySelector('.remix').addEventListener('click', () => play(free(at), textOf(at), textOf(at), drafts()[at].stem));
function save(text, name) {
    const url = URL.createObjectURL(new Blob([text], {type: 'text/plain'}));
    make('a', {href: url, download: name}).click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
}
box.querySelector('.save').addEventListener('click', () => save(textOf(at), `${at}.frag`));
box.querySelector('.export').addEventListener('click', async () => {
    save(await chapter.exported(), 'shadertoy.glsl');
    say('shadertoy.glsl is written. Paste its text into a new shader on Shadertoy.');
});
// A shader that a link contains becomes a draft once it runs.
box.querySelector('.live-start')?.addEventListener('click', async () => {
    await new Promise((ran) => { const wait = () => chapter.program?.call('live_runs') && !chapter.classList.contains('live-waits') ? ran() : requestAnimationFrame(wait); wait(); });
    const name = /^\/course\/chapters\/([\w-]+)\.frag$/.exec(chapter.program.state().files[0])?.[1];
    if (name && !/^\d\d_/.test(name)) await play(name, drafts()[name]?.base ?? chapter.program.read(fileOf(name)), chapter.program.read(fileOf(name)));
});

show();
// The button on the front page opens this page with #new=ball, which starts a draft of a ball.
if (location.hash.startsWith('#new=')) {
    document.getElementById(location.hash.slice(1))?.click();
    history.replaceState(null, '', location.pathname); // so that a reload does not start another draft
}
