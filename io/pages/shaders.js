// SPDX-License-Identifier: MIT
// What the graphics card does. Numbers of the mesh are in textures, 2048 to a row.

const common = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
uniform vec3 right, up, eye;
uniform vec2 shift;
uniform float zoom, aspect, pixel;
uniform vec4 cut; // cells are kept whose center c has dot(cut.xyz, c) <= cut.w
ivec2 at(int i) { return ivec2(i & 2047, i >> 11); }
vec4 seen(vec3 p, float nearer) {
    vec2 q = zoom * vec2(dot(right, p), dot(up, p)) + shift;
    return vec4(q.x / aspect, q.y, -0.3 * dot(eye, p) - nearer, 1.0);
}
`;

const coloring = `
uniform vec3 map[${mapSize}];
uniform vec2 range; // values at the ends of the map, or their logarithms
uniform bool logarithmic;
float part_of(float value) { // of the map; beyond its ends, too
    float x = logarithmic ? log(max(value, 1e-37)) : value;
    return range.y > range.x ? (x - range.x) / (range.y - range.x) : 0.5;
}
vec3 color_of(float value) {
    float x = clamp(part_of(value), 0.0, 1.0) * ${(mapSize - 1).toFixed(1)};
    int i = min(int(x), ${mapSize - 2});
    return mix(map[i], map[i + 1], x - float(i));
}
`;

// places of values: 0 none, 1 vertices, 2 cells, 3 edges, 4 faces
const faceVertices = `${common}
uniform usampler2D triangles; // corners, sides
uniform usampler2D owners;    // the cells on both sides + 1, the face
uniform usampler2D edges;     // of the sides + 1
uniform sampler2D points, values, centers;
uniform int place;
uniform bool solid;
flat out ivec4 cell; // + 1, sides, triangle, which edges have values
flat out vec3 side_values;
out vec3 corner, where;
out float value;
bool kept(uint c) {
    return c > 0u && dot(cut.xyz, texelFetch(centers, at(int(c) - 1), 0).xyz) <= cut.w;
}
float value_at(int i) { return texelFetch(values, at(i), 0).x; }
void main() {
    int t = gl_VertexID / 3, i = gl_VertexID % 3;
    uvec4 triangle = texelFetch(triangles, at(t), 0), owner = texelFetch(owners, at(t), 0);
    bool first = kept(owner.x), second = solid && kept(owner.y);
    uint shown = first ? owner.x : owner.y;
    corner = vec3(i == 0, i == 1, i == 2);
    where = texelFetch(points, at(int(triangle[i])), 0).xyz;
    cell = ivec4(int(shown), int(triangle.w), t, 0);
    side_values = vec3(0.0);
    value = 0.0;
    if (place == 1) value = value_at(int(triangle[i]));
    if (place == 2 && shown > 0u) value = value_at(int(shown) - 1);
    if (place == 4) value = value_at(int(owner.z));
    if (place == 3) {
        uvec4 numbers = texelFetch(edges, at(t), 0);
        for (int s = 0; s < 3; ++s)
            if (numbers[s] > 0u) {
                side_values[s] = value_at(int(numbers[s]) - 1);
                cell.w |= 1 << s;
            }
    }
    gl_Position = first == second ? vec4(2.0, 2.0, 2.0, 1.0) : seen(where, 0.0);
}`;

const faceColors = `${common}${coloring}
uniform int place;
uniform bool ids, light, lines, removed_lines, levels;
uniform int picked;
uniform vec3 plain, edge_color, removed_color, picked_color, level_color;
flat in ivec4 cell;
flat in vec3 side_values;
in vec3 corner, where;
in float value;
out vec4 color;
float lit() {
    vec3 normal = cross(dFdx(where), dFdy(where));
    float size = length(normal);
    if (!light || size == 0.0) return 1.0;
    normal = normal / size * (dot(normal, eye) < 0.0 ? -1.0 : 1.0);
    return 0.74 + 0.26 * max(0.0, dot(normal, normalize(-0.35 * right + 0.7 * up + eye)));
}
float band(float distance, float width) {
    return 1.0 - smoothstep(width - 0.5, width + 0.5, distance);
}
void main() {
    int number = cell.z + 1;
    if (ids) {
        color = vec4(number & 255, number >> 8 & 255, number >> 16 & 255, number >> 24 & 255) / 255.0;
        return;
    }
    bool has_values = place == 1 || place == 2 || place == 4;
    vec3 c = has_values ? color_of(value) : plain;
    float brightness = lit();
    vec3 slope = sqrt(dFdx(corner) * dFdx(corner) + dFdy(corner) * dFdy(corner));
    vec3 heights = 1.0 / max(slope, 1e-6); // of the triangle, pixels
    float room = smoothstep(2.0, 7.0, min(heights.x, min(heights.y, heights.z)) / pixel);
    float x = 16.0 * part_of(value);
    float steep = fwidth(x);
    if (levels && place == 1 && steep > 1e-5)
        c = mix(c, level_color, 0.75 * band(abs(fract(x - 0.5) - 0.5) / steep, 0.6 * pixel) *
            (1.0 - smoothstep(0.2, 0.5, steep)));
    c *= brightness;
    for (int s = 0; s < 3; ++s) {
        int opposite = s == 0 ? 2 : s - 1;
        float distance = corner[opposite] * heights[opposite];
        int kind = cell.y >> 2 * s & 3;
        if ((cell.w >> s & 1) == 1)
            c = mix(c, color_of(side_values[s]), band(distance, 3.5 * pixel));
        if (kind == 2 && removed_lines)
            c = mix(c, removed_color, 0.9 * room * band(distance, 0.8 * pixel));
        if (kind == 1 && lines)
            c = mix(c, edge_color, (place == 3 ? 0.5 : 0.85) * room * band(distance, 0.7 * pixel));
        if (kind == 1 && cell.x == picked)
            c = mix(c, picked_color, band(distance, 2.0 * pixel));
    }
    color = vec4(c, 1.0);
}`;

// Two texels a line: its ends, and what their values or owners are.
const lineVertices = `${common}
uniform sampler2D ends, centers;
uniform vec2 half_size; // of the view, pixels
uniform float width, nearer;
uniform bool owned; // the second number is the cell that is to be kept
out float value;
void main() {
    int line = gl_VertexID / 6, corner = gl_VertexID % 6;
    vec4 from = texelFetch(ends, at(2 * line), 0), to = texelFetch(ends, at(2 * line + 1), 0);
    int far = corner == 1 || corner == 2 || corner == 4 ? 1 : 0;
    float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
    vec4 a = seen(from.xyz, nearer), b = seen(to.xyz, nearer);
    vec2 along = (b.xy - a.xy) * half_size;
    float size = length(along);
    vec2 across = size > 0.0 ? vec2(-along.y, along.x) / size : vec2(0.0, 1.0);
    gl_Position = far == 1 ? b : a;
    gl_Position.xy += side * 0.5 * width * pixel * across / half_size;
    value = far == 1 ? to.w : from.w;
    if (owned && dot(cut.xyz, texelFetch(centers, at(int(to.w)), 0).xyz) > cut.w)
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

const lineColors = `${common}${coloring}
uniform vec3 ink;
uniform bool valued;
in float value;
out vec4 color;
void main() { color = vec4(valued ? color_of(value) : ink, 1.0); }`;

// Two texels an arrow: where it begins, and the vector.
const arrowVertices = `${common}
uniform sampler2D ends;
uniform vec2 half_size;
uniform float width, nearer, edge; // pixels around the arrow
void main() {
    int arrow = gl_VertexID / 9, corner = gl_VertexID % 9;
    vec3 from = texelFetch(ends, at(2 * arrow), 0).xyz;
    vec3 along = texelFetch(ends, at(2 * arrow + 1), 0).xyz;
    vec4 a = seen(from - 0.5 * along, nearer), b = seen(from + 0.5 * along, nearer);
    vec2 ray = (b.xy - a.xy) * half_size;
    float size = length(ray);
    vec2 forth = size > 0.0 ? ray / size : vec2(0.0), across = vec2(-forth.y, forth.x);
    float head = min(0.5 * size, 4.5 * width * pixel), half_width = (0.5 * width + edge) * pixel;
    vec2 q[9] = vec2[9](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1),
        vec2(1, -3), vec2(2, 0), vec2(1, 3));
    float reach = q[corner].x == 0.0 ? 0.0 : q[corner].x == 1.0 ? size - head : size;
    vec2 place = reach * forth + min(q[corner].y * half_width, 0.6 * head) * across;
    float around = edge * pixel;
    if (corner >= 6)
        place = (reach + (q[corner].x == 2.0 ? 1.6 : -1.0) * around) * forth +
            sign(q[corner].y) * (0.45 * head + 1.6 * around) * across;
    gl_Position = mix(a, b, size > 0.0 ? reach / size : 0.0);
    gl_Position.xy = a.xy + place / half_size;
    if (dot(cut.xyz, from) > cut.w || size == 0.0)
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

const inkColors = `${common}
uniform vec3 ink;
out vec4 color;
void main() { color = vec4(ink, 1.0); }`;
