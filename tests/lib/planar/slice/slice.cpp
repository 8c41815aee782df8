// What slicing promises, on meshes made by rule.
#include "slice/slice.hpp"
#include "../../shapes/mesh/shapes.hpp"
#include "base/error.hpp"
#include "mesh/holes.hpp"
#include "mesh/place.hpp"
#include "mutate.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace filum;
using mesh::Mesh;
using slice::Options;

namespace {

struct Result {
    std::vector<polygon::Layer> layers;
    Notes notes;
};

Result cut(const Mesh& m, const Options& o = {}, int threads = 1) {
    Result r;
    r.layers = slice::slice(slice::make_part(m, r.notes), o, r.notes, threads);
    return r;
}

double volume(const Result& r) {
    double sum = 0;
    for (const auto& l : r.layers) sum += l.height * polygon::signed_area(l.contours);
    return sum;
}

double noted(const Result& r, const std::string& what) {
    double sum = 0;
    for (const auto& n : r.notes)
        if (code_name(n).find(what) != std::string::npos) sum += n.amount;
    return sum;
}

// mm of open contours that were dropped.
double dropped(const Result& r) {
    double out = 0;
    for (const Note& n : r.notes)
        if (n.code == NoteCode::contour_open) out += n.amount;
    return out;
}

Mesh turned(Mesh m, double x, double y, double z) {
    Notes notes;
    mesh::Placement p;
    p.rotate_deg = {x, y, z};
    mesh::place(m, p, false, notes);
    return m;
}

Mesh snapped(Mesh m, double step) {
    for (auto& v : m.vertices) v.z = std::round(v.z / step) * step;
    return m;
}

std::vector<Mesh> solids() {
    return {shapes::box({0, 0, 0}, {12, 7, 5}), shapes::sphere(6, 4), shapes::torus(9, 3, 60, 30),
            shapes::together(shapes::sphere(4, 3), shapes::moved(shapes::torus(9, 2, 40, 20), {0, 0, 1}))};
}

} // namespace

TEST(Slice, AreasAddUpToTheVolume) {
    for (const Mesh& m : solids())
        for (const double a : {0.0, 33.0}) {
            const Mesh t = turned(m, a, 2 * a, 5);
            const Result r = cut(t, {.layer_height = 0.02});
            EXPECT_NEAR(volume(r) / mesh::volume(t), 1, 2e-3);
            EXPECT_TRUE(r.notes.empty());
            for (const auto& l : r.layers) EXPECT_TRUE(polygon::is_simple(l.contours));
        }
}

// Vertices exactly on planes, flat faces in them, edges along them: closed all the same.
TEST(Slice, AClosedMeshHasClosedContoursWhereverItsVerticesAre) {
    for (const Mesh& m : solids())
        for (const double step : {0.1, 0.2, 0.5, 1.0}) {
            const Mesh t = snapped(turned(m, 20, 10, 0), step);
            for (const double h : {0.2, 1.0}) {
                const Result r = cut(t, {.layer_height = h, .close_gaps = 0, .close_openings = 0, .hairline = 0});
                EXPECT_TRUE(r.notes.empty()) << code_name(r.notes.front());
                EXPECT_EQ(noted(r, "open"), 0);
            }
        }
}

TEST(Slice, ABoxIsExact) {
    const Result r = cut(shapes::box({1, 2, 0}, {11, 7, 3}));
    ASSERT_EQ(r.layers.size(), 15U);
    for (const auto& l : r.layers) {
        EXPECT_NEAR(l.z, 0.2 * (l.index + 1), 1e-12);
        EXPECT_NEAR(l.plane, 0.2 * (l.index + 0.5), 1e-12);
        EXPECT_DOUBLE_EQ(polygon::signed_area(l.contours), 50);
        EXPECT_EQ(l.contours.size(), 1U);
    }
}

