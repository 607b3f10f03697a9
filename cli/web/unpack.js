// Unpacks the page: text of 91 characters (basE91, with - in place of <), then LZMA, as xz --format=lzma writes it
// (LZMA specification, I. Pavlov 2015; basE91, J. Henke 2006). A third smaller than gzip in base64, which browsers know.
function fromText(text) {
    const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789!#$%&()*+,./:;-=>?@[]^_`{|}~"';
    const value = new Int32Array(128).fill(-1);
    for (let k = 0; k < 91; ++k) value[alphabet.charCodeAt(k)] = k;
    const out = new Uint8Array(Math.ceil(text.length * 7 / 8));
    let count = 0, first = -1, bits = 0, held = 0;
    for (let k = 0; k < text.length; ++k) {
        const v = value[text.charCodeAt(k)];
        if (v < 0) continue; // a line's end
        if (first < 0) {
            first = v;
            continue;
        }
        const pair = first + 91 * v;
        held |= pair << bits;
        bits += (pair & 8191) > 88 ? 13 : 14;
        for (; bits > 7; bits -= 8, held >>>= 8) out[count++] = held & 255;
        first = -1;
    }
    if (first >= 0) out[count++] = (held | first << bits) & 255;
    return out.subarray(0, count);
}

// The range coder: bits by adaptive probabilities, trees of them, and bits of equal chance.
function rangeDecoder(bytes, start) {
    let at = start + 5, range = 0xFFFFFFFF, code = 0;
    for (let k = 1; k < 5; ++k) code = (code << 8 | bytes[start + k]) >>> 0;
    const normalize = () => {
        if (range < 0x1000000) {
            range = (range << 8) >>> 0;
            code = (code << 8 | bytes[at++]) >>> 0;
        }
    };
    const bit = (chances, index) => {
        const chance = chances[index], bound = (range >>> 11) * chance;
        const one = code >= bound ? 1 : 0;
        if (one) {
            range -= bound;
            code -= bound;
            chances[index] = chance - (chance >>> 5);
        } else {
            range = bound;
            chances[index] = chance + ((2048 - chance) >>> 5);
        }
        normalize();
        return one;
    };
    const direct = (count) => {
        let value = 0;
        for (; count > 0; --count) {
            range >>>= 1;
            const one = code >= range ? 1 : 0;
            if (one) code -= range;
            normalize();
            value = value * 2 + one;
        }
        return value;
    };
    const tree = (chances, from, bits) => {
        let node = 1;
        for (let k = 0; k < bits; ++k) node = node * 2 + bit(chances, from + node);
        return node - (1 << bits);
    };
    const reverse = (chances, from, bits) => {
        let node = 1, value = 0;
        for (let k = 0; k < bits; ++k) {
            const one = bit(chances, from + node);
            node = node * 2 + one;
            value |= one << k;
        }
        return value;
    };
    return {bit, direct, tree, reverse};
}

function unlzma(bytes) {
    const chances = (count) => new Uint16Array(count).fill(1024);
    const lc = bytes[0] % 9, lp = Math.floor(bytes[0] / 9) % 5, pb = Math.floor(bytes[0] / 45);
    let size = 0;
    for (let k = 0; k < 4; ++k) size += bytes[5 + k] * 2 ** (8 * k); // all ones: until the end mark
    const out = new Uint8Array(size < 0xFFFFFFFF ? size : 1 << 24);
    const decoder = rangeDecoder(bytes, 13), {bit, direct, tree, reverse} = decoder;
    const literal = chances(0x300 << (lc + lp));
    const isMatch = chances(12 << 4), isRep = chances(12), isRep0 = chances(12), isRep1 = chances(12),
        isRep2 = chances(12), isLong = chances(12 << 4);
    const slots = chances(4 << 6), special = chances(128), align = chances(16);
    const lengths = () => ({choice: chances(2), low: chances(16 << 3), mid: chances(16 << 3), high: chances(256)});
    const matchLengths = lengths(), repLengths = lengths();
    const length = (from, place) => {
        if (!bit(from.choice, 0)) return 2 + tree(from.low, place << 3, 3);
        if (!bit(from.choice, 1)) return 10 + tree(from.mid, place << 3, 3);
        return 18 + tree(from.high, 0, 8);
    };
    const distance = (len) => {
        const slot = tree(slots, Math.min(len - 2, 3) << 6, 6);
        if (slot < 4) return slot;
        const bits = (slot >> 1) - 1, high = (2 | slot & 1) * 2 ** bits;
        if (slot < 14) return high + reverse(special, high - slot, bits);
        return high + direct(bits - 4) * 16 + reverse(align, 0, 4);
    };
    let state = 0, count = 0, rep0 = 0, rep1 = 0, rep2 = 0, rep3 = 0;
    while (count < out.length) {
        const place = count & ((1 << pb) - 1), at = (state << 4) + place;
        if (!bit(isMatch, at)) {
            const before = count > 0 ? out[count - 1] : 0;
            const from = 0x300 * (((count & ((1 << lp) - 1)) << lc) + (before >> (8 - lc)));
            let node = 1;
            if (state >= 7) {
                let match = out[count - rep0 - 1];
                while (node < 0x100) {
                    const expected = match >> 7 & 1;
                    match <<= 1;
                    const one = bit(literal, from + ((1 + expected) << 8) + node);
                    node = node * 2 + one;
                    if (one !== expected) break;
                }
            }
            while (node < 0x100) node = node * 2 + bit(literal, from + node);
            out[count++] = node & 255;
            state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
            continue;
        }
        let len;
        if (!bit(isRep, state)) {
            rep3 = rep2;
            rep2 = rep1;
            rep1 = rep0;
            len = length(matchLengths, place);
            state = state < 7 ? 7 : 10;
            rep0 = distance(len);
            if (rep0 === 0xFFFFFFFF) break; // the end mark
        } else {
            if (!bit(isRep0, state)) {
                if (!bit(isLong, at)) {
                    state = state < 7 ? 9 : 11;
                    out[count] = out[count - rep0 - 1];
                    ++count;
                    continue;
                }
            } else {
                let far;
                if (!bit(isRep1, state)) {
                    far = rep1;
                } else {
                    if (!bit(isRep2, state)) {
                        far = rep2;
                    } else {
                        far = rep3;
                        rep3 = rep2;
                    }
                    rep2 = rep1;
                }
                rep1 = rep0;
                rep0 = far;
            }
            len = length(repLengths, place);
            state = state < 7 ? 8 : 11;
        }
        for (; len > 0; --len, ++count) out[count] = out[count - rep0 - 1];
    }
    return out.subarray(0, count);
}

// The parts of the page by name: {"wasm": bytes, "module": bytes, ...}, in the order of a first line of JSON.
function unpackPage(text) {
    const bytes = unlzma(fromText(text)), end = bytes.indexOf(10);
    const parts = {};
    let at = end + 1;
    for (const [name, size] of JSON.parse(new TextDecoder().decode(bytes.subarray(0, end)))) {
        parts[name] = bytes.subarray(at, at + size);
        at += size;
    }
    return parts;
}
