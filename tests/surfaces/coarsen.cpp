// Flat parts in as few triangles as their outlines allow, as CAD writes them: long and thin.
#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace filum::trials {

namespace {

constexpr double kFlat = 1e-9; // of unit normals
constexpr double kThin = 1e-7; // of the longest side: no triangle becomes lower

class Coarsener {
  public:
    explicit Coarsener(Mesh& mesh) : mesh_(mesh), at_(mesh.vertices.size()), gone_(mesh.triangles.size(), 0) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (const auto v : mesh.triangles[t]) at_[v].insert(t);
    }

    void run() {
        for (int round = 0; round < 3; ++round)
            for (std::uint32_t v = 0; v < at_.size(); ++v) remove(v);
        std::vector<mesh::Triangle> kept;
        for (std::uint32_t t = 0; t < gone_.size(); ++t)
            if (!gone_[t]) kept.push_back(mesh_.triangles[t]);
        mesh_.triangles = std::move(kept);
    }

  private:
    [[nodiscard]] Vec3 cross_of(const mesh::Triangle& t) const {
        const Vec3& a = mesh_.vertices[t[0]];
        return cross(mesh_.vertices[t[1]] - a, mesh_.vertices[t[2]] - a);
    }

    // Neighbours, and of a vertex on a rim the two along it.
    void neighbours(std::uint32_t v, std::set<std::uint32_t>& all, std::set<std::uint32_t>& once) const {
        for (const auto t : at_[v])
            for (const auto w : mesh_.triangles[t])
                if (w != v) {
                    all.insert(w);
                    if (!once.insert(w).second) once.erase(w);
                }
    }

    void remove(std::uint32_t v) {
        if (at_[v].size() < 2) return;
        const Vec3 first = cross_of(mesh_.triangles[*at_[v].begin()]), n = 1 / norm(first) * first;
        for (const auto t : at_[v]) {
            const Vec3 c = cross_of(mesh_.triangles[t]);
            if (dot(c, n) < (1 - kFlat) * norm(c)) return;
        }
        std::set<std::uint32_t> all, once;
        neighbours(v, all, once);
        if (once.size() > 2) return;
        if (!once.empty()) { // only where the rim is straight
            const Vec3 a = mesh_.vertices[*once.begin()] - mesh_.vertices[v],
                       b = mesh_.vertices[*once.rbegin()] - mesh_.vertices[v];
            if (norm(cross(a, b)) > kFlat * norm(a) * norm(b) || dot(a, b) > 0) return;
        }
        for (const auto to : once.empty() ? all : once)
            if (moves(v, to, n)) return;
    }

    // Draws the vertex into another one, if no triangle turns over or becomes too thin, and no edge doubles.
    bool moves(std::uint32_t v, std::uint32_t to, const Vec3& n) {
        std::set<std::uint32_t> mine, once, its, unused;
        neighbours(v, mine, once);
        neighbours(to, its, unused);
        std::size_t common = 0;
        for (const auto w : mine) common += its.count(w);
        if (common != (once.empty() ? 2U : 1U)) return false;
        for (const auto t : at_[v]) {
            mesh::Triangle now = mesh_.triangles[t];
            if (std::find(now.begin(), now.end(), to) != now.end()) continue;
            std::replace(now.begin(), now.end(), v, to);
            const Vec3 c = cross_of(now);
            double longest = 0;
            for (int k = 0; k < 3; ++k)
                longest = std::max(longest, distance(mesh_.vertices[now[static_cast<std::size_t>(k)]],
                                                     mesh_.vertices[now[static_cast<std::size_t>((k + 1) % 3)]]));
            if (dot(c, n) < kThin * longest * longest) return false;
        }
        for (const auto t : at_[v]) {
            auto& now = mesh_.triangles[t];
            if (std::find(now.begin(), now.end(), to) != now.end()) {
                gone_[t] = 1;
                for (const auto w : now)
                    if (w != v) at_[w].erase(t);
                continue;
            }
            std::replace(now.begin(), now.end(), v, to);
            at_[to].insert(t);
        }
        at_[v].clear();
        return true;
    }

    Mesh& mesh_;
    std::vector<std::set<std::uint32_t>> at_; // per vertex: its triangles
    std::vector<char> gone_;
};

} // namespace

void coarsen(Mesh& mesh) { Coarsener(mesh).run(); }

} // namespace filum::trials
