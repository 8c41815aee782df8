#!/usr/bin/env python3
"""drive - opens reports in a headless Chromium, uses their controls and looks at what is drawn

drive.py TOWERS.html BESIDE.html SURFACE.html [FOLDER]     FOLDER: where screenshots go
The first shows two towers printed one after the other, the second two programs of them, the third a path on a disc.
Ends with 1 where something does not show what it should.  browser.py says what must be installed."""
import sys

import browser

PIXELS = """
    const v = Filum.views[arguments[0]], gl = v.renderer.getContext();
    v.draw(arguments[1]);
    const w = v.canvas.width, h = v.canvas.height, rgba = new Uint8Array(4 * w * h);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    let drawn = 0, red = 0, green = 0, blue = 0;
    for (let i = 0; i < 4 * w * h; i += 4) {
        if (Math.abs(rgba[i] - rgba[0]) + Math.abs(rgba[i + 1] - rgba[1]) + Math.abs(rgba[i + 2] - rgba[2]) < 24) continue;
        drawn++; red += rgba[i]; green += rgba[i + 1]; blue += rgba[i + 2];
    }
    return [drawn / (w * h), red / drawn, green / drawn, blue / drawn];
"""
failed = 0


def check(what, holds, said=""):
    global failed
    if not holds:
        failed += 1
        print(f"drive: {what}: {said}")


def shown(b, view=0, fine=True):
    return b.js(PIXELS, view, fine)


def towers(b, file):
    b.open(file)
    check("no error", not b.log())
    both = shown(b)
    check("the part is drawn", 0.03 < both[0] < 0.9, both)
    coarse = shown(b, 0, False)
    check("ribbons cover what tubes do", abs(coarse[0] - both[0]) < 0.2 * both[0], (coarse, both))
    coarsely(b, both)
    check("two strokes", b.js("return Filum.programs[0].strokes.size") == 2)
    # along the path: the first half is one tower
    b.js("const e = document.getElementById('path'); e.value = Math.round(e.max / 2); e.dispatchEvent(new Event('input'))")
    half = shown(b)
    check("half of the path is about half of the picture", 0.3 * both[0] < half[0] < 0.75 * both[0], (half, both))
    at = b.js("return Filum.state.path")
    b.key("\ue012")
    check("the left key goes back by one", b.js("return Filum.state.path") == at - 1)
    b.key("\ue014")
    b.js("const e = document.getElementById('path'); e.value = e.max; e.dispatchEvent(new Event('input'))")
    # over the layers
    b.js("const e = document.getElementById('high'); e.value = 0; e.dispatchEvent(new Event('input'))")
    low = shown(b)
    check("one layer is less than all", low[0] < 0.9 * both[0], (low, both))
    b.key("\ue013")
    check("the up key shows one layer more", b.js("return Filum.state.high") == 1)
    b.js("const e = document.getElementById('high'); e.value = e.max; e.dispatchEvent(new Event('input'))")
    # colours
    seen = {}
    for name in b.js("return Object.keys(Filum.COLOURS)"):
        b.js("const e = document.getElementById('colour'); e.value = arguments[0]; e.dispatchEvent(new Event('change'))", name)
        seen[name] = tuple(round(v) for v in shown(b)[1:])
        check(f"legend of {name}", b.js("return document.getElementById('legend').textContent").startswith(name))
    check("colours differ", len(set(seen.values())) >= 4, seen)
    check("no error", not b.log())


