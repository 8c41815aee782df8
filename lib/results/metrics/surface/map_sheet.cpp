#include "metrics/surface/map_sheet.hpp"

#include "geom/bvh.hpp"
#include "surface/finer.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace filum::metrics::surface {

namespace {

using filum::surface::Field;
using filum::surface::Sheet;

// About as many bytes as the sheet takes in a stream: numbers of 8 bytes, and numbers of vertices and sides up to 4.
std::size_t bytes(const Sheet& sheet) {
    std::size_t values = 3 * sheet.surface.vertices.size();
    for (const Field& f : sheet.fields) values += f.values.size();
    return 8 * values + 4 * 6 * sheet.surface.triangles.size();
}

// For each vertex of `to` the nearest one of `from`; ties: the first.
std::vector<std::size_t> nearest(const Surface& from, const Surface& to, double apart) {
    std::vector<geom::Box3> boxes;
    boxes.reserve(from.vertices.size());
    for (const Vec3& p : from.vertices) boxes.push_back({p, p});
    const geom::Bvh tree(boxes);
    std::vector<std::size_t> out;
    out.reserve(to.vertices.size());
    for (const Vec3& p : to.vertices) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t best = 0;
        for (double reach = apart; !(least <= reach); reach *= 2) {
            tree.visit(geom::grown({p, p}, reach), [&](std::uint32_t i) {
                const double d = distance(from.vertices[i], p);
                if (d > least || (d == least && i >= best)) return;
                least = d;
                best = i;
            });
        }
        out.push_back(best);
    }
    return out;
}

Sheet at_points_of(const Sheet& sheet, Surface coarse) {
    const auto from = nearest(sheet.surface, coarse, filum::surface::mean_edge(sheet.surface));
    Sheet out;
    out.surface = std::move(coarse);
    out.name = sheet.name;
    for (const Field& f : sheet.fields) {
        out.fields.push_back({f.name, {}, f.components});
        for (const std::size_t v : from)
            for (std::size_t c = 0; c < f.components; ++c)
                out.fields.back().values.push_back(f.values[f.components * v + c]);
    }
    return out;
}

} // namespace

Sheet sheet_of(const Map& map, const std::string& name) {
    Sheet out{map.ground.surface, {}, {}};
    out.name = name;
    std::vector<double> volume;
    for (std::size_t v = 0; v < map.even.size(); ++v)
        volume.push_back(map.nominal[v] > 0 ? map.even[v] / map.nominal[v] : std::numeric_limits<double>::infinity());
    out.fields = {{"thickness", map.thickness},
                  {"thickness-even", map.even},
                  {"thickness-nominal", map.nominal},
                  {"fibre-volume", std::move(volume)}};
    for (std::size_t k = 0; k < map.plies.size(); ++k) {
        const PlyMap& ply = map.plies[k];
        const auto field = [&](const char* what, const auto& value_of) {
            Field f{"ply-" + std::to_string(k + 1) + "." + what, {}};
            for (std::size_t v = 0; v < ply.passes.size(); ++v) f.values.push_back(value_of(v));
            out.fields.push_back(std::move(f));
        };
        field("thickness", [&](std::size_t v) { return ply.height * ply.passes[v]; });
        field("covered", [&](std::size_t v) { return std::min(1.0, ply.passes[v]); });
        field("twice", [&](std::size_t v) { return std::clamp(ply.passes[v] - 1, 0.0, 1.0); });
        field("gap", [&](std::size_t v) { return ply.clearance[v]; });
        field("deviation", [&](std::size_t v) { return ply.deviation[v]; });
        if (!ply.edge.empty()) field("edge", [&](std::size_t v) { return ply.edge[v]; });
    }
    return out;
}

Sheet with_fewer_points(Sheet sheet, const Surface& base, std::size_t most) {
    if (sheet.surface.vertices.empty() || bytes(sheet) <= most) return sheet;
    double edge = 0; // mm: the longest side
    for (std::size_t h = 0; h < 3 * sheet.surface.triangles.size(); ++h)
        edge = std::max(edge, distance(sheet.surface.vertices[sheet.surface.tail(h)],
                                       sheet.surface.vertices[sheet.surface.head(h)]));
    const std::size_t per_vertex = bytes(sheet) / sheet.surface.vertices.size();
    Surface coarse;
    do {
        edge *= 2;
        coarse = filum::surface::finer(base, edge).surface;
    } while (per_vertex * coarse.vertices.size() > most && coarse.vertices.size() > base.vertices.size());
    return at_points_of(sheet, std::move(coarse));
}

} // namespace filum::metrics::surface
