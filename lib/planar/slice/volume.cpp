#include "slice/volume.hpp"

#include "base/error.hpp"
#include "base/mix.hpp"
#include "base/number.hpp"
#include "mesh/place.hpp"
#include "parallel/parallel.hpp"
#include "polygon/simple.hpp"
#include "slice/section.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::slice {

namespace {

constexpr double kTold = 0.015;            // of the volume: larger differences are noted; 2 % less the error
constexpr double kUncertain = 0.25;        // a point is undecided if its winding number is farther from a whole one
constexpr std::size_t kPlanes = 256;       // planes that measure a part
constexpr std::size_t kPoints = 64000;     // points on all planes together, where contours are open
constexpr std::size_t kFirstPlanes = 32;   // planes of the first pass, which tests if the part is a solid at all
constexpr std::size_t kFirstPoints = 8000; // points of the first pass
constexpr double kRows = 512;              // most rows across a plane
constexpr double kFewRows = 48;            // fewest rows
constexpr double kPassed = 2e5;            // most crossings of rows and walls, which limits the rows

// The planes that measure the layers `asked`: `each` per layer, up to the top of the part.
std::vector<Level> levels_within(const Sweep& sweep, const std::vector<std::size_t>& asked, std::size_t each) {
    std::vector<Level> out;
    for (const std::size_t i : asked) {
        const Level& l = sweep.levels[i];
        const double bottom = l.z - l.height, top = std::min(l.z, sweep.top);
        const double step = (top - bottom) / static_cast<double>(each);
        for (std::size_t k = 0; k < each; ++k) {
            const double at = bottom + (static_cast<double>(k) + 0.5) * step;
            out.push_back({at, step, at - kLift}); // kLift is what the sweep adds
        }
    }
    return out;
}

// The area that closed contours wind round, mm2, by sampling rows.
double area_by_rows(const Loops& loops, bool hollow) {
    const geom::Box2 box = polygon::bounds(loops);
    if (box.empty() || !(box.hi.y > box.lo.y)) return 0;
    const auto walls = polygon::walls(loops);
    double rise = 0;
    for (const polygon::Wall& w : walls) rise += std::abs(w.b.y - w.a.y) / (box.hi.y - box.lo.y);
    const double rows = std::clamp(std::floor(kPassed / std::max(rise, 1.0)), kFewRows, kRows);
    const double step = (box.hi.y - box.lo.y) / rows;
    std::vector<std::vector<std::pair<double, int>>> passed(static_cast<std::size_t>(rows)); // x, and direction
    for (const polygon::Wall& w : walls) {
        const auto [low, high] = std::minmax(w.a.y, w.b.y);
        const double first = std::ceil((low - box.lo.y) / step - 0.5);
        for (double r = std::max(0.0, first); r < rows; ++r) {
            const double y = box.lo.y + (r + 0.5) * step;
            if ((w.a.y > y) != (w.b.y > y))
                passed[static_cast<std::size_t>(r)].emplace_back(
                    w.a.x + (w.b.x - w.a.x) * ((y - w.a.y) / (w.b.y - w.a.y)), w.a.y > y ? 1 : -1);
            if (y > high) break;
        }
    }
    double area = 0;
    for (auto& row : passed) {
        std::sort(row.begin(), row.end());
        int winding = 0;
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            winding += row[k].second;
            if (hollow ? winding > 0 : winding != 0) area += step * (row[k + 1].first - row[k].first);
        }
    }
    return area;
}

// The measurement of one plane.
struct Reading {
    double solid = 0;              // mm2, where contours close
    double cell = 0;               // mm2 per point
    std::vector<geom::Vec2> point; // sample points, where contours are open
    std::vector<double> winding;   // winding number of the surface, per point
};

