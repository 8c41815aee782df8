#include "mesh/seams.hpp"

#include "geom/bvh.hpp"
#include "geom/disjoint_sets.hpp"
#include "geom/segment.hpp"
#include "mesh/formats.hpp"
#include "mesh/holes.hpp"
#include "mesh/place.hpp"
#include "mesh/sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::mesh {

namespace {

constexpr double kAlong = 0.9;  // cosine: two sides with a larger one run in the same direction
constexpr double kCopies = 0.9; // cosine: triangles on one side with more similar directions are copies, not neighbours
constexpr int kSplittingRounds = 4; // a triangle has three sides; each round splits one of them
constexpr int kSamples = 4;         // points per side where the gap beside it is measured

// The sides with one triangle, and data of their ends.
class SeamRims {
  public:
    SeamRims(const Mesh& mesh, double most) : mesh_(mesh), most_(most) {
        const auto sides = half_edges(mesh);
        each_edge(sides, [&](std::size_t i, std::size_t j) {
            if (j - i == 1) sides_.push_back(sides[i].side);
        });
        std::sort(sides_.begin(), sides_.end());
        for (std::uint32_t i = 0; i < sides_.size(); ++i)
            for (const std::uint32_t v : {tail(i), head(i)}) ends_.emplace_back(v, i);
        std::sort(ends_.begin(), ends_.end());
        for (const auto& [v, i] : ends_)
            if (vertices_.empty() || vertices_.back() != v) vertices_.push_back(v);
        measure();
    }

    [[nodiscard]] std::size_t size() const { return sides_.size(); }
    [[nodiscard]] std::uint32_t half_edge(std::uint32_t i) const { return sides_[i]; }
    [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }
    [[nodiscard]] std::uint32_t tail(std::uint32_t i) const { return corner(i, 0); }
    [[nodiscard]] std::uint32_t head(std::uint32_t i) const { return corner(i, 1); }
    [[nodiscard]] std::uint32_t apex(std::uint32_t i) const { return corner(i, 2); }
    [[nodiscard]] const Vec3& at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }
    [[nodiscard]] double length(std::uint32_t i) const { return distance(at(tail(i)), at(head(i))); }
    // The largest distance from vertex k of vertices() to another rim that is joined to it, mm.
    [[nodiscard]] double reach(std::size_t k) const { return std::min(most_, kSeamOfSide * shortest_[k]); }

    // Calls visit(side) for the rim's sides at a vertex.
    template <class Visit>
    void each_side(std::uint32_t vertex, const Visit& visit) const {
        auto it = std::lower_bound(ends_.begin(), ends_.end(), std::pair{vertex, 0U});
        for (; it != ends_.end() && it->first == vertex; ++it) visit(it->second);
    }

    [[nodiscard]] Vec3 direction(std::uint32_t i) const { return geom::unit(at(head(i)) - at(tail(i)), {}); }
    // The unit vector from a side into its triangle.
    [[nodiscard]] Vec3 inwards(std::uint32_t i) const {
        const Vec3 d = direction(i), p = at(apex(i)) - at(tail(i));
        return geom::unit(p - dot(p, d) * d, {});
    }
    // True if two sides that lie beside each other may form a seam.
    [[nodiscard]] bool may_meet(std::uint32_t i, std::uint32_t j) const {
        return sides_[i] / 3 != sides_[j] / 3 && std::abs(dot(direction(i), direction(j))) > kAlong &&
               dot(inwards(i), inwards(j)) < kCopies;
    }
    // True if a seam may lead through both vertices: each has a side that runs in the same direction.
    [[nodiscard]] bool may_meet_at(std::uint32_t u, std::uint32_t v) const {
        bool out = false;
        each_side(u, [&](std::uint32_t i) {
            each_side(v, [&](std::uint32_t j) {
                const bool same_way = (tail(i) == u) == (tail(j) == v);
                const double along = dot(direction(i), direction(j));
                out = out || ((same_way ? along : -along) > 0 && may_meet(i, j));
            });
        });
        return out;
    }

