// slice - cut a mesh into layers of closed contours
// reads:  a mesh file
// writes: Layers
// memory: the model
#include "slice/slice.hpp"
#include "cli/command.hpp"
#include "mesh/read.hpp"
#include "wire/planar.hpp"

#include <fstream>
#include <iostream>
#include <iterator>

namespace {

using namespace filum;

cli::Spec spec(slice::Options& o) {
    return {.name = "slice",
            .synopsis = "cut a mesh into layers of closed contours",
            .description = "Cuts.",
            .in = cli::file("mesh file"),
            .out = cli::writes(stream::Payload::layers),
            .memory = "the model",
            .options = {cli::Option{"layer-height", &o.layer_height, "MM", "thickness of a layer"}.above(0)},
            .examples = {{"slice part.stl > part.layers", "the layers of a part, 0.2 mm each"}}};
}

void run(const slice::Options& options, const cli::Io& io) {
    std::string bytes;
    if (io.input == "-")
        bytes.assign(std::istreambuf_iterator<char>(std::cin), {});
    else {
        std::ifstream f(io.input, std::ios::binary);
        if (!f) throw Error(Exit::io, "cannot open '" + io.input + "'");
        bytes.assign(std::istreambuf_iterator<char>(f), {});
    }
    Notes notes;
    const auto layers = slice::slice(mesh::read(bytes, "'" + io.input + "'"), options, notes);
    auto header = cli::header(io, stream::Payload::layers);
    header.expected = layers.size();
    stream::Writer writer(io.output, header);
    for (const auto& l : layers) writer.write(wire::frame(l));
    writer.close();
}

} // namespace

int main(int argc, char** argv) { return cli::main<slice::Options>(argc, argv, spec, run); }
