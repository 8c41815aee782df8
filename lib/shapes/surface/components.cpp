#include "surface/components.hpp"

namespace filum::surface {

std::vector<Component> components(const Sheet& whole) {
    const Surface& s = whole.surface;
    std::vector<Component> out(s.components);
    // Per vertex and triangle its number within its component; per component its vertices.
    std::vector<std::uint32_t> vertex(s.vertices.size()), triangle(s.triangles.size());
    std::vector<std::vector<std::uint32_t>> vertices(s.components);
    const auto of_vertex = [&](std::uint32_t v) { return s.component[s.outgoing[v] / 3]; };
    for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
        auto& to = vertices[of_vertex(v)];
        vertex[v] = static_cast<std::uint32_t>(to.size());
        to.push_back(v);
    }
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        auto& to = out[s.component[t]].triangles;
        triangle[t] = static_cast<std::uint32_t>(to.size());
        to.push_back(t);
    }
    for (std::uint32_t c = 0; c < s.components; ++c) {
        std::vector<Vec3> places;
        for (const std::uint32_t v : vertices[c]) places.push_back(s.vertices[v]);
        std::vector<Triangle> corners;
        std::vector<std::uint32_t> twin;
        for (const std::uint32_t t : out[c].triangles) {
            const Triangle& old = s.triangles[t];
            corners.push_back({vertex[old[0]], vertex[old[1]], vertex[old[2]]});
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
                twin.push_back(s.twin[h] == kNone ? kNone : 3 * triangle[s.twin[h] / 3] + s.twin[h] % 3);
        }
        out[c].sheet.surface = assemble(std::move(places), std::move(corners), std::move(twin));
        for (const Field& field : whole.fields) out[c].sheet.fields.push_back(picked(field, vertices[c]));
    }
    for (const std::uint32_t v : whole.sources.vertices) out[of_vertex(v)].sheet.sources.vertices.push_back(vertex[v]);
    for (const Segment& g : whole.sources.segments)
        out[s.component[g.triangle]].sheet.sources.segments.push_back({triangle[g.triangle], g.a, g.b});
    return out;
}

} // namespace filum::surface
