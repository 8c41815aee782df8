#include "metrics/planar/air.hpp"

#include "geom/segment_grid.hpp"
#include "metrics/planar/cover_tiles.hpp"
#include "metrics/planar/row_sections.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace filum::metrics::planar {

namespace {

constexpr double kRowsPerBead = 4;
constexpr double kFaint = 1e-3; // mm of bead, or mm2: less is rounding error

// The beads of a layer in printing order.
struct Track {
    std::vector<Bead> beads;
    std::vector<char> follows; // continues, without a stop, at the end of the bead before
    double mean = 0;           // mm, of their widths
};

// The beads of regions that are `layers` layers high; 0: of all.
Track track(const LayerBeads* from, unsigned layers) {
    Track out;
    double length = 0, area = 0;
    for (std::size_t k = 0; from != nullptr && k < from->runs.size(); ++k) {
        const BeadRun& p = from->runs[k];
        if (p.role == toolpath::Role::connector || (layers > 0 && p.layers != layers)) continue;
        for (std::size_t i = p.first; i + 1 < from->end(k); ++i) {
            const Bead b{from->points[i], from->points[i + 1], from->width[i], 0, 0};
            const bool after_bead = k > 0 && from->runs[k - 1].role != toolpath::Role::connector;
            out.follows.push_back(i > p.first || (p.continues && after_bead) ? 1 : 0);
            const double l = geom::distance(b.a, b.b);
            length += l;
            area += l * b.width;
            out.beads.push_back(b);
        }
    }
    out.mean = length > 0 ? area / length : 0;
    return out;
}

// The supporting beads: those of the layer below, wider by half a bead on each side.
std::vector<Bead> carriers(const Track& below, double half) {
    std::vector<Bead> out = below.beads;
    for (Bead& b : out) b.width += 2 * half;
    return out;
}

// The area under `beads` and not under `below`, mm2.
double uncovered(std::span<const Bead> beads, std::span<const Bead> below, double spacing) {
    const auto upper = swept_beads(beads), lower = swept_beads(below);
    double top = upper.front().hi, sum = 0;
    for (const SweptBead& l : upper) top = std::max(top, l.hi);
    spacing = std::max(spacing, (top - upper.front().lo) / kMostRows);
    const auto count = static_cast<std::size_t>(std::ceil((top - upper.front().lo) / spacing));
    const Rows rows{upper.front().lo + spacing / 2, spacing, count};
    if (tiles_pay(upper, rows)) return uncovered_by_tiles(upper, lower, rows);
    RowSweep printed(upper), under(lower);
    std::vector<Interval> up, low;
    for (std::size_t k = 0; k < count; ++k) {
        const double y = rows.at(k);
        printed.move_to(y, up);
        under.move_to(y, low);
        for (const Interval& i : up) sum += (i.hi - i.lo) * spacing;
        sum -= shared_length(up, low) * spacing;
    }
    return sum;
}

// The parts of beads outside of all supporting beads.
class CarrierBeads {
  public:
    explicit CarrierBeads(const std::vector<Bead>& carriers)
        : carrier_(carriers), segment_(segments(carriers)), reach_(reach(carriers)),
          grid_(segment_, geom::cell_for(segment_, reach_), reach_) {}

    // The unsupported intervals of the axis a -> b, mm from a.
    const std::vector<Interval>& free(Vec2 a, Vec2 b) {
        const double l = geom::distance(a, b);
        const Vec2 u = (1 / l) * (b - a);
        held_.clear();
        bool all = false;
        grid_.along(a, b, [&](std::uint32_t i) {
            if (all) return;
            const Bead& c = carrier_[i];
            const auto turned = [&](Vec2 p) { return Vec2{geom::dot(p - a, u), geom::cross(u, p - a)}; };
            const SweptBead lane = swept_bead({turned(c.a), turned(c.b), c.width});
            Interval s;
            if (!section(lane, 0, s) || s.hi <= 0 || s.lo >= l) return;
            all = s.lo <= 0 && s.hi >= l;
            held_.push_back(s);
        });
        free_.clear();
        if (all) return free_;
        unite(held_);
        double from = 0;
        for (const Interval& h : held_) {
            if (h.lo > from) free_.push_back({from, h.lo, 0});
            from = std::max(from, h.hi);
        }
        if (from < l) free_.push_back({from, l, 0});
        return free_;
    }

