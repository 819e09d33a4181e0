// SPDX-License-Identifier: MIT
// From where the mesh is seen, without perspective: turned, moved and scaled.

class Camera {
    constructor(isFlat) {
        this.isFlat = isFlat;
        this.reset();
    }

    /** All of the mesh, from the front and above; flat ones from straight above. */
    reset() {
        this.zoom = 0.94;
        this.x = this.y = 0;
        this.axes = this.isFlat ? [[1, 0, 0], [0, 1, 0], [0, 0, 1]] : this.above();
    }

    /** The directions to the right, up and to the eye (1, -2, 1.2), as in the still picture. */
    above() {
        const eye = normalized([1, -2, 1.2]);
        const right = normalized(cross([0, 0, 1], eye));
        return [right, cross(eye, right), eye];
    }

    /** By angles around the upward and the rightward axis of the view. */
    turn(horizontal, vertical) {
        if (this.isFlat)
            return this.move(-horizontal, vertical);
        const [right, up, eye] = this.axes;
        const turned = (a, b, angle) => a.map((x, i) => x * Math.cos(angle) + b[i] * Math.sin(angle));
        let r = turned(right, eye, horizontal), e = turned(eye, right, -horizontal);
        const u = turned(up, e, -vertical);
        e = turned(e, up, vertical);
        this.axes = [normalized(r), normalized(u), normalized(e)];
    }

    /** In parts of half the height of the view. */
    move(x, y) {
        this.x += x;
        this.y += y;
    }

    /** Keeps the place (x, y) of the view where it is. */
    scale(factor, x = 0, y = 0) {
        const zoom = Math.min(5000, Math.max(0.2, this.zoom * factor));
        this.x = x + (this.x - x) * zoom / this.zoom;
        this.y = y + (this.y - y) * zoom / this.zoom;
        this.zoom = zoom;
    }

    /** Of a point of the scene: right and up, in parts of half the height. */
    seen(p) {
        return [this.zoom * dot(this.axes[0], p) + this.x, this.zoom * dot(this.axes[1], p) + this.y];
    }
}

function dot(a, b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a, b) {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function normalized(a) {
    const length = Math.sqrt(dot(a, a));
    return a.map(x => x / length);
}
