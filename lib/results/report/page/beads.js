'use strict';
// Draws beads as instances, one per segment: as ribbons that face the eye (many beads) or as tubes with six sides (few
// beads).
Filum.VERTEX = `
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
    vec2 half_ = 0.5 * mix(size.xy, sizeTo.x > 0.0 ? sizeTo : size.xy, position.x);
    // ends reach a little beyond, so that corners close
    vec3 at = from + way * position.x + t * (position.x * 2.0 - 1.0) * half_.x * 0.6 - up * half_.y;
#ifdef RIBBON
    vec3 look = normalize(eye - at);
    vec3 e = cross(t, look);
    e = dot(e, e) < 1e-8 ? side : normalize(e);
    float reach = length(vec2(half_.x * dot(e, side), half_.y * dot(e, above)));
    at += e * position.y * reach;
    vNormal = e * position.y * 0.9 + normalize(cross(e, t)) * sign(dot(cross(e, t), look)) * 0.6;
#else
    at += side * position.y * half_.x + above * position.z * half_.y;
    vNormal = normalize(side * position.y / half_.x + above * position.z / half_.y);
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

Filum.Beads = class {
    constructor(p) {
        const c = p.c, n = p.n, leans = c.nx.length > 0;
        const data = new Float32Array(6 * (n + 1));
        for (let i = 0; i < n; i++) {
            data[6 * i] = c.x[i] / 1000 - p.middle[0];
            data[6 * i + 1] = c.y[i] / 1000 - p.middle[1];
            data[6 * i + 2] = c.z[i] / 1000 - p.middle[2];
            data[6 * i + 3] = c.width[i] / 1000;
            data[6 * i + 4] = c.height[i] / 1000;
            data[6 * i + 5] = p.lays(i) ? c.layer[p.spanOf[i]] : -9;
        }
        this.points = data;
        this.buffer = new THREE.InstancedInterleavedBuffer(data, 6, 1);
        this.tone = new THREE.InstancedBufferAttribute(new Uint8Array(4 * n), 4, true);
        this.uniforms = { low: { value: 0 }, high: { value: 1e9 }, eye: { value: new THREE.Vector3() } };
        if (leans) {
            const up = new Float32Array(3 * n);
            for (let i = 0; i < n; i++) { up[3 * i] = c.nx[i] / 1000; up[3 * i + 1] = c.ny[i] / 1000; up[3 * i + 2] = (i < c.nz.length ? c.nz[i] : 1000) / 1000; }
            this.up = new THREE.InstancedBufferAttribute(up, 3);
        }
        this.ribbon = this.mesh([[0, -1, 0], [1, -1, 0], [1, 1, 0], [0, 1, 0]], [0, 1, 2, 0, 2, 3], { RIBBON: 1 }, leans);
        const sides = 6, around = [], faces = [];
        for (let k = 0; k < sides; k++) {
            const a = 2 * Math.PI * (k + 0.5) / sides, next = (k + 1) % sides;
            around.push([0, Math.cos(a), Math.sin(a)], [1, Math.cos(a), Math.sin(a)]);
            faces.push(2 * k, 2 * next, 2 * k + 1, 2 * next, 2 * next + 1, 2 * k + 1);
        }
        this.tube = this.mesh(around, faces, {}, leans);
        this.object = new THREE.Group();
        this.object.add(this.ribbon, this.tube);
        this.count = Math.max(0, n - 1);
        this.show(this.count);
        this.fine(false);
    }
    mesh(corners, faces, defines, leans) {
        const g = new THREE.InstancedBufferGeometry();
        g.setAttribute('position', new THREE.BufferAttribute(new Float32Array(corners.flat()), 3));
        g.setIndex(faces);
        const part = (items, offset) => new THREE.InterleavedBufferAttribute(this.buffer, items, offset);
        g.setAttribute('from', part(3, 0));
        g.setAttribute('size', part(3, 3));
        g.setAttribute('to', part(3, 6));
        g.setAttribute('sizeTo', part(2, 9));
        g.setAttribute('tone', this.tone);
        if (leans) { g.setAttribute('up', this.up); defines.LEANS = 1; }
        const m = new THREE.Mesh(g, new THREE.ShaderMaterial({ vertexShader: Filum.VERTEX, fragmentShader: Filum.FRAGMENT, uniforms: this.uniforms, defines, side: THREE.DoubleSide }));
        m.frustumCulled = false;
        return m;
    }
    show(count) {
        this.shown = Math.min(count, this.count);
        for (const m of [this.ribbon, this.tube]) m.geometry.maxInstancedCount = this.shown;
        this.object.visible = this.shown > 0;
    }
    fine(yes) { this.tube.visible = yes; this.ribbon.visible = !yes; }
    colour(tones) { this.tone.array.set(tones); this.tone.needsUpdate = true; }
    layers(low, high) { this.uniforms.low.value = low; this.uniforms.high.value = high; }
};