# With fewer beads than the program has the picture still shows the same part, from every side and of any layers.
def coarsely(b, both):
    chosen = "const v = Filum.views[0], d = v.beads; d.most = arguments[0]; d.select(v.frustum()); v.describe(); return [d.used, d.step, d.level, d.complete()]"
    few = b.js(chosen, b.js("return Filum.views[0].beads.detail.whole") // 20)
    part = shown(b, 0, False)
    check("a twentieth of the beads covers what all do", abs(part[0] - both[0]) < 0.1 * both[0], (few, part, both))
    check("what is left out is told", "fewer points" in b.js("return Filum.views[0].name.textContent") and not few[3], few)
    b.js("const e = document.getElementById('high'); e.value = 0; e.dispatchEvent(new Event('input'))")
    check("one layer is drawn whole", b.js("const d = Filum.views[0].beads; return d.step") == 1)
    b.js("const e = document.getElementById('high'); e.value = e.max; e.dispatchEvent(new Event('input'))")
    check("all are drawn if there is time", b.js(chosen, 10**9)[1:] == [1, 0, True])
    check("no word of it then", "drawn with" not in b.js("return Filum.views[0].name.textContent"))


def panels(b):
    b.click("[data-tab=figures]")
    check("figures", "strokes" in b.js("return document.getElementById('tab-figures').innerText"))
    b.click("[data-tab=places]")
    where = b.js("return JSON.stringify(Filum.where)")
    check("a travel in the list", b.js("return document.querySelectorAll('#tab-places button').length") >= 3)
    b.click("#tab-places button")
    check("a click flies there", b.js("return JSON.stringify(Filum.where)") != where)
    b.key("f")
    b.click("[data-tab=layer]")
    ink = """const c = document.getElementById('flat'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
             let red = 0, all = 0;
             for (let i = 0; i < d.length; i += 4) if (d[i + 3] > 0) { all++; red += d[i] > 200 && d[i + 1] < 110 && d[i + 2] < 110 ? 1 : 0; }
             return [red, all]"""
    red, everything = b.js(ink)
    check("the layer from above is drawn, hardly any voids", everything > 2000 and red < 0.1 * everything, (red, everything))
    b.js("const e = document.getElementById('path'); e.value = 0; e.dispatchEvent(new Event('input'))")
    red, everything = b.js(ink)
    check("without beads all of it is void", red > 0.7 * everything, (red, everything))
    b.click("[data-tab=made]")
    made = b.js("return document.getElementById('tab-made').innerText")
    check("how it was made", all(s in made for s in ("slice", "regions", "sequence", "fill", "link3d")), made[:200])
    check("a copy button", b.js("return !!document.querySelector('button.copy')"))
    dark = b.js("return getComputedStyle(document.body).backgroundColor")
    b.key("d")
    check("dark and light", b.js("return getComputedStyle(document.body).backgroundColor") != dark)
    b.key("?")
    check("help", not b.js("return document.getElementById('help').hidden"))
    b.key("?")
    look = b.js("return Filum.where.rise")
    b.key("2")
    check("from the top", b.js("return Filum.where.rise") > 1.5 > look)
    check("no error", not b.log())


def beside(b, file):
    b.open(file)
    check("two views", b.js("return Filum.views.length") == 2)
    left, right = shown(b, 0), shown(b, 1)
    check("both are drawn, alike", left[0] > 0.02 and abs(left[0] - right[0]) < 0.2 * left[0], (left, right))
    b.js("const e = document.getElementById('path'); e.value = Math.round(e.max / 2); e.dispatchEvent(new Event('input'))")
    left, right = shown(b, 0), shown(b, 1)
    first, second = b.js("return Filum.views.map(v => v.p.share(v.beads.shown))")
    check("both have laid the same share", abs(first - second) < 0.01, (first, second))
    check("both go along together", abs(left[0] - right[0]) < 0.25 * left[0], (left, right))
    check("no error", not b.log())


def surface(b, file):
    b.open(file)
    plain = shown(b)
    check("surface and path are drawn", plain[0] > 0.05, plain)
    check("a field to colour by", "distance" in b.js("return [...document.querySelectorAll('#field option')].map(o => o.value)"))
    b.js("const e = document.getElementById('path'); e.value = 0; e.dispatchEvent(new Event('input'))")
    bare = shown(b)
    b.js("const e = document.getElementById('field'); e.value = 'distance'; e.dispatchEvent(new Event('change'))")
    coloured = shown(b)
    check("the field colours it", max(abs(x - y) for x, y in zip(bare[1:], coloured[1:])) > 15, (bare, coloured))
    check("no error", not b.log())


def main():
    absent = browser.missing()
    if absent:
        sys.exit(f"drive: not installed: {absent}; run scripts/setup --test")
    files, folder = sys.argv[1:4], sys.argv[4] if len(sys.argv) > 4 else None
    b = browser.Browser()
    try:
        towers(b, files[0])
        if folder:
            b.picture(f"{folder}/towers.png")
        panels(b)
        if folder:
            b.picture(f"{folder}/panels.png")
        beside(b, files[1])
        if folder:
            b.picture(f"{folder}/beside.png")
        surface(b, files[2])
        if folder:
            b.picture(f"{folder}/surface.png")
    finally:
        b.close()
    sys.exit(1 if failed else 0)


main()
