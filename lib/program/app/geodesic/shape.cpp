#include "app/geodesic/shape.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "surface/curve/transfer.hpp"
#include "surface/facing.hpp"
#include "surface/fit/fit.hpp"
#include "surface/remesh.hpp"

namespace filum::app::geodesic {

using cli::Option;

namespace {

// The side length of triangles, mm; 0: no remeshing.  Throws Error(usage) for other text.
double side(const std::string& remesh) {
    const double out = parse_number(remesh, "--remesh");
    if (!(out == 0 || (out >= 0.001 && out <= 1e6)))
        throw Error(Exit::usage, "cannot remesh to '" + remesh + "'; say auto, 0, or a length from 0.001 to 1e6 mm");
    return out;
}

surface::Surface remeshed(const surface::Surface& s, const Shaping& how, Notes& notes, Facts& facts) {
    if (how.remesh != "auto") {
        const double edge = side(how.remesh);
        const std::size_t thin = surface::stretched(s, edge);
        if (thin == 0) return surface::remesh(s, edge, notes);
        notes.push_back({NoteCode::triangle_stretched, how.tolerance, thin});
        return surface::remesh(surface::fit::evened(s, {edge, how.tolerance}), edge, notes);
    }
    auto out = surface::fit::fitted(s, {how.longest, how.tolerance});
    facts.push_back({"", "remesh-off", out.off, "mm"});
    if (out.off > how.tolerance)
        notes.push_back({NoteCode::remesh_off, out.off, 1, -1, out.off_at.x, out.off_at.y, out.off_at.z});
    return std::move(out.surface);
}

} // namespace

std::vector<Option> options(Shaping& to) {
    return {
        Option{"flip", &to.flip, "",
               "turns the surface round, so that its back becomes its front; if only some components face inwards, "
               "turns those"},
        Option{"cut", &to.cut, "NX,NY,NZ,D", "keeps the side where NX x + NY y + NZ z <= D; may be given several times"}
            .numbers(4)
            .repeated()
            .within(-1e7, 1e7),
        Option{"cut-mesh", &to.cut_mesh, "FILE", "cuts by a closed mesh; all kinds of files of the input"}
            .not_a_setting(),
        Option{"keep", &to.keep, "", "the side of --cut-mesh that remains"}
            .one_of({"outside", "inside"})
            .when("cut-mesh"),
        Option{"remesh", &to.remesh, "MM|auto",
               "makes all sides about this long and keeps rims and sharp edges; auto: by bends; 0: off"},
        Option{"longest", &to.longest, "MM",
               "longest side where the surface is flat: the distance between paths, or half of it"}
            .within(0.001, 1e6)
            .when("remesh=auto"),
        Option{"tolerance", &to.tolerance, "MM", "largest distance of the new surface from the given one"}
            .within(1e-4, 1000)
            .when("remesh=auto")
            .a_limit()};
}

Facts shape(Model& model, const Shaping& how, const mesh::Placement& place, cli::Io& self) {
    Facts facts;
    const bool remesh = how.remesh == "auto" || side(how.remesh) > 0;
    if (how.cut.empty() && how.cut_mesh.empty() && !remesh && !how.flip) return facts;
    surface::Sheet& sheet = model.sheet;
    if (how.flip) sheet.surface = surface::flipped(sheet.surface);
    surface::Surface now = sheet.surface;
    for (std::size_t i = 0; i + 3 < how.cut.size(); i += 4) {
        const double* c = &how.cut[i];
        now = surface::cut(now, surface::Plane{{c[0], c[1], c[2]}, c[3]}, model.notes);
    }
    if (!how.cut_mesh.empty()) {
        const mesh::Mesh solid = read_mesh(how.cut_mesh, "cut_mesh_crc32c", place, self, model.notes);
        now = surface::cut(now, solid, how.keep == Keep::inside, model.notes);
    }
    if (remesh) now = remeshed(now, how, model.notes, facts);
    if (!how.cut.empty() || !how.cut_mesh.empty() || remesh)
        model.of_file.clear(); // the vertices are no longer those of the file
    sheet.fields = surface::curve::transferred(sheet.surface, sheet.fields, now);
    sheet.faces = surface::curve::transferred_faces(sheet.surface, sheet.faces, now);
    const auto gone = [&](NoteCode code, std::size_t count) {
        if (count > 0) model.notes.push_back({.code = code, .count = count});
    };
    gone(NoteCode::isoline_dropped, sheet.isolines.size());
    gone(NoteCode::source_dropped, sheet.sources.vertices.size() + sheet.sources.segments.size());
    sheet = {.surface = std::move(now),
             .fields = std::move(sheet.fields),
             .isolines = {},
             .sources = {},
             .name = std::move(sheet.name),
             .faces = std::move(sheet.faces),
             .algorithm = std::move(sheet.algorithm)};
    return facts;
}

} // namespace filum::app::geodesic
