#include "mesh/items.hpp"

#include "geom/disjoint_sets.hpp"
#include "mesh/formats.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace filum::mesh {

namespace {

constexpr double kLevel = 1e-3;  // mm: heights that differ by less count as equal, as files round them
constexpr double kOpen = 1e-6;   // share of the area by which area vectors of a closed surface may differ from 0
constexpr double kBeyond = 1e-2; // mm by which the body below the bed is larger than the item

bool overlap_from_above(const geom::Box3& a, const geom::Box3& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

Mesh box_mesh(const geom::Vec3& lo, const geom::Vec3& hi) {
    Mesh out;
    for (int i = 0; i < 8; ++i)
        out.vertices.push_back({(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z});
    out.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return out;
}

} // namespace

Plates::Plates(const std::vector<Plate>& plates, int plate) : plates_(plates), plate_(plate) {
    if (plates.empty()) items_[1] = 0;
    for (const Plate& p : plates) items_[p.number] = 0;
}

bool Plates::wanted(const std::string& object) {
    const int instance = instances_[object]++;
    if (plates_.empty()) {
        ++items_[1];
        return plate_ == 1;
    }
    const auto on = std::ranges::find_if(plates_, [&](const Plate& p) {
        return std::ranges::find(p.items, std::pair(object, instance)) != p.items.end();
    });
    if (on == plates_.end()) {
        ++nowhere_;
        return false;
    }
    ++items_[on->number];
    return on->number == plate_;
}

std::string Plates::fault() const {
    const auto own = items_.find(plate_);
    if (own != items_.end() && (own->second > 0 || plates_.empty())) return "";
    std::string others;
    for (const auto& [number, items] : items_)
        if (items > 0) others += (others.empty() ? "" : ", ") + std::to_string(number);
    return "plate " + std::to_string(plate_) + (own != items_.end() ? " is empty" : " does not exist") +
           "; plates with parts: " + (others.empty() ? "none" : others + " (--plate)");
}

void Plates::tell(Notes& notes) const {
    for (const auto& [number, items] : items_) {
        if (number == plate_ || items == 0) continue;
        const auto plate = std::ranges::find(plates_, number, &Plate::number);
        const std::string name = plate != plates_.end() && !plate->name.empty() ? " '" + plate->name + "'" : "";
        notes.push_back(note(NoteCode::plate_ignored, 0, std::to_string(number) + name));
        notes.back().count = items;
    }
    if (nowhere_ == 0) return;
    notes.push_back(note(NoteCode::object_off_plate));
    notes.back().count = nowhere_;
}

std::vector<double> heights_to_lose(std::span<const geom::Box3> boxes, Notes& notes) {
    std::vector<double> out(boxes.size(), 0);
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty()) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return boxes[i].lo.x; });
    geom::DisjointSets groups(boxes.size());
    for (std::size_t a = 0; a < order.size(); ++a)
        for (std::size_t b = a + 1; b < order.size() && boxes[order[b]].lo.x <= boxes[order[a]].hi.x; ++b)
            if (overlap_from_above(boxes[order[a]], boxes[order[b]])) groups.unite(order[a], order[b]);
    std::vector<double> low(boxes.size(), std::numeric_limits<double>::infinity());
    for (const std::uint32_t i : order) low[groups.root(i)] = std::min(low[groups.root(i)], boxes[i].lo.z);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double z : low)
        if (std::isfinite(z)) {
            least = std::min(least, z);
            most = std::max(most, z);
        }
    if (!(most - least > kLevel)) return out;
    double farthest = 0;
    std::size_t moved = 0;
    for (const std::uint32_t i : order) {
        out[i] = low[groups.root(i)];
        if (std::abs(out[i]) > kLevel) ++moved;
        farthest = std::max(farthest, std::abs(out[i]));
    }
    notes.push_back(note(NoteCode::item_set_down, farthest));
    notes.back().count = moved;
    return out;
}

void cut_below_bed(const geom::Box3& box, std::uint32_t item, File& to) {
    if (box.empty() || !(box.lo.z < -kLevel)) return;
    const geom::Vec3 beyond{kBeyond, kBeyond, kBeyond};
    geom::Vec3 top = box.hi + beyond;
    top.z = 0;
    Body& body = to.bodies.emplace_back();
    body.what = Body::Purpose::negative;
    body.mesh = box_mesh(box.lo - beyond, top);
    body.item = item;
    to.notes.push_back(note(NoteCode::part_below_bed, -box.lo.z));
}

void face_outwards(Mesh& mesh, std::size_t from, std::span<const std::size_t> part, Notes& notes) {
    struct Shell {
        geom::Vec3 origin, sum; // the sum of area vectors, which is 0 for a closed surface
        double volume = 0, area = 0;
    };
    std::map<std::size_t, Shell> shells;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Triangle& t = mesh.triangles[from + i];
        Shell& s = shells.try_emplace(part[i], Shell{mesh.vertices[t[0]], {}}).first->second;
        const geom::Vec3 a = mesh.vertices[t[0]] - s.origin, b = mesh.vertices[t[1]] - s.origin,
                         c = mesh.vertices[t[2]] - s.origin;
        const geom::Vec3 doubled = cross(b - a, c - a);
        s.sum = s.sum + doubled;
        s.area += norm(doubled);
        s.volume += dot(a, cross(b, c)) / 6;
    }
    Note turned = note(NoteCode::shell_turned);
    turned.count = 0;
    const auto inwards = [](const Shell& s) { return s.volume < 0 && norm(s.sum) <= kOpen * s.area; };
    for (const auto& [number, s] : shells)
        if (inwards(s)) {
            ++turned.count;
            turned.amount -= s.volume;
        }
    if (turned.count == 0) return;
    for (std::size_t i = 0; i < part.size(); ++i)
        if (inwards(shells.at(part[i]))) std::swap(mesh.triangles[from + i][1], mesh.triangles[from + i][2]);
    notes.push_back(std::move(turned));
}

void tell_bodies(File& to) {
    const auto count = [&](const auto& fits) {
        return static_cast<std::size_t>(std::ranges::count_if(to.bodies, fits));
    };
    tell(NoteCode::project_modifier,
         count([](const Body& b) { return b.what == Body::Purpose::modifier && !b.printed; }), to.notes);
    tell(NoteCode::project_part_settings, count([](const Body& b) { return b.printed && changes_settings(b); }),
         to.notes);
    tell(NoteCode::project_support_body,
         count([](const Body& b) { return wants_supports(b, true) || wants_supports(b, false); }), to.notes);
}

Mesh part_of(const Mesh& mesh, std::span<const Triangle> triangles) {
    Mesh out;
    std::unordered_map<std::uint32_t, std::uint32_t> index;
    for (const Triangle& t : triangles) {
        Triangle& own = out.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [at, fresh] = index.try_emplace(t[k], static_cast<std::uint32_t>(out.vertices.size()));
            if (fresh) out.vertices.push_back(mesh.vertices[t[k]]);
            own[k] = at->second;
        }
    }
    return out;
}

} // namespace filum::mesh
