// slice - cut a mesh into layers of closed contours
// reads:  a mesh file: STL, OBJ, PLY, OFF, 3MF or STEP
// writes: Layers
// memory: the model
#include "slice/slice.hpp"
#include "cli/command.hpp"
#include "cli/step_options.hpp"
#include "mesh/place.hpp"
#include "mesh/step/step.hpp"
#include "stream/crc32c.hpp"
#include "wire/planar.hpp"

#include <cstdio>

namespace {

using namespace filum;
using cli::Option;

struct Options {
    mesh::Placement place;
    slice::Options slice;
    mesh::step::Tessellation step;
};

constexpr const char* kDescription =
    "Reads a mesh from a file or standard input and cuts it at the mid-height of each layer; a face level "
    "with that counts as below it. The kind of file is recognised by its content: STL (binary or ASCII), OBJ, PLY "
    "(ASCII or binary), OFF, 3MF with its unit, components "
    "and build items, STEP if the build has OpenCASCADE.\n\n"
    "The part is scaled, turned, moved, centred and set on the bed, in this order. It gets round(height / layer "
    "height) layers, at least one, half a layer rounded down; a part lower than half a layer is an error.\n\n"
    "Bodies that overlap, touch or are a hairline apart become one solid; a shell that faces inwards within another "
    "stays a cavity. Flipped triangles are turned round, gaps in contours closed, contours led straight across holes "
    "in "
    "the surface. Whatever was repaired, and every open contour that had to be left out, is noted in the stream with "
    "its layer and length, and summed up on standard error.\n\n"
    "Limits: files up to 4 GiB, coordinates up to 10 km, a million layers. Contours are on a grid of 0.1 um.";

std::vector<Option> placing(mesh::Placement& p) {
    return {
        Option{"unit", &p.unit, "", "unit of the file; auto guesses from the size, 3MF and STEP state their own"}
            .one_of({"mm", "cm", "m", "in", "um", "auto"}),
        {"scale", &p.scale, "S|X,Y,Z", "factor on the size, one or one per axis; negative ones mirror"},
        Option{"rotate", &p.rotate_deg, "X,Y,Z", "degrees to turn about the x axis, then y, then z"}.numbers(3),
        Option{"translate", &p.translate, "X,Y,Z", "mm to move by"}.numbers(3),
        Option{"center", &p.center, "X,Y", "place for the middle of the part's box, mm"}.numbers(2),
        {"on-bed", &p.on_bed, "", "move the part's lowest point to z = 0: done unless --no-on-bed is given"},
        {"no-on-bed", &p.keep_z, "", "leave the part at its own height"},
    };
}

std::vector<Option> cutting(slice::Options& s) {
    return {
        Option{"layer-height", &s.layer_height, "MM", "thickness of a layer"}.above(0),
        Option{"first-layer-height", &s.first_layer_height, "MM", "thickness of the first layer, 0: as the others"}
            .at_least(0),
        {"adaptive", &s.adaptive, "", "choose the thickness of every layer by the slope of the surface"},
        Option{"min-layer-height", &s.min_layer_height, "MM", "least thickness of adaptive layers"}.above(0),
        Option{"max-layer-height", &s.max_layer_height, "MM", "greatest thickness of adaptive layers"}.above(0),
        Option{"cusp", &s.cusp, "MM", "how far the steps of adaptive layers may stand off the surface"}.above(0),
        Option{"close-gaps", &s.close_gaps, "MM", "width up to which gaps in contours are closed"}.at_least(0).at_most(
            100),
        Option{"close-openings", &s.close_openings, "SHARE",
               "close wider openings straight, up to this part of the contour's length; 0: never, nor holes"}
            .at_least(0)
            .at_most(1),
        Option{"hairline", &s.hairline, "MM", "heal gaps and slivers between bodies narrower than this"}
            .at_least(0)
            .at_most(1),
    };
}

cli::Spec spec(Options& o) {
    auto options = cutting(o.slice);
    for (Option& option : placing(o.place)) options.push_back(std::move(option));
    for (Option& option : cli::step_options(o.step)) options.push_back(std::move(option));
    return {.name = "slice",
            .synopsis = "cut a mesh into layers of closed contours",
            .description = kDescription,
            .in = cli::file("mesh file"),
            .out = cli::writes(stream::Payload::layers),
            .memory = "the model",
            .options = std::move(options),
            .examples = {{"slice part.stl > part.layers", "the layers of a part, 0.2 mm each"},
                         {"slice --layer-height 0.3 --rotate 0,0,45 --center 110,110 part.stl > part.layers",
                          "thicker layers of a part that is turned and put on the middle of the bed"},
                         {"slice --adaptive --max-layer-height 0.3 < part.stl > part.layers",
                          "thin layers on gentle slopes, thick ones on steep walls; from standard input"}},
            .see_also = {"regions", "peek"}};
}

void run(const Options& o, const cli::Io& io) {
    cli::Io self = io; // with what identifies the input, as its name may not
    mesh::File file;
    {
        const mesh::Bytes bytes = mesh::load(io.input);
        char crc[9];
        std::snprintf(crc, sizeof crc, "%08x", stream::crc32c(0, bytes.data.get(), bytes.size));
        self.settings.push_back({"input_crc32c", crc});
        file = mesh::step::read(bytes.view(), mesh::spoken_name(io.input), o.step);
    }
    Notes notes = std::move(file.notes);
    mesh::place(file.mesh, o.place, mesh::states_unit(file.kind), notes);
    const slice::Part part = slice::make_part(std::move(file.mesh), notes);
    const slice::Sweep sweep = slice::prepare(part, o.slice, io.threads, notes);
    auto header = cli::header(self, stream::Payload::layers);
    header.expected = sweep.levels.size();
    cli::source_stage(io, header, sweep.chunks(), std::move(notes), [&](std::size_t chunk, Notes& found) {
        slice::Cut cut = slice::cut(sweep, chunk);
        found = std::move(cut.notes);
        std::vector<stream::RawFrame> frames;
        for (const auto& layer : cut.layers) frames.push_back(wire::frame(layer));
        return frames;
    });
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