TEST(Slice, AFaceLevelWithAPlaneCountsAsBelowIt) {
    // a step whose tread, and the ceiling of a recess, lie at the mid-height of layer 1, as single precision has it
    for (const double z : {0.3, static_cast<double>(0.3F), std::nextafter(0.3, 0.0)}) {
        const Result tread =
            cut(shapes::together(shapes::box({0, 0, 0}, {10, 5, 1}), shapes::box({20, 0, 0}, {30, 5, z})));
        ASSERT_EQ(tread.layers.size(), 5U);
        EXPECT_DOUBLE_EQ(polygon::signed_area(tread.layers[0].contours), 100);
        EXPECT_DOUBLE_EQ(polygon::signed_area(tread.layers[1].contours), 50) << z;
        const Result ceiling =
            cut(shapes::together(shapes::box({0, 0, 0}, {10, 5, 1}), shapes::box({20, 0, z}, {30, 5, 1})));
        EXPECT_DOUBLE_EQ(polygon::signed_area(ceiling.layers[0].contours), 50);
        EXPECT_DOUBLE_EQ(polygon::signed_area(ceiling.layers[1].contours), 100) << z;
    }
}

TEST(Slice, MovingThePartMovesTheContours) {
    for (const Mesh& m : solids()) {
        const Result a = cut(m), b = cut(shapes::moved(m, {1234.5, -777.25, 0}));
        ASSERT_EQ(a.layers.size(), b.layers.size());
        for (std::size_t i = 0; i < a.layers.size(); ++i) {
            const auto &p = a.layers[i].contours, &q = b.layers[i].contours;
            ASSERT_EQ(p.size(), q.size());
            ASSERT_EQ(p.points.size(), q.points.size());
            for (std::size_t k = 0; k < p.points.size(); ++k)
                EXPECT_LT(geom::distance(p.points[k] + geom::Vec2{1234.5, -777.25}, q.points[k]), 3e-4);
        }
    }
}

TEST(Slice, ThreadsDoNotMatter) {
    const Mesh m = shapes::together(shapes::torus(9, 3, 60, 30), shapes::moved(shapes::sphere(6, 4), {7, 0, 0}));
    const Result a = cut(m, {}, 1);
    for (const int threads : {2, 8}) {
        const Result b = cut(m, {}, threads);
        ASSERT_EQ(a.layers.size(), b.layers.size());
        for (std::size_t i = 0; i < a.layers.size(); ++i) {
            EXPECT_EQ(a.layers[i].contours.points, b.layers[i].contours.points);
            EXPECT_EQ(a.layers[i].contours.start, b.layers[i].contours.start);
        }
    }
}

TEST(Bodies, OverlappingOnesAreOne) {
    const Result r = cut(shapes::together(shapes::box({0, 0, 0}, {10, 10, 2}), shapes::box({5, 5, 0}, {15, 15, 2})));
    for (const auto& l : r.layers) {
        EXPECT_EQ(l.contours.size(), 1U);
        EXPECT_NEAR(polygon::signed_area(l.contours), 175, 1e-9);
    }
}

TEST(Bodies, OneWithinAnotherVanishesAndACavityStays) {
    const Mesh outer = shapes::box({0, 0, 0}, {10, 10, 10}), inner = shapes::box({3, 3, 3}, {6, 6, 6});
    EXPECT_NEAR(volume(cut(shapes::together(outer, inner))), 1000, 1e-6);
    EXPECT_NEAR(volume(cut(shapes::together(outer, shapes::inverted(inner)))), 1000 - 27, 1e-6);
    const Result r = cut(shapes::inverted(shapes::together(outer, shapes::inverted(inner))));
    EXPECT_NEAR(volume(r), 1000 - 27, 1e-6);
    EXPECT_GT(noted(r, "shell-turned"), 0);
}

