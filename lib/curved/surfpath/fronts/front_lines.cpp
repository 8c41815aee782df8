#include "surfpath/fronts/front_lines.hpp"

#include "surfpath/fronts/elastic.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace filum::surfpath::fronts {

namespace {

using surface::kNone;

struct LiveLine {
    double x = 0; // mm along its front
    std::uint32_t line = 0;
    double before = -1;     // mm from the start of the front before; negative: none
    double before_end = -1; // mm from the end of the front before
};

class March {
  public:
    March(const Fronts& fronts, const SpacingRule& rule)
        : fronts_(fronts), rule_(rule), d_(rule.spacing), half_(rule.group == 1 ? 5 : 9),
          most_(rule.group == 1 ? 0.55 : 1.05), wide_(rule.group == 1 ? 1.8 : 2.6) {}

    FrontLines run() {
        begin();
        for (std::size_t k = 0; k + 1 < fronts_.levels() && !done_; ++k) advance(k);
        out_.bound = bound();
        return std::move(out_);
    }

  private:
    [[nodiscard]] const Front& front(std::uint32_t f) const { return fronts_.at(level_)[f]; }

    std::uint32_t add(std::uint32_t f, double x, FrontLineEnd begin, std::uint32_t group) {
        FrontLine s;
        s.first = level_;
        s.spots = {{f, x}};
        s.begin = begin;
        s.born_with = group;
        out_.lines.push_back(std::move(s));
        root_.push_back(level_ == 0 ? f : kNone);
        return static_cast<std::uint32_t>(out_.lines.size() - 1);
    }

    // Starts lines at equal distances on both sides of each source curve, in pairs at the same places.
    void begin() {
        const auto& sources = fronts_.at(0);
        alive_.assign(sources.size(), {});
        for (std::uint32_t f = 0; f + 1 < sources.size(); f += 2) {
            const double l = sources[f].length();
            const bool closed = sources[f].line.closed;
            const auto n = static_cast<std::uint32_t>(std::max(1.0, std::round(l / d_)));
            const auto first = static_cast<std::uint32_t>(out_.lines.size());
            for (std::uint32_t side = 0; side < 2; ++side)
                for (std::uint32_t i = 0; i < n; ++i) {
                    const double x = l * (i + (closed ? 0.0 : 0.5)) / n;
                    const std::uint32_t s = add(f + side, x, FrontLineEnd::source, kNone);
                    alive_[f + side].push_back({x, s});
                    const std::uint32_t across = closed ? (n - i) % n : n - 1 - i;
                    out_.lines[s].mate = first + (1 - side) * n + across;
                }
        }
    }

    void advance(std::size_t k) {
        std::vector<std::vector<LiveLine>> next(fronts_.at(k + 1).size());
        for (std::uint32_t f = 0; f < alive_.size(); ++f) {
            const double l = fronts_.at(k)[f].length();
            for (const LiveLine& a : alive_[f]) {
                const auto to = fronts_.onward(k, {f, a.x});
                if (!to) continue;
                out_.lines[a.line].spots.push_back(*to);
                const bool closed = fronts_.at(k)[f].line.closed || fronts_.at(k + 1)[to->front].line.closed;
                next[to->front].push_back({to->x, a.line, closed ? -1 : a.x, closed ? -1 : l - a.x});
            }
        }
        level_ = k + 1;
        for (std::uint32_t f = 0; f < next.size(); ++f) {
            std::stable_sort(next[f].begin(), next[f].end(),
                             [](const LiveLine& a, const LiveLine& b) { return a.x < b.x; });
            apply(f, next[f]);
        }
        record(next);
        alive_ = std::move(next);
    }

    // ---- the spacing rule, on one front
    void apply(std::uint32_t f, std::vector<LiveLine>& row) {
        if (row.empty()) return settle(f, row);
        thin(f, row);
        fill(f, row);
        const std::size_t before = row.size();
        while (row.size() < 2 * before + 2 && bear(f, row)) {
        }
        if (row.size() > before) return; // windows at rims hold fewer gaps; no line may die for one just born
        while (reap(f, row)) {
        }
    }

