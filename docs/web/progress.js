// progress.js - saves what this browser remembers of the reader in a file, and reads such a file: the chapters that are read,
// the exercises that are solved, guesses, answers and drafts. This is a classic script, because browsers run no modules from
// file://.
(() => {
    const box = document.querySelector('.progress'), said = box.querySelector('.said');
    const HERE = new URL('.', location.href).pathname; // the keys of edits.js and play.js end with the site's path
    const OURS = /^(progress|guesses .*|ray marching: .*)$/;
    const parsed = (text) => { try { return JSON.parse(text) ?? {}; } catch { return {}; } };

    // What this browser remembers, {NAME: VALUE}.
    function remembered() {
        const own = Object.keys(localStorage).filter((key) => OURS.test(key) && (!key.startsWith('ray') || key.endsWith(` in ${HERE}`)));
        return Object.fromEntries(own.map((key) => [key.replace(` in ${HERE}`, ''), parsed(localStorage[key])]));
    }

    // Two values as one, in which the reader's own parts are kept. A chapter that is read in one of them is read.
    function joined(mine = {}, other = {}) {
        const both = {...other, ...mine};
        if (!mine.solved && !other.solved) return both;
        const read = {...other.read, ...mine.read};
        for (const stem of Object.keys(read)) if (other.read?.[stem] === true) read[stem] = true;
        return {...both, read, solved: [...new Set([...mine.solved ?? [], ...other.solved ?? []])].sort()};
    }

    box.querySelector('button').addEventListener('click', () => {
        const url = URL.createObjectURL(new Blob([JSON.stringify({course: 'Ray marching, step by step', remembered: remembered()}, null, 1)], {type: 'application/json'}));
        Object.assign(document.createElement('a'), {href: url, download: 'progress.json'}).click();
        setTimeout(() => URL.revokeObjectURL(url), 10000);
    });
    box.querySelector('input').addEventListener('change', async ({target}) => {
        const [file] = target.files, other = file && parsed(await file.text()).remembered;
        if (!file) return;
        target.value = '';
        if (!other || typeof other !== 'object') {
            said.textContent = `${file.name} is not a file that this page has saved.`;
            return;
        }
        const mine = remembered();
        try {
            for (const [name, value] of Object.entries(other)) if (OURS.test(name) && value && typeof value === 'object') localStorage[name.startsWith('ray') ? `${name} in ${HERE}` : name] = JSON.stringify(joined(mine[name], value));
            said.textContent = `${file.name} has been read.`;
            dispatchEvent(new StorageEvent('storage', {key: null})); // shows it in the contents
        } catch {
            said.textContent = 'This browser cannot store it.';
        }
    });
})();
