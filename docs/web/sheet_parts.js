// sheet_parts.js - what only some pages with interactive figures need: digits in the picture, textures, and words that light
// a point. Such a page loads this script before sheet.js.
window.sheetParts = {
    ...window.sheetParts,

    // Bind the digits that a shader writes itself, in the cells of shaders/signs.glsl and the font of the page.
    bindDigits(pen, cell) {
        const {gl} = pen;
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, pen.digits ??= gl.createTexture());
        if (pen.cell === cell) return;
        const canvas = Object.assign(document.createElement('canvas'), {width: 48 * cell, height: 8 * cell}), context = canvas.getContext('2d');
        context.font = `${7.1 * cell}px ${getComputedStyle(document.body).fontFamily}`;
        context.fillRect(0, 0, canvas.width, canvas.height);
        context.fillStyle = '#fff';
        context.textAlign = 'center';
        [...'0123456789.−'].forEach((sign, i) => context.fillText(sign, cell * (i < 10 ? 4 * i + 2 : i === 10 ? 41 : 46), 6 * cell));
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        pen.cell = cell;
    },

    // The files of the textures that have arrived, as data. Each is a script, because a page that is opened as a file may
    // not read the pixels of another file.
    textures: {},

    // Load the file of a texture once: when its figure comes near the screen, or before (sheet_rest.js). Returns a promise.
    load(file) {
        return this.scripts[file] ??= new Promise((done) => {
            if (this.textures[file]) done();
            else document.head.append(Object.assign(document.createElement('script'), {src: file, onload: done}));
        });
    },
    scripts: {},

    // Bind the textures of a figure, with the filter and the edges of common/picture/texture.c. Returns false if one has
    // not arrived yet; the figure is then drawn again when it has.
    bindTextures(pen, sheet) {
        const {gl, textures} = pen;
        return sheet.textures.map(({name, file, srgb, repeat}, i) => {
            let one = textures.get(file);
            if (!one) {
                const image = new Image();
                textures.set(file, one = {waiting: new Set()});
                image.onload = () => {
                    if (textures !== pen.textures) return; // the context was lost
                    one.texture = gl.createTexture();
                    gl.bindTexture(gl.TEXTURE_2D, one.texture);
                    gl.texImage2D(gl.TEXTURE_2D, 0, srgb ? gl.SRGB8_ALPHA8 : gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
                    gl.generateMipmap(gl.TEXTURE_2D);
                    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
                    for (const axis of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, axis, repeat ? gl.REPEAT : gl.CLAMP_TO_EDGE);
                    for (const each of one.waiting) each.ask();
                };
                this.load(file).then(() => { image.src = this.textures[file]; });
            }
            if (!one.texture) {
                one.waiting.add(sheet);
                return false;
            }
            gl.activeTexture(gl.TEXTURE1 + i);
            gl.bindTexture(gl.TEXTURE_2D, one.texture);
            gl.uniform1i(sheet.places[name], 1 + i);
            return true;
        }).every(Boolean);
    },
};

// ---- Words ----

// A word in a sentence lights a point of the nearest figure that has it, or sets one of the figure's parameters.
for (const word of document.querySelectorAll('.sheet-word')) {
    const {name, value} = word.dataset, middle = (one) => { const {top, bottom} = one.getBoundingClientRect(); return (top + bottom) / 2; }, far = (one) => Math.abs(middle(one) - middle(word));
    const sheet = () => [...document.querySelectorAll('figure-sheet')].filter((one) => one.parameter(name) && one.checkVisibility()).sort((a, b) => far(a) - far(b))[0];
    if (value === undefined) for (const event of ['pointerenter', 'pointerleave', 'focus', 'blur']) word.addEventListener(event, () => sheet()?.light(name, word.matches(':hover, :focus')));
    word.addEventListener('click', () => {
        const at = sheet();
        at?.screen.scrollIntoView({block: 'nearest', behavior: matchMedia('(prefers-reduced-motion: reduce)').matches ? 'instant' : 'smooth'});
        if (value === undefined) word.focus({preventScroll: true}); // some browsers focus no button that is pressed
        else value.split(',').forEach((part, i) => at?.set(name, part === 'true' ? 1 : Number(part) || 0, i));
    });
}
