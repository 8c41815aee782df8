#include "surfpath/rings/reach.hpp"

#include "base/error.hpp"
#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "geom/disjoint_sets.hpp"
#include "geom/point_grid.hpp"
#include "surface/finer.hpp"
#include "surfpath/plan/samples.hpp"
#include "surfpath/rings/rounding.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace filum::surfpath::rings {

namespace {

using surface::kNone;

// Angle defect of every vertex inside the surface, rad.
std::vector<double> defects(const Surface& s) {
    std::vector<double> out(s.vertices.size(), 0);
    for (std::uint32_t v = 0; v < out.size(); ++v) {
        if (s.on_rim(v)) continue;
        out[v] = 2 * std::numbers::pi;
        surface::each_outgoing(s, v, [&](std::uint32_t h) {
            const Vec3 a = s.vertices[s.head(h)] - s.vertices[v];
            const Vec3 b = s.vertices[s.tail(surface::prev(h))] - s.vertices[v];
            out[v] -= std::atan2(norm(cross(a, b)), dot(a, b));
        });
    }
    return out;
}

// Radius in mm of a circle of geodesic curvature 1 / radius on the sphere whose curvature is the greatest of the
// surface in any disc of that radius near a rim.
double on_ball(const Surface& s, std::span<const double> from_rim, double radius, double near) {
    const auto bent = defects(s);
    const geom::PointGrid<Vec3> grid(s.vertices, radius);
    double most = 0;
    for (std::uint32_t v = 0; v < bent.size(); ++v) {
        if (!(from_rim[v] <= near)) continue;
        double sum = 0;
        grid.near(s.vertices[v], 1, [&](std::uint32_t w) {
            if (distance(s.vertices[w], s.vertices[v]) <= radius) sum += bent[w];
        });
        most = std::max(most, sum);
    }
    const double x = std::sqrt(most / std::numbers::pi); // ratio of the disc's radius to that of the sphere
    return x > 0 ? radius * std::atan(x) / x : radius;
}

enum class Zone : std::uint8_t { margin, open, narrow }; // too near to a rim; within reach of discs; the rest

class RingBoundSolver {
  public:
    RingBoundSolver(const Surface& s, double spacing, double radius)
        : s_(s), half_(spacing / 2), edge_(surface::longest_edge(s)), slack_(edge_ / std::numbers::sqrt3),
          radius_(radius) {
        const auto from = geodesic::exact(s, surface::rim_sources(s), half_ + 2 * radius + 2 * edge_);
        unfolding_ = from.unfolding;
        radius_ = on_ball(s, from.distance, radius, half_ + 2 * radius);
        find_open(from);
        find_kinds(from.distance);
        find_dead();
        find_beside();
    }

    [[nodiscard]] RingBound run() const {
        RingBound out;
        std::vector<double> bare(sizes_.size(), 0);
        // first triangle of each that is out of reach as a whole
        std::vector<std::uint32_t> first(sizes_.size(), kNone);
        for (std::uint32_t t = 0; t < s_.triangles.size(); ++t) {
            const double area = surface::area(s_, t), in = covered(t, area);
            out.surface += area;
            out.reached += in;
            if (piece_[t] == kNone || dead_[piece_[t]] == 0) continue;
            bare[piece_[t]] += area - in;
            if (in == 0) first[piece_[t]] = std::min(first[piece_[t]], t);
        }
        for (std::uint32_t p = 0; p < bare.size(); ++p) {
            out.dead += first[p] != kNone ? 1 : 0;
            if (first[p] == kNone || !(bare[p] > out.largest)) continue;
            out.largest = bare[p];
            const auto& [a, b, c] = s_.triangles[first[p]];
            out.at = 1.0 / 3 * (s_.vertices[a] + s_.vertices[b] + s_.vertices[c]);
        }
        return out;
    }

