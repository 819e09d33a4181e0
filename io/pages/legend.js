// SPDX-License-Identifier: MIT
// The words and numbers beside the colors.

/** Of a field and its scale: a title, a description, and numbers at even steps along the bar. */
function legendOf(field, scale) {
    const {title, name, about, place, components, unit} = field, isStrength = title !== undefined;
    const isSigned = place === "edge" || place === "face";
    return {
        title: `${title ?? name}${unit ? ` [${unit}]` : ""}`,
        about: [isStrength ? `length of its vectors in each cell; ${about}` : about,
            isSigned ? `one value for each ${place}, whose sign goes with its orientation` : "",
            components > 1 ? "colors show the length" : "",
            scale.isConstant ? "the same everywhere, but for rounding" : ""].filter(Boolean).join("; "),
        colors: scale.colors,
        numbers: [0, 0.25, 0.5, 0.75, 1].map(t =>
            scale.isConstant && t !== 0.5 ? "" : numberText(valueAt(t, scale), 4)),
    };
}
