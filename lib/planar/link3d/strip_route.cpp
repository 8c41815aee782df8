#include "link3d/strip_route.hpp"

#include "geom/polyline.hpp"
#include "geom/segment.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>

namespace filum::link3d {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using FaceInfo = std::array<int, 3>; // number of the side opposite to each vertex, -1: none yet
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Face = Triangulation::Face_handle;

constexpr int kNone = -1;

// A side of a triangle that a path may pass through: its middle, and the shortest way to it.
struct Door {
    Vec2 middle;
    Face face; // one of the two at the side
    int side = 0;
    double half = 0;      // mm, from the middle to the ends of the side, which lie on lines
    double clear = -1;    // mm, from the middle to the nearest line; negative: not measured yet
    double beyond_bead{}; // mm, from the middle to the bead of that line; negative: within it
    double length = std::numeric_limits<double>::infinity();
    int before = kNone;
    bool done = false;

    void forget_ways() {
        length = std::numeric_limits<double>::infinity();
        before = kNone;
        done = false;
    }
};

constexpr double kPointRounding = 1e-9; // mm; more than the rounding of a point on a line

constexpr double kMostPieces = 1e6; // of a region's lines: 0.1 m2 of beads 0.4 mm wide; beyond, pieces are longer

constexpr double kVoidParts = 10; // the least step along a line is this part of the void that may be crossed

// The width of the widest bead, mm.
double widest(std::span<const toolpath::Curve> curves) {
    double out = 0;
    for (const auto& curve : curves)
        for (std::size_t i = 0; i < curve.points.size(); ++i) out = std::max(out, curve.width_at(i));
    return out;
}

Vec2 vec(const Point& p) { return {p.x(), p.y()}; }

// The lines, split into pieces of at most `step` mm, so that there is a door about every `step` mm. Line k has the
// points start[k] to start[k + 1].
struct Pieces {
    std::vector<Point> points;
    std::vector<std::size_t> start;
};

Pieces pieces(std::span<const std::vector<Vec2>> lines, double step) {
    Pieces out;
    for (const auto& line : lines) {
        out.start.push_back(out.points.size());
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (i > 0 && line[i] == line[i - 1]) continue;
            const double pieces = i > 0 ? std::ceil(geom::distance(line[i - 1], line[i]) / step) : 1;
            for (double k = 1; k < pieces; ++k) {
                const Vec2 p = geom::lerp(line[i - 1], line[i], k / pieces);
                out.points.emplace_back(p.x, p.y);
            }
            out.points.emplace_back(line[i].x, line[i].y);
        }
    }
    out.start.push_back(out.points.size());
    return out;
}

// Inserts all points before the lines, in random order by larger and larger shares, each along a space-filling curve.
// In the order of a long straight line, each point would flip the triangles of all points before it, or search through
// them. That would take O(n^2) time.
Triangulation triangulate(const Pieces& lines) {
    Triangulation t;
    const auto place = CGAL::make_property_map(lines.points);
    std::vector<std::size_t> order(lines.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(place)>(place, Kernel()));
    std::vector<Triangulation::Vertex_handle> vertex(order.size());
    Face near;
    for (const std::size_t i : order) {
        vertex[i] = t.insert(lines.points[i], near);
        near = vertex[i]->face();
    }
    for (std::size_t k = 0; k + 1 < lines.start.size(); ++k)
        for (std::size_t i = lines.start[k] + 1; i < lines.start[k + 1]; ++i)
            if (vertex[i - 1] != vertex[i]) t.insert_constraint(vertex[i - 1], vertex[i]);
    return t;
}

// Searches from door to door, nearest first (Dijkstra). The distances from doors to lines stay for further searches.
class Search {
  public:
    Search(Triangulation& t, std::span<const toolpath::Curve> curves, const SegmentIndex& index,
           const SegmentCells& cells, Vec2 from, double width)
        : t_(t), curves_(curves), index_(index), cells_(cells), from_(from), void_(kMostVoid * width),
          widest_(widest(curves)),
          begin_(t.insert(Point(from.x, from.y))) { // a vertex already, if `from` is a point of a line
        for (Face f : t_.all_face_handles()) f->info() = {kNone, kNone, kNone};
    }

