// sheet_space.js - what figures in space need: views that a reader turns, and points in space. A page with such figures
// loads this script before sheet.js.
window.sheetParts = {
    ...window.sheetParts,

    // ---- Figures that a reader turns ----

    // Begin with the camera of the picture, which turns around the point of its axis that is nearest the origin.
    stand(sheet) {
        const numbers = (text) => text.split(',').map(Number), [eye, ...axes] = sheet.getAttribute('camera').split(' ').map(numbers), forward = axes[2];
        const away = Number(sheet.getAttribute('away')) || Math.max(-eye.reduce((sum, x, i) => sum + x * forward[i], 0), 1);
        Object.assign(sheet, {stood: {axes, away, centre: eye.map((x, i) => x + away * forward[i])}, turned: [0, 0]});
        sheet.classList.add('turns');
        const {canvas} = sheet, degrees = (angle) => Math.round(angle * 180 / Math.PI), STEP = Math.PI / 36;
        const say = () => {
            canvas.setAttribute('aria-valuenow', degrees(sheet.turned[0]));
            canvas.setAttribute('aria-valuetext', `turned by ${degrees(-sheet.turned[0])}°, tilted by ${degrees(sheet.turned[1])}°`);
        };
        for (const [name, value] of Object.entries({tabindex: 0, role: 'slider', 'aria-roledescription': 'view', 'aria-description': 'The arrow keys turn the picture. Escape turns it back.', 'aria-valuemin': -180, 'aria-valuemax': 180})) canvas.setAttribute(name, value);
        canvas.addEventListener('keydown', (event) => {
            const way = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1], Escape: []}[event.key];
            if (!way || event.ctrlKey || event.altKey || event.metaKey) return;
            event.preventDefault();
            this.turn(sheet, ...[0, 1].map((i) => way.length ? sheet.turned[i] + STEP * (event.shiftKey ? 5 : 1) * way[i] : 0));
        });
        sheet.says = say;
        this.turn(sheet, 0, 0);
    },

    // Turn a figure by an angle around the vertical, and by one up or down; the other pictures of its table turn as well.
    // The camera stays above the horizon, and below the zenith.
    turn(sheet, across, up) {
        const clamp = (x, low, high) => Math.min(Math.max(x, low), high), LOW = 0.05, HIGH = 1.45, whole = 2 * Math.PI;
        if (across !== 0 || up !== 0) sheet.classList.add('moved');
        const all = [...sheet.closest('table')?.querySelectorAll('figure-sheet') ?? []].filter(({stood}) => stood);
        for (const one of all.length > 0 ? all : [sheet]) {
            const {axes: [right, above, forward], away, centre} = one.stood, first = Math.asin(clamp(-forward[1], -1, 1));
            const tilt = clamp(first + up, Math.min(first, LOW), Math.max(first, HIGH)) - first, angle = across - whole * Math.round(across / whole);
            const [c, s] = [Math.cos(tilt), Math.sin(tilt)], [C, S] = [Math.cos(angle), Math.sin(angle)];
            const around = ([x, y, z]) => [C * x + S * z, y, C * z - S * x];
            const axes = [right, above.map((x, i) => c * x + s * forward[i]), forward.map((x, i) => c * x - s * above[i])].map(around);
            Object.assign(one, {turned: [angle, tilt], axes, camera: [centre.map((x, i) => x - away * axes[2][i]), ...axes]});
            one.says();
            one.ask();
        }
    },

    // The option that gives a program the camera of a figure that has been turned.
    cameraOf({turned, camera: [eye, , , forward]}) {
        const degrees = (x) => x * 180 / Math.PI;
        return turned.every((x) => x === 0) ? '' : ` --camera ${[...eye, degrees(Math.atan2(forward[0], -forward[2])), degrees(Math.asin(forward[1]))].map((x) => Number(x.toFixed(5)))}`;
    },

    // ---- Points in space ----

    // Find the points in space in the picture, and move the one that is dragged in the plane parallel to the screen, with
    // Newton's method on the shader's own projection (common/picture/handles.c). A point that the reader moves stays in
    // the picture.
    follow(pen, sheet) {
        const {aim, axes, canvas: {width, height}} = sheet, SMALL = 0.01;
        // The positions of points, in units of the sheet; null if one of them is not in the picture.
        const project = (points) => {
            sheet.sendValues();
            pen.gl.uniform3fv(sheet.places.sheetPoints, points.flat());
            const found = sheet.asked(2, points.length);
            return found.every(([seen]) => seen === 1) ? found.map(([, x, y]) => [(2 * x - width) / height, 2 * y / height - 1]) : null;
        };
        sheet.aim = null;
        for (const knob of sheet.knobs.filter(({parameter}) => parameter.type === 'vec3')) {
            const one = knob.parameter, beside = (axis) => one.value.map((x, i) => x + SMALL * axis[i]), find = () => project([one.value, beside(axes[0]), beside(axes[1])]);
            for (let turns = aim?.one === one ? 6 : 1; turns > 0; turns--) {
                let seen = find();
                if (!seen && knob === document.activeElement && knob.last) {
                    one.value = knob.last;
                    seen = find();
                }
                knob.hidden = !seen;
                if (!seen) break;
                [knob.place] = seen;
                knob.last = one.value;
                if (turns === 1) break;
                const [a, b] = [seen[1], seen[2]].map((at) => at.map((x, i) => (x - seen[0][i]) / SMALL)), by = aim.to.map((x, i) => x - seen[0][i]), area = a[0] * b[1] - a[1] * b[0];
                const [s, t] = [(by[0] * b[1] - by[1] * b[0]) / area, (a[0] * by[1] - a[1] * by[0]) / area];
                if (Number.isFinite(s + t)) sheet.move(one, one.value.map((x, i) => x + s * axes[0][i] + t * axes[1][i]));
            }
        }
        sheet.sendValues();
    },
};
