// guess.js - asks for a guess before the answer to a *Predict* question opens, and then says how close the guess was.
// Guesses are stored on this device. This is a classic script, because browsers run no modules from file://.
(() => {
    const KEY = `guesses ${location.pathname.split('/').pop()}`;
    const kept = () => { try { return JSON.parse(localStorage[KEY]); } catch { return {}; } };
    function keep(number, guess) {
        try { localStorage[KEY] = JSON.stringify({...kept(), [number]: guess}); } catch {} // the browser stores nothing
    }

    // How far a point of a picture is from a rectangle, in widths of the picture.
    function outside([x, y], [left, top, right, bottom], height) {
        return Math.hypot(Math.max(left - x, 0, x - right), height * Math.max(top - y, 0, y - bottom));
    }

    // How close a guess is, in words.
    //   kind, right  as in guesses.txt; for a choice, right is the index of the right answer
    //   height       the height of the tapped picture, in widths of the picture
    function judged(kind, guess, right, height) {
        if (kind === 'tap') {
            const off = outside(guess.split(' ').map(Number), right.split(' ').map(Number), height);
            return off === 0 ? 'That is right.' : `You were off by ${Math.max(1, Math.round(100 * off))} % of the picture's width.`;
        }
        if (kind === 'choice') return guess === right ? 'That is right.' : 'That is not right.';
        if (kind !== 'number') return 'Compare it with the answer.';
        const [mine, its] = [guess, right].map(Number), factor = Math.max(mine / its, its / mine);
        return mine === its ? 'That is exact.' : Math.abs(mine - its) <= 0.1 * Math.abs(its) ? `It is ${right}: you were within a tenth of it.`
            : factor > 0 && factor < Infinity ? `It is ${right}: you were off by a factor of ${factor.toPrecision(2)}.` : `It is ${right}.`;
    }

    function answerOf(form) {
        let next = form.nextElementSibling;
        while (!next.matches('details')) next = next.nextElementSibling;
        return next;
    }

    function show(form, guess) {
        const {kind, right} = form.dataset, said = document.createElement('p'), img = form.querySelector('img');
        const words = kind === 'choice' ? form.querySelector(`[value="${guess}"]`).parentNode.textContent.trim() : kind === 'tap' ? 'the mark' : guess;
        said.className = 'guessed';
        said.textContent = `Your guess: ${words}. ${judged(kind, guess, right, img ? img.height / img.width : 1)}`;
        answerOf(form).querySelector('.guessed')?.remove();
        answerOf(form).querySelector('summary').after(said);
    }

    // Put the mark on a point of the picture, after a tap or an arrow key.
    function mark(form, x, y) {
        const at = form.querySelector('.tap i'), inside = (v) => Math.min(Math.max(v, 0), 1).toFixed(3);
        form.elements.guess.value = `${inside(x)} ${inside(y)}`;
        at.hidden = false;
        [at.style.left, at.style.top] = [x, y].map((v) => `${100 * inside(v)}%`);
    }
    function takeTaps(form, tap) {
        const point = () => (form.elements.guess.value || '0.5 0.5').split(' ').map(Number);
        tap.addEventListener('click', (event) => {
            const box = tap.getBoundingClientRect();
            // A click made with a key has no position.
            if (event.detail) mark(form, (event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
            else mark(form, ...point());
        });
        tap.addEventListener('keydown', (event) => {
            const move = {ArrowLeft: [-0.02, 0], ArrowRight: [0.02, 0], ArrowUp: [0, -0.02], ArrowDown: [0, 0.02]}[event.key];
            if (!move) return;
            event.preventDefault();
            mark(form, ...point().map((v, k) => v + move[k]));
        });
    }

    document.querySelectorAll('form.guess').forEach((form, number) => {
        const answer = answerOf(form), told = form.querySelector('output'), before = kept()[number], tap = form.querySelector('.tap');
        let asked = false;
        if (tap) takeTaps(form, tap);
        if (before !== undefined) {
            if (tap) mark(form, ...before.split(' ').map(Number));
            form.elements.guess.value = before;
            show(form, before);
        }
        form.addEventListener('submit', (event) => {
            event.preventDefault();
            const guess = form.elements.guess.value.trim();
            if (!guess) { told.textContent = 'Guess something first.'; return; }
            keep(number, guess);
            told.textContent = '';
            show(form, guess);
            answer.open = true;
        });
        // If there is no guess, the first press on Answer asks for one, and the second opens the answer anyway.
        answer.querySelector('summary').addEventListener('click', (event) => {
            if (asked || answer.open || kept()[number] !== undefined) return;
            event.preventDefault();
            asked = true;
            told.textContent = 'Guess first. If you press Answer again, it opens without a guess.';
            form.querySelector('input:not([type=hidden]), .tap').focus();
        });
    });
})();
