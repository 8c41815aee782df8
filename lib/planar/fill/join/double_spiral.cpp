#include "fill/join/double_spiral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace filum::fill::join {

namespace {

// In bead widths, except where noted.
constexpr double kBend = std::numbers::pi / 3; // rad
// The least distance of links. The turning lanes turn this far behind the line, and the first bend leans back by as
// much behind the turn.
constexpr double kApart = 0.65;

struct Direction {
    Vec2 along, left; // unit
};

// The direction of the ring at s, from a chord one bead long; nullopt if the ring bends too much there.
std::optional<Direction> direction(const RingGraph& graph, std::uint32_t ring, double s, double width) {
    const double half = std::min(width / 2, graph.length(ring) / 8);
    const Vec2 chord = graph.at(ring, s + half) - graph.at(ring, s - half);
    const double l = geom::norm(chord);
    if (l < 1.9 * half) return std::nullopt;
    return Direction{(1 / l) * chord, (1 / l) * geom::left_of(chord)};
}

// The next lane on the line from `from`, inwards (side 1) or outwards (-1).
std::optional<Lanes::Lane> next_lane(const RingGraph& graph, const Lanes::Lane& from, double side, double width) {
    const double aslant = kBend / 2;
    const Vec2 d = side * (std::cos(aslant) * from.inward + std::sin(aslant) * from.forward);
    const double least = rings::kNarrowest * width, most = kNeighbourReach * width / std::cos(aslant);
    const auto hit = graph.first_hit(from.at.point, d, least, most, [](std::uint32_t) { return true; });
    if (!hit) return std::nullopt;
    const auto there = direction(graph, hit->ring, hit->s, width);
    if (!there) return std::nullopt;
    const double cosine = dot(there->along, from.forward), sense = cosine > 0 ? 1 : -1;
    if (std::abs(cosine) < std::cos(kBend)) return std::nullopt;
    const Vec2 inward = dot(there->left, from.inward) > 0 ? there->left : -1.0 * there->left;
    return Lanes::Lane{*hit, inward, sense * there->along, sense};
}

// Builds a double spiral from lanes lo_ .. hi_ - 1 of those given.
class DoubleSpiralBuilder {
  public:
    DoubleSpiralBuilder(const RingGraph& graph, const Lanes& lanes, double width, const Room& room)
        : graph_(&graph), lanes_(&lanes.lane), width_(width), room_(&room), hi_(lanes.lane.size()) {}

    std::optional<Splice> run(std::size_t own) {
        first_.resize(hi_);
        second_.resize(hi_);
        for (std::size_t k = 0; k < hi_; ++k) {
            first_[k] = (*lanes_)[k].at.s;
            second_[k] = beyond(k);
        }
        // lanes without room end the spiral; a turn without room moves to the next lane
        for (std::size_t k = own + 1; k-- > lo_;)
            if (!has_room(k)) lo_ = k + 1;
        for (std::size_t k = own; k < hi_; ++k)
            if (!has_room(k)) hi_ = k;
        for (std::size_t k = std::max(lo_, own) + 2; k < hi_; ++k)
            if (!bend_fits(k)) hi_ = k;
        for (std::size_t k = own + 2; k-- > lo_ + 2;)
            if (k < hi_ && !bend_fits(k)) lo_ = k - 1;
        for (; hi_ >= lo_ + 3; own < lo_ + (hi_ - lo_) / 2 ? --hi_ : ++lo_)
            if (auto splice = make()) return splice;
        return std::nullopt;
    }

  private:
    [[nodiscard]] const Lanes::Lane& lane(std::size_t k) const { return (*lanes_)[k]; }
    [[nodiscard]] double gap(std::size_t k) const { // from lane k to the next, across
        if (k + 1 >= lanes_->size()) return width_;
        return std::cos(kBend / 2) * geom::distance(lane(k).at.point, lane(k + 1).at.point);
    }
    // Where lane k + 2, bent at the line, reaches lane k.
    [[nodiscard]] double beyond(std::size_t k) const {
        return first_[k] + lane(k).sense * (gap(k) + gap(k + 1)) / std::sin(kBend);
    }
    [[nodiscard]] Vec2 begin(std::size_t k) const { return lane(k).at.point; }
    [[nodiscard]] Vec2 end(std::size_t k) const { return graph_->at(lane(k).at.ring, second_[k]); }

