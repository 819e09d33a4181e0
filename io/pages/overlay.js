// SPDX-License-Identifier: MIT
// What is written over the picture: directions, a length, the places of extreme values; and the
// picture as a file.

/** The largest of 1, 2 and 5 times a power of ten that is not above a length. */
function roundLength(most) {
    const power = 10 ** Math.floor(Math.log10(most));
    return [5, 2, 1].find(n => n * power <= most * (1 + 1e-9)) * power;
}

/** Parts of the largest value: values within the first are equal, since a page has 7 digits of them;
 * below the second, a value is what rounding leaves of 0. */
const equalWithin = 1e-6, nothingBelow = 1e-9;

/** Where values of a step are extreme: the largest, and the smallest if it is below 0 by more than
 * rounding; with the place of the vertex, or the middle of the cell. Of equal ones, that nearest to
 * the eye of what the cut leaves. */
function extremesOf(scene, field, step, eye, cut) {
    const values = field.values[step], found = [], isCell = field.place === "cell";
    if (field.scale.constant || scene.isCurve || !["vertex", "cell"].includes(field.place))
        return found;
    const placeOf = i => isCell ? scene.center(i) : scene.point(i);
    const isSeen = isCell ? i => scene.isKept(i, cut) : scene.seenVertices(cut);
    const nearness = i => isSeen(i) ? dot(eye, placeOf(i)) : -Infinity;
    for (const [name, sign] of [["max", 1], ["min", -1]]) {
        const far = values.reduce((most, x) => sign * x > most ? sign * x : most, -Infinity); // not NaN
        const least = far - equalWithin * Math.abs(far);
        let best = -1, nearest = -Infinity;
        for (let i = 0; i < values.length; ++i)
            if (sign * values[i] >= least && (best < 0 || nearness(i) > nearest)) {
                best = i;
                nearest = nearness(i);
            }
        if (best >= 0 && (sign > 0 || far > nothingBelow * Math.max(field.high, -field.low)))
            found.push({name, value: values[best], place: placeOf(best), cell: isCell ? best : -1});
    }
    return found;
}

/** Of a mark, in the page's pixels: its ring, where its words begin, and how high a line of them is. */
const ringRadius = 6, wordsFrom = 2 * ringRadius, lineHeight = 18;

class Overlay {
    /** On a 2D canvas of as many of its pixels as the picture, each of this part of the page's. */
    constructor(canvas, width, height, pixel, colors) {
        this.width = width / pixel;
        this.height = height / pixel;
        this.colors = colors;
        if (canvas.width !== width || canvas.height !== height) {
            canvas.width = width;
            canvas.height = height;
        }
        const draw = this.draw = canvas.getContext("2d");
        draw.setTransform(pixel, 0, 0, pixel, 0, 0);
        draw.clearRect(0, 0, this.width, this.height);
        draw.font = "13px system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
        draw.textBaseline = "middle";
        draw.lineJoin = draw.lineCap = "round";
    }

    text(words, x, y, align) {
        const {draw} = this;
        draw.textAlign = align;
        draw.lineWidth = 4;
        draw.strokeStyle = this.colors.ground;
        draw.strokeText(words, x, y);
        draw.fillStyle = this.colors.text;
        draw.fillText(words, x, y);
    }

    /** Draws the path in these colors and widths, one over the other. */
    stroke(...layers) {
        for (const [color, width] of layers) {
            this.draw.strokeStyle = color;
            this.draw.lineWidth = width;
            this.draw.stroke();
        }
    }

    /** A line, light around so that it is seen on everything. */
    line(points, color, width) {
        this.draw.beginPath();
        for (const [x, y] of points)
            this.draw.lineTo(x, y);
        this.stroke([this.colors.ground, width + 2], [color, width]);
    }

