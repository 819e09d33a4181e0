// SPDX-License-Identifier: MIT
// What is at a place of the view, in words.

/** Barycentric coordinates of a place of the view in a triangle that is seen there. */
function coordinatesIn(place, corners) {
    const [a, b, c] = corners;
    const area = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    const all = area(a, b, c);
    return all === 0 ? [1, 0, 0]
        : [area(place, b, c) / all, area(place, c, a) / all, area(place, a, b) / all];
}

/** The triangle's cell that is seen: of two, the one that was not cut away. */
function cellAt(scene, triangle, look) {
    return scene.owners(triangle).find(cell => scene.isKept(cell, look.cut));
}

/** The line of a curve that passes nearest to a place; -1: none within some pixels. */
function lineAt(scene, place, camera, most) {
    let best = -1;
    for (let i = 0; i < scene.size; ++i) {
        const [a, b] = [0, 1].map(end => camera.seen(scene.point(scene.arrays.lines[2 * i + end])));
        const far = toSegment([...place, 0], [...a, 0], [...b, 0]);
        if (far < most)
            [best, most] = [i, far];
    }
    return best;
}

function valueText(field, number, step) {
    const values = [0, 1, 2].slice(0, field.components).map(
        c => numberText(field.rows[step][number * field.components + c]));
    const text = field.components === 1 ? values[0]
        : `(${values.join(", ")}), of length ${numberText(field.values[step][number])}`;
    return field.off ? `${text} (off by at most ${numberText(field.off, 2)})` : text;
}

/** Of a triangle that is seen at a place: numbers to show, and what the values are. */
function factsAt(scene, triangle, place, camera, look, field, step) {
    const corners = [...scene.corners(triangle)];
    const weights = coordinatesIn(place, corners.map(v => camera.seen(scene.point(v))));
    const nearest = corners[weights.indexOf(Math.max(...weights))];
    const cell = cellAt(scene, triangle, look);
    const facts = {cell, vertices: scene.vertices(cell), vertex: nearest,
        at: scene.original(scene.point(nearest))};
    if (!field)
        return facts;
    if (field.place === "vertex") {
        facts.here = corners.reduce((sum, v, i) => sum + weights[i] * field.values[step][v], 0);
        facts.number = nearest;
    } else if (field.place === "edge") {
        const edges = scene.arrays.edges.subarray(3 * triangle, 3 * triangle + 3);
        const order = [0, 1, 2].filter(s => edges[s] >= 0)
            .sort((s, t) => weights[(s + 2) % 3] - weights[(t + 2) % 3]);
        facts.number = order.length ? edges[order[0]] : undefined;
    } else {
        facts.number = field.place === "face" ? scene.arrays.faces[triangle] : cell;
    }
    if (facts.number !== undefined)
        facts.value = field.rows[step][facts.number * field.components];
    return facts;
}

function factsOfLine(scene, line, field, step) {
    const vertices = [...scene.arrays.lines.subarray(2 * line, 2 * line + 2)];
    const facts = {cell: scene.arrays.line_cells[line], vertices, vertex: vertices[0],
        at: scene.original(scene.point(vertices[0]))};
    if (field) {
        facts.number = field.place === "vertex" ? facts.vertex : facts.cell;
        facts.value = field.rows[step][facts.number * field.components];
    }
    return facts;
}

/** The facts as lines of text. */
function toldOf(facts, scene, field, step) {
    const kind = ["point", "edge", "polygon", "solid"][scene.header.dimension];
    const count = facts.vertices.length;
    const some = facts.vertices.slice(0, 40).join(", ") + (count > 40 ? ", .." : "");
    const lines = [
        `Cell ${facts.cell}: a ${kind} (degree ${scene.header.dimension}) with ${count} corners, the vertices ${some}`,
        `Nearest corner: vertex ${facts.vertex} at (${facts.at.map(x => numberText(x, 6)).join(", ")})`,
    ];
    if (field && facts.number !== undefined)
        lines.push(`${field.name} at ${field.place} ${facts.number}: ${valueText(field, facts.number, step)}`);
    if (facts.here !== undefined)
        lines.push(`${field.name} at this place, between the corners: ${numberText(facts.here)}`);
    return lines;
}