    [[nodiscard]] bool has_room(std::size_t k) const {
        return room_->free(lane(k).at.ring, std::min(first_[k], second_[k]), std::max(first_[k], second_[k]));
    }
    // Lane k as it bends over to lane k - 2.
    [[nodiscard]] geom::Segment bend(std::size_t k) const { return {begin(k), end(k - 2)}; }
    [[nodiscard]] bool bend_fits(std::size_t k) const {
        const auto b = bend(k);
        return clear(b, [&](const Place& at) {
            return at.ring == lane(k - 1).at.ring && within(at.s, k - 1, first_[k - 1], second_[k - 1]);
        });
    }
    // True if s lies between the places a and b of lane k.
    [[nodiscard]] bool within(double s, std::size_t k, double a, double b) const {
        const double l = graph_->length(lane(k).at.ring);
        const double ahead = std::fmod(lane(k).sense * (s - a), l);
        return (ahead < 0 ? ahead + l : ahead) < lane(k).sense * (b - a);
    }
    template <class Through>
    [[nodiscard]] bool clear(const geom::Segment& link, Through&& through) const {
        const Vec2 a = geom::lerp(link.a, link.b, kLinkEnd), b = geom::lerp(link.b, link.a, kLinkEnd);
        bool ok = true;
        graph_->each_crossing(a, b, [&](const Place& at) { ok = ok && through(at); });
        return ok && room_->clear(link.a, link.b);
    }

    // The place on lane `k` straight across from the place s on lane `from`.
    [[nodiscard]] std::optional<double> facing(std::size_t from, double s, std::size_t k) const {
        const Vec2 p = graph_->at(lane(from).at.ring, s), d = (k > from ? 1.0 : -1.0) * lane(from).inward;
        const auto hit = graph_->first_hit(p, d, 0, kNeighbourReach * width_,
                                           [&](std::uint32_t ring) { return ring == lane(k).at.ring; });
        if (!hit) return std::nullopt;
        return hit->s;
    }

    struct Turn {
        double outer, inner; // places on the two lanes
        geom::Segment link;
    };
    // The turn between lanes k and k + 1 at place s of lane `on`; nullopt if a ring or outline lies between.
    [[nodiscard]] std::optional<Turn> turn(std::size_t k, std::size_t on, double s) const {
        const auto other = facing(on, s, on == k ? k + 1 : k);
        if (!other) return std::nullopt;
        const double a = on == k ? s : *other, b = on == k ? *other : s;
        const Turn t{a, b, {graph_->at(lane(k).at.ring, a), graph_->at(lane(k + 1).at.ring, b)}};
        if (!clear(t.link, [](const Place&) { return false; })) return std::nullopt;
        return t;
    }

    // Makes the lanes that bend lean back into the room behind the turn, each less than the one before.
    void lean(std::vector<double>& first, std::vector<double>& second) const {
        const std::size_t bends = hi_ - lo_ - 2;
        const double most = kApart * width_ * std::min(1.0, static_cast<double>(bends) / 2);
        for (std::size_t i = 0; i < bends; ++i) {
            const double by = most * static_cast<double>(bends - i) / static_cast<double>(bends);
            second[lo_ + i] -= lane(lo_ + i).sense * by;
            first[hi_ - 1 - i] += lane(hi_ - 1 - i).sense * by;
        }
    }

    std::optional<Splice> make() const {
        const std::size_t last = hi_ - 1;
        const double past = kApart * width_;
        const auto out = turn(lo_, lo_, first_[lo_] + lane(lo_).sense * past);
        const auto in = turn(last - 1, last, second_[last] - lane(last).sense * past);
        if (!out || !in) return std::nullopt;
        auto first = first_, second = second_;
        lean(first, second);
        first[lo_] = out->outer;
        first[lo_ + 1] = out->inner;
        second[last - 1] = in->outer;
        second[last] = in->inner;
        const auto lines = with_rims(first, second);
        for (std::size_t k = 0; k + 1 < lines.size(); ++k)
            if (geom::segment_distance(lines[k][1], lines[k][2], lines[k + 1][1], lines[k + 1][2]) < kApart * width_)
                return std::nullopt;
        auto made = splice(first, second);
        for (std::size_t k = 1; made && k + 1 < lines.size(); ++k)
            made->links[k].bead = bead(lines[k - 1], lines[k], lines[k + 1]);
        return made;
    }

