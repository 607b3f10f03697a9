// assemble.js OUT MODULE: packs MODULE.wasm, MODULE.js and page*.js, and writes one HTML file that unpacks them.
'use strict';
const fs = require('fs'), path = require('path'), {execFileSync} = require('child_process');
const [out, name] = process.argv.slice(2);
const read = (file) => fs.readFileSync(path.join(__dirname, file));

// basE91, with - in place of <, which could end a script.
function toText(bytes) {
    const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789!#$%&()*+,./:;-=>?@[]^_`{|}~"';
    let text = '', held = 0, bits = 0;
    for (const byte of bytes) {
        held |= byte << bits;
        bits += 8;
        if (bits <= 13) continue;
        const short = (held & 8191) > 88;
        const pair = held & (short ? 8191 : 16383);
        held >>= short ? 13 : 14;
        bits -= short ? 13 : 14;
        text += alphabet[pair % 91] + alphabet[Math.floor(pair / 91)];
    }
    if (bits > 0) {
        text += alphabet[held % 91];
        if (bits > 7 || held > 90) text += alphabet[Math.floor(held / 91)];
    }
    return text;
}

// Scripts lose their comments and what stands before and behind a line; the sources stay readable.
const squeeze = (text) => text.split('\n').map((line) => line.trim()).filter((line) => line && !line.startsWith('//')).join('\n');
const scripts = fs.readdirSync(__dirname).filter((file) => /^page.*\.js$/.test(file)).sort().map((file) => read(file));
const parts = {
    wasm: fs.readFileSync(name + '.wasm'),
    module: fs.readFileSync(name + '.js'),
    page: Buffer.from(squeeze(Buffer.concat(scripts).toString())),
};
const first = JSON.stringify(Object.entries(parts).map(([part, bytes]) => [part, bytes.length])) + '\n';
const packed = execFileSync('xz', ['--format=lzma', '--lzma1=preset=9e,lc=4,lp=0,pb=0', '--stdout'],
    {input: Buffer.concat([Buffer.from(first), ...Object.values(parts)]), maxBuffer: 1 << 26});
const fill = {STYLE: squeeze(read('page.css').toString()), PACKED: toText(packed), UNPACK: squeeze(read('unpack.js').toString())};
const page = read('index.html').toString().replace(/\{\{(\w+)\}\}/g, (all, key) => fill[key]);
fs.writeFileSync(out + '.part', page);
fs.renameSync(out + '.part', out);
console.log(`  ${out}: ${Math.ceil(fs.statSync(out).size / 1000)} kB`);