Reading read_points(const Part& part, double z, const geom::Box3& box, std::size_t points, std::uint64_t seed) {
    const double w = box.hi.x - box.lo.x, d = box.hi.y - box.lo.y;
    const double wide = std::sqrt(static_cast<double>(points) * w / std::max(d, 1e-9));
    const auto columns = static_cast<std::size_t>(std::clamp(wide, 1.0, static_cast<double>(points)));
    const std::size_t rows = std::max<std::size_t>(1, points / columns);
    Reading out;
    out.cell = w * d / static_cast<double>(columns * rows);
    for (std::size_t i = 0; i < columns * rows; ++i) {
        const std::size_t column = i % columns, row = i / columns;
        const double u = static_cast<double>(column) + as_share(mixed(2 * (seed * 1000003 + i))),
                     v = static_cast<double>(row) + as_share(mixed(2 * (seed * 1000003 + i) + 1));
        out.point.push_back(
            {box.lo.x + w * u / static_cast<double>(columns), box.lo.y + d * v / static_cast<double>(rows)});
        out.winding.push_back(part.winding->at({out.point.back().x, out.point.back().y, z}));
    }
    return out;
}

// The typical winding number inside: 1, or less if triangles are missing everywhere.
double level_within(const std::vector<Reading>& readings) {
    std::vector<double> within;
    for (const Reading& r : readings)
        for (const double w : r.winding)
            if (w > kUncertain) within.push_back(w);
    if (within.empty()) return 1;
    const auto middle = within.begin() + static_cast<std::ptrdiff_t>(within.size() / 2);
    std::nth_element(within.begin(), middle, within.end());
    return std::clamp(*middle, 0.5, 1.0);
}

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

// "12.3 %"
std::string percent(double share) { return fixed_text(100 * share, 1) + " %"; }

[[noreturn]] void no_solid(double solid, double baseless) {
    const std::string what = "cannot slice the part: its surface is open, and ";
    const std::string why = solid > 0 ? "leaves " + fixed_text(baseless, 1) + " mm3 undecided, more than the " +
                                            fixed_text(solid, 1) + " mm3 that it holds"
                                      : "nothing lies within it";
    throw Error(Exit::bad_input, what + why + "; close or repair the mesh");
}

void note_undecided(const VolumeSamples& m, Notes& notes) {
    const double solid = sum(m.solid), undecided = sum(m.undecided);
    if (!(undecided > kTold * solid)) return;
    const auto worst =
        static_cast<std::size_t>(std::max_element(m.undecided.begin(), m.undecided.end()) - m.undecided.begin());
    notes.push_back({.code = NoteCode::volume_undecided,
                     .amount = undecided,
                     .layer = static_cast<std::int64_t>(m.layers[worst]),
                     .x = m.where[worst].x,
                     .y = m.where[worst].y,
                     .detail = percent(undecided / solid)});
}

// Notes the volume that flat lids may have lost. The estimate assumes that each hole was a half sphere over a disc of
// the lid's area.
void note_holes(const Part& part, double solid, Notes& notes) {
    double hidden = 0, largest = 0;
    geom::Vec3 at;
    for (const mesh::Hole& h : part.holes) {
        const double bulge = 2.0 / 3 / std::sqrt(std::acos(-1.0)) * h.area * std::sqrt(h.area);
        hidden += bulge;
        if (bulge > largest) {
            largest = bulge;
            at = h.middle;
        }
    }
    if (!(hidden > kTold * solid)) return;
    notes.push_back({.code = NoteCode::hole_closed_flat,
                     .amount = hidden,
                     .count = part.holes.size(),
                     .x = at.x,
                     .y = at.y,
                     .detail = percent(hidden / solid)});
}

void note_empty(const Sweep& sweep, std::span<const double> area, Notes& notes) {
    const auto full = [](double a) { return a > 0; };
    const auto first = std::find_if(area.begin(), area.end(), full);
    const auto last = std::find_if(area.rbegin(), area.rend(), full).base();
    for (auto it = first; it < last; ++it) {
        if (*it > 0) continue;
        const auto i = static_cast<std::size_t>(it - area.begin());
        notes.push_back(
            {.code = NoteCode::layer_empty, .amount = sweep.levels[i].height, .layer = static_cast<std::int64_t>(i)});
    }
}

} // namespace

