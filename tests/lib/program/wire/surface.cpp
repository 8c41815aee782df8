// What a surface message promises, and that every broken promise is noticed.
#include "wire/surface.hpp"
#include "base/error.hpp"

#include <filum/stream.pb.h> // a fault needs a message to be put into

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

namespace filum::wire {
namespace {

surface::Sheet good() {
    surface::Sheet s;
    s.surface = surface::assemble({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}}, {{0, 1, 2}, {2, 1, 3}},
                                  {surface::kNone, 3, surface::kNone, 1, surface::kNone, surface::kNone});
    s.fields = {{"distance", {0, 1, 1, std::numeric_limits<double>::infinity()}, 1},
                {"stress.x.d1", {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0}, 3}};
    s.isolines = {{0.5, false, {{0.5, 0, 0}, {0, 0.5, 0}}, {0}},
                  {0.7, true, {{0.5, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}}, {0, 0, 1}}};
    s.sources = {{2}, {{1, {0.5, 0.5, 0}, {1, 1, 0.5}}}};
    s.name = "A.1";
    s.faces = {7, 0};
    s.algorithm = "geo-fiso";
    return s;
}

TEST(SurfaceMessage, ComesOutAsItWentIn) {
    const auto raw = frame(good());
    EXPECT_EQ(raw.tag, stream::Tag::surface);
    const auto s = sheet(raw);
    EXPECT_EQ(s.surface.vertices, good().surface.vertices);
    EXPECT_EQ(s.surface.triangles, good().surface.triangles);
    EXPECT_EQ(s.surface.twin, good().surface.twin);
    ASSERT_EQ(s.surface.rims.size(), 1U);
    ASSERT_EQ(s.fields.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(s.fields[i].name, good().fields[i].name);
        EXPECT_EQ(s.fields[i].components, good().fields[i].components);
        EXPECT_EQ(s.fields[i].values, good().fields[i].values);
    }
    EXPECT_EQ(s.sources.vertices, good().sources.vertices);
    ASSERT_EQ(s.sources.segments.size(), 1U);
    EXPECT_EQ(s.sources.segments[0].b, good().sources.segments[0].b);
    ASSERT_EQ(s.isolines.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(s.isolines[i].level, good().isolines[i].level);
        EXPECT_EQ(s.isolines[i].closed, good().isolines[i].closed);
        EXPECT_EQ(s.isolines[i].points, good().isolines[i].points);
        EXPECT_EQ(s.isolines[i].triangles, good().isolines[i].triangles);
    }
    EXPECT_EQ(s.name, good().name);
    EXPECT_EQ(s.faces, good().faces);
    EXPECT_EQ(s.algorithm, good().algorithm);
    EXPECT_EQ(frame(s).body, raw.body);
}

TEST(SurfaceMessage, FaultsAreNoticed) {
    const std::function<void(proto::Surface&)> faults[] = {
        [](auto& m) { m.add_x(1); },
        [](auto& m) { m.set_x(1, std::nan("")); },
        [](auto& m) { m.set_z(3, 1e9); },
        [](auto& m) { m.add_corner(1); },
        [](auto& m) { m.set_corner(2, 4); },
        [](auto& m) { m.set_corner(2, 0); },
        [](auto& m) {
            m.clear_corner();
            m.clear_across();
        },
        [](auto& m) { m.clear_across(); },
        [](auto& m) { m.set_across(1, 0); },
        [](auto& m) { m.set_across(0, 77); },
        [](auto& m) {
            m.add_x(1);
            m.add_y(1);
            m.add_z(1);
        }, // a vertex of no triangle
        [](auto& m) { m.mutable_fields(0)->add_value(1); },
        [](auto& m) { m.mutable_fields(0)->set_value(1, std::nan("")); },
        [](auto& m) { m.clear_fields(); },
        [](auto& m) { m.mutable_fields(1)->set_components(2); },
        [](auto& m) { m.mutable_fields(1)->set_components(1); },
        [](auto& m) { m.mutable_sources()->set_vertex(0, 4); },
        [](auto& m) { m.mutable_sources()->set_triangle(0, 2); },
        [](auto& m) { m.mutable_sources()->add_ax(2); },
        [](auto& m) { m.mutable_sources()->set_bz(0, std::nan("")); },
        [](auto& m) { m.mutable_isolines()->add_x(1); },
        [](auto& m) { m.mutable_isolines()->set_start(1, 9); },
        [](auto& m) { m.mutable_isolines()->set_start(1, 1); },
        [](auto& m) { m.mutable_isolines()->set_start(2, 4); },
        [](auto& m) { m.mutable_isolines()->clear_start(); },
        [](auto& m) { m.mutable_isolines()->add_closed(true); },
        [](auto& m) { m.mutable_isolines()->set_triangle(0, 2); },
        [](auto& m) { m.mutable_isolines()->set_level(0, std::nan("")); },
        [](auto& m) { m.mutable_isolines()->clear_level(); },
        [](auto& m) { m.add_face(1); },
        [](auto& m) { m.set_name("a/b"); },
        [](auto& m) { m.set_name(std::string(65, 'a')); },
        [](auto& m) { m.set_algorithm("geo fiso"); },
    };
    for (std::size_t i = 0; i < std::size(faults); ++i) {
        proto::Surface m;
        ASSERT_TRUE(m.ParseFromString(frame(good()).body));
        faults[i](m);
        try {
            sheet({stream::Tag::surface, m.SerializeAsString()});
            ADD_FAILURE() << "fault " << i;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input) << i;
            EXPECT_TRUE(std::string(e.what()).starts_with("cannot use a surface frame: ")) << e.what();
        }
    }
    EXPECT_THROW(sheet({stream::Tag::layer, frame(good()).body}), Error);
}

TEST(SurfaceMessage, FlippedBytesNeverCrash) {
    const auto raw = frame(good());
    std::mt19937 random(3);
    for (int i = 0; i < 5000; ++i) {
        auto broken = raw;
        for (int k = 0; k < 3; ++k) broken.body[random() % broken.body.size()] = static_cast<char>(random());
        try {
            sheet(broken);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input);
        }
    }
}

} // namespace
} // namespace filum::wire