    /** The directions of the coordinates, those towards the eye last. */
    cross(camera, names) {
        const size = 30, x = 46, y = this.height - 46;
        const order = names.map((_, i) => i).sort((i, j) => camera.axes[2][i] - camera.axes[2][j]);
        for (const i of order) {
            const across = camera.axes[0][i], up = camera.axes[1][i];
            if (Math.hypot(across, up) < 0.1)
                continue; // it is a point
            this.line([[x, y], [x + size * across, y - size * up]], this.colors.axes[i], 2.5);
            this.text(names[i], x + (size + 11) * across, y - (size + 11) * up, "center");
        }
    }

    /** A bar whose length is a round number, in the unit of the file; at the top if a mark is below.
     * Returns how long it is. */
    bar(scene, camera, unit, marks) {
        const perPixel = 2 * scene.extent * scene.radius / (camera.zoom * this.height);
        const length = roundLength(Math.min(150, 0.3 * this.width) * perPixel);
        const right = this.width - 16, left = right - length / perPixel;
        const aside = 100; // as wide as the words beside a mark
        const isTaken = marks.some(at => at[1] > this.height - 3 * lineHeight && at[0] > left - aside);
        const y = isTaken ? 2 * lineHeight : this.height - 16;
        this.line([[left, y - 5], [left, y], [right, y], [right, y - 5]], this.colors.text, 2);
        this.text(`${numberText(length, 3)} ${unit || "(unit of the file)"}`, right, y - 13, "right");
        return {length, pixels: right - left};
    }

    /** Where a place of space is on the canvas. */
    at(place, camera) {
        const [x, y] = camera.seen(place);
        return [this.width / 2 + x * this.height / 2, this.height / 2 * (1 - y)];
    }

    /** A ring and words at an extreme value; thin behind the mesh. The words leave the other rings free. */
    mark({name, value, at, isHidden}, others) {
        const {draw} = this, words = `${name} ${numberText(value, 4)}${isHidden ? " (behind)" : ""}`;
        draw.beginPath();
        draw.arc(...at, ringRadius, 0, 7);
        draw.setLineDash(isHidden ? [2, 4] : []);
        this.stroke(...isHidden ? [] : [[this.colors.ground, 5]], [this.colors.text, 2]);
        draw.setLineDash([]);
        const reach = wordsFrom + draw.measureText(words).width + ringRadius;
        const isLeft = at[0] + reach > this.width || others.some(
            other => Math.abs(other[1] - at[1]) < lineHeight && other[0] >= at[0] && other[0] < at[0] + reach);
        this.text(words, at[0] + (isLeft ? -wordsFrom : wordsFrom), at[1], isLeft ? "right" : "left");
    }
}

/** The picture with what is written over it, and its legend below, as a canvas of its own. */
function pictureOf(canvas, overlay, legend, colors, pixel) {
    const below = legend ? 64 * pixel : 0, all = document.createElement("canvas");
    const paper = new Overlay(all, canvas.width, canvas.height + below, pixel, colors), {draw} = paper;
    draw.setTransform(1, 0, 0, 1, 0, 0);
    draw.fillStyle = colors.ground;
    draw.fillRect(0, 0, all.width, all.height);
    draw.drawImage(canvas, 0, 0);
    draw.drawImage(overlay, 0, 0);
    if (!legend)
        return all;
    draw.setTransform(pixel, 0, 0, pixel, 0, 0);
    const top = canvas.height / pixel, left = 16, wide = paper.width - 32;
    paper.text(legend.title, left, top + 12, "left");
    const bar = draw.createLinearGradient(left, 0, left + wide, 0);
    legend.colors.forEach((color, i) => bar.addColorStop(i / (legend.colors.length - 1), cssColor(color)));
    draw.fillStyle = bar;
    draw.fillRect(left, top + 24, wide, 14);
    legend.numbers.forEach((text, i) => paper.text(text, left + wide * i / (legend.numbers.length - 1),
        top + 50, i === 0 ? "left" : i === legend.numbers.length - 1 ? "right" : "center"));
    return all;
}

/** Offers a canvas as a file. */
function save(canvas, name) {
    canvas.toBlob(blob => {
        const link = document.createElement("a");
        link.href = URL.createObjectURL(blob);
        link.download = name;
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
}