  private:
    [[nodiscard]] std::uint32_t corner(std::uint32_t i, std::uint32_t k) const {
        return mesh_.triangles[sides_[i] / 3][(sides_[i] + k) % 3];
    }
    void measure() {
        std::vector<std::uint32_t> number(mesh_.vertices.size(), kNoSide);
        for (std::uint32_t k = 0; k < vertices_.size(); ++k) number[vertices_[k]] = k;
        shortest_.assign(vertices_.size(), std::numeric_limits<double>::infinity());
        for (const Triangle& t : mesh_.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                for (const std::uint32_t v : {t[k], t[(k + 1) % 3]})
                    if (number[v] != kNoSide)
                        shortest_[number[v]] = std::min(shortest_[number[v]], distance(at(t[k]), at(t[(k + 1) % 3])));
    }

    const Mesh& mesh_;
    double most_;
    std::vector<std::uint32_t> sides_;                          // half-edges
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_; // a vertex, and the index of a side that ends there
    std::vector<std::uint32_t> vertices_;                       // ascending
    std::vector<double> shortest_;                              // per vertex of vertices_: its shortest side, mm
};

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

// Merges vertices of rims that lie beside each other.
void weld_rims(Mesh& mesh, double most, Notes& notes) {
    const SeamRims rims(mesh, most);
    const auto& vertices = rims.vertices();
    std::vector<geom::Box3> boxes;
    boxes.reserve(vertices.size());
    for (const std::uint32_t v : vertices) boxes.push_back({mesh.vertices[v], mesh.vertices[v]});
    const geom::Bvh tree(boxes);
    geom::DisjointSets sets(vertices.size());
    for (std::uint32_t k = 0; k < vertices.size(); ++k)
        tree.visit(geom::grown(boxes[k], rims.reach(k)), [&](std::uint32_t j) {
            const double far = distance(mesh.vertices[vertices[j]], mesh.vertices[vertices[k]]);
            if (j > k && far <= std::min(rims.reach(j), rims.reach(k)) && rims.may_meet_at(vertices[k], vertices[j]))
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
    notes.push_back(std::move(n));
}

// A vertex that lies on a side.
struct OnSide {
    std::uint32_t side;
    double part; // position on the side, as a fraction from its tail
    std::uint32_t vertex;
};

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
    std::sort(out.begin(), out.end(), [](const OnSide& a, const OnSide& b) {
        return a.side != b.side ? a.side < b.side : a.part != b.part ? a.part < b.part : a.vertex < b.vertex;
    });
    return out;
}

// Splits triangles at vertices that lie on one of their sides.  Returns false if there are none.
bool split_sides(Mesh& mesh, double most, Note& n) {
    const auto places = vertices_on_sides(mesh, SeamRims(mesh, most));
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

// The length of side i that has another rim within kBead, in mm. Sides that share a vertex with side i do not count,
// and neither do rims on the inner side of its triangle.
double open_beside(const SeamRims& rims, const geom::Bvh& tree, std::uint32_t i) {
    const Vec3 &a = rims.at(rims.tail(i)), &b = rims.at(rims.head(i));
    const Vec3 in = rims.inwards(i);
    int beside = 0;
    for (int k = 0; k < kSamples; ++k) {
        const Vec3 p = between(a, b, (k + 0.5) / kSamples);
        bool found = false;
        tree.visit(geom::grown({p, p}, kBead), [&](std::uint32_t j) {
            if (found || !rims.may_meet(i, j)) return;
            for (const std::uint32_t v : {rims.tail(j), rims.head(j)})
                if (v == rims.tail(i) || v == rims.head(i)) return;
            const Vec3 &c = rims.at(rims.tail(j)), &d = rims.at(rims.head(j));
            const Vec3 gap = between(c, d, geom::nearest_parameter(c, d, p)) - p;
            found = norm(gap) <= kBead && dot(gap, in) < norm(gap) / 2;
        });
        beside += found ? 1 : 0;
    }
    return rims.length(i) * beside / kSamples;
}

void tell_open(const Mesh& mesh, double most, Notes& notes) {
    const SeamRims rims(mesh, most);
    std::vector<geom::Box3> boxes;
    for (std::uint32_t i = 0; i < rims.size(); ++i)
        boxes.push_back(geom::box_of(std::array{rims.at(rims.tail(i)), rims.at(rims.head(i))}));
    const geom::Bvh tree(boxes);
    Note n = empty_note(NoteCode::rim_near);
    for (std::uint32_t i = 0; i < rims.size(); ++i)
        if (const double length = open_beside(rims, tree, i); length > 0) add_case(n, rims.at(rims.tail(i)), length);
    if (n.count > 0) notes.push_back(std::move(n));
}

} // namespace

void join_seams(Mesh& mesh, Notes& notes) {
    if (is_closed(mesh)) return;
    const geom::Box3 box = bounds(mesh);
    const double most = kSeamOfBox * distance(box.lo, box.hi);
    weld_rims(mesh, most, notes);
    Note n = empty_note(NoteCode::rim_side_split);
    for (int round = 0; round < kSplittingRounds && split_sides(mesh, most, n); ++round) {
    }
    if (n.count > 0) notes.push_back(std::move(n));
    tell_open(mesh, most, notes);
}

} // namespace filum::mesh
