// From the spans of a toolpath to the steps of a machine: what to do, one after the other, still in numbers.
#pragma once

#include "machine/feed.hpp"
#include "postproc/arm_efforts.hpp"
#include "toolpath/merge.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

namespace filum::postproc {

using geom::Vec2;
using geom::Vec3;
using toolpath::Feature;
using toolpath::Role;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kTouch = 1e-6; // mm; spans that meet are written from the same number
// mm above its place from where the first stroke is sought: clear of clips and fixtures
inline constexpr double kApproach = 5;
// s: no move of a machine with rotary axes is said to take less.  A controller's servo does nothing in less, and words
// of inverse time stay below 1e5.
inline constexpr double kLeastSeconds = 1e-3;

enum class Act : std::uint8_t {
    layer,   // a span of another layer begins: `to.z` its top, `height` its thickness
    open,    // material on: a stroke begins
    close,   // material off: a stroke ends
    retract, // take material back
    prime,   // give it again
    travel,  // move without material
    climb,   // move along z alone, without material
    extrude, // move and lay `volume`
    tool,    // another tool takes over; where the tip is then, nobody knows
    push,    // push fibre into the air
    tension, // wait for the fibre's tension to settle
    cut,     // cut the fibre
    stand,   // a robot: the axes go as they like to where they stand as `posture`
    omit,    // nothing: a fibre stroke of `length` mm that begins at `to` is left out
};

struct Step {
    Act act = Act::travel;
    Role role = Role::bead;
    Feature feature = Feature::none;
    std::uint32_t layer = 0;
    Vec3 to;                      // mm, not yet placed on the bed
    double feed = 0;              // mm/s
    double volume = 0;            // mm3
    double width = 0, height = 0; // mm, mean of the two ends
    // How far the tip goes, mm, if it lays material; and on machines with rotary axes, where `to` are the program's
    // numbers: that of each move, where the axes stand, rad and mm, and how long it takes, s (0: nobody knows whence it
    // comes).
    double tilt = 0, turn = 0, length = 0, seconds = 0;
    Vec3 axes{};
    Vec3 axis{0, 0, 1}, heading{1, 0, 0}; // of a robot: up the tool, and whereto its x axis points; unit
    std::uint32_t tool = 0;
    double fed = 0;    // mm of fibre, fed on the way
    bool halt = false; // the tool comes to a stand there: what follows belongs to that very place
    double sweep = 0;  // rad of an arc, positive counter-clockwise; 0: straight
    Vec2 centre{};     // of an arc, placed as `to`
    const kinematics::Posture* posture = nullptr; // of Act::stand, if it is known; lives as long as the walk
};

using Steps = std::function<void(std::span<const Step>)>;

// What it took to bring a machine along the path.
struct Efforts {
    std::uint64_t given = 0;  // segments of what is laid, as the toolpath has them; first_pass.hpp counts the moves
    double off = 0;           // mm: the farthest that merging leads from them
    std::uint64_t slowed = 0; // moves that are slower because a controller takes no more of them at a time
    std::uint64_t unwinds = 0, unwinds_in_turns = 0; // breaks of a stroke to turn the axes back; in tight turns
    Vec3 unwind;                                     // where the first one is, as placed
    std::uint32_t unwind_layer = 0;
    double lean = 0, clipped = 0; // rad: the most a tool leans off its axis; the most of it to keep the tilt's limits
    Vec3 lean_at, clipped_at;
    ArmEfforts arm; // of a robot
};

// Where a toolpath goes without filling (lifts, jogs, connectors), layer by layer: what merged moves must not cross.
struct Joins {
    std::map<std::uint32_t, std::vector<geom::Segment>> of_layer;
    void add(const toolpath::Span& span); // to its layer and those that it may touch: below and above
    [[nodiscard]] std::span<const geom::Segment> near(std::uint32_t layer) const;
};

// Turns spans, in their order, into steps.
class Walker {
  public:
    virtual ~Walker() = default;
    // Throws Error(bad_input) with the place if the span does not begin where the one before ended.
    // `merged`: the moves that lay it, where they are known already, as merged() gives them.
    void add(const toolpath::Span& span, const toolpath::Merged* merged = nullptr);
    // Likewise; a span of fibre is to be laid as `how` says, and the tool to stand at its end if `halt`.
    void add_fibre(const toolpath::Span& span, const machine::Stretch& how, bool halt);
    virtual void end() = 0;                                                   // closes the last stroke
    [[nodiscard]] virtual const Efforts& efforts() const { return efforts_; } // once it has ended

