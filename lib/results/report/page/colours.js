'use strict';
// The colours of beads and their meaning.
Filum.RAMP = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
Filum.ramp = t => {
    const at = Math.min(0.99999, Math.max(0, t)) * (Filum.RAMP.length - 1), k = Math.floor(at), f = at - k;
    return Filum.RAMP[k].map((v, i) => v + (Filum.RAMP[k + 1][i] - v) * f);
};
Filum.distinct = i => { // hues step by the golden angle
    const h = (i * 0.381966 + 0.58) % 1, l = 0.5 + 0.12 * (i % 3 - 1) / 1.5, s = 0.62;
    const f = n => { const k = (n + h * 12) % 12; return l - s * Math.min(l, 1 - l) * Math.max(-1, Math.min(k - 3, 9 - k, 1)); };
    return [255 * f(0), 255 * f(8), 255 * f(4)];
};
Filum.ROLE_COLOURS = [[106, 168, 214], [45, 50, 58], [220, 80, 150], [210, 70, 60], [140, 146, 155], [170, 110, 220]];
Filum.FEATURE_COLOURS = [[0, 0, 0], [214, 69, 65], [240, 150, 50], [66, 120, 190], [165, 110, 175], [230, 200, 60], [150, 105, 80], [0, 170, 190],
    [190, 190, 190], [250, 150, 165], [70, 150, 70], [150, 205, 110], [115, 122, 132], [70, 70, 130]];
Filum.css = c => 'rgb(' + c.map(Math.round).join(',') + ')';

// Ways to colour, by name: 'ramp' gives a value per segment, 'kinds' a number and a word per span.
Filum.COLOURS = {
    stroke: { kinds: (p, s) => p.c.stroke[s], word: k => 'stroke ' + (k + 1) },
    progress: { ramp: (p, i) => i, unit: '', ends: ['start', 'end'] },
    role: {
        kinds: (p, s) => p.c.feature[s] ? 100 + p.c.feature[s] : p.c.role[s],
        word: k => k >= 100 ? Filum.FEATURES[k - 100] : Filum.ROLES[k],
        colour: k => k >= 100 ? Filum.FEATURE_COLOURS[k - 100] : Filum.ROLE_COLOURS[k]
    },
    layer: { ramp: (p, i) => p.c.layer[p.spanOf[i]], unit: '' },
    width: { ramp: (p, i) => p.c.width[i] / 1000, unit: 'mm' },
    speed: { ramp: (p, i) => p.c.speed[i] / 1000, unit: 'mm/s' },
    tool: { kinds: (p, s) => p.c.tool[s], word: k => 'tool ' + k },
    ply: { kinds: (p, s) => p.c.layer[s], word: k => 'ply ' + (k + 1) }
};
Filum.kindColour = (how, k) => (how.colour || Filum.distinct)(k);

// The range of a ramp over all programs, from the 1st to the 99th percentile of the extruding moves.
Filum.range = (how, programs) => {
    const values = [];
    for (const p of programs) {
        const step = Math.max(1, Math.floor(p.n / 20000));
        for (let i = 0; i < p.n; i += step) if (p.lays(i)) values.push(how.ramp(p, i));
    }
    values.sort((a, b) => a - b);
    if (!values.length) return [0, 1];
    const lo = values[Math.floor(values.length * 0.01)], hi = values[Math.ceil(values.length * 0.99) - 1];
    return [lo, hi > lo ? hi : lo + 1];
};

// The colour of the segment that begins at a point, as a function of the point: red, green, blue and 255.
Filum.tones = (p, name, range) => {
    const how = Filum.COLOURS[name], known = new Map(), shades = 512;
    const colour = k => {
        if (!known.has(k)) known.set(k, [...(how.ramp ? Filum.ramp(k / shades) : Filum.kindColour(how, k)), 255]);
        return known.get(k);
    };
    if (!how.ramp) return i => colour(how.kinds(p, p.spanOf[i]));
    return i => colour(Math.max(0, Math.min(shades, Math.round(shades * (how.ramp(p, i) - range[0]) / (range[1] - range[0])))));
};

Filum.legend = (element, programs, name, range) => {
    const how = Filum.COLOURS[name];
    element.textContent = '';
    const add = (tag, css, text, to) => {
        const e = document.createElement(tag);
        if (css) e.className = css;
        if (text) e.textContent = text;
        return (to || element).appendChild(e);
    };
    add('div', '', name);
    if (how.ramp) {
        add('div', 'ramp').style.background = 'linear-gradient(to right,' +
            [0, 0.25, 0.5, 0.75, 1].map(t => Filum.css(Filum.ramp(t))).join(',') + ')';
        const text = v => v.toFixed(Math.abs(v) < 10 && how.unit ? 2 : 0);
        add('div', '', how.ends ? how.ends.join(' to ') : text(range[0]) + ' to ' + text(range[1]) + ' ' + how.unit);
        return;
    }
    const kinds = new Set();
    for (const p of programs)
        for (let s = 0; s < p.c.start.length; s++) if (p.c.role[s] !== Filum.TRAVEL) kinds.add(how.kinds(p, s));
    const most = 14, sorted = [...kinds].sort((a, b) => a - b);
    if (sorted.length > most) { add('div', '', sorted.length + ' of them, each in a colour of its own; a click on a bead names it'); return; }
    for (const k of sorted.slice(0, most)) {
        const row = add('div', 'row');
        add('span', 'chip', '', row).style.background = Filum.css(Filum.kindColour(how, k));
        add('span', '', how.word(k), row);
    }
};
