// SPDX-License-Identifier: MIT
// Draws a scene by WebGL 2. All of it can be made anew, when the browser has lost what was there.

const textureWidth = 2048;
const kinds = {
    float1: ["R32F", "RED", "FLOAT", 1, Float32Array],
    float4: ["RGBA32F", "RGBA", "FLOAT", 4, Float32Array],
    whole4: ["RGBA32UI", "RGBA_INTEGER", "UNSIGNED_INT", 4, Uint32Array],
};
const places = {none: 0, vertex: 1, cell: 2, edge: 3, face: 4};

/** Puts rows of three numbers into a texture. */
const threes = numbers => (to, at, i) => {
    for (let c = 0; c < 3; ++c)
        to[at + c] = numbers[3 * i + c];
};

class Renderer {
    constructor(canvas, scene) {
        this.canvas = canvas;
        this.scene = scene;
        this.gl = canvas.getContext("webgl2", {antialias: false, preserveDrawingBuffer: true});
        if (!this.gl)
            throw new Error("this browser has no WebGL 2");
        this.restore();
    }

    /** Everything that is kept by the graphics card. */
    restore() {
        const {gl, scene} = this;
        this.programs = {
            lines: this.program(lineVertices, lineColors),
            arrows: this.program(arrowVertices, inkColors),
        };
        this.textures = {};
        gl.bindVertexArray(gl.createVertexArray());
        this.keep("centers", "float4", scene.centers.length / 3, threes(scene.centers));
        if (!scene.isCurve)
            this.restoreFaces();
        if (scene.arrays.dual_lines)
            this.keepTexels("dual", scene.dualLines());
        this.pickBuffer = gl.createFramebuffer();
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 1, 1);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickBuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        const depth = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, 1, 1);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        this.smooth = null;
    }

    /** Where a fine picture is drawn, four samples a pixel, before they are put together. */
    smoothBuffer() {
        const {gl, canvas: {width, height}} = this;
        if (this.smooth && this.smooth.width === width && this.smooth.height === height)
            return this.smooth.frame;
        const {frame, stores} = this.smooth ??
            {frame: gl.createFramebuffer(), stores: [gl.createRenderbuffer(), gl.createRenderbuffer()]};
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        [[gl.COLOR_ATTACHMENT0, gl.RGBA8], [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]].forEach(
            ([place, format], i) => {
                gl.bindRenderbuffer(gl.RENDERBUFFER, stores[i]);
                gl.renderbufferStorageMultisample(gl.RENDERBUFFER, 4, format, width, height);
                gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, stores[i]);
            });
        this.smooth = {frame, stores, width, height};
        return frame;
    }

    restoreFaces() {
        const {gl} = this, {arrays, size} = this.scene;
        this.programs.faces = this.program(faceVertices, faceColors);
        this.keepPoints();
        const {corners, sides, owners, faces, edges} = arrays, {isSolid} = this.scene;
        this.keep("triangles", "whole4", size, (to, at, t) => {
            for (let i = 0; i < 3; ++i)
                to[at + i] = corners[3 * t + i];
            to[at + 3] = sides[t];
        });
        this.keep("owners", "whole4", size, (to, at, t) => {
            to[at] = owners[isSolid ? 2 * t : t] + 1;
            to[at + 1] = isSolid ? owners[2 * t + 1] + 1 : 0;
            to[at + 2] = faces ? faces[t] : 0;
        });
        this.keep("edges", "whole4", edges ? size : 1, (to, at, t) => {
            for (let i = 0; edges && i < 3; ++i)
                to[at + i] = edges[3 * t + i] + 1;
        });
        this.keepTexels("values", new Float32Array(1), "float1");
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        this.cut = null;
    }

    keepPoints() {
        this.keep("points", "float4", this.scene.points.length / 3, threes(this.scene.points));
    }

    /** Keeps the triangles that a cut leaves to be seen: of a solid there are far fewer than all. */
    keepSeen(cut) {
        if (this.cut && this.cut.every((x, i) => x === cut[i]))
            return;
        const {gl} = this, seen = this.scene.seenCorners(cut);
        this.cut = [...cut];
        this.seen = seen.length;
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, seen, gl.DYNAMIC_DRAW);
    }

    program(vertices, colors) {
        const {gl} = this, program = gl.createProgram();
        for (const [kind, text] of [[gl.VERTEX_SHADER, vertices], [gl.FRAGMENT_SHADER, colors]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
            const logs = gl.getAttachedShaders(program).map(each => gl.getShaderInfoLog(each));
            throw new Error(`the graphics driver refuses a shader: ${logs.join(" ")} ${gl.getProgramInfoLog(program)}`);
        }
        const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0, places = {};
        for (let i = 0; i < count; ++i) {
            const {name, type} = gl.getActiveUniform(program, i);
            places[name.replace("[0]", "")] = {at: gl.getUniformLocation(program, name), type};
        }
        return {program, places};
    }

    /** A texture of as many entries, each four numbers, put where they belong. */
    keep(name, kind, count, put) {
        const texels = new kinds[kind][4](4 * count);
        for (let i = 0; i < count; ++i)
            put(texels, 4 * i, i);
        this.keepTexels(name, texels, kind);
    }

    keepTexels(name, numbers, kind = "float4") {
        const {gl} = this, [format, data, type, width, Numbers] = kinds[kind];
        const rows = Math.max(1, Math.ceil(numbers.length / width / textureWidth));
        if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE) && !gl.isContextLost())
            throw new Error("this mesh is larger than the graphics card can hold");
        const texels = new Numbers(width * textureWidth * rows);
        texels.set(numbers);
        if (this.textures[name])
            gl.deleteTexture(this.textures[name].texture);
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl[format], textureWidth, rows);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, textureWidth, rows, gl[data], gl[type], texels);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
            gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        this.textures[name] = {texture, count: numbers.length / width};
    }

    /** Makes a program the current one, with these values for what it asks for. */
    use(name, values) {
        const {gl} = this, {program, places} = this.programs[name];
        gl.useProgram(program);
        let unit = 0;
        for (const [uniform, {at, type}] of Object.entries(places)) {
            if (type === gl.SAMPLER_2D || type === gl.UNSIGNED_INT_SAMPLER_2D) {
                gl.activeTexture(gl.TEXTURE0 + unit);
                gl.bindTexture(gl.TEXTURE_2D, this.textures[values[uniform] ?? uniform].texture);
                gl.uniform1i(at, unit++);
            } else if (uniform in values) {
                this.set(at, type, values[uniform]);
            }
        }
    }

    set(at, type, value) {
        const {gl} = this;
        if (type === gl.FLOAT)
            gl.uniform1f(at, value);
        else if (type === gl.FLOAT_VEC2)
            gl.uniform2fv(at, value);
        else if (type === gl.FLOAT_VEC3)
            gl.uniform3fv(at, value.flat());
        else if (type === gl.FLOAT_VEC4)
            gl.uniform4fv(at, value);
        else
            gl.uniform1i(at, value);
    }

    /** The field that is seen, or null, at a step. */
    show(field, step) {
        this.field = field;
        // GPUs have floats alone: values are taken in parts of the largest one
        this.unit = field ? Math.max(Math.abs(field.low), Math.abs(field.high)) || 1 : 1;
        const shown = field ? field.values[step] : [0], {unit} = this;
        const values = made(Float32Array, shown.length, i => shown[i] / unit);
        if (this.scene.isCurve)
            this.keepTexels("curve", this.scene.curveLines(field, values));
        else
            this.keepTexels("values", values, "float1");
        const arrows = this.scene.arrowLines(field, step);
        this.hasArrows = arrows !== null;
        if (arrows)
            this.keepTexels("arrows", arrows);
        this.canvas.dataset.arrows = arrows ? arrows.length / 8 : 0;
        const flow = this.scene.flowLines(field);
        this.hasFlow = flow !== null;
        if (flow)
            this.keepTexels("flow", flow);
    }

    /** What all programs are told of the view. */
    view(camera, width, height, look) {
        return {
            right: camera.axes[0], up: camera.axes[1], eye: camera.axes[2],
            shift: [camera.x, camera.y], zoom: camera.zoom,
            aspect: width / height, pixel: look.pixel, cut: look.cut,
            half_size: [width / 2, height / 2],
        };
    }

    /** Draws, and gives the milliseconds that it took. Coarse pictures have edges with steps. */
    draw(camera, look, isCoarse) {
        const {gl, canvas: {width, height}} = this, begin = performance.now();
        const frame = isCoarse ? null : this.smoothBuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        this.drawAll(camera, look);
        if (frame) {
            gl.bindFramebuffer(gl.READ_FRAMEBUFFER, frame);
            gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
            gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for it
        return performance.now() - begin;
    }

    /** Of a scale, or null, as the shaders need it. */
    coloring(scale) {
        if (!scale)
            return {range: [0, 0], logarithmic: false, map: new Array(mapSize).fill([0, 0, 0])};
        const ends = scale.ends.map(x => x / this.unit);
        return {range: scale.isLog ? ends.map(Math.log) : ends, logarithmic: scale.isLog, map: scale.colors};
    }

    drawAll(camera, look) {
        const {gl, canvas} = this;
        gl.viewport(0, 0, canvas.width, canvas.height);
        gl.clearColor(...look.ground, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        const all = {
            ...this.view(camera, canvas.width, canvas.height, look), ids: false,
            ...this.coloring(look.scale),
        };
        if (!this.scene.isCurve)
            this.drawFaces(all, look);
        const lines = (name, more) => {
            this.use("lines", {...all, ends: name, ...more});
            gl.drawArrays(gl.TRIANGLES, 0, 3 * this.textures[name].count);
        };
        if (this.scene.isCurve)
            lines("curve", {owned: false, width: 4, nearer: 0, valued: this.field !== null,
                ink: look.edge_color});
        if (look.dual && this.textures.dual)
            lines("dual", {owned: true, width: 1.6, nearer: 0.0015, valued: false,
                ink: look.dual_color});
        const flow = (width, ink) => lines("flow", {owned: false, width, nearer: 0.003, valued: false, ink});
        if (look.flow && this.hasFlow && this.scene.hasPaths) {
            gl.disable(gl.DEPTH_TEST);
            flow(1, look.dual_color); // what is behind the mesh
            gl.enable(gl.DEPTH_TEST);
            flow(4, look.dual_color);
        } else if (look.flow && this.hasFlow) {
            flow(1.4, look.arrow_color);
        }
        if (look.arrows && this.hasArrows)
            this.drawArrows(all, look);
    }

    /** In a solid, arrows of the cells that are seen stand before them. Light edges set arrows off. */
    drawArrows(all, look) {
        const {gl, scene} = this, nearer = scene.isSolid ? 0.4 * scene.arrowLength : 0.004;
        for (const [edge, ink] of [[1.2, "arrow_edge"], [0, "arrow_color"]]) {
            this.use("arrows", {...all, ends: "arrows", width: 1.5, edge, nearer: nearer + (edge ? 0 : 0.001),
                ink: look[ink]});
            gl.drawArrays(gl.TRIANGLES, 0, 4.5 * this.textures.arrows.count);
        }
    }

    drawFaces(all, look) {
        const {gl, scene} = this;
        this.keepSeen(look.cut);
        this.use("faces", {...look, ...all, solid: scene.isSolid,
            place: this.field ? places[this.field.place] : 0});
        gl.drawElements(gl.TRIANGLES, this.seen, gl.UNSIGNED_INT, 0);
    }

    /** The triangle at a place of the view, which has so many pixels; -1: none. */
    triangleAt([x, y], [width, height], camera, look) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickBuffer);
        gl.viewport(-Math.floor((width + x * height) / 2), -Math.floor((1 + y) * height / 2), width, height);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        this.drawFaces({...this.view(camera, width, height, look), ids: true, ...this.coloring(null)}, look);
        const bytes = new Uint8Array(4);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        return (bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24) - 1;
    }
}
