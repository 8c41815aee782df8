#include "slice/section.hpp"

#include "polygon/simple.hpp"

#include <algorithm>
#include <bit>

namespace filum::slice {

namespace {

constexpr double kGrid = polygon::kGridPerMm;

// The line where one triangle meets the plane: from one edge to another, solid on the left.
struct SectionSegment {
    EdgeKey from, to;
};

EdgeKey key(std::uint32_t a, std::uint32_t b) { return a < b ? EdgeKey{a} << 32 | b : EdgeKey{b} << 32 | a; }

// Precondition: the plane is between the triangle's lowest and highest vertex.
SectionSegment piece(const mesh::Triangle& t, bool a, bool b, bool c) {
    // k: the only vertex on its side of the plane; its edges are k-1 -> k and k -> k+1
    const unsigned above = (a ? 1U : 0U) | (b ? 2U : 0U) | (c ? 4U : 0U);
    const bool alone_above = above == 1 || above == 2 || above == 4;
    const auto k = static_cast<unsigned>(std::countr_zero(alone_above ? above : ~above));
    const std::uint32_t self = t[k], next = t[(k + 1) % 3], before = t[(k + 2) % 3];
    if (alone_above) return {key(self, next), key(before, self)};
    return {key(before, self), key(self, next)};
}

double snap(double v) {
    return static_cast<double>(static_cast<std::int64_t>(v * kGrid + (v < 0 ? -0.5 : 0.5))) / kGrid;
}

// The point on an edge.  The vertex with the lower number comes first, so both triangles get the same bits.
Vec2 crossing(const mesh::Mesh& mesh, EdgeKey edge, double plane) {
    const auto &p = mesh.vertices[edge >> 32], &q = mesh.vertices[edge & 0xffffffff];
    const double t = (plane - p.z) / (q.z - p.z);
    return {snap(p.x + t * (q.x - p.x)), snap(p.y + t * (q.y - p.y))};
}

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Per piece, the piece that continues where it ends, or kNone; and whether another piece comes before it.
struct Order {
    std::vector<std::uint32_t> next;
    std::vector<char> continues;
};
Order put_in_order(const std::vector<SectionSegment>& pieces) {
    const std::size_t size = std::bit_ceil(2 * pieces.size() + 1), mask = size - 1;
    std::vector<std::uint32_t> slot(size, kNone);
    const auto hash = [](EdgeKey k) { return static_cast<std::size_t>((k * 0x9e3779b97f4a7c15ULL) >> 32); };
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        std::size_t h = hash(pieces[i].from) & mask;
        while (slot[h] != kNone) h = (h + 1) & mask;
        slot[h] = i;
    }
    Order out{std::vector<std::uint32_t>(pieces.size(), kNone), std::vector<char>(pieces.size(), 0)};
    for (std::uint32_t i = 0; i < pieces.size(); ++i)
        for (std::size_t h = hash(pieces[i].to) & mask; slot[h] != kNone; h = (h + 1) & mask) {
            const std::uint32_t j = slot[h];
            if (pieces[j].from != pieces[i].to || out.continues[j] != 0) continue;
            out.next[i] = j;
            out.continues[j] = 1;
            break;
        }
    return out;
}

void append(std::vector<Vec2>& points, std::size_t first, Vec2 p) {
    if (points.size() == first || !(points.back() == p)) points.push_back(p);
}

// Links pieces to open contours, which start at pieces without a predecessor, and the rest to loops. Both are in the
// order of their first pieces.
Section link(const Part& part, double plane, const std::vector<SectionSegment>& pieces) {
    Section out;
    const mesh::Mesh& mesh = part.mesh;
    Loops& loops = out.loops;
    const Order order = put_in_order(pieces);
    std::vector<char> done(pieces.size(), 0);
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        if (order.continues[i] != 0) continue;
        OpenContour& c = out.open.emplace_back();
        c.head = pieces[i].from;
        for (std::uint32_t j = i; j != kNone; j = order.next[j]) {
            done[j] = 1;
            append(c.points, 0, crossing(mesh, pieces[j].from, plane));
            c.tail = pieces[j].to;
        }
        append(c.points, 0, crossing(mesh, c.tail, plane));
    }
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        if (done[i] != 0) continue;
        const std::size_t first = loops.points.size();
        for (std::uint32_t j = i; done[j] == 0; j = order.next[j]) {
            done[j] = 1;
            append(loops.points, first, crossing(mesh, pieces[j].from, plane));
        }
        while (loops.points.size() > first + 1 && loops.points.back() == loops.points[first]) loops.points.pop_back();
        if (loops.points.size() < first + 3)
            loops.points.resize(first); // the loop is smaller than the grid
        else {
            loops.close();
            out.body.push_back(part.bodies.of_vertex[pieces[i].from >> 32]);
        }
    }
    return out;
}

} // namespace

std::vector<Section> sections(const Sweep& sweep, std::size_t chunk) {
    const std::size_t first = chunk * kChunk, last = std::min(first + kChunk, sweep.levels.size());
    std::vector<std::vector<SectionSegment>> pieces(last - first);
    for (std::uint64_t k = sweep.chunk_start[chunk]; k < sweep.chunk_start[chunk + 1]; ++k) {
        const auto& t = sweep.part->mesh.triangles[sweep.triangles[k]];
        const std::uint32_t a = sweep.rank[t[0]], b = sweep.rank[t[1]], c = sweep.rank[t[2]];
        const auto [low, high] = std::minmax({a, b, c});
        for (std::size_t i = std::max<std::size_t>(low, first); i < std::min<std::size_t>(high, last); ++i)
            pieces[i - first].push_back(piece(t, a > i, b > i, c > i));
    }
    std::vector<Section> out;
    for (std::size_t i = first; i < last; ++i) {
        out.push_back(link(*sweep.part, sweep.levels[i].plane + kLift, pieces[i - first]));
        pieces[i - first] = {};
    }
    return out;
}

std::vector<OpenContour> lid_contours(const Sweep& sweep, std::size_t layer) {
    std::vector<SectionSegment> pieces;
    for (const auto& t : sweep.part->lids) {
        const bool a = sweep.rank[t[0]] > layer, b = sweep.rank[t[1]] > layer, c = sweep.rank[t[2]] > layer;
        if (a != b || b != c) pieces.push_back(piece(t, a, b, c));
    }
    std::vector<OpenContour> out = link(*sweep.part, sweep.levels[layer].plane + kLift, pieces).open;
    for (OpenContour& c : out) c.lid = length(c);
    return out;
}

} // namespace filum::slice
