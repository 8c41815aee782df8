#include "infill/strips.hpp"

#include "base/none.hpp"
#include "infill/ruler.hpp"
#include "infill/waves.hpp"
#include "polygon/simple.hpp"
#include "polygon/stretches.hpp"

#include <algorithm>
#include <cmath>

namespace filum::infill {

namespace {

using geom::Vec2;
using polygon::kGridStep;

bool is_even(std::int64_t j) { return j % 2 == 0; }

// Straight lines v = const, in one column without knots.
class Rows {
  public:
    explicit Rows(const Lines& lines) : ruler_(lines) {}
    [[nodiscard]] static std::int64_t column(double) { return 0; }
    [[nodiscard]] static double knot(std::int64_t column) { return column > 0 ? 1e300 : -1e300; }
    [[nodiscard]] double at(std::int64_t, double, std::int64_t j) const { return ruler_.place(static_cast<double>(j)); }
    [[nodiscard]] std::int64_t below(std::int64_t, double, double v) const {
        return static_cast<std::int64_t>(ruler_.below(v));
    }

  private:
    Ruler ruler_;
};

// A crossing of the outline and a line. It is where a chain enters an even cell or leaves it.
struct Crossing {
    std::int64_t line = 0;
    Vec2 at;
    std::uint32_t chain = 0;
    bool enters = false;
};

// Cuts the outlines of an area into chains, the stretches in even cells, and joins these along the lines.
template <class Curves>
class Cutter {
  public:
    Cutter(const Loops& area, const Curves& curves) : curves_(curves) {
        for (std::size_t l = 0; l < area.size(); ++l) cut(area[l]);
    }

    std::optional<Loops> joined() {
        if (!sort()) return std::nullopt;
        std::vector<std::uint32_t> enter(chains()), leave(chains()); // crossings
        for (std::uint32_t k = 0; k < crossing_.size(); ++k)
            (crossing_[k].enters ? enter : leave)[crossing_[k].chain] = k;
        std::vector<char> seen(chains(), 0);
        for (std::uint32_t first = 0; first < chains(); ++first) {
            if (seen[first]) continue;
            const std::size_t begin = out_.points.size();
            for (std::uint32_t c = first; !seen[c];) {
                seen[c] = 1;
                const Crossing &in = crossing_[enter[c]], &end = crossing_[leave[c]];
                const Crossing& next = crossing_[leave[c] ^ 1U];
                put(in.at, begin);
                for (std::uint32_t i = start_[c]; i < start_[c + 1]; ++i) put(point_[i], begin);
                put(end.at, begin);
                follow(end, next, begin);
                c = next.chain;
            }
            close(begin);
        }
        return std::move(out_);
    }

  private:
    // What follows along an outline: a vertex, or a crossing of a line.
    struct Event {
        Vec2 at;
        std::int64_t line = 0;
        bool vertex = true, up = false;
        // The cell after a crossing.
        [[nodiscard]] std::int64_t cell() const { return up ? line : line - 1; }
    };

    [[nodiscard]] std::uint32_t chains() const { return static_cast<std::uint32_t>(start_.size() - 1); }

    void cut(std::span<const Vec2> loop) {
        events_.clear();
        const std::int64_t begin = curves_.below(curves_.column(loop[0].x), loop[0].x, loop[0].y);
        std::int64_t cell = begin;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            events_.push_back({loop[i]});
            cell = walk(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1], cell, i + 1 == loop.size() ? &begin : nullptr);
        }
        const auto first = std::find_if(events_.begin(), events_.end(), [](const Event& e) { return !e.vertex; });
        if (first == events_.end()) {
            if (is_even(begin)) out_.add(loop); // all in one cell
            return;
        }
        std::rotate(events_.begin(), first, events_.end());
        events_.push_back(events_.front());
        const Event* from = nullptr; // the crossing where the chain entered
        for (const Event& e : events_) {
            if (e.vertex) {
                if (from != nullptr) point_.push_back(e.at);
                continue;
            }
            if (from != nullptr) {
                crossing_.push_back({from->line, from->at, chains(), true});
                crossing_.push_back({e.line, e.at, chains(), false});
                start_.push_back(static_cast<std::uint32_t>(point_.size()));
            }
            from = is_even(e.cell()) ? &e : nullptr;
        }
    }

    // Adds the crossings of the edge from a, in `cell`, to b. Returns the cell of b; `*last` if that is known.
    std::int64_t walk(Vec2 a, Vec2 b, std::int64_t cell, const std::int64_t* last) {
        const bool right = b.x >= a.x;
        std::int64_t column = curves_.column(a.x);
        const std::int64_t end = curves_.column(b.x);
        while (column != end) {
            const double u = curves_.knot(right ? column + 1 : column);
            const double t = std::clamp((u - a.x) / (b.x - a.x), 0.0, 1.0);
            const Vec2 p{u, std::lerp(a.y, b.y, t)};
            const std::int64_t there = curves_.below(column, u, p.y);
            cross(a, p, column, cell, there);
            a = p;
            cell = there;
            column += right ? 1 : -1;
        }
        const std::int64_t there = last != nullptr ? *last : curves_.below(column, b.x, b.y);
        cross(a, b, column, cell, there);
        return there;
    }

