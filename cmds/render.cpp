// render - a picture of any stream
// reads:  Layers, Regions, Paths or Toolpath
// writes: a PNG picture, or SVG
// memory: the model
#include "base/number.hpp"
#include "cli/command.hpp"
#include "render/flat.hpp"
#include "render/perspective.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

struct Options {
    std::string color = "auto", view = "iso", regions;
    std::int64_t layer = -1, from_layer = 0, to_layer = UINT32_MAX, samples = 4;
    std::vector<double> size = {1024, 768};
    bool svg = false, travels = false, no_centres = false, no_table = false;
};

constexpr const char* kDescription =
    "Draws a toolpath in perspective, every bead as wide and as high as it is, lit so that neighbouring beads can be "
    "told; "
    "or with --layer one layer flat from above, where voids show red if the outlines are given with --regions and "
    "material "
    "laid twice shows dark.  Layers and Regions are drawn as solids, or with --layer as filled outlines.\n\n"
    "Colours tell where along the program a bead lies (progress), which stroke it belongs to, its layer, its width, or "
    "its class: "
    "bead, lift, jog, connector.  Green dots are where a stretch of path begins, red ones where it ends, orange ones "
    "lifts.\n\n"
    "A name that ends in .svg, or --svg, gives a layer as SVG in mm with true stroke widths.  Equal input gives equal "
    "bytes.";

cli::Spec spec(Options& o) {
    return {
        .name = "render",
        .synopsis = "draw a picture of any stream",
        .description = kDescription,
        .in = cli::reads(stream::Payload::unknown),
        .out = cli::text("a PNG picture, or SVG"),
        .memory = "the model",
        .options =
            {cli::Option{"color", &o.color, "",
                         "what colours mean; auto: stroke for Regions, layer for Layers, else progress"}
                 .one_of({"auto", "progress", "stroke", "layer", "width", "class"}),
             cli::Option{"view", &o.view, "VIEW",
                         "from where: iso, top, front, or X,Y,Z: the direction from the part to the camera"},
             cli::Option{"layer", &o.layer, "N", "draws this layer flat from above, -1 for all in perspective"}
                 .at_least(-1)
                 .at_most(UINT32_MAX),
             cli::Option{"from-layer", &o.from_layer, "N", "the lowest layer drawn"}.at_least(0).at_most(UINT32_MAX),
             cli::Option{"to-layer", &o.to_layer, "N", "the highest layer drawn: a cut"}.at_least(0).at_most(
                 UINT32_MAX),
             cli::Option{"regions", &o.regions, "FILE", "a Regions stream whose outlines are drawn with --layer"}
                 .not_a_setting(),
             cli::Option{"size", &o.size, "W,H", "width and height of the picture in pixels"}
                 .numbers(2)
                 .at_least(16)
                 .at_most(16384),
             cli::Option{"samples", &o.samples, "N", "rays per pixel; more give a calmer picture"}.at_least(1).at_most(
                 4096),
             cli::Option{"travels", &o.travels, "", "draws moves without material in perspective, too"},
             cli::Option{"no-centres", &o.no_centres, "", "leaves out the lines along the middle of beads"},
             cli::Option{"no-table", &o.no_table, "", "leaves out the table and its shadow"},
             cli::Option{"svg", &o.svg, "", "writes SVG; needs --layer"}},
        .examples = {{"slice part.stl | regions | sequence | fill | link3d | render --output part.png",
                      "the whole toolpath in perspective"},
                     {"slice part.stl | regions > part.regions; sequence part.regions | fill | link3d | render "
                      "--regions part.regions --layer 3 --output layer.png",
                      "one layer from above, with voids"}},
        .see_also = {"metrics", "peek"}};
}

render::By by(const std::string& color, stream::Payload payload) {
    if (color == "stroke") return render::By::stroke;
    if (color == "layer") return render::By::layer;
    if (color == "width") return render::By::width;
    if (color == "class") return render::By::role;
    if (color == "auto" && payload == stream::Payload::regions) return render::By::stroke;
    if (color == "auto" && payload == stream::Payload::layers) return render::By::layer;
    return render::By::progress;
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
    if (v.size() != 3 || !(geom::norm({v[0], v[1], v[2]}) > 0))
        throw Error(Exit::usage,
                    "cannot use '" + view +
                        "' for --view: it must be iso, top, front, or three numbers with commas between, not all 0");
    return {v[0], v[1], v[2]};
}

// Reads what lies in `range` of `file`; only outlines of a Regions stream if `outlines`.
stream::Payload load(const std::string& file, stream::Payload expected, render::Range range, render::Scene& scene) {
    stream::Reader reader(file, expected);
    while (auto f = reader.next()) {
        if (f->tag == stream::Tag::span)
            render::add(scene, wire::span(*f), range);
        else if (f->tag == stream::Tag::paths)
            render::add(scene, wire::paths(*f), range);
        else if (f->tag == stream::Tag::layer)
            render::add(scene, wire::layer(*f), range);
        else if (f->tag == stream::Tag::region)
            render::add(scene, wire::region(*f), range);
    }
    return reader.header().payload;
}

void run(const Options& o, const cli::Io& io) {
    const bool flat = o.layer >= 0, vector = o.svg || io.output.ends_with(".svg");
    if (vector && !flat) throw Error(Exit::usage, "cannot write SVG of all layers; choose one with --layer");
    const auto from = direction(o.view);
    const auto n = [](std::int64_t v) { return static_cast<std::uint32_t>(v); };
    const render::Range range =
        flat ? render::Range{n(o.layer), n(o.layer)} : render::Range{n(o.from_layer), n(o.to_layer)};
    render::Scene scene;
    const auto payload = load(io.input, stream::Payload::unknown, range, scene);
    if (flat && !o.regions.empty()) load(o.regions, stream::Payload::regions, range, scene);
    if (!flat && scene.spans.empty()) render::fill_outlines(scene);
    const auto tint = render::tint(scene, by(o.color, payload));
    const int w = static_cast<int>(o.size[0]), h = static_cast<int>(o.size[1]), samples = static_cast<int>(o.samples);
    std::string bytes;
    const render::FlatView flat_view{w, h, samples, true, !o.no_centres};
    if (vector)
        bytes = render::svg(scene, tint, flat_view);
    else if (flat)
        bytes = encode_png(render::draw_flat(scene, tint, flat_view, io.threads));
    else
        bytes = encode_png(
            render::draw_perspective(scene, tint, {w, h, from, samples, o.travels, !o.no_table}, io.threads));
    stream::Sink out(io.output, vector ? stream::Sink::Content::text : stream::Sink::Content::binary);
    out.write(bytes);
    out.commit();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
