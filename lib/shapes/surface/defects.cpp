#include "surface/defects.hpp"

#include "mesh/sides.hpp"

#include <algorithm>

namespace filum::surface {

namespace {

constexpr double kFlat = 1e-9;       // height over longest side, below which a triangle has no area
constexpr int kSplittingRounds = 20; // rounds of splitting; each may leave new triangles without area

Vec3 cross_of(const mesh::Mesh& mesh, std::uint32_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
}

// The longest side, 0 to 2, of a triangle without area; 3 if it has an area.
std::uint32_t flat_side(const mesh::Mesh& mesh, std::uint32_t t) {
    double longest = -1;
    std::uint32_t side = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const double l = distance(mesh.vertices[mesh.triangles[t][k]], mesh.vertices[mesh.triangles[t][(k + 1) % 3]]);
        if (l > longest) {
            longest = l;
            side = k;
        }
    }
    return norm(cross_of(mesh, t)) <= kFlat * longest * longest ? side : 3;
}

bool degenerate(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Removes triangles that have become degenerate, with their CAD faces.
void erase_degenerate(mesh::Mesh& mesh) {
    if (!mesh.faces.empty()) {
        std::size_t kept = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (!degenerate(mesh.triangles[t])) mesh.faces[kept++] = mesh.faces[t];
        mesh.faces.resize(kept);
    }
    std::erase_if(mesh.triangles, degenerate);
}

// One round: splits the triangles across the longest sides of flat ones. Returns how many flat ones it removed.
std::size_t split_across_flat(mesh::Mesh& mesh) {
    std::vector<std::uint32_t> longest(mesh.triangles.size());
    std::size_t flat = 0;
    for (std::uint32_t t = 0; t < longest.size(); ++t) flat += (longest[t] = flat_side(mesh, t)) != 3 ? 1 : 0;
    if (flat == 0) return 0;
    std::vector<char> touched(longest.size(), 0);
    const auto sides = mesh::half_edges(mesh);
    std::vector<Triangle> more;
    std::vector<std::uint32_t> faces; // of the new triangles
    const auto split = [&](std::uint32_t h, std::uint32_t middle) {
        Triangle& t = mesh.triangles[h / 3];
        if (t[0] == middle || t[1] == middle || t[2] == middle) return; // the flat triangle lies on it: a fold
        Triangle other = t;
        other[h % 3] = middle;
        t[(h + 1) % 3] = middle;
        more.push_back(other);
        if (!mesh.faces.empty()) faces.push_back(mesh.faces[h / 3]);
    };
    std::size_t out = 0;
    mesh::each_edge(sides, [&](std::size_t i, std::size_t j) {
        for (std::size_t k = i; k < j; ++k) {
            const std::uint32_t t = sides[k].side / 3;
            if (longest[t] != sides[k].side % 3 || touched[t] != 0) continue;
            bool free = true; // a triangle is changed once per round at most
            for (std::size_t m = i; m < j; ++m) free = free && touched[sides[m].side / 3] == 0;
            if (!free) continue;
            const std::uint32_t middle = mesh.triangles[t][(sides[k].side % 3 + 2) % 3];
            for (std::size_t m = i; m < j; ++m) {
                touched[sides[m].side / 3] = 1;
                if (m != k) split(sides[m].side, middle);
            }
            mesh.triangles[t] = {};
            ++out;
        }
    });
    erase_degenerate(mesh);
    mesh.triangles.insert(mesh.triangles.end(), more.begin(), more.end());
    mesh.faces.insert(mesh.faces.end(), faces.begin(), faces.end());
    return out;
}

// How far two triangles at an edge are from being coplanar continuations: 0 flat, 2 folded back.
double fold(const mesh::Mesh& mesh, std::uint32_t s, std::uint32_t t) {
    const Vec3 m = cross_of(mesh, s), n = cross_of(mesh, t);
    return 1 - dot(m, n) / (norm(m) * norm(n));
}

} // namespace

void remove_copies(mesh::Mesh& mesh, Notes& notes) {
    struct Key {
        Triangle corners;
        std::uint32_t t;
    };
    std::vector<Key> keys;
    keys.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        keys.push_back({mesh.triangles[t], t});
        std::sort(keys.back().corners.begin(), keys.back().corners.end());
    }
    std::sort(keys.begin(), keys.end(),
              [](const Key& a, const Key& b) { return a.corners != b.corners ? a.corners < b.corners : a.t < b.t; });
    std::size_t copies = 0;
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (keys[i].corners == keys[i - 1].corners) {
            mesh.triangles[keys[i].t] = {};
            ++copies;
        }
    if (copies == 0) return;
    erase_degenerate(mesh);
    notes.push_back(note(NoteCode::triangle_copied, copies));
}

