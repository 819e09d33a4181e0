// SPDX-License-Identifier: MIT
// The form beside the picture, the table, and the keyboard.

const element = id => document.getElementById(id);

class Controls {
    constructor(viewer) {
        this.viewer = viewer;
        this.calm = matchMedia("(prefers-reduced-motion: reduce)");
        const {scene, fields} = viewer, {header} = scene;
        this.offer("field", [["-1", "cells without values"],
            ...fields.map((field, i) => [String(i), `${field.name} (${field.place})`])]);
        element("field").value = String(header.shown);
        element("removed").checked = header.shown < 0; // they would drown a field
        this.hideWhatIsNotThere(scene, header, fields);
        element("step").max = header.steps.length - 1;
        element("controls").addEventListener("input", () => this.changed());
        element("controls").addEventListener("submit", event => event.preventDefault());
        element("play").addEventListener("click", () => this.play());
        this.namePlay();
        element("theme").addEventListener("click", () => this.turnTheme());
        document.addEventListener("keydown", event => this.key(event));
        element("canvas").addEventListener("keydown", event => this.canvasKey(event));
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => viewer.changed());
        this.prepareTable();
        for (const id of ["controls", "theme"])
            element(id).hidden = false;
    }

    offer(id, choices) {
        element(id).replaceChildren(...choices.map(([value, text]) => {
            const option = document.createElement("option");
            option.value = value;
            option.textContent = text;
            return option;
        }));
    }

    hideWhatIsNotThere(scene, header, fields) {
        const hide = (id, isThere) => {
            element(id).closest("label, fieldset").hidden = !isThere;
        };
        const kinds = scene.isCurve ? [] : new Set(scene.arrays.sides);
        hide("field", fields.length > 0);
        hide("map", fields.length > 0);
        hide("step", header.steps.length > 1);
        hide("speed", header.steps.length > 1 && !this.calm.matches);
        hide("removed", [...kinds].some(bits => [0, 2, 4].some(s => (bits >> s & 3) === 2)));
        hide("edges", !scene.isCurve);
        hide("dual", scene.arrays.dual_lines !== undefined);
        hide("levels", !scene.isCurve && fields.some(field => field.place === "vertex"));
        if (scene.hasPaths) {
            element("flow").checked = true;
            const [, , line, words] = element("flow").closest("label").childNodes;
            line.className = "line dual";
            words.textContent = " paths ";
        }
        hide("arrows", header.arrows.some(each => !each.lines_alone) || fields.some(field => field.components > 1));
        hide("flow", header.arrows.some((_, i) => scene.arrays[`flow${i}`] !== undefined));
        hide("shade", !scene.isFlat && !scene.isCurve);
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

    choose(field) {
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
            light: is("shade"), axis: Number(element("axis").value),
            cut: Number(element("cut").value) / 100,
        };
    }

    changed() {
        const {step, field} = this.state();
        for (const row of document.querySelectorAll("tr[data-field]"))
            row.setAttribute("aria-selected", String(Number(row.dataset.field) === field));
        element("time").textContent = this.viewer.scene.header.steps[step] ?? "";
        element("cut-at").textContent = `${element("cut").value} %`;
        this.viewer.changed();
    }

    next(id, by) {
        const select = element(id);
        select.selectedIndex = (select.selectedIndex + by + select.options.length) % select.options.length;
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
        const root = document.documentElement;
        const isDark = getComputedStyle(root).getPropertyValue("--ground").trim() === "#14181d";
        root.dataset.theme = isDark ? "light" : "dark";
        this.viewer.changed();
    }

    /** Letters, wherever the focus is but in lists and sliders. */
    key(event) {
        if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented)
            return;
        // lists, buttons and switches have a use for some keys themselves
        const {tagName, type} = event.target;
        if (tagName === "SELECT" || event.key === " " && (tagName === "BUTTON" || type === "checkbox"))
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
