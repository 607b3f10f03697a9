'use strict';
// The compiled library: starts it, and calls its functions with texts.
let sph2d = null;

async function startModule() {
    sph2d = await makeModule({wasmBinary: parts.wasm, canvas: document.getElementById('canvas')});
    return sph2d._page_start() !== 0;
}

// Calls a function of C with texts, whose answer is a text.
function ask(name, ...texts) {
    const places = texts.map((text) => {
        const size = sph2d.lengthBytesUTF8(text) + 1, place = sph2d._malloc(size);
        sph2d.stringToUTF8(text, place, size);
        return place;
    });
    const answer = sph2d.UTF8ToString(sph2d['_' + name](...places));
    places.forEach((place) => sph2d._free(place));
    return answer;
}

const key = (name) => sph2d._page_key(name.codePointAt(0));

// How play goes, by name.
function numbers() {
    const names = ['time', 'particles', 'pictures', 'pace', 'stepping', 'drawing', 'steps', 'paused', 'stopped',
        'gravity', 'viscosity', 'tension', 'compression', 'rate', 'density', 'tool', 'left'];
    const at = sph2d._page_numbers() / 8, values = sph2d.HEAPF64.subarray(at, at + names.length);
    return Object.fromEntries(names.map((name, k) => [name, values[k]]));
}
