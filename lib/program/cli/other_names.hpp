// The one table of option names that other slicers use for options of Filum, and of former names of Filum's own
// options.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace filum::cli {

// How a value of another slicer is converted to a value of Filum.
enum class Value : std::uint8_t {
    same,       // unchanged
    length,     // mm; percentages are ignored, and so is 0, which means "automatic"
    share,      // 15% or 15 becomes 15%
    flag,       // 0 or 1
    steepness,  // degrees from the horizontal; Filum counts from the vertical
    pattern,    // a pattern of infill
    key,        // a key of the machine's profile, for --set; percentages are ignored
    text,       // a key of the machine's profile, for --set: code, with \n for a new line
    bed,        // what the nozzle reaches, for --set: 220x220, 220x220x250, or corners, 0x0,220x0,220x220,0x220
    fan,        // % of the full speed of the part's fan, for --set
    bed_only,   // 0 or 1: whether supports may stand only on the bed
    seam,       // the position of seams
    shrinks_by, // % of the size in x and y that a part loses when it cools
    shrinks_to, // % of the size in x and y that remain then
    shrinks_z,  // % of the height that it loses (PrusaSlicer: up to 10) or that remain (OrcaSlicer: more than 10)
    turn_x,     // degrees
    turn_y,
    turn_z,
    none, // Filum's option takes another kind of value: messages give only its name
};

struct OtherName {
    std::string_view theirs; // words separated by '-'
    std::string_view ours;   // an option without dashes; for Value::key and Value::text a key of the machine's profile
    Value value = Value::same;
};

// The first entry of the table for a name of PrusaSlicer, OrcaSlicer, Cura, Slic3r or an older Filum. The name may use
// '-' or '_', and text from '=' on is ignored. An entry counts only if `has` returns true for its option ("set" for
// keys of a profile). Null if there is none.
const OtherName* other_name(std::string_view theirs, const std::function<bool(std::string_view)>& has);

// What to type for the entry: "--set feeds.bead=50" or "--bead-width".
std::string ours_of(const OtherName& name);

// "; here it is '--bead-width'" for an option `theirs` of another slicer, if Filum's option is among `names` (without
// dashes); else "".
std::string in_our_words(std::string_view theirs, std::span<const std::string> names);

// "; the command 'filum compare ...' does that" for an option that some look for in a program, although it is a command
// of its own; else "".
std::string as_command(std::string_view program, std::string_view option);

} // namespace filum::cli
