// commands.mjs - decides what a command of a page becomes in the browser: a command line for the live program, a
// comparison of two pictures, a check of an exercise, or a reason why it needs a terminal (commands.txt).
import fs from 'node:fs';

const REASONS = fs.readFileSync(new URL('commands.txt', import.meta.url), 'utf8').split('\n')
    .filter((line) => line && !line.startsWith('#'))
    .map((line) => {
        const [pattern, reason] = line.split(' | ').map((part) => part.trim());
        return {pattern: new RegExp(pattern), reason};
    });
const STEMS = fs.readdirSync('chapters').filter((name) => /^\d\d_.*\.c$/.test(name)).map((name) => name.slice(0, -2)).sort();
// With any of these options, a window cannot show what --output would write.
const STILL = ['--probe', '--step', '--from', '--overlay', '--list', '--print-shader'];

// Maps the file name of every reference picture to its command line, {stem, line, probe, step}, from
// tests/pictures/images.txt. The pixel of --probe is removed from the line, because --probe would print its ray; it is
// given in fractions of the picture instead, so that a window of any size can show the ray. A picture with several
// samples per pixel is shown with one.
export const pictures = new Map(fs.readFileSync('tests/pictures/images.txt', 'utf8').split('\n').filter((line) => /^\d/.test(line)).map((row) => {
    const [stem, variant, ...words] = row.trim().split(/\s+/);
    const value = (name) => words.includes(name) ? words.splice(words.indexOf(name), 2)[1] : undefined;
    const probe = value('--probe')?.split(','), step = value('--step');
    value('-a');
    const [width, height] = (words[words.indexOf('-s') + 1] ?? '').match(/^(\d+)x(\d+)$/)?.slice(1) ?? [640, 360];
    return [`${stem}${variant === '-' ? '' : `-${variant}`}.png`, {stem, line: words.join(' '), step, probe: probe && `${probe[0] / width},${probe[1] / height}`}];
}));
const FIXED = /--(?:overlay|from|frames)/; // options with results that a page's window cannot show

export function pictureOf(name) {
    const found = pictures.get(name);
    return found && !FIXED.test(found.line) ? found : undefined;
}

// Does this command line draw an interactive figure?
export const isFigure = (line) => /(?:-f|--shader)[ =]chapters\/figures\//.test(line);

// The words of a command as a shell reads them; a comment ends the command.
export function wordsOf(command) {
    const words = [];
    for (const [word] of command.matchAll(/(?:'[^']*'|[^\s'])+/g)) {
        if (word.startsWith('#')) break;
        words.push(word.replaceAll("'", ''));
    }
    return words;
}

// The stem of the chapter that the value of CHAPTER names, found as in .make/chapters.sh.
function stemOf(name) {
    const stem = STEMS.find((stem) => !name || stem === name || stem.startsWith(`${name.padStart(2, '0')}_`));
    if (!stem) throw new Error(`unknown chapter: ${name}`);
    return stem;
}

// The command line for a program whose window is in the page: {line, still}. If the window can show the picture that
// the command would write, no file is written, and the window shows that picture with the time paused.
function lineOf(words) {
    const at = words.findIndex((word) => word === '--output' || word === '-o');
    const still = at >= 0 && !words.some((word) => STILL.some((still) => word === still || word.startsWith(`${still}=`)));
    return {line: words.filter((_, i) => !still || i < at || i > at + 1).join(' '), still};
}

const reasonOf = (command) => REASONS.find(({pattern}) => pattern.test(command))?.reason;

// The stem of the chapter whose program this word names.
const programOf = (word) => STEMS.find((stem) => word === `build/${stem}`);

// The two pictures that `make compare` names, if the same program writes both of them earlier in the block:
// {stem, line, other}.
function pairOf(command, above) {
    const files = /^make compare PICTURES='(\S+) (\S+)'$/.exec(command)?.slice(1) ?? [];
    const lines = above.map((one) => wordsOf(one.replaceAll('\\\n', ' ')));
    const made = files.map((file) => lines.findLast((words) => words[words.indexOf('--output') + 1] === file));
    const stems = made.map((words) => words && !reasonOf(words.join(' ')) && programOf(words[0]));
    if (!stems[0] || stems[0] !== stems[1]) return null;
    const [line, other] = made.map((words) => words.slice(1).join(' '));
    return {stem: stems[0], line, other};
}

// What a command of a page does:
//   {stem, line, still}  it runs the chapter's program with this line, with the time paused if `still`; with `head` or
//                        `tail`, the page shows only that many first or last lines of the output
//   {stem, line, other}  it compares the pictures that these two lines write
//   {check, stem}        it checks an exercise, "03_2", of this chapter
//   {reason}             it has no button, for this reason; in the course for students, a page cannot check exercises
// Throws if the command does none of these, because then commands.txt lacks a line.
//   above  the commands that precede it in its block
export function commandOf(command, above = []) {
    const pair = pairOf(command, above);
    if (pair) return pair;
    const reason = reasonOf(command);
    if (reason) return {reason};
    const cut = /\|\s*(head|tail) -n (\d+)\s*$/.exec(command);
    const words = wordsOf(cut ? command.slice(0, cut.index) : command.replaceAll('\\\n', ' '));
    const [program, ...rest] = words;
    const chapter = programOf(program);
    if (chapter) return {stem: chapter, ...lineOf(rest), ...(cut && {[cut[1]]: cut[2]})};
    if (program === 'make') {
        const values = Object.fromEntries(rest.slice(1).map((word) => /^(\w+)=(.*)$/s.exec(word)?.slice(1) ?? [word, '']));
        if (rest[0] === 'run' && values.FIGURE) return {stem: stemOf(values.FIGURE.slice(0, 2)), line: `--shader chapters/figures/${values.FIGURE}.frag`};
        if (rest[0] === 'run') return {stem: stemOf(values.CHAPTER), ...lineOf((values.OPTIONS ?? '').split(/\s+/).filter(Boolean))};
        if (rest[0] === 'check' && !fs.existsSync('chapters/solutions')) return {reason: 'this command needs the folder of the course, because these pages have no solutions'};
        if (rest[0] === 'check' && values.EXERCISE) return {check: values.EXERCISE, stem: stemOf(values.EXERCISE.slice(0, 2))};
    }
    throw new Error(`docs/web/commands.txt: no line says why this command has no button: ${command}`);
}

// The commands of a block: [{text, command}], where text includes the comments above the command. A command continues
// after a backslash and within quotes or braces.
export function piecesOf(block) {
    const pieces = [];
    let text = '', command = '';
    for (const line of block.split('\n')) {
        text += (text ? '\n' : '') + line;
        if (!command && /^\s*(#|$)/.test(line)) continue;
        command += (command ? '\n' : '') + line;
        const said = command.replace(/(^|\s)#.*$/gm, ''); // an apostrophe in a comment is not a quote
        if (/\\$/.test(line) || (said.match(/'/g) ?? []).length % 2 === 1 || (/\(\) \{/.test(command) && !/\}$/.test(command))) continue;
        pieces.push({text, command});
        text = command = '';
    }
    if (text.trim()) pieces.push({text, command: ''});
    return pieces;
}

// Is this inline code a command, and not only the name of a program?
export function isCommand(code) {
    return /^build\/\d\d_\w+ -/.test(code) || /^make run (CHAPTER=|FIGURE=\d)/.test(code);
}