  private:
    // Computes the distance from the places where centres of discs can be. Discs reach as far as their radius from
    // there.
    void find_open(const geodesic::ExactField& from) {
        const double level = half_ + radius_;
        const double levels[] = {level};
        const auto lines = geodesic::isolines(s_, from, levels);
        std::vector<const Isoline*> all;
        all.reserve(lines.size());
        for (const Isoline& l : lines) all.push_back(&l);
        if (all.empty())
            off_.distance.assign(s_.vertices.size(), std::numeric_limits<double>::infinity());
        else
            off_ = geodesic::exact(s_, as_sources(all), radius_ + std::max(half_, slack_) + 2 * edge_, from.unfolding,
                                   // places farther inside are not needed
                                   geodesic::triangles_beyond(s_, from.distance, level + edge_));
        field_ = !all.empty();
        inside_.resize(s_.vertices.size());
        for (std::size_t v = 0; v < inside_.size(); ++v) inside_[v] = from.distance[v] >= level ? 1 : 0;
    }
    [[nodiscard]] double off(std::uint32_t v) const { return inside_[v] != 0 ? 0 : off_.distance[v]; }

    void find_kinds(std::span<const double> from_rim) {
        for (const auto& corners : s_.triangles) {
            double least = std::numeric_limits<double>::infinity(), most = 0;
            for (const std::uint32_t v : corners) {
                least = std::min(least, off(v));
                most = std::max(most, from_rim[v]);
            }
            kind_.push_back(least <= radius_ + slack_ ? Zone::open
                            : most < half_ - slack_   ? Zone::margin
                                                      : Zone::narrow);
        }
        geom::DisjointSets sets(s_.triangles.size());
        for (std::uint32_t h = 0; h < s_.twin.size(); ++h)
            if (joined(h)) sets.unite(h / 3, s_.twin[h] / 3);
        std::vector<std::uint32_t> number(s_.triangles.size(), kNone);
        piece_.assign(s_.triangles.size(), kNone);
        for (std::uint32_t t = 0; t < s_.triangles.size(); ++t) {
            if (kind_[t] != Zone::narrow) continue;
            std::uint32_t& own = number[sets.root(t)];
            if (own == kNone) {
                own = static_cast<std::uint32_t>(sizes_.size());
                sizes_.push_back({});
            }
            piece_[t] = own;
        }
    }
    [[nodiscard]] bool joined(std::uint32_t h) const {
        return s_.twin[h] != kNone && kind_[h / 3] == Zone::narrow && kind_[s_.twin[h] / 3] == Zone::narrow;
    }

    // Finds dead ends: narrow pieces that are discs whose border is one loop with at most one stretch along open area
    // and at least one other stretch.
    void find_dead() {
        std::vector<std::set<std::uint32_t>> corners(sizes_.size());
        for (std::uint32_t t = 0; t < s_.triangles.size(); ++t) {
            if (piece_[t] == kNone) continue;
            ++sizes_[piece_[t]].euler;
            corners[piece_[t]].insert(s_.triangles[t].begin(), s_.triangles[t].end());
        }
        std::vector<char> seen(s_.twin.size(), 0);
        for (std::uint32_t h = 0; h < s_.twin.size(); ++h) {
            if (piece_[h / 3] == kNone) continue;
            Topology& own = sizes_[piece_[h / 3]];
            if (!joined(h) || h < s_.twin[h]) --own.euler;
            if (!joined(h) && seen[h] == 0) walk(h, seen, own);
        }
        for (std::size_t p = 0; p < sizes_.size(); ++p) {
            const Topology& own = sizes_[p];
            const long euler = own.euler + static_cast<long>(corners[p].size());
            dead_.push_back(own.loops == 1 && own.mouths <= 1 && own.closed && euler == 1 ? 1 : 0);
        }
    }
    struct Topology {
        long euler = 0; // triangles minus edges, then plus vertices
        int loops = 0, mouths = 0;
        bool closed = false; // part of the border is not along open area
    };
    // Follows the loop of the border that contains half-edge `first`.
    void walk(std::uint32_t first, std::vector<char>& seen, Topology& own) const {
        const auto opens = [&](std::uint32_t h) { return s_.twin[h] != kNone && kind_[s_.twin[h] / 3] == Zone::open; };
        ++own.loops;
        int mouths = 0;
        bool closed = false;
        for (std::uint32_t h = first; seen[h] == 0;) {
            seen[h] = 1;
            std::uint32_t to = surface::next(h);
            for (std::size_t step = 0; joined(to); to = surface::next(s_.twin[to]))
                if (++step > seen.size())
                    throw Error(Exit::failure, "internal error: a border of rings does not close");
            mouths += opens(to) && !opens(h) ? 1 : 0;
            closed |= !opens(h);
            h = to;
        }
        own.mouths += mouths;
        own.closed |= closed;
    }

