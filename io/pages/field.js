// SPDX-License-Identifier: MIT
// Values, their range and their colors.

/** As many digits as are known, without zeros behind them. */
function numberText(value, digits = 7) {
    if (value === 0)
        return "0";
    const text = value.toPrecision(digits);
    return text.includes("e") ? text.replace(/\.?0+e/, "e")
        : text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/** Times with so few digits that each is off by at most a twentieth of the shortest step. */
function timeTexts(texts) {
    const times = texts.map(Number), largest = Math.max(...times.map(Math.abs));
    if (!Number.isFinite(largest) || largest === 0)
        return texts;
    const steps = times.slice(1).map((time, i) => Math.abs(time - times[i])).filter(step => step > 0);
    const most = Math.min(largest, ...steps) / 20;
    let power = Math.floor(Math.log10(largest));
    const rounded = time => Math.round(time / 10 ** power) * 10 ** power;
    while (10 ** power > 1e-12 * largest && times.some(time => Math.abs(time - rounded(time)) > most))
        --power;
    return times.map(time => numberText(rounded(time), 12));
}

/** Of each vector its length; of numbers these. */
function lengths(numbers, components) {
    return components === 1 ? new Float64Array(numbers) : made(Float64Array, numbers.length / 3,
        i => Math.hypot(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]));
}

/** The longest of vectors in several lists. */
function longest(lists) {
    return lists.reduce((most, numbers) => lengths(numbers, 3).reduce((x, y) => Math.max(x, y), most), 0);
}

/** Values at every step, their range over all, and the colors that the library chose for it. */
function withValues(field, names, header, arrays) {
    const entries = names.map(name => header.arrays[name]);
    const rows = names.map(name => arrays[name]);
    const values = rows.map(numbers => lengths(numbers, field.components));
    let low = Infinity, high = -Infinity, least = Infinity;
    for (const list of values)
        for (const value of list) {
            low = Math.min(low, value);
            high = Math.max(high, value);
            if (value > 0)
                least = Math.min(least, value);
        }
    const off = Math.max(...entries.map(entry => entry.kind === "rounded" ? entry.step / 2 : 0));
    return {...field, rows, values, low, high, least, off};
}

/** The fields of a page; those with a vector in each cell also have its length as a field. */
function fieldsOf(header, arrays) {
    const named = name => header.steps.length ? header.steps.map((_, s) => `${name}.${s}`) : [name];
    return header.fields.map((about, i) => {
        const field = withValues(about, named(`f${i}`), header, arrays);
        const at = header.arrows.findIndex(each => each.field === field.name);
        const names = named(`sizes${at}`);
        if (arrays[names[0]])
            field.strength = {...withValues({...field, scale: header.arrows[at].scale, place: "cell",
                components: 1}, names, header, arrays), title: `|${field.name}|`};
        return field;
    });
}

/** The map that is meant, and the values at its ends, of which the user may choose one or both. */
function scaleOf(field, {map, from, to, log}, maps) {
    const name = map === "auto" ? field.scale.map : map, isDiverging = name === "diverging";
    const colors = name === "gray" ? ["#f2f2f2", "#1c1c1c"] : maps[name];
    const [low, high] = field.scale.constant ? field.scale.ends : [field.low, field.high];
    const largest = Math.max(Math.abs(low), Math.abs(high));
    let ends = isDiverging ? [-largest, largest] : [low, high];
    const isLog = log && field.low >= 0 && field.high > 0;
    if (isLog)
        ends[0] = Math.max(field.least, 1e-6 * field.high);
    const asked = [Number.isFinite(from) ? from : ends[0], Number.isFinite(to) ? to : ends[1]];
    if (asked[0] < asked[1] && (!isLog || asked[0] > 0))
        ends = asked;
    if (isDiverging) // white stays 0
        ends = [-1, 1].map(sign => sign * Math.max(...ends.map(Math.abs)));
    return {colors: spread(colors.map(colorOf)), ends, isLog, isConstant: field.scale.constant};
}

function colorOf(text) {
    return [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255);
}

const mapSize = 31;

/** The value at a part of the bar, from 0 to 1. */
function valueAt(part, {ends: [a, b], isLog}) {
    return isLog ? Math.exp((1 - part) * Math.log(a) + part * Math.log(b)) : (1 - part) * a + part * b;
}

/** The same colors at as many places as the shaders ask for. */
function spread(colors) {
    return Array.from({length: mapSize}, (_, i) => mixed(colors, i / (mapSize - 1)));
}

function mixed(colors, t) {
    const at = Math.min(1, Math.max(0, t)) * (colors.length - 1);
    const i = Math.min(Math.floor(at), colors.length - 2);
    return colors[i].map((x, c) => x + (at - i) * (colors[i + 1][c] - x));
}

function cssColor(color) {
    return `rgb(${color.map(x => Math.round(255 * x)).join(" ")})`;
}

function gradient(scale) {
    return `linear-gradient(to right, ${scale.colors.map(cssColor).join(", ")})`;
}
