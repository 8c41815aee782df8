#include "link3d/linker.hpp"

#include "link3d/beside.hpp"
#include "link3d/climb.hpp"
#include "link3d/connector.hpp"
#include "link3d/curve.hpp"
#include "link3d/entry.hpp"
#include "link3d/settle.hpp"

#include <utility>

namespace filum::link3d {

namespace {

using toolpath::Span;

// The curve of the front region that should be printed last: the one longer than all others together, if the next
// region climbs from this one. The next region is most likely in reach from there. Nothing if there is no such curve.
std::optional<std::uint32_t> main_curve(const State& state) {
    const auto& curves = state.region().paths.curves;
    if (curves.size() < 2 || climbing(state) == 0) return std::nullopt;
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

// The reason why the front region could not be joined to the one before it.
NoteCode no_climb(const State& state) {
    if (!state.before.printed) return NoteCode::join_no_bead;
    if (state.region().paths.join == Join::beside) return NoteCode::join_brim;
    return rises(state) ? NoteCode::join_out_of_reach : NoteCode::join_unsupported;
}

// Moves the nozzle to the front region's first curve, by a join or by a travel.
Entry enter(State& state) {
    const auto& r = state.region();
    const bool above = goes_on(r);
    std::optional<Entry> joined;
    if (above)
        joined = r.paths.join == Join::beside ? step_in(state) : climb(state);
    else if (state.at && state.options.connect == Connect::outside)
        joined = go_around(state);
    else if (state.at && state.options.connect == Connect::inside)
        joined = go_inside(state);
    if (joined && !above) {
        state.column.home = joined->place.point;
        state.column.offset = 0;
    }
    if (joined) {
        count_passed_paint(state);
        return *joined;
    }
    if (state.at && (above || state.options.connect != Connect::stop)) {
        ++state.counts.broken;
        const Vec3 at = *state.at;
        state.notes.push_back(
            {above ? no_climb(state) : NoteCode::connector_impossible, 0, 1, r.paths.layer, at.x, at.y});
    }
    Entry entry = start_entry(state);
    if (const auto other = other_end(state, entry)) entry = *other;
    if (state.options.paint) entry = by_paint(state, entry);
    stop_and_travel(state, entry.place.point);
    state.column.home = entry.place.point;
    state.column.offset = 0;
    return entry;
}

// Moves to the front region and prints its curves, one after the other.
void print_region(State& state) {
    const auto& r = state.region().paths;
    const Entry first = enter(state);
    state.front.start = first.place.point;
    std::vector<char> done(r.curves.size(), 0);
    Entry entry = first;
    const auto main = main_curve(state);
    for (std::size_t left = r.curves.size(); left > 0; --left) {
        if (main) done[*main] = left > 1 || *main == first.place.curve ? 1 : 0;
        if (left < r.curves.size()) entry = hop(state, done);
        done[entry.place.curve] = 1;
        print_curve(state, entry, left == 1);
    }
}

// Where the nozzle must get to from the front region.
NextPlace next(const State& state) {
    if (state.window.size() < 2 || state.window[1].paths.curves.empty()) return NextPlace::anywhere;
    if (goes_on(state.window[1])) return NextPlace::above;
    const Connect connect = state.options.connect;
    const bool same_layer = state.window[1].paths.layer == state.region().paths.layer;
    return connect == Connect::outside || (connect == Connect::inside && same_layer) ? NextPlace::outside
                                                                                     : NextPlace::anywhere;
}

} // namespace

void Linker::add(toolpath::RegionPaths region, const Emit& emit, Notes& notes) {
    if (region.join == Join::start) ++state_.counts.planned;
    state_.window.push_back(waiting(std::move(region)));
    // Connectors and strands must keep clear of all regions, so all regions must be known.
    if (state_.options.connect == Connect::stop &&
        static_cast<std::int64_t>(state_.window.size()) > state_.options.look_ahead)
        print_front(emit, notes);
}

void Linker::print_front(const Emit& emit, Notes& notes) {
    const WaitingRegion& r = state_.region();
    state_.front = {};
    state_.before.printed = state_.before.printed && !r.paths.curves.empty();
    if (!r.paths.curves.empty()) {
        state_.front.next = next(state_);
        print_region(state_);
        settle(state_);
        for (const Span& s : state_.front.spans) emit(s);
        state_.at = state_.front.spans.back().points.back();
        state_.printed.add(r.index.bounds(), r.widest, r.paths.z);
        state_.before.printed = true;
        state_.before.width = r.width;
    } else if (r.paths.area > 0) {
        state_.notes.push_back({NoteCode::region_without_bead, r.paths.area, 1, r.paths.layer});
    }
    notes.insert(notes.end(), state_.notes.begin(), state_.notes.end());
    state_.notes.clear();
    state_.window.pop_front();
}

void Linker::finish(const Emit& emit, Notes& notes) {
    while (!state_.window.empty()) print_front(emit, notes);
    const Counts& c = state_.counts;
    if (c.paint_passed > 0)
        notes.push_back({NoteCode::seam_paint_passed, static_cast<double>(c.paint_passed), c.paint_passed});
    if (c.strokes > c.planned) notes.push_back({NoteCode::strokes_more, static_cast<double>(c.strokes - c.planned), 1});
}

} // namespace filum::link3d