// Faces that should be one, turned so that no coordinate is round: rounding, then gaps of some um, then real gaps.
TEST(Bodies, TouchingOnesAreOneAndClearOnesAreNot) {
    for (const double gap : {0.0, 1e-6, 1e-4, 0.003, 0.03}) {
        const Mesh m = turned(
            shapes::together(shapes::box({0, 0, 0}, {10, 10, 2}), shapes::box({10 + gap, 2, 0}, {20, 8, 2})), 0, 0, 31);
        const Result r = cut(m);
        for (const auto& l : r.layers) {
            EXPECT_EQ(l.contours.size(), 1U) << gap;
            EXPECT_NEAR(polygon::signed_area(l.contours), 160, 0.01) << gap;
        }
        EXPECT_EQ(noted(r, "hairline-gap") > 0, gap > 0.002) << gap;
    }
    const Result clear = cut(turned(
        shapes::together(shapes::box({0, 0, 0}, {10, 10, 2}), shapes::box({10.06, 2, 0}, {20, 8, 2})), 0, 0, 31));
    for (const auto& l : clear.layers) EXPECT_EQ(l.contours.size(), 2U);
    EXPECT_TRUE(clear.notes.empty());
}

// A pin in a hole: facets of different number leave crescents all around.
TEST(Bodies, APinInItsHoleLeavesNoCrescents) {
    const auto ring = [](double r, int n, double z0, double z1, bool inwards) {
        Mesh m;
        for (int i = 0; i < n; ++i)
            for (const double z : {z0, z1})
                m.vertices.push_back(
                    {r * std::cos(6.283185307179586 * i / n), r * std::sin(6.283185307179586 * i / n), z});
        const auto k = static_cast<std::uint32_t>(2 * n);
        for (std::uint32_t i = 0; i < k; i += 2) {
            m.triangles.push_back({i, (i + 2) % k, i + 1});
            m.triangles.push_back({(i + 2) % k, (i + 3) % k, i + 1});
        }
        return inwards ? shapes::inverted(m) : m;
    };
    const Mesh block =
        shapes::together(ring(20, 90, 0, 2, false), ring(5, 48, 0, 2, true)); // tubes: no ends are needed
    const Result r = cut(shapes::together(block, ring(5, 61, 0, 2, false)), {.hairline = 0.05});
    for (const auto& l : r.layers) EXPECT_EQ(l.contours.size(), 1U);
}

TEST(Bodies, AThousandShells) {
    Mesh m;
    for (int i = 0; i < 1000; ++i)
        m = shapes::together(std::move(m),
                             shapes::moved(shapes::sphere(1.2, 1), {i % 10 * 1.5, i / 10 % 10 * 1.5, i / 100 * 1.5}));
    const Result r = cut(m, {.layer_height = 0.5});
    EXPECT_GT(volume(r), 0.6 * 15 * 15 * 15);
    EXPECT_EQ(noted(r, "open"), 0);
}

TEST(Broken, FlippedTrianglesChangeNothing) {
    const Mesh m = shapes::torus(9, 3, 60, 30);
    Mesh f = m;
    for (std::size_t t = 0; t < f.triangles.size(); t += 13) std::swap(f.triangles[t][0], f.triangles[t][1]);
    const Result a = cut(m), b = cut(f);
    ASSERT_EQ(a.layers.size(), b.layers.size());
    for (std::size_t i = 0; i < a.layers.size(); ++i)
        EXPECT_NEAR(polygon::signed_area(a.layers[i].contours), polygon::signed_area(b.layers[i].contours), 1e-6);
    EXPECT_GT(noted(b, "turned"), 0);
}

TEST(Broken, HolesAreBridgedAndSaid) {
    const Mesh m = shapes::sphere(10, 5);
    Mesh h = m;
    std::erase_if(h.triangles, [&](const mesh::Triangle& t) { return h.vertices[t[0]].x > 8; }); // a window
    const Result a = cut(m), b = cut(h);
    EXPECT_EQ(dropped(b), 0);
    EXPECT_GT(noted(b, "hole"), 10);
    Mesh lidded = h;
    const auto lids = mesh::lids(lidded);
    lidded.triangles.insert(lidded.triangles.end(), lids.triangles.begin(), lids.triangles.end());
    EXPECT_NEAR(volume(b) / volume(cut(lidded)), 1, 1e-4);
    EXPECT_LT(volume(b), volume(a) - 100);
}

