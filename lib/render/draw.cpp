#include "render/draw.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "render/flat.hpp"
#include "render/perspective.hpp"

namespace filum::render {

namespace {

By by(const std::string& color) {
    if (color == "stroke") return By::stroke;
    if (color == "layer") return By::layer;
    if (color == "width") return By::width;
    if (color == "speed") return By::speed;
    if (color == "class") return By::role;
    return By::progress;
}

geom::Vec3 direction(const std::string& view) {
    if (view == "iso") return {1, -1.5, 0.9};
    if (view == "top") return {0, 0, 1};
    if (view == "front") return {0, -1, 0.12};
    std::vector<double> v;
    for (std::size_t at = 0; at <= view.size();) {
        const std::size_t comma = std::min(view.find(',', at), view.size());
        v.push_back(parse_number(view.substr(at, comma - at), "--view"));
        at = comma + 1;
    }
    if (v.size() == 3 && geom::norm({v[0], v[1], v[2]}) > 1e-100) return {v[0], v[1], v[2]};
    throw Error(Exit::usage, "cannot use '" + view +
                                 "' for --view: it must be iso, top, front, or three numbers with commas " +
                                 "between, not all 0");
}

} // namespace

Range Options::range() const {
    if (flat()) return {static_cast<std::uint32_t>(layer), static_cast<std::uint32_t>(layer)};
    return {static_cast<std::uint32_t>(from_layer), static_cast<std::uint32_t>(to_layer)};
}

void check(const Options& o) {
    direction(o.view);
    if (o.svg && !o.flat()) throw Error(Exit::usage, "cannot write all layers as SVG; choose one with --layer");
    if (!o.regions.empty() && !o.flat())
        throw Error(Exit::usage, "cannot use --regions without --layer; choose a layer");
}

std::string draw(Scene scene, const Options& o, const std::string& by_default, int threads) {
    if (!o.flat() && scene.spans.empty()) fill_outlines(scene);
    const By color = by(o.color == "auto" ? by_default : o.color);
    machine::Profile profile;
    if (color == By::speed) profile = machine::load_profile(o.machine);
    const Tint colours = tint(scene, color, &profile);
    const int w = static_cast<int>(o.size[0]), h = static_cast<int>(o.size[1]), samples = static_cast<int>(o.samples);
    const FlatView flat{w, h, samples, true, !o.no_centres};
    if (o.svg) return svg(scene, colours, flat);
    if (o.flat()) return encode_png(draw_flat(scene, colours, flat, threads));
    const View view{w, h, direction(o.view), samples, o.travels, !o.no_table};
    return encode_png(draw_perspective(scene, colours, view, threads));
}

} // namespace filum::render
