// The stream format: preamble, header frame, frames, end frame.  Knows no geometry; see docs/stream.md.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::stream {

// The one kind of payload that a stream carries.  Values are the wire's.
enum class Payload : std::uint8_t { unknown = 0, layers = 1, regions = 2, paths = 3, toolpath = 4, surface = 5 };

std::string_view name(Payload p);

// A frame's type: the field number of Frame's oneof.
enum class Tag : std::uint32_t {
    header = 1,
    end = 2,
    note = 3,
    fact = 4,
    layer = 8,
    region = 9,
    paths = 10,
    span = 11,
    surface = 12
};

// The only payload tag that a stream of this kind holds.
Tag tag_of(Payload p);

struct Setting {
    std::string name, value;
    bool changed = false; // differs from the program's default
};

// One of several things that stand on the bed together.
struct Object {
    std::string name;
    std::vector<double> x, y; // mm, its convex outline seen from above, counter-clockwise
    double height = 0;        // mm, of its top above the bed
};

// One program's part in making a stream.
struct Run {
    std::string program, version;
    std::vector<Setting> settings;
    std::vector<std::uint32_t> parents; // indices into Header::history
    std::vector<Object> objects = {};   // that it put on the bed, if they are several
};

struct Header {
    Payload payload = Payload::unknown;
    std::vector<Run> history;   // oldest first; the last one wrote the stream
    std::uint64_t expected = 0; // payload frames to come, 0 if unknown
};

// A frame as it stands on the wire: the tag, and the message behind it, still serialised.
struct RawFrame {
    Tag tag = Tag::header;
    std::string body;
};

inline constexpr std::size_t kMaxFrame = std::size_t{64} << 20;

std::string serialise(const Note& note);
Note parse_note(std::string_view body); // throws Error(bad_input)
std::string serialise(const Fact& fact);
Fact parse_fact(std::string_view body); // throws Error(bad_input): malformed, or not finite

// True for frames that any stream may hold between its payload: stages that do not know them pass them on.
inline bool is_remark(Tag tag) { return tag == Tag::note || tag == Tag::fact; }

} // namespace filum::stream
