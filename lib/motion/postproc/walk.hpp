// From the spans of a toolpath to the steps of a machine: its acts in their order, with numbers that are not yet text.
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
inline constexpr double kTouch = 1e-6; // mm; ends of spans that are nearer than this are one place
// mm above the start of the first stroke, from where the tool approaches it: clear of clips and fixtures
inline constexpr double kApproach = 5;
// s: least duration of a move on a machine with rotary axes.  A controller's servo does nothing in less time, and words
// of inverse time stay below 1e5.
inline constexpr double kLeastSeconds = 1e-3;

enum class Act : std::uint8_t {
    layer,   // a span of another layer begins: `to.z` its top, `height` its thickness
    open,    // material on: a stroke begins
    close,   // material off: a stroke ends
    retract, // take material back
    prime,   // push it forward again
    travel,  // move without material
    climb,   // move along z alone, without material
    extrude, // move and extrude `volume`
    tool,    // another tool takes over; the position of its tip is unknown
    purge,   // push out `volume` at the tool's place for it, from the height `to.z`; `halt`: it is retracted before
    push,    // push fibre into the air
    tension, // wait for the fibre's tension to settle
    cut,     // cut the fibre
    stand,   // of a robot: a joint move to `posture`
    omit,    // no move: a fibre stroke of `length` mm that begins at `to` is left out
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
    std::uint8_t over_air = 0;    // percent of a wall's width
    // length: the way of the tip, mm; with three axes only of moves that extrude.
    // Only with rotary axes, where `to` are the program's numbers: `tilt` and `turn`, rad, and `axes`, mm, are the
    // positions of the axes; `seconds` is the duration, s (0: unknown, because the start position is unknown).
    double tilt = 0, turn = 0, length = 0, seconds = 0;
    Vec3 axes{};
    Vec3 axis{0, 0, 1}, heading{1, 0, 0}; // of a robot: tool axis, and direction of the tool's x axis; unit
    std::uint32_t tool = 0;
    double fed = 0;                               // mm of fibre fed on the way
    bool halt = false;                            // the tool stops at `to`, as the next act belongs to that place
    double sweep = 0;                             // rad of an arc, positive counter-clockwise; 0: straight
    Vec2 centre{};                                // of an arc, in the frame of `to`
    const kinematics::Posture* posture = nullptr; // of Act::stand, if known; valid as long as the walker
};

using Steps = std::function<void(std::span<const Step>)>;

// What a machine does to a path: merged and slowed moves, unwound axes, leaning tools.
struct Efforts {
    std::uint64_t given = 0;  // extruding segments of the toolpath; FirstPass::laying counts the moves
    double off = 0;           // mm: largest distance of a merged move from them
    std::uint64_t slowed = 0; // moves slowed because the controller takes no more per second
    std::uint64_t unwinds = 0, unwinds_in_turns = 0; // breaks of a stroke to turn the axes back; those in hairpins
    Vec3 unwind;                                     // place of the first one, in the machine's frame
    std::uint32_t unwind_layer = 0;
    double lean = 0, clipped = 0; // rad: largest lean of the tool off its axis; largest lean to keep the tilt's limits
    Vec3 lean_at, clipped_at;
    ArmEfforts arm; // of a robot
};

// The lifts, jogs and connectors of a toolpath, layer by layer.  Merged moves must not cross them.
struct Joins {
    std::map<std::uint32_t, std::vector<geom::Segment>> of_layer;
    void add(const toolpath::Span& span); // to its layer, and to the layers below and above, which it may touch
    [[nodiscard]] std::span<const geom::Segment> near(std::uint32_t layer) const;
};

// Turns spans, in their order, into steps.
class Walker {
  public:
    virtual ~Walker() = default;
    // Throws Error(bad_input) with the place if the span does not begin where the last one ended.
    // `merged`: the moves of the span, as merged() gives them, if they are known already; may be null.
    void add(const toolpath::Span& span, const toolpath::MergeResult* merged = nullptr);
    // Adds a span of fibre with the feed and fibre of `how`; if `halt`, the tool stops at its end.  Throws as add().
    void add_fibre(const toolpath::Span& span, const machine::Stretch& how, bool halt);
    virtual void end() = 0;                                                   // closes the last stroke
    [[nodiscard]] virtual const Efforts& efforts() const { return efforts_; } // complete after end()

