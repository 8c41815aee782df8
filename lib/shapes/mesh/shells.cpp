#include "geom/bvh.hpp"
#include "geom/disjoint_sets.hpp"
#include "mesh/bodies.hpp"
#include "mesh/formats.hpp"
#include "mesh/holes.hpp"
#include "mesh/place.hpp"
#include "mesh/sides.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace filum::mesh {

namespace {

constexpr std::size_t kWitnesses = 13; // points of a shell from which rays count the shells around it
constexpr double kSameSize = 0.01;     // fraction of a volume: shells closer in size may be copies of each other

// Sums over the triangles of a shell, or of all shells.
struct Sums {
    double volume = 0; // six times the volume, mm3, measured from the middle of the box
    Vec3 area;         // twice the sum of the area vectors; 0 if the shell is closed
    double size = 0;   // twice the area
    [[nodiscard]] bool nearly_closed() const { return norm(area) <= kOpenShare * size; }
};

struct Shell {
    Box3 box{};
    Sums sums;
    std::uint64_t unbalanced = 0;           // sum of the hashes of its triangles (see imbalance); 0: closed
    std::vector<std::uint32_t> witnesses{}; // triangles where the rays start
    bool turned = false;
    std::optional<std::uint32_t> holder{}; // the shell whose cavity it is
    std::size_t cavities = 0;              // number of cavities that it holds
};

void add(Sums& sums, const Mesh& mesh, const Triangle& t, const Vec3& origin) {
    const Vec3 a = mesh.vertices[t[0]] - origin, b = mesh.vertices[t[1]] - origin, c = mesh.vertices[t[2]] - origin;
    const Vec3 n = cross(b - a, c - a);
    sums.volume += dot(a, n);
    sums.area = sums.area + n;
    sums.size += norm(n);
}

std::vector<Shell> measure(const Mesh& mesh, const std::vector<std::uint32_t>& shell, std::size_t count) {
    std::vector<Shell> out(count);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) out[shell[v]].box.add(mesh.vertices[v]);
    std::vector<std::size_t> triangles(count, 0);
    for (const Triangle& t : mesh.triangles) ++triangles[shell[t[0]]];
    std::vector<std::size_t> seen(count, 0);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t i = shell[mesh.triangles[t][0]];
        Shell& s = out[i];
        add(s.sums, mesh, mesh.triangles[t], 0.5 * (s.box.lo + s.box.hi));
        s.unbalanced += imbalance(mesh.triangles[t]);
        if (seen[i]++ % std::max<std::size_t>(1, triangles[i] / kWitnesses) == 0 && s.witnesses.size() < kWitnesses)
            s.witnesses.push_back(t);
    }
    return out;
}

Note turned_note(std::size_t count, double volume6) {
    Note n = note(NoteCode::shell_turned, std::abs(volume6) / 6);
    n.count = count;
    return n;
}

void turn_round(Triangle& t) { std::swap(t[1], t[2]); }

// Turns every triangle if the whole mesh is inside out.
void face_whole_outwards(Mesh& mesh, std::vector<Shell>& shells, Notes& notes) {
    const Box3 box = bounds(mesh);
    Sums whole;
    if (shells.size() == 1)
        whole = shells[0].sums;
    else
        for (const Triangle& t : mesh.triangles) add(whole, mesh, t, 0.5 * (box.lo + box.hi));
    if (whole.volume >= 0 || !whole.nearly_closed()) return;
    for (Triangle& t : mesh.triangles) turn_round(t);
    for (Shell& s : shells) s.sums.volume = -s.sums.volume;
    notes.push_back(turned_note(shells.size(), whole.volume));
}

// Finds the shells around a point, by rays along the axes. Successive points of a shell use different directions, as a
// ray may leave through a hole.
class Surroundings {
  public:
    Surroundings(const Mesh& mesh, const std::vector<std::uint32_t>& shell)
        : mesh_(mesh), shell_(shell), tree_(boxes(mesh)) {}

    // The shells that contain most witnesses of shell `self`, in ascending order.
    [[nodiscard]] std::vector<std::uint32_t> of(std::uint32_t self, const Shell& s) const {
        std::vector<std::uint32_t> found, out;
        for (std::size_t w = 0; w < s.witnesses.size(); ++w) {
            const auto around = of_point(inner_point(mesh_.triangles[s.witnesses[w]]), self, static_cast<int>(w % 6));
            found.insert(found.end(), around.begin(), around.end());
        }
        std::sort(found.begin(), found.end());
        for (std::size_t i = 0, j = 0; i < found.size(); i = j) {
            while (j < found.size() && found[j] == found[i]) ++j;
            if (2 * (j - i) > s.witnesses.size()) out.push_back(found[i]);
        }
        return out;
    }

