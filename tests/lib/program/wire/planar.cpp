// What the messages promise, and that every broken promise is noticed.
#include "wire/planar.hpp"
#include "base/error.hpp"

#include <filum/stream.pb.h> // a fault needs a message to be put into

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

namespace filum::wire {
namespace {

using stream::RawFrame;
using stream::Tag;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

polygon::Loops square(double size) {
    polygon::Loops out;
    const geom::Vec2 corners[] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    out.add(corners);
    return out;
}

polygon::Layer good_layer() { return {3, 0.6, 0.2, 0.5, square(10)}; }

polygon::Region good_region() {
    polygon::Region r;
    r.id = 4;
    r.layer = 3;
    r.z = 0.6;
    r.height = 0.2;
    r.area = 100;
    r.parent = -1;
    r.stroke = 2;
    r.join = Join::beside;
    r.loops = square(10);
    r.below = {{1, 50, 2}, {2, 25, 0}};
    r.areas = {{polygon::AreaKind::sparse, square(5), 0.5, 3, polygon::InfillPattern::wave, 1.5},
               {polygon::AreaKind::skin_top, square(2), 0, 0, {}},
               {polygon::AreaKind::zone, square(3), 0, 0, {}, 0, 2, 0.6}};
    r.walls = 2;
    return r;
}

toolpath::RegionPaths good_paths() {
    toolpath::RegionPaths p;
    p.region = 4;
    p.layer = 3;
    p.z = 0.6;
    p.height = 0.2;
    p.area = 100;
    p.join = Join::vertical;
    p.unplaced = 0.5;
    p.curves = {{true, {{0, 0}, {1, 0}, {1, 1}}, {0.4}}, {false, {{0, 0}, {1, 0}}, {0.4, 0.5}}};
    p.curves[0].feature = {toolpath::Feature::wall, toolpath::Feature::infill, toolpath::Feature::top};
    p.curves[0].over_air = {35, 0, 100};
    p.curves[1].feature = {toolpath::Feature::solid};
    p.stacked = {{{0, 0}, {1, 0}}};
    return p;
}

toolpath::Span good_span() {
    return {toolpath::Role::jog,
            1,
            3,
            4,
            {{0, 0, 0.2}, {1, 0, 0.3}, {1, 1, 0.4}},
            {0.4, 0.4, 0.5},
            {0.2},
            {{0, 0, 1}, {0, 0.6, 0.8}, {1, 0, 0}},
            5,
            toolpath::Retraction::by_machine,
            toolpath::Feature::bridge};
}

TEST(Planar, EverythingComesOutAsItWentIn) {
    const auto l = layer(frame(good_layer()));
    EXPECT_EQ(l.index, 3U);
    EXPECT_EQ(l.plane, 0.5);
    EXPECT_EQ(l.contours.points, good_layer().contours.points);
    EXPECT_EQ(l.contours.start, good_layer().contours.start);
    const auto r = region(frame(good_region()));
    EXPECT_EQ(r.id, 4U);
    EXPECT_EQ(r.parent, -1);
    EXPECT_EQ(r.join, Join::beside);
    ASSERT_EQ(r.below.size(), 2U);
    EXPECT_EQ(r.below[1].area, 25);
    ASSERT_EQ(r.areas.size(), 3U);
    EXPECT_EQ(r.areas[0].kind, polygon::AreaKind::sparse);
    EXPECT_EQ(r.areas[0].loops.points, square(5).points);
    EXPECT_EQ(r.areas[0].direction, 0.5);
    EXPECT_EQ(r.areas[0].spacing, 3);
    EXPECT_EQ(r.areas[0].pattern, polygon::InfillPattern::wave);
    EXPECT_EQ(r.areas[1].kind, polygon::AreaKind::skin_top);
    EXPECT_EQ(r.areas[2].kind, polygon::AreaKind::zone);
    EXPECT_EQ(r.areas[2].walls, 2U);
    EXPECT_EQ(r.areas[2].width, 0.6);
    EXPECT_EQ(r.walls, 2U);
    const auto p = paths(frame(good_paths()));
    ASSERT_EQ(p.curves.size(), 2U);
    EXPECT_TRUE(p.curves[0].closed);
    EXPECT_EQ(p.curves[1].width, (std::vector<double>{0.4, 0.5}));
    EXPECT_EQ(p.unplaced, 0.5);
    EXPECT_EQ(p.curves[0].feature, good_paths().curves[0].feature);
    EXPECT_EQ(p.curves[1].feature_at(0), toolpath::Feature::solid);
    EXPECT_EQ(p.curves[0].over_air, good_paths().curves[0].over_air);
    EXPECT_EQ(p.curves[1].over_air_at(0), 0);
    EXPECT_EQ(p.stacked, good_paths().stacked);
    const auto s = span(frame(good_span()));
    EXPECT_EQ(s.points, good_span().points);
    EXPECT_EQ(s.width, good_span().width);
    EXPECT_EQ(s.role, toolpath::Role::jog);
    EXPECT_EQ(s.normals, good_span().normals);
    EXPECT_EQ(s.tool, 5U);
    EXPECT_EQ(s.feature, toolpath::Feature::bridge);
    toolpath::Span leaning = good_span();
    leaning.over_air = 65;
    EXPECT_EQ(span(frame(leaning)).over_air, 65);
}

TEST(Planar, AnEmptyLayerIsAllowed) {
    EXPECT_TRUE(layer(frame(polygon::Layer{0, 0.2, 0.2, 0.1, {}})).contours.empty());
}

// Changes a good message in one place; the result must be refused as bad input.
template <class Message, class Domain, class Read>
void refuse(Tag tag, const Domain& good, const Read& read, const std::vector<std::function<void(Message&)>>& faults) {
    Message m;
    ASSERT_TRUE(m.ParseFromString(frame(good).body));
    for (std::size_t i = 0; i < faults.size(); ++i) {
        Message broken = m;
        faults[i](broken);
        try {
            read(RawFrame{tag, broken.SerializeAsString()});
            ADD_FAILURE() << "fault " << i << " passed";
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input) << e.what();
        }
    }
}

TEST(Planar, BrokenLayersAreRefused) {
    using M = proto::Layer;
    refuse<M>(Tag::layer, good_layer(), layer,
              {[](M& m) { m.set_height(0); }, [](M& m) { m.set_height(-1); }, [](M& m) { m.set_z(kNan); },
               [](M& m) { m.set_plane(kInf); }, [](M& m) { m.mutable_contours()->add_x(1); },
               [](M& m) { m.mutable_contours()->set_x(0, kNan); }, [](M& m) { m.mutable_contours()->set_y(1, -kInf); },
               [](M& m) { m.mutable_contours()->set_x(0, 1e9); }, [](M& m) { m.mutable_contours()->set_start(0, 1); },
               [](M& m) { m.mutable_contours()->set_start(1, 3); }, [](M& m) { m.mutable_contours()->set_start(1, 5); },
               [](M& m) { m.mutable_contours()->set_start(1, 0xffffffffU); },
               [](M& m) { // four less than the next offset, counted past the end of the numbers
                   m.mutable_contours()->set_start(1, 0xfffffffeU);
                   m.mutable_contours()->add_start(static_cast<std::uint32_t>(m.contours().x_size()));
               },
               [](M& m) { m.mutable_contours()->clear_start(); },
               [](M& m) { m.mutable_contours()->add_start(4); }, // a loop of no points
               [](M& m) {
                   m.mutable_contours()->set_start(1, 2);
                   m.mutable_contours()->add_start(4);
               }});
}

TEST(Planar, BrokenRegionsAreRefused) {
    using M = proto::Region;
    refuse<M>(Tag::region, good_region(), region,
              {[](M& m) { m.set_area(0); }, [](M& m) { m.set_area(kNan); }, [](M& m) { m.set_area(kInf); },
               [](M& m) { m.set_unsupported(-1); }, [](M& m) { m.set_unsupported(kNan); },
               [](M& m) { m.clear_loops(); }, [](M& m) { m.set_join(static_cast<proto::Join>(7)); },
               [](M& m) { m.set_join(static_cast<proto::Join>(-1)); }, [](M& m) { m.mutable_below(0)->set_area(-1); },
               [](M& m) { m.mutable_below(1)->set_inradius(kNan); }, [](M& m) { m.mutable_areas(0)->set_spacing(0); },
               [](M& m) { m.mutable_areas(1)->set_spacing(-1); }, [](M& m) { m.mutable_areas(0)->set_direction(kNan); },
               [](M& m) { m.mutable_areas(0)->set_kind(static_cast<proto::AreaKind>(9)); },
               [](M& m) { m.mutable_areas(0)->set_pattern(static_cast<proto::Pattern>(9)); },
               [](M& m) { m.mutable_areas(2)->set_width(0); }, [](M& m) { m.mutable_areas(0)->set_width(kNan); },
               [](M& m) { m.mutable_areas(0)->mutable_loops()->set_x(0, kNan); }});
}

TEST(Planar, BrokenPathsAreRefused) {
    using M = proto::RegionPaths;
    refuse<M>(Tag::paths, good_paths(), paths,
              {[](M& m) { m.set_height(kNan); },
               [](M& m) { m.set_area(-1); },
               [](M& m) { m.set_unplaced(kNan); },
               [](M& m) { m.mutable_curves(0)->clear_width(); },
               [](M& m) { m.mutable_curves(0)->add_width(0.4); },
               [](M& m) { m.mutable_curves(0)->set_width(0, 0); },
               [](M& m) { m.mutable_curves(0)->set_width(0, kNan); },
               [](M& m) { m.mutable_curves(0)->set_feature(0, static_cast<proto::Feature>(99)); },
               [](M& m) {
                   m.mutable_curves(0)->add_feature(proto::WALL);
                   m.mutable_curves(0)->add_feature(proto::WALL);
               },
               [](M& m) { m.mutable_curves(0)->set_over_air(0, 101); },
               [](M& m) { m.mutable_curves(0)->add_over_air(5); },
               [](M& m) { m.mutable_curves(1)->set_width(1, -0.1); },
               [](M& m) { m.mutable_curves(1)->add_y(0); },
               [](M& m) { m.add_curves()->add_width(0.4); },
               [](M& m) { m.add_stacked(); },
               [](M& m) { m.mutable_stacked(0)->add_y(0); },
               [](M& m) { m.mutable_stacked(0)->set_x(0, kNan); },
               [](M& m) { m.mutable_stacked(0)->set_x(0, 9e7); },
               [](M& m) { m.mutable_curves(0)->set_x(0, 9e7); },
               [](M& m) { m.mutable_curves(0)->set_y(0, -9e7); }});
}

TEST(Planar, BrokenSpansAreRefused) {
    using M = proto::Span;
    refuse<M>(Tag::span, good_span(), span,
              {[](M& m) { m.set_role(static_cast<proto::Role>(9)); }, [](M& m) { m.set_tool(1001); },
               [](M& m) { m.set_feature(static_cast<proto::Feature>(99)); }, [](M& m) { m.set_role(proto::TRAVEL); },
               [](M& m) { m.set_over_air(101); }, [](M& m) { m.clear_width(); }, [](M& m) { m.add_width(0.4); },
               [](M& m) { m.clear_z(); }, [](M& m) { m.add_z(1); }, [](M& m) { m.set_z(1, kNan); },
               [](M& m) { m.set_height(0, 0); }, [](M& m) { m.set_x(0, 9e7); },
               [](M& m) {
                   m.clear_x();
                   m.clear_y();
               },
               [](M& m) { m.set_nz(0, 0.9); }, [](M& m) { m.add_nx(1); }, [](M& m) { m.set_ny(1, kNan); },
               [](M& m) {
                   m.clear_nx();
                   m.clear_ny();
                   m.clear_nz();
                   m.add_nx(1);
               }});
}

TEST(Planar, AFrameOfAnotherKindIsRefused) {
    EXPECT_THROW(region(frame(good_layer())), Error);
    EXPECT_THROW(span(frame(good_paths())), Error);
}

// Any bytes at all: an Error or a value, never anything else.
TEST(Planar, RandomBytesAreSurvived) {
    std::mt19937 random(2);
    const std::string seeds[] = {frame(good_layer()).body, frame(good_region()).body, frame(good_paths()).body,
                                 frame(good_span()).body};
    int refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string body = seeds[i % 4];
        for (unsigned k = 0; k < 1 + random() % 4; ++k) body[random() % body.size()] = static_cast<char>(random());
        if (random() % 4 == 0) body.resize(random() % body.size());
        try {
            if (i % 4 == 0) layer({Tag::layer, body});
            if (i % 4 == 1) region({Tag::region, body});
            if (i % 4 == 2) paths({Tag::paths, body});
            if (i % 4 == 3) span({Tag::span, body});
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
}

} // namespace
} // namespace filum::wire
