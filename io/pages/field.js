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

/** Of each vector its length. */
function lengths(numbers, components) {
    if (components === 1)
        return Float64Array.from(numbers);
    const result = new Float64Array(numbers.length / components);
    for (let i = 0; i < result.length; ++i)
        result[i] = Math.hypot(...numbers.subarray(i * components, (i + 1) * components));
    return result;
}

/** The fields of a page, each with its values at every step and their range over all. */
function fieldsOf(header, arrays) {
    return header.fields.map((field, i) => {
        const names = header.steps.length ? header.steps.map((_, s) => `f${i}.${s}`) : [`f${i}`];
        const entries = names.map(name => header.arrays[name]);
        const rows = names.map(name => arrays[name]);
        const values = rows.map(numbers => lengths(numbers, field.components));
        let low = Infinity, high = -Infinity;
        for (const list of values)
            for (const value of list) {
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
        const off = Math.max(...entries.map(entry => entry.kind === "rounded" ? entry.step / 2 : 0));
        return {...field, rows, values, low, high, off};
    });
}

/** The map that is meant, and the values at its ends. */
function scaleOf(field, choice, maps) {
    const largest = Math.max(Math.abs(field.low), Math.abs(field.high));
    const isConstant = field.high - field.low <= 1e-6 * largest;
    const bothSigns = field.low < 0 && field.high > 0;
    const name = choice !== "auto" ? choice : bothSigns && !isConstant ? "diverging" : "sequential";
    const colors = name === "gray" ? ["#f2f2f2", "#1c1c1c"] : maps[name];
    const ends = name === "diverging" ? [-largest, largest] : [field.low, field.high];
    return {name, colors: spread(colors.map(colorOf)), ends, isConstant};
}

function colorOf(text) {
    return [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255);
}

const mapSize = 31;

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
