// Reads STL. Binary: 80 bytes of any content, a count, then 50 bytes per triangle: normal, three corners, attribute.
// ASCII: solid NAME / facet normal / outer loop / vertex ... / endloop / endfacet / endsolid.
#include "base/error.hpp"
#include "mesh/formats.hpp"
#include "mesh/polygons.hpp"
#include "mesh/text.hpp"
#include "mesh/weld.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace filum::mesh {

namespace {

constexpr std::size_t kHeader = 84, kRecord = 50;
constexpr std::size_t kBlock = 32; // triangles hashed ahead of their look-up

void add_block(const char* record, std::size_t count, Weld<std::uint32_t>& weld, std::vector<Triangle>& out) {
    float v[3 * kBlock][3];
    std::array<std::uint32_t, 3> key[3 * kBlock];
    std::uint64_t hash[3 * kBlock];
    for (std::size_t t = 0; t < count; ++t) {
        std::memcpy(v[3 * t], record + kRecord * t + 12, 36);
        for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
            for (std::size_t d = 0; d < 3; ++d) key[k][d] = std::bit_cast<std::uint32_t>(v[k][d] + 0.0F);
            hash[k] = Weld<std::uint32_t>::hash(key[k]);
            weld.prefetch(hash[k]);
        }
    }
    for (std::size_t t = 0; t < count; ++t) {
        Triangle tri{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = 3 * t + k;
            tri[k] = weld.add(key[i], hash[i], {v[i][0] + 0.0F, v[i][1] + 0.0F, v[i][2] + 0.0F});
        }
        out.push_back(tri);
    }
}

std::size_t announced_by(std::string_view bytes) {
    std::uint32_t n = 0;
    std::memcpy(&n, bytes.data() + kHeader - 4, 4);
    return n;
}

// True if a whole binary STL begins there.
bool holds_stl(std::string_view bytes) {
    if (bytes.size() < kHeader + kRecord) return false;
    const std::size_t n = announced_by(bytes);
    return n > 0 && n <= (bytes.size() - kHeader) / kRecord;
}

constexpr float kLeastCoordinate = 1e-20F, kMostCoordinate = 1e20F; // other bytes hold numbers of any size
constexpr std::size_t kLook = 100;                                  // records that are looked at

} // namespace

bool are_stl_records(std::string_view bytes) {
    if (bytes.empty() || bytes.size() % kRecord != 0) return false;
    for (std::size_t t = 0; t < std::min(kLook, bytes.size() / kRecord); ++t) {
        float c[9];
        std::memcpy(c, bytes.data() + kRecord * t + 12, 36);
        if (std::all_of(std::begin(c), std::end(c), [](float v) { return v == 0; })) return false; // padding
        for (const float v : c)
            if (v != 0 && !(std::abs(v) > kLeastCoordinate && std::abs(v) < kMostCoordinate)) return false;
    }
    return true;
}

namespace {

void add_records(std::string_view records, Weld<std::uint32_t>& weld, std::vector<Triangle>& out) {
    const std::size_t triangles = records.size() / kRecord;
    out.reserve(out.size() + triangles);
    for (std::size_t t = 0; t < triangles; t += kBlock) {
        const std::size_t count = std::min(kBlock, triangles - t);
        weld.reserve(3 * count);
        add_block(records.data() + kRecord * t, count, weld, out);
    }
}

// Passes the name behind "solid" or "endsolid". It ends with its line, or before a facet or the end of the solid: some
// programs write all on one line.
void pass_name(Text& text) {
    const char comment = std::exchange(text.comment, '\0'); // a name may hold its sign
    while (text.more_on_line()) {
        const char* const from = text.at;
        const std::string_view word = text.word();
        const char* const behind = text.at;
        const bool ends =
            begins_with(word, "endsolid") || (begins_with(word, "facet") && begins_with(text.word(), "normal"));
        text.at = ends ? from : behind;
        if (ends) break;
    }
    text.comment = comment;
}

// Throws the error of a bad line.  On an unterminated last line, it says that the file was cut short.
[[noreturn]] void bad_line(const Text& text, const std::string& name, const std::string& why) {
    if (std::find_if(text.at, text.end, is_line_end) == text.end)
        throw Error(Exit::truncated, "cannot read " + name + ": it ends inside a facet");
    throw Error(Exit::bad_input, "cannot read " + name + ": line " + std::to_string(text.line()) + ": " + why);
}

} // namespace

