#include "slice/open_contours.hpp"

#include "geom/point_grid.hpp"
#include "geom/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace filum::slice {

namespace {

// Ends are numbered: 2c is the start of contour c, and 2c + 1 its end.
constexpr std::uint32_t kFree = ~std::uint32_t{0};
constexpr double kSeam = 2e-4; // mm: two steps of the grid; smaller gaps are rounding

// Per end, the end that it is joined to, or kFree.
using Mates = std::vector<std::uint32_t>;

bool is_start(std::uint32_t end) { return end % 2 == 0; }
Vec2 place(const std::vector<OpenContour>& contours, std::uint32_t end) {
    const auto& p = contours[end / 2].points;
    return is_start(end) ? p.front() : p.back();
}

void mate(Mates& mates, std::uint32_t a, std::uint32_t b) {
    mates[a] = b;
    mates[b] = a;
}

Mates mates_on_edges(const std::vector<OpenContour>& contours) {
    Mates mates(2 * contours.size(), kFree);
    std::vector<std::uint32_t> ends(mates.size());
    std::iota(ends.begin(), ends.end(), 0U);
    const auto key = [&](std::uint32_t e) { return is_start(e) ? contours[e / 2].head : contours[e / 2].tail; };
    std::sort(ends.begin(), ends.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (key(ends[i]) == key(ends[i + 1])) {
            mate(mates, ends[i], ends[i + 1]);
            ++i;
        }
    return mates;
}

// A grid of the free ends, to look up near ones.
class FreeEnds {
  public:
    FreeEnds(const std::vector<OpenContour>& contours, const Mates& mates, double size) {
        std::vector<Vec2> at;
        for (std::uint32_t e = 0; e < mates.size(); ++e)
            if (mates[e] == kFree) {
                end_.push_back(e);
                at.push_back(place(contours, e));
            }
        grid_ = geom::PointGrid<Vec2>(at, size);
    }
    // Calls visit(end) for every free end within `size` of p, and maybe for some farther ones.
    template <class Visit>
    void around(Vec2 p, const Visit& visit) const {
        grid_.near(p, 1, [&](std::uint32_t i) { visit(end_[i]); });
    }

  private:
    std::vector<std::uint32_t> end_;
    geom::PointGrid<Vec2> grid_;
};

struct Candidate {
    double distance;
    std::uint32_t a, b;
    friend bool operator<(const Candidate& l, const Candidate& r) {
        return std::tie(l.distance, l.a, l.b) < std::tie(r.distance, r.a, r.b);
    }
};

// Every free end proposes its nearest partner.  Pairs are joined in order of distance.  True if any was joined.
template <class Partner>
bool pair_round(Mates& mates, const Partner& partner) {
    std::vector<Candidate> wishes;
    for (std::uint32_t e = 0; e < mates.size(); ++e) {
        if (mates[e] != kFree) continue;
        const Candidate c = partner(e);
        if (c.b != kFree) wishes.push_back({c.distance, std::min(e, c.b), std::max(e, c.b)});
    }
    std::sort(wishes.begin(), wishes.end());
    bool any = false;
    for (const Candidate& c : wishes)
        if (mates[c.a] == kFree && mates[c.b] == kFree) {
            mate(mates, c.a, c.b);
            any = true;
        }
    return any;
}

constexpr int kRounds = 32; // each round joins at least the nearest pair, in practice most pairs

// The point of a contour `along` mm from `end`, or its other end if it is shorter.
Vec2 point_along(const std::vector<OpenContour>& contours, std::uint32_t end, double along) {
    const auto& p = contours[end / 2].points;
    const auto at = [&](std::size_t i) { return is_start(end) ? p[i] : p[p.size() - 1 - i]; };
    for (std::size_t i = 1; i < p.size(); ++i) {
        const double step = geom::distance(at(i - 1), at(i));
        if (step >= along && step > 0) return geom::lerp(at(i - 1), at(i), along / step);
        along -= step;
    }
    return at(p.size() - 1);
}

// True if the contours of two ends, `gap` mm apart, leave them in the same direction. Then they are copies, and neither
// continues the other.
bool leave_alike(const std::vector<OpenContour>& contours, std::uint32_t e, std::uint32_t f, double gap) {
    if (e / 2 == f / 2) return false;
    constexpr double kApart = 0.5; // largest distance between copies, per length along them: an angle of 29 degrees
    const double way = std::min(length(contours[e / 2]), length(contours[f / 2])) / 2;
    return geom::distance(point_along(contours, e, way), point_along(contours, f, way)) <= gap + kApart * way;
}

// Joins ends at most `radius` apart.  `directed`: joins only an end to a start.
void marry_near(const std::vector<OpenContour>& contours, double radius, bool directed, Mates& mates) {
    for (int round = 0; round < kRounds; ++round) {
        const FreeEnds ends(contours, mates, radius);
        const bool any = pair_round(mates, [&](std::uint32_t e) {
            Candidate best{radius, e, kFree};
            ends.around(place(contours, e), [&](std::uint32_t f) {
                if (f == e || mates[f] != kFree || (directed && is_start(e) == is_start(f))) return;
                const double d = geom::distance(place(contours, e), place(contours, f));
                if (d > best.distance || (d == best.distance && f >= best.b)) return;
                if (is_start(e) != is_start(f) || !leave_alike(contours, e, f, d)) best = {d, e, f};
            });
            return best;
        });
        if (!any) return;
    }
}

// Joins wide openings, an end to a start, if the line is at most `share` of the length that it joins.
void marry_far(const std::vector<OpenContour>& contours, double share, Mates& mates) {
    std::vector<double> size;
    for (const OpenContour& c : contours) size.push_back(length(c));
    const bool alone = contours.size() > 2000; // with so many pieces, only the two ends of one contour are joined
    for (int round = 0; round < kRounds; ++round) {
        const bool any = pair_round(mates, [&](std::uint32_t e) {
            Candidate best{std::numeric_limits<double>::infinity(), e, kFree};
            const std::uint32_t first = alone ? e & ~1U : 0;
            const auto last = alone ? (e | 1U) + 1 : static_cast<std::uint32_t>(mates.size());
            for (std::uint32_t f = first; f < last; ++f) {
                if (mates[f] != kFree || is_start(e) == is_start(f)) continue;
                const double d = geom::distance(place(contours, e), place(contours, f));
                const double joined = size[e / 2] + (f / 2 == e / 2 ? 0 : size[f / 2]);
                if (d < best.distance && d <= share * joined) best = {d, e, f};
            }
            return best;
        });
        if (!any) return;
    }
}

void append(std::vector<Vec2>& to, const Vec2& p) {
    if (to.empty() || !(to.back() == p)) to.push_back(p);
}

// Walks from `end` along its contour and all that are joined to it.  Marks the passed contours as done.
OpenContour walk(const std::vector<OpenContour>& contours, const Mates& mates, std::uint32_t end,
                 std::vector<char>& done, bool& closed) {
    OpenContour out;
    double along = 0, against = 0;
    const std::uint32_t from = end;
    out.head = is_start(end) ? contours[end / 2].head : contours[end / 2].tail;
    for (;;) {
        const OpenContour& c = contours[end / 2];
        done[end / 2] = 1;
        out.lid += c.lid;
        out.jumped += c.jumped;
        const double l = length(c);
        if (is_start(end)) {
            for (const Vec2 p : c.points) append(out.points, p);
            along += l - c.turned;
            against += c.turned;
        } else {
            for (std::size_t i = c.points.size(); i-- > 0;) append(out.points, c.points[i]);
            along += c.turned;
            against += l - c.turned;
        }
        const std::uint32_t other = end ^ 1U;
        out.tail = is_start(other) ? c.head : c.tail;
        end = mates[other];
        if (end != kFree)
            if (const double gap = geom::distance(place(contours, other), place(contours, end)); gap > kSeam)
                out.jumped += gap;
        closed = end == from;
        if (closed || end == kFree) break;
    }
    out.turned = std::min(along, against);
    if (against > along) {
        std::reverse(out.points.begin(), out.points.end());
        std::swap(out.head, out.tail);
    }
    return out;
}

// Joins contours as `mates` says. Adds closed ones to `out` and returns the others. Adds to `lid` the length over lids,
// mm.
std::vector<OpenContour> join(const std::vector<OpenContour>& contours, const Mates& mates, ClosedContours& out,
                              double& lid) {
    std::vector<OpenContour> open;
    std::vector<char> done(contours.size(), 0);
    const auto take = [&](std::uint32_t end) {
        bool closed = false;
        OpenContour c = walk(contours, mates, end, done, closed);
        if (!closed) {
            open.push_back(std::move(c));
            return;
        }
        if (c.points.size() > 1 && c.points.front() == c.points.back()) c.points.pop_back();
        out.turned += c.turned;
        lid += c.lid;
        if (c.points.size() > 2) (c.lid + c.jumped > 0 ? out.guessed : out.whole).add(c.points);
    };
    for (std::uint32_t e = 0; e < mates.size(); ++e) // first from free ends, then round the circles that remain
        if (mates[e] == kFree && done[e / 2] == 0) take(e);
    for (std::uint32_t c = 0; c < contours.size(); ++c)
        if (done[c] == 0) take(2 * c);
    return open;
}

// Adds one note for all joints of `mates` that are wider than kSeam.
void note_joints(const std::vector<OpenContour>& contours, const Mates& mates, NoteCode code, std::int64_t layer,
                 Notes& notes) {
    Note n{.code = code, .amount = 0, .count = 0, .layer = layer};
    double worst = 0;
    for (std::uint32_t e = 0; e < mates.size(); ++e) {
        if (mates[e] == kFree || mates[e] < e) continue;
        const Vec2 a = place(contours, e), b = place(contours, mates[e]);
        const double d = geom::distance(a, b);
        if (d <= kSeam) continue;
        n.amount += d;
        ++n.count;
        if (d > worst) {
            worst = d;
            n.x = (a.x + b.x) / 2;
            n.y = (a.y + b.y) / 2;
        }
    }
    if (n.count > 0) notes.push_back(std::move(n));
}

} // namespace

double length(const OpenContour& contour) { return geom::length(contour.points); }

ClosedContours close_contours(std::vector<OpenContour> contours, const std::function<std::vector<OpenContour>()>& lids,
                              const Options& o, std::int64_t layer, Notes& notes) {
    ClosedContours out;
    double lid = 0;
    const auto tell = [&](NoteCode code, double amount, Vec2 at) {
        notes.push_back({.code = code, .amount = amount, .layer = layer, .x = at.x, .y = at.y});
    };
    contours = join(contours, mates_on_edges(contours), out, lid);

    Mates mates(2 * contours.size(), kFree);
    const double widest = std::max(o.close_gaps, kSeam);
    for (const bool directed : {true, false}) // nearest first, so that few ends remain when the cells are wide
        for (double radius = kSeam;; radius *= 5) {
            marry_near(contours, std::min(radius, widest), directed, mates);
            if (radius >= widest) break;
        }
    note_joints(contours, mates, NoteCode::contour_gap_closed, layer, notes);
    contours = join(contours, mates, out, lid);

    if (!contours.empty() && o.close_openings > 0) {
        const Vec2 at = contours.front().points.front();
        for (OpenContour& c : lids()) contours.push_back(std::move(c));
        contours = join(contours, mates_on_edges(contours), out, lid);
        std::erase_if(contours, [](const OpenContour& c) { return c.lid >= length(c); }); // lids left over
        if (lid > 0) tell(NoteCode::contour_over_hole, lid, at);
    }
    for (std::size_t before = 0; before != contours.size();) { // joined contours are longer, and allow wider openings
        before = contours.size();
        mates.assign(2 * contours.size(), kFree);
        marry_far(contours, o.close_openings, mates);
        note_joints(contours, mates, NoteCode::contour_opening_closed, layer, notes);
        contours = join(contours, mates, out, lid);
    }

    for (const OpenContour& c : contours)
        if (length(c) > kSeam) tell(NoteCode::contour_open, length(c), c.points[c.points.size() / 2]);
    if (out.turned > 0) tell(NoteCode::contour_turned, out.turned, {std::nan(""), std::nan("")});
    return out;
}

} // namespace filum::slice
