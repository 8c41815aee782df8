// postproc - a toolpath to machine code
// reads:  Toolpath
// writes: text
// memory: one span
#include "base/number.hpp"
#include "cli/command.hpp"
#include "wire/planar.hpp"

#include <numbers>

namespace {

using namespace filum;

struct Options {
    std::string machine = "marlin";
};

cli::Spec spec(Options& o) {
    return {
        .name = "postproc",
        .synopsis = "a toolpath to machine code",
        .description = "Writes.",
        .in = cli::reads(stream::Payload::toolpath),
        .out = cli::text("machine code"),
        .memory = "one span",
        .options = {{"machine", &o.machine, "NAME", "machine profile"}},
        .examples = {{"slice part.stl | regions | sequence | fill | link3d | postproc --machine marlin > part.gcode",
                      "G-code"}}};
}

void run(const Options&, const cli::Io& io) {
    stream::Reader reader(io.input, stream::Payload::toolpath);
    stream::Sink out(io.output, stream::Sink::Content::text);
    out.write("G21\nG90\nM83\n");
    const double filament = std::numbers::pi * 1.75 * 1.75 / 4;
    while (auto f = reader.next()) {
        if (f->tag == stream::Tag::note) continue;
        const auto s = wire::span(*f);
        std::string text;
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i) {
            const auto& q = s.points[i + 1];
            text += toolpath::extrudes(s.role) ? "G1 X" : "G0 X";
            append_fixed(text, q.x, 3);
            text += " Y";
            append_fixed(text, q.y, 3);
            text += " Z";
            append_fixed(text, q.z, 3);
            if (toolpath::extrudes(s.role)) text += " E", append_fixed(text, toolpath::volume(s, i) / filament, 5);
            text += "\n";
        }
        out.write(text);
    }
    out.commit();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
