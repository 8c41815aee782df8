#include "surfpath/plan/coverage.hpp"

#include "parallel/parallel.hpp"
#include "surfpath/plan/path_segments.hpp"
#include "surfpath/plan/samples.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace filum::surfpath::plan {

namespace {

constexpr double kPart = 1.0 / 3; // widths between sample points: rules::kGrain takes 6 % more time for a whole path
constexpr double kTold = 0.04;    // share of the surface above which voids, or overlap, are reported in a note

struct CoverageSums {
    double surface = 0, covered = 0, missing = 0;
    std::vector<Sample> voids;
    struct OverlapCell {
        double area = 0; // mm2, counted for every pass after the first
        Vec3 at;         // of the first point
    };
    std::map<std::tuple<long, long, long>, OverlapCell> cells{}; // by cube
};

// Adds one sample point.  `about`: path segments, among them all within half a width of the point.
void judge(const Sample& point, const PathSegments& lines, std::span<const PathSegment* const> in_box, double width,
           CoverageSums& sum, std::vector<double>& arcs) {
    sum.surface += point.area;
    arcs.clear();
    for (const PathSegment* l : in_box)
        if (within(*l, point.p, (l->width > 0 ? l->width : width) / 2))
            arcs.push_back(arc(*l, nearest_place(*l, point.p).t));
    if (!arcs.empty())
        sum.covered += point.area;
    else {
        sum.voids.push_back(point);
        bool missing = true;
        lines.near(point.p, point.normal, width, [&](const PathSegment&, double) { missing = false; });
        if (missing) sum.missing += point.area;
    }
    if (const std::size_t n = passes(arcs, width); n > 1) {
        const auto cell = [&](double v) { return std::lround(v / (rules::kBeside * width)); };
        auto& cell_overlap =
            sum.cells.insert({{cell(point.p.x), cell(point.p.y), cell(point.p.z)}, {0, point.p}}).first->second;
        cell_overlap.area += static_cast<double>(n - 1) * point.area;
    }
}

void add(const CoverageSums& part, CoverageSums& sum) {
    sum.surface += part.surface;
    sum.covered += part.covered;
    sum.missing += part.missing;
    sum.voids.insert(sum.voids.end(), part.voids.begin(), part.voids.end());
    for (const auto& [cell, cell_overlap] : part.cells)
        sum.cells.insert({cell, {0, cell_overlap.at}}).first->second.area += cell_overlap.area;
}

double widest_bead(const Plan& plan, double width) {
    double out = width;
    for (const Stroke& stroke : plan.strokes)
        for (const Section& piece : stroke.sections)
            for (const double w : piece.widths) out = std::max(out, w);
    return out;
}

Vec3 widest_void(const std::vector<Sample>& voids, const PathSegments& lines, double width) {
    double worst = -1;
    Vec3 at;
    for (const Sample& b : voids) {
        double least = std::numeric_limits<double>::infinity();
        for (double reach = width; std::isinf(least) && reach <= rules::kBeside * width; reach *= 2)
            lines.near(b.p, b.normal, reach, [&](const PathSegment&, double off) { least = std::min(least, off); });
        if (least > worst) {
            worst = least;
            at = b.p;
        }
        if (std::isinf(worst)) break;
    }
    return at;
}

// Area in mm2 of the beads on the first `part` triangles. The plan must be threaded unless these are all.
double deposited_on(const Plan& plan, double width, std::uint32_t part) {
    double out = 0;
    for (const Stroke& stroke : plan.strokes)
        for (const Section& piece : stroke.sections)
            for (std::size_t i = 0; i + 1 < piece.line.size(); ++i)
                if (piece.line.places[i].triangle < part)
                    out += distance(piece.line[i], piece.line[i + 1]) *
                           (piece.widths.empty() ? width : (piece.widths[i] + piece.widths[i + 1]) / 2);
    return out;
}

Note note(NoteCode code, double area, const Vec3& at) { return {code, area, 1, -1, at.x, at.y, at.z}; }

} // namespace

Coverage cover(const Surface& s, const Plan& plan, double width, std::uint32_t part) {
    const PathSegments lines(s, plan);
    const double widest = widest_bead(plan, width);
    const std::size_t count = std::min<std::size_t>(part, s.triangles.size());
    std::vector<CoverageSums> parts((count + rules::kTrianglesAtOnce - 1) / rules::kTrianglesAtOnce);
    parallel::for_chunks(count, rules::kTrianglesAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        std::vector<double> arcs;
        std::vector<Sample> room;
        std::vector<const PathSegment*> in_box;
        for (std::size_t t = begin; t < end; ++t)
            each_few(s, static_cast<std::uint32_t>(t), kPart * width, room, [&](std::span<const Sample> few) {
                lines.in_box(geom::grown(box_of(few), widest / 2), few[0].normal, in_box);
                for (const Sample& p : few)
                    judge(p, lines, in_box, width, parts[begin / rules::kTrianglesAtOnce], arcs);
            });
    });
    CoverageSums sum;
    for (const CoverageSums& one : parts) add(one, sum);
    Coverage out{sum.surface, deposited_on(plan, width, part), sum.covered, sum.missing, {}, {}};
    out.widest = widest_void(sum.voids, lines, width);
    double most = 0;
    for (const auto& [cell, cell_overlap] : sum.cells)
        if (cell_overlap.area > most) {
            most = cell_overlap.area;
            out.thickest = cell_overlap.at;
        }
    return out;
}

void report_coverage(const Surface& s, Plan& plan, double width, std::uint32_t part) {
    const Coverage c = cover(s, plan, width, part);
    plan.facts.push_back({"", "bare", c.missing, "mm2"});
    plan.facts.push_back({"", "uncovered", c.voids(), "mm2"});
    plan.facts.push_back({"", "laid-twice", c.overlap(), "mm2"});
    if (c.missing > rules::kNegligible * c.surface)
        plan.notes.push_back(note(NoteCode::no_line_near, c.missing, c.widest));
    if (c.voids() > kTold * c.surface) plan.notes.push_back(note(NoteCode::area_bare, c.voids(), c.widest));
    if (c.overlap() > kTold * c.surface) plan.notes.push_back(note(NoteCode::area_doubled, c.overlap(), c.thickest));
}

} // namespace filum::surfpath::plan