  private:
    static double reach(const std::vector<Bead>& carriers) {
        double out = kFaint;
        for (const Bead& b : carriers) out = std::max(out, b.width / 2);
        return out;
    }
    static std::vector<geom::Segment> segments(const std::vector<Bead>& carriers) {
        std::vector<geom::Segment> out;
        out.reserve(carriers.size());
        for (const Bead& b : carriers) out.push_back({b.a, b.b});
        return out;
    }

    const std::vector<Bead>& carrier_;
    std::vector<geom::Segment> segment_;
    double reach_; // mm
    geom::SegmentGrid grid_;
    std::vector<Interval> held_, free_;
};

void stretches(const Track& upper, const std::vector<Bead>& carriers, Air& air) {
    CarrierBeads carried(carriers);
    double now = 0; // of the current connected length
    Vec2 begin;
    for (std::size_t i = 0; i < upper.beads.size(); ++i) {
        const Bead& b = upper.beads[i];
        const double l = geom::distance(b.a, b.b);
        if (upper.follows[i] == 0) now = 0;
        double end = 0; // of the last unsupported interval
        for (const Interval& f : carried.free(b.a, b.b)) {
            if (f.lo > 0) now = 0;
            if (now == 0) begin = geom::lerp(b.a, b.b, f.lo / l);
            now += f.hi - f.lo;
            air.length += f.hi - f.lo;
            end = f.hi;
            if (now > air.longest) {
                air.longest = now;
                air.at = begin;
            }
        }
        if (end < l) now = 0;
    }
}

// Of the beads of regions that are `layers` layers high and begin on `below`.
Air hanging(const LayerBeads& layer, unsigned layers, const LayerBeads* below, double pixel) {
    Air air;
    const Track upper = track(&layer, layers);
    if (upper.beads.empty()) return air;
    const std::vector<Bead> held = carriers(track(below, 0), upper.mean / 2);
    air.area = uncovered(upper.beads, held, pixel > 0 ? pixel : upper.mean / kRowsPerBead);
    stretches(upper, held, air);
    if (air.area < kFaint) air.area = 0;
    if (air.length < kFaint) air.length = air.longest = 0;
    return air;
}

void add_worst(const Air& further, std::uint32_t layer, Air& to) {
    to.area += further.area;
    to.length += further.length;
    if (further.longest <= to.longest) return;
    to.longest = further.longest;
    to.layer = layer;
    to.at = further.at;
}

// All beads of a layer, each on the layer where its region begins. `lowest`: the number of the lowest layer.
Air hanging(const Beads& beads, std::uint32_t layer, std::uint32_t lowest, double pixel) {
    const LayerBeads& own = beads.layer.at(layer);
    std::set<std::uint8_t> heights;
    for (const BeadRun& run : own.runs) heights.insert(run.layers);
    Air out;
    for (const std::uint8_t layers : heights) {
        if (layer < lowest + layers) continue; // on the bed
        const auto below = beads.layer.find(layer - layers);
        add_worst(hanging(own, layers, below == beads.layer.end() ? nullptr : &below->second, pixel), layer, out);
    }
    return out;
}

} // namespace

Air measure_air(const Beads& beads, double pixel, int threads) {
    std::vector<std::uint32_t> index;
    for (const auto& [layer, b] : beads.layer) index.push_back(layer);
    std::vector<Air> each(index.size());
    parallel::for_chunks(index.size(), 1, threads,
                         [&](std::size_t i, std::size_t) { each[i] = hanging(beads, index[i], index.front(), pixel); });
    Air out;
    for (std::size_t i = 0; i < each.size(); ++i) {
        out.layers += each[i].area > 0 || each[i].length > 0 ? 1 : 0;
        add_worst(each[i], index[i], out);
    }
    return out;
}

} // namespace filum::metrics::planar
