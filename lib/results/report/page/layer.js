'use strict';
// Draws one layer from above in true widths. Outlines are filled with the colour of voids, and beads are drawn over
// them.
Filum.Flat = class {
    constructor(canvas, said, note) {
        Object.assign(this, { canvas, said, note });
        this.zoom = 1; this.shift = [0, 0];
        canvas.addEventListener('wheel', e => { e.preventDefault(); this.zoom = Math.max(0.5, Math.min(200, this.zoom * Math.exp(-e.deltaY * 0.001))); this.draw(); }, { passive: false });
        let held = null;
        canvas.addEventListener('pointerdown', e => { held = [e.clientX, e.clientY]; canvas.setPointerCapture(e.pointerId); });
        canvas.addEventListener('pointermove', e => {
            if (!held) return;
            this.shift = [this.shift[0] + (e.clientX - held[0]) / this.scale, this.shift[1] - (e.clientY - held[1]) / this.scale];
            held = [e.clientX, e.clientY];
            this.draw();
        });
        canvas.addEventListener('pointerup', () => { held = null; });
        canvas.addEventListener('dblclick', () => { this.zoom = 1; this.shift = [0, 0]; this.draw(); });
    }
    show(p, layer, path, tones) {
        Object.assign(this, { p, layer, path, tones });
        this.draw();
    }
    // Shows a place of the part in the middle, enlarged by `zoom`.
    look(x, y, zoom) { this.shift = [this.p.middle[0] - x, this.p.middle[1] - y]; this.zoom = zoom; this.draw(); }
    draw() {
        const { canvas, p } = this, w = canvas.clientWidth, h = canvas.clientHeight;
        if (!p || !w) return;
        const dense = Math.min(2, window.devicePixelRatio);
        canvas.width = w * dense; canvas.height = h * dense;
        const g = canvas.getContext('2d'), css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
        const fit = 0.94 * Math.min(w / Math.max(0.1, p.hi[0] - p.lo[0]), h / Math.max(0.1, p.hi[1] - p.lo[1]));
        this.scale = fit * this.zoom;
        const k = dense * this.scale;
        g.setTransform(k, 0, 0, -k, dense * w / 2 - k * (p.middle[0] - this.shift[0]), dense * h / 2 + k * (p.middle[1] - this.shift[1]));
        this.fillOutlines(g, css);
        this.strokeBeads(g);
        this.ruler(g, dense, h, css);
        const loops = this.p.loopsOf.get(this.layer) || [], spans = this.p.spansOf.get(this.layer) || [];
        this.said.textContent = 'layer ' + this.layer + ' from above: ' + new Set(spans.map(s => p.c.stroke[s])).size + ' strokes, ' + loops.length + ' outlines';
        this.note.textContent = loops.length ? 'Red: not covered. Scroll to zoom, drag to pan, double-click to reset.' :
            'No outlines are in this page, so voids do not show: give them by --regions.';
    }
    fillOutlines(g, css) {
        const p = this.p, c = p.c;
        g.beginPath();
        for (const loop of p.loopsOf.get(this.layer) || []) {
            for (let i = c.ostart[loop]; i < p.loopEnd(loop); i++) g[i === c.ostart[loop] ? 'moveTo' : 'lineTo'](c.ox[i] / 1000, c.oy[i] / 1000);
            g.closePath();
        }
        g.fillStyle = css('--void');
        g.fill('evenodd');
    }
    strokeBeads(g) {
        const p = this.p, c = p.c;
        g.lineCap = g.lineJoin = 'round';
        for (const s of p.spansOf.get(this.layer) || []) {
            for (let i = c.start[s]; i + 1 < p.end(s) && i < this.path; i++) {
                this.line(g, i, v => (v + 255) / 2, (c.width[i] + c.width[i + 1]) / 2000);
            }
        }
        for (const s of p.spansOf.get(this.layer) || [])
            for (let i = c.start[s]; i + 1 < p.end(s) && i < this.path; i++) this.line(g, i, v => 0.8 * v, 1.2 / this.scale);
        g.strokeStyle = 'rgba(128,128,128,0.6)';
        g.lineWidth = 1 / this.scale;
        g.beginPath();
        for (const loop of p.loopsOf.get(this.layer) || []) {
            for (let i = c.ostart[loop]; i < p.loopEnd(loop); i++) g[i === c.ostart[loop] ? 'moveTo' : 'lineTo'](c.ox[i] / 1000, c.oy[i] / 1000);
            g.closePath();
        }
        g.stroke();
    }
    line(g, i, shade, width) {
        const c = this.p.c, tone = this.tones(i), t = k => Math.round(shade(tone[k]));
        g.strokeStyle = 'rgb(' + t(0) + ',' + t(1) + ',' + t(2) + ')';
        g.lineWidth = width;
        g.beginPath();
        g.moveTo(c.x[i] / 1000, c.y[i] / 1000);
        g.lineTo(c.x[i + 1] / 1000, c.y[i + 1] / 1000);
        g.stroke();
    }
    ruler(g, dense, h, css) {
        const rough = 80 / this.scale, power = 10 ** Math.floor(Math.log10(rough)), mm = [5, 2, 1].map(m => m * power).find(v => v <= rough);
        g.setTransform(dense, 0, 0, dense, 0, 0);
        g.fillStyle = g.strokeStyle = css('--ink');
        g.lineWidth = 2;
        g.beginPath(); g.moveTo(10, h - 10); g.lineTo(10 + mm * this.scale, h - 10); g.stroke();
        g.font = '12px system-ui';
        g.fillText(mm + ' mm', 10, h - 16);
    }
};
