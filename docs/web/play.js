// play.js - the page Play: a shader that is dropped or chosen runs in the page's program; Export hands out one file.
const box = document.querySelector('.drop'), chapter = box.querySelector('live-chapter'), said = box.querySelector('.said');
const choose = box.querySelector('input'), button = box.querySelector('.export');
const LIMIT = 1 << 20; // bytes: a shader has a few thousand

function say(text) { said.textContent = text; }

async function play(file) {
    if (!file) return;
    if (file.size > LIMIT) return say(`${file.name}: ${Math.round(file.size / 1e6)} MB is no shader: it may have 1 MB`);
    const text = await file.text();
    if (text.includes('\0')) return say(`${file.name}: that is no text`);
    // What the program's file system and its messages can name.
    const name = file.name.replace(/\.\w+$/, '').replace(/[^\w-]+/g, '_') || 'shader';
    say(`${file.name} runs.`);
    const status = await chapter.play(`${name}.frag`, text);
    button.disabled = status !== 0;
    if (status !== 0) say(`${file.name} cannot be drawn: what is wrong stands above.`);
}

choose.addEventListener('change', () => play(choose.files[0]));
box.addEventListener('dragover', (event) => { event.preventDefault(); box.classList.add('over'); });
box.addEventListener('dragleave', () => box.classList.remove('over'));
// A file that misses the box would take the page's place.
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
    event.preventDefault();
    box.classList.remove('over');
    play(event.dataTransfer.files[0]);
});

button.addEventListener('click', async () => {
    const text = await chapter.exported();
    const link = Object.assign(document.createElement('a'), {href: URL.createObjectURL(new Blob([text], {type: 'text/plain'})), download: 'shadertoy.glsl'});
    link.click();
    URL.revokeObjectURL(link.href);
    say('shadertoy.glsl is written: paste it into a new shader there.');
});
