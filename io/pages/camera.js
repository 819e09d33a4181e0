// SPDX-License-Identifier: MIT
// From where the mesh is seen, without perspective: turned, moved and scaled.

class Camera {
    constructor(isFlat, up, eyes) {
        this.isFlat = isFlat;
        this.up = up;
        this.eyes = eyes; // directions to the eye, where x, y or z is up
        this.reset();
    }

    /** With another axis upwards, or flat or not. */
    stand(isFlat, up) {
        if (this.isFlat === isFlat && this.up === up)
            return;
        this.isFlat = isFlat;
        this.up = up;
        this.reset();
    }

    /** All of the mesh, from the front and above; flat ones from straight above. */
    reset() {
        this.isMoved = false;
        this.filled = "";
        this.zoom = 0.94;
        this.x = this.y = 0;
        this.axes = this.isFlat ? [[1, 0, 0], [0, 1, 0], [0, 0, 1]] : this.above();
    }

    /** The directions to the right, up and to the eye, as in the still picture. */
    above() {
        const upward = [0, 1, 2].map(i => i === this.up ? 1 : 0);
        const eye = normalized(this.eyes[this.up]), right = normalized(cross(upward, eye));
        return [right, cross(eye, right), eye];
    }

    /** Until somebody moves it, what a cut leaves of the scene fills the view, as wide as `aspect` times
     * its height. */
    fill(scene, cut, aspect) {
        const filled = `${cut} ${aspect}`;
        if (this.isMoved || this.filled === filled)
            return;
        this.filled = filled;
        const isSeen = scene.seenVertices(cut);
        const [[left, right], [below, above]] = this.axes.slice(0, 2).map(axis => rangeOf(
            scene.points.length / 3, v => isSeen(v) ? dot(axis, scene.point(v)) : NaN));
        this.zoom = 1.88 * Math.min(aspect / (right - left || 1e-9), 1 / (above - below || 1e-9), 1e6);
        this.x = -this.zoom * (left + right) / 2;
        this.y = -this.zoom * (below + above) / 2;
    }

    /** By angles around the upward and the rightward axis of the view. */
    turn(horizontal, vertical) {
        if (this.isFlat)
            return this.move(-horizontal, vertical);
        this.isMoved = true;
        const [right, up, eye] = this.axes;
        const turned = (a, b, angle) => a.map((x, i) => x * Math.cos(angle) + b[i] * Math.sin(angle));
        let r = turned(right, eye, horizontal), e = turned(eye, right, -horizontal);
        const u = turned(up, e, -vertical);
        e = turned(e, up, vertical);
        this.axes = [normalized(r), normalized(u), normalized(e)];
    }

    /** In parts of half the height of the view. */
    move(x, y) {
        this.isMoved = true;
        this.x += x;
        this.y += y;
    }

    /** Keeps the place (x, y) of the view where it is. */
    scale(factor, x = 0, y = 0) {
        this.isMoved = true;
        const zoom = Math.min(5000, Math.max(0.2, this.zoom * factor));
        this.x = x + (this.x - x) * zoom / this.zoom;
        this.y = y + (this.y - y) * zoom / this.zoom;
        this.zoom = zoom;
    }

    /** As it is now, whatever moves later. */
    copy() {
        return Object.assign(Object.create(Camera.prototype), this);
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
