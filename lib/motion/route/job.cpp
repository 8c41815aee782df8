#include "route/job.hpp"

#include "parallel/parallel.hpp"
#include "route/tilting.hpp"

#include <utility>

namespace filum::route {

namespace {

using collision::Move;
using toolpath::Span;
using Things = std::array<std::vector<collision::Solid>, 4>;

// Attempts at tilting: density of samples, and mm by which the head keeps farther than the margin from solid
// obstacles.
struct TiltAttempt {
    TestDensity pace;
    double more;
};
constexpr std::array<TiltAttempt, 4> kRounds{
    {{{1, false}, 0.05}, {{0.5, true}, 0}, {{0.25, true}, 0.05}, {{0.25, true}, 0.01}}};

bool lays(const Span& s) { return toolpath::extrudes(s.role); }

Vec3 axis(const Span& s, std::size_t i) { return s.normals.empty() ? Vec3{0, 0, 1} : s.normals[i]; }

double travelled(const std::vector<Move>& moves) {
    double sum = 0;
    for (const Move& m : moves) sum += m.travel ? distance(m.from.tip, m.to.tip) : 0;
    return sum;
}

// One or several consecutive travels: spans [first, last), after a stroke and usually before one.
struct TravelGap {
    std::size_t first, last;
    std::uint32_t before; // beads born earlier are obstacles
};

class Router {
  public:
    Router(std::vector<Span> spans, Things things, const Options& o, int threads)
        : o_(o), shapes_(o.machine.head), threads_(threads), spans_(std::move(spans)) {
        const collision::MoveReader walk = walked();
        job_.before = travelled(walk.growth.moves);
        if (o.bed) things[static_cast<std::size_t>(collision::Obstacle::bed)] = collision::bed(walk.growth.moves);
        for (std::size_t k = 0; k < scene_.size(); ++k) scene_[k] = collision::Tree(std::move(things[k]));
    }

    RoutedToolpath run() {
        if (o_.tilt.most > 0) tilt();
        route();
        collision::MoveReader walk = walked();
        set_beads(walk);
        job_.after = travelled(walk.growth.moves);
        job_.found = collision::check(scene_, o_.machine.head, walk.growth.moves, o_.check, threads_);
        job_.moves = std::move(walk.growth.moves);
        job_.spans = std::move(spans_);
        return std::move(job_);
    }

  private:
    [[nodiscard]] collision::MoveReader walked() const {
        collision::MoveReader walk(o_.machine);
        for (const Span& s : spans_) walk.add(s);
        return walk;
    }
    void set_beads(collision::MoveReader& walk) { scene_[0] = collision::Tree(std::move(walk.growth.beads)); }

    void route() {
        std::vector<TravelGap> gaps;
        collision::MoveReader walk(o_.machine);
        for (std::size_t i = 0; i < spans_.size(); ++i) {
            if (lays(spans_[i])) {
                walk.add(spans_[i]);
            } else if (i > 0 && !lays(spans_[i - 1]) && !gaps.empty()) {
                gaps.back().last = i + 1;
            } else if (!walk.growth.moves.empty()) {
                gaps.push_back({i, i + 1, static_cast<std::uint32_t>(walk.growth.beads.size())});
            }
        }
        set_beads(walk);
        collision::Options clear = o_.check; // a travel must not sink into beads
        clear.margin += clear.press;
        std::vector<Travel> ways(gaps.size());
        parallel::for_chunks(gaps.size(), 1, threads_, [&](std::size_t begin, std::size_t) {
            const TravelGap& gap = gaps[begin];
            const auto [from, to] = ends(gap);
            ways[begin] = travel(collision::Room(scene_, shapes_.of(spans_[gap.last - 1].tool), clear), from, to,
                                 gap.before, o_.travel);
        });
        replace(gaps, ways);
    }

    // The stances at which a travel begins and ends; the carriage's rotation is known as in collision::MoveReader.
    [[nodiscard]] std::pair<ToolFrame, ToolFrame> ends(const TravelGap& gap) const {
        const Span &a = spans_[gap.first - 1], &b = spans_[gap.last < spans_.size() ? gap.last : gap.last - 1];
        const std::size_t i = lays(b) ? 0 : b.points.size() - 1;
        const bool known = !o_.machine.rotary && a.normals.empty() && axis(b, i) == Vec3{0, 0, 1};
        const Vec3 side = known ? Vec3{1, 0, 0} : Vec3{};
        return {{a.points.back(), axis(a, a.points.size() - 1), side}, {b.points[i], axis(b, i), side}};
    }

    void replace(const std::vector<TravelGap>& gaps, const std::vector<Travel>& ways) {
        std::vector<Span> out;
        std::size_t at = 0;
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            for (; at < gaps[i].first; ++at) out.push_back(std::move(spans_[at]));
            Span span = std::move(spans_[at]);
            span.tool = spans_[gaps[i].last - 1].tool; // that of the bead that follows
            span.points.clear();
            span.normals.clear();
            for (const ToolFrame& s : ways[i].stances) {
                if (!span.points.empty() && span.points.back() == s.tip && span.normals.back() == s.axis &&
                    span.points.size() > 1)
                    continue;
                span.points.push_back(s.tip);
                span.normals.push_back(s.axis);
            }
            out.push_back(std::move(span));
            ++job_.kinds[static_cast<std::size_t>(ways[i].kind)];
            at = gaps[i].last;
        }
        for (; at < spans_.size(); ++at) out.push_back(std::move(spans_[at]));
        spans_ = std::move(out);
    }

    // Tilts the tool on strokes whose head collides; repeated while moves remain blocked.
    void tilt() {
        StrokeTilter all(spans_, o_.machine.rotary);
        const collision::Rooms rooms{scene_, shapes_, o_.check};
        for (std::size_t round = 0;; ++round) {
            collision::MoveReader walk = walked(); // the tilt displaces beads slightly
            set_beads(walk);
            const auto& moves = walk.growth.moves;
            const auto found = collision::check(scene_, o_.machine.head, moves, o_.check, threads_);
            if (!all.judge(moves, found, spans_, rooms) || round == kRounds.size()) break;
            const auto& [pace, more] = kRounds[round];
            all.lean({scene_, shapes_, o_.check, more}, o_.tilt, pace, threads_, spans_);
            if (more > 0) all.hope();
        }
        job_.leaning = all.best(spans_);
    }

    const Options& o_;
    const collision::Shapes shapes_;
    int threads_;
    std::vector<Span> spans_;
    collision::Scene scene_{collision::Tree({}), collision::Tree({}), collision::Tree({}), collision::Tree({})};
    RoutedToolpath job_;
};

} // namespace

RoutedToolpath route(std::vector<Span> spans, Things things, const Options& options, int threads) {
    return Router(std::move(spans), std::move(things), options, threads).run();
}

} // namespace filum::route