TEST(Broken, TrianglesThatShareNoVertexAreJoinedAcrossTheirGaps) {
    const Mesh m = shapes::sphere(10, 4);
    Mesh soup;
    std::uint64_t state = 5;
    const auto jitter = [&] {
        return static_cast<double>((state = state * 6364136223846793005ULL + 1) >> 40) / (1 << 24) * 0.004 - 0.002;
    };
    for (const auto& t : m.triangles)
        for (const auto v : t) soup.vertices.push_back(m.vertices[v] + mesh::Vec3{jitter(), jitter(), jitter()});
    for (std::uint32_t i = 0; i < soup.vertices.size(); i += 3) soup.triangles.push_back({i, i + 1, i + 2});
    const Result r = cut(soup);
    EXPECT_NEAR(volume(r) / volume(cut(m)), 1, 2e-3);
    EXPECT_GT(noted(r, "contour-gap-closed"), 0);
    EXPECT_LT(dropped(r), 0.01 * 180 * 60);
}

TEST(Broken, WhatHoldsNothingIsRefused) {
    const auto said = [](const Mesh& m) {
        try {
            cut(m);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input);
            return std::string(e.what());
        }
        return std::string();
    };
    Mesh sheet;
    sheet.vertices = {{0, 0, 0}, {5, 0, 0}, {5, 0, 2}, {0, 0, 2}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_NE(said(sheet).find("nothing lies within it"), std::string::npos);
    EXPECT_NE(said(turned(sheet, 20, 30, 40)).find("its surface is open"), std::string::npos);
    Mesh soup;
    mutate::Dice dice;
    for (std::uint32_t i = 0; i < 900; i += 3) {
        const mesh::Vec3 at = dice.shift(10);
        for (int k = 0; k < 3; ++k) soup.vertices.push_back(at + dice.shift(5) + mesh::Vec3{0, 0, 15});
        soup.triangles.push_back({i, i + 1, i + 2});
    }
    EXPECT_NE(said(soup).find("mm3 undecided, more than the"), std::string::npos);
}

TEST(Broken, TornTrianglesAreTurnedRoundAsTheirNeighboursSay) {
    const Mesh m =
        shapes::together(shapes::box({0, 0, 0}, {10, 10, 4}), shapes::inverted(shapes::box({3, 3, -1}, {6, 6, 5})));
    Mesh torn = mutate::soup(mutate::split(m, *std::make_unique<mutate::Dice>(), 1));
    mutate::Dice dice;
    for (auto& v : torn.vertices) v = v + dice.shift(0.01);
    for (std::size_t t = 0; t < torn.triangles.size(); t += 3) std::swap(torn.triangles[t][0], torn.triangles[t][1]);
    const Result r = cut(torn, {.layer_height = 1});
    ASSERT_EQ(r.layers.size(), 6U);
    EXPECT_NEAR(polygon::signed_area(r.layers[3].contours), 100 - 9, 1);
    EXPECT_GT(noted(r, "triangle-turned"), 0);
}

TEST(Broken, FarFromTheOrigin) {
    const Result r = cut(shapes::moved(shapes::sphere(10, 4), {1e6, -1e6, 0}));
    EXPECT_NEAR(volume(r) / volume(cut(shapes::sphere(10, 4))), 1, 1e-6);
    const Result large = cut(shapes::sphere(1e6, 4), {.layer_height = 1e4});
    EXPECT_NEAR(volume(large) / volume(cut(shapes::sphere(10, 4), {.layer_height = 0.1})), 1e15, 1e10);
}
