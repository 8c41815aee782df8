#include "app/slice/carved.hpp"

#include "base/error.hpp"
#include "mesh/place.hpp"
#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"
#include "slice/volume.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace filum::app::slice {

namespace {

using filum::slice::kLift;
using filum::slice::Level;
using polygon::Loops;

constexpr std::size_t kMostPlanes = 20000; // most planes that are searched for material
constexpr int kHalvings = 20;              // most halvings of the step between two planes

// The contours of the part in layer `i` of the chunk without the bodies that are cut away.
Loops contours(polygon::Layer& part, const std::vector<filum::slice::SlicedChunk>& away, std::size_t i) {
    Loops all;
    for (const filum::slice::SlicedChunk& body : away) all.add(body.layers[i].contours);
    return all.empty() ? std::move(part.contours) : polygon::subtract(part.contours, all);
}

// The contours of the remaining material in each of the planes (z, mm).
std::vector<Loops> sections(CarvedPart& carved, const std::vector<double>& planes, int threads) {
    std::vector<Level> levels;
    levels.reserve(planes.size());
    for (const double z : planes) levels.push_back({z, kLift, z - kLift});
    sweep(carved, {}, levels, threads);
    std::vector<Loops> out(planes.size());
    const std::size_t chunks = (planes.size() + filum::slice::kChunk - 1) / filum::slice::kChunk;
    parallel::for_chunks(chunks, 1, threads, [&](std::size_t from, std::size_t to) {
        for (std::size_t c = from; c < to; ++c)
            for (polygon::Layer& layer : cut(carved, c).layers) out[layer.index] = std::move(layer.contours);
    });
    return out;
}

// The height where the remaining material ends, between a plane that meets it and one that does not.
double end_between(CarvedPart& carved, double inside, double outside) {
    for (int i = 0; i < kHalvings && std::abs(outside - inside) > kLift / 10; ++i) {
        const double middle = (inside + outside) / 2;
        (sections(carved, {middle}, 1)[0].empty() ? outside : inside) = middle;
    }
    // The end usually is at a vertex of the part or of a negative body, so the nearest one within 2 kLift is taken.
    double out = (inside + outside) / 2;
    double nearest = 2 * kLift;
    const auto look = [&](const CarvedPart::Cut& c) {
        for (const geom::Vec3& v : c.part.mesh.vertices)
            if (std::abs(v.z - (inside + outside) / 2) < nearest) {
                nearest = std::abs(v.z - (inside + outside) / 2);
                out = v.z;
            }
    };
    for (const auto& group : carved.groups) {
        look(group->part);
        for (const auto& body : group->away) look(*body);
    }
    return out;
}

geom::Box3 box_left(CarvedPart& carved, const geom::Box3& whole, double step, int threads) {
    const double height = whole.hi.z - whole.lo.z;
    const auto count = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(height / step)), 2, kMostPlanes);
    std::vector<double> planes(count);
    for (std::size_t i = 0; i < count; ++i)
        planes[i] = whole.lo.z + height * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const std::vector<Loops> found = sections(carved, planes, threads);
    geom::Box3 out;
    std::optional<std::size_t> first, last;
    for (std::size_t i = 0; i < count; ++i) {
        if (found[i].empty()) continue;
        if (!first) first = i;
        last = i;
        const geom::Box2 box = polygon::bounds(found[i]);
        out.add(geom::Vec3{box.lo.x, box.lo.y, planes[i]});
        out.add(geom::Vec3{box.hi.x, box.hi.y, planes[i]});
    }
    if (!first) throw Error(Exit::bad_input, "cannot slice the part: its project cuts all of it away");
    out.lo.z = end_between(carved, planes[*first], *first > 0 ? planes[*first - 1] : whole.lo.z - 2 * kLift);
    out.hi.z = end_between(carved, planes[*last], *last + 1 < count ? planes[*last + 1] : whole.hi.z + 2 * kLift);
    return out;
}

} // namespace

