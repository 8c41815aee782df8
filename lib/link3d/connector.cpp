// Joins to regions that do not lie above: strands that are not part of the part.
#include "geom/segment.hpp"
#include "link3d/linker.hpp"

#include <algorithm>
#include <array>

namespace filum::link3d {

namespace {

using toolpath::Role;
using toolpath::Span;

constexpr double kNeck = 0.4;       // of the flow: where a connector is to break off
constexpr double kNeckLength = 2;   // bead widths
constexpr double kDetourMargin = 2; // bead widths between the part and the way around
constexpr double kUncarried = 0.1;  // share of a carried connector that may hang free
constexpr double kClearance = 0.05; // mm between the head and what it passes

// Puts a point into the way `at` mm from its beginning, measured in XY.
void insert_point(std::vector<Vec3>& way, double at) {
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const double l = geom::distance(way[i].xy(), way[i + 1].xy());
        if (at < l) {
            const double t = at / l;
            if (at > 0)
                way.insert(way.begin() + static_cast<std::ptrdiff_t>(i + 1),
                           {way[i].x + t * (way[i + 1].x - way[i].x), way[i].y + t * (way[i + 1].y - way[i].y),
                            way[i].z + t * (way[i + 1].z - way[i].z)});
            return;
        }
        at -= l;
    }
}

double length_xy(std::span<const Vec3> way) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) sum += geom::distance(way[i].xy(), way[i + 1].xy());
    return sum;
}

// The widths of a connector that is thin at both ends; adds the points where that changes.
std::vector<double> necks(std::vector<Vec3>& way, double width) {
    const double all = length_xy(way), neck = std::min(kNeckLength * width, all / 4), change = neck / 4;
    for (const double at : {neck, neck + change, all - neck - change, all - neck}) insert_point(way, at);
    std::vector<double> out;
    double s = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (i > 0) s += geom::distance(way[i - 1].xy(), way[i].xy());
        const double in = std::min(s, all - s);
        out.push_back(width * (kNeck + (1 - kNeck) * std::clamp((in - neck) / change, 0.0, 1.0)));
    }
    return out;
}

} // namespace

// mm of the connector below which there is neither the bed nor a connector one layer below.
double Linker::uncarried(std::span<const Vec3> way) const {
    const auto& r = window_.front();
    double free = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const double l = geom::distance(way[i].xy(), way[i + 1].xy()), z = way[i].z;
        if (l == 0 || z < 1.5 * r.paths.height) continue;
        const int pieces = static_cast<int>(std::ceil(l / r.width));
        for (int k = 0; k < pieces; ++k) {
            const Vec2 p = geom::lerp(way[i].xy(), way[i + 1].xy(), (k + 0.5) / pieces);
            const bool carried = std::any_of(strands_.begin(), strands_.end(), [&](const auto& s) {
                const double down = z - s.first.z;
                return down > 0.5 * r.paths.height && down < 1.5 * r.paths.height &&
                       geom::point_segment_distance(s.first.xy(), s.second.xy(), p) < r.width;
            });
            if (!carried) free += l / pieces;
        }
    }
    return free;
}

// The way around the part to one of the front region's extreme places, or to an end of an open curve there.
std::optional<std::pair<std::vector<Vec3>, Linker::Entry>> Linker::way_around(double margin) const {
    const auto& r = window_.front();
    const auto free = [&](Vec3 a, Vec3 b) {
        const bool leaves = a == *at_;
        return leads_out(a, b, leaves ? *last_ : r.index, leaves) && misses_others(a, b, leaves);
    };
    const auto clear = [&](Vec3 a, Vec3 b) { return misses_strands(a, b) && !printed_.hits(a, b, options_.head); };
    std::optional<std::pair<std::vector<Vec3>, Entry>> best;
    const auto consider = [&](const Entry& entry) {
        auto way = around(around_, margin, *at_, at_height(entry.place.point, r.paths.z), free, clear);
        if (way && (!best || length(*way) < length(best->first))) best = {std::move(*way), entry};
    };
    for (const Place& p : r.index.extremes()) {
        const auto& curve = r.paths.curves[p.curve];
        if (curve.closed) {
            consider({p});
            continue;
        }
        const auto n = static_cast<std::uint32_t>(curve.points.size());
        consider({{p.curve, 0, 0, curve.points.front(), 0}});
        consider({{p.curve, n - 2, 1, curve.points.back(), 0}, true});
    }
    return best;
}

