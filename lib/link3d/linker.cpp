#include "link3d/linker.hpp"

#include "geom/segment.hpp"
#include "link3d/features.hpp"

#include <algorithm>
#include <utility>

namespace filum::link3d {

namespace {

using toolpath::Curve;
using toolpath::Role;
using toolpath::Span;

double region_width(const toolpath::RegionPaths& r) {
    double sum = 0;
    for (const auto& c : r.curves) sum += mean_width(c);
    return r.curves.empty() ? 0 : sum / static_cast<double>(r.curves.size());
}

} // namespace

Facts facts(const Counts& c) {
    const auto n = [](std::uint64_t count) { return static_cast<double>(count); };
    return {{"", "strokes", n(c.strokes), "strokes"},
            {"", "lifts", n(c.lifts), ""},
            {"", "ramps", n(c.ramps), ""},
            {"", "turns", n(c.turns), ""},
            {"", "lanes", n(c.lanes), ""},
            {"", "shifts", n(c.shifts), ""},
            {"", "kept-starts", n(c.kept), ""},
            {"", "jogs", n(c.jogs), ""},
            {"", "strands", n(c.strands), ""},
            {"", "brims", n(c.brims), ""},
            {"", "connectors", n(c.connectors), ""},
            {"", "breaks", n(c.breaks), ""},
            {"", "broken-joins", n(c.broken), ""},
            {"", "stops-in-regions", n(c.parted), ""},
            {"", "lift-length", c.lift_length, "mm"},
            {"", "lane-length", c.lane_length, "mm"},
            {"", "shift-length", c.shift_length, "mm"},
            {"", "jog-length", c.jog_length, "mm"},
            {"", "strand-length", c.strand_length, "mm"},
            {"", "connector-length", c.connector_length, "mm"},
            {"", "connector-free", c.connector_free, "mm"},
            {"", "connector-volume", c.connector_volume, "mm3"},
            {"", "travel-length", c.travel_length, "mm"}};
}

void Linker::add(toolpath::RegionPaths region, const Emit& emit, Notes& notes) {
    SegmentIndex index(region.curves);
    const double width = region_width(region);
    if (region.join == Join::start) ++counts_.planned;
    bool closed = false, open = false;
    for (const auto& c : region.curves) (c.closed ? closed : open) = true;
    window_.push_back({std::move(region), std::move(index), width, closed, open});
    // Connectors go around everything, so everything must be known.
    if (options_.connect != Connect::outside && static_cast<std::int64_t>(window_.size()) > options_.look_ahead)
        print_front(emit, notes);
}

void Linker::finish(const Emit& emit, Notes& notes) {
    while (!window_.empty()) print_front(emit, notes);
    if (counts_.strokes > counts_.planned)
        notes.push_back(
            {"", "more strokes than planned", static_cast<double>(counts_.strokes - counts_.planned), "strokes", 1});
}

void Linker::print_front(const Emit& emit, Notes& notes) {
    const auto& r = window_.front().paths;
    if (r.curves.empty()) {
        if (r.area > 0) notes.push_back({"", "region without a bead", r.area, "mm2", 1, r.layer});
        may_climb_ = false;
        window_.pop_front();
        return;
    }
    next_ = window_.size() < 2 || window_[1].paths.curves.empty()                      ? Next::anywhere
            : goes_on(window_[1])                                                      ? Next::above
            : options_.connect == Connect::outside                                     ? Next::outside
            : options_.connect == Connect::inside && window_[1].paths.layer == r.layer ? Next::outside
                                                                                       : Next::anywhere;
    std::vector<Span> spans;
    print_region([&](const Span& s) { spans.push_back(s); }, notes);
    settle(spans, notes);
    at_ = spans.back().points.back();
    for (const Span& s : spans) emit(s);
    joins_.clear();
    pin_.reset();
    printed_.add(window_.front().index.bounds(), r.z);
    may_climb_ = true;
    width_before_ = window_.front().width;
    window_.pop_front();
}

// Gets to the front region and prints its curves, one after the other.
void Linker::print_region(const Emit& emit, Notes& notes) {
    const auto& r = window_.front().paths;
    const Entry first = enter(emit, notes);
    start_ = first.place.point;
    std::vector<char> done(r.curves.size(), 0);
    Entry entry = first;
    const auto main = main_curve();
    for (std::size_t left = r.curves.size(); left > 0; --left) {
        if (main) done[*main] = left > 1 || *main == first.place.curve ? 1 : 0;
        if (left < r.curves.size()) entry = hop(done, emit, notes);
        done[entry.place.curve] = 1;
        print_curve(entry, left == 1, emit, notes);
    }
}

// The curve of the front region that is to be printed last, unless the region is entered there: the one that is longer
// than all others together, if the next region climbs from this one; from there it is most likely in reach.
std::optional<std::uint32_t> Linker::main_curve() const {
    const auto& curves = window_.front().paths.curves;
    if (curves.size() < 2 || climbing() == 0) return std::nullopt;
    double all = 0, longest = 0;
    std::uint32_t main = 0;
    for (std::uint32_t c = 0; c < curves.size(); ++c) {
        const double l = length(curves[c].points);
        all += l;
        if (l > longest) {
            longest = l;
            main = c;
        }
    }
    return longest > all / 2 ? std::optional(main) : std::nullopt;
}

// Why the front region, which is to be reached from the one below, was not.
const char* Linker::no_climb() const {
    if (!may_climb_) return "join broken, the region below has no bead";
    if (window_.front().paths.join == Join::beside) return "join broken, the brim is out of reach";
    return rises() ? "join broken, its ends are out of reach" : "join broken, it does not lie on the layer below";
}

// Gets the nozzle to the front region's first curve.
Linker::Entry Linker::enter(const Emit& emit, Notes& notes) {
    const auto& r = window_.front();
    const bool above = goes_on(r);
    std::optional<Entry> joined;
    if (above)
        joined = r.paths.join == Join::beside ? step_in(emit) : climb(emit);
    else if (at_ && options_.connect == Connect::outside)
        joined = go_around(emit, notes);
    else if (at_ && options_.connect == Connect::inside)
        joined = go_inside(emit);
    if (joined && !above) {
        home_ = joined->place.point;
        offset_ = 0;
    }
    if (joined) return *joined;
    if (at_ && (above || options_.connect != Connect::stop)) {
        ++counts_.broken;
        notes.push_back(
            {"", above ? no_climb() : "connector impossible, broken", 0, "", 1, r.paths.layer, at_->x, at_->y});
    }
    Entry entry = start_entry();
    if (const auto other = other_end(entry)) entry = *other;
    stop_and_travel(entry.place.point, emit);
    home_ = entry.place.point;
    offset_ = 0;
    return entry;
}

// The other end of the region's only curve, an open one, if beginning there it ends nearer to the next region.
std::optional<Linker::Entry> Linker::other_end(const Entry& entry) const {
    const auto& curves = window_.front().paths.curves;
    const Curve& curve = curves[entry.place.curve];
    if (curve.closed || curves.size() > 1 || next_ != Next::above) return std::nullopt;
    const auto left = [&](Vec2 end) { // to go from there
        return nearest_entry(window_[1], end, std::numeric_limits<double>::infinity(), {})->place.distance;
    };
    const Vec2 here = entry.place.point, there = entry.against ? curve.points.front() : curve.points.back();
    if (left(there) <= left(here) + window_[0].width / 2) return std::nullopt;
    const auto segment = entry.against ? 0 : static_cast<std::uint32_t>(curve.points.size()) - 2;
    return Entry{{0, segment, entry.against ? 0.0 : 1.0, there, 0}, !entry.against};
}

// The nozzle's way from one curve of the front region to the nearest one that is left.
Linker::Entry Linker::hop(std::span<const char> done, const Emit& emit, Notes& notes) {
    const auto& r = window_.front();
    auto entry = nearest_entry(r, at_->xy(), std::numeric_limits<double>::infinity(), done).value();
    const Vec2 to = entry.place.point;
    const bool near = entry.place.distance <= options_.reach * r.width;
    if (near && is_free(r.index, at_->xy(), to, kMargin, kEnds, kEnds) && crosses_no_join(at_->xy(), to)) {
        ++counts_.jogs;
        counts_.jog_length += entry.place.distance;
        jog(entry, emit);
    } else {
        ++counts_.parted;
        notes.push_back({"",
                         near ? "stop within a region, a bead lies between its curves"
                              : "stop within a region, its curves are out of reach of each other",
                         0, "", 1, r.paths.layer, at_->x, at_->y});
        stop_and_travel(to, emit);
    }
    return entry;
}

bool Linker::crosses_no_join(Vec2 a, Vec2 b) const {
    return std::none_of(joins_.begin(), joins_.end(),
                        [&](const Curve& j) { return geom::cross_properly(a, b, j.points[0], j.points[1]); });
}

// Prints one curve of the front region; the last one is left where the next region can be reached, if it can.
void Linker::print_curve(const Entry& entry, bool last, const Emit& emit, Notes& notes) {
    const auto& r = window_.front();
    const std::uint32_t c = entry.place.curve;
    const Curve& curve = r.paths.curves[c];
    const Ramp ramp = std::exchange(ramp_, {});
    const auto bead = [&](bool against) {
        Bead b = !curve.closed     ? run(curve, entry.against)
                 : ramp.length > 0 ? cut_over(curve, entry.place, against, ramp.length - ramp.lead)
                                   : cut(curve, entry.place, against, cut_gap(curve));
        if (pin_ && curve.closed) pin(b, *pin_, kOn);
        return b;
    };
    if (std::exchange(winds_, false)) {
        const bool goes_on = winds_on(entry);
        Bead end = wind(entry, goes_on, emit);
        if (goes_on) return;
        if (const auto lane = leave(c, end, [&] { return end; })) lay_lane(*lane, emit);
        return;
    }
    const bool turn = options_.alternate_direction && r.paths.layer % 2 != 0;
    Bead out = bead(turn);
    std::optional<std::vector<Vec2>> way;
    const bool shifts = last && next_ == Next::above && !leads_in() && curve.closed &&
                        options_.interlace != Interlace::none && !apart(out);
    if (shifts && (way = shift(c, out))) {
        ++counts_.shifts;
        counts_.shift_length += length(*way);
    }
    if (shifts && !way) {
        ++counts_.kept;
        notes.push_back({"", "start of the next layer not moved", 0, "", 1, r.paths.layer, start_.x, start_.y});
    }
    if (last && !way) way = leave(c, out, [&] { return curve.closed ? bead(!turn) : out; });
    if (way) thin_beside(out, *way, kThin * r.width, r.width, kThin, SegmentIndex(as_printed(c, out, {})), pin_);
    if (last && (options_.connect != Connect::stop || leads_in()))
        last_ = SegmentIndex(as_printed(c, out, way ? *way : std::vector<Vec2>{}));
    print(out, ramp, emit);
    if (way) lay_lane(*way, emit);
}

void Linker::lay_lane(const std::vector<Vec2>& way, const Emit& emit) {
    const auto& r = window_.front();
    std::vector<Vec3> points(way.size());
    std::transform(way.begin(), way.end(), points.begin(), [&](Vec2 p) { return at_height(p, r.paths.z); });
    extrude(Role::jog, std::move(points), {kThin * r.width}, emit);
}

void Linker::stop_and_travel(Vec2 to, const Emit& emit) {
    const auto& r = window_.front().paths;
    if (at_) {
        Span s{Role::travel, stroke_, r.layer, r.region, travel(printed_, *at_, at_height(to, r.z), options_.head),
               {},           {}};
        counts_.travel_length += length(s.points);
        ++counts_.breaks;
        ++stroke_;
        at_ = s.points.back();
        emit(s);
    } else {
        at_ = at_height(to, r.z);
    }
    ++counts_.strokes;
    printed_.begin();
}

void Linker::extrude(Role role, std::vector<Vec3> points, std::vector<double> width, const Emit& emit) {
    const auto& r = window_.front().paths;
    at_ = points.back();
    emit(Span{role, stroke_, r.layer, r.region, std::move(points), std::move(width), {r.height}});
}

void Linker::print(const Bead& bead, const Ramp& ramp, const Emit& emit) {
    if (print_stacked(bead, emit)) return;
    const auto& r = window_.front();
    Laid laid = lay(bead, r.paths.z, r.paths.height, ramp, r.width / 2);
    if (geom::distance(laid.points.front(), *at_) < kSamePoint) laid.points.front() = *at_; // spans chain exactly
    at_ = laid.points.back();
    emit_by_feature(Span{Role::bead, stroke_, r.paths.layer, r.paths.region, std::move(laid.points),
                         std::move(laid.width), std::move(laid.height)},
                    r.paths.curves, r.index, emit);
}

} // namespace filum::link3d