    // Starts lines on a front that no line reaches.
    void settle(std::uint32_t f, std::vector<LiveLine>& row) {
        const double l = front(f).length();
        auto n = static_cast<std::size_t>(std::round(l / d_));
        n -= n % rule_.group;
        const std::uint32_t group = groups_;
        for (std::size_t i = 0; i < n; ++i) {
            const double x = l * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
            row.push_back({x, add(f, x, FrontLineEnd::interior, group + static_cast<std::uint32_t>(i / rule_.group))});
        }
        groups_ += static_cast<std::uint32_t>((n + 1) / rule_.group);
        out_.born += n;
    }

    // How much too wide each gap is: the one before each line and, on an open front, the one behind the last.
    // Between a line and a rim along which it runs there should be half a spacing. If the line runs towards the
    // rim, that gap counts only if it has room for one more line.
    [[nodiscard]] std::vector<double> excess(std::uint32_t f, const std::vector<LiveLine>& row) const {
        const Front& on = front(f);
        const double l = on.length();
        std::vector<double> e;
        for (std::size_t i = 0; i < row.size(); ++i)
            e.push_back(i > 0 ? row[i].x - row[i - 1].x - d_ : row[0].x + l - row.back().x - d_);
        if (on.line.closed) return e;
        const auto to_rim = [&](double x, double before) {
            const bool along = before >= 0 && std::abs(x - before) < rules::kAlong * fronts_.step();
            return along || x > 1.3 * d_ ? x - d_ / 2 : 0;
        };
        e[0] = to_rim(row[0].x, row[0].before);
        e.push_back(to_rim(l - row.back().x, row.back().before_end));
        return e;
    }

    // Inserts n lines into gap i, which is before line i.
    void insert(std::uint32_t f, std::vector<LiveLine>& row, std::size_t i, std::size_t n) {
        const Front& on = front(f);
        const double l = on.length();
        double from, to;
        if (on.line.closed) {
            from = i > 0 ? row[i - 1].x : row.back().x - l;
            to = row[i].x;
        } else { // a rim counts as a line half a spacing outside
            from = i > 0 ? row[i - 1].x : -d_ / 2;
            to = i < row.size() ? row[i].x : l + d_ / 2;
        }
        std::vector<LiveLine> added;
        for (std::size_t j = 1; j <= n; ++j) {
            double x = from + (to - from) * static_cast<double>(j) / static_cast<double>(n + 1);
            if (on.line.closed && x < 0) x += l;
            x = std::clamp(x, 0.0, l);
            const auto group = groups_ + static_cast<std::uint32_t>((j - 1) / rule_.group);
            added.push_back({x, add(f, x, FrontLineEnd::interior, group)});
        }
        groups_ += static_cast<std::uint32_t>((n + rule_.group - 1) / rule_.group);
        out_.born += n;
        row.insert(row.begin() + static_cast<std::ptrdiff_t>(i), added.begin(), added.end());
        std::stable_sort(row.begin(), row.end(), [](const LiveLine& a, const LiveLine& b) { return a.x < b.x; });
    }

    void kill(std::vector<LiveLine>& row, std::size_t i, std::uint32_t group) {
        FrontLine& s = out_.lines[row[i].line];
        s.end = FrontLineEnd::interior;
        s.dies_with = group;
        ++out_.died;
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(i));
    }

    // Of two lines that are nearer than half a spacing the younger dies.
    void thin(std::uint32_t f, std::vector<LiveLine>& row) {
        for (std::size_t i = 0; row.size() > 1 && i < row.size();) {
            const bool closed = front(f).line.closed;
            const double gap = i > 0 ? row[i].x - row[i - 1].x : row[0].x + front(f).length() - row.back().x;
            if ((i == 0 && !closed) || gap >= d_ / 2) {
                ++i;
                continue;
            }
            const std::size_t before = i > 0 ? i - 1 : row.size() - 1;
            const bool first = out_.lines[row[before].line].first > out_.lines[row[i].line].first;
            kill(row, first ? before : i, groups_++);
        }
    }

    // Fills wide gaps.
    void fill(std::uint32_t f, std::vector<LiveLine>& row) {
        for (std::size_t i = 0; i < excess(f, row).size(); ++i) {
            const double gap = excess(f, row)[i] + d_;
            if (gap < wide_ * d_) continue;
            auto n = static_cast<std::size_t>(std::round(gap / d_)) - 1;
            n -= n % rule_.group;
            if (n == 0) continue;
            insert(f, row, i, n);
            i += n;
        }
    }

