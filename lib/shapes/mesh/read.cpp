#include "mesh/read.hpp"

#include "archive/zip.hpp"
#include "base/error.hpp"
#include "base/padding.hpp"
#include "mesh/formats.hpp"
#include "mesh/text.hpp"
#include "mesh/weld.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace filum::mesh {

namespace {

constexpr std::size_t kStlHeader = 84, kStlRecord = 50;

std::uint32_t announced_triangles(std::string_view bytes) {
    std::uint32_t n = 0;
    if (bytes.size() >= kStlHeader) std::memcpy(&n, bytes.data() + 80, 4);
    return n;
}

bool is_text(std::string_view bytes) {
    bytes = without_padding(bytes);
    return std::all_of(bytes.begin(), bytes.begin() + static_cast<long>(std::min<std::size_t>(bytes.size(), 1024)),
                       [](char c) { return static_cast<unsigned char>(c) >= 32 || is_blank(c) || is_line_end(c); });
}

} // namespace

std::string_view off_keyword(std::string_view text) {
    constexpr std::string_view kHeads[] = {"OFF",    "COFF",   "NOFF",    "CNOFF", "NCOFF", "STOFF",
                                           "STCOFF", "STNOFF", "STCNOFF", "4OFF",  "nOFF",  "4nOFF"};
    for (const std::string_view head : kHeads) {
        // in lower case, too, unless that would be another keyword: NOFF and nOFF
        const bool any_case = head.find_first_of("Nn") == std::string_view::npos;
        std::string small(head);
        std::transform(small.begin(), small.end(), small.begin(), lower);
        if (!text.starts_with(head) && !(any_case && text.starts_with(small))) continue;
        const char after = text.size() > head.size() ? text[head.size()] : '\n';
        if (is_blank(after) || is_line_end(after) || after == '#' || (after >= '0' && after <= '9')) return head;
    }
    return {};
}

namespace {

bool is_obj(std::string_view word) {
    constexpr std::string_view kWords[] = {"v", "vt", "vn", "vp",     "f",      "o",     "g",
                                           "s", "l",  "p",  "mtllib", "usemtl", "usemap"};
    return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

// True if an XML text has <amf> as its root; a declaration and comments may precede it.
bool is_amf(std::string_view bytes) {
    constexpr std::size_t kLook = 4096; // bytes
    const std::string_view head = bytes.substr(0, kLook);
    const auto at = head.find("<amf");
    return at != std::string_view::npos && head.find_first_not_of(" \t\r\n\xef\xbb\xbf") == head.find('<') &&
           head.find_first_of(" \t\r\n>/", at) == at + 4;
}

Kind recognise_text(std::string_view bytes) {
    if (is_amf(bytes)) return Kind::amf;
    Text text(bytes, '#');
    if (!text.more()) return Kind::unknown;
    const std::string_view word = text.word();
    if (word == "ply") return Kind::ply;
    if (!off_keyword(word).empty()) return Kind::off;
    if (is_obj(word)) return Kind::obj;
    if (word.starts_with("ISO-10303-21")) return Kind::step;
    if (begins_with(word, "solid") || begins_with(word, "facet")) return Kind::stl_ascii;
    return Kind::unknown;
}

// Merges vertices with equal coordinates, in order of first appearance.
void weld(Mesh& mesh) {
    Weld<std::uint64_t> welded(mesh.vertices.size());
    std::vector<std::uint32_t> to;
    to.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) {
        welded.reserve(1);
        const auto key = bits(v);
        to.push_back(welded.add(key, Weld<std::uint64_t>::hash(key), {v.x + 0.0, v.y + 0.0, v.z + 0.0}));
    }
    if (welded.vertices.size() < mesh.vertices.size()) mesh.renumber(to);
    mesh.vertices = std::move(welded.vertices);
    for (Triangle& t : mesh.triangles)
        for (auto& v : t) v = to[v];
}

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Leaves out triangles with equal corners or with a corner that is not finite. Then it leaves out vertices without a
// triangle that are not finite, so that all coordinates are finite. `items` and `materials` are empty or have an entry
// per triangle.
void leave_out_unusable(Mesh& mesh, std::vector<std::uint32_t>& items, std::vector<std::uint32_t>& materials,
                        Notes& notes) {
    const bool all_finite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(), finite);
    std::size_t lost = 0, kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = mesh.triangles[i];
        if (!all_finite &&
            !(finite(mesh.vertices[t[0]]) && finite(mesh.vertices[t[1]]) && finite(mesh.vertices[t[2]]))) {
            ++lost;
            continue;
        }
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        if (!items.empty()) items[kept] = items[i];
        if (!materials.empty()) materials[kept] = materials[i];
        mesh.triangles[kept++] = t;
    }
    mesh.triangles.resize(kept);
    if (!items.empty()) items.resize(kept);
    if (!materials.empty()) materials.resize(kept);
    if (lost > 0) {
        Note n = note(NoteCode::triangle_not_finite);
        n.count = lost;
        notes.push_back(std::move(n));
    }
    if (!all_finite)
        for (Vec3& v : mesh.vertices)
            if (!finite(v)) v = {};
}

