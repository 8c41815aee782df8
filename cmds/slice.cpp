// slice - cut a mesh into layers of closed contours
// reads:  a mesh file: STL, OBJ, PLY, OFF or 3MF
// writes: Layers
// memory: the model
#include "slice/slice.hpp"
#include "cli/command.hpp"
#include "mesh/place.hpp"
#include "mesh/read.hpp"
#include "parallel/parallel.hpp"
#include "stream/crc32c.hpp"
#include "wire/planar.hpp"

#include <cstdio>

namespace {

using namespace filum;

struct Options {
    mesh::Placement place;
    bool no_on_bed = false;
    slice::Options slice;
};

const char* const kDescription =
    "Reads a mesh from a file or from standard input and cuts it at the mid-height of every layer. The kind of file is "
    "recognised by its content: STL (binary or ASCII), OBJ, PLY (ASCII or binary), OFF, 3MF with units, components and "
    "build items.\n\n"
    "The part is scaled, turned, moved, centred and set on the bed, in this order. It gets round(height / layer "
    "height) "
    "layers, at least one; less than half a layer is an error.\n\n"
    "Bodies that overlap, touch or are a hairline apart become one solid; a shell inside another, facing inwards, "
    "stays a "
    "cavity. Broken meshes are repaired as far as their contours tell how: flipped triangles are turned round, gaps "
    "are "
    "closed, wide openings are closed straight where that is short beside the contour. Whatever was repaired, and "
    "every "
    "open contour that had to be left out, is noted in the stream with layer, place and length, and summed up on "
    "standard "
    "error.\n\n"
    "Limits: files up to 4 GiB, coordinates up to 10 km, a million layers. Contours are on a grid of 0.1 um.";

std::vector<cli::Option> options(Options& o) {
    auto& p = o.place;
    auto& s = o.slice;
    return {
        cli::Option{"layer-height", &s.layer_height, "MM", "thickness of a layer"}.above(0),
        cli::Option{"first-layer-height", &s.first_layer_height, "MM",
                    "thickness of the first layer, 0 for that of all"}
            .at_least(0),
        cli::Option{"adaptive", &s.adaptive, "", "choose the thickness of each layer from the slope of the surface"},
        cli::Option{"min-layer-height", &s.min_layer_height, "MM", "least thickness of adaptive layers"}.above(0),
        cli::Option{"max-layer-height", &s.max_layer_height, "MM", "greatest thickness of adaptive layers"}.above(0),
        cli::Option{"cusp", &s.cusp, "MM", "how far the steps of adaptive layers may stand off the surface"}.above(0),
        cli::Option{"unit", &p.unit, "",
                    "what one unit of the file is; auto guesses from the size, 3MF states it itself"}
            .one_of({"mm", "cm", "m", "in", "um", "auto"}),
        cli::Option{"scale", &p.scale, "S|SX,SY,SZ", "factor on the size, one or one per axis; negative ones mirror"},
        cli::Option{"rotate", &p.rotate_deg, "X,Y,Z", "turn by so many degrees about the x axis, then y, then z"}
            .numbers(3),
        cli::Option{"translate", &p.translate, "X,Y,Z", "move by so many mm"}.numbers(3),
        cli::Option{"center", &p.center, "X,Y", "move the middle of the part's box to this place, mm"}.numbers(2),
        cli::Option{"on-bed", &p.on_bed, "", "move the part's lowest point to z = 0; this is the default"},
        cli::Option{"no-on-bed", &o.no_on_bed, "", "leave the part at its own height"},
        cli::Option{"close-gaps", &s.close_gaps, "MM", "close gaps in contours up to this width"}.at_least(0).at_most(
            100),
        cli::Option{"close-openings", &s.close_openings, "SHARE",
                    "close wider openings straight, up to this part of the contour's length; 0 never"}
            .at_least(0)
            .at_most(1),
        cli::Option{"hairline", &s.hairline, "MM", "heal gaps and slivers between bodies narrower than this"}
            .at_least(0)
            .at_most(1)};
}

cli::Spec spec(Options& o) {
    return {.name = "slice",
            .synopsis = "cut a mesh into layers of closed contours",
            .description = kDescription,
            .in = cli::file("mesh file"),
            .out = cli::writes(stream::Payload::layers),
            .memory = "the model",
            .options = options(o),
            .examples = {{"slice part.stl > part.layers", "the layers of a part, 0.2 mm each"},
                         {"slice --layer-height 0.3 --center 110,110 --rotate 0,0,45 part.stl > part.layers",
                          "thicker layers of a part that is turned and put in the middle of the bed"},
                         {"slice --adaptive --min-layer-height 0.1 --max-layer-height 0.3 < part.stl > part.layers",
                          "thin layers on gentle slopes, thick ones on steep walls; from standard input"}},
            .see_also = {"regions", "peek"}};
}

std::string hexadecimal(std::uint32_t v) {
    char text[9];
    std::snprintf(text, sizeof text, "%08x", v);
    return text;
}

struct Chunk {
    std::vector<stream::RawFrame> frames;
    Notes notes;
};

void run(const Options& given, const cli::Io& io) {
    Options o = given;
    if (o.no_on_bed) o.place.on_bed = false;
    cli::Io self = io; // with what identifies the input, as no path may
    mesh::File file;
    {
        const mesh::Bytes bytes = mesh::load(io.input);
        const bool standard = io.input.empty() || io.input == "-";
        self.settings.push_back({"input_crc32c", hexadecimal(stream::crc32c(0, bytes.data.get(), bytes.size))});
        file = mesh::read(bytes.view(), standard ? "standard input" : "'" + io.input + "'");
    }
    Notes& notes = file.notes;
    mesh::place(file.mesh, o.place, file.kind == mesh::Kind::threemf, notes);
    const slice::Part part = slice::make_part(std::move(file.mesh), notes);
    const slice::Sweep sweep = slice::prepare(part, o.slice, io.threads, notes);

    auto header = cli::header(self, stream::Payload::layers);
    header.expected = sweep.levels.size();
    stream::Writer writer(io.output, header);
    cli::Report report(io);
    cli::Progress progress(io, sweep.chunks());
    const auto tell = [&](Notes& all) {
        for (Note& n : all) {
            n.stage = io.program;
            writer.write(n);
            report.add(n);
        }
    };
    tell(notes);
    std::size_t next = 0;
    parallel::ordered<std::size_t, Chunk>(
        io.threads,
        [&]() -> std::optional<std::size_t> { return next < sweep.chunks() ? std::optional(next++) : std::nullopt; },
        [&](std::size_t chunk) {
            slice::Cut cut = slice::cut(sweep, chunk);
            Chunk out{{}, std::move(cut.notes)};
            for (auto& layer : cut.layers) {
                out.frames.push_back(wire::frame(layer));
                layer = {};
            }
            return out;
        },
        [&](Chunk chunk) {
            for (const auto& frame : chunk.frames) writer.write(frame);
            tell(chunk.notes);
            progress.step();
        });
    writer.close();
    report.say();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
