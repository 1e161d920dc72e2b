// firefox_hands.mjs - tests an interactive figure of the site in Firefox, in pages 1440 and 390 pixels wide: it starts
// in place, and its points respond to the mouse, a finger and the keys.
import {PATIENCE, check, finish, serve, SITE} from './browser.mjs';
import {Page} from './fox.mjs';

const server = await serve(SITE);

// Wait until a condition is true, or until time runs out. Returns null if no figure runs; otherwise, the values of the
// parameters, the positions of the figure's points on the screen, and how far the page is scrolled.
async function comes(page, right) {
    for (const begun = Date.now(); ;) {
        const now = await page.evaluate(() => {
            const at = document.querySelector('.live-drawn'), state = at?.program?.state();
            if (!state?.runs) return null;
            const {left, top, width, height} = at.querySelector('.live-canvas').getBoundingClientRect();
            return {scroll: scrollY, values: Object.fromEntries(state.parameters.map(({name, value}) => [name, value])),
                handles: Object.fromEntries(state.handles.map((one) => [one.name, {x: left + one.x * width, y: top + one.y * height, focused: one.focused}]))};
        });
        if (now && right(now) || Date.now() - begun > PATIENCE) return now;
        await new Promise((later) => setTimeout(later, 100));
    }
}

for (const [width, height, type] of [[1440, 900, 'mouse'], [390, 844, 'touch']]) {
    const page = await Page.open({width, height});
    await page.goto(`${server.at}/index.html`);
    const begin = await page.evaluate(async () => {
        while (document.querySelector('.quick, .later')) await new Promise(requestAnimationFrame);
        const figure = document.querySelector('.hands');
        figure.scrollIntoView({block: 'center', behavior: 'instant'});
        const {left, top} = figure.querySelector('.live-start').getBoundingClientRect();
        return [Math.round(left + 20), Math.round(top + 12)];
    });
    await page.drag(begin, begin, type);
    let now = await comes(page, ({handles}) => handles.ball);
    check(`${width} pixels: the figure starts in place`, Object.keys(now?.handles ?? {}).join() === 'eye,aim,ball', now);
    const {x, y} = now.handles.ball, scroll = now.scroll, from = [Math.round(x), Math.round(y)];
    await page.drag(from, [from[0] + 10, from[1] + 40], type);
    now = await comes(page, ({handles}) => Math.abs(handles.ball.y - y - 40) < 4);
    check(`${width} pixels: a point follows the ${type}, and the page does not scroll`, Math.abs(now.handles.ball.y - y - 40) < 4 && now.scroll === scroll, y, now);
    const [right] = now.values.ball;
    await page.press('ArrowRight');
    now = await comes(page, ({values}) => values.ball[0] > right);
    check(`${width} pixels: an arrow key moves the point that was dragged`, now.values.ball[0] > right, right, now.values);
    await page.press('Enter');
    await page.press('Enter');
    now = await comes(page, ({handles}) => handles.eye.focused);
    check(`${width} pixels: Enter moves the focus to another point`, now.handles.eye.focused, now.handles);
    check(`${width} pixels: the console reports no error`, page.said.length === 0, page.said);
    await page.close();
}
finish();
server.close();
