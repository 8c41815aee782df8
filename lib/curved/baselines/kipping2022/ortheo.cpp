#include "baselines/kipping2022/ortheo.hpp"

#include "base/error.hpp"
#include "baselines/kipping2022/path.hpp"
#include "baselines/kipping2022/seed.hpp"
#include "geom/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::baselines::kipping2022 {

namespace {

using surfpath::plan::Plan;

constexpr double kFarthest = 2; // d_iso: largest step to the next isocontour
constexpr double kNoise = 0.01; // d: tolerance of spacings

// The isocontours of one level, with a search for the closest points on them.
class Level {
  public:
    Level(const std::vector<Contour>& pieces, double step) : cloud_(all(pieces, step)), step_(step) {}

    struct ClosestPoint {
        Vec3 point;
        double distance = std::numeric_limits<double>::infinity();
    };
    [[nodiscard]] ClosestPoint closest(const Vec3& p, double reach) const {
        const auto near = cloud_.nearest(p, reach);
        if (near.index == surface::kNone) return {};
        const auto& points = cloud_.points();
        ClosestPoint out{points[near.index], near.distance};
        for (const std::uint32_t to : {before_[near.index], after_[near.index]}) {
            const Vec3 way = points[to] - points[near.index];
            const double l2 = dot(way, way), f = l2 > 0 ? dot(p - points[near.index], way) / l2 : 0;
            if (!(f > 0)) continue;
            const Vec3 q = points[near.index] + std::min(f, 1.0) * way;
            if (distance(p, q) < out.distance) {
                out.point = q;
                out.distance = distance(p, q);
            }
        }
        return out;
    }
    void mark(const Vec3& p) { lines_.push_back(p); }

    // A note if parts of the level are farther than `reach` from every line that ends here.
    [[nodiscard]] std::optional<Note> bare(double reach) {
        const geom::PointTree lines(std::move(lines_));
        const auto far = [&](const Vec3& p) { return lines.nearest(p, reach).index == surface::kNone; };
        const auto n = std::count_if(cloud_.points().begin(), cloud_.points().end(), far);
        if (n == 0) return {};
        return lines_note(NoteCode::isocontours_far, static_cast<double>(n) * step_,
                          *std::find_if(cloud_.points().begin(), cloud_.points().end(), far));
    }

  private:
    Points all(const std::vector<Contour>& pieces, double step) {
        Points out;
        for (std::uint32_t k = 0; k < pieces.size(); ++k) {
            const Points even = resampled(pieces[k].points, pieces[k].closed, step);
            const auto first = static_cast<std::uint32_t>(out.size()), n = static_cast<std::uint32_t>(even.size());
            for (std::uint32_t i = 0; i < n; ++i) {
                const bool closed = pieces[k].closed;
                before_.push_back(first + (i > 0 ? i - 1 : closed ? n - 1 : 0));
                after_.push_back(first + (i + 1 < n ? i + 1 : closed ? 0 : i));
            }
            out.insert(out.end(), even.begin(), even.end());
        }
        return out;
    }

    std::vector<std::uint32_t> before_, after_; // per point
    geom::PointTree cloud_;
    double step_;
    Points lines_;
};

// The lines that grow from one seed line, side by side.
class LineFamily {
  public:
    LineFamily(const SeedLine& seed, const Options& o) : closed_(seed.closed), o_(o) {
        const double l = length(seed.points, seed.closed);
        const auto n = static_cast<std::size_t>(std::ceil(l / o.spacing - 1e-9));
        double before = 0;
        std::size_t i = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const double way = static_cast<double>(k) * o.spacing;
            const auto stretch = [&] { return distance(seed.points[i], seed.points[(i + 1) % seed.points.size()]); };
            while (before + stretch() < way && i + 2 < seed.points.size() + (seed.closed ? 1 : 0)) {
                before += stretch();
                ++i;
            }
            const double f = stretch() > 0 ? std::min(1.0, (way - before) / stretch()) : 0;
            row_.push_back(static_cast<std::uint32_t>(lines.size()));
            lines.push_back({seed.points[i] + f * (seed.points[(i + 1) % seed.points.size()] - seed.points[i])});
        }
    }

