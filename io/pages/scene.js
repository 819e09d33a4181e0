// SPDX-License-Identifier: MIT
// The mesh as it is drawn: around the origin, of radius 1.

const highest = 0.5; // of heights over a plane, by the radius

class Scene {
    constructor(header, arrays) {
        this.header = header;
        this.arrays = arrays;
        this.isSolid = header.dimension === 3;
        this.isCurve = header.dimension < 2;
        this.size = this.isCurve ? arrays.line_cells.length : arrays.sides.length;
        this.extent = arrays.points.reduce((most, x) => Math.max(most, Math.abs(x)), 0) || 1;
        this.radius = 1;
        this.radius = this.farthest(this.places(arrays.points)) || 1;
        this.points = this.places(arrays.points);
        this.isFlat = header.flat;
        this.hasPaths = header.arrows.some(each => each.lines_alone);
        if (this.isFlat) // but for rounding
            this.points = this.points.map((x, i) => i % 3 < 2 ? x : 0);
        this.centers = this.isCurve ? new Float32Array(3) : this.cellCenters();
    }

    /** Places of the file, less its origin, in the scene. */
    places(numbers) {
        const {extent, radius} = this;
        return made(Float64Array, numbers.length, i => numbers[i] / extent / radius);
    }

    /** Gives a plane mesh heights, of each point the value there by the largest one; or none. */
    lift(values, largest) {
        if (this.lifted === values)
            return false;
        this.lifted = values;
        for (let v = 0; v < this.points.length / 3; ++v)
            this.points[3 * v + 2] = values ? highest * values[v] / (largest || 1) : 0;
        return true;
    }

    /** And back: coordinates of the file. */
    original(p) {
        return (this.isFlat ? [p[0], p[1], 0] : p).map((x, i) => this.header.origin[i] + x * this.extent * this.radius);
    }

    farthest(points) {
        let most = 0;
        for (let i = 0; i < points.length; i += 3)
            most = Math.max(most, points[i] ** 2 + points[i + 1] ** 2 + points[i + 2] ** 2);
        return Math.sqrt(most);
    }

    point(v) {
        return vectorAt(this.points, v);
    }

    corners(t) {
        return this.arrays.corners.subarray(3 * t, 3 * t + 3);
    }

    /** The cells at a triangle, one or two; -1: none. */
    owners(t) {
        const owners = this.arrays.owners;
        return this.isSolid ? [owners[2 * t], owners[2 * t + 1]] : [owners[t], -1];
    }

    /** Of each cell the mean of the corners of its triangles, as the shaders know it. */
    cellCenters() {
        const {points, arrays: {corners, owners}} = this, cells = this.header.cells;
        const sums = new Float64Array(3 * cells), counts = new Float64Array(cells);
        for (let side = 0; side < owners.length; ++side) {
            const cell = owners[side], t = this.isSolid ? side >> 1 : side;
            if (cell < 0)
                continue;
            counts[cell] += 3;
            for (let corner = 3 * t; corner < 3 * t + 3; ++corner)
                for (let i = 0; i < 3; ++i)
                    sums[3 * cell + i] += points[3 * corners[corner] + i];
        }
        return made(Float32Array, 3 * cells, i => sums[i] / (counts[Math.floor(i / 3)] || 1));
    }

    center(cell) {
        return vectorAt(this.centers, cell);
    }

    /** Whether a plane leaves a cell: cells are taken away whole, by their centers. */
    isKept(cell, cut) {
        const c = this.centers, i = 3 * cell;
        return cell >= 0 && cut[0] * c[i] + cut[1] * c[i + 1] + cut[2] * c[i + 2] <= cut[3];
    }

    /** Of the triangles with one side at a cell that is kept, 3 numbers each, as shaders count. */
    seenCorners(cut) {
        const {owners} = this.arrays, sides = this.isSolid ? 2 : 1;
        const isKept = made(Uint8Array, this.header.cells, cell => this.isKept(cell, cut));
        const at = cell => cell < 0 ? 0 : isKept[cell];
        const seen = new Uint32Array(3 * this.size);
        let size = 0;
        for (let t = 0; t < this.size; ++t)
            if (at(owners[sides * t]) !== (this.isSolid ? at(owners[2 * t + 1]) : 0))
                for (let i = 0; i < 3; ++i)
                    seen[size++] = 3 * t + i;
        return seen.subarray(0, size);
    }

    /** Tells whether a vertex is at something that the cut leaves to be seen. */
    seenVertices(cut) {
        if (!this.isSolid)
            return () => true;
        const isSeen = new Uint8Array(this.points.length / 3);
        for (const corner of this.seenCorners(cut))
            isSeen[this.arrays.corners[corner]] = 1;
        return vertex => isSeen[vertex] === 1;
    }

