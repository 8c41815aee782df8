'use strict';
// Draws beads, one per segment: as ribbons that face the eye (many beads) or as tubes with six sides (few beads).
Filum.VERTEX = `
attribute vec4 corner;    // of the ribbon or tube: along the bead from 0 to 1, and across it
attribute vec3 from, to;
attribute vec3 size;      // width, height, layer (below 0: nothing)
attribute vec2 sizeTo;
attribute vec4 tone;
#ifdef LEANS
attribute vec3 up;
#else
const vec3 up = vec3(0.0, 0.0, 1.0);
#endif
uniform float low, high;
uniform vec3 eye;
varying vec3 vNormal;
varying vec3 vTone;
void main() {
    vec3 way = to - from;
    float len = length(way);
    if (size.z < low - 0.5 || size.z > high + 0.5 || len == 0.0) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
    vec3 t = way / len;
    vec3 side = cross(t, up);
    side = dot(side, side) < 1e-6 ? vec3(1.0, 0.0, 0.0) : normalize(side);
    vec3 above = normalize(cross(side, t));
    vec2 half_ = 0.5 * mix(size.xy, sizeTo.x > 0.0 ? sizeTo : size.xy, corner.x);
    // ends reach a little beyond, so that corners close
    vec3 at = from + way * corner.x + t * (corner.x * 2.0 - 1.0) * half_.x * 0.6 - up * half_.y;
#ifdef RIBBON
    vec3 look = normalize(eye - at);
    vec3 e = cross(t, look);
    e = dot(e, e) < 1e-8 ? side : normalize(e);
    float reach = length(vec2(half_.x * dot(e, side), half_.y * dot(e, above)));
    at += e * corner.y * reach;
    vNormal = e * corner.y * 0.9 + normalize(cross(e, t)) * sign(dot(cross(e, t), look)) * 0.6;
#else
    at += side * corner.y * half_.x + above * corner.z * half_.y;
    vNormal = normalize(side * corner.y / half_.x + above * corner.z / half_.y);
#endif
    vTone = tone.rgb;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(at, 1.0);
}`;
Filum.FRAGMENT = `
precision mediump float;
varying vec3 vNormal;
varying vec3 vTone;
void main() {
    vec3 n = normalize(vNormal);
    float light = 0.45 + 0.4 * max(0.0, dot(n, normalize(vec3(0.4, -0.6, 0.8)))) + 0.2 * max(0.0, dot(n, normalize(vec3(-0.7, 0.3, 0.4))));
    gl_FragColor = vec4(vTone * light, 1.0);
}`;


// A shape that is drawn once for every bead. All its corners are repeated for each bead, with what they need to know of
// it: software renderers and many drivers take far longer for small instances than for as many corners in one buffer.
Filum.Copies = class {
    constructor(corners, faces, room, defines, uniforms) {
        this.corners = corners.length;
        this.faces = faces.length;
        this.stride = defines.LEANS ? 14 : 11;
        this.data = new Float32Array(room * this.corners * this.stride);
        const g = new THREE.BufferGeometry(), n = room * this.corners;
        const corner = new Int8Array(4 * n), index = new Uint32Array(room * this.faces), one = corners.map(c => [...c, 0].map(v => Math.round(127 * v))).flat();
        for (let i = 0; i < room; i++) {
            corner.set(one, 4 * this.corners * i);
            for (let k = 0; k < this.faces; k++) index[i * this.faces + k] = i * this.corners + faces[k];
        }
        this.buffer = new THREE.InterleavedBuffer(this.data, this.stride);
        this.tone = new THREE.BufferAttribute(new Uint8Array(4 * n), 4, true);
        g.setAttribute('corner', new THREE.BufferAttribute(corner, 4, true));
        [['from', 3, 0], ['size', 3, 3], ['to', 3, 6], ['sizeTo', 2, 9], ['up', 3, 11]].forEach(([name, items, at]) => {
            if (at < this.stride) g.setAttribute(name, new THREE.InterleavedBufferAttribute(this.buffer, items, at));
        });
        g.setAttribute('position', g.attributes.from); // three.js asks for one
        g.setAttribute('tone', this.tone);
        g.setIndex(new THREE.BufferAttribute(index, 1));
        this.mesh = new THREE.Mesh(g, new THREE.ShaderMaterial({ vertexShader: Filum.VERTEX, fragmentShader: Filum.FRAGMENT, uniforms, defines, side: THREE.DoubleSide }));
        this.mesh.frustumCulled = false;
    }
    // The first `count` beads of `points` (six numbers for each: place, width, height, layer).
    fill(points, ups, count) {
        const d = this.data, step = this.stride, all = step * this.corners;
        for (let j = 0; j < count; j++) {
            const at = j * all;
            for (let k = 0; k < 11; k++) d[at + k] = points[6 * j + k];
            if (ups) for (let k = 0; k < 3; k++) d[at + 11 + k] = ups[3 * j + k];
            for (let k = 1; k < this.corners; k++) d.copyWithin(at + k * step, at, at + step);
        }
        this.buffer.needsUpdate = true;
    }
    paint(tones, count) { // RGBA of each bead
        const to = new Uint32Array(this.tone.array.buffer), from = new Uint32Array(tones.buffer);
        for (let j = 0; j < count; j++) to.fill(from[j], j * this.corners, (j + 1) * this.corners);
        this.tone.needsUpdate = true;
    }
    show(count) { this.mesh.geometry.setDrawRange(0, count * this.faces); }
};

