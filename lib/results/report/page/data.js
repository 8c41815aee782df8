'use strict';
// The programs in the page: their unpacked columns (lib/results/report/column.hpp), and values derived from them.
const Filum = {};

Filum.ROLES = ['bead', 'lift', 'jog', 'connector', 'travel', 'hairpin'];
Filum.FEATURES = ['', 'outer wall', 'wall', 'infill', 'solid', 'top', 'bottom', 'bridge', 'gap', 'ironing', 'support', 'interface', 'skirt', 'tower'];
Filum.TRAVEL = 4;
Filum.FILLS = new Set([0, 5]); // toolpath::Role: bead, hairpin
Filum.NOT_PART = new Set([10, 11, 12, 13]); // toolpath::Feature: support, interface, skirt, tower

Filum.unpack = async (text, n) => {
    const letters = atob(text), bytes = new Uint8Array(letters.length);
    for (let i = 0; i < bytes.length; i++) bytes[i] = letters.charCodeAt(i);
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    const raw = new Uint8Array(await new Response(stream).arrayBuffer());
    const out = new Int32Array(n);
    for (let i = 0, value = 0; i < n; i++) {
        const folded = raw[i] | raw[n + i] << 8 | raw[2 * n + i] << 16 | raw[3 * n + i] << 24;
        value = value + ((folded >>> 1) ^ -(folded & 1)) | 0;
        out[i] = value;
    }
    return out;
};

Filum.load = async element => {
    const about = JSON.parse(element.querySelector('script[type="application/json"]').textContent);
    const columns = {}, waiting = [];
    for (const script of element.querySelectorAll('script[data-column]')) {
        const name = script.dataset.column;
        waiting.push(Filum.unpack(script.textContent, about.columns[name]).then(c => { columns[name] = c; }));
    }
    await Promise.all(waiting);
    element.remove();
    return new Filum.Program(about, columns);
};

