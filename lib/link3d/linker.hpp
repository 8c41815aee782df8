// Curves to one toolpath: where each is entered and left, and how one gets from each to the next.
//
// A closed curve is cut where it is entered, so its exit lies beside its entry.  From there a region above is entered
// at the nearest place of its curve: a plain lift, then a short jog that cannot cross that curve.  If the region above
// is out of reach, a lane is laid from the exit along the middle of the strip between two lanes of the curve
// (strip_route.hpp), at half a bead's width, and the beads on both sides give up what it deposits.  Looking some
// regions ahead, entries drift towards where the column goes, so that such lanes stay rare (docs/algorithms/link3d.md).
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "link3d/bead.hpp"
#include "link3d/options.hpp"
#include "link3d/segment_index.hpp"
#include "link3d/stacked.hpp"
#include "link3d/travel.hpp"
#include "toolpath/path.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

namespace filum::link3d {

// Every join of two curves, by class; strokes = breaks + 1.
struct Counts {
    std::uint64_t strokes = 0;
    std::uint64_t planned = 0;    // strokes, by the joins that the input asks for
    std::uint64_t lifts = 0;      // to a region above
    std::uint64_t ramps = 0;      // of those, by a ramp
    std::uint64_t turns = 0;      // regions that are a turn of a helix
    std::uint64_t lanes = 0;      // of those, with a lane through the region below
    std::uint64_t shifts = 0;     // lanes to where the next layer is to begin
    std::uint64_t kept = 0;       // starts that were to move and could not
    std::uint64_t jogs = 0;       // between curves of a region
    std::uint64_t strands = 0;    // to another region of the layer, straight
    std::uint64_t brims = 0;      // from the brim to its region
    std::uint64_t connectors = 0; // outside the part
    std::uint64_t breaks = 0;
    std::uint64_t broken = 0; // of those, where the input asked for a join
    std::uint64_t parted = 0; // and between curves of a region
    double lift_length = 0, lane_length = 0, shift_length = 0, jog_length = 0, strand_length = 0, connector_length = 0,
           travel_length = 0;    // mm
    double connector_free = 0;   // mm of connectors that nothing carries
    double connector_volume = 0; // mm3
};

// The counts by name, for the stream.
Facts facts(const Counts& counts);

// Takes the regions in processing order, gives the spans in printing order.  Keeps at most look_ahead + 1 regions.
// Every span begins where the one before it ended.
class Linker {
  public:
    using Emit = std::function<void(const toolpath::Span&)>;
    explicit Linker(const Options& options) : options_(options), random_(options.seed) {}

    void add(toolpath::RegionPaths region, const Emit& emit, Notes& notes);
    void finish(const Emit& emit, Notes& notes); // prints what is still waiting
    [[nodiscard]] const Counts& counts() const { return counts_; }

  private:
    // A region that waits to be printed.
    struct Waiting {
        toolpath::RegionPaths paths;
        SegmentIndex index;
        double width;      // mm, mean of its beads
        bool closed, open; // has curves of this kind
    };
    // Where a curve is entered: for an open one at its first point, or its last.
    struct Entry {
        Place place;
        bool against = false;
    };

    // Where the nozzle must get to from the front region.
    enum class Next : std::uint8_t { anywhere, above, outside }; // outside: of this region

    static constexpr double kThin = 0.5;     // of the bead width: a bead laid where material is, or between two beads
    static constexpr double kMargin = 0.003; // mm; joins keep this far from beads: more than a digit of machine code
    static constexpr double kEnds = 0.01;    // mm; but for this much at their ends, which lie on beads
    static constexpr double kOn = 0.02;      // mm; a nozzle this near to a bead is on it
    static Vec3 at_height(Vec2 p, double z) { return {p.x, p.y, z}; }

    // One turn of a helix.
    struct Turn {
        toolpath::Curve line;      // open
        std::vector<double> along; // 0 to 1 for each of its points

        [[nodiscard]] std::optional<double> at(const SegmentIndex& index, Vec2 p, double t, double reach) const;
    };

    void print_front(const Emit& emit, Notes& notes);
    void print_region(const Emit& emit, Notes& notes);
    void settle(std::vector<toolpath::Span>& spans, Notes& notes) const; // settle.cpp
    Entry enter(const Emit& emit, Notes& notes);
    [[nodiscard]] std::optional<Entry> other_end(const Entry& entry) const;
    [[nodiscard]] std::optional<Entry> climb_to() const;
    std::optional<Entry> climb(const Emit& emit);
    std::optional<Entry> step_in(const Emit& emit);
    [[nodiscard]] bool beside_last() const;
    void jog(const Entry& entry, const Emit& emit);
    [[nodiscard]] std::optional<std::uint32_t> main_curve() const;
    Entry hop(std::span<const char> done, const Emit& emit, Notes& notes);
    [[nodiscard]] const char* no_climb() const;
    [[nodiscard]] bool rises() const;
    [[nodiscard]] bool crosses_no_join(Vec2 a, Vec2 b) const;
    void print_curve(const Entry& entry, bool last, const Emit& emit, Notes& notes);