Filum.Beads = class {
    constructor(p) {
        this.p = p;
        this.detail = new Filum.Detail(p);
        const largest = 400000; // beads
        this.room = Math.max(2, Math.min(this.detail.whole, largest));
        this.index = new Uint32Array(this.room); // the point of each bead, ascending
        this.points = new Float32Array(6 * (this.room + 1));
        this.tones = new Uint8Array(4 * this.room);
        if (p.c.nx.length) this.ups = new Float32Array(3 * this.room);
        this.uniforms = { low: { value: 0 }, high: { value: 1e9 }, eye: { value: new THREE.Vector3() } };
        this.object = new THREE.Group();
        this.ribbons = this.copies([[0, -1, 0], [1, -1, 0], [1, 1, 0], [0, 1, 0]], [0, 1, 2, 0, 2, 3], this.room, { RIBBON: 1 });
        this.most = Math.min(this.room, 20000); // beads of a picture, until the time of one is known
        this.shown = p.n - 1;
        this.select();
        this.fine(false);
    }
    copies(corners, faces, room, defines) {
        const out = new Filum.Copies(corners, faces, room, this.ups ? { ...defines, LEANS: 1 } : defines, this.uniforms);
        this.object.add(out.mesh);
        return out;
    }
    // Chooses the beads to draw. `seen` tells which places are in view; without it the choice holds for every view.
    select(seen) {
        const u = this.uniforms, until = seen ? this.shown : Infinity;
        const { chunks, level, step, all } = this.detail.choose(u.low.value, u.high.value, until, seen || (() => true), this.most);
        Object.assign(this, { level, step, all, inView: !!seen && !all, until, low: u.low.value, high: u.high.value });
        let j = 0;
        for (const k of chunks) {
            const a = this.detail.first[k], b = this.detail.last[k], layer = this.p.layers[this.detail.layer[k]];
            if (j + this.detail.counts[k * Filum.LEVELS + level] > this.room) break;
            for (let i = a; i <= b; i++) if (this.detail.level[i] >= level) this.put(j++, i, i === b ? -9 : layer);
        }
        this.used = j;
        this.ribbons.fill(this.points, this.ups, j);
        this.colour(this.colourOf);
        this.tubesHold = false;
        this.show(this.shown);
    }
    put(j, i, layer) {
        const c = this.p.c, d = this.points, m = this.p.middle;
        this.index[j] = i;
        d[6 * j] = c.x[i] / 1000 - m[0];
        d[6 * j + 1] = c.y[i] / 1000 - m[1];
        d[6 * j + 2] = c.z[i] / 1000 - m[2];
        d[6 * j + 3] = c.width[i] / 1000;
        d[6 * j + 4] = this.step * c.height[i] / 1000;
        d[6 * j + 5] = layer;
        if (this.ups) this.ups.set(i < c.nz.length ? [c.nx[i] / 1000, c.ny[i] / 1000, c.nz[i] / 1000] : [0, 0, 1], 3 * j);
    }
    // Whether the present choice has all beads that the layers and the path ask for.
    holds() { return this.uniforms.low.value >= this.low && this.uniforms.high.value <= this.high && this.shown <= this.until; }
    // Whether it has every bead of the layers with all of its points.
    complete() { return this.all && this.level === 0 && this.step === 1; }
    // Draws the beads before point `count` of the path.
    show(count) {
        this.shown = Math.min(count, this.p.n - 1);
        let n = 0, last = this.used;
        while (n < last) { const m = n + last >> 1; if (this.index[m] < this.shown) n = m + 1; else last = m; }
        this.drawn = n;
        this.ribbons.show(n);
        if (this.tubes) this.tubes.show(n);
        this.object.visible = n > 0;
    }
    // Draws tubes, or else ribbons; always ribbons if there are too many beads.
    fine(yes) {
        const room = Math.min(this.room, 60000), tubes = yes && this.used <= room;
        if (tubes && !this.tubes) {
            const sides = 6, around = [], faces = [];
            for (let k = 0; k < sides; k++) {
                const a = 2 * Math.PI * (k + 0.5) / sides, next = (k + 1) % sides;
                around.push([0, Math.cos(a), Math.sin(a)], [1, Math.cos(a), Math.sin(a)]);
                faces.push(2 * k, 2 * next, 2 * k + 1, 2 * next, 2 * next + 1, 2 * k + 1);
            }
            this.tubes = this.copies(around, faces, room, {});
        }
        if (tubes && !this.tubesHold) {
            this.tubes.fill(this.points, this.ups, this.used);
            this.tubes.paint(this.tones, this.used);
            this.tubes.show(this.drawn);
            this.tubesHold = true;
        }
        if (this.tubes) this.tubes.mesh.visible = tubes;
        this.ribbons.mesh.visible = !tubes;
    }
    colour(of) { // of(point): red, green, blue, 255
        if (!of) return;
        this.colourOf = of;
        for (let j = 0; j < this.used; j++) this.tones.set(of(this.index[j]), 4 * j);
        this.ribbons.paint(this.tones, this.used);
        this.tubesHold = false;
    }
    layers(low, high) { this.uniforms.low.value = low; this.uniforms.high.value = high; }
};
