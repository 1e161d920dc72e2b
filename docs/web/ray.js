// ray.js - shows the ray of the selected pixel: its outcome, its steps, and buttons to move along it.
const VIEWS = {Slice: 'slice', Plot: 'plot'};

export class Ray {
    constructor(stage) {
        const {part} = stage;
        this.stage = stage;
        this.title = part('summary', {textContent: 'Ray'});
        this.outcome = part('p', {className: 'live-outcome'});
        this.body = part('tbody');
        this.table = part('table', {}, part('thead', {}, part('tr', {}, ...['step', 't', 'distance', 'x', 'y', 'z'].map((text) => part('th', {textContent: text, scope: 'col'})))), this.body);
        this.scroll = part('div', {className: 'live-table', tabIndex: 0}, this.table);
        this.scroll.setAttribute('role', 'region');
        this.scroll.setAttribute('aria-label', 'The steps of the ray');
        this.body.addEventListener('click', (event) => {
            const row = event.target.closest('tr');
            if (row) stage.call('live_step', row.sectionRowIndex);
        });
        const to = (step) => stage.call('live_step', Math.max(0, step));
        const view = (name) => () => stage.call('live_view', Math.max(0, stage.state.views.indexOf(stage.state.view === name ? 'picture' : name)));
        this.ways = Object.entries(VIEWS).map(([text, name]) => Object.assign(stage.button(text, view(name)), {view: name}));
        this.tools = part('div', {className: 'live-steps'},
            stage.button('First step', () => to(0)), stage.button('Back one step', () => to(this.shown === 0 ? this.steps : this.shown - 2)),
            stage.button('Forward', () => to(this.shown)), stage.button('Last step', () => to(this.steps)),
            ...this.ways, stage.button('Deselect', () => stage.call('live_pixel', -1, -1)));
        this.tools.setAttribute('role', 'group');
        this.tools.setAttribute('aria-label', 'Along the ray');
        this.middle = stage.button('Select the middle pixel', () => {
            const [width, height] = stage.state.size;
            stage.call('live_pixel', Math.floor(width / 2), Math.floor(height / 2));
        });
        this.none = part('p', {className: 'live-outcome'}, 'Click or tap a pixel of the picture to follow its ray step by step. ', this.middle);
        this.slice = part('canvas', {className: 'live-slice', width: 0});
        this.slice.setAttribute('role', 'img');
        this.slice.setAttribute('aria-label', 'The slice view: the ray seen from the side, with the circles of its steps');
        this.element = part('details', {className: 'live-ray'}, this.title, this.slice, this.tools, this.none, this.outcome, this.scroll);
    }

    show({pixel, probe, why, shown, view}) {
        const chosen = pixel[0] >= 0;
        this.shown = shown;
        if (chosen && !probe && !why) return; // the next frame marches the ray; until then, the old ray is shown
        this.none.hidden = chosen;
        this.outcome.hidden = this.tools.hidden = !chosen;
        this.scroll.hidden = !probe?.recorded;
        if (chosen && this.element.classList.toggle('live-chosen', true) && !this.chosen && (this.stage.narrow.matches || !this.stage.at.isInPlace)) this.element.open = true;
        if (!chosen) this.element.classList.remove('live-chosen');
        // On a narrow page, the steps are above the text that is edited.
        if (chosen !== Boolean(this.chosen) && this.stage.narrow.matches && this.stage.at.matches('.live-editing'))
            requestAnimationFrame(() => (chosen ? this.element : this.stage.changes.element).scrollIntoView({block: 'start', behavior: 'instant'}));
        this.chosen = chosen;
        this.slice.hidden = !chosen || !this.stage.narrow.matches || !probe?.recorded || ['slice', 'plot'].includes(view);
        this.title.textContent = chosen ? `Ray of pixel ${pixel.join(', ')}` : 'Ray';
        for (const button of this.ways) button.setAttribute('aria-pressed', button.view === view);
        if (!chosen) return;
        this.outcome.textContent = why || !probe ? why
            : `${probe.outcome}; steps: ${probe.steps}; steps of further rays: ${probe.all_steps - probe.steps}; evaluations of the scene: ${probe.evaluations}; colour: ${probe.colour.join(', ')}`;
        if (!probe) return;
        this.steps = probe.march.length;
        const text = JSON.stringify(probe.march);
        if (text !== this.text) {
            this.text = text;
            this.body.replaceChildren(...probe.march.map(([t, distance, ...place], i) => this.stage.part('tr', {},
                ...[i, t?.toFixed(4), distance?.toPrecision(3), ...place.map((x) => x?.toFixed(3))].map((cell) => this.stage.part('td', {textContent: cell ?? '–'})))));
        }
        this.mark(shown - 1);
        if (!this.slice.hidden && this.element.open) this.drawSlice(`${text} ${shown}`);
    }

    // On a narrow page, the slice is below the picture. The program draws the slice once, and then the current view
    // again, before the browser shows either of them.
    drawSlice(what) {
        if (what === this.drawn) return;
        this.drawn = what;
        const {program, state, canvas} = this.stage, to = (name) => {
            program.call('live_view', state.views.indexOf(name));
            program.module._live_turn();
        };
        to('slice');
        Object.assign(this.slice, {width: canvas.width, height: canvas.height});
        this.slice.getContext('2d').drawImage(canvas, 0, 0);
        to(state.view);
    }

    mark(at) {
        if (this.marked === at && this.body.children[at]?.classList.contains('live-at')) return;
        this.marked = at;
        for (const row of this.body.querySelectorAll('.live-at')) row.classList.remove('live-at');
        const row = this.body.children[at];
        if (!row) return;
        row.classList.add('live-at');
        const top = row.offsetTop - this.scroll.clientHeight / 2;
        this.scroll.scrollTop = Math.max(0, top);
    }
}
