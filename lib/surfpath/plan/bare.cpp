#include "surfpath/plan/bare.hpp"

#include "parallel/parallel.hpp"
#include "surfpath/plan/samples.hpp"
#include "surfpath/plan/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace filum::surfpath::plan {

namespace {

constexpr double kPart = 1.0 / 3;       // of the width, between points of a triangle
constexpr double kMissing = 0.01;       // of the surface: more is told aloud
constexpr double kTold = 0.04;          // likewise, of what is not covered, or laid twice
constexpr double kSought = 4;           // widths: up to where the widest place is sought
constexpr double kHeap = 3;             // widths: side of the cubes by which the thickest place is found
constexpr std::size_t kTriangles = 256; // of a piece of work
constexpr double kFar = std::numeric_limits<double>::infinity();

struct Sum {
    double surface = 0, covered = 0, missing = 0;
    std::vector<Sample> bare;
    struct Heap {
        double area = 0; // mm2, once for every pass but the first
        Vec3 at;         // of the first point
    };
    std::map<std::tuple<long, long, long>, Heap> heaps{}; // by cubes
};

// `about`: the stretches within half a width of the point, and others.
void look(const Sample& point, const Stretches& lines, std::span<const Stretch* const> about, double width, Sum& sum,
          std::vector<double>& ways) {
    sum.surface += point.area;
    ways.clear();
    for (const Stretch* l : about)
        if (within(*l, point.p, width / 2)) ways.push_back(way(*l, beside(*l, point.p).t));
    if (!ways.empty())
        sum.covered += point.area;
    else {
        sum.bare.push_back(point);
        bool missing = true;
        lines.near(point.p, point.normal, width, [&](const Stretch&, double) { missing = false; });
        if (missing) sum.missing += point.area;
    }
    if (const std::size_t n = passes(ways, width); n > 1) {
        const auto cell = [&](double v) { return std::lround(v / (kHeap * width)); };
        auto& heap =
            sum.heaps.insert({{cell(point.p.x), cell(point.p.y), cell(point.p.z)}, {0, point.p}}).first->second;
        heap.area += static_cast<double>(n - 1) * point.area;
    }
}

void add(const Sum& part, Sum& sum) {
    sum.surface += part.surface;
    sum.covered += part.covered;
    sum.missing += part.missing;
    sum.bare.insert(sum.bare.end(), part.bare.begin(), part.bare.end());
    for (const auto& [cell, heap] : part.heaps) sum.heaps.insert({cell, {0, heap.at}}).first->second.area += heap.area;
}

Vec3 widest(const std::vector<Sample>& bare, const Stretches& lines, double width) {
    double worst = -1;
    Vec3 at;
    for (const Sample& b : bare) {
        double least = kFar;
        for (double reach = width; least == kFar && reach <= kSought * width; reach *= 2)
            lines.near(b.p, b.normal, reach, [&](const Stretch&, double off) { least = std::min(least, off); });
        if (least > worst) {
            worst = least;
            at = b.p;
        }
        if (worst == kFar) break;
    }
    return at;
}

// The length, mm, that lies on the first `part` triangles; of a threaded plan, or if they are all.
double laid_on(const Plan& plan, std::uint32_t part) {
    double out = 0;
    for (const Stroke& stroke : plan.strokes)
        for (const Piece& piece : stroke.pieces)
            for (std::size_t i = 0; i + 1 < piece.line.size(); ++i)
                if (piece.line.places[i].triangle < part) out += distance(piece.line[i], piece.line[i + 1]);
    return out;
}

Note noted(NoteCode code, double area, const Vec3& at) { return {code, area, 1, -1, at.x, at.y, at.z}; }

} // namespace

Cover cover(const Surface& s, const Plan& plan, double width, std::uint32_t part) {
    const Stretches lines(s, plan);
    const std::size_t count = std::min<std::size_t>(part, s.triangles.size());
    std::vector<Sum> parts((count + kTriangles - 1) / kTriangles);
    parallel::for_chunks(count, kTriangles, 0, [&](std::size_t begin, std::size_t end) {
        std::vector<double> ways;
        std::vector<Sample> room;
        std::vector<const Stretch*> about;
        for (std::size_t t = begin; t < end; ++t)
            each_few(s, static_cast<std::uint32_t>(t), kPart * width, room, [&](std::span<const Sample> few) {
                lines.about(geom::grown(box_of(few), width / 2), few[0].normal, about);
                for (const Sample& p : few) look(p, lines, about, width, parts[begin / kTriangles], ways);
            });
    });
    Sum sum;
    for (const Sum& one : parts) add(one, sum);
    Cover out{sum.surface, laid_on(plan, part) * width, sum.covered, sum.missing, {}, {}};
    out.widest = widest(sum.bare, lines, width);
    double most = 0;
    for (const auto& [cell, heap] : sum.heaps)
        if (heap.area > most) {
            most = heap.area;
            out.thickest = heap.at;
        }
    return out;
}

void tell_cover(const Surface& s, Plan& plan, double width, std::uint32_t part) {
    const Cover c = cover(s, plan, width, part);
    plan.facts.push_back({"", "bare", c.missing, "mm2"});
    plan.facts.push_back({"", "uncovered", c.bare(), "mm2"});
    plan.facts.push_back({"", "laid-twice", c.overlap(), "mm2"});
    if (c.missing > kMissing * c.surface) plan.notes.push_back(noted(NoteCode::no_line_near, c.missing, c.widest));
    if (c.bare() > kTold * c.surface) plan.notes.push_back(noted(NoteCode::area_bare, c.bare(), c.widest));
    if (c.overlap() > kTold * c.surface) plan.notes.push_back(noted(NoteCode::area_doubled, c.overlap(), c.thickest));
}

} // namespace filum::surfpath::plan
