#include "mesh/seams.hpp"

#include "geom/bvh.hpp"
#include "geom/disjoint_sets.hpp"
#include "geom/segment.hpp"
#include "mesh/formats.hpp"
#include "mesh/holes.hpp"
#include "mesh/lenses.hpp"
#include "mesh/place.hpp"
#include "mesh/seam_rims.hpp"

#include <algorithm>

namespace filum::mesh {

namespace {

constexpr int kSplittingRounds = 4; // a triangle has three sides; each round splits one of them
constexpr int kSamples = 4;         // points per side where the gap beside it is measured

Vec3 between(const Vec3& a, const Vec3& b, double part) { return a + part * (b - a); }

Note empty_note(NoteCode code) {
    Note n = note(code);
    n.count = 0;
    return n;
}

void add_case(Note& n, const Vec3& where, double amount) {
    if (n.count++ == 0) {
        n.x = where.x;
        n.y = where.y;
        n.z = where.z;
    }
    n.amount += amount;
}

// Drops the triangles that have a corner twice.
void drop_empty_triangles(Mesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = mesh.triangles[i];
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        if (!mesh.faces.empty()) mesh.faces[kept] = mesh.faces[i];
        mesh.triangles[kept++] = t;
    }
    mesh.triangles.resize(kept);
    if (!mesh.faces.empty()) mesh.faces.resize(kept);
}

// Merges vertices of rims that lie beside each other.
void weld_rims(Mesh& mesh, double most, double same, Notes& notes) {
    const SeamRims rims(mesh, most, same);
    const auto& vertices = rims.vertices();
    std::vector<geom::Box3> boxes;
    boxes.reserve(vertices.size());
    for (const std::uint32_t v : vertices) boxes.push_back({mesh.vertices[v], mesh.vertices[v]});
    const geom::Bvh tree(boxes);
    geom::DisjointSets sets(vertices.size());
    for (std::uint32_t k = 0; k < vertices.size(); ++k)
        tree.visit(geom::grown(boxes[k], std::max(same, rims.reach(k))), [&](std::uint32_t j) {
            const double far = distance(mesh.vertices[vertices[j]], mesh.vertices[vertices[k]]);
            if (j > k && (far <= same || (far <= std::min(rims.reach(j), rims.reach(k)) &&
                                          rims.may_meet_at(vertices[k], vertices[j]))))
                sets.unite(k, j);
        });
    if (sets.sets() == vertices.size()) return;
    Note n = empty_note(NoteCode::rim_joined);
    std::vector<std::uint32_t> to(mesh.vertices.size());
    for (std::uint32_t v = 0; v < to.size(); ++v) to[v] = v;
    for (std::uint32_t k = 0; k < vertices.size(); ++k) {
        const std::uint32_t v = vertices[k], other = vertices[sets.root(k)];
        to[v] = other;
        if (v != other) add_case(n, mesh.vertices[other], distance(mesh.vertices[v], mesh.vertices[other]));
    }
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t) v = to[v];
    mesh.renumber(to);
    drop_empty_triangles(mesh);
    notes.push_back(std::move(n));
}

std::vector<OnSide> vertices_on_sides(const Mesh& mesh, const SeamRims& rims) {
    std::vector<OnSide> out;
    std::vector<geom::Box3> boxes;
    for (std::uint32_t i = 0; i < rims.size(); ++i)
        boxes.push_back(geom::box_of(std::array{mesh.vertices[rims.tail(i)], mesh.vertices[rims.head(i)]}));
    const geom::Bvh tree(boxes);
    for (std::size_t k = 0; k < rims.vertices().size(); ++k) {
        const std::uint32_t v = rims.vertices()[k];
        const Vec3& p = mesh.vertices[v];
        tree.visit(geom::grown({p, p}, rims.reach(k)), [&](std::uint32_t i) {
            if (rims.tail(i) == v || rims.head(i) == v || rims.apex(i) == v) return;
            const Vec3 &a = mesh.vertices[rims.tail(i)], &b = mesh.vertices[rims.head(i)];
            const double part = geom::nearest_parameter(a, b, p), length = distance(a, b);
            const double reach = std::min(rims.reach(k), kSeamOfSide * length);
            if (distance(between(a, b, part), p) > reach || part * length <= reach || (1 - part) * length <= reach)
                return;
            bool meets = false;
            rims.each_side(v, [&](std::uint32_t j) { meets = meets || rims.may_meet(i, j); });
            if (meets) out.push_back({rims.half_edge(i), part, v});
        });
    }
    return out;
}

