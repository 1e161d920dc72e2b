// values.js - shows a row for each parameter of the shader: sliders, numbers, help with the unit, and a Reset button.

// The scale of a parameter's slider, which is logarithmic if a key press multiplies the value.
function scaleOf(parameter) {
    const {minimum, maximum, step, type} = parameter;
    if (parameter.multiplies && minimum > 0)
        return {to: Math.log, from: Math.exp, minimum: Math.log(minimum), maximum: Math.log(maximum), step: (Math.log(maximum) - Math.log(minimum)) / 200};
    const same = (x) => x, fine = (maximum - minimum) / 200;
    return {to: same, from: same, minimum, maximum, step: type === 'int' ? 1 : step > 0 ? Math.min(step, fine) : fine};
}

const written = (value) => String(Number(value.toPrecision(4)));

export class Values {
    constructor(stage) {
        const {part} = stage;
        this.stage = stage;
        this.rows = new Map();
        this.list = part('div', {className: 'live-rows'});
        this.all = stage.button('Reset all', () => { for (const name of this.rows.keys()) stage.call('live_reset', name); }, {className: 'live-reset-all'});
        this.element = part('details', {className: 'live-values'}, part('summary', {textContent: 'Values'}), this.list, this.all);
    }

    row(parameter) {
        const {part} = this.stage, {name, type} = parameter, id = `live-help-${name.replace(/\W+/g, '-')}`; // "factor (right)" is a parameter of the second of two pictures
        const set = (i, value) => this.stage.call('live_set', name, i, value);
        const row = {inputs: [], numbers: [], scale: scaleOf(parameter)};
        const letters = parameter.value.length > 1 ? (/colour( \(|$)/i.test(name) ? 'rgba' : 'xyzw') : ' ';
        const fields = parameter.value.map((_, i) => {
            const label = `${name} ${letters[i]}`.trim();
            if (type === 'bool') {
                const box = part('input', {type: 'checkbox', ariaLabel: label});
                box.addEventListener('change', () => set(i, Number(box.checked)));
                row.inputs.push(box);
                return part('span', {className: 'live-field live-switch'}, box);
            }
            const {scale} = row;
            const slider = part('input', {type: 'range', min: scale.minimum, max: scale.maximum, step: scale.step, ariaLabel: label});
            const number = part('input', {type: 'number', min: parameter.minimum, max: parameter.maximum, step: type === 'int' ? 1 : 'any', ariaLabel: `${label}, as a number`});
            slider.addEventListener('input', () => set(i, scale.from(Number(slider.value))));
            number.addEventListener('change', () => { if (number.value !== '') set(i, Number(number.value)); });
            row.inputs.push(slider);
            row.numbers.push(number);
            return part('span', {className: 'live-field'}, letters === ' ' ? '' : part('i', {textContent: letters[i]}), slider, number);
        });
        row.reset = this.stage.button('Reset', () => this.stage.call('live_reset', name), {className: 'live-reset'});
        row.reset.setAttribute('aria-label', `Reset ${name}`);
        const help = part('p', {id, className: 'live-help', textContent: [parameter.meaning, parameter.unit && `in ${parameter.unit}`].filter(Boolean).join('; ')});
        for (const input of row.inputs) input.setAttribute('aria-describedby', id);
        row.element = part('div', {className: 'live-row'}, part('div', {className: 'live-name'}, part('code', {textContent: name}), row.reset), ...fields, help);
        return row;
    }

    show(parameters) {
        const shape = JSON.stringify(parameters.map(({value, ...rest}) => [value.length, rest]));
        if (shape !== this.shape) {
            this.shape = shape;
            this.rows = new Map(parameters.map((parameter) => [parameter.name, this.row(parameter)]));
            this.list.replaceChildren(...[...this.rows.values()].map((row) => row.element));
        }
        this.element.hidden = parameters.length === 0;
        let moved = false;
        for (const {name, type, value, initial} of parameters) {
            const {inputs, numbers, scale, reset} = this.rows.get(name);
            value.forEach((x, i) => {
                if (type === 'bool') { inputs[i].checked = x !== 0; return; }
                if (document.activeElement !== inputs[i] || Math.abs(scale.to(x) - inputs[i].value) > scale.step) inputs[i].value = scale.to(x);
                inputs[i].setAttribute('aria-valuetext', written(x));
                if (document.activeElement !== numbers[i]) numbers[i].value = written(x);
            });
            reset.disabled = value.every((x, i) => x === initial[i]);
            moved ||= !reset.disabled;
        }
        this.all.disabled = !moved; // it keeps its place, so that nothing below it moves
    }
}
