#include "app/collide/collide.hpp"

#include "../worlds.hpp"

#include <sstream>

namespace filum::app::collide {
namespace {

using namespace test;
using stream::Payload;

std::string strokes(const Folder& at) {
    return write_stream(at("strokes"), Payload::toolpath, frames(two_strokes()), {{NoteCode::wall_doubled, 1}});
}

TEST(Collide, PassesOnUnchangedWhatMeetsNothing) {
    const Folder at;
    Options o;
    o.bed = true;
    run(o, io("collide", strokes(at), at("out")));
    const Stream before = read_stream(at("strokes"), Payload::toolpath),
                 after = read_stream(at("out"), Payload::toolpath);
    ASSERT_EQ(after.frames.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(after.frames[i].body, before.frames[i].body);
    ASSERT_EQ(after.told.notes.size(), 1U);
    EXPECT_EQ(after.told.notes[0].stage, "before");
    EXPECT_EQ(find(after.told.facts, "collide", "colliding-moves")->value, 0);
}

// A post of 5 mm between the strokes: the head's flat passes at 0.2 mm, and the travel goes through it.
TEST(Collide, APartInTheWayIsAnErrorWithItsPlace) {
    const Folder at;
    Options o;
    o.part = box(at, "post.off", {19, -1, 0}, {21, 1, 5});
    o.places = at("places");
    const Refusal r = refusal([&] { run(o, io("collide", strokes(at), at("out"))); });
    EXPECT_EQ(r.exit, 1);
    EXPECT_TRUE(tells(r.what, "the part")) << r.what;
    EXPECT_FALSE(at.has("out"));
    const std::string places = at.text("places"); // listed all the same
    EXPECT_GE(std::count(places.begin(), places.end(), '\n'), 2);
}

TEST(Collide, GoesOnWithANoteIfItIsNotStrict) {
    const Folder at;
    Options o;
    o.fixture = box(at, "post.off", {19, -1, 0}, {21, 1, 5});
    o.strict = false;
    run(o, io("collide", strokes(at), at("out")));
    const Stream s = read_stream(at("out"), Payload::toolpath);
    EXPECT_EQ(s.frames.size(), 3U);
    EXPECT_GT(find(s.told.facts, "collide", "colliding-moves")->value, 0);
    bool noted = false;
    for (const Note& n : s.told.notes) noted = noted || (n.stage == "collide" && tells(code_name(n), "fixture"));
    EXPECT_TRUE(noted);
    bool known = false; // by its content, as the head by its measures
    for (const auto& setting : s.told.header.history.back().settings) known = known || setting.name == "fixture_crc32c";
    EXPECT_TRUE(known);
}

TEST(Collide, ChecksAProgramByItsLinesAlone) {
    const Folder at;
    Options o;
    o.machine = "marlin";
    o.program = at.write("p.gcode", "G90\nM83\nG0 X0 Y0 Z0.2\nG1 X10 Y0 E1\nG0 X30 Y0\n"
                                    "G1 X40 Y0 E1\nM104 S0\n");
    o.format = "tsv";
    o.strict = false;
    o.bead = {0.4, 0.2};
    const auto figure = [&](const std::string& name) {
        run(o, io("collide", "-", at("figures")));
        std::istringstream lines(at.text("figures"));
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(name + "\t")) return std::stod(line.substr(name.size() + 1));
        return -1.0;
    };
    EXPECT_EQ(figure("program_lines"), 4);
    EXPECT_EQ(figure("program_lines_other"), 3);
    EXPECT_EQ(figure("collisions"), 0);
    o.part = box(at, "post.off", {19, -1, 0}, {21, 1, 5});
    EXPECT_GT(figure("collisions"), 0);
    o.shift = {0, 0, 100}; // far above
    EXPECT_EQ(figure("collisions"), 0);
}

TEST(Collide, RefusesWhatDoesNotGoTogether) {
    const Folder at;
    const std::string input = strokes(at);
    Options no_machine, bead, empty_name, changes, two;
    no_machine.program = "p.gcode";
    bead.bead = {0.4, 0.2};
    empty_name.part = "a.stl,,b.stl";
    changes.set = "travel.lift=2";
    two.machine = "marlin";
    two.program = "p.gcode";
    for (const Options& o : {no_machine, bead, empty_name, changes, two})
        EXPECT_EQ(refusal([&] { run(o, io("collide", input, at("out"))); }).exit, 2);
    Options gone;
    gone.part = at("nowhere.stl");
    EXPECT_EQ(refusal([&] { run(gone, io("collide", input, at("out"))); }).exit, 5);
    Options robot;
    robot.machine = "kuka-krl";
    robot.program = at.write("p.src", "PTP {X 0}\n");
    EXPECT_TRUE(tells(refusal([&] { run(robot, io("collide", "-", at("out"))); }).what, "only G-code is understood"));
    EXPECT_FALSE(at.has("out"));
}

TEST(Collide, RefusesPlacesBeyondAllMachines) {
    const Folder at;
    auto far = two_strokes();
    for (auto& point : far[2].points) point.x += 2e7;
    const auto input = write_stream(at("far"), Payload::toolpath, frames(far));
    const Refusal r = refusal([&] { run({}, io("collide", input, at("out"))); });
    EXPECT_EQ(r.exit, 3);
    EXPECT_TRUE(tells(r.what, "beyond 10000 m")) << r.what;
}

} // namespace
} // namespace filum::app::collide
