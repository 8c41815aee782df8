#include "render/vtp.hpp"

#include "base/printable.hpp"
#include "render/tint.hpp"

#include <bit>
#include <cstring>
#include <type_traits>

namespace filum::render {

namespace {

using geom::Vec3;

static_assert(std::endian::native == std::endian::little);

void append_base64(std::string& out, const std::string& bytes) {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) : 0U;
        };
        const std::uint32_t v = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        out += kDigits[v >> 18];
        out += kDigits[v >> 12 & 63];
        out += i + 1 < bytes.size() ? kDigits[v >> 6 & 63] : '=';
        out += i + 2 < bytes.size() ? kDigits[v & 63] : '=';
    }
}

// `name` as the value of an XML attribute. Control codes are shown as text, because XML cannot represent them.
std::string quoted(const std::string& name) {
    std::string out;
    for (const char c : printable(name)) {
        if (c == '"' || c == '<' || c == '>' || c == '&')
            out += "&#" + std::to_string(static_cast<int>(c)) + ";";
        else
            out += c;
    }
    return out;
}

template <class T>
void append_array(std::string& out, const std::string& name, std::size_t components, const std::vector<T>& values) {
    const char* type = std::is_same_v<T, double>          ? "Float64"
                       : std::is_same_v<T, std::int64_t>  ? "Int64"
                       : std::is_same_v<T, std::uint32_t> ? "UInt32"
                                                          : "UInt8";
    const std::uint64_t size = values.size() * sizeof(T);
    std::string bytes(sizeof size + size, '\0');
    std::memcpy(bytes.data(), &size, sizeof size);
    if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
    out += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + quoted(name) + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"binary\">";
    append_base64(out, bytes);
    out += "</DataArray>\n";
}

std::vector<double> flat(const std::vector<Vec3>& v) {
    std::vector<double> out;
    out.reserve(3 * v.size());
    for (const Vec3& p : v) out.insert(out.end(), {p.x, p.y, p.z});
    return out;
}

// Lines or polygons: the indices of their corners, and the end of each in that list.
struct Cells {
    std::vector<std::int64_t> corners, ends;
};

std::string file(const std::string& comment, const std::vector<Vec3>& points, const char* kind, const Cells& cells,
                 const std::string& point_data, const std::string& cell_data) {
    const bool lines = std::string_view(kind) == "Lines";
    const auto count = std::to_string(cells.ends.size());
    std::string out = "<?xml version=\"1.0\"?>\n" + comment +
                      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                      "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
                      std::to_string(points.size()) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
                      (lines ? count : "0") + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + (lines ? "0" : count) +
                      "\">\n<PointData>\n" + point_data + "</PointData>\n<CellData>\n" + cell_data +
                      "</CellData>\n<Points>\n";
    append_array(out, "points", 3, flat(points));
    out += "</Points>\n<" + std::string(kind) + ">\n";
    append_array(out, "connectivity", 1, cells.corners);
    append_array(out, "offsets", 1, cells.ends);
    return out + "</" + kind + ">\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string file_of(const surface::Sheet& sheet) {
    Cells cells;
    for (const auto& t : sheet.surface.triangles) {
        cells.corners.insert(cells.corners.end(), t.begin(), t.end());
        cells.ends.push_back(static_cast<std::int64_t>(cells.corners.size()));
    }
    std::string data;
    for (const auto& f : sheet.fields) append_array(data, f.name, f.components, f.values);
    return file("", sheet.surface.vertices, "Polys", cells, data, "");
}

std::string file_of(const std::vector<toolpath::Span>& spans) {
    std::vector<Vec3> points, normals;
    std::vector<double> width, height, progress;
    std::vector<std::uint8_t> role;
    std::vector<std::uint32_t> stroke, layer, region;
    Cells cells;
    double along = 0;
    for (const auto& s : spans) {
        const bool bead = toolpath::extrudes(s.role);
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            if (i > 0 && bead) along += geom::distance(s.points[i - 1], s.points[i]);
            cells.corners.push_back(static_cast<std::int64_t>(points.size()));
            points.push_back(s.points[i]);
            normals.push_back(s.normals.empty() ? Vec3{0, 0, 1} : s.normals[i]);
            width.push_back(bead ? s.width_at(i) : 0);
            height.push_back(bead ? s.height_at(i) : 0);
            progress.push_back(along);
        }
        cells.ends.push_back(static_cast<std::int64_t>(points.size()));
        role.push_back(static_cast<std::uint8_t>(s.role));
        stroke.push_back(s.stroke);
        layer.push_back(s.layer);
        region.push_back(s.region);
    }
    std::string per_point, per_line, comment = "<!-- role:";
    append_array(per_point, "normal", 3, flat(normals));
    append_array(per_point, "width", 1, width);
    append_array(per_point, "height", 1, height);
    append_array(per_point, "progress", 1, progress);
    append_array(per_line, "role", 1, role);
    append_array(per_line, "stroke", 1, stroke);
    append_array(per_line, "layer", 1, layer);
    append_array(per_line, "region", 1, region);
    for (std::size_t r = 0; r < toolpath::kRoles; ++r)
        comment += " " + std::to_string(r) + " " + role_name(static_cast<toolpath::Role>(r));
    return file(comment + " -->\n", points, "Lines", cells, per_point, per_line);
}

} // namespace

std::string vtp(const Scene& scene) {
    return scene.spans.empty() && scene.sheet ? file_of(*scene.sheet) : file_of(scene.spans);
}

} // namespace filum::render
