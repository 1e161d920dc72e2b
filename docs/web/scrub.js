// scrub.js - makes numbers in sentences adjustable: a number that a parameter has, as in `shadowOffset=0.25` or in a link
// with a value, [12 steps](#most=12), can be dragged sideways or changed with the arrow keys, and a picture follows.
const WAY = 240; // the drag distance, in CSS pixels, from a parameter's minimum to its maximum
const ONE = 40; // and that from one whole number to the next, at most
const FEW = 4; // a finger that has moved no farther, in CSS pixels, has tapped
const isSheet = (one) => one.matches('figure-sheet');

export class Scrub {
    //   code   the element, .scrub, with the parameter's name as data-name and the number in <data>; data-at is the
    //          picture that the page's author has chosen, or chapter
    //   runIn  runs a <live-chapter>: its command line or, if the second argument is true, the chapter's own shader
    constructor(code, runIn) {
        const {name, at} = code.dataset, number = code.querySelector('data');
        code.scrub = this;
        Object.assign(this, {code, runIn, name, number, chosen: at, value: Number(number.value), first: Number(number.value), turn: 0});
        code.tabIndex = 0;
        code.title = 'Drag sideways';
        code.setAttribute('role', 'slider');
        code.setAttribute('aria-label', name);
        code.setAttribute('aria-description', 'The arrow keys change the number. Escape puts it back.');
        this.say();
        code.addEventListener('pointerdown', (event) => this.grab(event));
        code.addEventListener('touchmove', (event) => { if (this.held) event.preventDefault(); }, {passive: false}); // touch-action does not apply within a line of text
        code.addEventListener('keydown', (event) => {
            const way = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, Enter: 0, ' ': 0, Escape: 0}[event.key];
            if (way === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
            event.preventDefault();
            const from = event.key === 'Escape' ? this.first : this.value;
            this.move(() => way === 0 ? from : this.value, ({type, minimum, maximum}) => way * Math.max(1 / 40, type === 'int' ? 1 / (maximum - minimum) : 0));
        });
        code.addEventListener('blur', () => this.land());
    }

    say() {
        this.code.setAttribute('aria-valuenow', this.value);
        this.code.setAttribute('aria-valuetext', this.number.textContent);
    }

    // A mouse sets the number when it is pressed. A finger may be about to scroll the page, so it sets the number only
    // when it moves sideways, or when it is lifted.
    grab(event) {
        if (event.button !== 0) return;
        const {code} = this, from = this.value, {clientX, clientY, pointerType} = event, act = (x) => this.move(() => from, ({type, minimum, maximum}) => x / Math.min(WAY, type === 'int' ? ONE * (maximum - minimum) : WAY));
        this.held = pointerType === 'mouse';
        if (!document.pointerLockElement) code.setPointerCapture(event.pointerId);
        code.focus({preventScroll: true});
        if (this.held) act(0);
        const end = () => { code.onpointermove = code.onpointerup = code.onpointercancel = null; };
        code.onpointermove = (moved) => {
            this.held ||= Math.abs(moved.clientX - clientX) > Math.max(FEW, Math.abs(moved.clientY - clientY));
            if (this.held) act(moved.clientX - clientX);
        };
        code.onpointerup = () => {
            if (!this.held) act(0);
            end();
        };
        code.onpointercancel = end;
    }

    // The picture that follows the number: the one that the author has chosen, or the nearest visible one that has the
    // parameter, or that of the chapter.
    picture() {
        const own = document.querySelector('live-chapter'), place = (one) => one.matches('.hands:not(.live-on)') ? one.querySelector('figure-sheet') : one;
        if (this.chosen) return place(document.querySelector(`live-chapter:has(img[src*="/${this.chosen}."])`) ?? own);
        const {top, bottom} = this.code.getBoundingClientRect(), middle = (top + bottom) / 2, far = (one) => {
            const box = one.getBoundingClientRect();
            return Math.max(box.top - middle, middle - box.bottom, 0);
        };
        return [...document.querySelectorAll('live-chapter:not(.hands), .live-window, figure-sheet')].filter((one) => one.checkVisibility() && this.has(one)).sort((a, b) => far(a) - far(b))[0] ?? own;
    }

    // Does a picture have the parameter? What runs knows it; of the others, the site's builder has noted it.
    has(at) { return isSheet(at) || at.program?.call('live_runs') ? Boolean(this.parameter(at)) : Boolean(at.getAttribute('numbers')?.split(' ').includes(this.name)); }

    parameter(at) { return isSheet(at) ? at.parameter(this.name) : at.program?.call('live_runs') && at.program.state().parameters.find(({name}) => name === this.name); }

    // Set the parameter to the value that `from` returns, moved by the share of the parameter's range that `by` returns.
    async move(from, by) {
        const turn = ++this.turn;
        let at = this.picture();
        if (!this.parameter(at)) {
            await (this.starting ??= this.runIn(at).finally(() => { this.starting = null; }));
            if (!this.parameter(at)) await this.runIn(at = document.querySelector('live-chapter'), true); // the picture's shader lacks the parameter
        }
        const parameter = this.parameter(at);
        if (turn !== this.turn || !parameter) return;
        const {minimum, maximum, type, multiplies} = parameter, start = from(), share = by(parameter);
        const moved = share === 0 ? start : multiplies && start > 0 && minimum > 0 ? start * (maximum / minimum) ** share : start + share * (maximum - minimum);
        this.value = Math.min(Math.max(type === 'int' ? Math.round(moved) : share === 0 ? moved : Number(moved.toPrecision(3)), minimum), maximum);
        this.number.textContent = String(this.value).replace('-', '−');
        this.code.setAttribute('aria-valuemin', minimum);
        this.code.setAttribute('aria-valuemax', maximum);
        this.say();
        if (isSheet(at)) at.set(this.name, this.value);
        else at.stage.call('live_set', this.name, 0, this.value);
        this.keepInSight(at);
    }

    land() {
        this.at?.classList.remove('live-afloat', 'live-aloft');
        this.watch?.disconnect();
    }

    // A picture that is scrolled out of view floats over the page, away from the number, until the number loses the
    // focus or is itself scrolled out of view.
    keepInSight(at) {
        if (this.at !== at) this.land();
        this.at = at;
        if (at.classList.contains('live-afloat')) return;
        const {top, bottom, height} = at.screen.getBoundingClientRect();
        if (top > -height / 4 && bottom < innerHeight + height / 4) return;
        at.style.setProperty('--height', `${at.getBoundingClientRect().height}px`); // with what is below the picture, so that no text moves
        at.classList.add('live-afloat');
        this.watch = new IntersectionObserver(([{isIntersecting}]) => { if (!isIntersecting) this.land(); });
        this.watch.observe(this.code);
        at.classList.toggle('live-aloft', this.code.getBoundingClientRect().bottom > at.screen.getBoundingClientRect().top - 20);
    }
}
