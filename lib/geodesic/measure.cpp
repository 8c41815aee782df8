#include "geodesic/measure.hpp"

#include "base/error.hpp"
#include "geodesic/certificate.hpp"
#include "geodesic/heat.hpp"
#include "geodesic/isolines.hpp"
#include "geodesic/sides.hpp"

namespace filum::geodesic {

namespace {

constexpr double kMaxLevels = 1e5;
constexpr std::size_t kExactTriangles = 300'000;

// What no place on an edge is farther than.
double farthest_on_edges(const Surface& s, std::span<const double> distance) {
    double out = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const double sum = distance[s.tail(h)] + distance[s.head(h)];
        if (std::isfinite(sum))
            out = std::max(out, (sum + geom::distance(s.vertices[s.tail(h)], s.vertices[s.head(h)])) / 2);
    }
    return out;
}

// All levels asked for, ascending, each once.
std::vector<double> levels_up_to(double farthest, const Options& o) {
    std::vector<double> out = o.levels;
    for (const double level : out)
        if (!(level > 0)) throw Error(Exit::usage, "cannot draw isolines at --levels that are not above 0");
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

bool is_exact(const Surface& s, const Options& o) {
    if (o.paper && o.method != "heat") throw Error(Exit::usage, "cannot use --paper without --method heat");
    return o.method == "exact" || (o.method == "auto" && s.triangles.size() <= kExactTriangles);
}

// By the side of each line's first stretch that has one.
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
        // The other way round: an open line's stretches turn with its points, a closed one's last joins last and first.
        std::reverse(line.points.begin(), line.points.end());
        std::reverse(line.triangles.begin(), line.triangles.end() - (line.closed ? 1 : 0));
    }
    std::stable_sort(lines.begin(), lines.end(), [](const Isoline& a, const Isoline& b) { return a.level < b.level; });
}

} // namespace

Facts measure(surface::Sheet& sheet, const Sources& sources, const Options& o) {
    const Surface& s = sheet.surface;
    const bool by_windows = is_exact(s, o);
    Facts facts{{"", "exact", by_windows ? 1.0 : 0.0, ""}};
    std::vector<double> distance;
    const auto levels = [&] { return levels_up_to(farthest_on_edges(s, distance), o); };
    if (by_windows) {
        ExactField field = exact(s, sources);
        distance = field.distance;
        sheet.isolines = isolines(s, field, levels());
        facts.push_back({"", "windows", static_cast<double>(field.propagated), ""});
    } else {
        Heat heat(s, sources, {.paper = o.paper});
        distance = heat.distance();
        sheet.isolines = isolines(s, distance, levels());
        facts.push_back({"", "heat-time", heat.time(), "mm2"});
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
