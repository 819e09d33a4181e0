// SPDX-License-Identifier: MIT
// Raw deflate (RFC 1951) for browsers that have no DecompressionStream.

class Bits {
    constructor(bytes) {
        this.bytes = bytes;
        this.at = 0;
        this.kept = 0;
        this.count = 0;
    }

    take(n) {
        while (this.count < n) {
            this.kept |= this.bytes[this.at++] << this.count;
            this.count += 8;
        }
        const value = this.kept & (1 << n) - 1;
        this.kept >>>= n;
        this.count -= n;
        return value;
    }

    /** Goes on at a whole byte. */
    align() {
        this.kept = this.count = 0;
    }
}

/** How many codes there are of each length, and the symbols in the order of their codes. */
function codeOf(lengths) {
    const counts = new Uint16Array(16), begins = new Uint16Array(16);
    for (const length of lengths)
        ++counts[length];
    counts[0] = 0;
    for (let i = 1; i < 16; ++i)
        begins[i] = begins[i - 1] + counts[i - 1];
    const symbols = new Uint16Array(lengths.length);
    lengths.forEach((length, symbol) => {
        if (length)
            symbols[begins[length]++] = symbol;
    });
    return {counts, symbols};
}

function symbolOf(bits, {counts, symbols}) {
    let code = 0, first = 0, index = 0;
    for (let length = 1; length < 16; ++length) {
        code |= bits.take(1);
        if (code - counts[length] < first)
            return symbols[index + code - first];
        index += counts[length];
        first = first + counts[length] << 1;
        code <<= 1;
    }
    throw new Error("the data of this page are damaged");
}

/** The smallest values of symbols that take more bits, and how many. */
function ranges(first, bits) {
    const begins = [];
    for (const n of bits) {
        begins.push(first);
        first += 1 << n;
    }
    return {begins, bits};
}
const lengthBits = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5];
const lengthRanges = ranges(3, lengthBits);
lengthRanges.begins.push(258);
lengthRanges.bits.push(0);
const distanceRanges = ranges(1, Array.from({length: 30}, (_, i) => Math.max(0, (i >> 1) - 1)));

function fixedCodes() {
    const lengths = Array.from({length: 288}, (_, i) => i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8);
    return [codeOf(lengths), codeOf(new Array(30).fill(5))];
}

function dynamicCodes(bits) {
    const literals = bits.take(5) + 257, distances = bits.take(5) + 1, count = bits.take(4) + 4;
    const order = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
    const own = new Array(19).fill(0);
    for (let i = 0; i < count; ++i)
        own[order[i]] = bits.take(3);
    const code = codeOf(own), lengths = [];
    while (lengths.length < literals + distances) {
        const symbol = symbolOf(bits, code);
        const repeated = symbol === 16 ? lengths[lengths.length - 1] : 0;
        const times = symbol < 16 ? 1 : symbol === 16 ? 3 + bits.take(2)
            : symbol === 17 ? 3 + bits.take(3) : 11 + bits.take(7);
        for (let i = 0; i < times; ++i)
            lengths.push(symbol < 16 ? symbol : repeated);
    }
    return [codeOf(lengths.slice(0, literals)), codeOf(lengths.slice(literals))];
}

function inflate(bytes) {
    const bits = new Bits(bytes);
    let out = new Uint8Array(8 * bytes.length + 1024), size = 0;
    const room = more => {
        if (size + more > out.length) {
            const larger = new Uint8Array(2 * (size + more));
            larger.set(out);
            out = larger;
        }
    };
    for (let last = 0; !last;) {
        last = bits.take(1);
        const kind = bits.take(2);
        if (kind === 0) {
            bits.align();
            const length = bits.take(8) | bits.take(8) << 8;
            bits.at += 2;
            room(length);
            out.set(bytes.subarray(bits.at, bits.at += length), size);
            size += length;
            continue;
        }
        const [literals, distances] = kind === 1 ? fixedCodes() : dynamicCodes(bits);
        for (let symbol; (symbol = symbolOf(bits, literals)) !== 256;) {
            room(258);
            if (symbol < 256) {
                out[size++] = symbol;
                continue;
            }
            const length = lengthRanges.begins[symbol - 257] +
                bits.take(lengthRanges.bits[symbol - 257]);
            const far = symbolOf(bits, distances);
            const distance = distanceRanges.begins[far] + bits.take(distanceRanges.bits[far]);
            for (let i = 0; i < length; ++i, ++size)
                out[size] = out[size - distance];
        }
    }
    return out.subarray(0, size);
}
