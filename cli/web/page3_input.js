// Pointers, keys and sliders.
const canvas = document.getElementById('canvas');
const pointer = {x: 0, y: 0, buttons: 0, clicked: 0, scroll: 0, zoom: 0};

function moveTo(event) {
    const box = canvas.getBoundingClientRect(), scale = canvas.width / box.width;
    pointer.x = (event.clientX - box.left) * scale;
    pointer.y = (event.clientY - box.top) * scale;
}

// One finger or the left button uses the tool, the right button or Shift pushes; the middle one, or two fingers, move the view,
// and fingers that part make it larger.
function startPointer() {
    const touches = new Map();
    const gesture = () => {
        const [one, other] = [...touches.values()];
        moveTo({clientX: (one.clientX + other.clientX) / 2, clientY: (one.clientY + other.clientY) / 2});
        return Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
    };
    let apart = 0;
    canvas.addEventListener('pointerdown', (event) => {
        canvas.focus({preventScroll: true});
        canvas.setPointerCapture(event.pointerId);
        touches.set(event.pointerId, event);
        moveTo(event);
        if (touches.size === 2) {
            sph2d._page_pick(numbers().tool); // what one finger began is left
            apart = gesture();
        }
        pointer.buttons = touches.size > 1 || event.button === 1 ? 4 : event.button === 2 || event.shiftKey ? 2 : 1;
        pointer.clicked = pointer.buttons; // until a turn has seen it
        event.preventDefault();
    });
    canvas.addEventListener('pointermove', (event) => {
        if (!touches.has(event.pointerId) || touches.size === 1) moveTo(event);
        if (!touches.has(event.pointerId)) return;
        touches.set(event.pointerId, event);
        if (touches.size !== 2) return;
        const now = gesture();
        pointer.zoom += Math.log(now / apart) / Math.log(1.1);
        apart = now;
    });
    const lift = (event) => {
        touches.delete(event.pointerId);
        if (touches.size === 0) pointer.buttons = 0;
    };
    canvas.addEventListener('pointerup', lift);
    canvas.addEventListener('pointercancel', lift);
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => { // a pinch on a trackpad is a wheel with Ctrl, in small parts
        moveTo(event);
        if (event.ctrlKey) pointer.zoom -= Math.max(-1, Math.min(1, event.deltaY / 20));
        else pointer.scroll -= Math.sign(event.deltaY);
        event.preventDefault();
    }, {passive: false});
}

const KEYS = {ArrowLeft: 256, ArrowRight: 257, ArrowDown: 258, ArrowUp: 259, Home: 261}; // as in cli/play/window.h

function startKeys(special) {
    window.addEventListener('keydown', (event) => {
        const typing = /^(TEXTAREA|SELECT|INPUT)$/.test(event.target.tagName), control = event.ctrlKey || event.metaKey;
        const undo = control && event.key.toUpperCase() === 'Z';
        if (typing || (control && !undo) || event.altKey) return;
        const name = undo ? 'U' : event.key.length === 1 ? event.key.toUpperCase() : event.key;
        if (special[name]) special[name]();
        else if (KEYS[name]) sph2d._page_key(KEYS[name]);
        else if (name.length === 1 && name !== 'Q') key(name);
        else return;
        if (name === ' ' || KEYS[name] || special[name]) event.preventDefault(); // neither a button nor the page's scrolling
    });
}

// Sliders of powers of ten, but for gravity and the pace, which is a power of two; the least of some is nothing.
const sliders = {
    gravity: {what: 0, value: (s) => s, place: (v) => v},
    viscosity: {what: 1, value: (s) => (s <= -4 ? 0 : 10 ** s), place: (v) => (v > 0 ? Math.log10(v) : -4)},
    tension: {what: 2, value: (s) => (s <= -1 ? 0 : 10 ** s), place: (v) => (v > 0 ? Math.log10(v) : -1)},
    compression: {what: 3, value: (s) => 10 ** s, place: (v) => Math.log10(v)},
    rate: {what: 4, value: (s) => 2 ** s, place: (v) => Math.log2(v), id: 'pace'},
    density: {what: 5, value: (s) => 10 ** s, place: (v) => Math.log10(v)},
};

function startSliders() {
    for (const [name, slider] of Object.entries(sliders)) {
        slider.input = document.getElementById(slider.id || name);
        slider.output = slider.input.nextElementSibling;
        slider.input.oninput = () => {
            slider.until = performance.now() + 300; // the hand is on it
            slider.output.textContent = textOf(name, slider.value(Number(slider.input.value)));
        };
        slider.input.onchange = () => sph2d._page_set(slider.what, slider.value(Number(slider.input.value)));
    }
}

const textOf = (name, value) => Number((name === 'compression' ? 100 * value : value).toPrecision(3)).toString();

// Sliders follow what keys and scenes change.
function showSliders(now) {
    for (const [name, slider] of Object.entries(sliders)) {
        if (slider.until > performance.now() || document.activeElement === slider.input) continue;
        slider.input.value = slider.place(now[name]);
        slider.output.textContent = textOf(name, now[name]);
    }
}
