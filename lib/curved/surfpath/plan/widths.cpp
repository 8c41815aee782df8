#include "surfpath/plan/widths.hpp"

#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/plan/path_segments.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath::plan {

namespace {

namespace curve = surface::curve;

constexpr double kOnSide = 0.5; // sine of the least angle between a line and the way to what lies beside it

class WidthFitter {
  public:
    WidthFitter(const Surface& s, const Plan& plan, const WidthOptions& o)
        : s_(s), o_(o), normals_(curve::vertex_normals(s)), lines_(s, plan), rim_(s, rims(s)) {}

    // `arc`: mm of the section's start along the path, as PathSegment counts.
    void fit(Section& section, double arc) const {
        Line out;
        std::vector<double> widths;
        std::vector<char> given;
        const Line& line = section.line;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const bool last = i + 1 == line.size();
            const Vec3 way = last ? line[i] - line[i - 1] : line[i + 1] - line[i];
            const double length = norm(way);
            const int n = last ? 1 : static_cast<int>(std::max(1.0, std::ceil(length / (rules::kGrain * o_.spacing))));
            for (int k = 0; k < n; ++k) {
                const double part = last ? 0 : static_cast<double>(k) / n;
                const Place p{line.places[i].triangle, line[i] + part * way};
                out.places.push_back(p);
                widths.push_back(length > 0 ? width(p, way, arc + part * length) : o_.spacing);
                given.push_back(k == 0 ? 1 : 0);
            }
            if (!last) arc += length;
        }
        keep_needed(out, widths, given, section);
    }

  private:
    // All rims as strokes.
    static Plan rims(const Surface& s) {
        Plan out;
        for (const auto& rim : s.rims) {
            Stroke stroke;
            for (const std::uint32_t h : rim.sides) {
                const Line side{{{h / 3, s.vertices[s.tail(h)]}, {h / 3, s.vertices[s.head(h)]}}, false};
                stroke.sections.push_back({side, false, {}});
            }
            out.strokes.push_back(std::move(stroke));
        }
        return out;
    }

    [[nodiscard]] double width(const Place& p, const Vec3& way, double arc) const {
        const Vec3 n = curve::normal_at(s_, normals_, p), left = geom::unit(cross(n, way), {});
        const double most = (1 + o_.change) * o_.spacing / 2;
        double room[2] = {most, most};
        const auto look = [&](const PathSegment& l, double share) {
            const Vec3 to = l.a + nearest_place(l, p.point).t * (l.b - l.a) - p.point;
            const double far = norm(to), side = dot(to, left);
            if (std::abs(side) < kOnSide * far) return;
            double& here = room[side > 0 ? 0 : 1];
            here = std::min(here, share * far);
        };
        lines_.near(p.point, n, 2 * most, [&](const PathSegment& l, double) {
            if (std::abs(plan::arc(l, nearest_place(l, p.point).t) - arc) > rules::kHalfTurn * o_.spacing) look(l, 0.5);
        });
        rim_.near(p.point, n, most, [&](const PathSegment& l, double) { look(l, 1); });
        const double least = (1 - o_.change) * o_.spacing;
        const double wide = std::max(least, room[0] + room[1]);
        return curve::kRipple * o_.spacing * std::round(wide / (curve::kRipple * o_.spacing));
    }

    // Leaves out places that were added where the width does not change.
    void keep_needed(const Line& line, std::span<const double> widths, std::span<const char> given,
                     Section& section) const {
        section.line.places.clear();
        section.widths.clear();
        for (std::size_t i = 0; i < line.size(); ++i) {
            const bool needed = given[i] != 0 || i + 1 == line.size() ||
                                std::abs(widths[i] - section.widths.back()) > curve::kRipple / 2 * o_.spacing ||
                                std::abs(widths[i] - widths[i + 1]) > curve::kRipple / 2 * o_.spacing;
            if (!needed) continue;
            section.line.places.push_back(line.places[i]);
            section.widths.push_back(widths[i]);
        }
    }

    const Surface& s_;
    const WidthOptions& o_;
    std::vector<Vec3> normals_;
    PathSegments lines_, rim_;
};

} // namespace

void fit_widths(const Surface& s, Plan& plan, const WidthOptions& o) {
    const WidthFitter fitter(s, plan, o);
    double arc = 0;
    for (Stroke& stroke : plan.strokes) {
        for (Section& section : stroke.sections) {
            const double length = curve::length(section.line);
            if (section.line.size() >= 2) fitter.fit(section, arc);
            arc += length;
        }
        arc += kStrokesApart;
    }
}

} // namespace filum::surfpath::plan