  protected:
    // How the span that is being added is laid.
    struct Laying {
        double feed = 0, fed = 0; // mm/s; mm of fibre
        bool halt = false;
    };
    [[nodiscard]] Laying laying(const machine::Profile& profile, std::uint32_t tool, const machine::Laid& move,
                                bool last) const;
    [[nodiscard]] Act before() const; // what comes before its first move; Act::extrude for nothing
    virtual void travel(const toolpath::Span& span) = 0;
    virtual void extrude(const toolpath::Span& span) = 0;
    [[nodiscard]] bool started() const { return started_; }                 // a span came before
    [[nodiscard]] const toolpath::Merged* known() const { return merged_; } // of the span that is being added
    Efforts efforts_;

  private:
    void lay(const toolpath::Span& span);
    Vec3 path_; // end of the span before
    const toolpath::Merged* merged_ = nullptr;
    bool started_ = false;
    machine::Stretch how_;
    bool halt_ = false;
};

// Of three axes: a Walk, whose steps are not placed; of more: a TiltedWalk of what is placed by `shift`; before either
// a FibreWalk.  `joins`, if any, of the whole toolpath, as long as the walker.
std::unique_ptr<Walker> walker(const machine::Profile& profile, Vec2 shift, Steps out, const Joins* joins = nullptr);

// How far what a walker makes of a span may be from it.
toolpath::Tolerance tolerance(const machine::Profile& profile, const toolpath::Span& span);

// The moves that lay a span on a machine of three axes.
toolpath::Merged merged(const machine::Profile& profile, const toolpath::Span& span, const Joins* joins);

class Throughput;

// Three axes.  Within a stroke nothing but extruding moves (and layer marks) comes out.  Moves are merged as the
// profile's Merging allows, of each span by itself: so no end of a stroke, role, tool or layer moves.
// A travel closes the stroke, retracts, rises above all printed so far and the span's own points (cut at the top of the
// machine) and to travel.above, moves, comes down, primes and opens again; one with normals goes where its points are
// instead, behind a change of the tool from above the second of them; one shorter than the profile's min_length only
// moves. Feeds: by role, lowered on layer 0, and so that limits.flow and motion.max_speed_z are kept; a lowered feed is
// a whole number of mm/s where it is above one; and to motion.moves_per_second (throughput.hpp).
class Walk final : public Walker {
  public:
    Walk(const machine::Profile& profile, Steps out, const Joins* joins = nullptr);
    ~Walk() override;
    void end() override;

  private:
    void put(const Step& step);
    void travel(const toolpath::Span& span) override;
    void leave(const toolpath::Span& travel);
    void go(const Vec3& to, const toolpath::Span& travel);
    void begin_stroke(const toolpath::Span& span);
    void extrude(const toolpath::Span& span) override;
    [[nodiscard]] const machine::Profile& own() const { return machine::of_tool(*profile_, tool_); } // for the tool

    const machine::Profile* profile_;
    std::unique_ptr<Throughput> steps_;
    const Joins* joins_;
    Vec3 at_;        // of the nozzle
    double top_ = 0; // highest point printed so far
    std::int64_t layer_ = -1;
    std::uint32_t tool_ = 0;
    std::set<std::uint32_t> retracted_; // tools
    bool open_ = false, risen_ = false;
};

} // namespace filum::postproc
