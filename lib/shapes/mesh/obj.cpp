// Reads Wavefront OBJ: "v x y z" and "f 1 2/1 3/1/1 -1".  Other lines are skipped.
#include "base/error.hpp"
#include "mesh/formats.hpp"
#include "mesh/polygons.hpp"
#include "mesh/text.hpp"

#include <algorithm>

namespace filum::mesh {

namespace {

// Skips a backslash at the end of a line, which continues on the next line.  True if there was one.
bool continued(Text& text) {
    if (*text.at != '\\') return false;
    const char* p = text.at + 1;
    while (p < text.end && is_blank(*p)) ++p;
    if (p == text.end || !is_line_end(*p)) return false;
    text.at = p;
    text.pass_line_end();
    return true;
}

Vec3 vertex(Text& text, const std::string& name) {
    double c[3] = {};
    for (double& d : c) {
        while (text.more_on_line() && continued(text)) {
        }
        if (!text.more_on_line() || !text.number(d)) malformed_line(name, text, "a vertex takes three numbers");
    }
    return {c[0], c[1], c[2]};
}

// The corners of an "f" line, counted from 0; `count` vertices came before it.
void face(Text& text, const std::string& name, std::size_t count, std::vector<std::uint32_t>& corners) {
    corners.clear();
    while (text.more_on_line()) {
        if (continued(text)) continue;
        long long i = 0;
        if (!text.whole(i)) malformed_line(name, text, "a corner of a face is no whole number");
        while (text.at < text.end && !is_blank(*text.at) && !is_line_end(*text.at)) ++text.at; // texture, normal
        if (i < 0) i += static_cast<long long>(count) + 1;
        if (i < 1 || i > 0xffffffffLL) malformed_line(name, text, "a face has a corner that is no vertex");
        corners.push_back(static_cast<std::uint32_t>(i - 1));
    }
}

// Adds a note on vertices from number `from` on that no face uses. They are the mark of concatenated files: the faces
// of the second one refer to vertices of the first.
void note_unused(const Mesh& mesh, std::size_t from, Notes& notes) {
    std::vector<char> used(mesh.vertices.size(), 0);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t) used[v] = 1;
    const auto unused = std::count(used.begin() + static_cast<std::ptrdiff_t>(from), used.end(), 0);
    if (unused == 0) return;
    Note n = note(NoteCode::obj_vertex_unused);
    n.count = static_cast<std::size_t>(unused);
    notes.push_back(std::move(n));
}

} // namespace

Mesh read_obj(std::string_view bytes, const std::string& name, Notes& notes) {
    Text text(bytes, '#');
    Mesh out;
    Faces faces;
    std::size_t before_faces = 0; // number of vertices before the first face
    std::vector<std::uint32_t> corners;
    while (text.more()) {
        const std::string_view word = text.word();
        if (word == "v")
            out.vertices.push_back(vertex(text, name));
        else if (word == "f") {
            if (faces.triangles.empty()) before_faces = out.vertices.size();
            face(text, name, out.vertices.size(), corners);
            faces.add(corners);
        }
        text.skip_line();
    }
    for (const Triangle& t : faces.triangles)
        for (const std::uint32_t v : t)
            if (v >= out.vertices.size())
                throw Error(Exit::bad_input, "cannot read " + name + ": a face has vertex " + std::to_string(v + 1) +
                                                 " of " + std::to_string(out.vertices.size()));
    faces.cut(out.vertices, notes);
    out.triangles = std::move(faces.triangles);
    note_unused(out, before_faces, notes);
    return out;
}

} // namespace filum::mesh