    using Line = std::array<Vec2, 4>;
    // Every link with a short stretch of the lanes that it joins, from the outer turn to the inner one.
    [[nodiscard]] std::vector<Line> with_rims(const std::vector<double>& first,
                                              const std::vector<double>& second) const {
        const auto at = [&](std::size_t k, const std::vector<double>& line, double on) {
            return graph_->at(lane(k).at.ring, line[k] + lane(k).sense * on * width_);
        };
        std::vector<Line> out{{at(lo_, first, -1), at(lo_, first, 0), at(lo_ + 1, first, 0), at(lo_ + 1, first, -1)}};
        for (std::size_t k = lo_ + 2; k < hi_; ++k)
            out.push_back({at(k, first, -1), at(k, first, 0), at(k - 2, second, 0), at(k - 2, second, 1)});
        out.push_back({at(hi_ - 2, second, 1), at(hi_ - 2, second, 0), at(hi_ - 1, second, 0), at(hi_ - 1, second, 1)});
        return out;
    }
    // The bead of a bend, as wide as its neighbours leave room for.
    [[nodiscard]] Curve bead(const Line& before, const Line& own, const Line& after) const {
        const auto gap = [&](const Line& other, Vec2 p) {
            double best = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i + 1 < other.size(); ++i)
                best = std::min(best, geom::point_segment_distance(other[i], other[i + 1], p));
            return best;
        };
        Curve out;
        for (const double t : {0.15, 0.5, 0.85}) {
            const Vec2 p = geom::lerp(own[1], own[2], t);
            out.add(p, (gap(before, p) + gap(after, p)) / 2);
        }
        return out;
    }

    [[nodiscard]] std::optional<Splice> splice(const std::vector<double>& first,
                                               const std::vector<double>& second) const {
        Splice out;
        const double most = 2 * (kNeighbourReach / std::sin(kBend) + kApart) * width_; // across two lanes, and leaning
        for (std::size_t k = lo_; k < hi_; ++k) {
            const std::uint32_t ring = lane(k).at.ring;
            const double l = graph_->length(ring);
            double gone = std::fmod(lane(k).sense * (second[k] - first[k]), l);
            if (gone < 0) gone += l;
            if (gone > most) return std::nullopt; // a turn found the ring elsewhere
            const double s0 = lane(k).sense > 0 ? first[k] : second[k];
            if (!room_->free(ring, s0, s0 + gone)) return std::nullopt;
            out.windows.push_back({ring, s0, s0 + gone});
        }
        const auto rim = [&](std::size_t k, bool behind) {
            return weave::End{static_cast<std::uint32_t>(k - lo_), behind == (lane(k).sense > 0)};
        };
        out.links.push_back({rim(lo_, false), rim(lo_ + 1, false), {}});
        for (std::size_t k = lo_ + 2; k < hi_; ++k) out.links.push_back({rim(k, false), rim(k - 2, true), {}});
        out.links.push_back({rim(hi_ - 2, true), rim(hi_ - 1, true), {}});
        return out;
    }

    const RingGraph* graph_;
    const std::vector<Lanes::Lane>* lanes_;
    double width_;
    const Room* room_;
    std::size_t lo_ = 0, hi_;
    std::vector<double> first_, second_; // per lane: places on the two lines
};

} // namespace

Lanes lanes_across(const RingGraph& graph, std::uint32_t ring, double s, bool ahead, double width,
                   const std::function<bool(std::uint32_t)>& use) {
    Lanes out;
    const auto here = direction(graph, ring, s, width);
    if (!here) return out;
    const double sense = ahead ? 1 : -1;
    out.lane = {{{ring, s, graph.at(ring, s), 0}, here->left, sense * here->along, sense}};
    for (const double side : {-1.0, 1.0}) {
        if (side > 0) {
            std::reverse(out.lane.begin(), out.lane.end());
            out.own = out.lane.size() - 1;
        }
        while (const auto next = next_lane(graph, out.lane.back(), side, width)) {
            if (!use(next->at.ring)) break;
            out.lane.push_back(*next);
        }
    }
    return out;
}

std::optional<Splice> double_spiral(const RingGraph& graph, const Lanes& lanes, double width, const Room& room) {
    if (lanes.lane.size() < 3) return std::nullopt;
    return DoubleSpiralBuilder(graph, lanes, width, room).run(lanes.own);
}

} // namespace filum::fill::join
