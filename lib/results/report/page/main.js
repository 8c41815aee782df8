'use strict';
// Builds the page, and updates the views when sliders, buttons and keys are used.
(async () => {
    const $ = id => document.getElementById(id), began = performance.now();
    const told = text => { $('layers-said').textContent = text; };
    if (typeof DecompressionStream === 'undefined') return told('this browser is too old: it needs DecompressionStream');
    const programs = await Promise.all([...document.querySelectorAll('div.program')].map(Filum.load));
    const state = { path: 1, low: 0, high: 0, colour: 'stroke', range: [0, 1], tones: [] };
    document.querySelector('h1').textContent = programs.map(p => p.name).join('  |  ');
    let views = [];
    const changed = () => views.forEach(v => v.ask());
    try {
        views = programs.map(p => new Filum.View(p, $('views'), changed));
    } catch (e) {
        $('legend').textContent = 'this browser cannot draw in three dimensions (no WebGL); the layer from above works';
    }
    const flat = new Filum.Flat($('flat'), $('layer-said'), $('layer-note'));
    const layers = [...new Set(programs.flatMap(p => p.layers))].sort((a, b) => a - b);
    const points = Math.max(1, programs[0].n - 1);

    // --- what is shown ---
    // All programs show the same share of their own paths.
    const count = p => p === programs[0] || state.path >= points ? Math.min(p === programs[0] ? state.path : points * p.n, Math.max(0, p.n - 1)) : p.atShare(programs[0].share(state.path));
    function showPath() {
        views.forEach(v => v.path(count(v.p)));
        const p = programs[0], i = Math.min(count(p), p.n - 1);
        $('path').value = state.path;
        $('path-said').textContent = p.n < 2 ? '' : 'move ' + i + ' of ' + points + ', stroke ' + (p.c.stroke[p.spanOf[i]] + 1) + ', layer ' + p.c.layer[p.spanOf[i]];
        showFlat();
    }
    function showLayers() {
        state.low = Math.min(state.low, state.high);
        $('low').value = state.low; $('high').value = state.high;
        const low = layers[state.low] ?? 0, high = layers[state.high] ?? 0;
        views.forEach(v => v.layers(low, high));
        told(layers.length ? 'layers ' + low + ' to ' + high : '');
        showFlat();
    }
    function showFlat() {
        // If all layers are shown, the top one would hide the others, so the middle one is shown from above.
        const at = state.low === 0 && state.high === layers.length - 1 ? layers.length >> 1 : state.high;
        if (!$('tab-layer').hidden) flat.show(programs[0], layers[at] ?? 0, count(programs[0]), state.tones[0]);
    }
    function showColour() {
        const how = Filum.COLOURS[state.colour];
        state.range = how.ramp ? Filum.range(how, programs) : [0, 1];
        state.tones = programs.map(p => Filum.tones(p, state.colour, state.range));
        views.forEach((v, k) => v.colour(state.tones[k]));
        if (views.length) Filum.legend($('legend'), programs, state.colour, state.range);
        $('colour').value = state.colour;
        showFlat();
    }
    const theme = dark => {
        document.documentElement.classList.toggle('dark', dark);
        $('theme').textContent = dark ? 'light' : 'dark';
        changed(); showFlat();
    };
    const look = name => { [Filum.where.turn, Filum.where.rise] = Filum.LOOKS[name]; changed(); };
    const fit = () => { Filum.where.at = [0, 0, 0]; Filum.where.far = 3; changed(); };
    const tab = name => {
        document.querySelectorAll('nav button').forEach(b => b.classList.toggle('on', b.dataset.tab === name));
        document.querySelectorAll('.tab').forEach(t => { t.hidden = t.id !== 'tab-' + name; });
        showFlat();
    };
    const travels = on => { $('travels').checked = on; views.forEach(v => { v.travels.visible = on; v.ask(); }); };
    function fly(which, [, x, y, z, layer, point]) {
        const v = views[which], p = programs[which];
        if (v) v.fly(x, y, z, Math.max(3, p.radius / 12));
        if (point >= 0 && which === 0) { state.path = Math.min(points, point + 1); showPath(); }
        if (layer >= 0 && layers.includes(layer)) { state.high = layers.indexOf(layer); showLayers(); }
        if (v && point >= 0) v.tell(point);
        if (which === 0) { flat.p = p; flat.shift = [p.middle[0] - x, p.middle[1] - y]; flat.zoom = Math.max(1, p.radius / 6); showFlat(); }
    }

    // --- controls ---
    for (const name of Object.keys(Filum.COLOURS)) Filum.make($('colour'), 'option', name).value = name;
    $('colour').addEventListener('change', e => { state.colour = e.target.value; showColour(); });
    $('path').max = points; $('low').max = $('high').max = Math.max(0, layers.length - 1);
    state.path = points; state.high = Math.max(0, layers.length - 1);
    $('path').addEventListener('input', e => { state.path = +e.target.value; showPath(); });
    $('high').addEventListener('input', e => { state.high = +e.target.value; showLayers(); });
    $('low').addEventListener('input', e => { state.low = +e.target.value; state.high = Math.max(state.high, state.low); showLayers(); });
    $('theme').addEventListener('click', () => theme(!document.documentElement.classList.contains('dark')));
    $('fit').addEventListener('click', fit);
    $('travels').addEventListener('change', e => travels(e.target.checked));
    $('outlines').addEventListener('change', e => views.forEach(v => v.showOutlines(e.target.checked)));
    $('outlines').checked = views.some(v => v.outlines);
    $('ask').addEventListener('click', () => { $('help').hidden = false; });
    $('help').addEventListener('click', () => { $('help').hidden = true; });
    document.querySelectorAll('[data-look]').forEach(b => b.addEventListener('click', () => look(b.dataset.look)));
    document.querySelectorAll('nav button').forEach(b => b.addEventListener('click', () => tab(b.dataset.tab)));
    const fields = [...new Set(programs.flatMap(p => p.surfaces.flat().map(f => f[0])))];
    $('field-label').hidden = !fields.length;
    for (const name of ['plain', ...fields]) Filum.make($('field'), 'option', name).value = name;
    $('field').addEventListener('change', e => views.forEach(v => v.field(e.target.value)));
    let playing = 0;
    const play = () => {
        if (playing) { cancelAnimationFrame(playing); playing = 0; $('play').textContent = 'play'; return; }
        if (state.path >= points) state.path = 0;
        const seconds = 20, step = () => {
            state.path = Math.min(points, state.path + Math.max(1, Math.round(points / (seconds * 60))));
            showPath();
            playing = state.path < points ? requestAnimationFrame(step) : 0;
            $('play').textContent = playing ? 'stop' : 'play';
        };
        playing = requestAnimationFrame(step);
        $('play').textContent = 'stop';
    };
    $('play').addEventListener('click', play);
    const along = by => { state.path = Math.max(0, Math.min(points, state.path + by)); showPath(); };
    const up = by => { state.high = Math.max(0, Math.min(layers.length - 1, state.high + by)); showLayers(); };
    const names = Object.keys(Filum.COLOURS), looks = Object.keys(Filum.LOOKS);
    const alone = by => { up(by); state.low = state.high; showLayers(); };
    document.addEventListener('keydown', e => {
        if (e.ctrlKey || e.altKey || e.metaKey || e.target.tagName === 'SELECT') return;
        const far = e.shiftKey ? 100 : 1, keys = {
            ArrowLeft: () => along(-far), ArrowRight: () => along(far), ArrowUp: () => up(1), ArrowDown: () => up(-1),
            PageUp: () => alone(1), PageDown: () => alone(-1), ' ': play, f: fit, d: () => $('theme').click(), t: () => travels(!$('travels').checked),
            c: () => { state.colour = names[(names.indexOf(state.colour) + 1) % names.length]; showColour(); },
            '?': () => { $('help').hidden = !$('help').hidden; }, Escape: () => { $('help').hidden = true; }
        };
        const act = keys[e.key] || (looks[e.key - 1] && (() => look(looks[e.key - 1])));
        if (act) { act(); e.preventDefault(); }
    });
    window.addEventListener('resize', () => { changed(); showFlat(); });

    Filum.figures($('tab-figures'), programs);
    Filum.listPlaces($('tab-places'), programs, fly);
    Filum.made($('tab-made'), programs);
    const jobs = programs.map(p => p.job()), front = jobs[0] === 'surface' && programs[0].facing();
    state.colour = jobs.includes('hollow') ? 'role' : programs.some(p => p.strokes.size > 1) ? 'stroke' : 'progress';
    if (front) [Filum.where.turn, Filum.where.rise] = [Math.hypot(front[0], front[1]) < 0.05 ? -Math.PI / 2 : Math.atan2(front[1], front[0]), Math.max(-1.5, Math.min(1.5, Math.asin(front[2])))];
    theme(window.matchMedia('(prefers-color-scheme: dark)').matches);
    fit();
    showColour(); showLayers(); showPath();
    views.forEach(v => v.draw(false));
    Filum.ready = { ms: performance.now(), began, points: programs.map(p => p.n) };
    Filum.state = state; Filum.views = views; Filum.programs = programs;
    document.documentElement.dataset.ready = 'yes';
})();
