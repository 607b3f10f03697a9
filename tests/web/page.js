// page.js PAGE STATE SPH2D FOLDER: tests the page in a real Chromium (CHROMIUM names it): it starts, the liquid falls,
// mouse, touch and keys move it, the editor tells faults, links carry scenes; pictures are those of `sph2d run`, and the
// state after 100 steps has the bits of the native baseline. Pictures and times go into FOLDER.
'use strict';
const assert = require('assert'), fs = require('fs'), path = require('path'), zlib = require('zlib');
const {execFileSync} = require('child_process');
const {Browser, sleep} = require('./browser.js');
const [page, stateProgram, command, folder] = process.argv.slice(2).map((name) => path.resolve(name));
const address = `file://${page}`, scenes = path.join(__dirname, '../../cli/play/scenes');

const text = (name) => fs.readFileSync(path.join(scenes, name), 'utf8');
const numbers = (browser) => browser.value('numbers()');
const open = (browser, scene) => browser.value(`openText(${JSON.stringify(scene)}, 'scene')`);

// The liquid, one Float64Array for x, y and both velocities.
async function liquid(browser) {
    const base64 = await browser.value(`(() => {
        const count = numbers().particles, parts = [0, 1, 2, 3].map((k) => {
            const at = sph2d._page_particles(k);
            return new Uint8Array(sph2d.HEAPU8.slice(at, at + 8 * count));
        });
        let binary = '';
        for (const part of parts) for (const byte of part) binary += String.fromCharCode(byte);
        return btoa(binary);
    })()`);
    const bytes = Buffer.from(base64, 'base64');
    return new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

function mean(values, part) {
    const count = values.length / 4;
    return values.subarray(part * count, (part + 1) * count).reduce((sum, value) => sum + value, 0) / count;
}

// A place of the canvas from parts of its sides.
async function at(browser, x, y) {
    const box = await browser.value('(() => { const b = canvas.getBoundingClientRect();' +
        ' return [b.left, b.top, b.width, b.height]; })()');
    return [box[0] + x * box[2], box[1] + y * box[3]];
}

// A place of the scene on the canvas: the picture fits the domain into it.
async function sceneAt(browser, x, y, width, height) {
    const [canvasWidth, canvasHeight] = await browser.value('[canvas.width, canvas.height]');
    const strip = 0.045 * canvasHeight, scale = Math.min(canvasWidth / width, (canvasHeight - strip) / height);
    return at(browser, 0.5 + (x - width / 2) * scale / canvasWidth,
        (0.5 * (canvasHeight - strip) - (y - height / 2) * scale) / canvasHeight);
}

async function drag(browser, places, button = 'left') {
    const buttons = {left: 1, right: 2, middle: 4}[button];
    await browser.mouse('mousePressed', ...places[0], {button, buttons});
    for (const place of places) {
        await browser.mouse('mouseMoved', ...place, {button, buttons});
        await sleep(120);
    }
    await browser.mouse('mouseReleased', ...places[places.length - 1], {button});
}

const pause = async (browser, wanted) => {
    await browser.value(`numbers().paused == ${Number(wanted)} || key(' ')`);
    await browser.until(`numbers().paused == ${Number(wanted)}`);
};

// Steps while paused, without waiting for pictures.
async function steps(browser, count) {
    await browser.value(`(() => {
        for (let k = 0; k < ${count}; ++k) {
            key('.');
            sph2d._page_turn(0, 0, 0, 0, 0, 0, 0, 0);
        }
    })()`);
}

// ---- pictures: PNG of 8-bit RGB or RGBA to rows of RGB --------------------------------------------------------------

function readPng(bytes) {
    const width = bytes.readUInt32BE(16), height = bytes.readUInt32BE(20), channels = bytes[25] === 6 ? 4 : 3;
    const data = [];
    for (let k = 8; k < bytes.length; k += 12 + bytes.readUInt32BE(k))
        if (bytes.toString('latin1', k + 4, k + 8) === 'IDAT') data.push(bytes.subarray(k + 8, k + 8 + bytes.readUInt32BE(k)));
    const raw = zlib.inflateSync(Buffer.concat(data)), stride = width * channels;
    const rows = Buffer.alloc(height * stride);
    for (let y = 0; y < height; ++y) {
        const filter = raw[y * (stride + 1)];
        for (let x = 0; x < stride; ++x) {
            const a = x >= channels ? rows[y * stride + x - channels] : 0, b = y > 0 ? rows[(y - 1) * stride + x] : 0;
            const c = x >= channels && y > 0 ? rows[(y - 1) * stride + x - channels] : 0, p = a + b - c;
            const near = Math.abs(p - a) <= Math.abs(p - b) && Math.abs(p - a) <= Math.abs(p - c) ? a :
                Math.abs(p - b) <= Math.abs(p - c) ? b : c;
            const guess = [0, a, b, (a + b) >> 1, near][filter];
            rows[y * stride + x] = raw[y * (stride + 1) + 1 + x] + guess;
        }
    }
    return {width, height, pixel: (x, y, c) => rows[y * stride + x * channels + c]};
}

// The mean difference of levels over the upper 90 % of two pictures, and the part of pixels that differ by over 16.
function compare(one, other) {
    assert.deepStrictEqual([one.width, one.height], [other.width, other.height], 'pictures of one size');
    let sum = 0, far = 0, count = 0;
    for (let y = 0; y < Math.floor(0.9 * one.height); ++y)
        for (let x = 0; x < one.width; ++x, ++count) {
            let most = 0;
            for (let c = 0; c < 3; ++c) most = Math.max(most, Math.abs(one.pixel(x, y, c) - other.pixel(x, y, c)));
            sum += most;
            far += most > 16;
        }
    return {mean: sum / count, far: far / count};
}

// ---- tests ----------------------------------------------------------------------------------------------------------

const tests = {
    'the page is small and whole': async () => {
        const html = fs.readFileSync(page, 'utf8');
        assert(fs.statSync(page).size < 470e3, `${fs.statSync(page).size} bytes`);
        assert(!/(src|href)\s*=\s*["'](https?:)?\/\//.test(html), 'nothing is loaded from elsewhere');
    },

    'the liquid falls': async (browser) => {
        await browser.until('numbers().time > 0.02');
        const before = await liquid(browser);
        await browser.until(`numbers().time > ${(await numbers(browser)).time + 0.15}`, 60);
        const after = await liquid(browser);
        assert.strictEqual(before.length, after.length);
        assert(mean(after, 1) < mean(before, 1) - 0.005, 'its centre sinks');
        assert(mean(after, 0) > mean(before, 0) + 0.005, 'and goes to the right');
    },

    'a picture is that of sph2d run': async (browser) => {
        await open(browser, text('1_dam_break.yaml'));
        await pause(browser, true);
        await browser.press('r');
        await browser.until('numbers().steps === 0');
        await sleep(300);
        const data = await browser.value('canvas.toDataURL("image/png")');
        const shown = Buffer.from(data.slice(data.indexOf(',') + 1), 'base64');
        fs.writeFileSync(path.join(folder, 'page.png'), shown);
        const size = await browser.value('[canvas.width, canvas.height]');
        const out = path.join(folder, 'run'), frames = path.join(out, 'frames');
        execFileSync(command, ['run', path.join(scenes, '1_dam_break.yaml'), '-q', '-f', '-o', out, '--set',
            'run.until=0.001', '--set', 'run.frames.every=1', '--set', `run.frames.size=[${size}]`]);
        const {mean: level, far} = compare(readPng(shown), readPng(fs.readFileSync(path.join(frames, 'frame_000000.png'))));
        console.log(`    differs by ${level.toFixed(3)} levels in the mean, by over 16 in ${(100 * far).toFixed(3)} % of pixels`);
        assert(level < 1 && far < 0.01, 'the pictures are alike');
        await pause(browser, false);
    },

    'mouse: pull, push, pour, wipe, wall': async (browser) => {
        await open(browser, text('1_dam_break.yaml'));
        await browser.until('numbers().time > 0');
        const before = await liquid(browser);
        await drag(browser, Array(12).fill(await at(browser, 0.38, 0.35)));
        const pulled = await liquid(browser);
        const speed = (state) => Math.hypot(...state.subarray(state.length / 2)) / Math.sqrt(state.length / 4);
        assert(speed(pulled) > speed(before) + 0.01, `pulled: ${speed(before)} to ${speed(pulled)} m/s`);
        await browser.press('o');
        await browser.until('numbers().tool === 2');
        const first = await numbers(browser);
        await drag(browser, [await at(browser, 0.5, 0.2), await at(browser, 0.52, 0.22)]);
        const poured = await numbers(browser);
        assert(poured.particles > first.particles + 5, 'liquid is poured');
        await browser.press('e');
        await browser.until('numbers().tool === 3');
        const full = await numbers(browser);
        await drag(browser, [await sceneAt(browser, 0.1, 0.05, 1.6, 0.9), await sceneAt(browser, 0.12, 0.05, 1.6, 0.9)]); // a corner
        await browser.until(`numbers().particles < ${full.particles}`);
        await browser.press('w');
        await browser.until('numbers().tool === 4');
        await drag(browser, await Promise.all([0.1, 0.15, 0.2, 0.3].map((x) => at(browser, x, 0.85))));
        await sleep(500);
        assert.match(await browser.value('ask("page_text")'), /polyline/, 'the scene has a wall more');
        await browser.press('p');
    },

    'what is poured leaves as a jet, and falls': async (browser) => {
        await open(browser, text('1_dam_break.yaml'));
        await browser.press('o');
        await browser.until('numbers().tool === 2');
        await browser.value(`(() => { // ten turns, the pointer held in a corner of the air; then it is let go and all rests
            const turn = (buttons) => sph2d._page_turn(0.016, canvas.width, canvas.height, 0.75 * canvas.width, 0.25 * canvas.height, buttons, 0, 0);
            for (let k = 0; k < 10; ++k) turn(1);
            key(' ');
            turn(0);
        })()`);
        const state = await liquid(browser), all = state.length / 4, gravity = 9.81, width = 0.24 * 0.9;
        const jet = Array.from({length: all}, (unused, k) => k).filter((k) => state[k] > 0.95 && state[all + k] > 0.3)
            .map((k) => ({x: state[k], y: state[all + k], down: -state[3 * all + k]}));
        const top = Math.max(...jet.map((p) => p.y)), across = jet.filter((p) => p.y > top - 0.05).map((p) => p.x);
        const wide = Math.max(...across) - Math.min(...across);
        assert(Math.abs(wide + 0.0093 - width) < 0.02, `${wide} m wide`);
        const energy = (p) => p.down ** 2 / 2 + gravity * p.y, first = gravity * (width / 2 + top);
        const mean = jet.reduce((sum, p) => sum + energy(p), 0) / jet.length, slowest = Math.min(...jet.map((p) => p.down));
        assert(jet.length > 100 && Math.abs(mean - first) < 0.04 * first, `${first} m^2/s^2 at first, ${mean} in the mean`);
        assert(slowest > 0.85 * Math.sqrt(gravity * width), `${slowest} m/s at least`);
        await pause(browser, false);
        await browser.press('p');
    },

    'walls stand where liquid is now; acts are undone; what leaves is told': async (browser) => {
        const walls = async () => ((await browser.value('ask("page_text")')).match(/polyline/g) || []).length;
        await open(browser, text('1_dam_break.yaml'));
        await browser.until('numbers().time > 0.8', 90); // the column has fallen
        await browser.press('w');
        await browser.until('numbers().tool === 4');
        await drag(browser, await Promise.all([[0.1, 0.2], [0.25, 0.35], [0.1, 0.5], [0.25, 0.2]].map(([x, y]) => at(browser, x, y))));
        await browser.until('ask("page_text").includes("polyline")');
        const drawn = await walls();
        assert(drawn > 1, 'a wall that turns sharply is several pieces');
        const place = await at(browser, 0.11, 0.21);
        await browser.mouse('mousePressed', ...place, {button: 'right', buttons: 2}); // shorter than a turn
        await browser.mouse('mouseReleased', ...place, {button: 'right'});
        await browser.until('!ask("page_text").includes("polyline")');
        await browser.value('document.querySelector("button[data-key=U]").click()');
        await browser.until('ask("page_text").includes("polyline")');
        assert.strictEqual(await walls(), drawn);
        const all = (({particles, left}) => particles + left)(await numbers(browser));
        await browser.press('p');
        await browser.press('ArrowUp');
        await browser.until('numbers().left > numbers().particles', 90);
        assert.strictEqual((({particles, left}) => particles + left)(await numbers(browser)), all);
        assert.match(await browser.value('element("numbers").textContent'), /particles, \d+ left/);
        await browser.value(`window.dispatchEvent(new KeyboardEvent('keydown', {key: 'z', ctrlKey: true}))`);
        await browser.until(`numbers().particles > ${all - 100}`);
        await browser.press('ArrowUp');
        await browser.until('numbers().left > numbers().particles', 90);
        await browser.press('r');
        await browser.until('numbers().left < 100 && numbers().steps < 100');
        assert.match(await browser.value('ask("page_text")'), /^(?!.*gravity: \[-?[\d.e-]+, 9)/s, "the scene's gravity");
    },

    'mouse: a body is held, a wheel is turned': async (browser) => {
        const body = (index) => browser.value(`Array.from(sph2d.HEAPF64.subarray(sph2d._page_body(${index}) / 8).slice(0, 3))`);
        const place = (...where) => sceneAt(browser, ...where);
        await open(browser, text('6_ship.yaml'));
        await browser.until('numbers().steps > 5');
        const before = await body(1);
        const path = [before, [0.35, 0.9], [0.4, 1], [0.45, 1.05], [0.45, 1.05], [0.45, 1.05], [0.45, 1.05]];
        await drag(browser, await Promise.all(path.map(([x, y]) => place(x, y, 2.4, 1.2))));
        const after = await body(1);
        assert(after[1] > before[1] + 0.1, `the crate is lifted: ${before} to ${after}`);
        await open(browser, text('7_water_wheel.yaml'));
        await browser.until('numbers().steps > 5');
        const angle = (await body(0))[2];
        await drag(browser, await Promise.all([0, 0.3, 0.6, 0.9, 1.2, 1.5].map((turn) =>
            place(1.1 + 0.1 * Math.sin(turn), 0.5 + 0.1 * Math.cos(turn), 2.2, 1.2))));
        assert((await body(0))[2] < angle - 0.1, `the wheel turns: ${angle} to ${(await body(0))[2]}`);
    },

    'bodies are drawn, held and let go': async (browser) => {
        const body = (index) => browser.value(`Array.from(sph2d.HEAPF64.subarray(sph2d._page_body(${index}) / 8).slice(0, 3))`);
        const count = async (word) => (await browser.value('ask("page_text")')).split(word).length - 1;
        const draw = async (tool, ...places) => {
            await browser.value(`tools[${tool}].click()`);
            await drag(browser, await Promise.all(places.map(([x, y]) => sceneAt(browser, x, y, 1.6, 0.9))));
            await sleep(200);
        };
        await open(browser, text('1_dam_break.yaml'));
        await browser.until('numbers().steps > 2');
        await pause(browser, true);
        await draw(5, [1.0, 0.6], [1.05, 0.6], [1.1, 0.6]);
        await draw(6, [1.2, 0.4], [1.25, 0.5], [1.4, 0.6]);
        await draw(7, [0.6, 0.2], [0.7, 0.15], [0.8, 0.2], [0.8, 0.3], [0.7, 0.35], [0.6, 0.3], [0.6, 0.22]);
        assert.strictEqual(await count('density: 500'), 3);
        await draw(5, [1.0, 0.6], [1.2, 0.6]);
        assert.match(await browser.value('told'), /no body: starts in bodies/);
        await draw(7, [0.2, 0.75], [0.5, 0.85], [0.5, 0.75], [0.2, 0.88]);
        assert.match(await browser.value('told'), /no body: a polygon must not cross/);
        await draw(5, [0.2, 0.2], [0.25, 0.2], [0.3, 0.2]);
        assert.match(await browser.value('told'), /took the place of \d{3} particles/);
        await draw(8, [1.3, 0.5]);
        await draw(8, [1.0, 0.6], [1.0, 0.7], [1.0, 0.8]);
        assert.strictEqual(await count('stiffness'), 2);
        await draw(0, [0.7, 0.25], [0.7, 0.4], [0.7, 0.6]); // moved while time stands still
        const moved = await body(2);
        assert(Math.abs(moved[1] - 0.61) < 0.03 && (await numbers(browser)).paused, `${moved} after it was moved up`);
        const held = await body(1), hung = await body(0);
        await pause(browser, false);
        await browser.until(`numbers().time > ${(await numbers(browser)).time} + 0.5`, 90);
        const after = [await body(0), await body(1), await body(2)];
        assert(Math.hypot(after[1][0] - held[0], after[1][1] - held[1]) < 0.02, `the box is held: ${held} to ${after[1]}`);
        assert(after[0][1] > hung[1] - 0.15, `the circle hangs: ${hung} to ${after[0]}`);
        assert(after[2][1] < moved[1] - 0.15, `what is not held falls: ${moved} to ${after[2]}`);
        await draw(8, [1.3, 0.5]);
        assert.strictEqual(await count('stiffness'), 1);
        await browser.press('p');
    },

    'the view is moved and scaled': async (browser) => {
        const box = async () => { // draws one on the screen, where it is in the scene
            await browser.value('tools[6].click()');
            await drag(browser, await Promise.all([[0.3, 0.2], [0.4, 0.25], [0.45, 0.35]].map(([x, y]) => at(browser, x, y))));
            await browser.until('ask("page_text").includes("bodies")');
            const [, least, most] = /bodies:\s+- box:\s+min: (.*)\s+max: (.*)/.exec(await browser.value('ask("page_text")'));
            await browser.press('u');
            await browser.until('!ask("page_text").includes("bodies")');
            return [JSON.parse(least), JSON.parse(most)];
        };
        const wide = ([least, most]) => most[0] - least[0], near = (a, b) => Math.abs(a / b - 1) < 0.02;
        await open(browser, text('1_dam_break.yaml'));
        await pause(browser, true);
        await browser.press('r');
        const first = await box(), place = await at(browser, 0.3, 0.2);
        for (let k = 0; k < 5; ++k)
            await browser.send('Input.dispatchMouseEvent', {type: 'mouseWheel', x: place[0], y: place[1], deltaX: 0, deltaY: -20, modifiers: 2});
        await sleep(300);
        const zoomed = await box();
        assert(near(wide(zoomed), wide(first) / 1.1 ** 5), `${first} and ${zoomed}`);
        assert(near(zoomed[0][0], first[0][0]), 'the place at the mouse stays');
        const pan = await Promise.all([[0.5, 0.5], [0.5, 0.5], [0.6, 0.5], [0.6, 0.5]].map(([x, y]) => at(browser, x, y)));
        await drag(browser, pan, 'middle');
        const moved = await box();
        assert(near(zoomed[0][0] - moved[0][0], wide(zoomed) * 0.1 / 0.15), `${zoomed} and ${moved}`);
        await browser.press('Home');
        await sleep(300);
        assert(near(wide(await box()), wide(first)), 'Home shows all');
        const [x, y] = await at(browser, 0.4, 0.5), fingers = (apart) => [[x - apart, y], [x + apart, y]];
        await browser.touch('touchStart', fingers(50));
        await browser.touch('touchMove', fingers(75));
        await browser.touch('touchMove', fingers(100));
        await sleep(300);
        await browser.touch('touchEnd', []);
        assert(near(wide(await box()), wide(first) / 2), 'two fingers zoom');
        await browser.press('Home');
        await browser.press('p');
        await pause(browser, false);
    },

    'touch: a finger pours': async (browser) => {
        await open(browser, text('1_dam_break.yaml'));
        await browser.press('o');
        await browser.until('numbers().tool === 2');
        const before = await numbers(browser), place = await at(browser, 0.75, 0.3);
        await browser.touch('touchStart', [place]);
        await sleep(400);
        await browser.touch('touchEnd', []);
        assert((await numbers(browser)).particles > before.particles + 5, 'liquid is poured');
        await browser.press('p');
    },

    'keys and sliders': async (browser) => {
        await open(browser, text('1_dam_break.yaml'));
        await pause(browser, true);
        const from = (await numbers(browser)).steps;
        await browser.press('.');
        await browser.until(`numbers().steps === ${from + 1}`);
        await pause(browser, false);
        await browser.press('ArrowRight');
        await browser.until('/gravity: ?\\[9.8/.test(ask("page_text"))');
        await browser.value('sliders.viscosity.input.value = 1; sliders.viscosity.input.onchange()');
        await browser.until('Math.abs(numbers().viscosity - 10) < 1e-9');
        await browser.press('3');
        await browser.until('editor.text.value.includes("drop falls")');
        const all = await browser.value('sph2d._page_scene_count()');
        for (let k = 1; k <= all; ++k) {
            await browser.press(k < 10 ? String(k) : 'PageDown');
            await browser.until(`numbers().steps > 3 && !numbers().stopped && element('scenes').selectedIndex === ${k - 1}`, 60);
            assert.strictEqual(await browser.value('element("verdict").textContent'), 'no errors');
            await browser.picture(path.join(folder, `scene_${k}.png`));
        }
    },

    'the editor tells faults beside their lines': async (browser) => {
        await browser.value(`element('edit').click(); editor.set("spacing: 0.01\\nspacin: 3\\ndomain: {min: [0, 0], max: [1, 1]}")`);
        const told = await browser.value('element("messages").textContent');
        assert.match(told, /line 2: spacin/);
        assert.match(await browser.value('element("lines").querySelector("b").textContent'), /^2/);
        const time = (await numbers(browser)).time;
        await browser.value('element("run").click()');
        await browser.until(`numbers().time > ${time}`); // the game goes on
        await browser.value(`editor.set(${JSON.stringify(text('3_drop.yaml'))}); element('run').click()`);
        assert.strictEqual(await browser.value('element("verdict").textContent'), 'no errors');
        await browser.value(`editor.set('start: {snapshot: nowhere.h5}\\n' + ${JSON.stringify(text('3_drop.yaml'))})`);
        assert.match(await browser.value('element("messages").textContent'), /snapshot/);
        for (const nonsense of ['', '{', '\0\u00ff', '[[[[', 'a: &b [*b]', 'spacing: 1e-300'])
            assert.match(await browser.value(`editor.set(${JSON.stringify(nonsense)}); element("verdict").textContent`), /error/);
        await browser.value('element("edit").click()');
    },

    'a link carries the scene': async (browser) => {
        const scene = text('2_two_dams.yaml').replace('two dams', 'zwei Dämme');
        await browser.value(`editor.set(${JSON.stringify(scene)}); copyLink()`);
        await browser.until('/^#scene=./.test(location.hash)');
        await browser.send('Page.reload');
        await sleep(500);
        await browser.until(`editor.text.value === ${JSON.stringify(scene)} && numbers().particles > 0`);
        assert.strictEqual(await browser.value('document.title'), 'zwei Dämme - sph2d');
        assert.strictEqual(await browser.value('element("scenes").selectedOptions[0].textContent'), 'zwei Dämme');
        await browser.value('location.hash = "#scene=%%%"');
        await browser.send('Page.reload');
        await sleep(500);
        await browser.until('editor.text.value.includes("column of water") && numbers().particles > 0');
    },

    'scenes are kept in the browser': async (browser) => {
        const saved = () => browser.value('Array.from(element("saved").children, (row) => row.firstChild.textContent)');
        await open(browser, text('3_drop.yaml'));
        await browser.value('element("save").click()');
        for (const name of ['my drop', '<b>&"']) {
            await browser.value(`element('name').value = ${JSON.stringify(name)}; element('keep').requestSubmit()`);
            await open(browser, text('2_two_dams.yaml'));
        }
        await browser.send('Page.reload');
        await sleep(500);
        await browser.until('numbers().particles > 0');
        await browser.value('element("save").click()');
        assert.deepStrictEqual(await saved(), ['<b>&"', 'my drop']);
        await browser.value('element("saved").children[1].firstChild.click()');
        assert.strictEqual(await browser.value('document.title'), 'my drop - sph2d');
        assert.match(await browser.value('ask("page_text")'), /name: drop/);
        await browser.value('element("saved").children[1].lastChild.click()');
        assert.deepStrictEqual(await saved(), ['<b>&"']);
        await browser.value('element("saved").children[0].lastChild.click()');
        await browser.value('element("save").click()');
    },

    'on a phone buttons are as large as fingers': async (browser) => {
        const size = (width, height, mobile) =>
            browser.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile});
        await size(390, 844, true);
        await open(browser, text('1_dam_break.yaml'));
        for (const section of [null, 'save', 'more', 'edit']) {
            if (section) await browser.value(`element('${section}').click()`);
            await sleep(300);
            const small = await browser.value(`Array.from(document.querySelectorAll('button, select, input'), (item) => {
                const box = item.getBoundingClientRect();
                return [item.textContent || item.id, box.width, box.height];
            }).filter(([name, width, height]) => width > 0 && (width < 44 || height < 44))`);
            assert.deepStrictEqual(small, []);
            assert(await browser.value('document.documentElement.scrollWidth') <= 390, 'the page does not scroll aside');
            assert(await browser.value('element("stage").getBoundingClientRect().height') > 200, 'the liquid has room');
            await browser.picture(path.join(folder, `phone_${section || 'page'}.png`));
            if (section) await browser.value(`element('${section}').click()`);
        }
        const tops = await browser.value('tools.map((button) => button.getBoundingClientRect().top)');
        assert.strictEqual(new Set(tops).size, 1, 'tools are one row');
        await browser.value('tools[tools.length - 1].scrollIntoView()');
        assert(await browser.value('tools[tools.length - 1].getBoundingClientRect().right') <= 390, 'all can be reached');
        await size(1000, 640, false);
        await sleep(300);
    },

    // As in browsers that add up half floats alone, or none.
    'with half floats the picture is the same, without floats there is a sentence': async (browser) => {
        await browser.send('Page.addScriptToEvaluateOnNewDocument', {source: `
            const all = WebGL2RenderingContext.prototype.getSupportedExtensions;
            WebGL2RenderingContext.prototype.getSupportedExtensions = function () { // without those that window.name matches
                return all.call(this).filter((name) => !window.name || !name.match(window.name));
            };`});
        const shown = async (lacking) => {
            await browser.value(`window.name = '${lacking}'`);
            await browser.send('Page.reload');
            await sleep(500);
            await browser.until('element("trouble").textContent !== "" || numbers().particles > 0');
            const trouble = await browser.value('element("trouble").textContent');
            if (trouble) return trouble;
            await pause(browser, true);
            await browser.press('r');
            await browser.until('numbers().steps === 0');
            await sleep(300);
            const data = await browser.value('canvas.toDataURL("image/png")');
            return readPng(Buffer.from(data.slice(data.indexOf(',') + 1), 'base64'));
        };
        const whole = await shown(''), half = await shown('float_blend|float_linear');
        const {mean: level, far} = compare(whole, half);
        console.log(`    differs by ${level.toFixed(3)} levels in the mean, by over 16 in ${(100 * far).toFixed(3)} % of pixels`);
        assert(level < 1 && far < 0.01, 'the pictures are alike');
        assert.match(await shown('color_buffer'), /EXT_color_buffer_float/);
        await shown('');
    },

    // But for what takes powers, sines and cosines from the C library: walls of method muller, and bodies that turn.
    'the state after 100 steps has the bits of the native baseline': async (browser) => {
        const dam = text('1_dam_break.yaml'), file = path.join(folder, 'scene.yaml');
        const coarse = dam.replace(/^spacing:.*$/m, 'spacing: 0.015');
        const by = (method) => coarse.replace(/^method:.*$/m, `method: {name: ${method}}`);
        const variants = [['hybrid', dam, 0], ['constraint', by('constraint'), 0],
            ['constraint, tension', text('9_drops.yaml'), 0], ['wcsph', by('wcsph'), 0],
            ['pcisph', by('pcisph'), 0], ['muller', by('muller'), 1e-11]];
        await pause(browser, true);
        for (const [name, scene, allowed] of variants) {
            fs.writeFileSync(file, scene);
            await open(browser, scene);
            await steps(browser, 100);
            assert.strictEqual((await numbers(browser)).steps, 100);
            const here = await liquid(browser), bytes = execFileSync(stateProgram, [file, '100'], {maxBuffer: 1 << 26});
            const native = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
            assert.strictEqual(here.length, native.length, name);
            const far = here.reduce((most, value, k) => Math.max(most, Math.abs(value - native[k])), 0);
            const same = Buffer.compare(Buffer.from(here.buffer), bytes) === 0;
            console.log(`    ${name}: ${here.length / 4} particles, ${same ? 'the same bits' : `differ by ${far}`}`);
            assert(allowed === 0 ? same : far <= allowed, name);
        }
        await pause(browser, false);
    },

    '4,000 particles: times of steps and pictures': async (browser) => {
        await open(browser, text('1_dam_break.yaml').replace(/spacing:.*/, 'spacing: 0.0093'));
        await sleep(8000);
        const {particles, stepping, drawing, pictures, pace, steps: count, time} = await numbers(browser);
        await pause(browser, true);
        const [step, frame] = await browser.value(`(() => {
            const one = (count, act) => {
                const begun = performance.now();
                for (let k = 0; k < count; ++k) act();
                return (performance.now() - begun) / count;
            };
            const pixel = new Uint8Array(4), gl = canvas.getContext('webgl2');
            return [one(40, () => { key('.'); sph2d._page_turn(0, 0, 0, 0, 0, 0, 0, 0); }),
                one(10, () => {
                    sph2d._page_turn(0, canvas.width, canvas.height, 0, 0, 0, 0, 0);
                    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
                })];
        })()`);
        const size = await browser.value('canvas.width + " x " + canvas.height');
        const line = `${particles} particles, ${size}: ${step.toFixed(2)} ms a step, ${frame.toFixed(1)} ms a picture; in play ` +
            `${pictures.toFixed(0)} pictures/s at ${pace.toFixed(2)} of the clock, step of ${(1e3 * time / count).toFixed(2)} ms ` +
            `(turns: ${(1e3 * stepping).toFixed(1)} ms steps, ${(1e3 * drawing).toFixed(1)} ms drawing calls)`;
        console.log(`    ${line}`);
        fs.writeFileSync(path.join(folder, 'times.txt'), line + '\n');
        assert(particles > 3900 && step < 100 && frame < 1000);
        await pause(browser, false);
    },
};

async function main() {
    fs.mkdirSync(folder, {recursive: true});
    const browser = await Browser.open(process.env.CHROMIUM || 'chromium', address, 1000, 640);
    let failed = 0;
    try {
        await browser.until('numbers().particles > 0');
        for (const [name, test] of Object.entries(tests)) {
            if (process.env.ONLY && !name.includes(process.env.ONLY)) continue;
            const begun = Date.now();
            try {
                await test(browser);
                assert.deepStrictEqual(browser.errors, []);
                console.log(`ok   web: ${name} (${((Date.now() - begun) / 1000).toFixed(1)} s)`);
            } catch (error) {
                ++failed;
                console.log(`FAIL web: ${name}: ${error.stack}`);
                browser.errors.length = 0;
                await browser.picture(path.join(folder, 'failed.png'));
            }
        }
    } finally {
        await browser.close();
    }
    return failed;
}

main().then((failed) => process.exit(failed > 0 ? 1 : 0), (error) => {
    console.error(error);
    process.exit(1);
});
