// The page: scenes, buttons, pictures, films, and the loop.
const element = (id) => document.getElementById(id);
const tools = [...element('tools').children]; // in the order of hand_tool in cli/play/hand.h
let told = '', toldUntil = 0, recorder = null, last = 0;

function download(data, name) {
    const link = Object.assign(document.createElement('a'), {href: URL.createObjectURL(data), download: name});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function tell(text) {
    told = text;
    element('told').textContent = text;
    element('told').classList.add('shown');
    toldUntil = performance.now() + 4000;
}

// ---- scenes -------------------------------------------------------------------------------------------------------

// Opens a text; `index` is that of a scene of the list, and of none what follows these: another scene, by its name.
function openText(text, name, index = sph2d._page_scene_count()) {
    const result = JSON.parse(ask('page_open', text, name));
    if (editor.text.value !== text) editor.text.value = text;
    editor.show(result);
    if (!result.ok) {
        tell(`The scene has errors: ${result.messages[0].message}.`);
        return false;
    }
    showName(ask('page_name') || name, index);
    return true;
}

function showName(name, index = sph2d._page_scene_count()) {
    const list = element('scenes'), other = list.options[sph2d._page_scene_count()];
    other.textContent = name;
    other.hidden = index < other.index;
    list.selectedIndex = index;
    element('name').value = name;
    document.title = `${name} - sph2d`;
}

function openNumber(index) {
    if (index >= sph2d._page_scene_count()) return;
    const name = sph2d.UTF8ToString(sph2d._page_scene_name(index));
    openText(sph2d.UTF8ToString(sph2d._page_scene_text(index)), name, index);
}

function listScenes() {
    const list = element('scenes'), count = sph2d._page_scene_count();
    for (let k = 0; k < count; ++k) {
        const name = sph2d.UTF8ToString(sph2d._page_scene_name(k)).replace(/_/g, ' ');
        list.add(new Option(k < 9 ? `${k + 1} ${name}` : name, k));
    }
    list.add(new Option('', count));
    list.options[count].hidden = true;
    list.onchange = () => {
        openNumber(list.selectedIndex);
        canvas.focus();
    };
}

async function copyLink() {
    history.replaceState(null, '', `#scene=${await links.pack(editor.text.value)}`);
    try {
        await navigator.clipboard.writeText(location.href);
        tell('The link is in the clipboard, and in the address.');
    } catch (error) {
        tell('The link is in the address of this page.');
    }
}

// Scenes that the browser keeps, by their names.
const kept = {
    prefix: 'sph2d scene ',

    names() {
        let storage = {};
        try {
            storage = localStorage;
        } catch (error) { // a browser may forbid it
            tell(`This browser keeps nothing: ${error.message}`);
        }
        return Object.keys(storage).filter((key) => key.startsWith(this.prefix)).map((key) => key.slice(this.prefix.length)).sort();
    },

    list() {
        const item = (name) => {
            const button = (text, act) => Object.assign(document.createElement('button'), {textContent: text, onclick: act});
            const row = document.createElement('li');
            const open = () => openText(localStorage.getItem(this.prefix + name), name) && showName(name);
            row.append(button(name, open), button('Delete', () => {
                localStorage.removeItem(this.prefix + name);
                this.list();
            }));
            return row;
        };
        element('saved').replaceChildren(...this.names().map(item));
    },

    save(event) {
        event.preventDefault();
        try {
            localStorage.setItem(this.prefix + element('name').value, ask('page_text'));
            this.list();
        } catch (error) {
            tell(`This browser does not keep it: ${error.message}`);
        }
    },
};

// ---- pictures and films -------------------------------------------------------------------------------------------

const savePicture = () => canvas.toBlob((blob) => download(blob, 'sph2d.png'));

function toggleFilm() {
    if (recorder) {
        recorder.stop();
        recorder = null;
    } else if (!window.MediaRecorder || !canvas.captureStream) {
        tell('This browser cannot record films.');
    } else {
        const chunks = [];
        recorder = new MediaRecorder(canvas.captureStream(30), {videoBitsPerSecond: 8e6});
        recorder.ondataavailable = (event) => chunks.push(event.data);
        recorder.onstop = (event) => download(new Blob(chunks, {type: event.target.mimeType}),
            `sph2d.${/mp4/.test(event.target.mimeType) ? 'mp4' : 'webm'}`);
        recorder.start();
    }
    element('film').classList.toggle('on', recorder !== null);
}

// The scene as it is now, with what was changed and drawn.
const saveScene = () => download(new Blob([ask('page_text')], {type: 'text/yaml'}), 'scene.yaml');

// ---- the loop -----------------------------------------------------------------------------------------------------

function fitCanvas() {
    const box = element('stage').getBoundingClientRect(), scale = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.round(box.width * scale), height = Math.round(box.height * scale);
    if (canvas.width !== width || canvas.height !== height) {
        canvas.width = width;
        canvas.height = height;
    }
}

function showState() {
    const now = numbers();
    element('numbers').textContent = `t = ${now.time.toFixed(2)} s   ${now.particles} particles${now.left ? `, ${now.left} left` : ''}   ` +
        `${now.stopped ? 'stopped' : now.paused ? 'paused' : `${now.pace.toFixed(2)} x the clock`}   ` +
        `${now.pictures.toFixed(0)} pictures/s   ${(1000 * now.stepping).toFixed(1)} ms steps, ` +
        `${(1000 * now.drawing).toFixed(1)} ms drawing`;
    element('pause').textContent = now.paused ? 'Go on' : 'Pause';
    tools.forEach((button, k) => button.classList.toggle('on', k === now.tool));
    showSliders(now);
    const message = ask('page_told');
    if (message) tell(message);
    if (performance.now() > toldUntil) element('told').classList.remove('shown');
}

function turn(time) {
    const seconds = last > 0 ? (time - last) / 1000 : 0;
    last = time;
    fitCanvas();
    const buttons = pointer.buttons || pointer.clicked;
    if (!sph2d._page_turn(seconds, canvas.width, canvas.height, pointer.x, pointer.y, buttons, pointer.scroll, pointer.zoom)) {
        element('trouble').textContent = ask('page_told');
        return;
    }
    pointer.scroll = pointer.zoom = pointer.clicked = 0;
    showState();
    requestAnimationFrame(turn);
}

function startButtons() {
    document.querySelectorAll('button[data-key]').forEach((button) => {
        button.onclick = () => {
            key(button.dataset.key);
            canvas.focus();
        };
    });
    tools.forEach((button, k) => {
        button.onclick = () => {
            sph2d._page_pick(k);
            canvas.focus();
        };
    });
    const toggle = (button, section) => {
        element(section).hidden = !element(section).hidden;
        element(button).classList.toggle('on', !element(section).hidden);
    };
    element('edit').onclick = () => {
        toggle('edit', 'editor');
        if (!editor.box.hidden) editor.check();
    };
    const more = () => toggle('more', 'sliders');
    element('more').onclick = more;
    element('save').onclick = () => {
        toggle('save', 'kept');
        kept.list();
    };
    element('keep').onsubmit = (event) => kept.save(event);
    element('link').onclick = copyLink;
    element('picture').onclick = savePicture;
    element('film').onclick = toggleFilm;
    const special = {H: more, F: toggleFilm, S: saveScene};
    const all = sph2d._page_scene_count();
    const by = (step) => () => openNumber((Math.min(element('scenes').selectedIndex, step > 0 ? all - 1 : all) + step + all) % all);
    Object.assign(special, {PageDown: by(1), PageUp: by(-1)});
    for (let k = 0; k < 9; ++k) special[String(k + 1)] = () => openNumber(k);
    startKeys(special);
}

async function start() {
    if (!await startModule()) throw new Error('This page needs WebGL 2, which this browser does not have.');
    listScenes();
    canvas.addEventListener('webglcontextlost', () => {
        element('trouble').textContent = 'The browser took the canvas away; load the page again.';
    });
    startPointer();
    startSliders();
    startButtons();
    editor.start(() => openText(editor.text.value, 'scene'));
    const shared = await links.read();
    if (shared === null || !openText(shared, 'scene')) {
        openNumber(0);
        if (shared !== null) editor.show(JSON.parse(ask('page_check', shared, 'scene')));
    }
    requestAnimationFrame(turn);
}

start().catch((error) => {
    element('trouble').textContent = error.message;
});
