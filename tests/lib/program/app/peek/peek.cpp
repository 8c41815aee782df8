#include "app/peek/peek.hpp"

#include "../files.hpp"
#include "app/peek/text.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <cmath>

namespace filum::app::peek {
namespace {

using namespace test;
using stream::Payload;

polygon::Region region(std::uint32_t id, std::uint32_t layer, double side) {
    polygon::Region r;
    r.id = id;
    r.layer = layer;
    r.z = 0.2 * (layer + 1);
    r.height = 0.2;
    r.area = side * side;
    r.loops.add(std::vector<geom::Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}});
    return r;
}

// Two regions, the upper one on the lower.
std::vector<stream::RawFrame> column() {
    polygon::Region above = region(1, 1, 2);
    above.below = {{0, 4, 1, true}};
    above.join = Join::vertical;
    above.stroke = 1;
    above.inradius = 1;
    return {wire::frame(region(0, 0, 3)), wire::frame(above)};
}

std::string peeked(const Folder& at, const std::string& file, Options o) {
    run(o, io("peek", file, at("out")));
    return at.text("out");
}

TEST(Peek, TextIsALinePerRecordAndPerPoint) {
    const Folder at;
    const auto file = write_stream(at("s"), Payload::regions, {column()[1]});
    const std::string text = peeked(at, file, {.text = true});
    EXPECT_TRUE(tells(
        text,
        "region id 1 layer 1 z 0.4 height 0.2 area 4 parent -1 unsupported 0 stroke 1 join vertical "
        "inradius 1 walls 0 purpose part brim -1 body 0 tool 0 width 0 layers 0 skipped 0 loops 1 below 1 areas 0\n"
        "  loop points x,y 4\n    0 0\n    2 0\n    2 2\n    0 2\n"
        "  overlap below 0 area 4 inradius 1 link yes\n"))
        << text;
}

TEST(Peek, DecimalsCountInTheText) {
    const auto raw = wire::frame(region(0, 0, 2.0 / 3));
    EXPECT_TRUE(tells(text(record(raw), 2), "\n    0.67 0\n"));
    EXPECT_TRUE(tells(text(record(raw), 6), "\n    0.666667 0\n"));
}

TEST(Peek, FramesAreToldByOffsetAndKind) {
    const Folder at;
    const auto file = write_stream(at("s"), Payload::regions, column(), {{NoteCode::contour_gap_closed, 1}});
    const std::string text = peeked(at, file, {.frames = true});
    std::size_t places = 0;
    std::istringstream lines(text);
    std::uint64_t before = 0, offset = 0;
    for (std::string kind; lines >> offset >> kind; ++places) {
        EXPECT_GT(offset, before);
        EXPECT_EQ(kind, places == 0 ? "note" : "region");
        before = offset;
    }
    EXPECT_EQ(places, 3U);
}

TEST(Peek, CheckPrintsNothing) {
    const Folder at;
    EXPECT_EQ(peeked(at, write_stream(at("s"), Payload::regions, column()), {.check = true}), "");
}

TEST(Peek, SumsCountWhatLiesOnOtherThingsOnce) {
    Summary s;
    for (const auto& raw : column()) add(s, raw, record(raw));
    const stream::RawFrame note{stream::Tag::note, stream::serialise(Note{NoteCode::contour_gap_closed, 0.5, 2})};
    for (int i = 0; i < 2; ++i) add(s, note, record(note));
    EXPECT_EQ(s.areas["area"], 9 + 4); // not the overlap's
    EXPECT_EQ(s.records["overlap"], 1U);
    EXPECT_EQ(s.records["loop"], 2U);
    EXPECT_EQ(s.layers, 2);
    EXPECT_EQ(s.strokes, 2);
    EXPECT_EQ(s.points, 8U);
    EXPECT_EQ(s.named["join vertical"], 1U);
    EXPECT_EQ(s.named["join start"], 1U);
    EXPECT_EQ(s.ranges["x"].lo, 0);
    EXPECT_EQ(s.ranges["x"].hi, 3);
    EXPECT_EQ(s.ranges["z"].hi, 0.4);
    ASSERT_EQ(s.notes.size(), 1U);
    EXPECT_EQ(s.notes[0].amount, 1);
    EXPECT_EQ(s.notes[0].count, 4U);
}

