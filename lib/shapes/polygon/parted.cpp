#include "polygon/parted.hpp"

#include <algorithm>
#include <cmath>

namespace filum::polygon {

namespace {

constexpr int kPasses = 100;     // limit; three passes are usual
constexpr std::size_t kFew = 32; // so few walls are compared each with each
constexpr int kDeep = 60;        // limit of nested halvings
constexpr double kNoGain = 1.8;  // of the walls; if both halves hold more, halving separates nothing
constexpr double kRim = 2;       // grid steps of margin around a piece of a wall, more than rounding errors

// The part of a wall in a cell, as a box.
struct Stretch {
    std::uint32_t wall = 0;
    double lo[2] = {0, 0}, hi[2] = {0, 0};
};

struct Split {
    std::uint32_t wall = 0;
    GridPoint at;
    friend auto operator<=>(const Split&, const Split&) = default;
};

bool same_box(const Stretch& s, const Stretch& t) {
    return s.lo[0] <= t.hi[0] && t.lo[0] <= s.hi[0] && s.lo[1] <= t.hi[1] && t.lo[1] <= s.hi[1];
}

int sign(__int128 v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

// Whether p, on the line through the wall, lies between its ends.
bool between(const GridWall& w, GridPoint p) { return w.a < p && p < w.b; }

GridPoint crossing_of(const GridWall& e, const GridWall& f) {
    const auto above = static_cast<double>(turn(f.a, f.b, e.a)), below = static_cast<double>(turn(f.a, f.b, e.b));
    const double t = above / (above - below);
    return {e.a.x + std::llround(t * static_cast<double>(e.b.x - e.a.x)),
            e.a.y + std::llround(t * static_cast<double>(e.b.y - e.a.y))};
}

class WallSplitter {
  public:
    explicit WallSplitter(const std::vector<GridWall>& walls) : walls_(walls) {}

    // The places where walls must be split, sorted by wall.
    std::vector<Split> run() {
        std::vector<Stretch> all;
        all.reserve(walls_.size());
        for (std::uint32_t i = 0; i < walls_.size(); ++i) {
            const GridWall& w = walls_[i];
            const auto ax = static_cast<double>(w.a.x), ay = static_cast<double>(w.a.y),
                       bx = static_cast<double>(w.b.x), by = static_cast<double>(w.b.y);
            all.push_back({i, {ax - kRim, std::min(ay, by) - kRim}, {bx + kRim, std::max(ay, by) + kRim}});
        }
        halve(std::move(all), 0);
        std::sort(splits_.begin(), splits_.end());
        splits_.erase(std::unique(splits_.begin(), splits_.end()), splits_.end());
        return std::move(splits_);
    }

  private:
    void compare(std::uint32_t i, std::uint32_t j) {
        const GridWall &e = walls_[i], &f = walls_[j];
        if (!e.fresh && !f.fresh) return;
        const int p = sign(turn(e.a, e.b, f.a)), q = sign(turn(e.a, e.b, f.b));
        if (p * q > 0) return;
        const int r = sign(turn(f.a, f.b, e.a)), s = sign(turn(f.a, f.b, e.b));
        if (r * s > 0) return;
        if (p * q < 0 && r * s < 0) {
            const GridPoint at = crossing_of(e, f);
            if (at != e.a && at != e.b) splits_.push_back({i, at});
            if (at != f.a && at != f.b) splits_.push_back({j, at});
            return;
        }
        if (p == 0 && between(e, f.a)) splits_.push_back({i, f.a});
        if (q == 0 && between(e, f.b)) splits_.push_back({i, f.b});
        if (r == 0 && between(f, e.a)) splits_.push_back({j, e.a});
        if (s == 0 && between(f, e.b)) splits_.push_back({j, e.b});
    }

    void compare_all(std::vector<Stretch>& s) {
        std::sort(s.begin(), s.end(), [](const Stretch& a, const Stretch& b) {
            return a.lo[0] != b.lo[0] ? a.lo[0] < b.lo[0] : a.wall < b.wall;
        });
        for (std::size_t i = 0; i < s.size(); ++i)
            for (std::size_t j = i + 1; j < s.size() && s[j].lo[0] <= s[i].hi[0]; ++j)
                if (same_box(s[i], s[j])) compare(s[i].wall, s[j].wall);
    }

    // The part of a stretch on one side of a cut across axis k.
    [[nodiscard]] Stretch clipped(Stretch s, int k, double cut, bool low) const {
        (low ? s.hi[k] : s.lo[k]) = low ? std::min(s.hi[k], cut) : std::max(s.lo[k], cut);
        const GridWall& w = walls_[s.wall];
        const double a[2] = {static_cast<double>(w.a.x), static_cast<double>(w.a.y)};
        const double d[2] = {static_cast<double>(w.b.x - w.a.x), static_cast<double>(w.b.y - w.a.y)};
        const int m = 1 - k;
        if (d[k] == 0) return s;
        const double at = a[m] + d[m] * ((cut - a[k]) / d[k]); // where the wall meets the cut, along the other axis
        const bool rises = (d[m] > 0) == (d[k] > 0);
        const double reach = kRim * (1 + std::abs(d[m] / d[k])); // the margin of the cut, along the other axis
        if (low == rises)
            s.hi[m] = std::min(s.hi[m], at + reach);
        else
            s.lo[m] = std::max(s.lo[m], at - reach);
        return s;
    }

    bool parted_across(const std::vector<Stretch>& all, int k, std::vector<Stretch> (&half)[2]) const {
        double cut = 0; // the mean of the middles
        for (const Stretch& s : all) cut += (s.lo[k] + s.hi[k]) / 2 / static_cast<double>(all.size());
        for (auto& h : half) {
            h.clear();
            h.reserve(all.size());
        }
        for (const Stretch& s : all) {
            if (s.lo[k] <= cut) half[0].push_back(clipped(s, k, cut, true));
            if (s.hi[k] >= cut) half[1].push_back(clipped(s, k, cut, false));
        }
        return static_cast<double>(half[0].size() + half[1].size()) <= kNoGain * static_cast<double>(all.size());
    }

    void halve(std::vector<Stretch> all, int depth) {
        const bool fresh = std::any_of(all.begin(), all.end(), [&](const Stretch& s) { return walls_[s.wall].fresh; });
        if (!fresh) return;
        if (all.size() <= kFew || depth == kDeep) {
            compare_all(all);
            return;
        }
        double lo[2] = {all[0].lo[0], all[0].lo[1]}, hi[2] = {all[0].hi[0], all[0].hi[1]};
        for (const Stretch& s : all)
            for (int k = 0; k < 2; ++k) {
                lo[k] = std::min(lo[k], s.lo[k]);
                hi[k] = std::max(hi[k], s.hi[k]);
            }
        const int longer = hi[0] - lo[0] >= hi[1] - lo[1] ? 0 : 1;
        std::vector<Stretch> half[2];
        if (!parted_across(all, longer, half) && !parted_across(all, 1 - longer, half)) {
            compare_all(all);
            return;
        }
        all = {};
        halve(std::move(half[0]), depth + 1);
        halve(std::move(half[1]), depth + 1);
    }

    const std::vector<GridWall>& walls_;
    std::vector<Split> splits_;
};

// Sorts the walls, merges copies, and directs each from its lesser end to its greater one.
void put_in_order(std::vector<GridWall>& walls) {
    for (GridWall& w : walls)
        if (w.b < w.a) {
            std::swap(w.a, w.b);
            w.weight = -w.weight;
        }
    std::erase_if(walls, [](const GridWall& w) { return w.a == w.b; });
    std::sort(walls.begin(), walls.end(),
              [](const GridWall& v, const GridWall& w) { return v.a != w.a ? v.a < w.a : v.b < w.b; });
    std::size_t count = 0;
    for (const GridWall& w : walls) {
        if (count > 0 && walls[count - 1].a == w.a && walls[count - 1].b == w.b) {
            GridWall& same = walls[count - 1];
            same.weight += w.weight;
            same.marked = same.marked || w.marked;
            same.fresh = same.fresh || w.fresh;
        } else
            walls[count++] = w;
    }
    walls.resize(count);
}

std::vector<GridWall> split_at(const std::vector<GridWall>& walls, std::vector<Split>& splits) {
    std::vector<GridWall> out;
    out.reserve(walls.size() + splits.size());
    std::size_t k = 0;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
        const std::size_t first = k;
        while (k < splits.size() && splits[k].wall == i) ++k;
        GridWall piece = walls[i];
        piece.fresh = k > first;
        const GridPoint end = piece.b;
        const auto along = [&](const Split& s) {
            return static_cast<__int128>(s.at.x - walls[i].a.x) * (end.x - walls[i].a.x) +
                   static_cast<__int128>(s.at.y - walls[i].a.y) * (end.y - walls[i].a.y);
        };
        std::sort(splits.begin() + static_cast<std::ptrdiff_t>(first), splits.begin() + static_cast<std::ptrdiff_t>(k),
                  [&](const Split& s, const Split& t) {
                      const __int128 u = along(s), v = along(t);
                      return u != v ? u < v : s.at < t.at;
                  });
        for (std::size_t j = first; j < k; ++j) {
            piece.b = splits[j].at;
            out.push_back(piece);
            piece.a = piece.b;
        }
        piece.b = end;
        out.push_back(piece);
    }
    return out;
}

} // namespace

std::optional<std::vector<GridWall>> parted(std::vector<GridWall> walls) {
    put_in_order(walls);
    for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<Split> splits = WallSplitter(walls).run();
        if (splits.empty()) return walls;
        walls = split_at(walls, splits);
        put_in_order(walls);
    }
    return std::nullopt;
}

} // namespace filum::polygon
