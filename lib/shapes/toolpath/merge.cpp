#include "toolpath/merge.hpp"

#include "toolpath/reach.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::toolpath {

namespace {

constexpr double kLevel = 1e-9; // mm of z between points of a horizontal part
// number of attempts to keep only crossing parts as given, before the whole span is kept as given
constexpr int kUntangled = 3;

Line line_of(const Span& span) {
    Line out;
    double laid = 0;
    const auto add = [&](std::size_t i) {
        out.at.push_back(out.points.empty() ? 0 : out.at.back() + distance(out.points.back(), span.points[i]));
        out.points.push_back(span.points[i]);
        out.volume.push_back(laid);
        out.width.push_back(span.width.empty() ? 0 : span.width_at(i));
        out.height.push_back(span.height.empty() ? 0 : span.height_at(i));
        out.area.push_back(out.width.back() * out.height.back());
        out.source.push_back(static_cast<std::uint32_t>(i));
    };
    const auto drop = [&] {
        out.points.pop_back();
        out.at.pop_back();
        out.volume.pop_back();
        out.width.pop_back();
        out.height.pop_back();
        out.area.pop_back();
        out.source.pop_back();
    };
    const std::size_t n = span.points.size();
    out.points.reserve(n);
    for (auto* v : {&out.at, &out.volume, &out.width, &out.height, &out.area}) v->reserve(n);
    out.source.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0) laid += volume(span, i - 1);
        const bool near = i > 0 && distance(out.points.back(), span.points[i]) < kLeastMove;
        if (near && i + 1 < n) continue;
        if (near && out.size() > 1) drop(); // the last point stays
        add(i);
    }
    return out;
}

bool level(const Line& l, std::uint32_t i) { return std::abs(l.points[i + 1].z - l.points[i].z) <= kLevel; }

// The farthest point that a straight move in space reaches from point i; all points between are within the tolerance.
std::uint32_t spatial_reach(const Line& l, std::uint32_t i, std::uint32_t last, const Tolerance& t, double& off) {
    double worst = 0;
    const auto fits = [&](std::uint32_t to) {
        Section section(l, i, t.section);
        const Vec3 way = l.points[to] - l.points[i];
        const double length = norm(way);
        if (!(length > 0)) return false;
        const Vec3 u = (1 / length) * way;
        double reached = 0, here = 0;
        for (std::uint32_t k = i + 1; k <= to; ++k) {
            section.take(k);
            const Vec3 p = l.points[k] - l.points[i];
            const double s = dot(p, u), aside = norm(p - s * u);
            if (aside > t.path || s < reached) return false;
            reached = s;
            here = std::max(here, aside);
        }
        if (!section.suits() || l.at[to] - l.at[i] > (1 + t.section) * length) return false;
        worst = here;
        return true;
    };
    const std::uint32_t out = farthest(i + 1, last, fits);
    off = std::max(off, worst);
    return out;
}

// Moves, and for each the point of the line where it begins.
struct MoveSequence {
    std::vector<Move> moves;
    std::vector<std::uint32_t> begins;
    double off = 0;
    MergeSteps steps;
};

double mean(const Line& l, const std::vector<double>& values, std::uint32_t from, std::uint32_t to) {
    double sum = 0;
    for (std::uint32_t k = from; k < to; ++k) sum += l.step(k) * (values[k] + values[k + 1]) / 2;
    const double length = l.at[to] - l.at[from];
    return length > 0 ? sum / length : values[from];
}

void put(MoveSequence& out, const Line& l, std::uint32_t from, std::uint32_t to, const Arc& arc = {}) {
    Move m;
    m.to = l.points[to];
    m.centre = arc.centre;
    m.sweep = arc.sweep;
    m.length = arc.sweep != 0 ? std::abs(arc.sweep) * geom::distance(l.points[from].xy(), arc.centre)
                              : distance(l.points[from], m.to);
    m.volume = l.volume[to] - l.volume[from];
    m.width = mean(l, l.width, from, to);
    m.height = mean(l, l.height, from, to);
    m.first = l.source[from];
    out.moves.push_back(m);
    out.begins.push_back(from);
}