// Splits triangles at vertices that lie on one of their sides.  Returns false if there are none.
bool split_sides(Mesh& mesh, std::vector<OnSide> places, Note& n) {
    std::sort(places.begin(), places.end(), [](const OnSide& a, const OnSide& b) {
        return a.side != b.side ? a.side < b.side : a.part != b.part ? a.part < b.part : a.vertex < b.vertex;
    });
    const std::size_t before = mesh.triangles.size();
    std::vector<char> changed(before, 0);
    for (std::size_t i = 0, j = 0; i < places.size(); i = j) {
        while (j < places.size() && places[j].side == places[i].side) ++j;
        const std::uint32_t t = places[i].side / 3, k = places[i].side % 3;
        if (changed[t] != 0) continue; // already split on another side in this round
        changed[t] = 1;
        const Triangle old = mesh.triangles[t];
        const std::uint32_t head = old[(k + 1) % 3], apex = old[(k + 2) % 3];
        mesh.triangles[t] = {old[k], places[i].vertex, apex};
        for (std::size_t m = i; m < j; ++m) {
            mesh.triangles.push_back({places[m].vertex, m + 1 < j ? places[m + 1].vertex : head, apex});
            if (!mesh.faces.empty()) mesh.faces.push_back(std::uint32_t(mesh.faces[t]));
            const Vec3 &a = mesh.vertices[old[k]], &b = mesh.vertices[head], &p = mesh.vertices[places[m].vertex];
            add_case(n, p, distance(between(a, b, places[m].part), p));
        }
    }
    return mesh.triangles.size() > before;
}

// The length of side i that has another rim within kBead, in mm. The side's own neighbours along its rim do not count,
// and neither do rims on the inner side of its triangle.
double open_beside(const SeamRims& rims, const PinchedVertices& pinched, const geom::Bvh& tree, std::uint32_t i) {
    const Vec3 &a = rims.at(rims.tail(i)), &b = rims.at(rims.head(i));
    const Vec3 in = rims.inwards(i);
    int beside = 0;
    for (int k = 0; k < kSamples; ++k) {
        const Vec3 p = between(a, b, (k + 0.5) / kSamples);
        bool found = false;
        tree.visit(geom::grown({p, p}, kBead), [&](std::uint32_t j) {
            if (found || !rims.may_meet(i, j)) return;
            for (const std::uint32_t v : {rims.tail(j), rims.head(j)})
                if ((v == rims.tail(i) || v == rims.head(i)) && !pinched.apart(v, i, j)) return;
            const Vec3 &c = rims.at(rims.tail(j)), &d = rims.at(rims.head(j));
            const Vec3 gap = between(c, d, geom::nearest_parameter(c, d, p)) - p;
            found = norm(gap) <= kBead && dot(gap, in) < norm(gap) / 2;
        });
        beside += found ? 1 : 0;
    }
    return rims.length(i) * beside / kSamples;
}

void tell_open(const Mesh& mesh, double most, double same, Notes& notes) {
    const SeamRims rims(mesh, most, same);
    const PinchedVertices pinched(mesh, rims);
    std::vector<geom::Box3> boxes;
    for (std::uint32_t i = 0; i < rims.size(); ++i)
        boxes.push_back(geom::box_of(std::array{rims.at(rims.tail(i)), rims.at(rims.head(i))}));
    const geom::Bvh tree(boxes);
    Note n = empty_note(NoteCode::rim_near);
    for (std::uint32_t i = 0; i < rims.size(); ++i)
        if (const double length = open_beside(rims, pinched, tree, i); length > 0)
            add_case(n, rims.at(rims.tail(i)), length);
    if (n.count > 0) notes.push_back(std::move(n));
}

} // namespace

void join_seams(Mesh& mesh, Notes& notes) {
    if (is_closed(mesh)) return;
    const geom::Box3 box = bounds(mesh);
    const double diagonal = distance(box.lo, box.hi), most = kSeamOfBox * diagonal, same = kSamePoint * diagonal;
    weld_rims(mesh, most, same, notes);
    Note n = empty_note(NoteCode::rim_side_split);
    const auto rounds = [&](const auto& search) {
        for (int round = 0; round < kSplittingRounds; ++round)
            if (!split_sides(mesh, search(mesh, SeamRims(mesh, most, same)), n)) return;
    };
    rounds(across_lenses); // first, as it takes the vertices of both rims in one order
    rounds(vertices_on_sides);
    rounds(across_lenses);
    if (n.count > 0) notes.push_back(std::move(n));
    tell_open(mesh, most, same, notes);
}

} // namespace filum::mesh
