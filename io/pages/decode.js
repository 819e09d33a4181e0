// SPDX-License-Identifier: MIT
// The numbers of a page: base64, deflate, and the coding of io/pages/page_data.h.

function bytesOfBase64(text) {
    const raw = atob(text);
    const bytes = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; ++i)
        bytes[i] = raw.charCodeAt(i);
    return bytes;
}

async function inflated(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The four bytes of each number, which stand far from each other. */
function wordsOf(bytes, at, count) {
    const words = new Uint32Array(count);
    for (let i = 0; i < count; ++i)
        words[i] = bytes[at + i] | bytes[at + count + i] << 8 | bytes[at + 2 * count + i] << 16 |
            bytes[at + 3 * count + i] << 24;
    return words;
}

/** As many numbers, each by its place, without the iterator of `from`. */
function made(Numbers, count, number) {
    const result = new Numbers(count);
    for (let i = 0; i < count; ++i)
        result[i] = number(i);
    return result;
}

/** Of vectors in space, one after the other. */
function vectorAt(numbers, i) {
    return [numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]];
}

/** The least and the largest of as many numbers, each by its place; without those that are none. */
function rangeOf(count, number) {
    let low = Infinity, high = -Infinity;
    for (let i = 0; i < count; ++i) {
        const x = number(i);
        low = x < low ? x : low;
        high = x > high ? x : high;
    }
    return [low, high];
}

/** From differences with the row before. */
function sums(words, width) {
    const numbers = new Int32Array(words.buffer);
    for (let i = 0; i < words.length; ++i) {
        const difference = words[i] >>> 1 ^ -(words[i] & 1);
        numbers[i] = (i < width ? 0 : numbers[i - width]) + difference;
    }
    return numbers;
}

/** An array that the header's directory tells of: Int32Array or Float64Array. */
function arrayOf(bytes, entry) {
    const words = wordsOf(bytes, entry.at, entry.count);
    if (entry.kind === "whole")
        return sums(words, entry.width);
    const {low, step, width} = entry;
    if (entry.kind === "rounded") {
        const steps = sums(words, width);
        return made(Float64Array, entry.count, i => low + step * steps[i]);
    }
    // in two steps, since the power itself may be no number
    const half = 2 ** Math.trunc(entry.exponent / 2), rest = 2 ** (entry.exponent -
        Math.trunc(entry.exponent / 2));
    const floats = new Float32Array(words.buffer);
    return made(Float64Array, entry.count, i => floats[i] * half * rest);
}

/** All arrays by name. */
async function readArrays(header, text) {
    const bytes = await inflated(bytesOfBase64(text));
    const arrays = {};
    for (const [name, entry] of Object.entries(header.arrays))
        arrays[name] = arrayOf(bytes, entry);
    return arrays;
}
