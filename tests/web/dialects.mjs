// dialects.mjs - tests the small shaders of tests/shaders/dialects.txt in a browser: each must be drawn or refused,
// with the colour or the message that its heading gives.
import fs from 'node:fs';
import {check, finish, launch, openPage, serve, WEB} from './browser.mjs';

const server = await serve(WEB), browser = await launch();
const {page} = await openPage(browser, server.at);
const cases = fs.readFileSync('tests/shaders/dialects.txt', 'utf8').split(/^=== /m).slice(1)
    .map((text) => ({...text.match(/^(?<name>[^ ]*)(?<kind>[:!?]) ?(?<right>.*)\n(?<shader>[^]*)$/).groups}))
    .filter(({name}) => !name.startsWith('native_') && name.includes(process.argv[2] ?? ''));
for (const {name, kind, right, shader} of cases) {
    const {status, lines} = await page.evaluate(async ([name, shader]) => {
        window.lines.length = 0;
        window.program.write(`chapters/${name}`, shader);
        const status = await window.program.start('01_normal_colouring', `--shader chapters/${name} --size 48x27 --time 0.25 --probe 24,13`);
        return {status, lines: [...window.lines]};
    }, [name, shader]);
    const said = lines.join('\n'), colour = said.match(/colour: (\d+), (\d+), (\d+)/)?.slice(1);
    const near = colour?.length === 3 && right.split(' ! ')[0].split(',').every((c, i) => Math.abs(c - colour[i]) <= 1);
    if (kind === ':') check(`${name} is drawn`, status === 0 && near, status, said);
    else if (kind === '!') check(`${name} is refused`, status === 1 && said.includes(right), status, said);
    else check(`${name} is drawn, with the expected message`, status === 0 && said.includes(right), status, said);
}
finish();
await browser.close();
server.close();
