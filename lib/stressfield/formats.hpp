// One reader per file format; private to lib/stressfield.  All throw Error as stressfield::read says; positions are in
// mm, stresses in MPa.
#pragma once

#include "base/error.hpp"
#include "stressfield/read.hpp"

namespace filum::stressfield {

Samples read_csv(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes);
Samples read_frd(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes);
Samples read_vtu(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes);

[[noreturn]] inline void bad(const std::string& name, const std::string& why) {
    throw Error(Exit::bad_input, "cannot read " + name + ": " + why);
}
[[noreturn]] inline void cut(const std::string& name, const std::string& why) {
    throw Error(Exit::truncated, "cannot read " + name + ": " + why + "; copy or export it again");
}

// A note of this library; the stage's name is set by the command.
inline Note note(std::string what, std::uint64_t count) {
    return {.stage = "", .what = std::move(what), .amount = 0, .unit = "", .count = count};
}

} // namespace filum::stressfield
