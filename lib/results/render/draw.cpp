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
    const char* asked = !o.by.empty()                    ? "--by"
                        : !o.arrows.empty()              ? "--arrows"
                        : !o.around.empty() && !o.flat() ? "--around"
                        : o.voids                        ? "--voids"
                        : o.overlap                      ? "--overlap"
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

DrapeView drape_view(const Options& o) {
    return {
        static_cast<int>(o.samples), chosen(o, "face"), {o.by, o.arrows, o.voids, o.overlap, !o.no_centres, o.around}};
}

void draw_meetings(Canvas& page, Scene scene, ColourBy color, const Options& o, int threads) {
    const auto places = read_meetings(mesh::load(o.collisions).view(), mesh::spoken_name(o.collisions));
    add_parts(scene, o.part);
    const geom::Vec3 from = o.view == "auto" ? geom::Vec3{} : chosen(o, "iso").front().from;
    const View view{from, static_cast<int>(o.samples), o.travels, !o.no_table, {}};
    draw_collisions(page, std::move(scene), places, machine::head(o.head), color, view, threads);
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
    const bool flat = o.flat() || o.vtp, cut = o.from_layer > 0 || o.to_layer < UINT32_MAX;
    if (!o.collisions.empty() && (flat || cut || !o.surface.empty() || !o.views.empty() || o.view.starts_with("face")))
        throw Error(Exit::usage, "cannot draw --collisions on a surface, flat, of some layers, as VTP, or from several "
                                 "sides; --view alone may go with it");
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
    const FlatView flat{samples, true, !o.no_centres, o.around};
    const Format format = o.format == "svg" ? Format::svg : o.format == "pdf" ? Format::pdf : Format::png;
    Canvas page(w, h, format, o.flat() ? flat_scale(scene, flat, w, h) : kScreenPixels);
    if (o.flat())
        draw_flat(page, scene, colours, flat, threads);
    else if (!o.collisions.empty())
        draw_meetings(page, std::move(scene), color, o, threads);
    else if (scene.sheet)
        draw_draped(page, scene, colours, drape_view(o), threads);
    else
        contact_sheet(page, chosen(o, "iso"), [&](Canvas& cell, const ViewDirection& look) {
            draw_perspective(cell, scene, colours, {look.from, samples, o.travels, !o.no_table, {}}, threads);
        });
    return page.bytes();
}

} // namespace filum::render