    // `narrow` and `beyond` as in Strips, in mm.
    std::optional<std::vector<Vec2>> run(double narrow, double beyond, int best,
                                         const std::function<int(Vec2, int)>& rank) {
        narrow_ = narrow;
        beyond_ = beyond;
        open_ = {};
        for (Door& door : doors_) door.forget_ways();
        start();
        int reached = 0, end = kNone;
        while (!open_.empty() && reached < best) {
            const auto [length, at] = open_.top();
            open_.pop();
            auto& door = doors_[static_cast<std::size_t>(at)];
            if (door.done) continue;
            door.done = true;
            const Face face = door.face;
            const int side = door.side;
            const Vec2 middle = door.middle;
            if (const int r = rank(middle, reached + 1); r > reached) {
                reached = r;
                end = at;
            }
            for (const Face f : {face, face->neighbor(side)})
                if (!t_.is_infinite(f)) spread(f, at, middle, length);
        }
        if (end == kNone) return std::nullopt;
        return trace(end);
    }

  private:
    void start() {
        auto f = t_.incident_faces(begin_), end = f;
        if (f == nullptr) return;
        do {
            if (!t_.is_infinite(f)) spread(f, kNone, from_, 0);
        } while (++f != end);
    }

    void spread(Face f, int before, Vec2 from, double length) {
        for (int side = 0; side < 3; ++side) {
            const int at = door(f, side);
            if (at == kNone || at == before) continue;
            auto& d = doors_[static_cast<std::size_t>(at)];
            const double step = geom::distance(from, d.middle), l = length + step;
            if (d.done || l >= d.length) continue;
            if (!may_step(before, from, d, step)) continue;
            d.length = l;
            d.before = before;
            open_.emplace(l, at);
        }
    }

    // Whether the line between the middles of two doors, `step` mm long, keeps away from lines. Each of its points is
    // as far from them as either middle, less its distance from that. Mostly this is enough.
    [[nodiscard]] bool free_step(const Door& a, const Door& b, double step) const {
        return (a.clear + b.clear - step) / 2 > narrow_ + kPointRounding || cells_.is_free(a.middle, b.middle, narrow_);
    }

    // Whether the path may go from `from`, the middle of the door `before` or the start of the path, to a door. The
    // first step is within a triangle as well, but there may be lines near it that are not in the triangulation.
    [[nodiscard]] bool may_step(int before, Vec2 from, const Door& to, double step) const {
        if (before == kNone)
            return is_free(cells_, from, to.middle, 0, kPointRounding, 0) && stays_beside_beads(from, to.middle, step);
        const Door& door = doors_[static_cast<std::size_t>(before)];
        if (!free_step(door, to, step)) return false;
        if (step <= 2 * void_ - door.beyond_bead - to.beyond_bead) return true; // each half is near one end's bead
        return stays_beside_beads(from, to.middle, step);
    }

    // Whether each point of the line a -> b, `step` mm long, is at most void_ outside some bead. The sides of a
    // triangle can lie in strips on both sides of a hole, with nothing but the hole between them. From a point that is
    // less than void_ outside a bead, the line stays beside that bead for the difference at least.
    [[nodiscard]] bool stays_beside_beads(Vec2 a, Vec2 b, double step) const {
        for (double at = 0; at < step;) {
            const Vec2 p = geom::lerp(a, b, at / step);
            const auto near = cells_.nearest(p, void_ + widest_ / 2);
            const double room = near ? void_ + bead_width(near->segment, p) / 2 - near->distance : -1;
            if (room < 0) return false;
            at += std::max(room, void_ / kVoidParts);
        }
        return true;
    }

