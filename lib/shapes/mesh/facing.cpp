#include "geom/bvh.hpp"
#include "mesh/formats.hpp"
#include "mesh/holes.hpp"
#include "mesh/sides.hpp"

namespace filum::mesh {

namespace {

constexpr double kTear = 0.25;      // largest gap to a torn-off neighbour, as a fraction of the side's length
constexpr double kFoldedBack = 0.9; // cosine: triangles on one side with a larger one are copies, not neighbours

// Per half-edge, its partner on an edge of exactly two triangles, and whether both run in the same direction.
struct Meeting {
    std::uint32_t side = kNoSide;
    bool same_way = false;
};
std::vector<Meeting> meetings(const Mesh& mesh) {
    const auto sides = half_edges(mesh);
    std::vector<Meeting> out(sides.size());
    each_edge(sides, [&](std::size_t i, std::size_t j) {
        if (j - i != 2) return;
        const bool same = sides[i].falls == sides[i + 1].falls;
        out[sides[i].side] = {sides[i + 1].side, same};
        out[sides[i + 1].side] = {sides[i].side, same};
    });
    return out;
}

// The rims of a torn mesh.
class Rims {
  public:
    Rims(const Mesh& mesh, const std::vector<Meeting>& meets)
        : mesh_(mesh), sides_(free_sides(meets)), tree_(boxes()) {}

    // Pairs sides that are each other's nearest, in either direction.
    void join(std::vector<Meeting>& meets) const {
        std::vector<Meeting> wish(sides_.size());
        for (std::size_t i = 0; i < sides_.size(); ++i) wish[i] = nearest(sides_[i]);
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            if (wish[i].side == kNoSide) continue;
            const std::uint32_t j = wish[i].side; // index in sides_
            if (wish[j].side == i) meets[sides_[i]] = {sides_[j], wish[i].same_way};
        }
    }

  private:
    static std::vector<std::uint32_t> free_sides(const std::vector<Meeting>& meets) {
        std::vector<std::uint32_t> out;
        for (std::uint32_t s = 0; s < meets.size(); ++s)
            if (meets[s].side == kNoSide) out.push_back(s);
        return out;
    }
    [[nodiscard]] Vec3 corner(std::uint32_t side, std::uint32_t k) const {
        return mesh_.vertices[mesh_.triangles[side / 3][(side + k) % 3]];
    }
    [[nodiscard]] Vec3 middle(std::uint32_t side) const { return 0.5 * (corner(side, 0) + corner(side, 1)); }
    [[nodiscard]] double reach(std::uint32_t side) const { return kTear * distance(corner(side, 0), corner(side, 1)); }
    [[nodiscard]] std::vector<geom::Box3> boxes() const {
        std::vector<geom::Box3> out;
        for (const std::uint32_t s : sides_) out.push_back({middle(s), middle(s)});
        return out;
    }
    // The unit vector from a side into its triangle.
    [[nodiscard]] Vec3 inwards(std::uint32_t side) const {
        const Vec3 a = corner(side, 0), d = corner(side, 1) - a, p = corner(side, 2) - a;
        const Vec3 u = dot(d, d) * p - dot(p, d) * d;
        return geom::unit(u, {});
    }
    [[nodiscard]] Meeting nearest(std::uint32_t s) const {
        const Vec3 a = corner(s, 0), b = corner(s, 1), m = middle(s), in = inwards(s);
        double best = reach(s);
        Meeting out;
        tree_.visit(geom::grown({m, m}, best), [&](std::uint32_t i) {
            const std::uint32_t t = sides_[i];
            if (t / 3 == s / 3 || dot(in, inwards(t)) > kFoldedBack) return;
            const Vec3 c = corner(t, 0), d = corner(t, 1);
            const double along = std::max(distance(a, c), distance(b, d)),
                         against = std::max(distance(a, d), distance(b, c));
            const double apart = std::min(along, against);
            if (apart < best || (apart == best && i < out.side)) {
                best = apart;
                out = {i, along < against};
            }
        });
        return out;
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> sides_;
    geom::Bvh tree_;
};

} // namespace

void face_one_way(Mesh& mesh, bool torn, Notes& notes) {
    if (is_closed(mesh)) return;
    auto meets = meetings(mesh);
    if (torn) Rims(mesh, meets).join(meets);
    std::vector<char> seen(mesh.triangles.size(), 0), turn(mesh.triangles.size(), 0);
    std::vector<std::uint32_t> patch;
    Note n = note(NoteCode::triangle_turned);
    n.count = 0;
    for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
        if (seen[first] != 0) continue;
        seen[first] = 1;
        patch.assign(1, first);
        double all = 0, turned = 0;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            const std::uint32_t t = patch[i];
            const double a = area(mesh, mesh.triangles[t]);
            all += a;
            if (turn[t] != 0) turned += a;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const Meeting& m = meets[3 * t + k];
                if (m.side == kNoSide || seen[m.side / 3] != 0) continue;
                seen[m.side / 3] = 1;
                turn[m.side / 3] = static_cast<char>((turn[t] != 0) != m.same_way);
                patch.push_back(m.side / 3);
            }
        }
        const char wrong = turned > all / 2 ? 0 : 1; // the mark of the part with the smaller area
        for (const std::uint32_t t : patch) {
            if (turn[t] != wrong) continue;
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
            ++n.count;
        }
        n.amount += std::min(turned, all - turned);
    }
    if (n.count > 0) notes.push_back(std::move(n));
}

} // namespace filum::mesh