    // joins.cpp
    // The jogs to a region, in mean widths of both.  Of climbs those that begin within the region above are sought
    // first, longer ones could begin above a neighbour of that region, and cross its outer bead.  From a brim they lead
    // over the outline, from one bead's middle to the next.
    [[nodiscard]] std::array<double, 2> reaches(const Waiting& to) const {
        if (to.paths.join == Join::beside) return {options_.reach, options_.reach};
        return {std::min(options_.reach, 0.6), std::min(options_.reach, 1.0)};
    }
    // Whether a region is to be reached from the one before.
    static bool goes_on(const Waiting& r) { return r.paths.join != Join::start; }
    [[nodiscard]] bool leads_in() const { return window_.size() > 1 && window_[1].paths.join == Join::beside; }
    [[nodiscard]] bool sees_outside(Vec2 p, const SegmentIndex& own) const;
    [[nodiscard]] int rank_above(Vec2 p, int least, double reach) const;
    [[nodiscard]] bool ends_well(std::uint32_t c, const Bead& bead, double reach) const;
    [[nodiscard]] std::vector<toolpath::Curve> as_printed(std::uint32_t c, const Bead& bead,
                                                          const std::vector<Vec2>& lane) const;
    [[nodiscard]] std::optional<std::vector<Vec2>> lane(std::uint32_t c, const Bead& bead, double reach) const;
    std::optional<std::vector<Vec2>> leave(std::uint32_t c, Bead& bead, const std::function<Bead()>& other);

    void lay_lane(const std::vector<Vec2>& way, const Emit& emit);
    void stop_and_travel(Vec2 to, const Emit& emit);
    void extrude(toolpath::Role role, std::vector<Vec3> points, std::vector<double> width, const Emit& emit);
    bool print_stacked(const Bead& bead, const Emit& emit); // stacked.cpp
    void print(const Bead& bead, const Ramp& ramp, const Emit& emit);

    // connector.cpp
    [[nodiscard]] Box2 all_bounds() const;
    [[nodiscard]] bool misses_others(Vec3 a, Vec3 b, bool front) const;
    [[nodiscard]] bool misses_strands(Vec3 a, Vec3 b) const;
    [[nodiscard]] double uncarried(std::span<const Vec3> way) const;
    [[nodiscard]] std::optional<std::pair<std::vector<Vec3>, Entry>> way_around(double margin) const;
    std::optional<Entry> go_around(const Emit& emit, Notes& notes);
    std::optional<Entry> go_inside(const Emit& emit);
    [[nodiscard]] bool leads_out(Vec3 a, Vec3 b, const SegmentIndex& own, bool leaves) const;

    // lift.cpp
    [[nodiscard]] double ramp_length() const;
    [[nodiscard]] bool ramps(const Entry& entry) const;
    void begin_ramp(const Entry& entry, const Emit& emit);

    // helix.cpp
    static Turn turn(const Waiting& r, const Entry& entry);
    [[nodiscard]] bool winds_on(const Entry& entry) const;
    Bead wind(const Entry& entry, bool goes_on, const Emit& emit);

    // interlace.cpp
    [[nodiscard]] static bool hidden(const Waiting& r, const Place& place);
    [[nodiscard]] bool apart(const Bead& bead) const;
    std::optional<std::vector<Vec2>> shift(std::uint32_t c, const Bead& bead);

    // entry.cpp
    static std::optional<Entry> nearest_entry(const Waiting& r, Vec2 p, double limit, std::span<const char> done);
    [[nodiscard]] std::size_t climbing() const;
    [[nodiscard]] Entry start_entry() const;
    [[nodiscard]] Entry drift(const Entry& nearest);
    [[nodiscard]] bool leads_free(Vec2 a, Vec2 b, std::optional<std::uint32_t> on) const;
    [[nodiscard]] Entry step_towards(const Entry& nearest, Vec2 to, double step) const;

    Options options_;
    Counts counts_;
    std::deque<Waiting> window_;
    std::optional<Vec3> at_;             // where the nozzle is
    std::vector<toolpath::Curve> joins_; // what lifts and jogs lay on the layer of the front region
    std::optional<Vec2> pin_;  // a place of the front region's curve where a jog leaves it: must be a point of it
    std::optional<Turn> turn_; // of the helix below the front region
    bool winds_ = false;       // the front region is a turn of a helix
    Ramp ramp_;                // by which the front region is entered, until its first curve is printed
    Next next_ = Next::anywhere;
    Vec2 home_, start_;       // where the column began; where the front region was entered
    double offset_ = 0;       // bead widths, of the layer's start from home
    std::uint64_t random_;    // state of the generator
    double width_before_ = 0; // mm, of the region before
    bool may_climb_ = false;  // something of the region before was printed
    std::uint32_t stroke_ = 0;
    std::optional<Stacked> stacked_; // walls of the region `stacked_in_`
    std::uint32_t stacked_in_ = 0;
    std::optional<SegmentIndex> last_; // the region before as printed, if a connector may leave it
    Printed printed_;
    Box2 around_;                                // what connectors go around
    std::vector<std::pair<Vec3, Vec3>> strands_; // legs of connectors
};

} // namespace filum::link3d
