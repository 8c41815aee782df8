'use strict';
// Chooses the beads of a program that are drawn, so that a picture is ready in time: all of them if there are few. Else
// those in view that no others hide, with fewer points, and with every second, fourth, ... layer, which is drawn as high as
// those it stands for.
//
// A chunk of the path is hidden if each place of it has beads on all six sides. Places are cubes, CUBES of them along the
// part.
//
// Points have levels. Level 0 is all points. Each level leaves out points of the one before that are near the line
// between their neighbours, but never two of them in a row: within an eighth of the bead's width at level 1, twice that at
// level 2, and so on. Paths are cut into chunks whose ends are in all levels, so each chunk can have a level of its own.
Filum.LEVELS = 5;
Filum.CUBES = 96;
Filum.Detail = class {
    constructor(p) {
        this.p = p;
        const c = p.c, layer = new Map(p.layers.map((l, k) => [l, k])), longest = 128; // points of a chunk
        const first = [], last = [], layers = [];
        for (let s = 0; s < c.start.length; s++) {
            if (c.role[s] === Filum.TRAVEL) continue;
            for (let i = c.start[s]; i + 1 < p.end(s); i += longest) {
                first.push(i);
                last.push(Math.min(i + longest, p.end(s) - 1));
                layers.push(layer.get(c.layer[s]));
            }
        }
        this.first = Uint32Array.from(first);
        this.last = Uint32Array.from(last);
        this.layer = Uint32Array.from(layers); // index among p.layers
        this.level = new Uint8Array(p.n); // per point: the highest level that has it
        this.counts = new Uint16Array(first.length * Filum.LEVELS); // per chunk and level: number of points
        this.ball = new Float32Array(4 * first.length); // per chunk: middle and radius, relative to p.middle
        for (let k = 0; k < first.length; k++) { this.rank(k); this.enclose(k); }
        this.whole = this.last.reduce((sum, last, k) => sum + last - this.first[k] + 1, 0); // points of all beads
    }
    // The levels of the points of a chunk.
    rank(k) {
        const c = this.p.c, a = this.first[k], b = this.last[k], at = k * Filum.LEVELS;
        let kept = [];
        for (let i = a; i <= b; i++) kept.push(i);
        this.counts[at] = kept.length;
        for (let l = 1; l < Filum.LEVELS; l++) {
            const next = [a], most = 2 ** (l - 4);
            for (let j = 1; j + 1 < kept.length; j++) {
                const before = next[next.length - 1], i = kept[j];
                if (before === kept[j - 1] && this.off(before, i, kept[j + 1]) <= most * c.width[i]) continue;
                next.push(i);
            }
            next.push(b);
            for (const i of next) this.level[i] = l;
            this.counts[at + l] = next.length;
            kept = next;
        }
        this.level[a] = this.level[b] = Filum.LEVELS - 1;
    }
    // The distance of point i from the line between a and b, um.
    off(a, i, b) {
        const { x, y, z } = this.p.c, ux = x[b] - x[a], uy = y[b] - y[a], uz = z[b] - z[a], vx = x[i] - x[a], vy = y[i] - y[a], vz = z[i] - z[a];
        const length2 = ux * ux + uy * uy + uz * uz, t = length2 ? Math.max(0, Math.min(1, (ux * vx + uy * vy + uz * vz) / length2)) : 0;
        return Math.hypot(vx - t * ux, vy - t * uy, vz - t * uz);
    }
    enclose(k) {
        const p = this.p, columns = [p.c.x, p.c.y, p.c.z];
        let square = 0;
        columns.forEach((column, d) => {
            let low = Infinity, high = -Infinity;
            for (let i = this.first[k]; i <= this.last[k]; i++) { low = Math.min(low, column[i]); high = Math.max(high, column[i]); }
            this.ball[4 * k + d] = (low + high) / 2000 - p.middle[d];
            square += (high - low) ** 2;
        });
        this.ball[4 * k + 3] = Math.sqrt(square) / 2000 + p.c.width[this.first[k]] / 1000;
    }
    // Calls f with the number of the cube of each place along a chunk, until f returns true. Cubes at the border of the
    // grid are free.
    visit(k, f) {
        const p = this.p, { x, y, z } = p.c, size = 1000 * Math.max(...p.hi.map((v, d) => v - p.lo[d])) / Filum.CUBES, n = Filum.CUBES + 3;
        const at = (a, b, t, d) => Math.floor((a + t * (b - a) - 1000 * p.lo[d]) / size) + 1;
        for (let i = this.first[k]; i < this.last[k];) {
            let j = i + 1;
            while (this.level[j] < Filum.LEVELS - 2) j++; // these are within half a bead of the path
            const steps = Math.ceil(Math.max(Math.abs(x[j] - x[i]), Math.abs(y[j] - y[i]), Math.abs(z[j] - z[i])) / size) || 1;
            for (let q = 0; q <= steps; q++)
                if (f((at(x[i], x[j], q / steps, 0) * n + at(y[i], y[j], q / steps, 1)) * n + at(z[i], z[j], q / steps, 2))) return true;
            i = j;
        }
        return false;
    }
    // Those of the chunks that are not hidden by others.
    exposed(chunks) {
        const n = Filum.CUBES + 3, full = new Uint8Array(n * n * n), sides = [1, -1, n, -n, n * n, -n * n];
        for (const k of chunks) this.visit(k, cube => { full[cube] = 1; });
        return chunks.filter(k => this.visit(k, cube => sides.some(side => !full[cube + side])));
    }
    // The chunks and the level to draw: those of layers `low` to `high` that begin before point `until` and are in view,
    // which seen(x, y, z, radius) tells; at most `most` points, unless the coarsest choice has more.
    choose(low, high, until, seen, most) {
        const layers = this.p.layers, few = 8; // so many layers are not thinned out
        let wanted = [], top = -1, bottom = layers.length, all = 0;
        for (let k = 0; k < this.first.length; k++) {
            const number = layers[this.layer[k]];
            if (number < low || number > high || this.first[k] >= until) continue;
            top = Math.max(top, this.layer[k]);
            bottom = Math.min(bottom, this.layer[k]);
            wanted.push(k);
            all += this.counts[k * Filum.LEVELS];
        }
        const count = wanted.length;
        if (all > most) wanted = this.exposed(wanted).filter(k => seen(...this.ball.subarray(4 * k, 4 * k + 4)));
        const per = new Map(); // points by layer and level
        for (const k of wanted) {
            if (!per.has(this.layer[k])) per.set(this.layer[k], new Array(Filum.LEVELS).fill(0));
            const sum = per.get(this.layer[k]);
            for (let j = 0; j < Filum.LEVELS; j++) sum[j] += this.counts[k * Filum.LEVELS + j];
        }
        let level = 0, step = 1;
        const points = () => { let n = 0; for (const [l, sum] of per) if ((top - l) % step === 0) n += sum[level]; return n; };
        for (let k = 0; points() > most; k++) {
            if (level < Filum.LEVELS - 1 && k % 2 === 0) level++;
            else if ((top - bottom + 1) / (2 * step) >= few) step *= 2;
            else if (level < Filum.LEVELS - 1) level++;
            else break;
        }
        return { chunks: wanted.filter(k => (top - this.layer[k]) % step === 0), level, step, all: wanted.length === count };
    }
};
