#include "baselines/kipping2022/spiral.hpp"

#include "base/error.hpp"
#include "baselines/kipping2022/path.hpp"
#include "geom/point_tree.hpp"

#include <algorithm>

namespace filum::baselines::kipping2022 {

namespace {

using surfpath::plan::Plan;

// The seed point: a vertex, or a segment without length.
Vec3 seed(const surface::Sheet& sheet) {
    const auto& [vertices, segments] = sheet.sources;
    if (vertices.size() + segments.size() == 1) {
        if (!vertices.empty()) return sheet.surface.vertices[vertices[0]];
        if (segments[0].a == segments[0].b) return segments[0].a;
    }
    throw Error(Exit::usage, "a spiral needs exactly one seed point; run geodesic --source point:X,Y,Z first");
}

geom::PointTree rim_vertices(const Surface& s) {
    Points out;
    for (const surface::Rim& rim : s.rims)
        for (const std::uint32_t h : rim.sides) out.push_back(s.vertices[s.tail(h)]);
    return geom::PointTree(std::move(out));
}

class Spiral {
  public:
    Spiral(const Surface& s, const Vec3& seed, const Options& o)
        : rims_(rim_vertices(s)), o_(o), place_(seed), begin_(seed) {}

    void add(const Contour& c) {
        Points points = resampled(c.points, c.closed, o_.resample);
        if (c.closed)
            open(points);
        else if (opened_ ? !forwards_ : distance(place_, points.back()) < distance(place_, points.front()))
            std::reverse(points.begin(), points.end());
        if (!c.closed) follow(c, points);
        path.insert(path.end(), points.begin(), points.end());
        place_ = path.back();
    }

    Points path;

  private:
    // Starts the closed contour at its start, without the points before that.
    void open(Points& points) {
        std::size_t start = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double d = opened_                  ? distance(place_, points[i])
                             : rims_.points().empty() ? distance(begin_, points[i])
                                                      : rims_.nearest(points[i], least).distance;
            if (d < least) {
                least = d;
                start = i;
            }
        }
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start), points.end());
        begin_ = points.front();
        points.resize(points.size() - std::min(static_cast<std::size_t>(o_.run), points.size() / 2));
    }

    // Records the direction of an open contour: isolines of one field side by side have the same direction.
    void follow(const Contour& c, const Points& points) {
        opened_ = true;
        forwards_ = distance(points.front(), c.points.front()) > distance(points.front(), c.points.back());
    }

    geom::PointTree rims_;
    const Options& o_;
    Vec3 place_, begin_;
    bool opened_ = false, forwards_ = true; // of open contours: direction of the next one
};

} // namespace

Plan geo_spiral(const surface::Sheet& sheet, const Options& o) {
    const auto& phi = distances(sheet, "run geodesic --source point:X,Y,Z first");
    Plan plan;
    Spiral spiral(sheet.surface, seed(sheet), o);
    note_unreached(sheet.surface, phi, plan.notes);
    const auto levels = contours(sheet.surface, phi, o.spacing, o.resample, plan.notes);
    if (levels.empty())
        throw Error(Exit::usage, "there is no spiral: no place is a spacing away from the seed; lower --spacing");
    std::size_t laid = 0;
    while (laid < levels.size() && levels[laid].size() == 1) spiral.add(levels[laid++][0]);
    for (std::size_t i = laid; i < levels.size(); ++i)
        for (const Contour& c : levels[i])
            plan.notes.push_back(lines_note(NoteCode::isocontour_beyond, length(c.points, c.closed), c.points[0]));
    Strokes(sheet.surface, o).lay(spiral.path, plan);
    plan.facts = {{"", "levels", static_cast<double>(levels.size()), ""},
                  {"", "levels-laid", static_cast<double>(laid), ""},
                  {"", "n-thresh", static_cast<double>(o.run), "points"}};
    return plan;
}

} // namespace filum::baselines::kipping2022