  protected:
    // Feed and fibre of one move of the current span.
    struct Laying {
        double feed = 0, fed = 0; // mm/s; mm of fibre
        bool halt = false;
    };
    [[nodiscard]] Laying laying(const machine::Profile& profile, std::uint32_t tool, const machine::ExtrudingMove& move,
                                bool last) const;
    [[nodiscard]] Act before() const; // the act before the span's first move; Act::extrude: none
    virtual void travel(const toolpath::Span& span) = 0;
    virtual void extrude(const toolpath::Span& span) = 0;
    [[nodiscard]] bool started() const { return started_; }                      // there was a span before
    [[nodiscard]] const toolpath::MergeResult* known() const { return merged_; } // of the current span; may be null
    Efforts efforts_;

  private:
    void lay(const toolpath::Span& span);
    Vec3 path_; // end of the last span
    const toolpath::MergeResult* merged_ = nullptr;
    bool started_ = false;
    machine::Stretch how_;
    bool halt_ = false;
};

// The walker of a machine: a FibreWalk in front of a Walk or a TiltedWalk.  With three axes it is a Walk, which ignores
// `shift`.  With rotary axes it is a TiltedWalk, whose steps are moved by `shift`.  `joins`, if not null, are those of
// the whole toolpath and must outlive the walker.
std::unique_ptr<Walker> walker(const machine::Profile& profile, Vec2 shift, Steps out, const Joins* joins = nullptr);

// How far the moves of a span may be from the span.
toolpath::Tolerance tolerance(const machine::Profile& profile, const toolpath::Span& span);

// The moves of a span on a machine with three axes.  `joins` may be null.
toolpath::MergeResult merged(const machine::Profile& profile, const toolpath::Span& span, const Joins* joins);

class Throughput;

// The walker of machines with three axes.
//
// Within a stroke it emits only extruding moves and layer marks.  Moves are merged as the profile's Merging allows,
// each span by itself, so no end of a stroke, role, tool or layer moves.
//
// A travel closes the stroke, retracts, rises, moves, comes down, primes, and opens the next stroke.  It rises above
// all printed so far, above its own points and to travel.above, but not above the top of the machine.  A travel with
// normals follows its points instead; after a change of the tool, and before the first stroke, it is entered from
// above.  A travel shorter than the profile's min_length only moves.
//
// Feeds depend on the role.  They are lowered on layer 0, to keep limits.flow and motion.max_speed_z, and to
// motion.moves_per_second (throughput.hpp).  A lowered feed above 1 mm/s is a whole number.
class Walk final : public Walker {
  public:
    Walk(const machine::Profile& profile, Steps out, const Joins* joins = nullptr);
    ~Walk() override;
    void end() override;

  private:
    void put(const Step& step);
    void put_bead(const Step& step, const Vec3& from);
    void travel(const toolpath::Span& span) override;
    void leave(const toolpath::Span& travel);
    void go(const Vec3& to, const toolpath::Span& travel);
    void begin_span(const toolpath::Span& span);
    void begin_stroke(const toolpath::Span& span);
    void purge(std::uint32_t layer, const Vec3& over);
    void extrude(const toolpath::Span& span) override;
    [[nodiscard]] const machine::Profile& own() const { return machine::of_tool(*profile_, tool_); } // in use

    const machine::Profile* profile_;
    std::unique_ptr<Throughput> steps_;
    const Joins* joins_;
    Vec3 at_;                   // of the nozzle
    std::vector<Vec3> lead_in_; // points of the travel before the first stroke, if it must be followed
    double top_ = 0;            // highest point printed so far
    double run_ = 0;            // mm of the stroke so far, while its speed rises
    std::int64_t layer_ = -1;
    std::uint32_t tool_ = 0;
    std::set<std::uint32_t> retracted_; // tools
    bool open_ = false, risen_ = false;
};

} // namespace filum::postproc
