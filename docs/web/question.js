// question.js - shows the comment on the answer that a reader chooses to an exit question of a chapter. This is a
// classic script, because browsers run no modules from file://.
(() => {
    for (const form of document.querySelectorAll('form.question')) {
        form.addEventListener('change', ({target}) => {
            form.querySelector('output').textContent = form.querySelectorAll('li')[Number(target.value)].textContent;
        });
    }
})();
