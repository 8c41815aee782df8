#include "route/tilting.hpp"

#include <algorithm>

namespace filum::route {

using toolpath::Span;

namespace {

std::size_t segments(const Span& s) { return s.points.size() - 1; }

} // namespace

StrokeTilter::StrokeTilter(const std::vector<Span>& spans, bool rotary)
    : given_(spans), stroke_of_(spans.size(), -1), rotary_(rotary) {
    for (std::size_t i = 0; i < given_.size(); ++i) {
        if (!toolpath::extrudes(given_[i].role)) continue;
        const bool goes_on = !strokes_.empty() && strokes_.back().last == i;
        if (!goes_on) strokes_.push_back({i, i, {}, {}, {}});
        Attempt& a = strokes_.back();
        a.last = i + 1;
        a.stroke.before.emplace_back(segments(given_[i]), 0);
        a.stroke.blocked.emplace_back(segments(given_[i]), false);
        stroke_of_[i] = static_cast<std::int64_t>(strokes_.size()) - 1;
    }
    for (Attempt& a : strokes_) a.stroke.spans = {given_.data() + a.first, a.last - a.first};
}

std::uint32_t StrokeTilter::origin(const Attempt& a, std::size_t span, std::uint32_t segment) {
    return a.now.origin.empty() ? segment : a.now.origin[span - a.first][segment];
}

collision::ToolFrame StrokeTilter::stance(const Span& span, std::size_t i) const {
    const Vec3 side = span.normals.empty() && !rotary_ ? Vec3{1, 0, 0} : Vec3{};
    return {span.points[i], span.normals.empty() ? Vec3{0, 0, 1} : span.normals[i], side};
}

bool StrokeTilter::judge(const std::vector<collision::Move>& moves, const collision::CheckResult& found,
                         const std::vector<Span>& spans, const collision::Rooms& rooms) {
    std::vector<std::uint32_t> begin{0}; // number of points before each span
    for (const Span& s : spans) begin.push_back(begin.back() + static_cast<std::uint32_t>(s.points.size()));
    // Calls f(attempt, span within it, segment of the input) for the stroke of the move, if there is one.
    const auto locate = [&](const collision::Move& m, const auto& f) {
        const auto span =
            static_cast<std::size_t>(std::upper_bound(begin.begin(), begin.end(), m.source) - begin.begin()) - 1;
        if (span >= spans.size() || stroke_of_[span] < 0) return;
        Attempt& a = strokes_[static_cast<std::size_t>(stroke_of_[span])];
        const std::uint32_t point = m.source - begin[span];
        f(a, span - a.first, origin(a, span, point > 0 ? point - 1 : 0));
    };
    const auto block = [](Attempt& a, std::size_t s, std::uint32_t i) {
        a.stroke.blocked[s][i] = true;
        ++a.met;
        a.hopeful += a.now.stuck.empty() || !a.now.stuck[s][i] ? 1 : 0;
    };
    for (Attempt& a : strokes_) a.met = a.hopeful = 0;
    for (const auto& m : moves)
        if (!m.travel) locate(m, [&](Attempt& a, std::size_t s, std::uint32_t i) { a.stroke.before[s][i] = m.before; });
    for (Attempt& a : strokes_) {
        const Span &first = spans[a.first], &last = spans[a.last - 1];
        const std::size_t n = a.last - a.first - 1, end = segments(given_[a.last - 1]) - 1;
        const collision::Room room = rooms.of(first.tool);
        if (!room.at(stance(first, 0), a.stroke.before[0][0])) block(a, 0, 0);
        if (!room.at(stance(last, segments(last)), a.stroke.before[n][end]))
            block(a, n, static_cast<std::uint32_t>(end));
    }
    for (const auto& place : found.collisions)
        if (!moves[place.move].travel) locate(moves[place.move], block);
    bool again = false;
    for (Attempt& a : strokes_) {
        if (!a.tried || a.met < a.fewest) {
            a.fewest = a.met;
            a.best = a.now;
        }
        a.tried = true;
        again = again || a.hopeful > 0;
    }
    return again;
}

void StrokeTilter::lean(const collision::Rooms& rooms, const TiltOptions& options, const TestDensity& pace, int threads,
                        std::vector<Span>& spans) {
    for (Attempt& a : strokes_) {
        if (a.hopeful == 0) continue;
        a.now = route::lean(rooms.of(given_[a.first].tool), a.stroke, options, pace, threads);
        std::copy(a.now.spans.begin(), a.now.spans.end(), spans.begin() + static_cast<std::ptrdiff_t>(a.first));
    }
}

void StrokeTilter::hope() {
    for (Attempt& a : strokes_) a.now.stuck.clear();
}

std::vector<TiltSummary> StrokeTilter::best(std::vector<Span>& spans) const {
    std::vector<TiltSummary> out;
    for (const Attempt& a : strokes_) {
        const auto& from = a.best.spans.empty() ? a.stroke.spans : std::span<const Span>(a.best.spans);
        std::copy(from.begin(), from.end(), spans.begin() + static_cast<std::ptrdiff_t>(a.first));
        if (a.best.leaning.leaning > 0) out.push_back(a.best.leaning);
    }
    return out;
}

} // namespace filum::route
