// SPDX-License-Identifier: MIT
// Mouse, pen and fingers on the picture.

class Pointers {
    constructor(canvas, viewer) {
        this.canvas = canvas;
        this.viewer = viewer;
        this.places = new Map();
        this.moved = 0;
        canvas.addEventListener("pointerdown", event => this.down(event));
        canvas.addEventListener("pointermove", event => this.move(event));
        canvas.addEventListener("pointerup", event => this.up(event));
        canvas.addEventListener("pointercancel", event => this.places.delete(event.pointerId));
        canvas.addEventListener("contextmenu", event => event.preventDefault());
        canvas.addEventListener("wheel", event => this.wheel(event), {passive: false});
    }

    /** A place of the view, in parts of half its height. */
    place(event) {
        const box = this.canvas.getBoundingClientRect();
        return [(2 * (event.clientX - box.left) - box.width) / box.height,
            (box.height - 2 * (event.clientY - box.top)) / box.height];
    }

    down(event) {
        this.canvas.setPointerCapture(event.pointerId);
        this.places.set(event.pointerId, this.place(event));
        this.moved = this.places.size > 1 ? Infinity : 0;
    }

    move(event) {
        const before = this.places.get(event.pointerId);
        if (!before)
            return;
        const now = this.place(event), step = [now[0] - before[0], now[1] - before[1]];
        this.moved += Math.hypot(...step);
        const {camera} = this.viewer;
        if (this.places.size === 1) {
            if (event.shiftKey || event.buttons > 1 || camera.isFlat)
                camera.move(...step);
            else
                camera.turn(2 * step[0], -2 * step[1]);
        } else {
            this.pinch(event.pointerId, before, now, camera);
        }
        this.places.set(event.pointerId, now);
        this.viewer.changed();
    }

    /** Two fingers: what is under them stays there. */
    pinch(id, before, now, camera) {
        const [other] = [...this.places].filter(([each]) => each !== id).map(([, place]) => place);
        const far = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) || 1e-6;
        camera.move((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
        camera.scale(far(now, other) / far(before, other), (now[0] + other[0]) / 2,
            (now[1] + other[1]) / 2);
    }

    up(event) {
        const known = this.places.delete(event.pointerId);
        if (known && this.moved < 0.02)
            this.viewer.pick(this.place(event));
    }

    wheel(event) {
        event.preventDefault();
        const turns = event.deltaY * (event.deltaMode === 1 ? 30 : 1);
        this.viewer.camera.scale(Math.exp(-0.0015 * turns), ...this.place(event));
        this.viewer.changed();
    }
}
