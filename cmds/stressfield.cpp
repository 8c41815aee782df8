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

constexpr const char* kDescription =
    "Reads stresses from the file of --stress and adds fields to the vertices of the surface, or of each patch of a "
    "divided one. stress.CASE.s1, .s2 and .s3 are the principal stresses in MPa. stress.CASE.d1 is the unit vector "
    "along which the greatest one, s1, pulls. A direction and its opposite are equal; the one with a positive "
    "largest component is written. Unknown values are infinite. Existing fields stay. Without --stress nothing is "
    "added.\n\n"
    "The file is FRD, VTU or CSV, plain or packed by gzip, recognised by its content. peek shows what was read, in "
    "which order and unit.\n\n"
    "FRD is the result of CalculiX as text. The STRESS of each step becomes a load case with the step's number, that "
    "of a mode STEP-modeN. Of several increments the last one counts; --step STEP-INCREMENT takes another one.\n\n"
    "VTU is a VTK grid, in any encoding except LZ4 and LZMA. Each array of stresses at the points becomes a load "
    "case with its name: of 6 or 9 numbers, or six arrays of one number. Arrays of strains, and arrays whose name "
    "does not say stress, are left out; --columns names those to take, also vectors. The names of components give "
    "their order. Six numbers without names are taken in VTK's order, xx yy zz xy yz xz, with a note. --order gives "
    "another one: abaqus (xx yy zz xy xz yz), voigt (xx yy zz yz xz xy), upper (xx xy xz yy yz zz), or names in "
    "their order.\n\n"
    "CSV is a table with a line per point: x,y,z and either the vector of s1, with or without s1,s2,s3, or the whole "
    "tensor. The header names the columns, with their units. Otherwise --columns lists them in order: x,y,z, "
    "s1x,s1y,s1z, s1,s2,s3, sxx,syy,szz,sxy,syz,szx, and - for others. If no s1 is given, it is the length of the "
    "vector.\n\n"
    "If there are elements, a vertex takes the stress of the element around it, else of the nearest place on their "
    "outer faces that face its way. Of bare points it takes the three around it on the surface, linearly; points on "
    "the other side of a thin wall do not count. --reach is the farthest allowed distance. A direction is unknown "
    "where s1 equals s2, or is below the share of --mask. Where a part is pressed, s1 is about 0 and its direction "
    "is the surface's normal, which is useless on it. A note and a fact give the area of such places. --tangent "
    "takes the direction of the greatest stress in the tangent plane instead.";

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
            .description = kDescription,
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
    const cli::Whole before = cli::read_all(io.input, stream::Payload::surface,
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
