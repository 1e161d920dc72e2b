// check.js - draws pictures in a separate program and compares them: `make check` compares the pictures and rays of the
// reader's answer to an exercise with those of the solution, and `make compare` compares two pictures.
// tests/pictures/images.txt and tests/course/checks.txt list the pictures of an exercise; the numbers and messages come
// from tests/lib/judge.c.
import {Program} from './program.js';
import {draftOf, kept, shownBy, withChanges} from './edits.js';

const SOLUTION = (stem, number) => `chapters/solutions/${stem}_${number}.frag`;
const MINE = 'my.frag';

// The pictures and rays that are compared for an exercise, "03_2": {stem, number, pictures: [{options, shown, rays,
// places}]}.
async function exercise(name) {
    const answer = await fetch(new URL('exercises.txt', import.meta.url));
    if (!answer.ok) throw new Error(`cannot load the list of exercises: ${answer.status} ${answer.statusText}`);
    const rows = (await answer.text()).trim().split('\n').map((line) => line.split('|')).filter(([one]) => one === name);
    if (rows.length === 0) throw new Error(`exercise ${name} has no solution to compare with`);
    return {stem: rows[0][1], number: name.slice(3), pictures: rows.map(([, , options, shown, rays, places]) => ({options, shown, rays, places}))};
}

// A separate, invisible program, so that the one in the page can continue.
class Judge {
    static async load() {
        const judge = new Judge();
        judge.canvas = document.createElement('canvas');
        judge.program = await Program.load(judge.canvas, {
            onLine: (text, isError) => (isError ? judge.errors : judge.lines).push(text),
            onPicture: (data) => { judge.picture = data; },
        });
        return judge;
    }

    close() {
        this.program.stop();
        this.canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    }

    async run(stem, line) {
        this.lines = [];
        this.errors = [];
        this.picture = null;
        await new Promise((painted) => setTimeout(painted)); // lets the page show the progress
        const status = await this.program.start(stem, line);
        this.program.stop();
        if (status === 0 && !this.program.lost) return '';
        return this.program.lost ? 'does not end: the graphics driver stopped it' : `does not run: ${this.errors.find((line) => /:\d+: /.test(line)) || this.errors[0] || `status ${status}`}`.replaceAll('/course/', '');
    }

    async draw(stem, line) {
        const why = await this.run(stem, line);
        return {why, data: this.picture};
    }

    async march(stem, rays, places, file) {
        await this.run(stem, `${rays} ${places.split(' ').map((place) => `--probe ${place}`).join(' ')} --shader ${file}`);
        return this.lines.join('\n');
    }

    // ---- Functions of tests/lib/judge.c ----

    call(name, ...values) {
        return this.program.module.ccall(name, name === 'judge_share' ? 'number' : 'string', values.map((value) => typeof value), values);
    }

    // Returns the judge's objection ('' if there is none), a description and a picture of the difference, the share of
    // pixels that differ by more than 2 of 255, and the centre of the 8 × 8 block that differs most.
    compare(shown, right, mine) {
        if (right.width !== mine.width || right.height !== mine.height) throw new Error(`one picture has ${right.width} × ${right.height} pixels, the other ${mine.width} × ${mine.height}`);
        const {module} = this.program, size = 3 * right.width * right.height;
        const at = [right, mine, null].map((picture) => {
            const start = module._malloc(size);
            if (picture) for (let i = 0, to = start; i < picture.data.length; i += 4)
                for (let c = 0; c < 3; c++) module.HEAPU8[to++] = picture.data[i + c];
            return start;
        });
        const words = this.call('judge_picture', shown, right.width, right.height, ...at);
        const difference = new ImageData(right.width, right.height);
        for (let i = 0, from = at[2]; i < difference.data.length; i += 4) {
            for (let c = 0; c < 3; c++) difference.data[i + c] = module.HEAPU8[from++];
            difference.data[i + 3] = 255;
        }
        for (const start of at) module._free(start);
        return {words, said: this.call('judge_words'), difference, share: this.call('judge_share'), place: this.call('judge_pixel')};
    }
}

// ---- An exercise ----

// Judge the text of an answer to an exercise. Returns {right, words, place?, rays?, pictures?: {mine, difference}}.
//   told  is called with messages about progress
export async function judge(name, text, told = () => {}) {
    const {stem, number, pictures} = await exercise(name);
    const solution = SOLUTION(stem, number), own = await Judge.load();
    try {
        own.program.write(MINE, text);
        let worst = 0;
        for (const [i, {options, shown, rays, places}] of pictures.entries()) {
            told(`Picture ${i + 1} of ${pictures.length} …`);
            const drawn = (file) => own.draw(stem, `${options} --output picture.png --shader ${file}`);
            const right = await drawn(solution);
            if (right.why) throw new Error(`the solution ${right.why}`);
            const mine = await drawn(MINE);
            if (mine.why) return {right: false, words: mine.why};
            const {words, difference, share, place} = own.compare(shown, right.data, mine.data);
            if (words) {
                const told = [];
                for (const file of [MINE, solution]) told.push(own.call('judge_ray', await own.march(stem, rays, place, file)));
                return {right: false, words, place, rays: told, pictures: {mine: mine.data, difference}};
            }
            worst = Math.max(worst, share);
            if (i > 0) continue;
            const wrong = own.call('judge_rays', shown, places, await own.march(stem, rays, places, solution), await own.march(stem, rays, places, MINE));
            if (wrong) return {right: false, words: wrong, pictures: {mine: mine.data, difference}};
        }
        return {right: true, words: own.call('judge_right', pictures.length, worst)};
    } finally {
        own.close();
    }
}

