// sheet_rest.js - while the page rests, gets the figures ready that are not near the screen yet: their textures are
// fetched and their shaders compiled, so that a reader who scrolls to a figure need not wait for the driver. site.js
// loads this script after the page.
(() => {
    const QUIET = 200; // milliseconds after the last thing that the reader did, after which the page rests
    const POLL = 50; // milliseconds between two looks at the driver in a browser without requestIdleCallback
    const FEW = 2; // how many figures are prepared ahead for a reader who has asked to save data, or whose telephone has little memory
    const LITTLE = 4; // gigabytes
    const SIZE = [640, 360]; // of a figure in a closed fold

    const isSparing = () => navigator.connection?.saveData === true || (matchMedia('(pointer: coarse)').matches && navigator.deviceMemory <= LITTLE);

    // ---- What the reader does ----

    let acted = -Infinity, pressed = false, fingers = 0;
    for (const type of ['pointerdown', 'pointerup', 'pointercancel', 'touchstart', 'touchend', 'touchcancel', 'scroll', 'wheel', 'keydown']) {
        addEventListener(type, (event) => {
            acted = performance.now();
            if (event.touches) fingers = event.touches.length;
            if (type.startsWith('pointer')) pressed = type === 'pointerdown';
        }, {capture: true, passive: true});
    }

    // Is a figure compiled, but a texture still on its way? The figure is asked to draw when the texture has arrived.
    const lacksTextures = ({pen: {textures}, places, textures: needed = []}) => places && needed.some(({file}) => !textures.get(file)?.texture);

    // A figure near the screen is drawn without this script, and comes first, as does a program that is about to start.
    const isDone = ({program, ready}) => program && ready;
    const isBusy = (sheets) => pressed || fingers > 0 || performance.now() - acted < QUIET || document.hidden
        || Boolean(document.querySelector('[aria-busy=true]')) || sheets.some((one) => one.near && one.screen.clientWidth > 0 && !isDone(one) && !lacksTextures(one));

    // ---- Which figure is next ----

    // The top of a figure, or of the outermost closed fold in which it is.
    function topOf(sheet) {
        let seen = sheet;
        for (let fold = sheet; (fold = fold.parentElement.closest('details'));) if (!fold.open) seen = fold;
        return seen.getBoundingClientRect().top;
    }

    // The nearest figure below the screen that is not ready, otherwise the nearest one above.
    function next(sheets) {
        if (!sheets.some((one) => !isDone(one)) || !sheets[0].pen) return undefined;
        const all = sheets.filter(({near}) => !near).map((sheet) => ({sheet, top: topOf(sheet)}));
        const below = all.filter(({top}) => top > 0).sort((a, b) => a.top - b.top), above = all.filter(({top}) => top <= 0).sort((a, b) => b.top - a.top);
        return (isSparing() ? below.slice(0, FEW) : [...below, ...above]).map(({sheet}) => sheet).find((one) => !isDone(one) && !lacksTextures(one));
    }

    // ---- Preparation ----

    const pause = (time) => new Promise((done) => setTimeout(done, time));
    const idle = () => window.requestIdleCallback ? new Promise((done) => requestIdleCallback(done)) : pause(POLL);

    // Wait until the driver has done what it was given, without blocking the page.
    async function driver(gl) {
        const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        do await idle(); while (!gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED);
        gl.deleteSync(fence);
    }

    // Compile a figure and draw one of its pixels, which nobody sees, because many drivers finish a program only when it
    // draws. If the figure comes near the screen meanwhile, it is drawn as it would be without this script.
    async function prepare(sheet) {
        const {gl, parallel, answers} = sheet.pen;
        if (!sheet.program) {
            sheet.compile();
            const {program} = sheet;
            if (parallel) while (sheet.program === program && !gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR)) await idle();
            else await driver(gl);
        }
        const {program, screen} = sheet, ratio = Math.min(devicePixelRatio, 2), size = screen.clientWidth > 0 ? [screen.clientWidth, screen.clientHeight] : SIZE;
        if (!program || sheet.ready || !sheet.pen || !sheet.isReady() || !sheet.give(...size.map((one) => Math.round(one * ratio)), ratio, sheet.time)) return;
        gl.uniform1i(sheet.places.sheetAsked, 0);
        gl.viewport(0, 0, 1, 1);
        for (const target of [answers, null]) {
            gl.bindFramebuffer(gl.FRAMEBUFFER, target);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
        }
        await driver(gl);
        if (sheet.program === program) sheet.ready = true;
    }

    let isActive = false;

    // Prepare one figure after the other, until all are ready. sheet.js calls this after each turn.
    async function rest() {
        if (isActive) return;
        isActive = true;
        const sheets = [...document.querySelectorAll('figure-sheet')].filter(({parameters}) => parameters);
        for (let sheet; (sheet = next(sheets));) {
            await idle();
            if (isBusy(sheets)) await pause(QUIET);
            else if ((sheet = next(sheets))) await prepare(sheet); // another one may be nearer now
        }
        isActive = false;
    }

    window.sheetParts = {...window.sheetParts, rest};
    if (!isSparing()) for (const {textures = []} of Object.values(window.sheets)) for (const {file} of textures) window.sheetParts.load(file);
    rest();
})();
