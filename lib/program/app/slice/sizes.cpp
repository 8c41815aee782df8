#include "app/slice/sizes.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "machine/profile.hpp"
#include "mesh/sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::app::slice {

namespace {

constexpr double kInch = 4, kTiny = 1; // mm: a part with a shorter longest side is probably in inches; is faulty
constexpr double kHuge = 1000;         // mm: beyond the reach of common machines
constexpr double kTold = 0.02;         // smallest change of the volume that is noted, as a fraction
constexpr double kRounding = 1e-6;     // mm by which a part may exceed the bed

Note unlikely(NoteCode code, double longest) { return {.code = code, .amount = longest}; }

std::string spoken(const geom::Vec3& size) {
    return fixed_text(size.x, 2) + " x " + fixed_text(size.y, 2) + " x " + fixed_text(size.z, 2) + " mm";
}

// The distance between neighbouring numbers in single precision at the value `at`.
double spacing(double at) {
    const auto f = static_cast<float>(std::abs(at));
    return std::nextafter(f, std::numeric_limits<float>::infinity()) - f;
}

bool fits(double x, double y, double z, const geom::Vec3& room) {
    return x <= room.x + kRounding && y <= room.y + kRounding && z <= room.z + kRounding;
}

} // namespace

void check_size(const mesh::Box3& box, bool unit_known, Notes& notes) {
    const geom::Vec3 size = box.hi - box.lo;
    const double longest = std::max({size.x, size.y, size.z});
    if (longest < (unit_known ? kTiny : kInch)) notes.push_back(unlikely(NoteCode::part_tiny, longest));
    if (longest > kHuge) notes.push_back(unlikely(NoteCode::part_huge, longest));
}

void check_precision(const mesh::Mesh& mesh, Notes& notes) {
    const mesh::Box3 box = mesh::bounds(mesh);
    double step = 0;
    for (const geom::Vec3& p : {box.lo, box.hi})
        for (const double c : {p.x, p.y, p.z}) step = std::max(step, spacing(c));
    const geom::Vec3 size = box.hi - box.lo;
    if (!(step > spacing(std::max({size.x, size.y, size.z})))) return; // the part is not far from the origin
    const auto single = [](double c) { return c == static_cast<double>(static_cast<float>(c)); };
    for (const geom::Vec3& v : mesh.vertices)
        if (!single(v.x) || !single(v.y) || !single(v.z)) return;
    double area = 0;
    for (const auto& t : mesh.triangles) area += mesh::area(mesh, t);
    const double moved = area * step / 2,
                 volume = std::abs(mesh::volume(mesh)); // if each face moves outwards by half a step
    if (!(moved > kTold * volume)) return;
    notes.push_back({.code = NoteCode::coordinates_rounded, .amount = moved, .detail = shortest_text(step)});
}

machine::Profile machine_of(const Options& o) {
    return machine::load_profile(o.machine.empty() ? "marlin" : o.machine, o.set);
}

void check_bed(const mesh::Box3& box, const Options& o) {
    if (o.machine.empty() && o.set.empty()) return;
    const machine::Profile profile = machine_of(o);
    if (profile.axes.active()) return;
    const machine::Bed& bed = profile.bed;
    const geom::Vec3 size = box.hi - box.lo, room{bed.x_max - bed.x_min, bed.y_max - bed.y_min, bed.z_max - bed.z_min};
    if (fits(size.x, size.y, size.z, room)) return;
    throw Error(Exit::bad_input, "cannot make the part with '" + profile.name + "': it is " + spoken(size) +
                                     ", and the machine reaches " + spoken(room) +
                                     (fits(size.y, size.x, size.z, room) ? "; turn it by --rotate 0,0,90"
                                                                         : "; check --unit and --scale"));
}

std::string size_text(geom::Vec2 v) { return fixed_text(v.x, 1) + " x " + fixed_text(v.y, 1) + " mm"; }

} // namespace filum::app::slice
