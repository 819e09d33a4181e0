// SPDX-License-Identifier: MIT
// The form beside the picture, the table, and the keyboard.

const element = id => document.getElementById(id);
const elementOf = (tag, text) => Object.assign(document.createElement(tag), {textContent: text});

/** A color of the page's style. */
const ink = name => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

const mostWithEdges = 2000; // cells: edges of more would hide what is shown

class Controls {
    constructor(viewer) {
        this.viewer = viewer;
        this.calm = matchMedia("(prefers-reduced-motion: reduce)");
        const {scene, fields} = viewer, {header} = scene;
        const choices = ["cells without values", ...fields.map(field => `${field.name} (${field.place})`)];
        element("field").replaceChildren(...choices.map(
            (text, i) => Object.assign(elementOf("option", text), {value: i - 1})));
        element("field").value = String(header.shown);
        element("removed").checked = header.shown < 0; // they would drown a field
        const isStrength = fields[header.shown]?.strength !== undefined; // lines run along it
        element("edges").checked = header.cells <= mostWithEdges && !isStrength;
        element("up").value = String(header.up);
        if (header.cut)
            [element("axis").value, element("cut").value] = header.cut.map(String);
        this.hideWhatIsNotThere(scene, header, fields);
        this.times = timeTexts(header.steps);
        element("step").max = header.steps.length - 1;
        element("step").value = header.step;
        element("field").addEventListener("input", () => this.forgetRange());
        element("controls").addEventListener("input", () => this.changed());
        element("controls").addEventListener("submit", event => event.preventDefault());
        element("play").addEventListener("click", () => this.play());
        this.namePlay();
        element("theme").addEventListener("click", () => this.turnTheme());
        element("save").addEventListener("click", () => {
            save(viewer.picture(), `${document.title.replace(/[^\p{L}\p{N}.-]+/gu, "-")}.png`);
        });
        document.addEventListener("keydown", event => this.key(event));
        element("canvas").addEventListener("keydown", event => this.canvasKey(event));
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => viewer.changed());
        this.prepareTable();
        for (const id of ["controls", "theme", "save"])
            element(id).hidden = false;
    }

    hideWhatIsNotThere(scene, header, fields) {
        const hide = (id, isThere) => {
            element(id).closest("label, fieldset").hidden = !isThere;
        };
        const kinds = scene.isCurve ? [] : new Set(scene.arrays.sides);
        for (const id of ["field", "map", "from"])
            hide(id, fields.length > 0);
        hide("step", header.steps.length > 1);
        hide("speed", header.steps.length > 1 && !this.calm.matches);
        hide("log", fields.some(field => [field, field.strength].some(each => each?.low >= 0 && each.high > 0)));
        hide("values", fields.some(field => field.strength));
        hide("height", scene.isFlat && !scene.isCurve && fields.some(
            field => field.place === "vertex" && field.components === 1));
        hide("up", !scene.isFlat);
        hide("marks", !scene.isCurve && fields.length > 0);
        hide("removed", [...kinds].some(bits => [0, 2, 4].some(s => (bits >> s & 3) === 2)));
        hide("edges", !scene.isCurve);
        hide("dual", scene.arrays.dual_lines !== undefined);
        hide("levels", !scene.isCurve && fields.some(field => field.place === "vertex"));
        if (scene.hasPaths) {
            const [, , line, words] = element("flow").closest("label").childNodes;
            line.className = "line dual";
            words.textContent = " paths ";
        }
        hide("arrows", header.arrows.some(each => !each.lines_alone) || fields.some(field => field.components > 1));
        const hasFlow = header.arrows.some((_, i) => scene.arrays[`flow${i}`] !== undefined);
        element("flow").checked = hasFlow;
        hide("flow", hasFlow);
        element("cutting").hidden = !scene.isSolid;
    }

    /** Rows that choose a field can be reached and pressed like buttons. */
    prepareTable() {
        for (const row of document.querySelectorAll("tr[data-field]")) {
            row.tabIndex = 0;
            row.setAttribute("aria-label", `show ${row.textContent}`);
            row.addEventListener("click", () => this.choose(row.dataset.field));
            row.addEventListener("keydown", event => {
                const to = {ArrowDown: row.nextElementSibling,
                    ArrowUp: row.previousElementSibling}[event.key];
                if (to)
                    to.focus();
                else if (event.key === "Enter" || event.key === " ")
                    this.choose(row.dataset.field);
                else
                    return;
                event.preventDefault();
            });
        }
    }

    /** What was chosen for one field says nothing of another. */
    forgetRange() {
        element("from").value = element("to").value = "";
    }

    choose(field) {
        this.forgetRange();
        element("field").value = field;
        this.changed();
    }

    /** What is chosen, as the picture needs it. */
    state() {
        const is = id => element(id).checked && !element(id).closest("label").hidden;
        return {
            field: Number(element("field").value), map: element("map").value,
            step: Number(element("step").value), lines: is("edges"), removed_lines: is("removed"),
            dual: is("dual"), levels: is("levels"), arrows: is("arrows"), flow: is("flow"),
            own_values: is("values"), height: is("height"), marks: is("marks"), log: is("log"),
            from: parseFloat(element("from").value), to: parseFloat(element("to").value),
            up: Number(element("up").value), light: is("shade"), axis: Number(element("axis").value),
            cut: Number(element("cut").value) / 100,
        };
    }

    changed() {
        const {step, field} = this.state();
        for (const row of document.querySelectorAll("tr[data-field]"))
            row.setAttribute("aria-selected", String(Number(row.dataset.field) === field));
        element("time").textContent = this.times.length ? `t = ${this.times[step]}` : "";
        element("shade").closest("label").hidden = this.viewer.scene.isCurve ||
            this.viewer.scene.isFlat && !element("height").checked;
        element("cut-at").textContent = `${element("cut").value} %`;
        this.viewer.changed();
    }

    next(id, by) {
        const select = element(id);
        select.selectedIndex = (select.selectedIndex + by + select.options.length) % select.options.length;
        if (id === "field")
            this.forgetRange();
        this.changed();
    }

    /** Plays or pauses; where motion is unwanted, goes one step on. */
    play() {
        if (this.calm.matches)
            return this.advance();
        const isPlaying = this.timer !== undefined;
        clearTimeout(this.timer);
        this.timer = undefined;
        if (!isPlaying)
            this.advanceLater();
        this.namePlay();
    }

    advanceLater() {
        this.timer = setTimeout(() => {
            this.advance();
            this.advanceLater();
        }, 1000 / Number(element("speed").value));
    }

    advance() {
        const step = element("step");
        step.value = Number(step.value) >= Number(step.max) ? 0 : Number(step.value) + 1;
        this.changed();
    }

    namePlay() {
        element("play").firstChild.data = this.calm.matches ? "Next step "
            : this.timer === undefined ? "Play " : "Pause ";
    }

    turnTheme() {
        document.documentElement.dataset.theme = ink("ground") === "#14181d" ? "light" : "dark";
        this.viewer.changed();
    }

    /** Letters, wherever the focus is but in lists and sliders. */
    key(event) {
        if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented)
            return;
        // lists, buttons and switches have a use for some keys themselves
        const {tagName, type} = event.target;
        if (tagName === "SELECT" || type === "number" || event.key === " " && (tagName === "BUTTON" || type === "checkbox"))
            return;
        const key = event.key === " " ? "p" : event.key.toLowerCase();
        const control = document.querySelector(`[data-key="${CSS.escape(key)}"]`);
        if (!control || control.closest("[hidden]"))
            return;
        if (control.tagName === "SELECT")
            this.next(control.id, event.shiftKey ? -1 : 1);
        else if (control.type === "range")
            control.focus();
        else
            control.click();
        event.preventDefault();
    }

    /** Keys that turn, move and scale. */
    canvasKey(event) {
        const {camera} = this.viewer;
        const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
        const arrow = arrows[event.key];
        if (arrow && (event.shiftKey || camera.isFlat))
            camera.move(0.1 * arrow[0], 0.1 * arrow[1]);
        else if (arrow)
            camera.turn(0.1 * arrow[0], -0.1 * arrow[1]);
        else if (event.key === "+" || event.key === "=")
            camera.scale(1.15);
        else if (event.key === "-")
            camera.scale(1 / 1.15);
        else if (event.key === "0")
            camera.reset();
        else if (event.key === "Enter")
            this.viewer.pick([0, 0]);
        else if (event.key === "Escape")
            this.viewer.unpick();
        else
            return;
        event.preventDefault();
        this.viewer.changed();
    }
}