// ---- Two pictures ----

// Draw two pictures and compare them. Returns {words, changed, pictures: [{name, data}], difference}.
//   stem   the stem of the chapter whose program draws them
//   lines  the program's command line for each picture, with --output
//   files  the files that the reader has changed, {NAME: TEXT}; `changed` lists those that the pictures show
//   told   is called with messages about progress
export async function compare(stem, lines, files, told = () => {}) {
    const own = await Judge.load();
    try {
        const pictures = [], changed = new Set();
        for (const [name, text] of Object.entries(files)) own.program.write(name, text);
        for (const [i, line] of lines.entries()) {
            told(`Picture ${i + 1} of ${lines.length} …`);
            const name = /--output[ =](\S+)/.exec(line)[1];
            const {why, data} = await own.draw(stem, line);
            if (why) throw new Error(`${name} ${why}`);
            pictures.push({name, data});
            for (const file of shownBy(Object.keys(files), stem, line)) changed.add(file);
        }
        const {said, difference} = own.compare('', ...pictures.map(({data}) => data));
        return {words: said, changed: [...changed], pictures, difference};
    } finally {
        own.close();
    }
}

// ---- In a page ----

function shown(part, data, words) {
    const canvas = part('canvas', {width: data.width, height: data.height});
    canvas.getContext('2d').putImageData(data, 0, 0);
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', words);
    return part('figure', {}, canvas, part('figcaption', {textContent: words}));
}

// The files that the reader has changed: {NAME: TEXT}.
async function changesOf(stage) {
    await stage?.changes.editor?.flush();
    return {...kept(), ...stage?.changes.files};
}

const GREY = 'The difference: grey where the two pictures are equal';

// Carry out the check that a form.check requests.
//   edit  opens the editor with the answer; a second argument gives the text with which the answer begins
export async function check(form, stage, part, edit) {
    if (form.getAttribute('aria-busy') === 'true') return;
    const place = form.chapter?.matches('.live-editing') ? form.chapter : form; // below the editor, if the reader works there
    for (const other of [form, form.chapter]) if (other !== place) other?.querySelector(':scope > .live-verdict')?.remove();
    const verdict = place.querySelector(':scope > .live-verdict') || place.appendChild(part('div', {className: 'live-verdict'}));
    verdict.setAttribute('role', 'status');
    const say = (...words) => verdict.replaceChildren(part('p', {}, ...words));
    const works = (does) => { // the verdict may be below the screen, but the button that was pressed is on it
        if (does) form.setAttribute('aria-busy', 'true');
        else form.removeAttribute('aria-busy');
        for (const button of [form.querySelector('[type=submit]'), stage?.changes.judge]) if (button) button.textContent = does ? 'Checking …' : 'Check';
    };
    works(true);
    try {
        const name = (form.dataset.exercise || '').replace('-', '_');
        const {stem} = await exercise(name);
        const files = await changesOf(stage), own = draftOf(name), chapter = `chapters/${stem}.frag`;
        if (files[own] === undefined) {
            const button = (text, from) => {
                const made = part('button', {type: 'button', className: 'live-open', textContent: text});
                made.addEventListener('click', () => edit(form, from));
                return made;
            };
            say('You have not changed the shader of this exercise yet. Change it as the exercise asks, then check it. ', button('Open the editor'),
                ...(files[chapter] === undefined ? [] : [' ', button(`Begin with your changes in ${chapter}`, files[chapter])]));
            return;
        }
        say('Loading …');
        const {right, words, place, rays, pictures} = await judge(name, files[own], (text) => say(text));
        say(part('strong', {textContent: right ? 'Right: ' : 'Wrong: '}), `${words}.`);
        verdict.classList.toggle('live-right', right);
        document.addEventListener('changed', function changed({detail}) { // the verdict is about the text that was checked
            if (detail !== own) return;
            document.removeEventListener('changed', changed);
            if (!verdict.querySelector('.live-earlier')) verdict.prepend(part('p', {className: 'live-earlier', textContent: 'This is about an earlier text:'}));
        });
        if (right) document.dispatchEvent(new CustomEvent('solved', {detail: name}));
        if (place) verdict.append(part('p', {}, `Your ray of pixel ${place}: ${rays[0]}`, part('br'), `The solution's ray: ${rays[1]}`));
        if (pictures) verdict.append(part('div', {className: 'live-two'}, shown(part, pictures.mine, 'Yours'), shown(part, pictures.difference, GREY)));
        const others = Object.keys(files).filter((one) => one.startsWith('shaders/'));
        if (others.length > 0) verdict.append(part('p', {textContent: `The check ignores your changes in ${others.join(', ')}.`}));
    } catch (error) {
        say(`Your shader cannot be checked: ${error.message}.`);
    } finally {
        works(false);
        verdict.scrollIntoView({block: 'nearest'});
    }
}

// Carry out the comparison that a `make compare` button requests, and show the result in `box`.
export async function compareIn(box, button, stage, part) {
    const say = (text) => box.replaceChildren(part('p', {textContent: text}));
    const {stem, line, other} = button.dataset;
    try {
        say('Loading …');
        const {words, changed, pictures, difference} = await compare(stem, [line, other], await changesOf(stage), say);
        say(`${words}.`);
        if (changed.length > 0) box.append(part('p', {textContent: withChanges(changed)}));
        box.append(part('div', {className: 'live-two'}, ...pictures.map(({name, data}) => shown(part, data, name)), shown(part, difference, GREY)));
    } catch (error) {
        say(`The pictures cannot be compared: ${error.message}.`);
    }
}
