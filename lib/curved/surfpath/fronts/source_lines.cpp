#include "surfpath/fronts/source_lines.hpp"

#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace filum::surfpath::fronts {

namespace {

using surface::kNone;
using surface::Segment;

// Per segment the numbers of its end points; end points that meet have the same number.
std::vector<std::array<std::uint32_t, 2>> ends(const std::vector<Segment>& segments) {
    const std::size_t n = 2 * segments.size();
    const auto point = [&](std::size_t i) { return i % 2 == 0 ? segments[i / 2].a : segments[i / 2].b; };
    std::vector<std::uint32_t> order(n), number(n, kNone);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return point(a).x < point(b).x; });
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (number[order[i]] != kNone) continue;
        const Vec3 p = point(order[i]);
        number[order[i]] = next;
        for (std::size_t j = i + 1; j < n && point(order[j]).x <= p.x + rules::kSamePoint; ++j)
            if (number[order[j]] == kNone && distance(p, point(order[j])) <= rules::kSamePoint) number[order[j]] = next;
        ++next;
    }
    std::vector<std::array<std::uint32_t, 2>> out(segments.size());
    for (std::size_t i = 0; i < n; ++i) out[i / 2][i % 2] = number[i];
    return out;
}

class CurveBuilder {
  public:
    explicit CurveBuilder(std::vector<Segment> segments) : segments_(std::move(segments)), ends_(ends(segments_)) {
        std::uint32_t points = 0;
        for (const auto& e : ends_) points = std::max({points, e[0] + 1, e[1] + 1});
        at_.resize(points);
        for (std::uint32_t i = 0; i < ends_.size(); ++i)
            for (const std::uint32_t p : ends_[i]) at_[p].push_back(i);
        used_.assign(segments_.size(), 0);
    }

    std::vector<Line> all() {
        std::vector<std::pair<std::uint32_t, Line>> found;
        for (std::uint32_t pass = 0; pass < 2; ++pass) // open curves first, then closed ones
            for (std::uint32_t i = 0; i < segments_.size(); ++i)
                for (const std::uint32_t p : ends_[i])
                    if (!used_[i] && (pass == 1 || at_[p].size() != 2)) found.push_back(follow(i, p));
        std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Line> out;
        for (auto& f : found) out.push_back(std::move(f.second));
        return out;
    }

  private:
    // The curve that starts at point `from` with segment `i`, and the lowest number of its segments.
    std::pair<std::uint32_t, Line> follow(std::uint32_t i, std::uint32_t from) {
        std::uint32_t least = i, p = from;
        Line out;
        while (true) {
            used_[i] = 1;
            least = std::min(least, i);
            const bool ahead = ends_[i][0] == p;
            const Segment& s = segments_[i];
            out.places.push_back({s.triangle, ahead ? s.a : s.b});
            p = ends_[i][ahead ? 1 : 0];
            if (p == from) {
                out.closed = true;
                return {least, out};
            }
            const std::uint32_t on = at_[p].size() == 2 ? at_[p][at_[p][0] == i ? 1 : 0] : kNone;
            if (on == kNone || used_[on]) {
                out.places.push_back({s.triangle, ahead ? s.b : s.a});
                return {least, out};
            }
            i = on;
        }
    }

    std::vector<Segment> segments_;
    std::vector<std::array<std::uint32_t, 2>> ends_;
    std::vector<std::vector<std::uint32_t>> at_; // per point: the segments that end there
    std::vector<char> used_;
};

} // namespace

std::vector<Line> source_lines(const surface::Sources& sources) {
    std::vector<Segment> long_ones;
    for (const Segment& s : sources.segments)
        if (distance(s.a, s.b) > rules::kSamePoint) long_ones.push_back(s);
    return CurveBuilder(std::move(long_ones)).all();
}

} // namespace filum::surfpath::fronts
