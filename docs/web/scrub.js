// scrub.js - makes numbers in sentences adjustable: code such as `shadowOffset=0.25`, which names a parameter, can be
// dragged sideways or changed with the arrow keys, and a picture on the page follows.
const WAY = 240; // the drag distance, in CSS pixels, from a parameter's minimum to its maximum
const isSheet = (one) => one.matches('figure-sheet');

export class Scrub {
    //   code   the element, code.scrub
    //   runIn  runs a <live-chapter>: its command line or, if the second argument is true, the chapter's own shader
    constructor(code, runIn) {
        const [name, value] = code.textContent.split('=');
        Object.assign(this, {code, runIn, name, value: Number(value), turn: 0});
        code.tabIndex = 0;
        code.title = 'Drag sideways';
        code.setAttribute('role', 'slider');
        code.setAttribute('aria-label', name);
        this.write();
        code.addEventListener('pointerdown', (event) => this.grab(event));
        code.addEventListener('keydown', (event) => {
            const way = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
            if (!way) return;
            event.preventDefault();
            this.move(() => this.value, way / 40);
        });
        code.addEventListener('blur', () => this.at?.classList.remove('live-afloat'));
    }

    write() {
        this.code.textContent = `${this.name}=${Number(this.value.toPrecision(3))}`;
        this.code.setAttribute('aria-valuenow', this.value);
        this.code.setAttribute('aria-valuetext', this.code.textContent.split('=')[1]);
    }

    grab(event) {
        if (event.button !== 0) return;
        const from = this.value, {clientX} = event;
        if (!document.pointerLockElement) this.code.setPointerCapture(event.pointerId);
        this.code.focus({preventScroll: true});
        this.move(() => from, 0);
        this.code.onpointermove = (moved) => this.move(() => from, (moved.clientX - clientX) / WAY);
        this.code.onpointerup = this.code.onpointercancel = () => { this.code.onpointermove = null; };
    }

    // The picture that follows the number: the running picture if it has the parameter, otherwise the nearest one. An
    // interactive figure counts only if it has the parameter; what the other pictures have is known when they run.
    picture() {
        const top = this.code.getBoundingClientRect().top, far = (one) => Math.abs(one.getBoundingClientRect().top - top);
        const on = document.querySelector('.live-window');
        if (on && this.parameter(on)) return on;
        return [...document.querySelectorAll('live-chapter:not(.live-beside, .hands), figure-sheet')].filter((one) => one.checkVisibility() && (!isSheet(one) || this.parameter(one))).sort((a, b) => far(a) - far(b))[0];
    }

    parameter(at) { return isSheet(at) ? at.parameter(this.name) : at.program?.call('live_runs') && at.program.state().parameters.find(({name}) => name === this.name); }

    // Set the parameter to the value that `from` returns, moved by this share of the parameter's range.
    async move(from, share) {
        const turn = ++this.turn;
        let at = this.picture();
        if (!this.parameter(at)) {
            await (this.starting ??= this.runIn(at).finally(() => { this.starting = null; }));
            if (!this.parameter(at)) await this.runIn(at = document.querySelector('live-chapter'), true); // the picture's shader lacks the parameter
        }
        const parameter = this.parameter(at);
        if (turn !== this.turn || !parameter) return;
        const {minimum, maximum, type, multiplies} = parameter, start = from();
        const moved = share === 0 ? start : multiplies && start > 0 && minimum > 0 ? start * (maximum / minimum) ** share : start + share * (maximum - minimum);
        this.value = Math.min(Math.max(type === 'int' ? Math.round(moved) : moved, minimum), maximum);
        this.code.setAttribute('aria-valuemin', minimum);
        this.code.setAttribute('aria-valuemax', maximum);
        this.write();
        if (isSheet(at)) at.set(this.name, this.value);
        else at.stage.call('live_set', this.name, 0, this.value);
        this.keepInSight(at);
    }

    // A picture that is scrolled out of view floats over the page until the number loses the focus.
    keepInSight(at) {
        if (this.at && this.at !== at) this.at.classList.remove('live-afloat');
        this.at = at;
        if (at.classList.contains('live-afloat')) return;
        const {top, bottom, height} = at.screen.getBoundingClientRect();
        if (top > -height / 4 && bottom < innerHeight + height / 4) return;
        at.style.setProperty('--height', `${height}px`);
        at.classList.add('live-afloat');
    }
}
