#include "trial.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "baselines/kipping2022/kipping2022.hpp"
#include "geodesic/lines.hpp"
#include "geodesic/measure.hpp"
#include "geodesic/named_sources.hpp"
#include "surface/remesh.hpp"
#include "surfpath/plan/plan.hpp"

#include "shapes.hpp"

#include <cmath>

namespace filum::trials {

namespace {

using surface::Sources;

Surface cut(Surface s, Random& r, std::string& words, Notes& notes) {
    const std::size_t cuts = r.chance(0.3) ? 1 + r.below(2) : 0;
    for (std::size_t i = 0; i < cuts; ++i) {
        const Vec3 n = r.direction(), p = s.vertices[r.below(s.vertices.size())];
        s = surface::cut(s, {n, dot(n, p)}, notes);
        words += " cut";
    }
    return s;
}

// A closed one is opened, most times, or there are no rims to speak of.
Surface opened(Surface s, Random& r, std::string& words, Notes& notes) {
    if (!s.rims.empty() || r.chance(0.1)) return s;
    const Vec3 n = r.direction();
    double lo = 1e9, hi = -1e9;
    for (const Vec3& v : s.vertices) {
        lo = std::min(lo, dot(n, v));
        hi = std::max(hi, dot(n, v));
    }
    words += " opened";
    return surface::cut(s, {n, lo + r.in(0.3, 0.9) * (hi - lo)}, notes);
}

Surface surface_of(Random& r, double spacing, std::string& words, Notes& notes) {
    Shape shape = random_shape(r);
    words = shape.name + spoil(shape.mesh, r);
    Surface s = opened(surface::connect(std::move(shape.mesh), notes), r, words, notes);
    s = cut(std::move(s), r, words, notes);
    if (r.chance(0.4)) {
        const double edge = spacing * r.in(0.35, 1.3);
        s = surface::remesh(s, edge, notes);
        words += " remeshed";
    }
    if (s.triangles.size() > 60'000) throw Error(Exit::usage, "too many triangles for a trial");
    return s;
}

std::string numbers(const Vec3& v) { return shortest_text(v.x) + "," + shortest_text(v.y) + "," + shortest_text(v.z); }

std::string plane(const Surface& s, Random& r) {
    const Vec3 n = r.chance(0.3) ? Vec3{1, 0, 0} : r.direction();
    Vec3 mean;
    for (const Vec3& v : s.vertices) mean = mean + 1.0 / static_cast<double>(s.vertices.size()) * v;
    const Vec3 p = mean + 0.5 * r.unit() * (s.vertices[r.below(s.vertices.size())] - mean);
    return "plane:" + numbers(n) + "," + shortest_text(dot(n, p));
}

std::string rim(const Surface& s, Random& r) {
    if (r.chance(0.6) || s.rims.empty()) return "boundary";
    return r.chance(0.5) ? "boundary:outer" : "boundary:" + std::to_string(r.below(s.rims.size()));
}

std::string point(const Surface& s, Random& r) {
    const auto v = r.below(s.vertices.size());
    if (r.chance(0.3)) return "vertex:" + std::to_string(v);
    const auto& [a, b, c] = s.triangles[r.below(s.triangles.size())];
    const double t = r.unit();
    return "point:" + numbers(0.5 * (s.vertices[a] + t * s.vertices[b] + (1 - t) * s.vertices[c]));
}

// A line between vertices that lie near to each other, drawn on.
void line(const Surface& s, Random& r, Sources& out, Notes& notes) {
    std::vector<Vec3> points{s.vertices[r.below(s.vertices.size())]};
    Vec3 way = r.direction();
    for (std::size_t i = 0, n = 1 + r.below(6); i < n; ++i) {
        way = way + 0.4 * r.direction();
        points.push_back(surface::nearest(s, points.back() + r.in(2, 6) * way).a);
    }
    geodesic::add_lines(out, s, {points}, notes);
}

Sources sources(const Surface& s, surfpath::Algorithm algorithm, Random& r, std::string& words, Notes& notes) {
    const double dice = r.unit();
    std::string what;
    if (algorithm == surfpath::Algorithm::hybrid)
        what = "";
    else if (algorithm == surfpath::Algorithm::geo_spiral)
        what = point(s, r);
    else if (algorithm == surfpath::Algorithm::geo_fiso || algorithm == surfpath::Algorithm::geo_contour)
        what = dice < 0.75 || s.rims.empty() ? rim(s, r) : dice < 0.85 ? plane(s, r) : dice < 0.95 ? point(s, r) : "";
    else if (algorithm == surfpath::Algorithm::ortheo)
        what = dice < 0.4 ? plane(s, r) : dice < 0.65 ? rim(s, r) : dice < 0.85 ? "line" : point(s, r);
    else
        what = dice < 0.6                                             ? plane(s, r)
               : dice < 0.8 && algorithm == surfpath::Algorithm::fina ? rim(s, r)
               : dice < 0.95                                          ? "line"
                                                                      : plane(s, r);
    words += " from " + (what.empty() ? "nothing" : what);
    if (what != "line") return geodesic::named_sources(s, what, notes);
    Sources out;
    line(s, r, out, notes);
    return out;
}

} // namespace

Trial make(std::uint64_t seed, std::uint64_t number) {
    Random r(seed * 1'000'003 + number);
    Trial out;
    static const std::vector<std::string> algorithms(surfpath::kAlgorithms.begin(), surfpath::kAlgorithms.end());
    surfpath::Options& o = out.options;
    o.algorithm = *surfpath::algorithm(r.of(algorithms));
    out.as_paper = r.chance(0.12);
    o.spacing = r.chance(0.3) ? 1 : r.in(0.6, 3);
    o.least_radius = r.chance(0.6) ? 2.4 : r.of<double>({0, 0.5, 1, 1.5, 4});
    const std::vector<std::string> turns{"none", "hairpin", "wide"};
    const std::string turn = r.of(turns);
    o.turns = static_cast<surfpath::RowTurns>(std::find(turns.begin(), turns.end(), turn) - turns.begin());
    out.sheet.surface = surface_of(r, o.spacing, out.words, out.notes);
    const Surface& s = out.sheet.surface;
    const Sources from = sources(s, o.algorithm, r, out.words, out.notes);
    if (!from.empty()) geodesic::measure(out.sheet, from, {}, out.notes);
    out.words = std::string(surfpath::name(o.algorithm)) + (out.as_paper ? " (kipping2022)" : "") + " spacing " +
                fixed_text(o.spacing, 2) + " radius " + fixed_text(o.least_radius, 1) +
                (o.algorithm == surfpath::Algorithm::ortheo ? " turns " + turn : "") + " on " + out.words + ", " +
                std::to_string(s.triangles.size()) + " triangles, " + std::to_string(s.rims.size()) + " rims, " +
                std::to_string(s.components) + " components";
    out.paper.algorithm = o.algorithm;
    out.paper.spacing = o.spacing;
    return out;
}

Outcome run(const Trial& t) {
    Outcome out;
    const bool ours = !t.as_paper;
    const bool rings = ours && (t.options.algorithm == surfpath::Algorithm::geo_fiso ||
                                t.options.algorithm == surfpath::Algorithm::geo_contour);
    const Asked asked{t.options.spacing, t.options.least_radius, ours, rings, t.sheet.sources};
    try {
        surfpath::Plan plan =
            ours ? surfpath::plan_paths(t.sheet, t.options) : baselines::kipping2022::plan(t.sheet, t.paper);
        surfpath::finish(t.sheet.surface, plan, t.options);
        surfpath::plan::SpanOptions laying;
        laying.width = t.options.spacing;
        const auto spans = surfpath::plan::spans(t.sheet.surface, plan, laying);
        out.judged = judge(t.sheet.surface, spans, asked);
        out.faults = faults(t.sheet.surface, spans, out.judged, plan.notes, asked);
    } catch (const Error& e) {
        out.refused = e.what();
        if (e.exit() != Exit::usage && e.exit() != Exit::bad_input && e.exit() != Exit::failure)
            out.faults.push_back("exit " + std::to_string(static_cast<int>(e.exit())));
    } catch (const std::exception& e) {
        out.faults.push_back(std::string("internal error: ") + e.what());
    }
    return out;
}

} // namespace filum::trials
