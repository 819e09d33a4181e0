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
        this.isSlow = scene.size > 2e5; // until a picture tells
        this.camera = new Camera(scene.isFlat, scene.header.up, scene.header.eyes);
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

    /** What is shown: of a field with a vector in each cell its length, unless its values are. */
    get field() {
        const {field, own_values: isOwn} = this.controls.state(), given = this.fields[field] ?? null;
        return given?.strength && !isOwn ? given.strength : given;
    }

    /** The plane of the cut, from the side that stays: all is kept at the end of the slider. */
    plane({axis: side, cut}) {
        const plane = [0, 0, 0, 2], axis = side % 3, sign = side < 3 ? 1 : -1;
        if (cut >= 1 || !this.scene.isSolid)
            return plane;
        const {centers} = this.scene;
        const [low, high] = rangeOf(centers.length / 3, cell => sign * centers[3 * cell + axis]);
        plane[axis] = sign;
        plane[3] = Math.fround(low + cut * (high - low) + 1e-6);
        return plane;
    }

    /** Colors and switches, as the shaders call them. */
    look() {
        const state = this.controls.state(), field = this.field, color = name => colorOf(ink(name));
        return {
            ...state, cut: this.plane(state), pixel: this.pixel, ground: color("ground"),
            plain: color("plain"), edge_color: color("edge"), removed_color: color("removed"),
            dual_color: color("dual"), level_color: color("level"), arrow_color: color("arrow"), arrow_edge: color("arrow-edge"),
            picked_color: color("removed"), picked: this.picked ? this.picked.cell + 1 : -1,
            scale: field ? scaleOf(field, state, this.scene.header.maps) : null,
        };
    }

    /** Where drawing takes long, coarsely as long as things change: a fine picture follows. */
    draw() {
        clearTimeout(this.finer);
        this.drawAs(this.isSlow);
        this.finer = setTimeout(() => this.isLost ? null : this.settle(), rest);
    }

    /** At rest: a fine picture, and which extreme values are behind the mesh. */
    settle() {
        if (this.isSlow)
            this.drawAs(false);
        const look = this.look();
        for (const extreme of this.extremes)
            extreme.isHidden = this.isHidden(extreme, look);
        this.write(look);
        element("overlay").dataset.settled = "";
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
        const look = this.look(), seen = `${look.field} ${look.step} ${look.own_values} ${look.height}`;
        this.camera.stand(this.scene.isFlat && !look.height, look.height ? 2 : look.up);
        if (seen !== this.seen) {
            this.seen = seen;
            this.raise(look);
            this.renderer.show(this.field, look.step);
            this.pickedText();
        }
        if (`${seen} ${look.cut}` !== this.marked) {
            this.marked = `${seen} ${look.cut}`;
            this.extremes = this.field ? extremesOf(this.scene, this.field, look.step,
                this.camera.axes[2], look.cut) : [];
        }
        this.camera.fill(this.scene, look.cut, width / height);
        const time = this.renderer.draw(this.camera, look, isCoarse);
        if (!isCoarse)
            this.isSlow = time > slowDrawing;
        this.canvas.dataset.drawing = isCoarse ? "coarse" : "fine";
        this.legend(look);
        this.write(look);
        delete element("overlay").dataset.settled;
    }

    /** Values at the vertices of a plane mesh as heights. */
    raise({height, step}) {
        const {field, scene} = this;
        const values = height && field.place === "vertex" ? field.values[step] : null;
        if (scene.isFlat && scene.lift(values, Math.max(...[field?.low, field?.high].map(Math.abs)))) {
            this.camera.aspect = 0; // fill anew
            this.renderer.keepPoints();
        }
    }

    legend(look) {
        element("legend").hidden = !look.scale;
        this.canvas.setAttribute("aria-label", this.label);
        if (!look.scale)
            return;
        const {title, about, numbers} = legendOf(this.field, look.scale);
        element("legend-name").textContent = title;
        element("legend-about").textContent = about;
        element("legend-bar").style.background = gradient(look.scale);
        element("legend-numbers").replaceChildren(...numbers.map(text => elementOf("span", text)));
        [["from", numbers[0]], ["to", numbers.at(-1)]].forEach(([id, text]) => {
            element(id).placeholder = text;
        });
        this.canvas.setAttribute("aria-label", `Colors of ${title}, from ${numbers[0]} to ` +
            `${numbers.at(-1)}. ${this.label}`);
    }

    /** Whether something is nearer to the eye than a place, by more than a little, and not of its cell. */
    isHidden({place, cell}, look) {
        const {camera, canvas: {width, height}} = this, seen = camera.seen(place);
        const at = this.renderer.triangleAt(seen, [width, height], camera, look);
        if (at < 0 || (cell >= 0 && this.scene.owners(at).includes(cell)))
            return false;
        const corners = [...this.scene.corners(at)].map(v => this.scene.point(v));
        const weights = coordinatesIn(seen, corners.map(p => camera.seen(p)));
        const depth = corners.reduce((sum, p, i) => sum + weights[i] * dot(camera.axes[2], p), 0);
        return depth > dot(camera.axes[2], place) + (this.scene.isSolid ? 0.1 : 0.03);
    }

    get inks() {
        return {ground: ink("ground"), text: ink("text"), axes: ["x", "y", "z"].map(ink)};
    }

    /** What stands over the picture. */
    write(look) {
        const {width, height} = this.canvas, {camera, scene} = this, canvas = element("overlay");
        const overlay = new Overlay(canvas, width, height, this.pixel, this.inks);
        overlay.cross(camera, ["x", "y", "z"]);
        const marks = look.marks
            ? this.extremes.map(each => ({...each, at: overlay.at(each.place, camera)})) : [];
        const places = marks.map(mark => mark.at);
        Object.assign(canvas.dataset, overlay.bar(scene, camera, scene.header.unit, places));
        if (!look.marks)
            return;
        for (const mark of marks)
            overlay.mark(mark, marks.filter(other => other !== mark).map(other => other.at));
        canvas.dataset.marks = JSON.stringify(marks);
    }

    /** The picture as it is seen, with its legend, as a PNG file. */
    picture() {
        const look = this.look();
        return pictureOf(this.canvas, element("overlay"),
            look.scale ? legendOf(this.field, look.scale) : null, this.inks, this.pixel);
    }

    unpick() {
        this.picked = null;
        this.pickedText();
    }

    /** Tells of what is at a place of the view, in parts of half its height. */
    pick(place) {
        const {scene, camera} = this;
        const at = scene.isCurve ? lineAt(scene, place, camera, 0.05)
            : this.renderer.triangleAt(place, this.size(this.finePixel), camera, this.look());
        this.picked = at < 0 ? null : {at, place, camera: camera.copy()};
        this.pickedText();
        this.changed();
    }

    pickedText() {
        const output = element("picked"), look = this.look(), {field} = this;
        output.hidden = !this.picked;
        if (!this.picked)
            return;
        const {at, place, camera} = this.picked;
        const facts = this.scene.isCurve ? factsOfLine(this.scene, at, field, look.step)
            : factsAt(this.scene, at, place, camera, look, field, look.step);
        this.picked.cell = facts.cell;
        output.replaceChildren(...toldOf(facts, this.scene, field, look.step).map(text => elementOf("p", text)));
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
