'use strict';
// The figures, the lists of places, and how it was made.
Filum.make = (parent, tag, text, css) => {
    const e = parent.appendChild(document.createElement(tag));
    if (text !== undefined) e.textContent = text;
    if (css) e.className = css;
    return e;
};

Filum.figures = (tab, programs) => {
    tab.textContent = '';
    const rows = (heading, list) => {
        Filum.make(tab, 'h2', heading);
        const table = Filum.make(tab, 'table');
        for (const [name, ...values] of list) {
            const row = Filum.make(table, 'tr');
            Filum.make(row, 'td', name);
            values.forEach(v => Filum.make(row, 'td', v, 'number'));
        }
    };
    const of = f => programs.map(f), n = (v, d) => v.toLocaleString('en', { maximumFractionDigits: d, minimumFractionDigits: d });
    if (programs.length > 1) rows('', [['', ...of(p => p.name)]]);
    rows('path', [
        ['strokes', ...of(p => n(p.strokes.size, 0))], ['moves', ...of(p => n(p.sums.moves, 0))],
        ['laid', ...of(p => n(p.sums.laid, 1) + ' mm')], ['travel', ...of(p => n(p.sums.travel, 1) + ' mm')],
        ['volume', ...of(p => n(p.sums.volume, 2) + ' mm3')], ['layers', ...of(p => n(p.layers.length, 0))],
        ['size', ...of(p => p.size.map(v => n(v, 2)).join(' x ') + ' mm')]
    ]);
    for (const p of programs) {
        Filum.make(tab, 'h2', 'machine');
        Filum.make(tab, 'div', p.machine);
        const groups = new Map();
        for (const [group, name, value, unit] of p.figures) {
            if (!groups.has(group)) groups.set(group, []);
            groups.get(group).push([name, value + (unit ? ' ' + unit : '')]);
        }
        for (const [group, list] of groups) rows((programs.length > 1 ? p.name + ': ' : '') + group, list);
    }
};

// Where one may fly to: [heading, [text, x, y, z, layer, point]...].
Filum.places = p => {
    const c = p.c, at = i => [c.x[i] / 1000, c.y[i] / 1000, c.z[i] / 1000], out = [];
    const spots = kind => p.spots.filter(s => s[0] === kind).map(s => [s[1] + (s[5] >= 0 ? ', layer ' + s[5] : ''), s[2], s[3], s[4], s[5], -1]);
    out.push(['collisions', spots('collision')]);
    for (const grade of ['will fail', 'look', 'harmless']) out.push([grade, spots(grade)]);
    const travels = [];
    for (let s = 0; s < c.start.length; s++) {
        if (c.role[s] !== Filum.TRAVEL) continue;
        let way = 0;
        for (let i = c.start[s]; i + 1 < p.end(s); i++) way += p.length(i);
        travels.push([way, s]);
    }
    const text = ([way, s]) => [way.toFixed(2) + ' mm on layer ' + c.layer[s] + [', nothing taken back', ''][c.taken[s] === 1 ? 0 : 1], ...at(c.start[s]), c.layer[s], c.start[s]];
    out.push(['travels, the longest first', [...travels].sort((a, b) => b[0] - a[0] || a[1] - b[1]).map(text)]);
    out.push(['stops, in their order', travels.filter(t => t[0] > 0.05 || c.taken[t[1]] === 2).map(text)]);
    out.push(['strokes', [...p.strokes].map(([k, s]) => ['stroke ' + (k + 1) + ', ' + s.length.toFixed(1) + ' mm', ...at(s.first), c.layer[p.spanOf[s.first]], s.first])]);
    return out;
};

Filum.listPlaces = (tab, programs, fly) => {
    tab.textContent = '';
    const most = 300;
    let any = false;
    programs.forEach((p, which) => {
        for (const [heading, list] of Filum.places(p)) {
            if (!list.length) continue;
            any = true;
            Filum.make(tab, 'h2', (programs.length > 1 ? p.name + ': ' : '') + heading + ' (' + list.length + ')');
            for (const place of list.slice(0, most)) {
                const b = Filum.make(tab, 'button', place[0]);
                b.addEventListener('click', () => {
                    tab.querySelectorAll('.on').forEach(e => e.classList.remove('on'));
                    b.classList.add('on');
                    fly(which, place);
                });
            }
            if (list.length > most) Filum.make(tab, 'div', 'and ' + (list.length - most) + ' more');
        }
    });
    if (!any) Filum.make(tab, 'div', 'nothing to fly to');
};

Filum.made = (tab, programs) => {
    tab.textContent = '';
    for (const p of programs) {
        Filum.make(tab, 'h2', (programs.length > 1 ? p.name + ': ' : '') + 'pipeline');
        const copy = Filum.make(tab, 'button', 'copy', 'copy'), pre = Filum.make(tab, 'pre', p.script);
        copy.addEventListener('click', async () => {
            try { await navigator.clipboard.writeText(p.script); } catch (e) {
                const range = document.createRange();
                range.selectNodeContents(pre);
                getSelection().removeAllRanges(); getSelection().addRange(range);
                document.execCommand('copy');
            }
            copy.textContent = 'copied';
            setTimeout(() => { copy.textContent = 'copy'; }, 1500);
        });
        for (const [program, settings] of p.made) {
            Filum.make(tab, 'h2', program);
            const table = Filum.make(tab, 'table');
            for (const [name, value, changed] of settings) {
                const row = Filum.make(table, 'tr');
                Filum.make(row, 'td', name).style.fontWeight = changed ? '600' : '';
                Filum.make(row, 'td', value, 'number');
            }
        }
    }
};
