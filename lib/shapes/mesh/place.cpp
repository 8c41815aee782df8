#include "mesh/place.hpp"

#include "base/error.hpp"
#include "base/length_unit.hpp"
#include "geom/angle.hpp"
#include "mesh/formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::mesh {

namespace {

// Sine and cosine, exact for quarter turns, so that a part set upright stands exactly upright.
struct SineCosine {
    double cos, sin;
};
SineCosine turn(double degrees) {
    const double d = std::remainder(degrees, 360.0);
    if (d == 0) return {1, 0};
    if (d == 90) return {0, 1};
    if (d == -90) return {0, -1};
    if (std::abs(d) == 180) return {-1, 0};
    const double r = geom::radians(d);
    return {std::cos(r), std::sin(r)};
}

Affine rotation(int axis, double degrees) {
    const auto [c, s] = turn(degrees);
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    Affine out;
    out.a[j][j] = c;
    out.a[j][k] = s;
    out.a[k][j] = -s;
    out.a[k][k] = c;
    return out;
}

constexpr std::array<std::string_view, 5> kUnits{"um", "mm", "cm", "m", "in"}; // the values of --unit, except "auto"

// Guesses the unit from the longest side. Parts measure some millimetres to some decimetres: below 0.4 units the unit
// is taken as metres, below 4 as inches.
const char* guess(double longest) { return longest < 0.4 ? "m" : longest < 4 ? "in" : "mm"; }

double unit_mm(const std::string& unit, double longest, bool in_mm, Notes& notes) {
    if (in_mm) {
        if (unit != "auto" && unit != "mm")
            throw Error(Exit::usage, "cannot use '" + unit + "' for --unit: the file states its own unit; use --scale");
        return 1;
    }
    const std::string name = unit == "auto" ? guess(longest) : unit;
    if (unit == "auto" && name != "mm") {
        notes.push_back(note(NoteCode::unit_guessed, longest));
        notes.back().detail = name;
    }
    if (std::ranges::find(kUnits, name) != kUnits.end()) return *length_of_symbol(name);
    throw Error(Exit::usage, "cannot use '" + unit + "' for --unit: it must be one of auto, um, mm, cm, m, in");
}

Affine placement_map(const Placement& p, double unit) {
    if (p.scale.size() != 1 && p.scale.size() != 3)
        throw Error(Exit::usage, "cannot use --scale: it takes one number or three");
    Affine map;
    for (std::size_t k = 0; k < 3; ++k) {
        const double s = p.scale.size() == 3 ? p.scale[k] : p.scale[0];
        if (s == 0) throw Error(Exit::usage, "cannot use '0' for --scale: nothing would be left");
        map.a[k][k] = s * unit;
    }
    return then(map, rigid(p.rotate_deg, p.translate));
}

double longest_side(const Box3& b) { return std::max({b.hi.x - b.lo.x, b.hi.y - b.lo.y, b.hi.z - b.lo.z}); }

bool within_limits(const Box3& b) {
    for (const double v : {b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z})
        if (!(std::abs(v) <= kMaxCoordinate)) return false;
    return true;
}

} // namespace

void append(const Mesh& from, Mesh& to) {
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (const Triangle& t : from.triangles) to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

void drop_unused_vertices(Mesh& mesh) {
    std::vector<std::uint32_t> to(mesh.vertices.size(), kNoVertex);
    for (const Triangle& t : mesh.triangles)
        for (const auto v : t) to[v] = 0;
    if (std::find(to.begin(), to.end(), kNoVertex) == to.end()) return;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
        if (to[i] == kNoVertex) continue;
        mesh.vertices[count] = mesh.vertices[i];
        to[i] = count++;
    }
    mesh.vertices.resize(count);
    mesh.renumber(to);
    for (Triangle& t : mesh.triangles)
        for (auto& v : t) v = to[v];
}

Affine rigid(const std::vector<double>& rotate_deg, const std::vector<double>& translate) {
    Affine map;
    for (int axis = 0; axis < 3; ++axis) map = then(map, rotation(axis, rotate_deg[static_cast<std::size_t>(axis)]));
    for (std::size_t k = 0; k < 3; ++k) map.t[k] += translate[k];
    return map;
}

Box3 bounds(const Mesh& mesh) { return geom::box_of(mesh.vertices); }

void move(Mesh& mesh, const Affine& map) {
    for (Vec3& v : mesh.vertices) v = map(v);
    if (map.mirrors())
        for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    if (!within_limits(bounds(mesh)))
        throw Error(Exit::bad_input, "cannot use the part: it reaches beyond 10000 m; check --unit and --scale");
}

PlacementMap place(Mesh& mesh, const Placement& placement, bool in_mm, Notes& notes) {
    drop_unused_vertices(mesh);
    const double unit = unit_mm(placement.unit, longest_side(bounds(mesh)), in_mm, notes);
    const Affine map = placement_map(placement, unit);
    move(mesh, map);
    const Box3 box = bounds(mesh);
    Vec3 shift;
    if (!placement.center.empty()) {
        shift.x = placement.center[0] - (box.lo.x + box.hi.x) / 2;
        shift.y = placement.center[1] - (box.lo.y + box.hi.y) / 2;
    }
    if (placement.on_bed && !placement.keep_z) shift.z = -box.lo.z;
    const Affine on{.t = {shift.x, shift.y, shift.z}};
    if (shift != Vec3{}) move(mesh, on);
    return {then(map, on), unit};
}

} // namespace filum::mesh
