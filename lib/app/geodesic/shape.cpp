#include "app/geodesic/shape.hpp"

#include "surface/curve/transfer.hpp"
#include "surface/remesh.hpp"

namespace filum::app::geodesic {

using cli::Option;

std::vector<Option> options(Shaping& to) {
    return {Option{"cut", &to.cut, "NX,NY,NZ,D", "keep what lies where NX x + NY y + NZ z <= D"}.numbers(4).within(-1e7,
                                                                                                                   1e7),
            Option{"cut-mesh", &to.cut_mesh, "FILE", "cut by a closed mesh, in a file as the input's"}.not_a_setting(),
            Option{"keep", &to.keep, "", "what of the surface --cut-mesh leaves"}
                .one_of({"outside", "inside"})
                .when("cut-mesh"),
            Option{"remesh", &to.remesh, "MM", "make all sides about this long, rims and sharp edges kept; 0: do not"}
                .zero_or_at_least(0.001)
                .at_most(1e6)};
}

void shape(Model& model, const Shaping& how, const mesh::Placement& place, cli::Io& self) {
    if (how.cut.empty() && how.cut_mesh.empty() && how.remesh == 0) return;
    surface::Sheet& sheet = model.sheet;
    surface::Surface now = sheet.surface;
    if (const auto& c = how.cut; !c.empty())
        now = surface::cut(now, surface::Plane{{c[0], c[1], c[2]}, c[3]}, model.notes);
    if (!how.cut_mesh.empty()) {
        const mesh::Mesh solid = read_mesh(how.cut_mesh, "cut_mesh_crc32c", place, self, model.notes);
        now = surface::cut(now, solid, how.keep == Keep::inside, model.notes);
    }
    if (how.remesh > 0) now = surface::remesh(now, how.remesh, model.notes);
    sheet.fields = surface::curve::transferred(sheet.surface, sheet.fields, now);
    sheet.faces = surface::curve::transferred_faces(sheet.surface, sheet.faces, now);
    const auto gone = [&](const char* what, std::size_t count) {
        if (count > 0) model.notes.push_back({.stage = "", .what = what, .amount = 0, .unit = "", .count = count});
    };
    gone("isoline of the surface before dropped", sheet.isolines.size());
    gone("source of the surface before dropped", sheet.sources.vertices.size() + sheet.sources.segments.size());
    sheet = {.surface = std::move(now),
             .fields = std::move(sheet.fields),
             .isolines = {},
             .sources = {},
             .name = std::move(sheet.name),
             .faces = std::move(sheet.faces),
             .algorithm = std::move(sheet.algorithm)};
}

} // namespace filum::app::geodesic