TEST(Peek, ASurfaceTellsWhatFollowsFromIt) {
    surface::Sheet sheet;
    sheet.surface = surface::assemble({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}},
                                      {surface::kNone, surface::kNone, surface::kNone});
    const auto raw = wire::frame(sheet);
    const std::string out = text(record(raw), 3);
    EXPECT_TRUE(tells(out, "surface name '' algorithm '' components 1 area 6 points x,y,z 3 triangles a,b,c,ab,bc,ca 1 "
                           "isolines 0 sources 0 rims 1\n"))
        << out;
    EXPECT_TRUE(tells(out, "  rim component 0 outer yes sides 3 length 12\n")) << out;
    Summary s;
    add(s, raw, record(raw));
    EXPECT_EQ(s.areas["area"], 6);
    EXPECT_FALSE(s.ranges.contains("length"));
}

TEST(Peek, JsonEscapesWordsAndHasNoBareNan) {
    Note note{.amount = 0.1, .y = 1e-3, .stage = "a"};
    note.foreign.text = "said \"no\\\n\x01\"";
    note.foreign.unit = "mm";
    const stream::RawFrame raw{stream::Tag::note, stream::serialise(note)};
    EXPECT_EQ(json(record(raw)),
              "{\"kind\":\"note\",\"stage\":\"a\",\"what\":\"said \\\"no\\\\\\u000a\\u0001\\\"\","
              "\"amount\":0.1,\"unit\":\"mm\",\"count\":1,\"layer\":-1,\"x\":null,\"y\":0.001,\"z\":0,"
              "\"code\":\"\",\"grade\":\"look\",\"detail\":\"\",\"patch\":\"\",\"bead\":0}");
}

TEST(Peek, OfACutStreamItPrintsWhatComesBefore) {
    const Folder at;
    const auto file = write_stream(at("s"), Payload::regions, column());
    const std::string whole = at.text("s");
    const std::string cut = at.write("cut", whole.substr(0, whole.size() - 5));
    testing::internal::CaptureStdout();
    const Refusal r = refusal([&] { run({.text = true}, io("peek", cut, "-")); });
    const std::string out = testing::internal::GetCapturedStdout();
    EXPECT_EQ(r.exit, 4);
    EXPECT_TRUE(tells(out, "region id 0 ") && tells(out, "region id 1 "));
    // a named file appears only when all is well
    EXPECT_EQ(refusal([&] { run({.text = true}, io("peek", cut, at("out"))); }).exit, 4);
    EXPECT_FALSE(at.has("out"));
}

TEST(Peek, ShowsOneThingAtOnce) {
    const Folder at;
    const auto file = write_stream(at("s"), Payload::regions, column());
    EXPECT_EQ(refusal([&] { peeked(at, file, {.check = true, .json = true}); }).exit, 2);
}

TEST(Script, QuotesAndJoinsWhatWasJoined) {
    stream::Header h;
    h.history = {
        {"slice", "1", {{"layer-height", "0.5", true}, {"unit", "mm", false}, {"input_crc32c", "1", true}}, {}},
        {"regions", "1", {{"set", "a='b c'", true}}, {0}},
        {"slice", "1", {}, {}},
        {"assemble", "1", {{"lift", "5", false}}, {1, 2}}};
    EXPECT_EQ(script(h, false), "#!/bin/bash\nset -euo pipefail\n"
                                "assemble <(slice --layer-height=0.5 \"$1\" |\n    regions '--set=a='\\''b c'\\''')"
                                " <(slice \"$1\")\n");
    const std::string all = script(h, true);
    EXPECT_TRUE(tells(all, "--unit=mm") && tells(all, "--lift=5") && !tells(all, "crc32c")) << all;
    EXPECT_TRUE(tells(script({}, false), "no history"));
}

} // namespace
} // namespace filum::app::peek
