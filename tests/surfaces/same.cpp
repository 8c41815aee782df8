#include "same.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geodesic/measure.hpp"
#include "geodesic/named_sources.hpp"
#include "surfpath/surfpath.hpp"

#include "judge.hpp"
#include "random.hpp"
#include "shapes.hpp"

#include <algorithm>
#include <cmath>

namespace filum::trials {

namespace {

// In another order of its triangles a surface gets the same path.  In other triangles, or turned, near-ties of where
// rows are left and taken up again fall otherwise, which moves a few turns.
constexpr double kSame = 0.002, kSampled = 0.02; // of the length; of the area, which the judge samples
constexpr double kCoverage = 0.05;               // of the area: that much may differ, or
constexpr double kTurns = 10;                    // squares of a spacing
constexpr double kStrokes = 0.1;                 // of the strokes, or one

constexpr std::size_t kMost = 10'000; // triangles: four times as many are to be filled, too

// Where lines come from, as a part of space that moves with the surface.
struct From {
    Vec3 point, normal;
};

std::string text(const Vec3& v) { return shortest_text(v.x) + "," + shortest_text(v.y) + "," + shortest_text(v.z); }

std::string source(surfpath::Algorithm algorithm, const From& from, const Motion& m) {
    const Vec3 n = m.way(from.normal), p = m.point(from.point);
    if (algorithm == surfpath::Algorithm::geo_spiral) return "point:" + text(p);
    if (algorithm == surfpath::Algorithm::hybrid) return "";
    if (algorithm == surfpath::Algorithm::geo_fiso || algorithm == surfpath::Algorithm::geo_contour) return "boundary";
    return "plane:" + text(n) + "," + shortest_text(dot(n, p));
}

struct Filled {
    Judged judged;
    std::size_t strokes = 0;
};

Filled fill(Mesh mesh, surfpath::Options o, const From& from, const Motion& motion) {
    Notes notes;
    o.follow.reference = motion.way(o.follow.reference);
    for (Vec3& v : mesh.vertices) v = motion.point(v);
    surface::Sheet sheet;
    sheet.surface = surface::connect(std::move(mesh), notes);
    geodesic::measure(sheet, geodesic::named_sources(sheet.surface, source(o.algorithm, from, motion), notes), {},
                      notes);
    surfpath::Plan plan = surfpath::plan_paths(sheet, o);
    surfpath::finish(sheet.surface, plan, o);
    surfpath::plan::SpanOptions laying;
    laying.width = o.spacing;
    return {judge(sheet.surface, surfpath::plan::spans(sheet.surface, plan, laying),
                  {o.spacing, o.least_radius, true, false, {}}),
            plan.strokes.size()};
}

// The middle of a triangle, and a way across the surface there.
From from_somewhere(const Mesh& mesh, Random& r) {
    const auto& [a, b, c] = mesh.triangles[r.below(mesh.triangles.size())];
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &s = mesh.vertices[c];
    return {1.0 / 3 * (p + q + s), r.direction()};
}

using Faults = std::vector<std::string>;

void hold(const std::string& what, double before, double now, double slack, Faults& out) {
    if (std::abs(now - before) > slack)
        out.push_back(what + " " + fixed_text(now, 4) + ", was " + fixed_text(before, 4));
}

void hold_near(const std::string& name, const Filled& a, const Filled& b, double spacing, Faults& out) {
    const double area = kTurns * spacing * spacing / a.judged.area, strokes = static_cast<double>(a.strokes);
    hold(name + ": coverage", a.judged.covered, b.judged.covered, std::max(kCoverage, area), out);
    hold(name + ": strokes", strokes, static_cast<double>(b.strokes), std::max(1.0, kStrokes * strokes), out);
}

} // namespace

Likeness compare(std::uint64_t seed, std::uint64_t number) {
    Random r(seed * 1'000'003 + number);
    static const std::vector<std::string> algorithms(surfpath::kAlgorithms.begin(), surfpath::kAlgorithms.end());
    surfpath::Options o;
    o.algorithm = *surfpath::algorithm(r.of(algorithms));
    o.spacing = r.chance(0.3) ? 1 : r.in(0.8, 2.5);
    o.least_radius = r.of<double>({0.5, 1}); // greater ones leave rings out, which is all or nothing
    const Shape shape = random_shape(r);
    if (shape.mesh.triangles.empty()) throw Error(Exit::usage, "nothing is left of the shape");
    if (shape.mesh.triangles.size() > kMost) throw Error(Exit::usage, "too many triangles for a trial");
    const From from = from_somewhere(shape.mesh, r);
    Likeness out;
    out.words = std::string(surfpath::name(o.algorithm)) + " spacing " + fixed_text(o.spacing, 2) + " on " +
                shape.name + ", " + std::to_string(shape.mesh.triangles.size()) + " triangles";
    const Filled first = fill(shape.mesh, o, from, {});
    Mesh shuffled = shape.mesh, split = shape.mesh;
    shuffle(shuffled, r);
    split_in_four(split);
    const Filled other = fill(shuffled, o, from, {});
    hold("shuffled: length", first.judged.length, other.judged.length, kSame * first.judged.length, out.faults);
    hold("shuffled: coverage", first.judged.covered, other.judged.covered, kSampled, out.faults);
    const std::string strokes = ", " + std::to_string(first.strokes) + " strokes";
    out.words += ", covered " + fixed_text(first.judged.covered, 3) + strokes;
    // Where its lines lie is the nearest of many minima: other triangles, or a turn's rounding, may lead to another
    // one.
    if (o.algorithm == surfpath::Algorithm::field || o.algorithm == surfpath::Algorithm::hybrid) return out;
    hold_near("split", first, fill(split, o, from, {}), o.spacing, out.faults);
    hold_near("turned", first, fill(shape.mesh, o, from, turned(r)), o.spacing, out.faults);
    return out;
}

} // namespace filum::trials
