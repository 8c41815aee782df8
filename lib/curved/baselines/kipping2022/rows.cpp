#include "baselines/kipping2022/rows.hpp"

#include "base/error.hpp"
#include "baselines/kipping2022/contours.hpp"
#include "baselines/kipping2022/path.hpp"
#include "baselines/kipping2022/seed.hpp"

#include <algorithm>
#include <numeric>

namespace filum::baselines::kipping2022 {

namespace {

using surface::Plane;
using surfpath::plan::Plan;

constexpr const char* kNeedsPlane = "run geodesic --source plane:NX,NY,NZ,D first";

Plane seed_plane(const surface::Sheet& sheet, const Options& o) {
    if (o.plane) return *o.plane;
    const auto found = plane_of(sheet.surface, sheet.sources);
    if (!found)
        throw Error(Exit::usage, "the sides of the seed curve are undefined: the sources are not in a plane; "
                                 "give --plane NX,NY,NZ,D");
    return *found;
}

// The direction of greatest extent of the section of the surface with the plane.
Vec3 direction(const Surface& s, const Plane& plane) {
    const auto cut = surface::section(s, plane);
    if (cut.empty()) throw Error(Exit::usage, "--plane does not meet the surface");
    const auto farthest = [&](const Vec3& from) {
        Vec3 best = from;
        for (const auto& segment : cut)
            for (const Vec3& p : {segment.a, segment.b})
                if (distance(from, p) > distance(from, best)) best = p;
        return best;
    };
    const Vec3 one = farthest(cut.front().a), way = farthest(one) - one;
    return geom::unit(way, {1, 0, 0});
}

// Sorts the pieces of a level along `axis` and directs each along it.
void arrange(std::vector<Contour>& level, const Vec3& axis) {
    for (Contour& c : level)
        if (!c.closed && dot(c.points.back() - c.points.front(), axis) < 0)
            std::reverse(c.points.begin(), c.points.end());
    const auto middle = [&](const Contour& c) { return dot(c.points[c.points.size() / 2], axis); };
    std::stable_sort(level.begin(), level.end(),
                     [&](const Contour& a, const Contour& b) { return middle(a) < middle(b); });
}

// Opens a closed piece at its point nearest to `from`.
void open(Contour& c, const Vec3& from) {
    if (!c.closed) return;
    const auto nearest = std::min_element(c.points.begin(), c.points.end(), [&](const Vec3& a, const Vec3& b) {
        return distance(from, a) < distance(from, b);
    });
    std::rotate(c.points.begin(), nearest, c.points.end());
    c.points.push_back(c.points.front());
}

// The rows of a half, back and forth from the seed curve outwards; rows without a travel in between are one line.
std::vector<Points> half(std::vector<std::vector<Contour>> levels, const Vec3& axis) {
    std::vector<Points> out;
    bool back = false;
    for (auto& level : levels) {
        arrange(level, axis);
        if (back) std::reverse(level.begin(), level.end());
        for (std::size_t i = 0; i < level.size(); ++i) {
            Contour& piece = level[i];
            if (back) std::reverse(piece.points.begin(), piece.points.end());
            if (!out.empty())
                open(piece, out.back().back());
            else
                open(piece, piece.points.front());
            if (i > 0 || out.empty()) out.emplace_back();
            out.back().insert(out.back().end(), piece.points.begin(), piece.points.end());
        }
        back = !back;
    }
    return out;
}

Plan rows(const Surface& s, std::vector<double> values, const Plane& plane, const Options& o) {
    Plan plan;
    note_unreached(s, values, plan.notes);
    const Vec3 axis = direction(s, plane);
    std::size_t pieces = 0, levels = 0;
    const auto lay = [&] {
        auto lines = contours(s, values, o.spacing, o.resample, plan.notes);
        levels += lines.size();
        for (const auto& level : lines) pieces += level.size();
        return half(std::move(lines), axis);
    };
    std::vector<Points> one = lay();
    for (double& v : values) v = -v;
    std::vector<Points> other = lay();
    if (one.empty() && other.empty())
        throw Error(Exit::usage, "there is no row: no place is a spacing away from the plane; lower --spacing");
    std::reverse(one.begin(), one.end());
    for (Points& p : one) std::reverse(p.begin(), p.end());
    if (!one.empty() && !other.empty()) {
        one.back().insert(one.back().end(), other.front().begin(), other.front().end());
        other.erase(other.begin());
    }
    one.insert(one.end(), other.begin(), other.end());
    const Strokes strokes(s, o);
    for (const Points& p : one) strokes.lay(p, plan);
    plan.facts = {{"", "levels", static_cast<double>(levels), ""}, {"", "pieces", static_cast<double>(pieces), ""}};
    return plan;
}

} // namespace

Plan fina(const surface::Sheet& sheet, const Options& o) {
    const auto& phi = distances(sheet, kNeedsPlane);
    const Plane plane = seed_plane(sheet, o);
    const auto values = signed_distances(sheet.surface, phi, plane, o.spacing);
    if (!values)
        throw Error(Exit::usage,
                    "the plane does not separate the sides of the seed curve: it meets the surface where the "
                    "distance is not 0; give another --plane");
    return rows(sheet.surface, *values, plane, o);
}

Plan fexa(const surface::Sheet& sheet, const Options& o) {
    const Plane plane = seed_plane(sheet, o);
    return rows(sheet.surface, surface::sides(sheet.surface, plane), plane, o);
}

} // namespace filum::baselines::kipping2022