  private:
    static std::vector<Box3> boxes(const Mesh& mesh) {
        std::vector<Box3> out;
        out.reserve(mesh.triangles.size());
        for (const Triangle& t : mesh.triangles)
            out.push_back(geom::box_of(std::array{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}));
        return out;
    }
    [[nodiscard]] Vec3 inner_point(const Triangle& t) const { // not the centroid: many line up
        return 0.311 * mesh_.vertices[t[0]] + 0.373 * mesh_.vertices[t[1]] + 0.316 * mesh_.vertices[t[2]];
    }
    // Permutes the axes, so that the ray runs along z.
    static Vec3 seen(const Vec3& v, int direction) {
        const int axis = direction % 3;
        const Vec3 t = axis == 0 ? v : axis == 1 ? Vec3{v.y, v.z, v.x} : Vec3{v.z, v.x, v.y};
        return direction < 3 ? t : Vec3{t.y, t.x, -t.z};
    }
    [[nodiscard]] std::vector<std::uint32_t> of_point(const Vec3& p, std::uint32_t self, int direction) const {
        constexpr double kEndless = std::numeric_limits<double>::infinity();
        constexpr Vec3 kWays[] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}};
        Box3 ray{p, p};
        const auto stretch = [](double way, double& lo, double& hi) {
            if (way > 0) hi = kEndless;
            if (way < 0) lo = -kEndless;
        };
        stretch(kWays[direction].x, ray.lo.x, ray.hi.x);
        stretch(kWays[direction].y, ray.lo.y, ray.hi.y);
        stretch(kWays[direction].z, ray.lo.z, ray.hi.z);
        const Vec3 q = seen(p, direction);
        std::vector<std::pair<std::uint32_t, int>> hits; // a shell, and the direction in which the ray crosses it
        tree_.visit(ray, [&](std::uint32_t i) {
            const Triangle& t = mesh_.triangles[i];
            if (shell_[t[0]] == self) return;
            const Vec3 a = seen(mesh_.vertices[t[0]], direction), b = seen(mesh_.vertices[t[1]], direction),
                       c = seen(mesh_.vertices[t[2]], direction);
            const double u = geom::orient(q.xy(), b.xy(), c.xy()), v = geom::orient(q.xy(), c.xy(), a.xy()),
                         w = geom::orient(q.xy(), a.xy(), b.xy());
            if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) return;
            const double z = (u * a.z + v * b.z + w * c.z) / (u + v + w);
            if (z > q.z) hits.emplace_back(shell_[t[0]], u > 0 ? 1 : -1);
        });
        std::sort(hits.begin(), hits.end());
        std::vector<std::uint32_t> out;
        for (std::size_t i = 0, j = 0; i < hits.size(); i = j) {
            int winding = 0;
            for (; j < hits.size() && hits[j].first == hits[i].first; ++j) winding += hits[j].second;
            if (winding != 0) out.push_back(hits[i].first);
        }
        return out;
    }

    const Mesh& mesh_;
    const std::vector<std::uint32_t>& shell_;
    geom::Bvh tree_;
};

// Decides which shells are turned, which are cavities, and which shell each cavity belongs to.
class Cavities {
  public:
    Cavities(const Mesh& mesh, const std::vector<std::uint32_t>& shell, bool two_sided, double least_wall,
             std::vector<Shell>& shells)
        : mesh_(mesh), shell_(shell), two_sided_(two_sided), least_wall_(least_wall), shells_(shells) {}

