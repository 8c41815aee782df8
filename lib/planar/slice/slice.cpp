#include "slice/slice.hpp"

#include "base/error.hpp"
#include "mesh/holes.hpp"
#include "mesh/place.hpp"
#include "mesh/sheets.hpp"
#include "parallel/parallel.hpp"
#include "slice/volume.hpp"

#include <algorithm>

namespace filum::slice {

namespace {

constexpr std::uint64_t kMaxPoints = std::uint64_t{1} << 32;
constexpr std::size_t kGrain = 1 << 16;

std::vector<std::uint32_t> ranks(const mesh::Mesh& mesh, const std::vector<Level>& levels, int threads) {
    std::vector<double> planes;
    for (const Level& l : levels) planes.push_back(l.plane + kLift);
    std::vector<std::uint32_t> out(mesh.vertices.size());
    parallel::for_chunks(out.size(), kGrain, threads, [&](std::size_t from, std::size_t to) {
        for (std::size_t v = from; v < to; ++v) // the number of planes below the vertex
            out[v] = static_cast<std::uint32_t>(std::lower_bound(planes.begin(), planes.end(), mesh.vertices[v].z) -
                                                planes.begin());
    });
    return out;
}

// Lists, per chunk of layers, the triangles that its planes meet.
void fill_chunks(Sweep& s) {
    const std::size_t chunks = (s.levels.size() + kChunk - 1) / kChunk;
    s.chunk_start.assign(chunks + 1, 0);
    std::uint64_t points = 0;
    const auto each = [&](const auto& visit) {
        for (std::uint32_t t = 0; t < s.part->mesh.triangles.size(); ++t) {
            const auto& tri = s.part->mesh.triangles[t];
            const auto [low, high] = std::minmax({s.rank[tri[0]], s.rank[tri[1]], s.rank[tri[2]]});
            if (low < high) visit(t, low, high);
        }
    };
    each([&](std::uint32_t, std::uint32_t low, std::uint32_t high) {
        points += high - low;
        for (std::size_t c = low / kChunk; c <= (high - 1) / kChunk; ++c) ++s.chunk_start[c + 1];
        if (points > kMaxPoints)
            throw Error(Exit::bad_input, "cannot slice into " + std::to_string(s.levels.size()) +
                                             " layers: their contours would have more than 4 billion points; give a "
                                             "larger --layer-height");
    });
    for (std::size_t c = 0; c < chunks; ++c) s.chunk_start[c + 1] += s.chunk_start[c];
    s.triangles.resize(s.chunk_start.back());
    std::vector<std::uint64_t> at(s.chunk_start.begin(), s.chunk_start.end() - 1);
    each([&](std::uint32_t t, std::uint32_t low, std::uint32_t high) {
        for (std::size_t c = low / kChunk; c <= (high - 1) / kChunk; ++c) s.triangles[at[c]++] = t;
    });
}

} // namespace

Part make_part(mesh::Mesh mesh, Notes& notes, double least_wall) {
    Part out;
    const bool two_sided = mesh::part_sheets(mesh, notes);
    mesh::face_one_way(mesh, true, notes);
    // lids on the holes make the volumes and directions of shells more reliable
    mesh::Lids found = mesh::lids(mesh);
    const auto& lids = found.triangles;
    mesh.triangles.insert(mesh.triangles.end(), lids.begin(), lids.end());
    out.bodies = mesh::face_outwards(mesh, two_sided, least_wall, notes);
    const auto first_lid = mesh.triangles.end() - static_cast<std::ptrdiff_t>(lids.size());
    out.lids.assign(first_lid, mesh.triangles.end());
    out.holes = std::move(found.holes);
    mesh.triangles.erase(first_lid, mesh.triangles.end());
    if (!out.lids.empty())
        out.bodies = {std::vector<std::uint32_t>(mesh.vertices.size(), 0), {0}, out.bodies.shells, false};
    if (!out.bodies.closed) out.winding = std::make_shared<const mesh::Winding>(mesh, out.lids);
    out.mesh = std::move(mesh);
    return out;
}

Sweep sweep_over(const Part& part, const Options& options, std::vector<Level> levels, int threads) {
    Sweep s;
    s.part = &part;
    s.options = options;
    s.levels = std::move(levels);
    s.top = mesh::bounds(part.mesh).hi.z;
    s.rank = ranks(part.mesh, s.levels, threads);
    fill_chunks(s);
    return s;
}

Sweep prepare(const Part& part, const Options& options, int threads, Notes& notes) {
    return sweep_over(part, options, levels(part.mesh, options, notes), threads);
}

std::vector<polygon::Layer> slice(const Part& part, const Options& options, Notes& notes, int threads) {
    const Sweep s = prepare(part, options, threads, notes);
    const auto measured = judge(s, threads, notes);
    std::vector<SlicedChunk> cuts(s.chunks());
    parallel::for_chunks(cuts.size(), 1, threads, [&](std::size_t from, std::size_t to) {
        for (std::size_t c = from; c < to; ++c) cuts[c] = cut(s, c);
    });
    std::vector<polygon::Layer> out;
    for (SlicedChunk& c : cuts) {
        std::move(c.layers.begin(), c.layers.end(), std::back_inserter(out));
        std::move(c.notes.begin(), c.notes.end(), std::back_inserter(notes));
    }
    std::vector<double> area;
    for (const polygon::Layer& l : out) area.push_back(polygon::signed_area(l.contours));
    compare(s, measured, area, threads, notes);
    return out;
}

} // namespace filum::slice