void remove_flat(mesh::Mesh& mesh, Notes& notes) {
    std::size_t out = 0;
    for (int round = 0; round < kSplittingRounds; ++round) {
        const std::size_t gone = split_across_flat(mesh);
        out += gone;
        if (gone == 0) break;
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (flat_side(mesh, t) != 3) {
            mesh.triangles[t] = {};
            ++out;
        }
    erase_degenerate(mesh);
    if (out > 0) notes.push_back(note(NoteCode::triangle_flat, out));
}

std::vector<std::uint32_t> join_sides(const mesh::Mesh& mesh, Notes& notes) {
    std::vector<std::uint32_t> twin(3 * mesh.triangles.size(), kNone);
    const auto sides = mesh::half_edges(mesh);
    std::size_t crowded = 0, one_sided = 0;
    const auto tail = [&](std::uint32_t h) { return mesh.triangles[h / 3][h % 3]; };
    mesh::each_edge(sides, [&](std::size_t i, std::size_t j) {
        if (j - i < 2) return;
        crowded += j - i > 2 ? 1 : 0;
        std::uint32_t a = kNone, b = kNone;
        double least = 3;
        for (std::size_t k = i; k < j; ++k)
            for (std::size_t m = k + 1; m < j; ++m) {
                if (tail(sides[k].side) == tail(sides[m].side)) continue; // they face in opposite directions
                const double f = j - i == 2 ? 0 : fold(mesh, sides[k].side / 3, sides[m].side / 3);
                if (f < least) {
                    least = f;
                    a = sides[k].side;
                    b = sides[m].side;
                }
            }
        if (a == kNone) {
            one_sided += j - i == 2 ? 1 : 0;
            return;
        }
        twin[a] = b;
        twin[b] = a;
    });
    if (crowded > 0) notes.push_back(note(NoteCode::edge_crowded, crowded));
    if (one_sided > 0) notes.push_back(note(NoteCode::edge_one_sided, one_sided));
    return twin;
}

void split_fans(mesh::Mesh& mesh, const std::vector<std::uint32_t>& twin, Notes& notes) {
    std::vector<std::uint32_t> fan(twin.size(), kNone); // the new vertex at the tail of each half-edge
    std::vector<char> used(mesh.vertices.size(), 0);
    const std::size_t before = mesh.vertices.size();
    for (std::uint32_t h = 0; h < twin.size(); ++h) {
        if (fan[h] != kNone) continue;
        std::uint32_t id = mesh.triangles[h / 3][h % 3];
        if (used[id] != 0) { // another fan has this vertex
            mesh.vertices.push_back(mesh.vertices[id]);
            id = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
        } else {
            used[id] = 1;
        }
        std::uint32_t e = h;
        for (; e != kNone && fan[e] == kNone; e = twin[prev(e)]) fan[e] = id; // counter-clockwise
        if (e != kNone) continue;                                             // a full turn
        for (e = twin[h]; e != kNone && fan[next(e)] == kNone; e = twin[next(e)]) fan[next(e)] = id;
    }
    const std::size_t split = mesh.vertices.size() - before;
    used.resize(mesh.vertices.size(), 1);
    std::vector<std::uint32_t> to(mesh.vertices.size(), kNone);
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < to.size(); ++v)
        if (used[v] != 0) mesh.vertices[to[v] = kept++] = mesh.vertices[v];
    mesh.vertices.resize(kept);
    for (std::uint32_t h = 0; h < twin.size(); ++h) mesh.triangles[h / 3][h % 3] = to[fan[h]];
    to.resize(before); // vertices of the file
    if (split > 0 || std::find(to.begin(), to.end(), kNone) != to.end()) mesh.renumber(to);
    if (split > 0) notes.push_back(note(NoteCode::vertex_split, split));
}

} // namespace filum::surface
