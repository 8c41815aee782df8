// One reader per file format; private to lib/curved/stressfield. All throw the errors of stressfield::read; positions
// are in mm, stresses in MPa.
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

// A note of this library; the command adds the name of the stage.
inline Note note(NoteCode code, std::uint64_t count, std::string detail = {}) {
    return {.code = code, .count = count, .detail = std::move(detail)};
}

} // namespace filum::stressfield