Filum.Program = class {
    constructor(about, c) {
        Object.assign(this, about);
        this.c = c;
        this.n = c.x.length;
        this.spanOf = new Uint32Array(this.n); // per point: index of its span
        for (let s = 0; s < c.start.length; s++) this.spanOf.fill(s, c.start[s], this.end(s));
        this.measure();
        this.bounds();
    }
    end(s) { return s + 1 < this.c.start.length ? this.c.start[s + 1] : this.n; }
    lays(i) { return this.c.width[i] > 0 && i + 1 < this.end(this.spanOf[i]); }
    length(i) {
        const c = this.c;
        return Math.hypot(c.x[i + 1] - c.x[i], c.y[i + 1] - c.y[i], c.z[i + 1] - c.z[i]) / 1000;
    }
    // The figure of that name as a number; if there are several, the first.
    figure(name) {
        const found = this.figures.find(f => f[1] === name && !f[0].startsWith('notes')), v = found ? parseFloat(found[2]) : NaN;
        return Number.isFinite(v) ? v : undefined;
    }
    // The value of a stage's setting, or undefined.
    told(stage, name) {
        for (const [program, settings] of this.made)
            if (program === stage) for (const [key, value] of settings) if (key === name) return value;
        return undefined;
    }
    // The kind of the job, which selects figures and colours.
    job() {
        if (this.surfaces.length || this.c.nx.length) return 'surface';
        if (this.told('fill', 'pattern') === 'scaffold') return 'scaffold';
        return this.c.feature.some(f => f > 0) ? 'hollow' : 'solid';
    }
    // The spacing of a scaffold, mm.
    spacing() {
        const told = +this.told('fill', 'spacing'), pore = this.told('fill', 'pore-size'), width = +this.told('fill', 'bead-width');
        return pore ? +pore + width : told || 2.5 * width;
    }
    // The direction that a surface is seen from: the mean tool axis of its path, or the mean normal of its area. Null
    // if there is no clear direction.
    facing() {
        const c = this.c, sum = [0, 0, 0];
        let all = 0;
        for (let i = 0; i < c.nx.length; i++) { sum[0] += c.nx[i]; sum[1] += c.ny[i]; sum[2] += c.nz[i]; all += 1000; }
        if (!all)
            this.surfaces.forEach((_, k) => {
                const at = n => c['s' + k + n], corner = at('corner'), x = at('x'), y = at('y'), z = at('z');
                for (let t = 0; t + 2 < corner.length; t += 3) {
                    const [p, q, r] = [corner[t], corner[t + 1], corner[t + 2]], a = [x[q] - x[p], y[q] - y[p], z[q] - z[p]], b = [x[r] - x[p], y[r] - y[p], z[r] - z[p]];
                    const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                    for (let d = 0; d < 3; d++) sum[d] += n[d];
                    all += Math.hypot(...n);
                }
            });
        const length = Math.hypot(...sum), least = 0.3; // a closed surface has no front
        return all > 0 && length > least * all ? sum.map(v => v / length) : null;
    }
    measure() {
        const c = this.c, layers = new Map();
        this.volumes = new Map(); // mm3 by role, in the groups of the colour 'role'
        this.along = new Float64Array(this.n); // mm extruded before each point
        this.sums = { laid: 0, travel: 0, volume: 0, moves: 0 };
        this.strokes = new Map(); // number -> first point, length
        for (let s = 0; s < c.start.length; s++) {
            const travel = c.role[s] === Filum.TRAVEL;
            let way = 0, volume = 0;
            if (s > 0) this.along[c.start[s]] = this.along[c.start[s] - 1];
            for (let i = c.start[s]; i + 1 < this.end(s); i++) {
                const d = this.length(i);
                way += d;
                this.along[i + 1] = this.along[i] + (travel ? 0 : d);
                if (!travel) volume += d * (c.width[i] * c.height[i] + c.width[i + 1] * c.height[i + 1]) / 2e6;
            }
            this.sums.volume += volume;
            const kind = c.feature[s] ? 100 + c.feature[s] : c.role[s];
            if (!travel) this.volumes.set(kind, (this.volumes.get(kind) || 0) + volume);
            this.sums[travel ? 'travel' : 'laid'] += way;
            if (travel) continue;
            this.sums.moves += this.end(s) - c.start[s] - 1;
            const stroke = this.strokes.get(c.stroke[s]) || { first: c.start[s], length: 0 };
            stroke.length += way;
            this.strokes.set(c.stroke[s], stroke);
            if (!layers.has(c.layer[s])) layers.set(c.layer[s], []);
            layers.get(c.layer[s]).push(s);
        }
        this.loopsOf = new Map();
        for (let k = 0; k < c.ostart.length; k++) {
            if (!this.loopsOf.has(c.olayer[k])) this.loopsOf.set(c.olayer[k], []);
            this.loopsOf.get(c.olayer[k]).push(k);
        }
        this.spansOf = layers;
        this.layers = [...new Set([...layers.keys(), ...this.loopsOf.keys()])].sort((a, b) => a - b);
    }
    bounds() {
        const lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity], c = this.c;
        const wide = (x, y, z) => {
            for (const [k, column] of [x, y, z].entries()) {
                let low = Infinity, high = -Infinity;
                for (let i = 0; i < column.length; i++) { const v = column[i]; if (v < low) low = v; if (v > high) high = v; }
                lo[k] = Math.min(lo[k], low); hi[k] = Math.max(hi[k], high);
            }
        };
        wide(c.x, c.y, c.z);
        wide(c.ox, c.oy, c.oz);
        this.surfaces.forEach((_, k) => wide(c['s' + k + 'x'], c['s' + k + 'y'], c['s' + k + 'z']));
        if (!(lo[0] <= hi[0])) { lo.fill(0); hi.fill(1000); }
        this.lo = lo.map(v => v / 1000); this.hi = hi.map(v => v / 1000);
        this.middle = this.lo.map((v, k) => (v + this.hi[k]) / 2);
        this.size = this.printed();
        this.radius = Math.max(0.1, Math.hypot(...this.hi.map((v, k) => v - this.lo[k])) / 2);
    }
    // The size of the printed part as toolpath::Extent defines it: mm along x, y and z.
    printed() {
        const c = this.c, lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity];
        const xyz = [c.x, c.y, c.z], axes = [c.nx, c.ny, c.nz];
        for (let s = 0; s < c.start.length; s++) {
            if (!Filum.FILLS.has(c.role[s]) || Filum.NOT_PART.has(c.feature[s])) continue;
            for (let i = c.start[s]; i < this.end(s); i++)
                for (let k = 0; k < 3; k++) {
                    const v = xyz[k][i], axis = i < c.nz.length ? axes[k][i] / 1000 : k === 2 ? 1 : 0;
                    const side = c.width[i] / 2 * Math.sqrt(Math.max(0, 1 - axis * axis)), down = c.height[i] * axis;
                    lo[k] = Math.min(lo[k], v - side - Math.max(0, down));
                    hi[k] = Math.max(hi[k], v + side + Math.max(0, -down));
                }
        }
        return lo.map((v, k) => v <= hi[k] ? (hi[k] - v) / 1000 : 0);
    }
    // The share of the extruded length before point i, and the first point with that share before it.
    share(i) { return this.sums.laid > 0 ? this.along[Math.min(i, this.n - 1)] / this.along[this.n - 1] : 1; }
    atShare(share) {
        const want = share * (this.n ? this.along[this.n - 1] : 0);
        let low = 0, high = Math.max(0, this.n - 1);
        while (low < high) { const m = low + high >> 1; if (this.along[m] < want) low = m + 1; else high = m; }
        return low;
    }
    loopEnd(k) { return k + 1 < this.c.ostart.length ? this.c.ostart[k + 1] : this.c.ox.length; }
};
