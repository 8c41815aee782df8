#include "app/route/route.hpp"

#include "../worlds.hpp"
#include "app/collide/collide.hpp"

namespace filum::app::route {
namespace {

using namespace test;
using stream::Payload;
using toolpath::Role;
using toolpath::Span;

std::string strokes(const Folder& at) { return write_stream(at("strokes"), Payload::toolpath, frames(two_strokes())); }

std::vector<Span> routed(const Folder& at, const Options& o, Stream* all = nullptr) {
    run(o, io("route", strokes(at), at("out")));
    Stream s = read_stream(at("out"), Payload::toolpath);
    std::vector<Span> out;
    for (const auto& f : s.frames) out.push_back(wire::span(f));
    if (all != nullptr) *all = std::move(s);
    return out;
}

double top(const Span& s) {
    double out = 0;
    for (const auto& p : s.points) out = std::max(out, p.z);
    return out;
}

TEST(Route, GoesStraightWhereNothingStands) {
    const Folder at;
    Options o;
    o.bed = true;
    o.lift = {1};
    Stream all;
    const auto spans = routed(at, o, &all);
    ASSERT_EQ(spans.size(), 3U);
    EXPECT_EQ(spans[1].role, Role::travel);
    EXPECT_NEAR(top(spans[1]), 1.2, 1e-9);
    EXPECT_EQ(spans[1].normals.size(), spans[1].points.size()); // to be followed as it is
    EXPECT_EQ(find(all.told.facts, "route", "travels")->value, 1);
    EXPECT_EQ(find(all.told.facts, "route", "colliding-moves")->value, 0);
}

// A wall between the strokes that is too long to be gone around.
TEST(Route, LeadsTheHeadOverAWallAndCollideAgrees) {
    const Folder at;
    Options o;
    o.part = box(at, "wall.off", {19, -80, 0}, {21, 80, 5});
    Stream all;
    const auto spans = routed(at, o, &all);
    const auto before = two_strokes();
    ASSERT_EQ(spans.size(), 3U);
    EXPECT_EQ(spans[0].points, before[0].points);
    EXPECT_EQ(spans[2].points, before[2].points);
    EXPECT_EQ(spans[1].points.front(), before[0].points.back());
    EXPECT_EQ(spans[1].points.back(), before[2].points.front());
    EXPECT_GT(top(spans[1]), 5);
    EXPECT_GT(find(all.told.facts, "route", "travel-length")->value,
              find(all.told.facts, "route", "travel-length-before")->value - 10);
    collide::Options check;
    check.part = o.part;
    EXPECT_EQ(refusal([&] { collide::run(check, io("collide", at("strokes"), at("no"))); }).exit, 1); // as it was
    collide::run(check, io("collide", at("out"), at("checked")));
    EXPECT_EQ(find(read_stream(at("checked"), Payload::toolpath).told.facts, "collide", "colliding-moves")->value, 0);
}

TEST(Route, WhatStaysInTheWayIsAnErrorOrANote) {
    const Folder at;
    Options o;
    o.part = box(at, "on.off", {4, -1, 0}, {6, 1, 3}); // on a stroke, which stays
    o.places = at("places");
    const Refusal r = refusal([&] { routed(at, o); });
    EXPECT_EQ(r.exit, 1);
    EXPECT_FALSE(at.has("out"));
    EXPECT_TRUE(at.has("places"));
    o.strict = false;
    Stream all;
    routed(at, o, &all);
    EXPECT_GT(find(all.told.facts, "route", "colliding-moves")->value, 0);
    EXPECT_FALSE(all.told.notes.empty());
}

TEST(Route, LeansTheToolWhereThatFreesItAndListsTheStrokes) {
    const Folder at;
    Options o;
    o.part = box(at, "beside.off", {-5, 3, 0}, {45, 6, 20}); // meets the carriage of an upright head
    o.tilt = 60;
    o.tilt_rate = 90;
    o.leaning = at("leaning");
    o.strict = false;
    o.head.cone_height = {15}, o.head.carriage = {8, 8}, o.head.cone_angle_deg = {10};
    Stream all;
    routed(at, o, &all);
    EXPECT_EQ(find(all.told.facts, "route", "leaning-strokes")->value, 2);
    const std::string list = at.text("leaning");
    EXPECT_TRUE(list.starts_with("stroke\tlayer\tlength\tleaning\tmost\tmean\n"));
    EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 3);
}

TEST(Route, ThreeAxesDoNotLean) {
    const Folder at;
    Options o;
    o.tilt = 20;
    o.machine = "marlin";
    const Refusal r = refusal([&] { routed(at, o); });
    EXPECT_EQ(r.exit, 2);
    EXPECT_TRUE(tells(r.what, "'marlin' has three axes")) << r.what;
}

} // namespace
} // namespace filum::app::route