    // Sums of `sign` times the excess over windows of neighbouring gaps, by the first gap of each. If there are no
    // more gaps than a window holds, there is one window with all.
    struct WindowSums {
        std::vector<double> sum;
        std::size_t gaps = 0, size = 0;
        bool closed = false;

        // The least sum of the windows that contain the gap.
        [[nodiscard]] double least(std::size_t gap) const {
            if (sum.size() == 1) return sum[0];
            double out = std::numeric_limits<double>::infinity();
            for (std::size_t back = 0; back < size; ++back) {
                if (!closed && back > gap) break;
                const std::size_t first = (gap + gaps - back) % gaps;
                if (first < sum.size()) out = std::min(out, sum[first]);
            }
            return out;
        }
    };

    [[nodiscard]] WindowSums windows(const std::vector<double>& e, bool closed, double sign) const {
        WindowSums w{{}, e.size(), std::min(2 * half_ + 1, e.size()), closed};
        const std::size_t n = w.size == w.gaps ? 1 : closed ? w.gaps : w.gaps - w.size + 1;
        for (std::size_t i = 0; i < n; ++i) {
            double sum = 0;
            for (std::size_t j = i; j < i + w.size; ++j) sum += sign * e[j % w.gaps];
            w.sum.push_back(sum);
        }
        return w;
    }

    // Makes a birth where a window demands one, unless it would make another window demand a death. Returns false if
    // none is due.
    bool bear(std::uint32_t f, std::vector<LiveLine>& row) {
        const auto e = excess(f, row);
        const WindowSums w = windows(e, front(f).line.closed, 1);
        const double allowed = (static_cast<double>(rule_.group) - most_ + rules::kSamePoint) * d_;
        for (std::size_t i = 0; i < w.sum.size(); ++i) {
            if (!(w.sum[i] > most_ * d_)) continue;
            std::size_t best = e.size();
            for (std::size_t back = 0; back < w.size; ++back) {
                const std::size_t j = (i + (w.size / 2 + back) % w.size) % w.gaps; // starting in the middle
                if (w.least(j) >= allowed && (best == e.size() || e[j] > e[best] + rules::kSamePoint * d_)) best = j;
            }
            if (best == e.size()) continue;
            insert(f, row, best, rule_.group);
            return true;
        }
        return false;
    }

    // Makes a death under the same rule: the group dies whose gaps, including those on both sides, are narrowest in
    // total.
    bool reap(std::uint32_t f, std::vector<LiveLine>& row) {
        const auto e = excess(f, row);
        const WindowSums w = windows(e, front(f).line.closed, -1);
        const std::size_t g = rule_.group, size = row.size();
        if (size <= g) return false;
        const double allowed = (static_cast<double>(g) - most_ + rules::kSamePoint) * d_;
        for (std::size_t i = 0; i < w.sum.size(); ++i) {
            if (!(w.sum[i] > most_ * d_)) continue;
            double least = std::numeric_limits<double>::infinity();
            std::size_t best = size;
            for (std::size_t j = i; j + g < i + w.size; ++j) {
                double sum = 0, room = std::numeric_limits<double>::infinity();
                for (std::size_t k = j; k <= j + g; ++k) {
                    sum += e[k % w.gaps];
                    room = std::min(room, w.least(k % w.gaps));
                }
                if (room >= allowed && sum < least - rules::kSamePoint * d_) {
                    least = sum;
                    best = j % size;
                }
            }
            if (best == size) continue;
            const std::uint32_t group = groups_++;
            for (std::size_t j = 0; j < g; ++j) kill(row, best < row.size() ? best : 0, group);
            return true;
        }
        return false;
    }

    // ---- growth of the fronts' widths, for the lower bound
    void record(const std::vector<std::vector<LiveLine>>& rows) {
        done_ = true;
        for (std::uint32_t f = 0; f < rows.size(); ++f) {
            if (!rows[f].empty()) done_ = false;
            for (std::size_t i = 1; i < rows[f].size(); ++i) {
                const FrontLine &a = out_.lines[rows[f][i - 1].line], &b = out_.lines[rows[f][i].line];
                if (a.first == level_ || b.first == level_) continue; // the room for a new line had grown before
                const Spot &sa = a.spots[a.spots.size() - 2], &sb = b.spots[b.spots.size() - 2];
                if (sa.front != sb.front || sb.x < sa.x) continue;
                change(root_[rows[f][i - 1].line], rows[f][i].x - rows[f][i - 1].x - (sb.x - sa.x));
            }
        }
    }

