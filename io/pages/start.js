// SPDX-License-Identifier: MIT
// Puts the parts together: what is chosen and seen becomes a picture, a legend and words.

const slowDrawing = 40, rest = 200; // milliseconds

class Viewer {
    constructor(canvas, scene, fields) {
        this.canvas = canvas;
        this.label = canvas.getAttribute("aria-label");
        this.scene = scene;
        this.fields = fields;
        this.picked = null;
        this.camera = new Camera(scene.isFlat);
        this.renderer = new Renderer(canvas, scene);
        canvas.addEventListener("webglcontextlost", event => {
            event.preventDefault();
            this.isLost = true;
            this.say("The graphics card was taken away; the picture comes back by itself.");
        });
        canvas.addEventListener("webglcontextrestored", () => {
            this.renderer.restore();
            this.isLost = false;
            this.seen = undefined;
            this.say("");
            this.changed();
        });
        this.controls = new Controls(this);
        new Pointers(canvas, this);
        new ResizeObserver(() => this.changed()).observe(canvas);
    }

    say(text) {
        element("message").textContent = text;
    }

    /** Draws anew before the next picture of the screen. */
    changed() {
        if (this.isWaiting)
            return;
        this.isWaiting = true;
        requestAnimationFrame(() => {
            this.isWaiting = false;
            if (!this.isLost)
                this.draw();
        });
    }

    get field() {
        return this.fields[this.controls.state().field] ?? null;
    }

    /** The plane of the cut: all is kept at the end of the slider. */
    plane({axis, cut}) {
        const plane = [0, 0, 0, 2];
        if (cut >= 1 || !this.scene.isSolid)
            return plane;
        let low = Infinity, high = -Infinity;
        for (let i = axis; i < this.scene.centers.length; i += 3) {
            low = Math.min(low, this.scene.centers[i]);
            high = Math.max(high, this.scene.centers[i]);
        }
        plane[axis] = 1;
        plane[3] = Math.fround(low + cut * (high - low) + 1e-6);
        return plane;
    }

    /** Colors and switches, as the shaders call them. */
    look() {
        const state = this.controls.state(), styles = getComputedStyle(document.documentElement);
        const color = name => colorOf(styles.getPropertyValue(`--${name}`).trim());
        const field = this.field;
        return {
            ...state, cut: this.plane(state), pixel: this.pixel, ground: color("ground"),
            plain: color("plain"), edge_color: color("edge"), removed_color: color("removed"),
            dual_color: color("dual"), level_color: color("level"), arrow_color: color("arrow"),
            picked_color: color("removed"), picked: this.picked ? this.picked.cell + 1 : -1,
            scale: field ? scaleOf(field, state.map, this.scene.header.maps) : null,
        };
    }

    /** Where drawing takes long, coarsely as long as things change: a fine picture follows. */
    draw() {
        clearTimeout(this.finer);
        this.drawAs(this.isSlow);
        if (this.isSlow)
            this.finer = setTimeout(() => this.isLost ? null : this.drawAs(false), rest);
    }

    /** Pixels of a fine picture by those of the page. */
    get finePixel() {
        return Math.min(2, window.devicePixelRatio || 1);
    }

    /** Of the canvas, by how many of its pixels there are to one of the page. */
    size(pixel) {
        return [this.canvas.clientWidth, this.canvas.clientHeight]
            .map(size => Math.max(1, Math.round(pixel * size)));
    }

    drawAs(isCoarse) {
        this.pixel = isCoarse ? 0.5 : this.finePixel;
        const [width, height] = this.size(this.pixel);
        if (this.canvas.width !== width || this.canvas.height !== height) {
            this.canvas.width = width;
            this.canvas.height = height;
        }
        this.camera.fill(this.scene.points, width / height);
        const look = this.look(), seen = `${look.field} ${look.step}`;
        if (seen !== this.seen) {
            this.seen = seen;
            this.renderer.show(this.field, look.step);
            this.pickedText();
        }
        const time = this.renderer.draw(this.camera, look, isCoarse);
        if (!isCoarse)
            this.isSlow = time > slowDrawing;
        this.canvas.dataset.drawing = isCoarse ? "coarse" : "fine";
        this.legend(look);
    }

    legend(look) {
        element("legend").hidden = !look.scale;
        this.canvas.setAttribute("aria-label", this.label);
        if (!look.scale)
            return;
        const {ends, isConstant} = look.scale, {name, about, place, components} = this.field;
        element("legend-name").textContent = name;
        const isSigned = place === "edge" || place === "face";
        element("legend-about").textContent = [about,
            isSigned ? `one value for each ${place}, whose sign goes with its orientation` : "", components > 1 ? "colors show the length" : "",
            isConstant ? "the same everywhere, but for rounding" : ""].filter(Boolean).join("; ");
        element("legend-bar").style.background = gradient(look.scale);
        const numbers = [ends[0], ends[0] / 2 + ends[1] / 2, ends[1]];
        [...element("legend-numbers").children].forEach((span, i) => {
            span.textContent = numberText(numbers[i], 4);
        });
        this.canvas.setAttribute("aria-label", `Colors of ${name}, from ${numberText(ends[0], 4)} to ` +
            `${numberText(ends[1], 4)}. ${this.label}`);
    }

    unpick() {
        this.picked = null;
        this.pickedText();
    }

    /** Tells of what is at a place of the view, in parts of half its height. */
    pick(place) {
        const [width, height] = this.size(this.finePixel), look = this.look();
        const at = this.scene.isCurve ? lineAt(this.scene, place, this.camera, 0.05)
            : this.renderer.triangleAt(Math.floor((width + place[0] * height) / 2),
                Math.floor((1 + place[1]) * height / 2), width, height, this.camera, look);
        this.picked = at < 0 ? null : {at, place: this.within(place)};
        this.pickedText();
        this.changed();
    }

    /** A place of the view by what is there, wherever it is seen later. */
    within(place) {
        const {camera} = this;
        return {place, axes: camera.axes, zoom: camera.zoom, x: camera.x, y: camera.y,
            seen: camera.seen};
    }

    pickedText() {
        const output = element("picked"), look = this.look(), {field} = this;
        output.hidden = !this.picked;
        if (!this.picked)
            return;
        const {at, place} = this.picked;
        const facts = this.scene.isCurve ? factsOfLine(this.scene, at, field, look.step)
            : factsAt(this.scene, at, place.place, place, look, field, look.step);
        this.picked.cell = facts.cell;
        output.replaceChildren(...toldOf(facts, this.scene, field, look.step).map(text => {
            const line = document.createElement("p");
            line.textContent = text;
            return line;
        }));
        for (const name of ["cell", "vertex", "number", "value", "here"])
            output.dataset[name] = facts[name] ?? "";
    }
}

async function start() {
    const header = JSON.parse(element("page-header").textContent);
    const canvas = element("canvas");
    if (!document.createElement("canvas").getContext("webgl2"))
        throw new Error("this browser has no WebGL 2");
    const arrays = await readArrays(header, element("page-data").textContent);
    canvas.hidden = false;
    const viewer = new Viewer(canvas, new Scene(header, arrays), fieldsOf(header, arrays));
    element("still").hidden = true;
    viewer.controls.changed();
    requestAnimationFrame(() => requestAnimationFrame(() => {
        document.body.dataset.state = "ready";
    }));
}

start().catch(error => {
    element("canvas").hidden = true;
    element("still").hidden = false;
    element("message").textContent = `A still picture only: ${error.message}.`;
    document.body.dataset.state = "still";
});
