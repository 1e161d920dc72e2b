// speed.mjs - compares the cost of a frame in a browser with that in the native program, in processor time, which other
// programs hardly affect. It also prints, but does not judge, how long a reader waits for the first picture of a program
// and, on a slow network, for that of a figure.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import {blankPage, check, finish, launch, loadProgram, openPage, processors, serve, SITE, WEB, whole} from './browser.mjs';
import {pagesWith} from './each_figure.mjs';

const server = await serve(WEB), browser = await launch();
const {page} = await openPage(browser, server.at);
const bench = (frames) => page.evaluate((frames) => window.program.start('03_shadows', `--benchmark ${frames}`), frames);
const own = () => Number(/frame, median +([0-9.]+)/.exec(execFileSync('build/03_shadows', ['--benchmark', '40'], {encoding: 'utf8', env: {...process.env, LIBGL_ALWAYS_SOFTWARE: '1'}}))[1]);

// ---- A frame ----

// The work that a benchmark does in addition to its frames is the same in both runs, so it cancels in their difference.
// The processor's speed changes while other programs run, so the measurements alternate, in three rounds.
const FEW = 5, MANY = 85;
await bench(FEW);
let here = 0, there = 0;
for (let round = 0; round < 3; round++) {
    const begun = processors();
    await bench(FEW);
    const between = processors();
    await bench(MANY);
    here += (processors() - between - (between - begun)) / (3 * (MANY - FEW));
    there += own() / 3000;
}
const ratio = here / there;
console.log(`# a frame of 03_shadows, 640x360: ${(1000 * here).toFixed(1)} ms of processor time in the browser, ${(1000 * there).toFixed(1)} ms in the native program; ratio ${ratio.toFixed(2)}`);
check('a frame takes at most 1.5 times as much processor time as in the native program', ratio <= 1.5, ratio);

// ---- The first picture ----

const waits = [];
for (let i = 0; i < 5; i++) {
    const fresh = await blankPage(browser);
    await fresh.page.goto(`${server.at}/test.html`);
    waits.push(await fresh.page.evaluate(`(async () => {
        const begun = performance.now();
        await (${loadProgram})();
        await window.program.start('03_shadows', '');
        while (window.calls.blitFramebuffer + window.calls.drawArrays === 0) await new Promise(requestAnimationFrame);
        return performance.now() - begun;
    })()`));
    await fresh.page.close();
}
waits.sort((a, b) => a - b);
console.log(`# from a click to the first picture of 03_shadows: ${waits.map((x) => x.toFixed(0)).join(', ')} ms (target: at most 500, not judged); load average ${fs.readFileSync('/proc/loadavg', 'utf8').split(' ')[0]}`);
check('the first picture is drawn', waits.every((x) => x > 0));

// ---- The figures on a slow network ----

const site = await serve(SITE), drawn = [], asked = [];
for (const name of pagesWith()) {
    const {page: slow} = await blankPage(browser, {context: {viewport: {width: 1440, height: 900}}});
    const network = await slow.context().newCDPSession(slow);
    await network.send('Network.enable');
    await network.send('Network.emulateNetworkConditions', {offline: false, latency: 300, downloadThroughput: 50e3, uploadThroughput: 50e3}); // 400 kbit/s
    await slow.goto(`${site.at}/${name}`);
    await whole(slow);
    await slow.waitForLoadState('networkidle');
    slow.on('request', (request) => { if (request.resourceType() !== 'image') asked.push(request.url()); });
    drawn.push(...await slow.evaluate(async () => {
        const waits = [];
        for (const sheet of document.querySelectorAll('figure-sheet:not(.drawn)')) {
            for (let fold = sheet; (fold = fold.parentElement.closest('details'));) fold.open = true;
            const begun = performance.now();
            sheet.scrollIntoView({block: 'center', behavior: 'instant'});
            while (!sheet.matches('.drawn')) await new Promise(requestAnimationFrame);
            waits.push(performance.now() - begun);
        }
        return waits;
    }));
    await slow.close();
}
drawn.sort((a, b) => a - b);
console.log(`# at 400 kbit/s, from the moment when one of ${drawn.length} figures is seen until it is drawn: median ${drawn[drawn.length >> 1].toFixed(0)} ms, at most ${drawn.at(-1).toFixed(0)} ms (target: at most 250, not judged); load average ${fs.readFileSync('/proc/loadavg', 'utf8').split(' ')[0]}`);
check('once its page is loaded, no figure waits for the network', drawn.length > 60 && asked.length === 0, drawn.length, asked);

finish();
site.close();
await browser.close();
server.close();