    /** The vertices at the true edges of a cell, ascending; linear time. */
    vertices(cell) {
        const found = new Set();
        for (let t = 0; t < this.size; ++t) {
            if (!this.owners(t).includes(cell))
                continue;
            for (let s = 0; s < 3; ++s)
                if ((this.arrays.sides[t] >> 2 * s & 3) === 1) {
                    found.add(this.corners(t)[s]);
                    found.add(this.corners(t)[(s + 1) % 3]);
                }
        }
        return [...found].sort((a, b) => a - b);
    }

    /** Lines as the shader reads them: both ends, each with a number beside it. */
    lineTexels(count, ends) {
        const texels = new Float32Array(8 * count);
        for (let i = 0; i < count; ++i)
            texels.set(ends(i).flat(), 8 * i);
        return texels;
    }

    dualLines() {
        return this.segments(this.arrays.dual_points, this.arrays.dual_lines);
    }

    /** Lines along the arrows that come with a field, or none. */
    flowLines(field) {
        const given = field ? this.givenArrows(field) : -1, lines = this.arrays[`flow${given}`];
        return lines ? this.segments(this.arrays[`flow${given}_points`], lines) : null;
    }

    givenArrows(field) {
        return this.header.arrows.findIndex(each => each.field === field.name);
    }

    /** Each with the number of the point where it begins. */
    segments(points, lines) {
        const places = this.places(points);
        return this.lineTexels(lines.length / 2, i => [
            [...vectorAt(places, lines[2 * i]), 0], [...vectorAt(places, lines[2 * i + 1]), lines[2 * i]]]);
    }

    curveLines(field, values) {
        const {lines, line_cells: cells} = this.arrays;
        const value = (v, i) => !field ? 0 : values[field.place === "vertex" ? v : cells[i]];
        return this.lineTexels(lines.length / 2, i => [0, 1].map(end => [
            ...this.point(lines[2 * i + end]), value(lines[2 * i + end], i)]));
    }

    /** Arrows of a field, or none: heads on its lines, or else by vectors that come with it, or its
     * own. */
    arrowLines(field, step) {
        if (!field)
            return null;
        const given = this.givenArrows(field), lines = this.arrays[`flow${given}`];
        if (lines && !this.header.arrows[given].lines_alone)
            return this.arrowTexels(headsOn(this.places(this.arrays[`flow${given}_points`]), lines));
        if (given >= 0) {
            const {all, most} = this.givenVectors(given);
            return this.spreadArrows(this.places(this.arrays[`sites${given}`]),
                all[Math.min(step, all.length - 1)], most, `given${given}`);
        }
        if (field.components < 3)
            return null;
        return this.spreadArrows(field.place === "vertex" ? this.points : this.centers,
            field.rows[step], field.high, field.place);
    }

    /** The vectors that come with a field, at every step or once for all, and the longest one. */
    givenVectors(given) {
        this.vectors ??= [];
        if (!this.vectors[given]) {
            const once = this.arrays[`vectors${given}`];
            const all = once ? [once]
                : this.header.steps.map((_, s) => this.arrays[`vectors${given}.${s}`]);
            this.vectors[given] = {all, most: longest(all)};
        }
        return this.vectors[given];
    }

    /** The places of one kind are chosen once. The longest vector of all steps is known. */
    spreadArrows(sites, vectors, most, kind) {
        this.spots ??= {};
        const spots = this.spots[kind] ??= arrowSpots(this, sites);
        this.arrowLength = spots.length;
        return this.arrowTexels(arrowsAt(spots, vectors, most));
    }

    arrowTexels(arrows) {
        return this.lineTexels(arrows.length, i => arrows[i].map(p => [...p, 0]));
    }

    /** What arrows must not cross: the sides of triangles on the boundary, of solids the triangles. */
    walls() {
        const {corners} = this.arrays, walls = [];
        if (this.isCurve)
            return walls;
        if (this.isSolid) {
            for (let t = 0; t < this.size; ++t)
                if (this.owners(t)[1] < 0)
                    walls.push([...this.corners(t)].map(v => this.point(v)));
            return walls;
        }
        const count = this.points.length / 3, sides = new Float64Array(corners.length);
        for (let i = 0; i < corners.length; ++i) {
            const a = corners[i], b = corners[i % 3 < 2 ? i + 1 : i - 2];
            sides[i] = Math.min(a, b) * count + Math.max(a, b);
        }
        sides.sort();
        for (let i = 0; i < sides.length; ++i)
            if (sides[i] !== sides[i - 1] && sides[i] !== sides[i + 1])
                walls.push([Math.floor(sides[i] / count), sides[i] % count].map(v => this.point(v)));
        return walls;
    }
}
