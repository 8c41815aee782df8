// stressfield - stresses of a finite-element program onto a surface
// reads:  Surface
// writes: Surface
// memory: the surface, and the file of stresses twice over
#include "stressfield/stressfield.hpp"
#include "base/printable.hpp"
#include "cli/command.hpp"
#include "cli/head_options.hpp"
#include "mesh/read.hpp"
#include "stream/crc32c.hpp"
#include "stressfield/read.hpp"
#include "wire/surface.hpp"

#include <cstdio>

namespace {

using namespace filum;
using cli::Option;

struct Options {
    std::string file;
    stressfield::ReadOptions read;
    stressfield::Options place;
};

std::vector<Option> options(Options& o) {
    const std::vector<Option> how = {
        {"case", &o.read.names, "NAME,...", "names for the load cases of the file, in order; none: its own"},
        {"step", &o.read.step, "NAME",
         "result of an FRD to take as a load case: STEP, STEP-INCREMENT, STEP-modeN, all"},
        {"columns", &o.read.columns, "NAME,...",
         "meaning of the columns of a CSV, or the arrays of a VTU; none: see above"},
        {"order", &o.read.order, "ORDER",
         "order of the numbers of a tensor in a VTU: vtk, abaqus, voigt, upper, or their names"},
        Option{"decimal", &o.read.decimal, "", "decimal mark of a CSV; auto: from its numbers"}.one_of(
            {"auto", "point", "comma"}),
        Option{"unit", &o.read.unit, "", "unit of positions; auto: from the file, else mm"}.one_of(
            {"auto", "mm", "cm", "m", "in"}),
        Option{"stress-unit", &o.read.stress_unit, "", "unit of stresses; auto: from the file, else MPa"}.one_of(
            {"auto", "MPa", "Pa", "kPa", "GPa", "psi", "ksi"}),
        Option{"reach", &o.place.reach, "MM", "largest distance of stresses from the surface; 0: by the spacing there"}
            .within(0, 1e6)
            .a_limit(),
        {"tangent", &o.place.tangent, "", "takes directions in the tangent plane"},
        Option{"mask", &o.place.mask, "SHARE", "no direction where s1 is below this share of its greatest"}
            .within(0, 1)
            .a_limit()};
    return cli::with(
        {Option{"stress", &o.file, "FILE", "the stresses: FRD, VTU or CSV, also packed by gzip"}.not_a_setting()},
        cli::when("stress", how));
}

cli::Spec spec(Options& o) {
    return {.name = "stressfield",
            .synopsis = "put stresses onto a surface",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::surface),
            .out = cli::writes(stream::Payload::surface),
            .memory = "the surface, and the file of stresses twice over",
            .options = options(o),
            .groups = {{"the file",
                        {"stress", "case", "step", "columns", "order", "decimal", "unit", "stress-unit", "reach"}},
                       {"directions", {"tangent", "mask"}}},
            .examples =
                {{"printf '0 0 1 5 0 0\\n9 0 1 5 0 0\\n9 9 1 5 0 0\\n0 9 1 5 0 0\\n' > stress.csv; geodesic part.stl | "
                  "stressfield --stress stress.csv --case X --reach 1 | peek",
                  "a part that is pulled along x with 5 MPa at the corners of its top"}},
            .see_also = {"geodesic", "peek"}};
}

void run(const Options& o, const cli::Io& io) {
    std::vector<surface::Sheet> sheets;
    const cli::WholeInput before = cli::read_all(io.input, stream::Payload::surface,
                                                 [&](const stream::RawFrame& f) { sheets.push_back(wire::sheet(f)); });
    cli::Io self = io; // with what identifies the file
    Notes notes;
    Facts facts;
    if (!o.file.empty()) {
        const mesh::Bytes bytes = mesh::load(o.file);
        char crc[9];
        std::snprintf(crc, sizeof crc, "%08x", stream::crc32c(0, bytes.data.get(), bytes.size));
        self.settings.push_back({"stress_crc32c", crc});
        const auto samples = stressfield::read(bytes.view(), mesh::spoken_name(o.file), o.read, notes);
        for (const auto& c : samples.cases) self.settings.push_back({"stress_read." + c.name, printable(c.origin)});
        stressfield::add(sheets, samples, o.place, io.threads, notes, facts);
    }
    std::vector<stream::RawFrame> frames;
    frames.reserve(sheets.size());
    for (const auto& sheet : sheets) frames.push_back(wire::frame(sheet));
    cli::write_all(io, cli::header(self, stream::Payload::surface, {&before.header}), before, notes, facts, frames);
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
