// The stream format: preamble, header frame, further frames, end frame. Independent of geometry; see docs/stream.md.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::stream {

// The kind of payload that a stream carries; a stream has only one. The values are those on the wire.
enum class Payload : std::uint8_t { unknown = 0, layers = 1, regions = 2, paths = 3, toolpath = 4, surface = 5 };

std::string_view name(Payload p);

// The type of a frame: the field number in the oneof of the message Frame.
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

// The tag of the payload frames of a stream of this kind.
Tag tag_of(Payload p);

struct Setting {
    std::string name, value;
    bool changed = false; // differs from the program's default
};

// One of several objects that stand together on the bed.
struct Object {
    std::string name;
    std::vector<double> x, y; // mm, the convex outline seen from above, counter-clockwise
    double height = 0;        // mm, height of the top above the bed
};

// One run of a program that took part in making a stream.
struct Run {
    std::string program, version;
    std::vector<Setting> settings;
    std::vector<std::uint32_t> parents; // indices into Header::history
    std::vector<Object> objects = {};   // the objects that it put on the bed, if there are several
};

struct Header {
    Payload payload = Payload::unknown;
    std::vector<Run> history;   // oldest first; the last one wrote the stream
    std::uint64_t expected = 0; // number of payload frames that follow, 0 if unknown
};

// A frame as on the wire: its tag, and its message, still serialised.
struct RawFrame {
    Tag tag = Tag::header;
    std::string body;
};

inline constexpr std::size_t kMaxFrame = std::size_t{64} << 20;

std::string serialise(const Note& note);
Note parse_note(std::string_view body); // throws Error(bad_input)
std::string serialise(const Fact& fact);
Fact parse_fact(std::string_view body); // throws Error(bad_input): malformed, or not finite

// True for notes and facts. Any stream may hold them between payload frames, and stages pass them on.
inline bool is_remark(Tag tag) { return tag == Tag::note || tag == Tag::fact; }

} // namespace filum::stream