Mesh read_stl_binary(std::string_view bytes, const std::string& name, Notes& notes) {
    const std::size_t held = (bytes.size() - kHeader) / kRecord, announced = announced_by(bytes);
    if (held < announced)
        throw Error(Exit::truncated, "cannot read " + name + ": it announces " + std::to_string(announced) +
                                         " triangles and ends after " + std::to_string(held) +
                                         "; copy or export it again");
    const std::string_view more_records = bytes.substr(kHeader + kRecord * announced);
    if (are_stl_records(more_records) && !holds_stl(more_records))
        throw Error(Exit::bad_input, "cannot read " + name + ": it announces " + std::to_string(announced) +
                                         " triangles and holds " + std::to_string(held) + "; export it again");
    Mesh out;
    Weld<std::uint32_t> weld(announced / 2 + 16);
    Note more = note(NoteCode::stl_appended);
    more.count = 0;
    for (bool first = true; first || holds_stl(bytes); first = false) {
        const std::size_t count = announced_by(bytes);
        add_records(bytes.substr(kHeader, kRecord * count), weld, out.triangles);
        bytes.remove_prefix(kHeader + kRecord * count);
        if (first) continue;
        ++more.count;
        more.amount += static_cast<double>(count);
    }
    if (more.count > 0) notes.push_back(std::move(more));
    if (recognise(bytes) != Kind::unknown)
        throw Error(Exit::bad_input, "cannot read " + name + ": behind its " + std::to_string(out.triangles.size()) +
                                         " triangles another file begins; give the files one by one");
    if (!bytes.empty()) notes.push_back(note(NoteCode::trailing_bytes, static_cast<double>(bytes.size())));
    out.vertices = std::move(weld.vertices);
    return out;
}

Mesh read_stl_ascii(std::string_view bytes, const std::string& name, Notes& notes) {
    Text text(bytes, '#');
    Weld<std::uint64_t> weld(bytes.size() / 600); // a triangle takes about 250 bytes
    Mesh out;
    Faces faces;
    std::vector<std::uint32_t> corners;
    bool in_facet = false, in_solid = false;
    Note passed = note(NoteCode::stl_word_ignored);
    passed.count = 0;
    while (text.more()) {
        const bool begins_line = text.begins_line();
        const std::string_view word = text.word();
        if (begins_with(word, "vertex")) {
            double c[3] = {};
            for (double& d : c)
                if (!text.more_on_line() || !text.number(d)) bad_line(text, name, "a vertex takes three numbers");
            const Vec3 v{c[0] + 0.0, c[1] + 0.0, c[2] + 0.0};
            weld.reserve(1);
            corners.push_back(weld.add(bits(v), Weld<std::uint64_t>::hash(bits(v)), v));
        } else if (begins_with(word, "facet")) {
            for (int k = 0; k < 4; ++k) text.word(); // "normal" and its three numbers
            in_facet = true;
            corners.clear();
        } else if (begins_with(word, "outer"))
            text.word();
        else if (begins_with(word, "endfacet")) {
            faces.add(corners);
            in_facet = false;
            corners.clear();
        } else if (begins_with(word, "solid") || begins_with(word, "endsolid")) {
            in_solid = begins_with(word, "solid");
            pass_name(text);
        } else if (!begins_with(word, "endloop") && !begins_line)
            ++passed.count;
        else if (!begins_with(word, "endloop"))
            bad_line(text, name, "'" + std::string(word.substr(0, 20)) + "' is no word of an STL file");
    }
    if (in_facet) throw Error(Exit::truncated, "cannot read " + name + ": it ends inside a facet");
    if (in_solid) notes.push_back(note(NoteCode::stl_unended));
    if (passed.count > 0) notes.push_back(std::move(passed));
    faces.cut(weld.vertices, notes);
    out.triangles = std::move(faces.triangles);
    out.vertices = std::move(weld.vertices);
    return out;
}

} // namespace filum::mesh