    // Whether the middle of a door is in a strip that the path may use.
    [[nodiscard]] bool in_strip(Door& door) const {
        if (door.half <= narrow_) return false;
        if (door.clear < 0) {
            const auto near = cells_.nearest(door.middle, door.half + kPointRounding);
            door.clear = near ? near->distance : 0;
            door.beyond_bead = near ? door.clear - bead_width(near->segment, door.middle) / 2 : 0;
        }
        return door.clear > narrow_ && door.beyond_bead <= beyond_;
    }

    [[nodiscard]] double bead_width(std::uint32_t segment, Vec2 at) const {
        const Place place = index_.place(segment, 0, at);
        return curves_[place.curve].width_at(place.segment);
    }

    // The number of the door at this side of f; kNone if a path may not pass there.
    int door(Face f, int side) {
        if (f->is_constrained(side)) return kNone;
        const Face g = f->neighbor(side);
        int& here = f->info()[static_cast<std::size_t>(side)];
        int& there = g->info()[static_cast<std::size_t>(t_.mirror_index(f, side))];
        if (here == kNone) {
            const Vec2 a = vec(f->vertex(t_.cw(side))->point()), b = vec(f->vertex(t_.ccw(side))->point());
            here = there = static_cast<int>(doors_.size());
            doors_.push_back({geom::lerp(a, b, 0.5), f, side, geom::distance(a, b) / 2});
        }
        return in_strip(doors_[static_cast<std::size_t>(here)]) ? here : kNone;
    }

    [[nodiscard]] std::vector<Vec2> trace(int at) const {
        std::vector<Vec2> out;
        for (; at != kNone; at = doors_[static_cast<std::size_t>(at)].before)
            out.push_back(doors_[static_cast<std::size_t>(at)].middle);
        out.push_back(from_);
        std::reverse(out.begin(), out.end());
        return out;
    }

    Triangulation& t_;
    std::span<const toolpath::Curve> curves_;
    const SegmentIndex& index_;
    const SegmentCells& cells_;
    Vec2 from_;
    double void_, widest_; // mm, how far outside beads a path may be; the width of the widest bead
    Triangulation::Vertex_handle begin_;
    double narrow_ = 0, beyond_ = 0; // mm
    std::vector<Door> doors_;
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open_;
};

// Drops points where the line between their neighbours stays within `tolerance` of them and clear of the lines.
std::vector<Vec2> straighten(const std::vector<Vec2>& way, const SegmentCells& cells, double clear, double tolerance) {
    std::vector<Vec2> out{way.front()};
    for (std::size_t i = 1; i + 1 < way.size();) {
        std::size_t far = i;
        for (std::size_t j = i + 1; j < way.size() && j < i + 64; ++j) {
            bool near = true;
            for (std::size_t k = i; k < j && near; ++k)
                near = geom::point_segment_distance(out.back(), way[j], way[k]) <= tolerance;
            if (!near || out.size() == 1 || !cells.is_free(out.back(), way[j], clear)) break;
            far = j;
        }
        out.push_back(way[far]);
        i = far + 1;
    }
    if (out.back() != way.back()) out.push_back(way.back());
    return out;
}

} // namespace

std::optional<std::vector<Vec2>> strip_route(std::span<const std::vector<Vec2>> lines,
                                             std::span<const toolpath::Curve> curves, const SegmentIndex& index,
                                             Vec2 from, double width, std::span<const Strips> strips, int best,
                                             const std::function<int(Vec2, int)>& rank) {
    double length = 0;
    for (const auto& line : lines) length += geom::length(line);
    Triangulation t = triangulate(pieces(lines, std::max(width, length / kMostPieces)));
    if (t.dimension() < 2) return std::nullopt;
    const SegmentCells cells(curves);
    Search search(t, curves, index, cells, from, width);
    for (const auto& [narrow, beyond] : strips)
        if (const auto way = search.run(narrow * width, beyond * width, best, rank))
            return straighten(*way, cells, narrow * width, width / 20);
    return std::nullopt;
}

} // namespace filum::link3d
