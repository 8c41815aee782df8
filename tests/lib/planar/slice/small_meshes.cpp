// Small meshes of any kind: each one is sliced, and connected to a surface and measured, within a time limit.
//
// FILUM_SMALL_MESHES=N tries every Nth of the enumerated meshes and as many random ones; 1 tries all of the 60,000
// sets of up to three triangles on seven vertices, and 60,000 random ones.
#include "base/error.hpp"
#include "geodesic/measure.hpp"
#include "slice/slice.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <random>
#include <set>
#include <sys/time.h>
#include <unistd.h>

using namespace filum;

namespace small {

constexpr int kSeconds = 10; // of CPU time that one mesh may take
constexpr std::uint32_t kVertices = 7;

std::string now_at_work; // the mesh that the time limit is for

extern "C" inline void too_slow(int) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, now_at_work.data(), now_at_work.size());
    std::abort();
}

// CPU time, so that a busy machine fails no test; 0: no limit.
void limit_time(int seconds) {
    const itimerval limit{{0, 0}, {seconds, 0}};
    ::setitimer(ITIMER_PROF, &limit, nullptr);
}

// Every mesh gets an answer in time: layers, or an Error that is none of the program's own.
void passes(const mesh::Mesh& m, const std::string& name) {
    now_at_work = "no end within the time limit: " + name + "\n";
    limit_time(kSeconds);
    const auto answered = [&](const char* what, const auto& work) {
        try {
            work();
        } catch (const Error& e) {
            EXPECT_EQ(std::string(e.what()).find("internal error"), std::string::npos)
                << what << ", " << name << ": " << e.what();
        } catch (const std::exception& e) {
            ADD_FAILURE() << what << ", " << name << ": " << e.what();
        }
    };
    answered("slice", [&] {
        Notes notes;
        const auto part = slice::make_part(m, notes);
        slice::slice(part, {.layer_height = 1}, notes, 1);
    });
    answered("geodesic", [&] {
        Notes notes;
        surface::Sheet sheet{surface::connect(m, notes), {}, {}};
        geodesic::measure(sheet, {.vertices = {0}, .segments = {}}, {.levels = {1, 3}}, notes);
    });
    limit_time(0);
}

// The corners of a box and a point within, none of them on a line with two others of the same face.
mesh::Mesh seven_vertices() {
    mesh::Mesh m;
    m.vertices = {{0, 0, 0}, {5, 0, 0.5}, {5, 4, 0}, {0, 4, 0.25}, {0.5, 0, 6}, {5, 0.25, 6}, {2, 2, 3}};
    return m;
}

// All triangles on the seven vertices, both ways round; each begins at its least corner.
std::vector<mesh::Triangle> all_triangles() {
    std::vector<mesh::Triangle> out;
    for (std::uint32_t a = 0; a < kVertices; ++a)
        for (std::uint32_t b = a + 1; b < kVertices; ++b)
            for (std::uint32_t c = b + 1; c < kVertices; ++c) {
                out.push_back({a, b, c});
                out.push_back({a, c, b});
            }
    return out;
}

// A closed tetrahedron or a fan, or single triangles, on a coarse grid.
void add_piece(mesh::Mesh& m, std::mt19937& chance, std::uint32_t vertices) {
    const auto any = [&](std::uint32_t n) { return static_cast<std::uint32_t>(chance() % n); };
    const std::uint32_t a = any(vertices), b = any(vertices), c = any(vertices), d = any(vertices);
    switch (any(3)) {
    case 0:
        m.triangles.insert(m.triangles.end(), {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}});
        break;
    case 1:
        for (std::uint32_t k = 0; k < 2 + any(6); ++k)
            m.triangles.push_back({a, (b + k) % vertices, (b + k + 1) % vertices});
        break;
    default:
        m.triangles.push_back({a, b, c});
    }
}

// Some triangles a second time, some of those the other way round, some vertices in the place of another one.
mesh::Mesh random_mesh(std::uint32_t seed) {
    std::mt19937 chance(seed);
    const auto any = [&](std::uint32_t n) { return static_cast<std::uint32_t>(chance() % n); };
    mesh::Mesh m;
    const std::uint32_t vertices = 4 + any(27);
    const std::uint32_t grid = 2 + any(8);
    std::set<std::array<std::uint32_t, 3>> taken;
    while (m.vertices.size() < vertices) { // a mesh that was read has no two vertices in one place
        const std::array<std::uint32_t, 3> p{any(grid + 2), any(grid + 2), any(grid + 2)};
        if (taken.insert(p).second || taken.size() >= vertices)
            m.vertices.push_back({double(p[0]), double(p[1]), double(p[2])});
    }
    const std::uint32_t pieces = 1 + any(12);
    for (std::uint32_t k = 0; k < pieces; ++k) add_piece(m, chance, vertices);
    const auto before = static_cast<std::uint32_t>(m.triangles.size());
    for (std::uint32_t k = any(1 + before); k > 0; --k) {
        mesh::Triangle t = m.triangles[any(before)];
        if (any(2) == 0) std::swap(t[1], t[2]);
        m.triangles.push_back(t);
    }
    std::erase_if(m.triangles, [](const mesh::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    return m;
}

std::size_t every() {
    const char* n = std::getenv("FILUM_SMALL_MESHES");
    return n == nullptr ? 1000 : std::max(1UL, std::strtoul(n, nullptr, 10));
}

std::uint32_t first_seed() {
    const char* seed = std::getenv("FILUM_FIRST_MESH");
    return seed == nullptr ? 0 : static_cast<std::uint32_t>(std::strtoul(seed, nullptr, 10));
}

} // namespace small

TEST(SmallMeshes, ARingOfTrianglesRoundAVertexWithoutTheFirstOneEnds) {
    mesh::Mesh m = small::seven_vertices();
    m.triangles = {{6, 0, 1}, {6, 1, 2}, {6, 2, 1}};
    std::signal(SIGPROF, small::too_slow);
    small::passes(m, "a flag with two sides and a flap");
}

TEST(SmallMeshes, AllOfUpToThreeTriangles) {
    std::signal(SIGPROF, small::too_slow);
    const auto all = small::all_triangles();
    const std::size_t step = small::every();
    std::size_t count = 0;
    mesh::Mesh m = small::seven_vertices();
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i; j < all.size(); ++j)
            for (std::size_t k = j; k < all.size(); ++k) {
                if (count++ % step != 0) continue;
                m.triangles = {all[i], all[j], all[k]};
                small::passes(m, "triangles " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(k));
            }
}

TEST(SmallMeshes, RandomOnesWithCopiesFlapsAndPinches) {
    std::signal(SIGPROF, small::too_slow);
    const std::size_t count = 60000 / small::every();
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t seed = small::first_seed() + k;
        const mesh::Mesh m = small::random_mesh(seed);
        if (!m.triangles.empty()) small::passes(m, "seed " + std::to_string(seed));
    }
}
