// questions.mjs - turns the exit questions of a chapter (docs/questions.txt) into the last section of its page. Without
// scripts, the comments on the answers can be unfolded; question.js shows the comment on the chosen answer.
import fs from 'node:fs';
import {escaped} from './colour.mjs';

const FILE = 'docs/questions.txt';
const all = fs.existsSync(FILE) ? fs.readFileSync(FILE, 'utf8').split(/^## /m).slice(1) : []; // the course for students has none

function questionOf(block) {
    const [head, ...lines] = block.trim().split('\n');
    const answers = lines.filter((line) => /^[+-] /.test(line)).map((line) => line.slice(2).split(' // '));
    const choice = ([answer], i) => `<label><input type="radio" name="answer" value="${i}"> ${escaped(answer)}</label>`;
    return `<form class="question"><fieldset><legend>${escaped(head.replace(/^\S+ /, ''))}</legend>${answers.map(choice).join('')}</fieldset><output></output>`
        + `<details><summary>Answers</summary><ol>${answers.map(([, why]) => `<li>${escaped(why ?? 'That is right.')}</li>`).join('')}</ol></details></form>`;
}

// The exit questions of a chapter as HTML; '' if the chapter has none.
export function questionsOf(stem) {
    const own = all.filter((block) => block.startsWith(`${stem.slice(0, 2)}.`));
    return own.length === 0 ? '' : `\n<h2 id="exit-questions">Questions</h2>\n<p>Choose an answer to see whether it is right and, if not, why.</p>\n${own.map(questionOf).join('\n')}`;
}