bool is_carved(const mesh::File& file) { return !file.items.empty(); }

CarvedPart carve(const mesh::File& file, double hairline, double step, int threads, Notes& notes) {
    std::map<std::uint32_t, std::pair<mesh::Mesh, std::vector<mesh::Mesh>>> cut; // by item: it, its negative bodies
    std::uint64_t bodies = 0;
    for (const mesh::Body& body : file.bodies) {
        if (body.what != mesh::Body::Purpose::negative) continue;
        cut[body.item].second.push_back(body.mesh);
        ++bodies;
    }
    mesh::Mesh rest{file.mesh.vertices, {}};
    for (auto& [item, meshes] : cut) meshes.first.vertices = file.mesh.vertices;
    for (std::size_t i = 0; i < file.mesh.triangles.size(); ++i) {
        const auto at = cut.find(file.items[i]);
        (at == cut.end() ? rest : at->second.first).triangles.push_back(file.mesh.triangles[i]);
    }
    CarvedPart out;
    const auto add = [&](mesh::Mesh part, std::vector<mesh::Mesh> away) {
        mesh::drop_unused_vertices(part);
        if (part.triangles.empty()) return;
        auto group = std::make_unique<CarvedPart::Group>();
        group->part.part = filum::slice::make_part(std::move(part), notes, hairline);
        for (mesh::Mesh& body : away) {
            auto& to = group->away.emplace_back(std::make_unique<CarvedPart::Cut>());
            to->part = filum::slice::make_part(std::move(body), notes, hairline);
        }
        out.groups.push_back(std::move(group));
    };
    add(std::move(rest), {});
    for (auto& [item, meshes] : cut) add(std::move(meshes.first), std::move(meshes.second));
    notes.push_back({.code = NoteCode::project_negative_cut, .count = bodies});
    out.box = box_left(out, mesh::bounds(file.mesh), step, threads);
    return out;
}

void sweep(CarvedPart& carved, const filum::slice::Options& options, const std::vector<Level>& levels, int threads) {
    for (const auto& group : carved.groups) {
        group->part.sweep = filum::slice::sweep_over(group->part.part, options, levels, threads);
        for (const auto& body : group->away)
            body->sweep = filum::slice::sweep_over(body->part, options, levels, threads);
    }
}

filum::slice::SlicedChunk cut(const CarvedPart& carved, std::size_t chunk) {
    filum::slice::SlicedChunk out;
    for (const auto& group : carved.groups) {
        filum::slice::SlicedChunk part = filum::slice::cut(group->part.sweep, chunk);
        std::ranges::move(part.notes, std::back_inserter(out.notes));
        std::vector<filum::slice::SlicedChunk> away;
        for (const auto& body : group->away) {
            away.push_back(filum::slice::cut(body->sweep, chunk));
            std::ranges::move(away.back().notes, std::back_inserter(out.notes));
        }
        const bool first = out.layers.empty();
        for (std::size_t i = 0; i < part.layers.size(); ++i) {
            polygon::Layer& layer = part.layers[i];
            Loops left = contours(layer, away, i);
            if (first) {
                layer.contours = std::move(left);
                out.layers.push_back(std::move(layer));
            } else if (!left.empty()) {
                Loops& all = out.layers[i].contours;
                all = all.empty() ? std::move(left) : polygon::unite(all, left);
            }
        }
    }
    return out;
}

mesh::Mesh within_heights(mesh::Mesh mesh, const geom::Box3& box) {
    for (geom::Vec3& v : mesh.vertices) v.z = std::clamp(v.z, box.lo.z, box.hi.z);
    const auto same = [&](std::uint32_t a, std::uint32_t b) { return mesh.vertices[a] == mesh.vertices[b]; };
    std::erase_if(mesh.triangles,
                  [&](const mesh::Triangle& t) { return same(t[0], t[1]) || same(t[1], t[2]) || same(t[2], t[0]); });
    return mesh;
}

} // namespace filum::app::slice
