#include "geodesic/measure.hpp"

#include "base/error.hpp"
#include "geodesic/certificate.hpp"
#include "geodesic/heat.hpp"
#include "geodesic/isolines.hpp"
#include "geodesic/sides.hpp"

#include <limits>

namespace filum::geodesic {

namespace {

constexpr double kMaxLevels = 1e5;
constexpr std::size_t kExactTriangles = 300'000;
constexpr std::size_t kTried = 8;             // windows per triangle, which take about as much time as the heat method
constexpr std::uint64_t kChecked = 4'000'000; // windows for the comparison with heat
constexpr std::size_t kSmall = 100'000; // triangles: for smaller surfaces the memory for all windows does not matter
constexpr double kOff = 0.05, kFarOff = 0.2; // relative errors: p99, or the maximum, above which a note is added

// An upper bound on the distance of any place on an edge.
double farthest_on_edges(const Surface& s, std::span<const double> distance) {
    double out = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const double sum = distance[s.tail(h)] + distance[s.head(h)];
        if (std::isfinite(sum)) out = std::max(out, (sum + surface::side_length(s, h)) / 2);
    }
    return out;
}

// The requested levels, ascending, without duplicates.
std::vector<double> levels_up_to(double farthest, const Options& o) {
    std::vector<double> out = o.levels;
    for (const double level : out)
        if (!(level > 0)) throw Error(Exit::usage, "--levels must be above 0");
    if (o.spacing > 0) {
        const double first = o.first > 0 ? o.first : o.spacing;
        if ((farthest - first) / o.spacing > kMaxLevels)
            throw Error(Exit::usage, "cannot draw more than 100000 isolines; raise --spacing");
        for (std::uint32_t i = 0; first + i * o.spacing <= farthest; ++i) out.push_back(first + i * o.spacing);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

// The side of the line's first segment that has one.
int side_of(const Surface& s, const Sides& sides, const Isoline& line) {
    for (std::size_t i = 0; i < line.triangles.size(); ++i) {
        const Vec3 middle = 0.5 * (line.points[i] + line.points[(i + 1) % line.points.size()]);
        if (const int side = sides.at(s, line.triangles[i], middle); side != 0) return side;
    }
    return 1;
}

void add_signs(const Surface& s, const Sources& sources, std::vector<double>& distance, std::vector<Isoline>& lines) {
    const Sides found = sides(s, sources);
    check(found, "--signed");
    for (std::size_t v = 0; v < distance.size(); ++v)
        if (found.of[v] < 0 && std::isfinite(distance[v])) distance[v] = -distance[v];
    for (Isoline& line : lines) {
        if (side_of(s, found, line) > 0) continue;
        line.level = -line.level;
        // Reverses the line. Segments of an open line reverse with its points; the last one of a closed line joins its
        // ends.
        std::reverse(line.points.begin(), line.points.end());
        std::reverse(line.triangles.begin(), line.triangles.end() - (line.closed ? 1 : 0));
    }
    std::stable_sort(lines.begin(), lines.end(), [](const Isoline& a, const Isoline& b) { return a.level < b.level; });
}

// Compares distances by heat with the exact ones, as far as these are known.
void compare(std::span<const double> truth, std::span<const double> distance, Facts& facts, Notes& notes) {
    const DistanceError e = distance_error(truth, distance);
    facts.push_back({"", "heat-checked", static_cast<double>(e.vertices), "vertices"});
    facts.push_back({"", "heat-checked-to", e.known, "mm"});
    facts.push_back({"", "heat-error-mean", 100 * e.mean, "%"});
    facts.push_back({"", "heat-error-p99", 100 * e.p99, "%"});
    facts.push_back({"", "heat-error-max", 100 * e.largest, "%"});
    if (e.p99 > kOff || e.largest > kFarOff)
        notes.push_back({.code = NoteCode::heat_inexact, .amount = 100 * e.largest});
}

bool wants_lines(const Options& o) { return !o.levels.empty() || o.spacing > 0; }

// Exact distances as far as they are worth the time: all if requested or cheap; otherwise as many as take about the
// time of the heat method, or a second for the comparison.
ExactDistances exact_part(const Surface& s, const Sources& sources, const Options& o) {
    constexpr double kAll = std::numeric_limits<double>::infinity();
    if (o.method == Method::heat) return exact_distances(s, sources, kAll, kChecked);
    if (o.method == Method::either && s.triangles.size() > kExactTriangles)
        return exact_distances(s, sources, kAll, kTried * s.triangles.size());
    if (wants_lines(o) || s.triangles.size() <= kSmall) return {{}, kAll, 0}; // measure() computes all windows
    return exact_distances(s, sources);
}

} // namespace

Facts measure(surface::Sheet& sheet, const Sources& sources, const Options& o, Notes& notes) {
    const Surface& s = sheet.surface;
    if (o.paper && o.method != Method::heat) throw Error(Exit::usage, "--paper requires --method heat");
    ExactDistances found = exact_part(s, sources, o);
    const bool by_windows = o.method != Method::heat && !std::isfinite(found.known);
    Facts facts{{"", "exact", by_windows ? 1.0 : 0.0, ""}};
    std::vector<double> distance;
    const auto levels = [&] { return levels_up_to(farthest_on_edges(s, distance), o); };
    if (by_windows && !wants_lines(o) && !found.distance.empty()) {
        distance = std::move(found.distance);
        facts.push_back({"", "windows", static_cast<double>(found.propagated), ""});
    } else if (by_windows) {
        const ExactField field = exact(s, sources);
        distance = field.distance;
        sheet.isolines = isolines(s, field, levels());
        facts.push_back({"", "windows", static_cast<double>(field.propagated), ""});
    } else {
        Heat heat(s, sources, {.paper = o.paper});
        distance = heat.distance();
        sheet.isolines = isolines(s, distance, levels());
        facts.push_back({"", "heat-time", heat.time(), "mm2"});
        compare(found.distance, distance, facts, notes);
    }
    const Facts quality = certificate(s, distance);
    facts.insert(facts.end(), quality.begin(), quality.end());
    if (o.with_sides) add_signs(s, sources, distance, sheet.isolines);
    facts.push_back({"", "isolines", static_cast<double>(sheet.isolines.size()), ""});
    std::erase_if(sheet.fields, [](const surface::Field& f) { return f.name == "distance"; });
    sheet.fields.push_back({"distance", std::move(distance), 1});
    sheet.sources = sources;
    return facts;
}

} // namespace filum::geodesic
