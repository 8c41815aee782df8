#include "render/draw.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/read.hpp"
#include "render/collisions.hpp"
#include "render/drape.hpp"
#include "render/flat.hpp"
#include "render/perspective.hpp"
#include "render/vtp.hpp"

namespace filum::render {

namespace {

ColourBy by(const std::string& color) {
    if (color == "stroke") return ColourBy::stroke;
    if (color == "tool") return ColourBy::tool;
    if (color == "layer") return ColourBy::layer;
    if (color == "width") return ColourBy::width;
    if (color == "speed") return ColourBy::speed;
    if (color == "class") return ColourBy::role;
    return ColourBy::progress;
}

// Throws Error(usage) if an option needs a surface or a path on it, or does not work with a surface.
void check_surface(const Scene& scene, const Options& o) {
    const char* asked = !o.by.empty()       ? "--by"
                        : !o.arrows.empty() ? "--arrows"
                        : !o.around.empty() ? "--around"
                        : o.voids           ? "--voids"
                        : o.overlap         ? "--overlap"
                                            : nullptr;
    if (asked != nullptr && !scene.sheet)
        throw Error(Exit::usage, std::string("cannot use ") + asked + " without a surface; name it with --surface");
    if (scene.sheet && scene.spans.empty() && (o.voids || o.overlap))
        throw Error(Exit::usage, "cannot mark voids or overlap without a toolpath; give the surface with --surface");
    if (scene.sheet && !scene.outlines.empty())
        throw Error(Exit::usage, "cannot draw outlines on a surface; leave out --surface");
    if (scene.sheet && o.flat()) throw Error(Exit::usage, "cannot draw a surface as a layer; leave out --layer");
}

// Adds the meshes whose files `list` names, separated by commas.
void add_parts(Scene& scene, const std::string& list) {
    for (std::size_t at = 0; !list.empty() && at <= list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        const std::string path = list.substr(at, end - at);
        scene.meshes.push_back(
            {mesh::read(mesh::load(path).view(), mesh::spoken_name(path)).mesh, oklch(0.82, 0.02, 200)});
        at = end + 1;
    }
}

std::vector<ViewDirection> chosen(const Options& o, const std::string& otherwise) {
    if (!o.views.empty()) return looks(o.views, "views");
    const auto one = looks(o.view == "auto" ? otherwise : o.view, "view");
    if (one.size() > 1)
        throw Error(Exit::usage, "cannot use '" + o.view + "' for --view; for several there is --views");
    return one;
}

} // namespace

Range Options::range() const {
    if (flat()) return {static_cast<std::uint32_t>(layer), static_cast<std::uint32_t>(layer)};
    return {static_cast<std::uint32_t>(from_layer), static_cast<std::uint32_t>(to_layer)};
}

void check(const Options& o) {
    chosen(o, "iso");
    if (!o.around.empty() && !(o.around[3] > 0 && o.around[3] < 1e9))
        throw Error(Exit::usage,
                    "cannot show a radius of " + shortest_text(o.around[3]) + " mm; give --around X,Y,Z,R");
    if (!o.views.empty() && o.flat())
        throw Error(Exit::usage, "cannot draw a layer from several sides; leave out --views");
    if (o.svg && !o.flat()) throw Error(Exit::usage, "cannot write all layers as SVG; choose one with --layer");
    const bool flat = o.flat() || o.svg || o.vtp, cut = o.from_layer > 0 || o.to_layer < UINT32_MAX;
    if (!o.collisions.empty() && (flat || cut || !o.surface.empty() || !o.views.empty() || o.view.starts_with("face")))
        throw Error(Exit::usage, "cannot draw --collisions on a surface, flat, of some layers, as SVG or VTP, or from "
                                 "several sides; --view alone may go with it");
    if (o.collisions.empty() && !o.part.empty())
        throw Error(Exit::usage, "cannot use --part without --collisions; name their list");
    if (!o.regions.empty() && !o.flat())
        throw Error(Exit::usage, "cannot use --regions without --layer; choose a layer");
}

std::string draw(Scene scene, const Options& o, const std::string& by_default, int threads) {
    check_surface(scene, o);
    if (o.vtp && !scene.outlines.empty())
        throw Error(Exit::usage, "cannot write outlines as VTP; it is for Surface, Paths and Toolpath");
    if (o.vtp) return vtp(scene);
    if (!o.flat() && scene.spans.empty() && !scene.sheet) fill_outlines(scene);
    const ColourBy color = by(o.color == "auto" ? by_default : o.color);
    machine::Profile profile;
    if (color == ColourBy::speed) profile = machine::load_profile(o.machine);
    const Tint colours = tint(scene, color, &profile);
    const int w = static_cast<int>(o.size[0]), h = static_cast<int>(o.size[1]), samples = static_cast<int>(o.samples);
    const FlatView flat{w, h, samples, true, !o.no_centres};
    if (o.svg) return svg(scene, colours, flat);
    if (o.flat()) return encode_png(draw_flat(scene, colours, flat, threads));
    if (!o.collisions.empty()) {
        const auto places = read_meetings(mesh::load(o.collisions).view(), mesh::spoken_name(o.collisions));
        add_parts(scene, o.part);
        const geom::Vec3 from = o.view == "auto" ? geom::Vec3{} : chosen(o, "iso").front().from;
        return encode_png(draw_collisions(std::move(scene), places, machine::head(o.head), color,
                                          {w, h, from, samples, o.travels, !o.no_table, {}}, threads));
    }
    if (scene.sheet) {
        const Show show{o.by, o.arrows, o.voids, o.overlap, !o.no_centres, o.around};
        return encode_png(draw_draped(scene, colours, {w, h, samples, chosen(o, "face"), show}, threads));
    }
    return encode_png(contact_sheet(chosen(o, "iso"), w, h, [&](const ViewDirection& look, int width, int height) {
        return draw_perspective(scene, colours, {width, height, look.from, samples, o.travels, !o.no_table, {}},
                                threads);
    }));
}

} // namespace filum::render
