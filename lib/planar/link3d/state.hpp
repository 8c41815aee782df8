// The state between two joins: what was printed, where the nozzle is, and the regions that come next. Plain data; the
// functions for the kinds of joins (climb, beside, connector, lane, shift, helix) read it and add their spans.
#pragma once

#include "base/note.hpp"
#include "link3d/bead.hpp"
#include "link3d/counts.hpp"
#include "link3d/options.hpp"
#include "link3d/ramp.hpp"
#include "link3d/stacked.hpp"
#include "link3d/travel.hpp"
#include "link3d/waiting.hpp"

#include <array>
#include <deque>
#include <utility>

namespace filum::link3d {

inline constexpr double kThin = 0.5;     // of the bead width: joins over material, and lanes between beads
inline constexpr double kMargin = 0.003; // mm; joins keep this distance from beads: more than the rounding in programs
inline constexpr double kEnds = 0.01;    // mm at the ends of a join, which lie on beads, where kMargin does not hold
inline constexpr double kOn = 0.02;      // mm; a nozzle this close to a bead counts as on it

// One turn of a helix.
struct HelixLap {
    toolpath::Curve line;      // open
    std::vector<double> along; // share of its length, 0 to 1, per point
};

// Where the nozzle must get to from the front region: `outside` is beyond the outline of this region.
enum class NextPlace : std::uint8_t { anywhere, above, outside };

// The region that is being printed.
struct Front {
    NextPlace next = NextPlace::anywhere;
    Vec2 start;                          // where it was entered
    Ramp ramp;                           // the ramp by which it was entered, until its first curve is printed
    bool winds = false;                  // it is printed as a turn of a helix
    std::vector<toolpath::Span> spans;   // printed so far; each begins where the one before it ended
    std::vector<toolpath::Curve> joins;  // lines of lifts and jogs on its layer
    std::optional<Vec2> pin;             // where a jog leaves its curve; must become a point of the curve
    std::optional<StackedWalls> stacked; // its walls in two passes
};

// The region before.
struct PreviousRegion {
    bool printed = false; // something of it was printed
    double width = 0;     // mm, of its beads
    // The lines of all regions printed on its layer, as printed; its own are the last. Kept only if joins on that layer
    // may leave it.
    std::vector<SegmentIndex> lines;
    double z = 0; // mm, height of `lines`
};

// The column that is being climbed.
struct Column {
    Vec2 home;                   // where it began
    double offset = 0;           // bead widths, from `home` to the layer's start
    std::optional<HelixLap> lap; // turn of a helix below the front region
};

struct State {
    explicit State(const Options& how) : options(how) {}

    Options options;
    std::deque<WaitingRegion> window; // the front one is printed next; at most look_ahead + 1
    std::optional<Vec3> at;           // position of the nozzle
    std::uint32_t stroke = 0;
    Front front;
    PreviousRegion before;
    Column column;
    PrintedBodies printed;
    std::vector<std::pair<Vec3, Vec3>> strands; // strands, and legs of connectors
    Box2 around;                                // the box that connectors go around
    Counts counts;
    Notes notes;

    [[nodiscard]] const WaitingRegion& region() const { return window.front(); }
};

inline Vec3 at_height(Vec2 p, double z) { return {p.x, p.y, z}; }

// How many of the regions after the front one climb from it without a break; at most look_ahead.
std::size_t climbing(const State& state);

// Whether the next region is entered from the front one, which is a brim.
bool leads_in(const State& state);

// Whether the lines of the region before are kept, and it lies on the front region's layer.
bool beside_last(const State& state);

// Keeps the lines of the front region for joins that leave it on its own layer, and for joins that must not cross it
// there.
void keep_lines(State& state, SegmentIndex as_printed);

// Whether the straight way a -> b on the layer of the region before crosses nothing printed there. It begins on that
// region.
bool leaves_freely(const State& state, Vec2 a, Vec2 b);

// Whether the straight way a -> b crosses no strand or connector at its height.
bool misses_strands(const State& state, Vec3 a, Vec3 b);

// The longest jogs to a region, in mean widths of both regions, in the order in which they are tried. A climb first
// tries a length at which the jog begins within the region above. A longer jog could begin above a neighbour of that
// region and cross its outer bead. That does not limit jogs to open curves, such as those of scaffolds, whose strands
// span gaps anyway. From a brim, a jog leads over the outline from the middle of one bead to that of the
// next; both lengths are the same.
std::array<double, 2> reaches(const State& state, const WaitingRegion& to);

// The curves of the front region as they are printed, with curve `c` as `bead`, and all joins and the lane beside them.
std::vector<toolpath::Curve> as_printed(const State& state, std::uint32_t c, const Bead& bead,
                                        const std::vector<Vec2>& lane = {});

// An empty span of the front region.
toolpath::Span span(const State& state, toolpath::Role role);

// Adds the span to the front region and moves the nozzle to its end.
void put(State& state, toolpath::Span span);

// Prints a thin bead. `height`: mm, per point or one for all; empty for the height of the layer.
void extrude(State& state, toolpath::Role role, std::vector<Vec3> points, std::vector<double> height = {});

// Keeps the line from the nozzle to `to` among the joins of the front region's layer.
void keep_join(State& state, Vec2 to);

// Prints a straight jog to a place of the front region, on its layer.
void jog(State& state, const Entry& entry);

// Travels to `to` on the front region's layer without extruding, and begins a new stroke.
void stop_and_travel(State& state, Vec2 to);

} // namespace filum::link3d