    void change(std::uint32_t root, double by) {
        auto& c = changes_[root];
        c.resize(level_ + 1, 0);
        c[level_] += by;
    }

    // Sum of the rises of the widths; rises separated by a fall of less than half a spacing count as one.
    [[nodiscard]] std::size_t bound() const {
        std::size_t out = 0;
        for (const auto& [root, steps] : changes_) {
            double now = 0, valley = 0, peak = 0;
            const auto bank = [&] { out += static_cast<std::size_t>(std::max(0.0, (peak - valley) / d_)); };
            for (const double v : steps) {
                now += v;
                peak = std::max(peak, now);
                if (now < peak - d_ / 2) {
                    bank();
                    valley = peak = now;
                }
                if (peak - valley < d_ / 2 && now < valley) valley = peak = now;
            }
            bank();
        }
        return out;
    }

    const Fronts& fronts_;
    const SpacingRule& rule_;
    double d_;
    std::size_t half_;
    double most_, wide_;
    std::size_t level_ = 0;
    bool done_ = false;
    std::uint32_t groups_ = 0;
    FrontLines out_;
    std::vector<std::vector<LiveLine>> alive_; // per front of the level
    std::vector<std::uint32_t> root_;          // per line: the source front from which it comes
    std::map<std::uint32_t, std::vector<double>> changes_;
};

// Extends lines that died shortly before a rim to that rim.
void revive(std::vector<FrontLine>& lines, const Fronts& fronts, double brief, std::size_t& died) {
    for (FrontLine& s : lines) {
        if (s.end != FrontLineEnd::interior) continue;
        FrontLine longer = s;
        bool rim = false;
        while (!rim && static_cast<double>(longer.last() - s.last()) * fronts.step() < brief) {
            const auto to = fronts.onward(longer.last(), longer.spots.back());
            if (to) longer.spots.push_back(*to);
            rim = !to;
        }
        if (!rim) continue;
        s = std::move(longer);
        s.end = FrontLineEnd::rim;
        s.dies_with = kNone;
        --died;
    }
}

// Leaves out lines that are too short. A line and its mate count together.
void drop_short(FrontLines& all, const Fronts& fronts, double shortest, double brief) {
    const std::size_t n = all.lines.size();
    std::vector<double> length(n);
    for (std::size_t i = 0; i < n; ++i) {
        const FrontLine& s = all.lines[i];
        const bool runs_out = s.end == FrontLineEnd::rim;
        length[i] = static_cast<double>(s.last() - s.first) * fronts.step() +
                    (runs_out ? surface::curve::length(fronts.last(s.last(), s.spots.back())) : 0);
    }
    std::vector<std::uint32_t> number(n, kNone);
    std::vector<FrontLine> kept;
    for (std::size_t i = 0; i < n; ++i) {
        const FrontLine& s = all.lines[i];
        const double whole = length[i] + (s.mate != kNone ? length[s.mate] : 0);
        const double least = s.begin == FrontLineEnd::interior ? std::max(shortest, brief) : shortest;
        if (length[i] > 1e-6 && whole >= least) {
            number[i] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(s);
        } else if (length[i] > 1e-6) {
            all.left_out.push_back({s.last(), s.spots.back(), length[i]});
            if (s.begin == FrontLineEnd::interior) --all.born;
            if (s.end == FrontLineEnd::interior) --all.died;
        }
    }
    for (FrontLine& s : kept)
        if (s.mate != kNone) s.mate = number[s.mate];
    all.lines = std::move(kept);
}

} // namespace

FrontLines front_lines(const Fronts& fronts, const SpacingRule& rule) {
    FrontLines out = March(fronts, rule).run();
    const double brief = rules::kBeside * rule.spacing; // a line is not worth starting, or ending, nearer to a rim
    revive(out.lines, fronts, brief, out.died);
    drop_short(out, fronts, std::max(rule.shortest, rule.spacing), brief);
    make_room(out.lines, fronts, rule.spacing);
    return out;
}

} // namespace filum::surfpath::fronts
