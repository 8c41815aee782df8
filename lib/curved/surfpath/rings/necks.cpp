#include "surfpath/rings/necks.hpp"

#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>

namespace filum::surfpath::rings {

namespace {

constexpr double kBridgeDrift = 8; // spacings of length over which the line changes from the ring to the bridge

struct Tip {
    std::size_t bend;
    double way; // arc length of its sharpest point
    Place place;
};

struct Neck {
    double length, height;
    std::size_t a, b; // tips
};

class NeckFinder {
  public:
    NeckFinder(const Surface& s, const geodesic::ExactField& field, double level, double spacing,
               const std::vector<Ring>& rings, std::vector<RoundedCorner>& bends)
        : surface_(s), field_(field), level_(level), spacing_(spacing), rings_(rings), tree_(rings), bends_(bends) {}

    void run() {
        find_tips();
        std::vector<Neck> necks;
        for (std::size_t a = 0; a < tips_.size(); ++a)
            for (std::size_t b = a + 1; b < tips_.size(); ++b) look_across(a, b, necks);
        std::sort(necks.begin(), necks.end(), [](const Neck& x, const Neck& y) {
            return std::tie(x.length, x.a, x.b) < std::tie(y.length, y.a, y.b);
        });
        for (const Neck& n : necks)
            if (!bends_[tips_[n.a].bend].bridged_to && !bends_[tips_[n.b].bend].bridged_to) bridge(n);
    }

  private:
    [[nodiscard]] const Ring& ring(const Tip& t) const { return rings_[bends_[t.bend].ring]; }
    [[nodiscard]] const Corner& corner(const Tip& t) const { return *bends_[t.bend].corner; }
    [[nodiscard]] Place at(const Tip& t, double way) const {
        return surface::curve::at(ring(t).line, ring(t).ways, way);
    }

    void find_tips() {
        for (std::size_t i = 0; i < bends_.size(); ++i) {
            Tip t{i, 0, {}};
            const Corner& c = corner(t);
            const double all = ring(t).ahead(c.from, c.to), half = 0.4 * spacing_;
            double most = -1;
            for (double on = half; on < all - half; on += 0.2 * spacing_) {
                const Vec3 p = at(t, c.from + on).point;
                const Vec3 a = p - at(t, c.from + on - half).point, b = at(t, c.from + on + half).point - p;
                const double turn = -dot(a, b) / (norm(a) * norm(b));
                if (turn > most) {
                    most = turn;
                    t.way = c.from + on;
                }
            }
            t.place = at(t, t.way);
            tips_.push_back(t);
        }
    }

    // Adds the neck between two tips, if there is one.
    void look_across(std::size_t a, std::size_t b, std::vector<Neck>& necks) const {
        const Place &from = tips_[a].place, &to = tips_[b].place;
        const double length = distance(from.point, to.point);
        if (length < 0.1 * spacing_) return;
        const Line line = surface::curve::join(surface_, from, to);
        if (line.size() == 2 && from.triangle != to.triangle) return;
        const auto ways = surface::curve::arc_lengths(line);
        if (tree_.nearest(surface::curve::at(line, ways, length / 2).point).distance < 0.3 * length)
            return; // the way leads along a ring
        double height = level_;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            const double h = geodesic::distance_at(surface_, field_, line.places[i].triangle, line[i]);
            if (h > level_ + 0.02 * spacing_) return; // the way leads through the inside of a ring
            height = std::min(height, h);
        }
        // two bridges are less than a spacing too near to each other, or they are farther than lines may be moved
        if (height < level_ - (0.5 + rules::kGive) * spacing_) return;
        necks.push_back({length, height, a, b});
    }

    void bridge(const Neck& n) {
        const double levels[] = {std::max(0.3 * spacing_, n.height - rules::kGive * spacing_)};
        std::vector<Ring> lower;
        for (const auto& line : geodesic::isolines(surface_, field_, levels))
            if (line.closed) lower.push_back({surface::curve::line(line), {}, {}});
        if (lower.empty()) return;
        for (Ring& r : lower) r.ways = surface::curve::arc_lengths(r.line);
        const RingTree tree(lower);
        const auto there = across(tips_[n.a], tips_[n.b], lower, tree),
                   back = across(tips_[n.b], tips_[n.a], lower, tree);
        if (there.size() < 2 || back.size() < 2) return;
        RoundedCorner &a = bends_[tips_[n.a].bend], &b = bends_[tips_[n.b].bend];
        a.bridged_to = &b;
        a.bridge = there;
        b.bridged_to = &a;
        b.bridge = back;
    }

    // The line from the start of corner `a` to the end of corner `b` along one of the `lower` rings; empty if no ring
    // leads there.
    [[nodiscard]] Line across(const Tip& a, const Tip& b, const std::vector<Ring>& lower, const RingTree& tree) const {
        const Corner &ca = corner(a), &cb = corner(b);
        const double la = std::min(kBridgeDrift * spacing_, 0.9 * ring(a).ahead(ca.from, a.way));
        const double lb = std::min(kBridgeDrift * spacing_, 0.9 * ring(b).ahead(b.way, cb.to));
        const RingPosition from = tree.nearest(at(a, ca.from + la).point), to = tree.nearest(at(b, cb.to - lb).point);
        if (from.line != to.line || std::max(from.distance, to.distance) > 1.5 * spacing_) return {};
        const Ring& low = lower[from.line];
        const double way = low.ahead(from.way, to.way);
        Line out = drift(a, ca.from, la, lower, tree, true);
        surface::curve::append(out, surface::curve::part(low.line, low.ways, from.way, from.way + way));
        surface::curve::append(out, drift(b, cb.to - lb, lb, lower, tree, false));
        return out;
    }

    // The line along the ring that gradually changes over to the lower ring, or back.
    [[nodiscard]] Line drift(const Tip& t, double way, double length, const std::vector<Ring>& lower,
                             const RingTree& tree, bool down) const {
        Line out;
        const int n = std::max(4, static_cast<int>(std::ceil(length / (0.3 * spacing_))));
        for (int i = 0; i <= n; ++i) {
            const double f = static_cast<double>(i) / n, g = down ? f : 1 - f;
            const Place from = at(t, way + f * length);
            const RingPosition on = tree.nearest(from.point);
            const Line line = surface::curve::join(
                surface_, from, surface::curve::at(lower[on.line].line, lower[on.line].ways, on.way));
            const auto ways = surface::curve::arc_lengths(line);
            out.places.push_back(surface::curve::at(line, ways, rules::shifted(g) * ways.back()));
        }
        return surface::curve::threaded(surface_, out);
    }

    const Surface& surface_;
    const geodesic::ExactField& field_;
    double level_, spacing_;
    const std::vector<Ring>& rings_;
    RingTree tree_;
    std::vector<RoundedCorner>& bends_;
    std::vector<Tip> tips_;
};

} // namespace

void bridge_necks(const Surface& s, const geodesic::ExactField& field, double level, double spacing,
                  const std::vector<Ring>& rings, std::vector<RoundedCorner>& bends) {
    NeckFinder(s, field, level, spacing, rings, bends).run();
}

} // namespace filum::surfpath::rings
