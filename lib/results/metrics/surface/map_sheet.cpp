#include "metrics/surface/map_sheet.hpp"

#include "surface/curve/transfer.hpp"
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

Sheet within_size(Sheet sheet, const Surface& base, std::size_t most) {
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
    Sheet out;
    out.fields = filum::surface::curve::transferred(sheet.surface, sheet.fields, coarse);
    out.surface = std::move(coarse);
    out.name = sheet.name;
    return out;
}

} // namespace filum::metrics::surface