    // Extends the lines to the next isocontour; new lines start there if it is not the last.
    void grow(Level& level, bool last) {
        std::vector<std::uint32_t> left;
        for (const std::uint32_t j : row_) {
            const auto found = level.closest(lines[j].back(), kFarthest * o_.iso);
            const bool near = std::isfinite(found.distance);
            const auto crowds = [&](std::uint32_t k) {
                return distance(lines[k].back(), found.point) < o_.least_spacing;
            };
            if (!near || (!left.empty() && crowds(left.back())) ||
                (closed_ && left.size() > 1 && crowds(left.front()))) {
                ++ended;
                continue;
            }
            level.mark(found.point);
            lines[j].push_back(found.point);
            left.push_back(j);
        }
        row_ = std::move(left);
        if (!last) insert(level);
    }

    std::vector<Points> lines; // in the order of their first points
    std::size_t inserted = 0, ended = 0;

  private:
    void insert(Level& level) {
        std::vector<std::uint32_t> out;
        for (std::size_t i = 0; i < row_.size(); ++i) {
            out.push_back(row_[i]);
            if (i + 1 == row_.size() && (!closed_ || row_.size() < 3)) continue;
            const Vec3 a = lines[row_[i]].back(), b = lines[row_[(i + 1) % row_.size()]].back();
            if (!(distance(a, b) > (1 + kNoise) * o_.spacing)) continue;
            const auto found = level.closest(0.5 * (a + b), distance(a, b));
            if (!std::isfinite(found.distance) || distance(found.point, a) < o_.least_spacing ||
                distance(found.point, b) < o_.least_spacing)
                continue;
            level.mark(found.point);
            out.push_back(static_cast<std::uint32_t>(lines.size()));
            lines.push_back({found.point});
            ++inserted;
        }
        row_ = std::move(out);
    }

    bool closed_;
    const Options& o_;
    std::vector<std::uint32_t> row_; // growing lines, in the order of the seed line
};

// phi on either side of the sources' plane if that separates the surface, otherwise phi.
std::vector<std::vector<double>> halves(const surface::Sheet& sheet, const std::vector<double>& phi, const Options& o) {
    const auto plane = o.plane ? o.plane : plane_of(sheet.surface, sheet.sources);
    auto one = plane ? signed_distances(sheet.surface, phi, *plane, o.spacing) : std::nullopt;
    if (!one) return {phi};
    std::vector<double> other = *one;
    for (double& v : other) v = -v;
    return {std::move(*one), std::move(other)};
}

} // namespace

Plan ortheo(const surface::Sheet& sheet, const Options& o) {
    const auto& phi = distances(sheet, "run geodesic --source-lines FILE, or --source plane:NX,NY,NZ,D, first");
    const auto seeds = seed_lines(sheet.sources);
    if (seeds.empty())
        throw Error(Exit::bad_input, "cannot grow lines without a seed curve: the sources are points; run geodesic "
                                     "--source-lines FILE, or --source plane:NX,NY,NZ,D, first");
    Plan plan;
    note_unreached(sheet.surface, phi, plan.notes);
    const Strokes strokes(sheet.surface, o);
    std::size_t inserted = 0, ended = 0, levels = 0;
    for (const auto& values : halves(sheet, phi, o)) {
        const auto lines = contours(sheet.surface, values, o.iso, o.resample, plan.notes);
        if (lines.empty()) continue;
        levels += lines.size();
        std::vector<LineFamily> all;
        for (const SeedLine& seed : seeds) all.emplace_back(seed, o);
        for (const auto& pieces : lines) {
            Level level(pieces, o.resample);
            for (LineFamily& strands : all) strands.grow(level, &pieces == &lines.back());
            if (const auto note = level.bare(o.spacing)) plan.notes.push_back(*note);
        }
        for (const LineFamily& strands : all) {
            inserted += strands.inserted;
            ended += strands.ended;
            for (const Points& line : strands.lines)
                if (line.size() > 1) strokes.lay(line, plan);
        }
    }
    if (levels == 0)
        throw Error(Exit::usage, "there is no line: no place is a step away from the seed curve; lower --d-iso");
    plan.facts = {{"", "levels", static_cast<double>(levels), ""},
                  {"", "insertions", static_cast<double>(inserted), "lines"},
                  {"", "endings", static_cast<double>(ended), "lines"},
                  {"", "d-iso", o.iso, "mm"},
                  {"", "least-spacing", o.least_spacing, "mm"}};
    return plan;
}

} // namespace filum::baselines::kipping2022
