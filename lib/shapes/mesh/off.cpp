// Reads text OFF and its variants with normals, colours or texture (COFF, NOFF, STOFF...).
#include "base/error.hpp"
#include "mesh/formats.hpp"
#include "mesh/polygons.hpp"
#include "mesh/text.hpp"

namespace filum::mesh {

namespace {

// Moves to the next word of the file.  Throws if there is none.
void need(Text& text, const std::string& name) {
    if (!text.more()) throw Error(Exit::truncated, "cannot read " + name + ": it ends before its last face");
}

std::uint64_t count(Text& text, const std::string& name, const char* of) {
    long long n = 0;
    need(text, name);
    if (!text.whole(n) || n < 0) malformed_line(name, text, std::string("the number of ") + of + " is missing");
    // every vertex and face takes two bytes or more
    if (static_cast<std::uint64_t>(n) > static_cast<std::uint64_t>(text.end - text.begin))
        throw Error(Exit::truncated, "cannot read " + name + ": it announces " + std::to_string(n) + " " + of +
                                         " and is too short for that");
    return static_cast<std::uint64_t>(n);
}

std::vector<Vec3> vertices(Text& text, const std::string& name, std::uint64_t n, bool extras) {
    std::vector<Vec3> out;
    out.reserve(n);
    for (std::uint64_t i = 0; i < n; ++i) {
        double c[3] = {};
        for (double& d : c) {
            need(text, name);
            if (!text.number(d)) malformed_line(name, text, "a vertex takes three numbers");
        }
        if (extras) text.skip_line();
        out.push_back({c[0], c[1], c[2]});
    }
    return out;
}

Faces faces(Text& text, const std::string& name, std::uint64_t n, std::size_t vertex_count) {
    Faces out;
    out.triangles.reserve(n);
    std::vector<std::uint32_t> corners;
    for (std::uint64_t i = 0; i < n; ++i) {
        long long size = 0, v = 0;
        need(text, name);
        if (!text.whole(size) || size < 0) malformed_line(name, text, "a face does not say how many corners it has");
        corners.clear();
        for (long long k = 0; k < size; ++k) {
            need(text, name);
            if (!text.whole(v) || v < 0 || static_cast<unsigned long long>(v) >= vertex_count)
                malformed_line(name, text, "a face has a corner that is no vertex");
            corners.push_back(static_cast<std::uint32_t>(v));
        }
        text.skip_line(); // its colour
        out.add(corners);
    }
    return out;
}

} // namespace

Mesh read_off(std::string_view bytes, const std::string& name, Notes& notes) {
    Text text(bytes, '#');
    text.more();
    const std::string_view head = off_keyword({text.at, static_cast<std::size_t>(text.end - text.at)});
    text.at += head.size(); // numbers may follow on the same line
    const std::string_view prefix = head.substr(0, head.size() - 3);
    if (prefix.find_first_of("4n") != std::string_view::npos)
        throw Error(Exit::bad_input, "cannot read " + name + ": it is an OFF file of more than three dimensions");
    if (text.more_on_line() && begins_with({text.at, static_cast<std::size_t>(text.end - text.at)}, "binary"))
        throw Error(Exit::bad_input, "cannot read " + name + ": it is a binary OFF file; export it as text");
    const std::uint64_t v = count(text, name, "vertices");
    const std::uint64_t f = count(text, name, "faces");
    long long edges = 0; // read, but ignored: programs often write a wrong number
    if (text.more_on_line()) text.whole(edges);
    Mesh out;
    out.vertices = vertices(text, name, v, !prefix.empty());
    Faces read = faces(text, name, f, out.vertices.size());
    read.cut(out.vertices, notes);
    out.triangles = std::move(read.triangles);
    if (text.more()) notes.push_back(note(NoteCode::trailing_bytes, static_cast<double>(text.end - text.at)));
    return out;
}

} // namespace filum::mesh
