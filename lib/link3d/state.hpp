// What is known between two joins: what was printed, where the nozzle is, and what is to come.  Plain data; the
// functions for the kinds of joins (climb, beside, connector, lane, shift, helix) read it and write down what they lay.
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

inline constexpr double kThin = 0.5;     // of the bead width: a bead laid where material is, or between two beads
inline constexpr double kMargin = 0.003; // mm; joins keep this far from beads: more than a digit of machine code
inline constexpr double kEnds = 0.01;    // mm; but for this much at their ends, which lie on beads
inline constexpr double kOn = 0.02;      // mm; a nozzle this near to a bead is on it

// One turn of a helix.
struct Turn {
    toolpath::Curve line;      // open
    std::vector<double> along; // 0 to 1 for each of its points
};

// Where the nozzle must get to from the front region.
enum class Next : std::uint8_t { anywhere, above, outside }; // outside: of this region

// Of the region that is being printed.
struct Front {
    Next next = Next::anywhere;
    Vec2 start;                         // where it was entered
    Ramp ramp;                          // by which it was entered, until its first curve is printed
    bool winds = false;                 // it is a turn of a helix
    std::vector<toolpath::Span> spans;  // what was laid; each begins where the one before it ended
    std::vector<toolpath::Curve> joins; // what lifts and jogs lay on its layer
    std::optional<Vec2> pin;            // a place of its curve where a jog leaves it: must be a point of it
    std::optional<Stacked> stacked;     // its walls in two passes
};

// Of the region before.
struct Before {
    bool printed = false; // something of it
    double width = 0;     // mm, of its beads
    // If joins on its layer may leave it: of all regions printed on that layer, as printed; its own are the last.
    std::vector<SegmentIndex> lines;
    double z = 0; // mm, of these
};

// Of the column that is climbed.
struct Column {
    Vec2 home;                // where it began
    double offset = 0;        // bead widths, of the layer's start from home
    std::uint64_t random = 0; // state of the generator for it
    std::optional<Turn> turn; // of the helix below the front region
};

struct State {
    explicit State(const Options& how) : options(how) { column.random = static_cast<std::uint64_t>(how.seed); }

    Options options;
    std::deque<Waiting> window; // the front one is printed next; at most look_ahead + 1
    std::optional<Vec3> at;     // where the nozzle is
    std::uint32_t stroke = 0;
    Front front;
    Before before;
    Column column;
    Printed printed;
    std::vector<std::pair<Vec3, Vec3>> strands; // and legs of connectors
    Box2 around;                                // what these go around
    Counts counts;
    Notes notes;

    [[nodiscard]] const Waiting& region() const { return window.front(); }
};

inline Vec3 at_height(Vec2 p, double z) { return {p.x, p.y, z}; }

// How many regions behind the front one climb from it without a break, of those that it looks ahead.
std::size_t climbing(const State& state);

// Whether the front region is a brim, from which the next one is entered.
bool leads_in(const State& state);

// Whether the region before, which is known as it was printed, is of the front region's layer.
bool beside_last(const State& state);

// Keeps the lines of the front region for joins that leave it on its own layer, or that must not cross it there.
void keep_lines(State& state, SegmentIndex as_printed);

// The straight way a -> b on the layer of the region before crosses nothing printed there.  It begins on that region.
bool leaves_freely(const State& state, Vec2 a, Vec2 b);

// The straight way a -> b crosses no strand or connector of its layer.
bool misses_strands(const State& state, Vec3 a, Vec3 b);

// The jogs to a region, in mean widths of both.  Of climbs those that begin within the region above are sought first,
// longer ones could begin above a neighbour of that region, and cross its outer bead.  From a brim they lead over the
// outline, from one bead's middle to the next.
std::array<double, 2> reaches(const State& state, const Waiting& to);

// The curves of the front region as they are printed, the curve `c` as `bead`, with all that joins them.
std::vector<toolpath::Curve> as_printed(const State& state, std::uint32_t c, const Bead& bead,
                                        const std::vector<Vec2>& lane = {});

// An empty span of the front region.
toolpath::Span span(const State& state, toolpath::Role role);

// Writes the span down; the nozzle is where it ends.
void put(State& state, toolpath::Span span);

// A span of a thin bead; `height` mm, per point or one for all: none where it is as thick as the layer.
void extrude(State& state, toolpath::Role role, std::vector<Vec3> points, std::vector<double> height = {});

// Keeps a join from where the nozzle is to `to` among those of the front region's layer.
void keep_join(State& state, Vec2 to);

// Straight to a place of the front region, on its layer.
void jog(State& state, const Entry& entry);

// To `to`, on the front region's layer, without extruding: a new stroke.
void stop_and_travel(State& state, Vec2 to);

} // namespace filum::link3d
