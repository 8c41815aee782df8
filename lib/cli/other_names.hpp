// The one table of what other slicers call the options of Filum, and of what Filum called them before.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace filum::cli {

// How a value of theirs becomes one of ours.
enum class Value : std::uint8_t {
    same,       // as it stands
    length,     // mm; a share of something else has no meaning here, nor has 0, which says "by itself"
    share,      // 15% or 15 becomes 15%
    flag,       // 0 or 1
    steepness,  // degrees from the horizontal; here they count from the vertical
    pattern,    // of infill
    key,        // of the machine's profile, by --set; a share of something else has no meaning here
    text,       // of the machine's profile, by --set: code, with \n for a new line
    bed_only,   // 0 or 1: where supports may stand
    seam,       // where strokes begin
    shrinks_by, // % of the size in x and y that a part loses as it cools
    shrinks_to, // % of it that are left then
    shrinks_z,  // % of the height that it loses (PrusaSlicer: up to 10), or that are left (OrcaSlicer: more than 10)
    turn_x,     // degrees
    turn_y,
    turn_z,
    none, // ours takes another kind of value: only its name can be told
};

struct OtherName {
    std::string_view theirs; // with '-'
    std::string_view ours;   // an option without dashes; of Value::key and Value::text a key of the machine's profile
    Value value = Value::same;
};

// The first entry for a name of PrusaSlicer, OrcaSlicer, Cura, Slic3r or an older Filum, with '-' or '_' and without
// what stands behind '=', whose option (--set, of a key) `has` knows; else null.
const OtherName* other_name(std::string_view theirs, const std::function<bool(std::string_view)>& has);

// "--set feeds.bead=50" or "--bead-width": what to type for it.
std::string ours_of(const OtherName& name);

// "; here it is '--bead-width'" for an option by such a name, if ours is among `names`, without dashes; else "".
std::string in_our_words(std::string_view theirs, std::span<const std::string> names);

} // namespace filum::cli