    // Computes distances from narrow pieces that are not dead ends; there a line may be anywhere.
    void find_beside() {
        surface::Sources from;
        for (std::uint32_t t = 0; t < s_.triangles.size(); ++t)
            if (piece_[t] != kNone && dead_[piece_[t]] == 0)
                from.vertices.insert(from.vertices.end(), s_.triangles[t].begin(), s_.triangles[t].end());
        std::sort(from.vertices.begin(), from.vertices.end());
        from.vertices.erase(std::unique(from.vertices.begin(), from.vertices.end()), from.vertices.end());
        beside_.assign(s_.vertices.size(), std::numeric_limits<double>::infinity());
        if (!from.empty()) beside_ = geodesic::exact(s_, from, half_ + slack_ + edge_, unfolding_).distance;
    }

    // mm2 of a triangle that are within reach.
    [[nodiscard]] double covered(std::uint32_t t, double area) const {
        const double reach = radius_ + std::max(half_, slack_);
        double least = std::numeric_limits<double>::infinity(), most = 0;
        for (const std::uint32_t v : s_.triangles[t]) {
            if (beside_[v] <= half_ + slack_) return area;
            least = std::min(least, off(v));
            most = std::max(most, off(v));
        }
        if (most <= reach - edge_) return area;
        if (least > reach + edge_ || !field_) return 0;
        double in = 0;
        plan::each_sample(s_, t, 2 * half_ * rules::kFineGrain, [&](const plan::Sample& p) {
            if (geodesic::distance_at(s_, off_, t, p.p) <= reach) in += p.area;
        });
        return in;
    }

    const Surface& s_;
    // mm: half a spacing; the longest edge; a place of a triangle is at most slack_ from its nearest corner
    double half_, edge_, slack_, radius_;
    std::shared_ptr<const geodesic::Unfolding> unfolding_;
    geodesic::ExactField off_;         // distance from the border of the area where centres of discs can be
    bool field_ = false;               // whether there is such a border
    std::vector<char> inside_;         // per vertex: inside that area
    std::vector<Zone> kind_;           // per triangle
    std::vector<std::uint32_t> piece_; // per triangle: number of its narrow piece
    std::vector<Topology> sizes_;      // per piece
    std::vector<char> dead_;
    std::vector<double> beside_; // per vertex
};

} // namespace

RingBound ring_bound(const Surface& s, double spacing, double radius) {
    if (s.rims.empty() || !(radius > 0)) {
        const double all = surface::area(s);
        return {all, all, 0, 0, {}};
    }
    // Triangles are classified as a whole. If their sides are longer than half a spacing, the bound is only weaker.
    const auto fine = surface::finer(s, spacing / 2, std::max(rules::kMostPieces, s.triangles.size()));
    return RingBoundSolver(fine.surface, spacing, radius).run();
}

void report_ring_bound(const RingBound& r, plan::Plan& plan) {
    plan.facts.push_back({"", "rings-bound", r.share(), ""});
    if (!(r.surface - r.reached > rules::kNegligible * r.surface)) return;
    Note out{NoteCode::area_out_of_rings, r.surface - r.reached};
    if (r.dead > 0) { // otherwise all of it is out of reach, and no place is special
        out.count = r.dead;
        out.x = r.at.x;
        out.y = r.at.y;
        out.z = r.at.z;
    }
    plan.notes.push_back(out);
}

} // namespace filum::surfpath::rings
