'use strict';
// The view of one program in three dimensions. All views share one camera: `where`, relative to the middle of the first
// program.
Filum.where = { turn: -0.9, rise: 0.6, far: 3, at: [0, 0, 0] };
Filum.TUBE = 3; // the time of a tube by that of a ribbon
Filum.LOOKS = { iso: [-0.9, 0.6], top: [-Math.PI / 2, 1.5699], front: [-Math.PI / 2, 0], right: [0, 0] };

Filum.View = class {
    constructor(p, parent, changed) {
        this.p = p;
        this.changed = changed; // called when the camera was moved
        this.element = parent.appendChild(document.createElement('div'));
        this.element.className = 'view';
        this.canvas = this.element.appendChild(document.createElement('canvas'));
        this.canvas.tabIndex = 0;
        for (const name of ['name', 'said']) {
            this[name] = this.element.appendChild(document.createElement('div'));
            this[name].className = name;
        }
        this.name.textContent = p.name;
        this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true });
        this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera(35, 1, 0.1, 1000);
        this.camera.up.set(0, 0, 1);
        this.scene.add(new THREE.HemisphereLight(0xffffff, 0x667788, 0.9));
        const lamp = new THREE.DirectionalLight(0xffffff, 0.45);
        lamp.position.set(1, -2, 3);
        this.scene.add(lamp);
        if (p.n > 1) this.scene.add((this.beads = new Filum.Beads(p)).object);
        this.addTravels();
        this.addSurfaces();
        this.addNozzle();
        this.drawn = 0;
        this.handle();
        if (p.n < 2) this.showOutlines(true);
    }
    lines(points, colour) {
        const g = new THREE.BufferGeometry();
        g.setAttribute('position', new THREE.BufferAttribute(new Float32Array(points), 3));
        const l = new THREE.LineSegments(g, new THREE.LineBasicMaterial({ color: colour }));
        l.frustumCulled = false;
        this.scene.add(l);
        return l;
    }
    addTravels() {
        const p = this.p, points = [];
        this.travelEnds = []; // the last point of each line, ascending
        for (let s = 0; s < p.c.start.length; s++) {
            if (p.c.role[s] !== Filum.TRAVEL) continue;
            for (let i = p.c.start[s]; i + 1 < p.end(s); i++) {
                points.push(...this.place(i), ...this.place(i + 1));
                this.travelEnds.push(i + 1);
            }
        }
        this.travels = this.lines(points, 0xe0902a);
        this.travels.visible = false;
    }
    showOutlines(yes) {
        if (!this.outlines && yes) this.addOutlines();
        if (this.outlines) this.outlines.visible = yes;
        this.ask();
    }
    addOutlines() {
        const p = this.p, c = p.c, points = new Float32Array(6 * c.ox.length);
        for (let k = 0; k < c.ostart.length; k++) {
            const a = c.ostart[k], b = p.loopEnd(k), z = c.oz[k] / 1000 - p.middle[2];
            for (let i = a; i < b; i++)
                [i, i + 1 < b ? i + 1 : a].forEach((j, end) => points.set([c.ox[j] / 1000 - p.middle[0], c.oy[j] / 1000 - p.middle[1], z], 6 * i + 3 * end));
        }
        this.outlines = this.lines(points, 0x8896a6);
    }
    addSurfaces() {
        this.surfaces = this.p.surfaces.map((_, k) => {
            const p = this.p, at = n => p.c['s' + k + n], n = at('x').length, xyz = new Float32Array(3 * n);
            for (let i = 0; i < n; i++) [at('x'), at('y'), at('z')].forEach((col, d) => { xyz[3 * i + d] = col[i] / 1000 - p.middle[d]; });
            const g = new THREE.BufferGeometry();
            g.setAttribute('position', new THREE.BufferAttribute(xyz, 3));
            g.setAttribute('color', new THREE.BufferAttribute(new Float32Array(3 * n).fill(0.7), 3));
            g.setIndex(new THREE.BufferAttribute(Uint32Array.from(at('corner')), 1));
            g.computeVertexNormals();
            this.sink(g, xyz);
            const m = new THREE.Mesh(g, new THREE.MeshLambertMaterial({ vertexColors: THREE.VertexColors, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 }));
            m.frustumCulled = false;
            this.scene.add(m);
            return m;
        });
    }
    // Moves a surface away from the path by the height of a bead. So beads lie on it, and depths do not conflict.
    sink(g, xyz) {
        const c = this.p.c, normal = g.attributes.normal.array, front = this.p.facing();
        let high = 0;
        for (let i = 0; i < c.height.length; i++) high = Math.max(high, c.height[i] / 1000);
        if (!high) return;
        let sum = [0, 0, 0];
        for (let i = 0; i < normal.length; i += 3) sum = sum.map((v, d) => v + normal[i + d]);
        const side = front && front[0] * sum[0] + front[1] * sum[1] + front[2] * sum[2] < 0 ? -1 : 1;
        for (let i = 0; i < xyz.length; i++) xyz[i] -= side * 1.1 * high * normal[i];
    }
    // Colours surfaces by a field; grey for surfaces without it.
    field(name) {
        this.surfaces.forEach((m, k) => {
            const which = this.p.surfaces[k].findIndex(f => f[0] === name), colour = m.geometry.attributes.color;
            const values = which < 0 ? null : this.p.c['s' + k + 'f' + which];
            for (let i = 0; i < colour.count; i++) {
                const c = !values ? [170, 178, 188] : values[i] < 0 ? [90, 90, 90] : Filum.ramp(values[i] / 65535);
                colour.setXYZ(i, c[0] / 255, c[1] / 255, c[2] / 255);
            }
            colour.needsUpdate = true;
        });
        this.ask();
    }
    addNozzle() {
        const g = new THREE.ConeGeometry(1, 2.5, 16);
        g.rotateX(-Math.PI / 2);
        g.translate(0, 0, 1.25);
        this.nozzle = new THREE.Mesh(g, new THREE.MeshLambertMaterial({ color: 0x0a6cff, transparent: true, opacity: 0.75 }));
        this.nozzle.scale.setScalar(Math.max(0.4, this.p.radius / 40));
        this.nozzle.visible = false;
        this.scene.add(this.nozzle);
    }
    place(i) { const p = this.p, c = p.c; return [c.x[i] / 1000 - p.middle[0], c.y[i] / 1000 - p.middle[1], c.z[i] / 1000 - p.middle[2]]; }

    // --- what is shown ---
    path(count) {
        if (!this.beads) return;
        this.beads.show(count);
        if (!this.beads.holds()) this.beads.select();
        let n = 0, last = this.travelEnds.length;
        while (n < last) { const m = n + last >> 1; if (this.travelEnds[m] <= count) n = m + 1; else last = m; }
        this.travels.geometry.setDrawRange(0, 2 * n);
        this.nozzle.visible = count < this.p.n - 1;
        this.nozzle.position.set(...this.place(Math.min(count, this.p.n - 1)));
        this.ask();
    }
    layers(low, high) {
        if (this.beads) {
            this.beads.layers(low, high);
            if (!this.beads.holds() || !this.beads.complete()) this.beads.select();
        }
        this.ask();
    }
    colour(of) { if (this.beads) this.beads.colour(of); this.ask(); }
    fly(x, y, z, radius) {
        const m = this.p.middle;
        Object.assign(Filum.where, { at: [x - m[0], y - m[1], z - m[2]] });
        if (radius) Filum.where.far = radius / this.p.radius * 3;
        this.changed();
    }

    // --- drawing, when asked ---
    ask() {
        if (this.asked) return;
        this.asked = requestAnimationFrame(() => { this.asked = 0; this.draw(false); this.settle(); });
    }
    // A picture that stands still gets the beads that are in view, with as many points as there is time for, and tubes.
    settle() {
        clearTimeout(this.settling);
        if (!this.beads || this.cost === undefined) return;
        const patience = 800, tubes = () => Filum.TUBE * this.cost * this.beads.used < patience; // ms
        const rest = () => {
            const moving = this.beads.most;
            if (!this.beads.complete()) {
                this.beads.most = Math.max(moving, Math.min(this.beads.room, Math.round(patience / this.cost)));
                this.beads.select(this.frustum());
                this.beads.most = moving;
            }
            this.draw(tubes());
            this.describe();
        };
        if (tubes() || !this.beads.complete()) this.settling = setTimeout(rest, 250);
    }
    // Whether a ball may be in view, as a function of its middle and radius.
    frustum() {
        const f = new THREE.Frustum(), ball = new THREE.Sphere(), set = f.setFromProjectionMatrix || f.setFromMatrix; // its name before three.js 111
        set.call(f, new THREE.Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse));
        return (x, y, z, radius) => { ball.center.set(x, y, z); ball.radius = radius; return f.intersectsSphere(ball); };
    }
    // Tells what is left out of the picture.
    describe() {
        const b = this.beads, coarse = [b.step > 1 && 'one of ' + b.step + ' layers', b.level > 0 && 'fewer points'].filter(Boolean);
        this.name.textContent = this.p.name + (coarse.length ? ' (drawn with ' + coarse.join(' and ') + ': zoom in, or show fewer layers, for all)' : '');
    }
    draw(fine) {
        const w = this.element.clientWidth, h = this.element.clientHeight, at = Filum.where;
        if (!w || !h) return;
        if (this.canvas.clientWidth !== this.w || h !== this.h) this.renderer.setSize(this.w = w, this.h = h, false);
        const r = this.p.radius, far = at.far * r * Math.max(1, h / w), k = Math.cos(at.rise);
        this.camera.aspect = w / h;
        this.camera.near = far / 200;
        this.camera.far = far + 4 * r;
        this.camera.updateProjectionMatrix();
        this.camera.position.set(at.at[0] + far * k * Math.cos(at.turn), at.at[1] + far * k * Math.sin(at.turn), at.at[2] + far * Math.sin(at.rise));
        this.camera.lookAt(...at.at);
        this.camera.updateMatrixWorld();
        if (this.beads) {
            const look = this.camera.matrixWorldInverse.elements.join();
            if (this.beads.used > this.beads.most && look !== this.look) this.beads.select(); // for a moving picture
            this.look = look;
            this.beads.fine(fine || (this.cost !== undefined && Filum.TUBE * this.cost * this.beads.used < 30));
            this.beads.uniforms.eye.value.copy(this.camera.position);
        }
        this.renderer.setClearColor(getComputedStyle(document.documentElement).getPropertyValue('--back').trim());
        this.renderer.render(this.scene, this.camera);
        if (this.beads && this.cost === undefined) this.time();
        this.drawn++;
    }

    // Measures ms per bead: reading a pixel waits until drawing ends. So many beads are drawn as a moving picture has
    // time for.
    time() {
        const gl = this.renderer.getContext(), wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        const patience = 60; // ms
        wait();
        const began = performance.now();
        this.renderer.render(this.scene, this.camera);
        wait();
        this.cost = (performance.now() - began) / Math.max(1, this.beads.drawn);
        this.beads.most = Math.max(10000, Math.min(this.beads.room, Math.round(patience / this.cost)));
    }

    // --- the hand ---
    handle() {
        let held = null;
        this.canvas.addEventListener('contextmenu', e => e.preventDefault());
        this.canvas.addEventListener('pointerdown', e => { held = { x: e.clientX, y: e.clientY, far: 0, shift: e.button === 2 || e.shiftKey }; this.canvas.setPointerCapture(e.pointerId); });
        this.canvas.addEventListener('pointermove', e => {
            if (!held) return;
            const dx = e.clientX - held.x, dy = e.clientY - held.y, at = Filum.where;
            held.x = e.clientX; held.y = e.clientY; held.far += Math.abs(dx) + Math.abs(dy);
            if (held.shift) this.slide(dx, dy);
            else {
                at.turn -= dx * 0.008;
                at.rise = Math.max(-1.5699, Math.min(1.5699, at.rise + dy * 0.008));
            }
            this.changed();
        });
        this.canvas.addEventListener('pointerup', e => { if (held && held.far < 4) this.pick(e); held = null; });
        this.canvas.addEventListener('wheel', e => {
            e.preventDefault();
            Filum.where.far = Math.max(0.005, Math.min(20, Filum.where.far * Math.exp(e.deltaY * 0.001)));
            this.changed();
        }, { passive: false });
    }
    slide(dx, dy) {
        const unit = 2 * Math.tan(35 / 2 * Math.PI / 180) * Filum.where.far * this.p.radius / this.h, m = this.camera.matrix.elements;
        Filum.where.at = Filum.where.at.map((v, k) => v - dx * unit * m[k] + dy * unit * m[4 + k]);
    }
    // Describes the bead under the pointer that is nearest to the eye.
    pick(e) {
        if (!this.beads) return;
        const box = this.canvas.getBoundingClientRect(), u = this.beads.uniforms;
        const px = e.clientX - box.left, py = e.clientY - box.top, m = new THREE.Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse).elements;
        const d = this.beads.points, at = i => {
            const x = d[6 * i], y = d[6 * i + 1], z = d[6 * i + 2], w = m[3] * x + m[7] * y + m[11] * z + m[15];
            return [(1 + (m[0] * x + m[4] * y + m[8] * z + m[12]) / w) * box.width / 2, (1 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / w) * box.height / 2, w];
        };
        let best = -1, nearest = Infinity;
        for (let i = 0; i < this.beads.drawn; i++) {
            const layer = d[6 * i + 5];
            if (layer < u.low.value - 0.5 || layer > u.high.value + 0.5) continue;
            const a = at(i), b = at(i + 1), wx = b[0] - a[0], wy = b[1] - a[1];
            const t = Math.max(0, Math.min(1, ((px - a[0]) * wx + (py - a[1]) * wy) / (wx * wx + wy * wy || 1)));
            const off = Math.hypot(a[0] + t * wx - px, a[1] + t * wy - py), w = a[2] + t * (b[2] - a[2]);
            if (off < 5 && w < nearest) { nearest = w; best = i; }
        }
        this.tell(best < 0 ? best : this.beads.index[best]);
    }
    tell(i) {
        const p = this.p, c = p.c;
        if (i < 0) { this.said.textContent = ''; return; }
        const s = p.spanOf[i], kind = Filum.FEATURES[c.feature[s]] || Filum.ROLES[c.role[s]];
        this.said.textContent = kind + ', stroke ' + (c.stroke[s] + 1) + ', layer ' + c.layer[s] + ', tool ' + c.tool[s] + '\n' +
            'at ' + [c.x[i], c.y[i], c.z[i]].map(v => (v / 1000).toFixed(3)).join(', ') + ' mm, point ' + i + '\n' +
            (c.role[s] === Filum.TRAVEL ? '' : (c.width[i] / 1000).toFixed(3) + ' wide, ' + (c.height[i] / 1000).toFixed(3) + ' high, ' + (c.speed[i] / 1000).toFixed(1) + ' mm/s');
    }
};
