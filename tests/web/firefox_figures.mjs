// firefox_figures.mjs [PATTERN] - tests every interactive figure in Firefox, in pages 1440 pixels wide with the mouse and
// 390 pixels wide with a finger (each_figure.mjs).
import {check, finish, serve, SITE} from './browser.mjs';
import {pagesWith, testFigures} from './each_figure.mjs';
import {Page} from './fox.mjs';

const server = await serve(SITE);
for (const [width, height] of [[1440, 900], [390, 844]]) {
    const page = await Page.open({width, height});
    for (const name of pagesWith(process.argv[2])) {
        await page.goto(`${server.at}/${name}`);
        await page.evaluate(async () => { while (document.querySelector('.quick, .later')) await new Promise(requestAnimationFrame); });
        const driver = {
            evaluate: (...all) => page.evaluate(...all),
            drag: (from, to, touch) => page.drag(from.map(Math.round), to.map(Math.round), touch ? 'touch' : 'mouse'),
            scrolls: false, // this Firefox scrolls for real fingers only
            key: (name) => page.press(name),
        };
        await testFigures(driver, name, `${width} pixels`, width === 390);
        check(`${width} pixels: ${name}: the console reports no error`, page.said.length === 0, page.said.splice(0));
    }
    await page.close();
}
finish();
server.close();
