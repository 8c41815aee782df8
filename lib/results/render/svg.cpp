#include "base/number.hpp"
#include "render/flat.hpp"
#include "render/layer.hpp"

#include <cmath>

namespace filum::render {

namespace {

using geom::Vec2;

std::string number(double v) { return fixed_text(v, 4); }

void path_point(std::string& out, char command, Vec2 p) {
    out += command;
    append_fixed(out, p.x, 4);
    out += ' ';
    append_fixed(out, p.y, 4);
}

// Writes the beads. Consecutive beads with the same colour and width (to 0.01 mm) become one path.
void beads(std::string& out, const Scene& scene, const Tint& tint, const FlatLayer& layer) {
    std::string open; // attributes of the path that is still open
    Vec2 last;
    double begin = 0;
    for (const FlatBead& b : layer.beads) {
        if (b.point == 0) begin = b.along;
        const double width = std::max(0.01, std::round(b.width * 100) / 100);
        const std::string attributes = "stroke=\"" +
                                       hex(from_srgb8(colour(tint, scene, b.span, b.point, b.along - begin))) +
                                       "\" stroke-width=\"" + number(width) + "\" d=\"";
        if (attributes != open || !(b.a == last)) {
            out += (open.empty() ? "" : "\"/>\n") + ("<path " + attributes);
            path_point(out, 'M', b.a);
            open = attributes;
        }
        path_point(out, 'L', b.b);
        last = b.b;
    }
    if (!open.empty()) out += "\"/>\n";
}

} // namespace

std::string svg(const Scene& scene, const Tint& tint, const FlatView& view) {
    FlatLayer layer = flatten(scene);
    if (layer.box.empty()) {
        layer.box.add({0, 0});
        layer.box.add({1, 1});
    }
    const double margin = layer.width;
    const double w = layer.box.hi.x - layer.box.lo.x + 2 * margin, h = layer.box.hi.y - layer.box.lo.y + 2 * margin;
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(w) + "mm\" height=\"" + number(h) +
                      "mm\" viewBox=\"" + number(layer.box.lo.x - margin) + " " + number(-layer.box.hi.y - margin) +
                      " " + number(w) + " " + number(h) + "\">\n<g transform=\"scale(1 -1)\">\n";
    for (const Outline& o : scene.outlines) {
        out += "<path fill=\"" + std::string(layer.beads.empty() ? "#9fb8cc" : "#e0524a") +
               "\" fill-rule=\"evenodd\" stroke=\"#333\" stroke-width=\"" + number(0.08 * layer.width) + "\" d=\"";
        for (std::size_t i = 0; i < o.loops.size(); ++i) {
            for (std::size_t k = 0; k < o.loops[i].size(); ++k) path_point(out, k == 0 ? 'M' : 'L', o.loops[i][k]);
            out += 'Z';
        }
        out += "\"/>\n";
    }
    out += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    beads(out, scene, tint, layer);
    if (view.centres && !layer.beads.empty()) {
        out += "<path stroke=\"#fff\" stroke-opacity=\"0.7\" stroke-width=\"" + number(0.08 * layer.width) + "\" d=\"";
        Vec2 last{INFINITY, 0};
        for (const FlatBead& b : layer.beads) {
            if (!(b.a == last)) path_point(out, 'M', b.a);
            path_point(out, 'L', b.b);
            last = b.b;
        }
        out += "\"/>\n";
    }
    for (const FlatBead& t : layer.travels) {
        if (!view.travels) break;
        out += "<path stroke=\"#777\" stroke-dasharray=\"" + number(layer.width) + "\" stroke-width=\"" +
               number(0.1 * layer.width) + "\" d=\"";
        path_point(out, 'M', t.a);
        path_point(out, 'L', t.b);
        out += "\"/>\n";
    }
    out += "</g>\n";
    for (const auto kind : {Mark::Kind::lift, Mark::Kind::end, Mark::Kind::start}) {
        for (const Mark& m : layer.marks) {
            if (m.kind != kind) continue;
            out += "<circle cx=\"" + number(m.at.x) + "\" cy=\"" + number(m.at.y) + "\" r=\"" +
                   number(0.4 * layer.width) + "\" fill=\"" + hex(mark_colour(kind)) + "\"/>\n";
        }
    }
    return out + "</g>\n</svg>\n";
}

} // namespace filum::render
