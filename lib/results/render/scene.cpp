#include "render/scene.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::render {

namespace {

using geom::Vec2;

constexpr double kMostLines = 4000; // largest number of lines that fill one outline

// The x coordinates where the horizontal line at `y` crosses the loops, ascending.
void crossings(const polygon::Loops& loops, double y, std::vector<double>& out) {
    out.clear();
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const auto loop = loops[i];
        for (std::size_t k = 0, j = loop.size() - 1; k < loop.size(); j = k++) {
            const Vec2 a = loop[j], b = loop[k];
            if ((a.y > y) != (b.y > y)) out.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
        }
    }
    std::sort(out.begin(), out.end());
}

// `loops` with x and y exchanged if `turn`.
polygon::Loops turned(polygon::Loops loops, bool turn) {
    if (turn)
        for (Vec2& p : loops.points) std::swap(p.x, p.y);
    return loops;
}

constexpr double kUnknown = std::numeric_limits<double>::infinity();

void append_fields(std::vector<surface::Field>& to, const std::vector<surface::Field>& more, std::size_t before,
                   std::size_t after) {
    for (const auto& f : more) {
        const auto old = std::find_if(to.begin(), to.end(), [&](const auto& o) { return o.name == f.name; });
        if (old == to.end()) {
            to.push_back({f.name, std::vector<double>(before * f.components, kUnknown), f.components});
            to.back().values.insert(to.back().values.end(), f.values.begin(), f.values.end());
        } else if (old->components != f.components) {
            throw Error(Exit::bad_input, "cannot draw the surfaces: their fields '" + f.name + "' are of two kinds");
        } else {
            old->values.insert(old->values.end(), f.values.begin(), f.values.end());
        }
    }
    for (auto& f : to) f.values.resize(after * f.components, kUnknown);
}

void append(surface::Sheet& to, surface::Sheet more) {
    auto &s = to.surface, &m = more.surface;
    const auto v = static_cast<std::uint32_t>(s.vertices.size()), t = static_cast<std::uint32_t>(s.triangles.size());
    append_fields(to.fields, more.fields, v, v + m.vertices.size());
    for (auto& triangle : m.triangles)
        for (auto& corner : triangle) corner += v;
    for (auto& h : m.twin) h += h == surface::kNone ? 0 : 3 * t;
    for (auto& line : more.isolines) {
        for (auto& triangle : line.triangles) triangle += t;
        to.isolines.push_back(std::move(line));
    }
    s.vertices.insert(s.vertices.end(), m.vertices.begin(), m.vertices.end());
    s.triangles.insert(s.triangles.end(), m.triangles.begin(), m.triangles.end());
    s.twin.insert(s.twin.end(), m.twin.begin(), m.twin.end());
    s = surface::assemble(std::move(s.vertices), std::move(s.triangles), std::move(s.twin));
}

} // namespace

void add(Scene& scene, const toolpath::Span& span, Range range) {
    if (range.has(span.layer)) scene.spans.push_back(span);
}

void add(Scene& scene, const toolpath::RegionPaths& paths, Range range) {
    if (!range.has(paths.layer)) return;
    for (const auto& c : paths.curves) {
        toolpath::Span s{toolpath::Role::bead, paths.stroke, paths.layer, paths.region, {}, c.width, {paths.height}};
        s.tool = paths.tool;
        for (const Vec2 p : c.points) s.points.push_back({p.x, p.y, paths.z});
        if (c.closed) s.points.push_back(s.points.front());
        if (c.closed && s.width.size() > 1) s.width.push_back(s.width.front());
        scene.spans.push_back(std::move(s));
    }
}

void add(Scene& scene, const polygon::Layer& layer, Range range) {
    if (range.has(layer.index))
        scene.outlines.push_back({layer.index, 0, layer.z, layer.height, layer.contours, layer.tool});
}

void add(Scene& scene, const polygon::Region& region, Range range) {
    if (range.has(region.layer))
        scene.outlines.push_back({region.layer, region.stroke, region.z, region.height, region.loops, region.tool});
}

void add(Scene& scene, surface::Sheet sheet) {
    const auto count = static_cast<std::uint32_t>(scene.patches.size());
    scene.patches.push_back(sheet.name.empty() ? std::to_string(count + 1) : sheet.name);
    scene.patch.insert(scene.patch.end(), sheet.surface.triangles.size(), count);
    if (scene.sheet)
        append(*scene.sheet, std::move(sheet));
    else
        scene.sheet = std::move(sheet);
}

void fill_outlines(Scene& scene) {
    scene.solid = true;
    std::vector<double> x;
    for (const Outline& o : scene.outlines) {
        const auto span = [&](std::vector<geom::Vec3> points) {
            scene.spans.push_back(
                {toolpath::Role::bead, o.stroke, o.layer, 0, std::move(points), {o.height}, {o.height}});
            scene.spans.back().tool = o.tool;
        };
        for (std::size_t i = 0; i < o.loops.size(); ++i) {
            std::vector<geom::Vec3> ring;
            for (const Vec2 p : o.loops[i]) ring.push_back({p.x, p.y, o.z});
            ring.push_back(ring.front());
            span(std::move(ring));
        }
        const bool turn = o.layer % 2 == 1;
        const auto loops = turned(o.loops, turn);
        const auto box = polygon::bounds(loops);
        if (box.empty()) continue;
        const double step = std::max(o.height, (box.hi.y - box.lo.y) / kMostLines);
        const double first = (std::floor(box.lo.y / step) + 0.5) * step;
        for (std::int64_t k = 0; first + static_cast<double>(k) * step < box.hi.y; ++k) {
            const double y = first + static_cast<double>(k) * step;
            crossings(loops, y, x);
            for (std::size_t i = 0; i + 1 < x.size(); i += 2)
                span(turn ? std::vector<geom::Vec3>{{y, x[i], o.z}, {y, x[i + 1], o.z}}
                          : std::vector<geom::Vec3>{{x[i], y, o.z}, {x[i + 1], y, o.z}});
        }
    }
}

} // namespace filum::render
