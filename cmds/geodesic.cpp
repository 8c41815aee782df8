// geodesic - distances on a surface, and lines of equal distance
// reads:  a mesh file: STL, OBJ, PLY, OFF or 3MF
// writes: Surface
// memory: the model, and some hundred bytes per edge for exact distances
#include "cli/command.hpp"
#include "geodesic/choose.hpp"
#include "geodesic/lines.hpp"
#include "geodesic/measure.hpp"
#include "mesh/place.hpp"
#include "mesh/read.hpp"
#include "stream/crc32c.hpp"
#include "surface/remesh.hpp"
#include "wire/surface.hpp"

#include <cstdio>

namespace {

using namespace filum;
using cli::Option;

struct Options {
    mesh::Placement place;
    std::string source, lines;
    std::vector<double> cut;
    double remesh = 0;
    geodesic::Options measure;
};

constexpr const char* kDescription =
    "Reads a triangle mesh, open or closed, from a file or standard input, and makes it a surface: every edge with "
    "one or two triangles, every vertex with one fan of them, all facing one way. What had to be repaired for that "
    "is noted: triangles that stand twice or have no area, that face against their neighbours, edges of more than "
    "two triangles (the flattest pair stays joined, the others are cut off), parts that touch in a point. Several "
    "components stay as they are. Then it is cut with --cut and remeshed with --remesh, if asked.\n\n"
    "With --source it computes the distance of every vertex from the nearest source along the surface, infinite "
    "where no source is on the same component. Sources, several in quotes with blanks between: vertex:ID, numbered "
    "as in the file from 0, after a cut as in 'peek --text'; point:X,Y,Z, the nearest point of the surface; "
    "boundary, boundary:outer or boundary:N, all rims, the one of each component that spans most, or one; "
    "plane:NX,NY,NZ,D, where the plane NX x + NY y + NZ z = D cuts the surface. --source-lines names a text of "
    "points, three numbers a line, lines of points apart by an empty line, drawn onto the surface.\n\n"
    "By default distances are exact: the length of the shortest path on the triangles to the nearest point of the "
    "sources, found by propagating windows; lines are sources as such, not their vertices. Isolines cross edges "
    "where the distance has their level, solved from the windows, and bend between them to 0.001 mm. --method heat "
    "lets heat flow instead (auto: on more than 300,000 triangles): off by some percent beyond 16 mean edges from "
    "the sources, with isolines that are straight in every triangle. --paper does it as Kipping et al. 2022, with "
    "the vertices nearest to lines as sources, for comparison only.\n\n"
    "Facts in the stream tell how many vertices were reached, the farthest, and how far the slope of the distances, "
    "taken as linear in every triangle, is from 1: it is where fronts meet, near points and on coarse meshes.";

cli::Spec spec(Options& o) {
    return {
        .name = "geodesic",
        .synopsis = "measure distances on a surface",
        .description = kDescription,
        .in = cli::file("mesh file"),
        .out = cli::writes(stream::Payload::surface),
        .memory = "the model, and some hundred bytes per edge for exact distances",
        .options =
            {{"source", &o.source, "SOURCES", "where distance is 0; none: only make the surface"},
             Option{"source-lines", &o.lines, "FILE", "lines of points where distance is 0 as well; see above"}
                 .not_a_setting(),
             Option{"cut", &o.cut, "NX,NY,NZ,D", "keep what lies where NX x + NY y + NZ z <= D"}.numbers(4),
             Option{"remesh", &o.remesh, "MM", "make all sides about this long, rims and sharp edges kept; 0: do not"}
                 .at_least(0),
             Option{"method", &o.measure.method, "", "how distances are found"}.one_of({"auto", "exact", "heat"}),
             {"paper", &o.measure.paper, "", "heat as in Kipping et al. 2022: snapped sources, no corrections"},
             {"levels", &o.measure.levels, "MM,...", "isolines at these distances"},
             Option{"spacing", &o.measure.spacing, "MM", "isolines at every multiple of this; 0: none"}.at_least(0),
             Option{"first", &o.measure.first, "MM", "where the first of these is; 0: one spacing away"}.at_least(0),
             Option{"unit", &o.place.unit, "", "unit of the file; auto guesses from the size, 3MF states its own"}
                 .one_of({"mm", "cm", "m", "in", "um", "auto"}),
             {"scale", &o.place.scale, "S|X,Y,Z", "factor on the size, one or one per axis; negative ones mirror"}},
        .examples = {{"geodesic part.stl --source vertex:0 > part.surface", "distances from a corner of a part"},
                     {"geodesic part.stl --source 'plane:1,0,0,4.5' --spacing 1 | peek",
                      "lines at 1, 2, 3 ... mm from where a plane cuts a part"},
                     {"geodesic part.stl | peek", "what had to be repaired to make a surface of it"}},
        .see_also = {"slice", "peek"}};
}

// The file's content; what it is enters the history, its name does not.
mesh::Bytes load(const std::string& path, const char* setting, cli::Io& self) {
    mesh::Bytes bytes = mesh::load(path);
    char crc[9];
    std::snprintf(crc, sizeof crc, "%08x", stream::crc32c(0, bytes.data.get(), bytes.size));
    self.settings.push_back({setting, crc});
    return bytes;
}

void run(const Options& o, const cli::Io& io) {
    cli::Io self = io; // with what identifies the input
    mesh::File file = mesh::read(load(io.input, "input_crc32c", self).view(), mesh::spoken_name(io.input));
    Notes notes = std::move(file.notes);
    mesh::Placement place = o.place;
    place.on_bed = false;
    mesh::place(file.mesh, place, file.kind == mesh::Kind::threemf, notes);
    surface::Sheet sheet{surface::connect(std::move(file.mesh), notes), {}, {}};
    if (const auto& c = o.cut; !c.empty())
        sheet.surface = surface::cut(sheet.surface, {{c[0], c[1], c[2]}, c[3]}, notes);
    if (o.remesh > 0) sheet.surface = surface::remesh(sheet.surface, o.remesh, notes);
    auto sources = geodesic::choose(sheet.surface, o.source, notes);
    if (!o.lines.empty()) {
        const mesh::Bytes text = load(o.lines, "source_lines_crc32c", self);
        geodesic::add_lines(sources, sheet.surface, geodesic::read_lines(text.view(), "'" + o.lines + "'"), notes);
    }
    Facts facts = surface::facts(sheet.surface);
    if (!sources.empty()) {
        const Facts found = geodesic::measure(sheet, sources, o.measure);
        facts.insert(facts.end(), found.begin(), found.end());
    } else if (!o.measure.levels.empty() || o.measure.spacing > 0) {
        throw Error(Exit::usage, "cannot draw isolines without a --source");
    }
    auto header = cli::header(self, stream::Payload::surface);
    header.expected = 1;
    cli::write_one(io, header, std::move(notes), std::move(facts), wire::frame(sheet));
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
