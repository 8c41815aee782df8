#include "surface/finer.hpp"

#include <algorithm>

namespace filum::surface {

namespace {

// The surface after a round. `whole[h]`: the half-edge before the round that is half-edge h now; kNone if h is new or
// a half.
struct Refinement {
    std::vector<mesh::Triangle> triangles;
    std::vector<std::uint32_t> parent, whole;
};

// Adds the middles of long sides as vertices; per half-edge its middle, kNone for sides that stay.
std::vector<std::uint32_t> middles(const Surface& s, double edge, std::vector<geom::Vec3>& vertices) {
    std::vector<std::uint32_t> out(s.twin.size(), kNone);
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        if (out[h] != kNone || side_length(s, h) <= edge) continue;
        out[h] = static_cast<std::uint32_t>(vertices.size());
        if (s.twin[h] != kNone) out[s.twin[h]] = out[h];
        vertices.push_back(0.5 * (s.vertices[s.tail(h)] + s.vertices[s.head(h)]));
    }
    return out;
}

// Appends the parts of triangle t, whose sides 3 t + k have the middles m[k].
void cut(const Surface& s, std::uint32_t t, const std::uint32_t* m, const std::vector<geom::Vec3>& v, Refinement& out) {
    const auto add = [&](mesh::Triangle corners, mesh::Triangle whole) {
        out.triangles.push_back(corners);
        out.whole.insert(out.whole.end(), whole.begin(), whole.end());
        out.parent.push_back(t);
    };
    const auto& c = s.triangles[t];
    const int cuts = (m[0] != kNone ? 1 : 0) + (m[1] != kNone ? 1 : 0) + (m[2] != kNone ? 1 : 0);
    if (cuts == 0) return add(c, {3 * t, 3 * t + 1, 3 * t + 2});
    if (cuts == 3) {
        for (std::uint32_t k = 0; k < 3; ++k) add({c[k], m[k], m[(k + 2) % 3]}, {kNone, kNone, kNone});
        return add({m[0], m[1], m[2]}, {kNone, kNone, kNone});
    }
    // Rotated such that side i is cut and, if two sides are, also the side before it.
    std::uint32_t i = 0;
    while (m[i] == kNone || (cuts == 2 && m[(i + 2) % 3] == kNone)) ++i;
    const std::uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (cuts == 1) {
        add({c[i], m[i], c[k]}, {kNone, kNone, 3 * t + k});
        return add({m[i], c[j], c[k]}, {kNone, 3 * t + j, kNone});
    }
    // Sides i and k are cut: a triangle at corner c[i], and the quadrilateral that remains, split along its shorter
    // diagonal.
    add({c[i], m[i], m[k]}, {kNone, kNone, kNone});
    if (distance(v[m[i]], v[c[k]]) <= distance(v[c[j]], v[m[k]])) {
        add({m[i], c[j], c[k]}, {kNone, 3 * t + j, kNone});
        add({m[i], c[k], m[k]}, {kNone, kNone, kNone});
    } else {
        add({m[i], c[j], m[k]}, {kNone, kNone, kNone});
        add({c[j], c[k], m[k]}, {3 * t + j, kNone, kNone});
    }
}

// Twins of the new half-edges. Whole sides keep theirs; the others are matched by their ends, since one of these is a
// new middle.
std::vector<std::uint32_t> join(const Surface& before, const Refinement& r) {
    std::vector<std::uint32_t> out(r.whole.size(), kNone), now(before.twin.size(), kNone), halves;
    for (std::uint32_t h = 0; h < r.whole.size(); ++h)
        if (r.whole[h] != kNone)
            now[r.whole[h]] = h;
        else
            halves.push_back(h);
    for (std::uint32_t h = 0; h < r.whole.size(); ++h)
        if (r.whole[h] != kNone && before.twin[r.whole[h]] != kNone) out[h] = now[before.twin[r.whole[h]]];
    const auto ends = [&](std::uint32_t h) {
        const auto a = r.triangles[h / 3][h % 3], b = r.triangles[h / 3][(h + 1) % 3];
        return std::pair{std::min(a, b), std::max(a, b)};
    };
    std::sort(halves.begin(), halves.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto ea = ends(a), eb = ends(b);
        return ea != eb ? ea < eb : a < b;
    });
    for (std::size_t i = 1; i < halves.size(); ++i)
        if (ends(halves[i - 1]) == ends(halves[i])) {
            out[halves[i - 1]] = halves[i];
            out[halves[i]] = halves[i - 1];
        }
    return out;
}

} // namespace

FinerSurface finer(const Surface& given, double edge, std::size_t most) {
    FinerSurface out{given, std::vector<std::uint32_t>(given.triangles.size())};
    for (std::uint32_t t = 0; t < out.parent.size(); ++t) out.parent[t] = t;
    for (;;) {
        const Surface& s = out.surface;
        auto vertices = s.vertices;
        const auto middle = middles(s, edge, vertices);
        if (vertices.size() == s.vertices.size()) return out;
        if (s.triangles.size() + 2 * (vertices.size() - s.vertices.size()) > most) return out;
        Refinement round;
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t) cut(s, t, &middle[3 * t], vertices, round);
        auto twin = join(s, round);
        for (auto& p : round.parent) p = out.parent[p];
        out = {assemble(std::move(vertices), std::move(round.triangles), std::move(twin)), std::move(round.parent)};
    }
}

} // namespace filum::surface
