// SPDX-License-Identifier: MIT
// Arrows that neither meet nor leave the mesh: which of many places have one, and how long it is.

const arrowsAcross = {surface: 30, solid: 14}; // at most, of the mesh

/** Things at places of space, found by the cubes around them. */
class Cubes {
    constructor(size) {
        this.size = size;
        this.lists = new Map();
    }

    key(x, y, z) {
        return ((x + 65536) * 131072 + y + 65536) * 131072 + z + 65536;
    }

    index(p) {
        return p.map(x => Math.floor(x / this.size));
    }

    /** Puts a thing into all cubes between two corners. */
    add(low, high, thing) {
        const [a, b] = [this.index(low), this.index(high)];
        for (let x = a[0]; x <= b[0]; ++x)
            for (let y = a[1]; y <= b[1]; ++y)
                for (let z = a[2]; z <= b[2]; ++z) {
                    const key = this.key(x, y, z), list = this.lists.get(key);
                    if (list)
                        list.push(thing);
                    else
                        this.lists.set(key, [thing]);
                }
    }

    isEmpty(p) {
        return !this.lists.has(this.key(...this.index(p)));
    }

    /** Everything within the size of a place, and more. */
    near(p) {
        const [x, y, z] = this.index(p), found = [];
        for (let i = x - 1; i <= x + 1; ++i)
            for (let j = y - 1; j <= y + 1; ++j)
                for (let k = z - 1; k <= z + 1; ++k)
                    found.push(...this.lists.get(this.key(i, j, k)) ?? []);
        return found;
    }
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

function toSegment(p, a, b) {
    const along = minus(b, a), size = dot(along, along);
    const t = size ? Math.min(1, Math.max(0, dot(minus(p, a), along) / size)) : 0;
    return apart(p, a.map((x, i) => x + t * along[i]));
}

/** The distance from a triangle, or from a segment, which has two corners. */
function toWall(p, wall) {
    const [a, b, c] = wall;
    let least = toSegment(p, a, b);
    if (!c)
        return least;
    least = Math.min(least, toSegment(p, b, c), toSegment(p, c, a));
    const normal = cross(minus(b, a), minus(c, a)), size = Math.sqrt(dot(normal, normal));
    const isInside = [[a, b], [b, c], [c, a]].every(
        ([from, to]) => dot(cross(minus(to, from), minus(p, from)), normal) >= 0);
    return isInside && size ? Math.min(least, Math.abs(dot(minus(p, a), normal)) / size) : least;
}

/** Numbers of places, each farther from the others than a distance. */
function chosenSites(sites, distance) {
    const coarse = new Cubes(distance / 2), fine = new Cubes(distance), chosen = [];
    for (let i = 0; i < sites.length / 3; ++i) {
        const p = vectorAt(sites, i);
        if (!coarse.isEmpty(p))
            continue; // the one there is near
        coarse.add(p, p, i);
        if (fine.near(p).some(q => apart(p, q) < distance))
            continue;
        fine.add(p, p, p);
        chosen.push(i);
    }
    return chosen;
}

/** Of places, how long an arrow with its middle there may be, and how long most are. */
function roomsAt(scene, places, distance) {
    const nearest = places.map(() => Infinity);
    for (let i = 0; i < places.length; ++i) // at most some thousands
        for (let j = 0; j < i; ++j) {
            const far = apart(places[i], places[j]);
            nearest[i] = Math.min(nearest[i], far);
            nearest[j] = Math.min(nearest[j], far);
        }
    const length = 0.8 * Math.min(0.4, [...nearest].sort((a, b) => a - b)[places.length >> 1] ?? 1);
    const reach = Math.max(distance, length);
    const walls = new Cubes(reach);
    for (const wall of scene.walls()) {
        const ends = pick => [0, 1, 2].map(i => pick(...wall.map(p => p[i])));
        walls.add(ends(Math.min), ends(Math.max), wall);
    }
    const rooms = places.map((p, i) => Math.min(0.8 * nearest[i], length, 1.9 * Math.min(
        ...walls.near(p).map(wall => toWall(p, wall)), reach)));
    return {length, rooms};
}

/** Where arrows stand among places of the scene. */
function arrowSpots(scene, sites) {
    const distance = 2 / (scene.isSolid ? arrowsAcross.solid : arrowsAcross.surface);
    const chosen = chosenSites(sites, distance);
    const places = chosen.map(i => vectorAt(sites, i));
    return {chosen, places, ...roomsAt(scene, places, distance)};
}

/** Each from tail to tip by its vector: as long as its room at the longest vector, or shorter, by
    the square root as in still.cpp, so that one long vector does not hide all others. */
function arrowsAt(spots, vectors, most) {
    return spots.chosen.map((row, i) => {
        const vector = vectorAt(vectors, row), size = Math.hypot(...vector);
        const length = Math.min(spots.length * Math.sqrt(size / (most || 1)), spots.rooms[i]);
        return [spots.places[i], vector.map(x => size ? x / size * length : 0)];
    });
}

/** Short arrows on lines, which run along a field: at even distances, and not at their ends. */
function headsOn(points, ends) {
    const every = 0.25, size = 0.035, heads = [];
    for (let first = 0, last; first < ends.length; first = last) {
        const line = [vectorAt(points, ends[first])], lengths = [0];
        for (last = first; last < ends.length && (last === first || ends[last] === ends[last - 1]); last += 2) {
            line.push(vectorAt(points, ends[last + 1]));
            lengths.push(lengths.at(-1) + apart(...line.slice(-2)));
        }
        const total = lengths.at(-1), count = Math.max(1, Math.floor(total / every));
        let i = 1;
        const along = length => {
            while (i > 1 && lengths[i - 1] > length)
                --i;
            while (i + 1 < lengths.length && lengths[i] < length)
                ++i;
            const t = (length - lengths[i - 1]) / (lengths[i] - lengths[i - 1] || 1);
            return line[i].map((x, c) => t * x + (1 - t) * line[i - 1][c]);
        };
        for (let n = 0; total > 2 * size && n < count; ++n) {
            const middle = (n + 0.5) * total / count;
            const [tail, tip] = [along(middle - size / 2), along(middle + size / 2)];
            heads.push([tail.map((x, c) => (x + tip[c]) / 2), minus(tip, tail)]);
        }
    }
    return heads;
}
