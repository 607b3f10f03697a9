// The scene's text, with what is wrong with it beside its lines; and links that carry it.
const editor = {
    box: document.getElementById('editor'),
    text: document.getElementById('text'),
    lines: document.getElementById('lines'),
    messages: document.getElementById('messages'),
    verdict: document.getElementById('verdict'),

    // Shows messages, {ok, messages: [{line, severity, message, hint}]}, and marks their lines.
    show(result) {
        this.messages.replaceChildren(...result.messages.map((m) => {
            const item = document.createElement('li');
            item.className = m.severity;
            item.textContent = (m.line ? `line ${m.line}: ` : '') + (m.path ? `${m.path}: ` : '') + m.message;
            if (m.hint) item.appendChild(Object.assign(document.createElement('small'), {textContent: m.hint}));
            if (m.line) item.onclick = () => this.jump(m.line);
            return item;
        }));
        const errors = result.messages.filter((m) => m.severity === 'error').length;
        this.verdict.textContent = result.ok ? 'no errors' : `${errors} error${errors === 1 ? '' : 's'}`;
        const worst = new Map();
        for (const m of result.messages)
            if (worst.get(m.line) !== 'error') worst.set(m.line, m.severity);
        const rows = this.text.value.split('\n').map((unused, k) => {
            const mark = {error: 'b', warning: 'i'}[worst.get(k + 1)] || 'span';
            return Object.assign(document.createElement(mark), {textContent: `${k + 1}\n`});
        });
        this.lines.replaceChildren(...rows);
        this.follow();
    },

    follow() {
        this.lines.scrollTop = this.text.scrollTop;
    },

    jump(line) {
        const starts = this.text.value.split('\n').slice(0, line);
        const end = starts.join('\n').length;
        this.text.focus();
        this.text.setSelectionRange(end - starts[starts.length - 1].length, end);
    },

    set(text) {
        this.text.value = text;
        this.check();
    },

    check() {
        this.show(JSON.parse(ask('page_check', this.text.value, 'scene')));
    },

    start(run) {
        let waiting = 0;
        this.text.addEventListener('input', () => {
            clearTimeout(waiting);
            waiting = setTimeout(() => this.check(), 250);
        });
        this.text.addEventListener('scroll', () => this.follow());
        this.text.addEventListener('keydown', (event) => {
            if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) run();
        });
        document.getElementById('run').onclick = run;
    },
};

// The text in the address after #, compressed: as long as the scene has no file names, it is the whole scene.
const links = {
    async pack(text) {
        const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
        const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
        return btoa(String.fromCharCode(...bytes)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
    },

    async unpack(packed) {
        const bytes = Uint8Array.from(atob(packed.replace(/-/g, '+').replace(/_/g, '/')), (c) => c.charCodeAt(0));
        const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
        return new Response(stream).text();
    },

    // The scene of the address, or null.
    async read() {
        const match = /^#scene=(.+)$/.exec(location.hash);
        if (!match) return null;
        try {
            return await this.unpack(match[1]);
        } catch (error) {
            return null;
        }
    },
};
