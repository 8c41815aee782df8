'use strict';
// The panel with figures, lists of places, and the settings of the programs.
Filum.make = (parent, tag, text, css) => {
    const e = parent.appendChild(document.createElement(tag));
    if (text !== undefined) e.textContent = text;
    if (css) e.className = css;
    return e;
};

// Adds a table under a heading. Long values wrap, so the panel needs no horizontal scroll bar.
Filum.rows = (parent, heading, list) => {
    if (!list.length) return;
    if (heading) Filum.make(parent, 'h2', heading);
    const table = Filum.make(parent, 'table'), long = 28;
    for (const [name, ...values] of list) {
        const row = Filum.make(table, 'tr');
        Filum.make(row, 'td', name);
        values.forEach(v => Filum.make(row, 'td', v, v.length > long ? 'text' : 'number'));
    }
};
Filum.number = (v, digits) => v.toLocaleString('en', { maximumFractionDigits: digits, minimumFractionDigits: digits });
Filum.duration = s => {
    const h = Math.floor(s / 3600), m = Math.floor(s / 60) % 60;
    return h ? h + ' h ' + m + ' min' : m ? m + ' min ' + Math.round(s % 60) + ' s' : s.toFixed(1) + ' s';
};

// Collects rows of a table, [name, value per program]. Rows without a known value are left out.
Filum.table = programs => {
    const out = [];
    const row = (name, f) => { const v = programs.map(p => f(p) ?? '-'); if (v.some(t => t !== '-')) out.push([name, ...v]); };
    const given = (name, text) => p => { const v = p.figure(name); return v === undefined ? undefined : text(v); };
    return { out, row, given };
};

// The most important figures of any job.
Filum.glance = programs => {
    const n = Filum.number, { out, row, given } = Filum.table(programs);
    row('time', given('print time', Filum.duration));
    row('material', p => n(p.sums.volume / 1000, 2) + ' cm3' + [['filament', 'm'], ['mass', 'g']].map(([k, unit]) => {
        const v = p.figure(k);
        return v > 0 ? ', ' + n(v, 1) + ' ' + unit : '';
    }).join(''));
    row('strokes', p => n(p.strokes.size, 0));
    row('stops', p => n(p.figure('stops') ?? Math.max(0, p.strokes.size - 1), 0));
    row('size', p => p.size.map(v => n(v, 1)).join(' x ') + ' mm');
    row('layers', p => n(p.layers.length, 0));
    return out;
};

// The figures that matter to jobs of this kind.
Filum.worth = programs => {
    const n = Filum.number, shares = v => n(100 * v, 1) + ' %', { out, row, given } = Filum.table(programs);
    const kinds = new Set(programs.map(p => p.job()));
    if (kinds.has('solid')) {
        row('part covered', p => p.job() === 'solid' ? given('coverage', shares)(p) : undefined);
        row('crossings', p => p.job() === 'solid' ? given('crossings', v => n(v, 0))(p) : undefined);
    }
    if (kinds.has('scaffold')) {
        row('strands apart', p => p.job() === 'scaffold' ? n(p.spacing(), 2) + ' mm' : undefined);
        for (const [name, text] of [['porosity by volume', shares], ['pore size', v => n(v, 3) + ' mm']]) row(name, given(name, text));
        row('filled', p => p.job() === 'scaffold' ? given('coverage', shares)(p) : undefined);
    }
    if (kinds.has('surface')) {
        row('surface covered', given('coverage', shares));
        row('cuts', given('cuts', v => n(v, 0)));
        row('covered twice', given('overlap', shares));
        row('below the minimum radius', given('tight-length', v => n(v, 1) + ' mm'));
        row('kinks, below 0.45 spacings', given('kink-length', v => n(v, 1) + ' mm'));
        row('fibre', p => p.job() === 'surface' ? n(p.sums.laid, 0) + ' mm' : undefined);
    }
    if (kinds.has('hollow'))
        for (const k of [...new Set(programs.flatMap(p => [...p.volumes.keys()]))].filter(k => k >= 100).sort((a, b) => a - b))
            row(Filum.COLOURS.role.word(k), p => p.volumes.has(k) ? n(p.volumes.get(k) / 1000, 2) + ' cm3' : undefined);
    row('in the air', given('length in the air', v => n(v, 0) + ' mm'));
    return out;
};

Filum.figures = (tab, programs) => {
    tab.textContent = '';
    const of = f => programs.map(f), n = Filum.number;
    if (programs.length > 1) Filum.rows(tab, '', [['', ...of(p => p.name)]]);
    Filum.rows(tab, '', Filum.glance(programs));
    for (const p of programs) {
        const notes = grade => p.figures.filter(f => f[0] === 'notes: ' + grade);
        for (const grade of ['will fail', 'look']) {
            const list = notes(grade);
            if (list.length) Filum.make(tab, 'h2', (programs.length > 1 ? p.name + ': ' : '') + (grade === 'look' ? 'look at' : grade));
            for (const [, stage, text] of list) Filum.make(tab, 'p', stage + ': ' + text.replace(/ \[[a-z-]+\]$/, ''), grade === 'look' ? 'note' : 'note fails');
        }
    }
    Filum.rows(tab, programs.every(p => p.job() === 'hollow') ? 'material by role' : 'this job', Filum.worth(programs));
    const more = Filum.make(tab, 'details');
    Filum.make(more, 'summary', 'all figures');
    Filum.rows(more, 'path', [
        ['moves', ...of(p => n(p.sums.moves, 0))],
        ['laid', ...of(p => n(p.sums.laid, 1) + ' mm')], ['travel', ...of(p => n(p.sums.travel, 1) + ' mm')],
        ['volume', ...of(p => n(p.sums.volume, 2) + ' mm3')],
        ['size', ...of(p => p.size.map(v => n(v, 2)).join(' x ') + ' mm')]
    ]);
    for (const p of programs) {
        Filum.make(more, 'h2', 'machine');
        Filum.make(more, 'div', p.machine);
        const groups = new Map();
        for (const [group, name, value, unit] of p.figures) {
            if (!groups.has(group)) groups.set(group, []);
            groups.get(group).push([name, value + (unit ? ' ' + unit : '')]);
        }
        const whole = p.job() === 'solid' || p.job() === 'surface' ? '' : ', of the whole outlines';
        for (const [group, list] of groups)
            Filum.rows(more, (programs.length > 1 ? p.name + ': ' : '') + group + (group === 'coverage' ? whole : ''), list);
    }
};

// The places that the view can go to: [heading, [text, x, y, z, layer, point]...].
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