// A connector outside everything printed to whichever place of the front region makes it the shortest; close to the
// part, or where the head must come down beside it, as far away as the head is wide.
std::optional<Linker::Entry> Linker::go_around(const Emit& emit, Notes& notes) {
    const auto& r = window_.front();
    if (!may_climb_ || !last_) return std::nullopt;
    if (around_.empty()) around_ = all_bounds();
    const auto& head = options_.head;
    const double cone = head.cone_radius(head.cone_height), carriage = std::max(head.carriage_x, head.carriage_y) / 2;
    std::optional<std::pair<std::vector<Vec3>, Entry>> best;
    for (const double margin : {kDetourMargin * r.width, cone + kClearance, carriage + kClearance})
        if ((best = way_around(margin))) break;
    if (!best) return std::nullopt;
    auto& [way, entry] = *best;
    const double free = uncarried(way);
    if (options_.strand == Strand::carried && free > kUncarried * length_xy(way)) return std::nullopt;
    ++counts_.connectors;
    counts_.connector_length += length_xy(way);
    counts_.connector_free += free;
    const Vec3 middle = way[way.size() / 2];
    joins_.push_back({false, {way[way.size() - 2].xy(), way.back().xy()}, {r.width}});
    printed_.connector(way);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) strands_.emplace_back(way[i], way[i + 1]);
    printed_.begin(); // the two ends of a connector are two bodies
    auto width = necks(way, r.width);
    at_ = way.back();
    const Span span{Role::connector, stroke_,          r.paths.layer,   r.paths.region,
                    std::move(way),  std::move(width), {r.paths.height}};
    double volume = 0;
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) volume += toolpath::volume(span, i);
    counts_.connector_volume += volume;
    notes.push_back({"", "connector to be trimmed", volume, "mm3", 1, r.paths.layer, middle.x, middle.y});
    emit(span);
    return entry;
}

// A strand straight over to the front region, if that is on the same layer and nothing of it is crossed.
std::optional<Linker::Entry> Linker::go_inside(const Emit& emit) {
    const auto& r = window_.front();
    if (!beside_last()) return std::nullopt;
    const auto entry = nearest_entry(r, at_->xy(), std::numeric_limits<double>::infinity(), {});
    if (!entry) return std::nullopt;
    const Vec3 a = *at_, b = at_height(entry->place.point, r.paths.z);
    if (!is_free(*last_, a.xy(), b.xy(), Linker::kMargin, kEnds, 0) || !leads_out(b, a, r.index, true) ||
        printed_.hits(a, b, options_.head))
        return std::nullopt;
    if (!misses_others(a, b, false)) return std::nullopt;
    ++counts_.strands;
    counts_.strand_length += entry->place.distance;
    printed_.begin();
    jog(*entry, emit);
    return entry;
}

// Of the part: of what is printed, and of all regions that are known.
Box2 Linker::all_bounds() const {
    Box2 box = printed_.bounds();
    for (const auto& w : window_)
        if (!w.index.empty()) {
            box.add(w.index.bounds().lo);
            box.add(w.index.bounds().hi);
        }
    return box;
}

// The straight way at one height meets no region of its layer that is still to be printed, the front one only if
// `front`.
bool Linker::misses_others(Vec3 a, Vec3 b, bool front) const {
    const double near = window_.front().paths.height / 2;
    return std::all_of(window_.begin() + (front ? 0 : 1), window_.end(), [&](const Waiting& w) {
        return std::abs(w.paths.z - a.z) > near || is_free(w.index, a.xy(), b.xy(), Linker::kMargin, 0, 0);
    });
}

// The way crosses no connector within its own layer.
bool Linker::misses_strands(Vec3 a, Vec3 b) const {
    const double thick = 0.99 * window_.front().paths.height;
    return std::none_of(strands_.begin(), strands_.end(), [&](const auto& s) {
        const auto& [c, d] = s;
        return std::min(a.z, b.z) < std::max(c.z, d.z) + thick && std::min(c.z, d.z) < std::max(a.z, b.z) + thick &&
               geom::cross_properly(a.xy(), b.xy(), c.xy(), d.xy());
    });
}

// A straight way at one height crosses nothing of its own region, and meets nothing else that is as high.
bool Linker::leads_out(Vec3 a, Vec3 b, const SegmentIndex& own, bool leaves) const {
    const auto& r = window_.front();
    return is_free(own, a.xy(), b.xy(), Linker::kMargin, kEnds, 0) &&
           !printed_.blocks(a, b, a.z - r.paths.height / 2, kDetourMargin * r.width, leaves);
}

} // namespace filum::link3d
