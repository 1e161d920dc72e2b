// guess.js - Predict first: a question takes a guess before its answer opens, and says afterwards how near it was. The
// guesses are kept on this device. A script of the old kind: browsers run no modules from file://.
(() => {
    const KEY = `guesses ${location.pathname.split('/').pop()}`;
    const kept = () => { try { return JSON.parse(localStorage[KEY]); } catch { return {}; } };
    function keep(number, guess) {
        try { localStorage[KEY] = JSON.stringify({...kept(), [number]: guess}); } catch {} // the browser keeps nothing
    }

    // How near a guess is, in words.
    //   kind, right  as guesses.txt has them; of a choice the place of the right one
    function judged(kind, guess, right) {
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
        const {kind, right} = form.dataset, said = document.createElement('p');
        const words = kind === 'choice' ? form.querySelector(`[value="${guess}"]`).parentNode.textContent.trim() : guess;
        said.className = 'guessed';
        said.textContent = `Your guess: ${words}. ${judged(kind, guess, right)}`;
        answerOf(form).querySelector('.guessed')?.remove();
        answerOf(form).querySelector('summary').after(said);
    }

    document.querySelectorAll('form.guess').forEach((form, number) => {
        const answer = answerOf(form), told = form.querySelector('output'), before = kept()[number];
        let asked = false;
        if (before !== undefined) {
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
        // The first press on an answer without a guess asks for one; the second opens it all the same.
        answer.querySelector('summary').addEventListener('click', (event) => {
            if (asked || answer.open || kept()[number] !== undefined) return;
            event.preventDefault();
            asked = true;
            told.textContent = 'Guess first. If you press Answer again, it opens without a guess.';
            form.querySelector('input').focus();
        });
    });
})();