VolumeSamples measure(const Sweep& sweep, std::size_t planes, std::size_t points, int threads) {
    const std::size_t n = sweep.levels.size(), asked = std::min(n, std::max<std::size_t>(1, planes / 2));
    const std::size_t each = std::max<std::size_t>(2, planes / 4 / asked);
    VolumeSamples out;
    for (std::size_t k = 0; k < asked; ++k) { // one random layer out of each of `asked` equal stretches
        const double at =
            (static_cast<double>(k) + (asked < n ? as_share(mixed(k + 1)) : 0.5)) / static_cast<double>(asked);
        out.layers.push_back(std::min(n - 1, static_cast<std::size_t>(at * static_cast<double>(n))));
    }
    const Sweep probe = sweep_over(*sweep.part, sweep.options, levels_within(sweep, out.layers, each), threads);
    const geom::Box3 box = mesh::bounds(sweep.part->mesh);
    const bool hollow = std::find(sweep.part->bodies.hollow.begin(), sweep.part->bodies.hollow.end(), 1) !=
                        sweep.part->bodies.hollow.end();
    std::vector<Reading> found(probe.levels.size());
    parallel::for_chunks(probe.chunks(), 1, threads, [&](std::size_t from, std::size_t to) {
        for (std::size_t c = from; c < to; ++c) {
            std::size_t i = c * kChunk;
            for (const Section& s : sections(probe, c)) {
                if (!s.open.empty())
                    found[i] = read_points(*sweep.part, probe.levels[i].plane, box, points / found.size() + 1, i);
                else
                    found[i].solid = polygon::is_simple(s.loops) ? std::abs(polygon::signed_area(s.loops))
                                                                 : area_by_rows(s.loops, hollow);
                ++i;
            }
        }
    });
    out.solid.assign(asked, 0);
    out.undecided.assign(asked, 0);
    out.where.resize(asked);
    const double level = level_within(found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::size_t k = i / each;
        const double h = probe.levels[i].height;
        out.solid[k] += h * found[i].solid;
        for (std::size_t p = 0; p < found[i].winding.size(); ++p) {
            const double w = found[i].winding[p], turns = w / level;
            if (w > 0.5) out.solid[k] += h * found[i].cell;
            if (std::abs(turns - std::round(turns)) > kUncertain) out.baseless += h * found[i].cell;
            const bool inside_out = w < -0.5; // part of the surface faces the wrong way
            if (std::abs(w - std::round(w)) <= kUncertain && !inside_out) continue;
            if (out.undecided[k] == 0) out.where[k] = found[i].point[p];
            out.undecided[k] += h * found[i].cell;
        }
    }
    return out;
}

std::optional<VolumeSamples> judge(const Sweep& sweep, int threads, Notes& notes) {
    if (sweep.part->winding == nullptr) return std::nullopt;
    for (const bool first : {true, false}) {
        VolumeSamples m =
            first ? measure(sweep, kFirstPlanes, kFirstPoints, threads) : measure(sweep, kPlanes, kPoints, threads);
        const double solid = sum(m.solid);
        if (!(solid > m.baseless)) no_solid(solid, m.baseless);
        if (first) continue;
        note_undecided(m, notes);
        note_holes(*sweep.part, solid, notes);
        return m;
    }
    return std::nullopt;
}

void compare(const Sweep& sweep, const std::optional<VolumeSamples>& measured, std::span<const double> area,
             int threads, Notes& notes) {
    note_empty(sweep, area, notes);
    double all = 0;
    for (std::size_t i = 0; i < area.size(); ++i) all += area[i] * sweep.levels[i].height;
    if (!measured) {
        const double solid = mesh::volume(sweep.part->mesh);
        if (std::abs(all - solid) <= kTold * solid) return;
    }
    const VolumeSamples m = measured ? *measured : measure(sweep, kPlanes, kPoints, threads);
    double printed = 0, solid = 0, most = 0;
    std::size_t worst = 0;
    for (std::size_t k = 0; k < m.layers.size(); ++k) {
        const double here = area[m.layers[k]] * sweep.levels[m.layers[k]].height;
        printed += here;
        solid += m.solid[k];
        if (std::abs(here - m.solid[k]) > most) {
            most = std::abs(here - m.solid[k]);
            worst = m.layers[k];
        }
    }
    if (!(std::abs(printed - solid) > kTold * solid)) return;
    const double share = solid > 0 ? printed / solid - 1 : 1;
    const double all_layers = static_cast<double>(area.size()) / static_cast<double>(m.layers.size());
    notes.push_back({.code = NoteCode::volume_off,
                     .amount = all_layers * std::abs(printed - solid),
                     .layer = static_cast<std::int64_t>(worst),
                     .detail = percent(std::abs(share)) + (share > 0 ? " above" : " below")});
}

} // namespace filum::slice