Mesh read_kind(Kind kind, std::string_view bytes, const std::string& name, int plate, File& to) {
    Notes& notes = to.notes;
    switch (kind) {
    case Kind::stl_binary:
        return read_stl_binary(bytes, name, notes);
    case Kind::stl_ascii:
        return read_stl_ascii(without_padding(bytes), name, notes);
    case Kind::obj:
        return read_obj(without_padding(bytes), name, notes);
    case Kind::ply:
        return read_ply(bytes, name, notes);
    case Kind::off:
        return read_off(without_padding(bytes), name, notes);
    case Kind::threemf:
        read_3mf(bytes, name, plate, to);
        return std::move(to.mesh);
    case Kind::amf:
        read_amf(bytes, name, to);
        return std::move(to.mesh);
    case Kind::step:
        throw Error(Exit::bad_input, "cannot read " + name + ": it is a STEP file, not a mesh");
    case Kind::unknown:
        break;
    }
    const std::string_view stream_mark("\x00\x89\x46\x69lum\n", 8);
    if (bytes.substr(0, 16).find(stream_mark) != std::string_view::npos)
        throw Error(Exit::bad_input, "cannot read " + name + ": it is a Filum stream, not a mesh");
    const std::string other = foreign(bytes);
    if (!other.empty()) throw Error(Exit::bad_input, "cannot read " + name + ": it is " + other);
    throw Error(Exit::bad_input, "cannot read " + name + ": it is no STL, OBJ, PLY, OFF, 3MF, AMF or STEP file");
}

} // namespace

Kind recognise(std::string_view bytes) {
    // The size is tested before the text: an ASCII file never has the size of a binary one. Its four bytes at the count
    // are letters, which would mean more than 500 million triangles.
    const std::uint32_t n = announced_triangles(bytes);
    if (bytes.size() >= kStlHeader && bytes.size() == kStlHeader + kStlRecord * std::size_t{n}) return Kind::stl_binary;
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06")) return Kind::threemf;
    if (bytes.starts_with("ply") || is_text(bytes)) return recognise_text(bytes);
    // A binary STL of another size than its count says is cut short or has data behind it.
    const std::string_view body = bytes.size() > kStlHeader ? bytes.substr(kStlHeader) : std::string_view{};
    const bool plausible = n > 0 && n < (1U << 27) && body.size() >= kStlRecord && std::size_t{n} < 1000 * body.size();
    const bool stream = bytes.substr(0, 16).find("Filum") != std::string_view::npos;
    // A program that did not know the number of triangles when it wrote the header leaves 0 or any number there.
    const bool uncounted = n == 0 && are_stl_records(body);
    return (plausible || uncounted) && !stream && foreign(bytes).empty() ? Kind::stl_binary : Kind::unknown;
}

void tell_uncut(const File& file, Notes& notes) {
    const auto count = std::ranges::count(file.bodies, Body::Purpose::negative, &Body::what);
    if (count == 0) return;
    notes.push_back(note(NoteCode::project_negative));
    notes.back().count = static_cast<std::uint64_t>(count);
}

// The content of the one mesh of a ZIP archive that is no 3MF; "" for other files.
static std::string unzipped(std::string_view bytes, const std::string& name) {
    if (recognise(bytes) != Kind::threemf) return "";
    archive::Zip zip(bytes, name);
    if (zip.has("_rels/.rels")) return "";
    std::vector<std::string> meshes = zip.entries();
    std::erase_if(meshes, [](const std::string& entry) { return !is_mesh_name(entry); });
    if (meshes.empty())
        throw Error(Exit::bad_input, "cannot read " + name + ": it is a ZIP archive, but no 3MF, and holds no mesh");
    if (meshes.size() > 1)
        throw Error(Exit::bad_input, "cannot read " + name + ": it is a ZIP archive that holds '" + meshes[0] + "', '" +
                                         meshes[1] + "'" + (meshes.size() > 2 ? " and others" : "") +
                                         "; unpack it and give the one you want");
    std::string out = zip.read(meshes[0]);
    if (recognise(out) == Kind::threemf)
        throw Error(Exit::bad_input, "cannot read " + name + ": it is a ZIP archive that holds another one, '" +
                                         meshes[0] + "'; unpack it first");
    return out;
}

File read(std::string_view bytes, const std::string& name, int plate) {
    if (bytes.empty()) throw Error(Exit::truncated, "cannot read " + name + ": it is empty");
    if (const std::string inner = unzipped(bytes, name); !inner.empty()) return read(inner, name, plate);
    File out;
    out.kind = recognise(bytes);
    out.mesh = read_kind(out.kind, bytes, name, plate, out);
    if (out.kind != Kind::stl_binary && out.kind != Kind::stl_ascii) weld(out.mesh);
    leave_out_unusable(out.mesh, out.items, out.materials, out.notes);
    std::vector<std::uint32_t> none;
    for (Body& b : out.bodies) {
        weld(b.mesh);
        leave_out_unusable(b.mesh, none, none, out.notes);
    }
    std::erase_if(out.bodies, [](const Body& b) { return b.mesh.triangles.empty(); });
    if (out.mesh.triangles.empty())
        throw Error(Exit::bad_input, "cannot use " + name + ": it holds no triangle with an area");
    return out;
}

} // namespace filum::mesh
