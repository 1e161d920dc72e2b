// sheet.js - <figure-sheet>: an interactive figure, drawn from the text of its shader alone. One WebGL context draws all
// figures of a page, each when it comes near the screen, and again only when something has changed. The points that a
// reader drags and the numbers are elements of the page. This is a classic script, so it also runs from file://.
//
// sheets.mjs writes the elements, and a script that sets `sheets`: the colours of the pens and, for each figure, its
// shader, its parameters, the labels of its numbers and its textures.
(() => {
    const NUMBERS = 16, WORDS = 8; // how many labelled numbers a figure may write, and how many floats describe each
    const STEP = 0.02, FAR = 5; // how far an arrow key moves a point of the sheet, and how many times as far with Shift
    const REACH = 30; // from a press of the mouse to the point that it takes, CSS pixels
    const TURN = 0.007; // radians by which a figure in space turns for each CSS pixel of a drag
    const CAMERA = ['iCameraPosition', 'iCameraRight', 'iCameraUp', 'iCameraForward'];
    const VERTEX = '#version 300 es\nvoid main(){gl_Position=vec4(gl_VertexID==1?3.:-1.,gl_VertexID==2?3.:-1.,0,1);}';
    const HEAD = `#version 300 es
precision highp float;precision highp int;precision highp sampler2D;
uniform vec3 iResolution;uniform float iTime;uniform int sheetAsked;uniform vec3 sheetPoints[3];out vec4 sheetOut;
int sheetWanted=-1,sheetCount=0;float sheetTold[8]=float[8](0.,0.,0.,0.,0.,0.,0.,0.);
void tell(int label,vec2 at,float value,int decimals,vec3 colour){if(sheetCount++==sheetWanted)sheetTold=float[8](float(label+1),at.x,at.y,value,float(decimals),colour.r,colour.g,colour.b);}
`;
    // If the page asks, each column of pixels contains the bytes of the floats of a number (1) or a projected point (2);
    // WebGL reads bytes on every machine, but floats only on some. Some shaders write numbers only at the top left.
    const tail = (projects) => `
void main(){sheetWanted=sheetAsked==1?int(gl_FragCoord.x):-1;mainImage(sheetOut,sheetAsked>0?iResolution.xy*vec2(.05,.95):gl_FragCoord.xy);
${projects ? 'if(sheetAsked==2){vec4 found=projectedPixel(sheetPoints[int(gl_FragCoord.x)]);sheetTold[0]=found.z;sheetTold[1]=found.x;sheetTold[2]=found.y;}' : ''}
if(sheetAsked>0){uint word=floatBitsToUint(sheetTold[int(gl_FragCoord.y)]);sheetOut=vec4(word&255u,word>>8&255u,word>>16&255u,word>>24)/255.;}}`;
    const calm = matchMedia('(prefers-reduced-motion: reduce)'), night = matchMedia('(prefers-color-scheme: dark)');
    const {colours, ...figures} = window.sheets;

    const mark = (element, attributes) => { for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value); };

    // ---- The one context ----

    let pen = null; // null before the first figure is drawn, false if this browser cannot draw

    function begin() {
        const canvas = document.createElement('canvas'), gl = canvas.getContext('webgl2', {antialias: false, depth: false, powerPreference: 'low-power'});
        pen = gl ? {canvas, gl, sheets: new Set()} : false;
        if (!gl) return;
        prepare();
        canvas.addEventListener('webglcontextlost', (event) => event.preventDefault()); // the figures keep their last pictures
        canvas.addEventListener('webglcontextrestored', () => {
            prepare();
            for (const sheet of pen.sheets) {
                sheet.program = null;
                sheet.ask();
            }
        });
    }

    // Create what all figures share, also after the context was lost.
    function prepare() {
        const {gl} = pen, bytes = gl.createRenderbuffer();
        Object.assign(pen, {parallel: gl.getExtension('KHR_parallel_shader_compile'), vertex: shaderOf(gl.VERTEX_SHADER, VERTEX), textures: new Map(), digits: null, cell: 0, answers: gl.createFramebuffer()});
        gl.bindRenderbuffer(gl.RENDERBUFFER, bytes);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, NUMBERS, WORDS);
        gl.bindFramebuffer(gl.FRAMEBUFFER, pen.answers);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, bytes);
        gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
        gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    }

    function shaderOf(kind, text) {
        const {gl} = pen, shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        return shader;
    }

    // ---- Turns ----

    const waiting = new Set(); // the figures to draw in the next frame of the page
    let frame = 0;

    // Draw what has changed. In one frame only one figure is compiled, because a driver may need a tenth of a second.
    function turn(now) {
        frame = 0;
        let compiled = false;
        for (const sheet of [...waiting]) {
            const isNew = pen && !sheet.program;
            if (isNew && compiled) continue;
            compiled ||= isNew;
            waiting.delete(sheet);
            sheet.draw(now);
        }
        if (waiting.size > 0) frame ||= requestAnimationFrame(turn);
        window.sheetParts?.rest?.();
    }

    // ---- Colours ----

    // Each pen has a colour for a light page and one for a dark page.
    const isDark = () => { const {colorScheme} = getComputedStyle(document.documentElement); return colorScheme === 'dark' || (colorScheme !== 'light' && night.matches); };
    const pens = () => `const vec3 ${Object.entries(colours).map(([name, pair]) => `${name}=vec3(${pair[Number(isDark())]})`).join()};`;
    let wasDark = isDark();
    function recolour() {
        if (wasDark === isDark()) return; // site.js names the theme after the first figures are drawn
        wasDark = isDark();
        for (const sheet of pen?.sheets ?? []) {
            sheet.forget();
            sheet.ask();
        }
    }
    new MutationObserver(recolour).observe(document.documentElement, {attributes: true, attributeFilter: ['data-theme']});
    night.addEventListener('change', recolour);

    // ---- Values ----

    // The position of a value on its slider, from 0 to 1, and the value at a position.
    const placeOf = ({minimum, maximum, multiplies}, value) => multiplies ? Math.log(value / minimum) / Math.log(maximum / minimum) : (value - minimum) / (maximum - minimum);
    const valueAt = ({minimum, maximum, multiplies}, at) => multiplies ? minimum * (maximum / minimum) ** at : minimum + at * (maximum - minimum);
    const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
    const written = (value, decimals) => (decimals === undefined ? String(Number(value.toPrecision(3))) : (Math.floor(value * 10 ** decimals + 0.5) / 10 ** decimals).toFixed(decimals)).replace('-', '−');

    class Sheet extends HTMLElement {
        connectedCallback() {
            if (this.parameters) return; // the element was only moved
            const {shader, parameters = [], labels = [], textures, axes, own} = figures[this.getAttribute('name')];
            const given = new Map((this.getAttribute('values') ?? '').split(' ').map((one) => one.split('=')));
            this.parameters = parameters.map((one) => {
                const start = given.get(one.name)?.split(',').map((x) => x === 'true' ? 1 : Number(x) || 0) ?? one.value;
                return {...one, start, value: [...start]};
            });
            this.screen = this.querySelector('.sheet-screen');
            const img = this.querySelector('img');
            this.aspect = img.getAttribute('width') / img.getAttribute('height');
            this.canvas = document.createElement('canvas');
            mark(this.canvas, {role: 'img', 'aria-label': img.alt});
            img.after(this.canvas);
            img.draggable = false;
            Object.assign(this, {shader, labels, textures, axes, projects: Boolean(axes), own, numbers: [], said: '', time: Number(this.getAttribute('time'))});
            if (this.hasAttribute('camera')) window.sheetParts.stand(this);
            this.knobs = [...this.querySelectorAll('.sheet-point')];
            for (const knob of this.knobs) this.wake(knob);
            for (const [name, act] of [['down', 'take'], ['move', 'drag'], ['up', 'release'], ['cancel', 'release']]) this.screen.addEventListener(`pointer${name}`, (event) => this[act](event));
            this.inputs = [...this.querySelectorAll('input')];
            for (const input of this.inputs) input.addEventListener('input', () => this.turn(input));
            for (const button of this.querySelectorAll('.sheet-reset, .sheet-edit')) button.setAttribute('aria-label', `${button.textContent} figure ${this.getAttribute('name')}`);
            this.querySelector('.sheet-reset').addEventListener('click', () => {
                for (const one of this.parameters) one.value = [...one.start];
                if (this.camera) window.sheetParts.turn(this, 0, 0);
                this.ask();
            });
            this.play = this.querySelector('.sheet-play');
            this.runs = this.play && !calm.matches;
            this.play?.addEventListener('click', () => { this.runs = !this.runs; this.ask(); });
            this.showInputs();
            new ResizeObserver(() => this.ask()).observe(this.screen);
            const watch = (name, rootMargin) => new IntersectionObserver(([{isIntersecting}]) => { this[name] = isIntersecting; this.ask(); }, {rootMargin}).observe(this.screen);
            watch('near', '50% 0px');
            if (this.play) watch('seen', '0px');
        }

        parameter(name) { return this.parameters?.find((one) => one.name === name); }

        // Set a component of a parameter, within its range.
        set(name, value, component = 0) {
            const one = this.parameter(name), {type, minimum, maximum} = one;
            one.value = one.value.map((old, i) => i === Number(component) ? clamp(type === 'int' || type === 'bool' ? Math.round(value) : value, minimum, maximum) : old);
            this.ask();
        }

        // The options that give a program the values which the reader has changed.
        get settings() {
            return this.parameters.filter(({value, start}) => String(value) !== String(start))
                .map(({name, type, value}) => ` --set ${name}=${type === 'bool' ? Boolean(value[0]) : value.map((x) => Number(x.toPrecision(6)))}`).join('') + (this.camera ? window.sheetParts.cameraOf(this) : '');
        }

        // ---- Points ----

        // A point is a slider with two directions, because screen readers give such an element the arrow keys, and read
        // its new value.
        wake(knob) {
            const one = knob.parameter = this.parameter(knob.dataset.name), inSpace = one.type === 'vec3';
            mark(knob, {tabindex: 0, role: 'slider', 'aria-roledescription': 'point', 'aria-label': `${one.name}, ${one.meaning}`,
                'aria-description': `The arrow keys move the point, ${inSpace ? 'Page Up and Page Down move it away and nearer, all of them ' : ''}with Shift further. Escape puts it back.`});
            knob.addEventListener('keydown', (event) => {
                const way = {ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0], PageUp: inSpace && [0, 0, 1], PageDown: inSpace && [0, 0, -1], Escape: [0, 0, 0]}[event.key];
                if (!way || event.ctrlKey || event.altKey || event.metaKey) return;
                event.preventDefault();
                const by = (inSpace ? one.step : STEP) * (event.shiftKey ? FAR : 1), along = inSpace ? one.value.map((_, i) => way.reduce((sum, x, k) => sum + x * this.axes[k][i], 0)) : way;
                this.move(one, event.key === 'Escape' ? one.start : one.value.map((x, i) => x + by * along[i]));
            });
            this.show(knob);
        }

        // Take the point that is nearest to a press and within reach. A finger has to press the element of a point,
        // because a swipe beside it scrolls the page.
        take(event) {
            if (!this.drawn || this.held || event.button !== 0 || (event.pointerType !== 'mouse' && !event.target.closest('.sheet-point') && !this.camera)) return;
            const far = (knob) => { const {left, top, width, height} = knob.getBoundingClientRect(); return width > 0 ? Math.hypot(left + width / 2 - event.clientX, top + height / 2 - event.clientY) : Infinity; };
            const knob = this.knobs.reduce((best, one) => !best || far(one) < far(best) ? one : best, null);
            if (!knob || far(knob) > REACH) {
                if (this.camera) this.hold(event, this.turned);
                if (this.camera && event.pointerType === 'mouse') event.preventDefault();
                return;
            }
            event.preventDefault(); // otherwise the browser would select text
            knob.focus({preventScroll: true});
            knob.classList.add('held');
            this.hold(event, knob.place ?? knob.parameter.value, knob);
        }
        hold({pointerId, clientX, clientY}, from, knob) {
            this.screen.setPointerCapture(pointerId);
            this.held = {knob, id: pointerId, from, x: clientX, y: clientY};
        }
        drag({pointerId, clientX, clientY}) {
            const {held} = this, unit = this.screen.clientHeight / 2;
            if (pointerId !== held?.id) return;
            if (!held.knob) return window.sheetParts.turn(this, held.from[0] - (clientX - held.x) * TURN, held.from[1] + (clientY - held.y) * TURN);
            const one = held.knob.parameter, to = [held.from[0] + (clientX - held.x) / unit, held.from[1] - (clientY - held.y) / unit];
            if (one.type === 'vec3') this.aim = {one, to};
            else this.move(one, to);
            this.ask();
        }
        release({pointerId}) {
            if (pointerId !== this.held?.id) return;
            this.held.knob?.classList.remove('held');
            this.held = null;
        }

        // Move a point, with as many decimals as in the program. A point of the sheet stays in the picture.
        move(one, to) {
            const edge = one.type === 'vec2' ? [this.aspect, 1] : [Infinity, Infinity, Infinity];
            one.value = to.map((x, i) => Math.round(1e3 * clamp(x, Math.max(one.minimum, -edge[i]), Math.min(one.maximum, edge[i]))) / 1e3);
            this.ask();
        }

        // Light the point of this name, or stop lighting it.
        light(name, on) { this.knobs.find((knob) => knob.dataset.name === name)?.classList.toggle('lit', on); }

        // ---- Sliders and buttons ----

        turn(input) {
            const one = this.parameter(input.dataset.name);
            this.set(one.name, one.type === 'bool' ? input.checked : valueAt(one, input.value / input.max), input.dataset.component);
        }
        showInputs() {
            for (const input of this.inputs) {
                const one = this.parameter(input.dataset.name), value = one.value[input.dataset.component];
                if (one.type === 'bool') input.checked = value;
                else {
                    input.value = placeOf(one, value) * input.max;
                    mark(input, {'aria-valuetext': `${written(value)} ${one.unit}`});
                    input.nextElementSibling.textContent = written(value);
                }
            }
            if (this.play) this.play.textContent = this.runs ? 'Pause' : 'Play';
        }

        // ---- Drawing ----

        ask() {
            waiting.add(this);
            frame ||= requestAnimationFrame(turn);
        }

        forget() {
            pen.gl.deleteProgram(this.program);
            this.program = null;
        }

        compile() {
            const {gl} = pen;
            pen.sheets.add(this);
            this.places = null;
            this.ready = false;
            this.program = gl.createProgram();
            this.fragment = shaderOf(gl.FRAGMENT_SHADER, HEAD + (this.own ? '' : pens()) + this.shader + tail(this.projects));
            gl.attachShader(this.program, pen.vertex);
            gl.attachShader(this.program, this.fragment);
            gl.linkProgram(this.program);
        }

        // Is the program compiled? A driver with threads of its own is asked again in the next frame.
        isReady() {
            const {gl, parallel} = pen;
            if (this.places) return true;
            if (parallel && !gl.getProgramParameter(this.program, parallel.COMPLETION_STATUS_KHR)) {
                this.ask();
                return false;
            }
            if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) {
                console.error(`${this.getAttribute('name')}: ${gl.getShaderInfoLog(this.fragment)}`);
                this.ready = true; // nothing more can be done
                return false;
            }
            gl.deleteShader(this.fragment);
            const names = ['iResolution', 'iTime', 'iSigns', 'sheetAsked', 'sheetPoints', ...CAMERA, ...[...this.parameters, ...this.textures ?? []].map(({name}) => name)];
            this.places = Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(this.program, name)]));
            return true;
        }

        // The context that draws all figures; false if there is none, or the browser has taken it away.
        get pen() {
            if (pen === null) begin();
            return pen && !pen.gl.isContextLost() && pen;
        }

        draw(now) {
            const {screen, canvas} = this;
            if (!this.near || screen.clientWidth < 1) return;
            if (!this.pen) return this.classList.toggle('still', !pen);
            if (!this.program) this.compile();
            if (!this.isReady()) return;
            const ratio = Math.min(devicePixelRatio, 2), width = Math.round(screen.clientWidth * ratio), height = Math.round(screen.clientHeight * ratio);
            if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
            if (!this.give(width, height, ratio, this.pass(now))) return;
            if (this.projects) window.sheetParts.follow(pen, this);
            if (this.labels.length > 0) this.showNumbers(this.asked(1, NUMBERS));
            this.paint(width, height);
            for (const knob of this.knobs) this.show(knob);
            this.showInputs();
            this.ready = this.drawn = true;
            this.classList.add('drawn');
        }

        // Give the program all that it reads. Returns false if a texture has not arrived yet.
        give(width, height, ratio, time) {
            const {gl} = pen, parts = window.sheetParts;
            gl.useProgram(this.program);
            gl.uniform3f(this.places.iResolution, width, height, 1);
            gl.uniform1f(this.places.iTime, time);
            if (this.textures && !parts.bindTextures(pen, this)) return false;
            if (this.places.iSigns) parts.bindDigits(pen, Math.round(Math.max(height / 180, 1.6 * ratio)));
            this.sendValues();
            return true;
        }

        // The time of a moving figure, which passes only while the figure is seen.
        pass(now) {
            const runs = this.runs && this.seen;
            if (runs && this.before) this.time += Math.min((now - this.before) / 1e3, 0.1);
            this.before = runs && now;
            if (runs) this.ask();
            return this.time;
        }

        sendValues() {
            const {gl} = pen;
            for (const {name, type, value} of this.parameters) {
                if (type === 'int' || type === 'bool') gl.uniform1iv(this.places[name], value);
                else gl[`uniform${value.length}fv`](this.places[name], value);
            }
            this.camera?.forEach((one, i) => gl.uniform3fv(this.places[CAMERA[i]], one));
        }

        paint(width, height) {
            const {gl, canvas} = pen;
            if (canvas.width < width || canvas.height < height) Object.assign(canvas, {width: Math.max(canvas.width, width), height: Math.max(canvas.height, height)});
            gl.bindFramebuffer(gl.FRAMEBUFFER, null);
            gl.uniform1i(this.places.sheetAsked, 0);
            gl.viewport(0, 0, width, height);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
            this.context ??= this.canvas.getContext('2d', {alpha: false});
            this.context.drawImage(canvas, 0, canvas.height - height, width, height, 0, 0, width, height);
        }

        // Ask the shader for numbers (1) or for points (2). Returns the floats of each answer.
        asked(what, count) {
            const {gl} = pen, bytes = new Uint8Array(4 * count * WORDS);
            gl.bindFramebuffer(gl.FRAMEBUFFER, pen.answers);
            gl.uniform1i(this.places.sheetAsked, what);
            gl.viewport(0, 0, count, WORDS);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
            gl.readPixels(0, 0, count, WORDS, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            const floats = new Float32Array(bytes.buffer); // every machine with a browser stores the lowest byte first
            return Array.from({length: count}, (_, i) => Array.from({length: WORDS}, (_, k) => floats[k * count + i]));
        }

        // Show the numbers that the shader writes, with their labels, where it writes them.
        showNumbers(told) {
            const shown = told.filter(([label]) => label > 0), {clientWidth, clientHeight} = this.screen;
            while (this.numbers.length < shown.length) {
                const span = Object.assign(document.createElement('span'), {className: 'sheet-number'});
                this.numbers.push(span);
                this.screen.append(span);
            }
            const paper = colours.PAPER[Number(isDark())].split(',');
            this.numbers.forEach((span, i) => {
                const one = shown[i];
                span.hidden = !one;
                if (!one) return;
                const [label, x, y, value, decimals, ...colour] = one, unit = clientHeight / 2;
                const text = written(value, decimals), [seen, read] = this.labels[label - 1].split('|').map((part) => part.trim().replace('#', text).replace('(s)', text === '1' ? '' : 's'));
                span.textContent = seen;
                span.said = read ?? seen;
                // Numbers with words, one below the other at the left or right, are aligned there. The others are centred.
                const half = span.offsetWidth / 2, aside = Math.abs(x) > 1.1 && seen !== text && Math.sign(x), at = clientWidth / 2 + (x + 0.13 * aside) * unit - half * aside;
                span.classList.toggle('bare', Math.hypot(...colour.map((part, k) => part - paper[k])) < 0.65); // on a part of the picture unlike the paper
                span.style.color = `rgb(${colour.map((part) => Math.round(255 * part))})`;
                span.style.transform = `translate(${clamp(at, half + 3, clientWidth - half - 3)}px, ${(1 - y) * unit}px) translate(-50%, -50%)`;
            });
            this.said = this.numbers.filter(({hidden, said}) => !hidden && said).map(({said}) => `; ${said}`).join('');
        }

        show(knob) {
            const one = knob.parameter, {clientHeight} = this.screen, {aspect} = this, [to, from] = one.type === 'vec3' ? [knob.place ?? [0, 0], [0, 0]] : [one.value, one.start];
            knob.style.transform = `translate(${[0, 1].map((i) => `${(to[i] - from[i]) * (i ? -1 : 1) * clientHeight / 2}px`)})`; // a change of left and top would count as a layout shift
            mark(knob, {'aria-valuemin': Math.max(one.minimum, -aspect).toFixed(2), 'aria-valuemax': Math.min(one.maximum, aspect).toFixed(2), 'aria-valuenow': one.value[0],
                'aria-valuetext': one.value.map((v, i) => `${'xyz'[i]} ${written(v, 2)}`).join(', ') + this.said});
        }
    }
    customElements.define('figure-sheet', Sheet);
})();
