#include "mesh/formats.hpp"
#include "mesh/place.hpp"

#include <algorithm>
#include <numeric>

namespace filum::mesh {

namespace {

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}

// What the triangles of a shell, or of all shells, add up to.
struct Sums {
    double volume = 0; // six times, about the middle of the box
    Vec3 area;         // vectors, twice: they cancel out if it is closed
    double size = 0;   // twice the area
    // An open sheet has no volume that would tell inside from outside; a few holes do not matter.
    [[nodiscard]] bool nearly_closed() const { return norm(area) <= 0.05 * size; }
};

struct Shell {
    Vec3 lo{1e300, 1e300, 1e300}, hi{-1e300, -1e300, -1e300};
    Sums sums;
};

bool holds(const Shell& outer, const Shell& inner) {
    return outer.lo.x <= inner.lo.x && outer.lo.y <= inner.lo.y && outer.lo.z <= inner.lo.z &&
           outer.hi.x >= inner.hi.x && outer.hi.y >= inner.hi.y && outer.hi.z >= inner.hi.z;
}

void add(Sums& sums, const Mesh& mesh, const Triangle& t, const Vec3& origin) {
    const Vec3 a = mesh.vertices[t[0]] - origin, b = mesh.vertices[t[1]] - origin, c = mesh.vertices[t[2]] - origin;
    const Vec3 n = cross(b - a, c - a);
    sums.volume += dot(a, n);
    sums.area = sums.area + n;
    sums.size += norm(n);
}

std::vector<Shell> measure(const Mesh& mesh, const std::vector<std::uint32_t>& shell, std::size_t count) {
    std::vector<Shell> out(count);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3& p = mesh.vertices[v];
        Shell& s = out[shell[v]];
        s.lo = {std::min(s.lo.x, p.x), std::min(s.lo.y, p.y), std::min(s.lo.z, p.z)};
        s.hi = {std::max(s.hi.x, p.x), std::max(s.hi.y, p.y), std::max(s.hi.z, p.z)};
    }
    for (const Triangle& t : mesh.triangles) {
        Shell& s = out[shell[t[0]]];
        add(s.sums, mesh, t, 0.5 * (s.lo + s.hi));
    }
    return out;
}

Note turned_note(std::size_t count, double volume6) {
    Note n = note("shell that was inside out turned round", std::abs(volume6) / 6, "mm3");
    n.count = count;
    return n;
}

void turn_round(Triangle& t) { std::swap(t[1], t[2]); }

// Turns everything round if the whole is inside out.
void face_whole_outwards(Mesh& mesh, std::vector<Shell>& shells, Notes& notes) {
    const Box3 box = bounds(mesh);
    Sums whole;
    if (shells.size() == 1)
        whole = shells[0].sums;
    else
        for (const Triangle& t : mesh.triangles) add(whole, mesh, t, 0.5 * (box.lo + box.hi));
    if (whole.volume >= 0 || !whole.nearly_closed()) return;
    for (Triangle& t : mesh.triangles) turn_round(t);
    for (Shell& s : shells) s.sums.volume = -s.sums.volume;
    notes.push_back(turned_note(shells.size(), whole.volume));
}

} // namespace

double volume(const Mesh& mesh) {
    Sums sums;
    if (!mesh.vertices.empty())
        for (const Triangle& t : mesh.triangles) add(sums, mesh, t, mesh.vertices.front());
    return sums.volume / 6;
}

Shells shells_of(const Mesh& mesh) {
    Shells out;
    auto& shell = out.of_vertex;
    shell.resize(mesh.vertices.size());
    std::iota(shell.begin(), shell.end(), 0U);
    for (const Triangle& t : mesh.triangles) {
        const auto a = root(shell, t[0]);
        for (const auto v : {t[1], t[2]}) { // the lower number wins: roots are the first vertices
            const auto r = root(shell, v), s = root(shell, a);
            if (r != s) shell[std::max(r, s)] = std::min(r, s);
        }
    }
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < shell.size(); ++v) // a parent comes before its children
        shell[v] = shell[v] == v ? count++ : shell[shell[v]];
    out.count = count;
    return out;
}

std::size_t face_outwards(Mesh& mesh, Notes& notes) {
    const auto [shell, count] = shells_of(mesh);
    auto shells = measure(mesh, shell, count);
    face_whole_outwards(mesh, shells, notes);
    std::vector<const Shell*> solid; // largest first: one of them holds most cavities
    for (const Shell& s : shells)
        if (s.sums.volume > 0) solid.push_back(&s);
    std::stable_sort(solid.begin(), solid.end(),
                     [](const Shell* a, const Shell* b) { return a->sums.volume > b->sums.volume; });
    std::vector<char> turned(count, 0);
    std::size_t inverted = 0;
    double volume = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Shell& s = shells[i];
        if (s.sums.volume >= 0 || !s.sums.nearly_closed()) continue;
        if (std::any_of(solid.begin(), solid.end(), [&](const Shell* o) { return holds(*o, s); })) continue;
        turned[i] = 1;
        ++inverted;
        volume += s.sums.volume;
    }
    if (inverted == 0) return count;
    for (Triangle& t : mesh.triangles)
        if (turned[shell[t[0]]] != 0) turn_round(t);
    notes.push_back(turned_note(inverted, volume));
    return count;
}

} // namespace filum::mesh