void level_moves(MoveSequence& out, const Line& l, std::uint32_t first, std::uint32_t last, const Tolerance& t) {
    for (std::uint32_t at = first; at < last;) {
        double off = 0, round = 0;
        std::uint32_t to = straight_reach(l, at, last, t, off);
        // an arc, if it saves a move: if two or more straight ones do not reach farther
        const Arc arc = t.arcs && to < last ? arc_reach(l, at, to, last, t, round) : Arc{at, {}, 0};
        const bool bent = arc.to > at;
        if (bent) to = arc.to;
        put(out, l, at, to, bent ? arc : Arc{});
        out.off = std::max(out.off, bent ? round : off);
        at = to;
    }
}

// Appends a move that is too short for a program to the one before it, or to the next.
void fold_short(MoveSequence& c) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < c.moves.size(); ++i) {
        const bool last = i + 1 == c.moves.size(), small = c.moves[i].length < kLeastMove && c.moves.size() > 1;
        if (!small || (n == 0 && last)) {
            c.moves[n] = c.moves[i];
            c.begins[n++] = c.begins[i];
        } else if (n == 0) {
            c.moves[i + 1].volume += c.moves[i].volume;
            c.moves[i + 1].first = c.moves[i].first;
            c.begins[i + 1] = c.begins[i];
        } else {
            c.moves[n - 1].volume += c.moves[i].volume;
            c.moves[n - 1].to = c.moves[i].to;
        }
    }
    c.moves.resize(n);
    c.begins.resize(n);
}

MergeSteps steps_of(const MoveSequence& c) {
    MergeSteps out{c.begins, {}, c.off};
    for (std::uint32_t i = 0; i < c.moves.size(); ++i)
        if (c.moves[i].sweep != 0) out.turns.push_back({i, c.moves[i].centre, c.moves[i].sweep});
    return out;
}

// `given`: segments of the line that must not change.
MoveSequence course(const Line& l, const Tolerance& t, const std::vector<std::uint8_t>& given) {
    MoveSequence out;
    const std::uint32_t n = l.size();
    for (std::uint32_t i = 0; i + 1 < n;) {
        std::uint32_t last = i + 1;
        const bool flat = level(l, i), kept = !(t.path > 0) || given[i] != 0;
        while (!kept && last + 1 < n && level(l, last) == flat && given[last] == 0) ++last;
        if (kept) {
            put(out, l, i, i + 1);
        } else if (flat) {
            level_moves(out, l, i, last, t);
        } else {
            for (std::uint32_t k = i, to = 0; k < last; k = to) {
                to = spatial_reach(l, k, last, t, out.off);
                put(out, l, k, to);
            }
        }
        i = last;
    }
    out.steps = steps_of(out);
    fold_short(out);
    return out;
}

} // namespace

MergeResult merge(const Span& span, const Tolerance& given, std::span<const geom::Segment> others) {
    Tolerance t = given;
    // the diagonal error of rounding
    t.path = fills(span.role) ? std::max(0.0, t.path - t.grid / std::numbers::sqrt2) : 0;
    const Line l = line_of(span);
    std::vector<std::uint8_t> as_given(l.size(), 0);
    MoveSequence c = course(l, t, as_given);
    for (int k = 0; t.path > 0 && k <= kUntangled; ++k) {
        auto all = tangles(l, c.moves, c.begins, others, t.grid);
        // if the line crosses there as given, only rounding is the cause
        std::erase_if(all, [&](const Tangle& x) {
            return std::find(as_given.begin() + x.first, as_given.begin() + x.last + 1, 0) ==
                   as_given.begin() + x.last + 1;
        });
        if (all.empty()) break;
        if (k == kUntangled) t.path = 0;
        for (const Tangle& x : all) std::fill(as_given.begin() + x.first, as_given.begin() + x.last + 1, 1);
        c = course(l, t, as_given);
    }
    return {std::move(c.moves), c.off, std::move(c.steps)};
}

MergeResult merge_again(const Span& span, const MergeSteps& steps) {
    const Line l = line_of(span);
    MoveSequence c;
    auto turn = steps.turns.begin();
    for (std::uint32_t i = 0; i < steps.begins.size(); ++i) {
        const std::uint32_t to = i + 1 < steps.begins.size() ? steps.begins[i + 1] : l.size() - 1;
        const bool bent = turn != steps.turns.end() && turn->step == i;
        put(c, l, steps.begins[i], to, bent ? Arc{to, turn->centre, turn->sweep} : Arc{});
        if (bent) ++turn;
    }
    fold_short(c);
    return {std::move(c.moves), steps.off, {}};
}

} // namespace filum::toolpath
