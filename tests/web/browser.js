// browser.js: a headless Chromium by its debugging pipe (DevTools protocol), for the test of the page.
'use strict';
const {spawn} = require('child_process'), fs = require('fs'), os = require('os'), path = require('path');

class Browser {
    // Opens a page of this size; `program` is Chromium.
    static async open(program, address, width, height) {
        const browser = new Browser();
        browser.folder = fs.mkdtempSync(path.join(os.tmpdir(), 'sph2d-web-'));
        browser.process = spawn(program, ['--headless=new', '--no-sandbox', '--remote-debugging-pipe',
            '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage',
            '--no-first-run', `--user-data-dir=${browser.folder}`, `--window-size=${width},${height}`, 'about:blank'],
            {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], env: {...process.env, HOME: browser.folder}});
        browser.next = 1;
        browser.waiting = new Map();
        browser.errors = [];
        let rest = '';
        browser.process.stdio[4].on('data', (data) => {
            const texts = (rest + data).split('\0');
            rest = texts.pop();
            texts.forEach((text) => browser.take(JSON.parse(text)));
        });
        browser.process.on('exit', () => {
            browser.waiting.forEach((reply) => reply.reject(new Error('the browser ended')));
        });
        const {targetInfos} = await browser.send('Target.getTargets');
        const page = targetInfos.find((target) => target.type === 'page');
        const {sessionId} = await browser.send('Target.attachToTarget', {targetId: page.targetId, flatten: true});
        browser.session = sessionId;
        await browser.send('Runtime.enable');
        await browser.send('Page.enable');
        await browser.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: false});
        await browser.send('Page.navigate', {url: address});
        return browser;
    }

    take(message) {
        if (message.method === 'Runtime.exceptionThrown') {
            const details = message.params.exceptionDetails;
            this.errors.push(details.exception ? details.exception.description : details.text);
        }
        if (message.method === 'Runtime.consoleAPICalled' && message.params.type === 'error')
            this.errors.push(message.params.args.map((item) => item.value).join(' '));
        const reply = this.waiting.get(message.id);
        if (!reply) return;
        this.waiting.delete(message.id);
        if (message.error) reply.reject(new Error(message.error.message));
        else reply.resolve(message.result);
    }

    send(method, params = {}) {
        const message = {id: this.next++, method, params};
        if (this.session) message.sessionId = this.session;
        this.process.stdio[3].write(JSON.stringify(message) + '\0');
        return new Promise((resolve, reject) => this.waiting.set(message.id, {resolve, reject}));
    }

    // The value of an expression on the page, also of a promise.
    async value(expression) {
        const answer = await this.send('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
        if (answer.exceptionDetails)
            throw new Error(answer.exceptionDetails.exception.description || answer.exceptionDetails.text);
        return answer.result.value;
    }

    // Waits until an expression is true.
    async until(expression, seconds = 30) {
        const end = Date.now() + 1000 * seconds;
        while (!await this.value(`(() => { try { return Boolean(${expression}); } catch (e) { return false; } })()`)) {
            if (Date.now() > end) throw new Error(`after ${seconds} s it is not so: ${expression}`);
            await sleep(50);
        }
    }

    mouse(type, x, y, more = {}) {
        return this.send('Input.dispatchMouseEvent', {type, x, y, button: 'left', clickCount: 1, ...more});
    }

    touch(type, points) {
        return this.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y]) => ({x, y}))});
    }

    async press(key) {
        await this.send('Input.dispatchKeyEvent', {type: 'keyDown', key, text: key.length === 1 ? key : undefined});
        await this.send('Input.dispatchKeyEvent', {type: 'keyUp', key});
    }

    async picture(file) {
        const {data} = await this.send('Page.captureScreenshot', {format: 'png'});
        fs.writeFileSync(file, Buffer.from(data, 'base64'));
    }

    async close() {
        const ended = new Promise((resolve) => this.process.once('exit', resolve));
        this.process.kill();
        await ended;
        fs.rmSync(this.folder, {recursive: true, force: true, maxRetries: 5});
    }
}

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

module.exports = {Browser, sleep};