    void find() {
        std::vector<std::uint32_t> order; // largest first, so that a shell comes before those inside it
        for (std::uint32_t i = 0; i < shells_.size(); ++i)
            if (shells_[i].sums.nearly_closed()) order.push_back(i);
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::abs(shells_[a].sums.volume) > std::abs(shells_[b].sums.volume);
        });
        for (const std::uint32_t i : order) settle(i);
    }

  private:
    // Decides shell i from the settled shells around it. If the shell around it is inside out, so is every shell
    // inside.
    void settle(std::uint32_t i) {
        Shell& s = shells_[i];
        const bool inwards = s.sums.volume < 0;
        if (!inwards && !two_sided_ && !any_turned_) return;
        std::vector<std::uint32_t> around = walled(i);
        int winding = 0; // winding number of the shells around, which are settled already
        for (const std::uint32_t h : around) winding += shells_[h].holder ? -1 : 1;
        const bool odd = around.size() % 2 == 1;
        std::erase_if(around, [&](std::uint32_t h) { return shells_[h].holder.has_value(); });
        if (two_sided_ ? odd : winding > 0) s.holder = holder(around, inwards);
        s.turned = s.holder.has_value() != inwards;
        any_turned_ = any_turned_ || s.turned;
    }

    // The smallest body around a shell that can hold it as a cavity. Copies of that body have the same size and may
    // have cavities of their own; the one with the fewest cavities wins.
    std::optional<std::uint32_t> holder(const std::vector<std::uint32_t>& around, bool inwards) {
        std::optional<std::uint32_t> best;
        for (const std::uint32_t h : around) {
            if (std::abs(shells_[h].sums.volume) > (1 + kSameSize) * std::abs(shells_[around.front()].sums.volume))
                break;
            if (!two_sided_ && inwards == shells_[h].turned) continue;
            if (!best || shells_[h].cavities < shells_[*best].cavities) best = h;
        }
        if (best) ++shells_[*best].cavities;
        return best;
    }

    // The shells around shell i that leave a wall between, smallest first.
    std::vector<std::uint32_t> walled(std::uint32_t i) {
        if (shells_.size() == 1) return {};
        if (!surroundings_) surroundings_.emplace(mesh_, shell_);
        std::vector<std::uint32_t> out = surroundings_->of(i, shells_[i]);
        const double size = std::abs(shells_[i].sums.volume);
        std::erase_if(out, [&](std::uint32_t h) {
            const Sums& o = shells_[h].sums;
            return !o.nearly_closed() || (std::abs(o.volume) - size) / 6 <= least_wall_ * o.size / 2;
        });
        std::stable_sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::abs(shells_[a].sums.volume) < std::abs(shells_[b].sums.volume);
        });
        return out;
    }

    const Mesh& mesh_;
    const std::vector<std::uint32_t>& shell_;
    bool two_sided_;
    double least_wall_;
    std::vector<Shell>& shells_;
    std::optional<Surroundings> surroundings_;
    bool any_turned_ = false;
};

// The outermost shell of the chain of holders that starts at shell i.
std::uint32_t body_of(const std::vector<Shell>& shells, std::uint32_t i) {
    while (shells[i].holder) i = *shells[i].holder;
    return i;
}

// Numbers the bodies and assigns each vertex to one.
Bodies bodies_of(const std::vector<Shell>& shells, const std::vector<std::uint32_t>& shell) {
    Bodies out;
    out.shells = shells.size();
    out.closed = std::all_of(shells.begin(), shells.end(), [](const Shell& s) { return s.unbalanced == 0; });
    std::vector<std::uint32_t> number(shells.size(), 0);
    if (out.closed)
        for (std::uint32_t i = 0; i < shells.size(); ++i)
            if (!shells[i].holder) {
                number[i] = static_cast<std::uint32_t>(out.hollow.size());
                out.hollow.push_back(0);
            }
    if (out.hollow.empty()) out.hollow.push_back(0);
    for (std::uint32_t i = 0; i < shells.size(); ++i) {
        if (!shells[i].holder) continue;
        if (out.closed) number[i] = number[body_of(shells, i)];
        out.hollow[number[i]] = 1;
    }
    out.of_vertex.reserve(shell.size());
    for (const std::uint32_t s : shell) out.of_vertex.push_back(number[s]);
    return out;
}

} // namespace

double volume(const Mesh& mesh) {
    Sums sums;
    if (!mesh.vertices.empty())
        for (const Triangle& t : mesh.triangles) add(sums, mesh, t, mesh.vertices.front());
    return sums.volume / 6;
}

Shells shells_of(const Mesh& mesh) {
    geom::DisjointSets sets(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles) {
        sets.unite(t[0], t[1]);
        sets.unite(t[0], t[2]);
    }
    Shells out;
    out.count = sets.number(out.of_vertex);
    return out;
}

Bodies face_outwards(Mesh& mesh, bool two_sided, double least_wall, Notes& notes) {
    const auto [shell, count] = shells_of(mesh);
    auto shells = measure(mesh, shell, count);
    if (!two_sided) face_whole_outwards(mesh, shells, notes);
    Cavities(mesh, shell, two_sided, least_wall, shells).find();
    std::size_t turned = 0;
    double volume = 0;
    for (const Shell& s : shells)
        if (s.turned) {
            ++turned;
            volume += std::abs(s.sums.volume);
        }
    if (turned > 0) {
        for (Triangle& t : mesh.triangles)
            if (shells[shell[t[0]]].turned) turn_round(t);
        if (!two_sided) notes.push_back(turned_note(turned, volume));
    }
    return bodies_of(shells, shell);
}

} // namespace filum::mesh
