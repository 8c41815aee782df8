// render - a picture of any stream
// reads:  Layers, Regions, Paths, Toolpath or Surface
// writes: a PNG picture, SVG, PDF, VTP or an HTML page
// memory: the model
#include "app/render/render.hpp"
#include "cli/command.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

cli::Spec spec(render::Options& o) {
    using cli::Option;
    return {
        .name = "render",
        .synopsis = "draw a picture of any stream",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::unknown),
        .out = cli::text("a PNG picture, SVG, PDF, VTP or an HTML page"),
        .memory = "the model",
        .options = cli::with(
            {Option{"color", &o.color, "", "meaning of colours; auto: depends on the stream"}.one_of(
                 {"auto", "progress", "stroke", "tool", "layer", "width", "speed", "class"}),
             Option{
                 "view", &o.view, "VIEW",
                 "from where: iso, top, bottom, front, back, left, right, face (straight onto it), face-left, -right, "
                 "-up, -down (50 degrees aside), or X,Y,Z: towards the camera; auto: face for surfaces, else iso"}
                 .when("!views !layer"),
             Option{"views", &o.views, "VIEW,...", "several of these in one picture"}.when("!layer"),
             Option{"surface", &o.surface, "FILE", "the Surface stream that a toolpath lies on"}.not_a_setting(),
             {"by", &o.by, "FIELD", "field that colours the surface; beads are thin then, except with --voids"},
             {"arrows", &o.arrows, "FIELD", "a field of vectors, drawn as short lines on the surface"},
             Option{"collisions", &o.collisions, "FILE", "shows the places of 'collide --places'"}.not_a_setting(),
             Option{"part", &o.part, "FILE,...", "meshes that the head touches there"}.not_a_setting().when(
                 "collisions"),
             Option{"around", &o.around, "X,Y,Z,R", "fills the picture with R mm around this place"}.numbers(4).within(
                 -1e9, 1e9),
             {"voids", &o.voids, "", "marks where no bead covers the surface"},
             {"overlap", &o.overlap, "", "marks where passes of one layer cover the surface twice"},
             Option{"layer", &o.layer, "N", "draws this layer flat from above; -1: all"}.within(-1, UINT32_MAX),
             Option{"from-layer", &o.from_layer, "N", "the lowest layer drawn"}.within(0, UINT32_MAX).when("!layer"),
             Option{"to-layer", &o.to_layer, "N", "the highest layer drawn: a cut"}
                 .within(0, UINT32_MAX)
                 .when("!layer")
                 .a_limit(),
             Option{"regions", &o.regions, "FILE", "Regions stream whose outlines are shown, for a layer or a report"}
                 .not_a_setting(),
             Option{"figures", &o.figures, "FILE", "figures for a report, as TSV"}.not_a_setting(),
             Option{"title", &o.title, "TEXT", "title of a report; default: the name of the file"}.not_a_setting(),
             Option{"beside", &o.beside, "FILE", "second stream, shown side by side in a report"}.not_a_setting(),
             Option{"size", &o.size, "W,H", "size of the picture in pixels"}.numbers(2).at_least(16).at_most(8192),
             Option{"samples", &o.samples, "N",
                    "rays per pixel, 16 where beads are thinner than a pixel; more, a calmer picture"}
                 .within(1, 4096),
             Option{"machine", &o.machine, "NAME|FILE", "machine profile for the speeds of --color speed or a report"}
                 .not_a_setting(),
             Option{"travels", &o.travels, "", "draws moves without material in perspective, too"}
                 .when("!layer")
                 .a_limit(),
             {"no-centres", &o.no_centres, "", "leaves out the lines along the middle of beads"},
             Option{"no-table", &o.no_table, "", "leaves out the table and its shadow"}.when("!layer"),
             Option{"format", &o.format, "", "format of the picture; auto: by the ending of its name, else png"}.one_of(
                 {"auto", "png", "svg", "pdf"})},
            cli::when("collisions", cli::head_options(o.head))),
        .groups = {{"the view",
                    {"view", "views", "size", "format", "samples", "from-layer", "to-layer", "travels", "no-centres",
                     "no-table"}},
                   {"a layer, flat", {"layer", "regions"}},
                   {"on a surface", {"surface", "by", "arrows", "voids", "overlap"}},
                   {"collisions", {"collisions", "part", "around"}},
                   {"a report", {"figures", "title", "beside"}},
                   cli::head_group()},
        .examples = {{"slice part.stl | regions | sequence | fill | link3d | render --output part.png",
                      "the whole toolpath in perspective"},
                     {"slice part.stl | regions > part.regions; sequence part.regions | fill | link3d | "
                      "render --regions part.regions --layer 3 --output layer.png",
                      "one layer from above, with voids"},
                     {"slice part.stl | regions | sequence | render --output order.png",
                      "which regions are printed in one stroke"},
                     {"slice part.stl | regions | sequence | fill | link3d | render --output part.html",
                      "a page to look around in"},
                     {"geodesic part.stl --source vertex:0 --spacing 1 | render --by distance --views iso,back "
                      "--output distance.png",
                      "distances on a surface"}},
        .see_also = {"metrics", "peek", "geodesic", "surfpath"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<render::Options>(argc, argv, spec, app::render::run); }