    // Adds the crossings of the part of an edge in one column, from one cell to another.
    void cross(Vec2 a, Vec2 b, std::int64_t column, std::int64_t from, std::int64_t to) {
        const bool up = to > from;
        for (std::int64_t j = up ? from + 1 : from; up ? j <= to : j > to; j += up ? 1 : -1) {
            const double below = a.y - curves_.at(column, a.x, j), above = b.y - curves_.at(column, b.x, j);
            const double t = above != below ? std::clamp(below / (below - above), 0.0, 1.0) : 0.5;
            events_.push_back({geom::lerp(a, b, t), j, false, up});
        }
    }

    // Sorts the crossings of each line. False if what enters and what leaves do not alternate.
    bool sort() {
        std::sort(crossing_.begin(), crossing_.end(), [](const Crossing& a, const Crossing& b) {
            if (a.line != b.line) return a.line < b.line;
            if (a.at.x != b.at.x) return a.at.x < b.at.x;
            return a.chain != b.chain ? a.chain < b.chain : a.enters < b.enters;
        });
        for (std::size_t k = 0; k + 1 < crossing_.size(); k += 2) {
            const auto touch = [&](std::size_t i) { return crossing_[i].at.x - crossing_[k + 1].at.x < kGridStep; };
            // the area touches itself on the line: any order of what meets there is right
            for (std::size_t i = k + 2; crossing_[k].enters == crossing_[k + 1].enters && i < crossing_.size() &&
                                        crossing_[i].line == crossing_[k].line && touch(i);
                 ++i)
                if (crossing_[i].enters != crossing_[k].enters) std::swap(crossing_[i], crossing_[k + 1]);
            const Crossing &left = crossing_[k], &right = crossing_[k + 1];
            if (left.line != right.line || left.enters == right.enters) return false;
            // below an even cell the area leaves on the left and enters on the right; above it, the other way round
            if (left.enters == is_even(left.line) && right.at.x - left.at.x > kGridStep) return false;
        }
        return crossing_.size() % 2 == 0;
    }

    // Adds the knots of a line between two crossings.
    void follow(const Crossing& from, const Crossing& to, std::size_t begin) {
        const bool right = to.at.x > from.at.x;
        const std::int64_t end = curves_.column(to.at.x);
        for (std::int64_t c = curves_.column(from.at.x); c != end;) {
            const double u = curves_.knot(right ? c + 1 : c);
            put({u, curves_.at(c, u, from.line)}, begin);
            c += right ? 1 : -1;
        }
    }

    void put(Vec2 p, std::size_t begin) {
        if (out_.points.size() > begin && geom::distance(out_.points.back(), p) < kGridStep) return;
        out_.points.push_back(p);
    }
    void close(std::size_t begin) {
        while (out_.points.size() > begin + 1 && geom::distance(out_.points.back(), out_.points[begin]) < kGridStep)
            out_.points.pop_back();
        if (out_.points.size() >= begin + 3)
            out_.close();
        else
            out_.points.resize(begin);
    }

    const Curves& curves_;
    std::vector<Event> events_;
    std::vector<Crossing> crossing_;
    std::vector<Vec2> point_; // of chains, without the crossings at their ends
    std::vector<std::uint32_t> start_{0};
    Loops out_;
};

// x and y exchanged; loops keep their orientation.
Loops mirrored(Loops a) {
    for (Vec2& p : a.points) std::swap(p.x, p.y);
    for (std::size_t l = 0; l < a.size(); ++l)
        std::reverse(a.points.begin() + a.start[l], a.points.begin() + a.start[l + 1]);
    return a;
}

std::optional<Loops> in_waves(const Loops& area, const Lines& lines) {
    const geom::Box2 box = polygon::bounds(area);
    return Cutter(area, Waves(lines, box.lo.x, box.hi.x)).joined();
}

} // namespace

std::optional<Loops> in_even_cells(const Loops& area, const Lines& lines) {
    if (area.empty()) return Loops{};
    if (lines.pattern == polygon::InfillPattern::rows) {
        const Rows rows(lines);
        auto out = Cutter(polygon::rotated(area, -lines.direction), rows).joined();
        if (out) *out = polygon::rotated(*out, lines.direction);
        return out;
    }
    if (Waves::along_x(lines)) return in_waves(area, lines);
    auto out = in_waves(mirrored(area), lines);
    if (out) *out = mirrored(std::move(*out));
    return out;
}

} // namespace filum::infill
