// What a program says to a printer besides moves: an offset, pauses, values by layer, how far it is, which part it is
// at.
#include "sample.hpp"

#include "base/error.hpp"
#include "postproc/measure.hpp"

#include <gtest/gtest.h>

#include <sstream>

using namespace filum;
using sample::Role;
using sample::Span;

namespace {

std::vector<std::string> lines(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> out;
    for (std::string line; std::getline(in, line);) out.push_back(line);
    return out;
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

// A tower of some layers, each a stroke of its own.
std::vector<Span> tower(std::uint32_t layers, double side = 20, geom::Vec2 at = {}) {
    std::vector<Span> out;
    for (std::uint32_t k = 0; k < layers; ++k) {
        const double z = 0.2 * (k + 1);
        const geom::Vec3 a{at.x, at.y, z}, b{at.x + side, at.y, z}, c{at.x + side, at.y + side, z};
        if (!out.empty()) out.push_back({Role::travel, k, k, 0, {out.back().points.back(), a}, {}, {}});
        out.push_back({Role::bead, k, k, 0, {a, b, c}, {0.4}, {0.2}});
    }
    return out;
}

// The program as the command writes it, of a toolpath that is changed by `change`.
std::string program(const machine::Profile& p, const std::vector<Span>& spans, const std::string& pauses = "",
                    const std::string& by_layer = "", std::vector<postproc::LabelledPart> parts = {},
                    postproc::FirstPass* found = nullptr) {
    postproc::Measure measure(p, postproc::Place::as_is, {}, false, machine::parse_pauses(pauses));
    do
        for (const Span& s : spans) measure.add(s);
    while (measure.again());
    auto first = measure.end();
    first.by_layer = postproc::parse_by_layer(by_layer, p);
    first.parts = std::move(parts);
    std::string text;
    const auto writer = postproc::writer(p, first, {}, [&](std::string_view t) { text += t; });
    writer->begin({});
    const auto walk = postproc::walker(
        p, {}, [&](auto steps) { writer->add(steps); }, measure.joins());
    for (const Span& s : spans) walk->add(s);
    walk->end();
    writer->end({});
    if (found != nullptr) *found = first;
    return text;
}

machine::Profile printer(const std::string& templates = "", const std::string& format = "") {
    return machine::parse_profile("name = \"test\"\n[bed]\nx = [0, 200]\ny = [0, 200]\nz = [0, 200]\n[extrusion]\n" +
                                      std::string(sample::kFilament) + "[values]\nnozzle_temp = 210\n[format]\n" +
                                      format + "[templates]\nstart = \"M109 S{nozzle_temp}\"\n" + templates,
                                  "test.toml");
}

TEST(Printing, AnOffsetRaisesEveryHeight) {
    const auto plain = lines(program(printer(), tower(3)));
    machine::Profile high = printer();
    high.bed.z_offset = 0.15;
    const auto raised = lines(program(high, tower(3)));
    ASSERT_EQ(plain.size(), raised.size());
    std::size_t heights = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const auto at = plain[i].find(" Z"), to = raised[i].find(" Z");
        ASSERT_EQ(at == std::string::npos, to == std::string::npos);
        if (at == std::string::npos || plain[i][0] == ';') continue;
        EXPECT_NEAR(std::stod(raised[i].substr(to + 2)) - std::stod(plain[i].substr(at + 2)), 0.15, 1e-9);
        ++heights;
    }
    EXPECT_GT(heights, 5U);
    high.bed.z_offset = -0.3; // into the bed
    EXPECT_THROW(program(high, tower(3)), Error);
}

// On the way from the purge line to the first stroke the nozzle would ooze; without one, nothing stands at its tip.
TEST(Printing, TheWayFromThePurgeLineHasARetraction) {
    const auto retractions = [](const machine::Profile& p) {
        postproc::FirstPass found;
        const std::string text = program(p, tower(3), "", "", {}, &found);
        const std::size_t first = text.find("\nG1 E-"), bead = text.find(" E0."), travel = text.find("\nG0 X");
        return std::tuple(count(text, "\nG1 E-"), first < travel && travel < bead, found.seconds);
    };
    machine::Profile plain = printer();
    machine::Profile purging = plain;
    purging.templates.start += "\nG1 X{purge_x} Y{purge_y}";
    purging.templates.primed = true;
    const auto [few, late, short_time] = retractions(plain);
    const auto [more, at_once, long_time] = retractions(purging);
    EXPECT_EQ(more, few + 1);
    EXPECT_FALSE(late);
    EXPECT_TRUE(at_once);
    EXPECT_GT(long_time, short_time);
}

TEST(Printing, APauseComesBeforeItsLayer) {
    const auto p = printer("pause = \"M0\"\n");
    for (const char* at : {"3", "0.6mm", "0.5mm"}) { // layers end at 0.2, 0.4, 0.6, 0.8; half of the third is above 0.5
        postproc::FirstPass found;
        const std::string text = program(p, tower(6), at, "", {}, &found);
        EXPECT_EQ(count(text, "\nM0\n"), 1U);
        const auto pause = text.find("\nM0\n");
        EXPECT_LT(text.find(";LAYER:2"), pause);
        EXPECT_GT(text.find("G1 X20", pause), pause);
        EXPECT_LT(text.find(";LAYER:3"), pause);
        EXPECT_GT(text.find(";LAYER:4"), pause);
        EXPECT_EQ(found.waits.count, 1U);
        EXPECT_EQ(found.waits.within + found.waits.late, 0U);
    }
    postproc::FirstPass found; // two towers one after the other: the second comes late
    auto spans = tower(4);
    const auto second = tower(4, 20, {50, 0});
    spans.push_back({Role::travel, 4, 0, 0, {spans.back().points.back(), second[0].points[0]}, {}, {}});
    spans.insert(spans.end(), second.begin(), second.end());
    EXPECT_EQ(count(program(p, spans, "2", "", {}, &found), "\nM0\n"), 1U);
    EXPECT_EQ(found.waits.late, 2U);
    for (const char* bad : {"0", "-1", "2.5", "x", "0mm", "3:color", ":colour"})
        EXPECT_THROW(machine::parse_pauses(bad), Error) << bad;
}

TEST(Printing, ValuesChangeFromTheirLayerOn) {
    const auto p = printer("upper_layers = \"M104 S{nozzle_temp}\"\n");
    const std::string text = program(p, tower(8), "", "3:nozzle_temp=200,6:nozzle_temp=190");
    std::vector<std::string> told;
    for (const auto& line : lines(text))
        if (line.starts_with("M104") || line.starts_with(";LAYER:")) told.push_back(line);
    const std::vector<std::string> wanted = {";LAYER:0", ";LAYER:1", "M104 S210", ";LAYER:2",  ";LAYER:3", "M104 S200",
                                             ";LAYER:4", ";LAYER:5", ";LAYER:6",  "M104 S190", ";LAYER:7"};
    EXPECT_EQ(told, wanted);
    for (const char* bad : {"3:bed=1", "3", "x:nozzle_temp=3", "1.5:nozzle_temp=200"})
        EXPECT_THROW(postproc::parse_by_layer(bad, p), Error) << bad;
    EXPECT_THROW(postproc::parse_by_layer("3:nozzle_temp=200", printer()), Error); // no codes name it
}

TEST(Printing, ProgressClimbsToTheEnd) {
    const auto p = printer("progress = \"M73 P{percent} R{minutes_left}\"\n");
    const std::string text = program(p, tower(40, 60));
    int percent = -1, left = 1 << 20, seen = 0;
    for (const auto& line : lines(text)) {
        if (!line.starts_with("M73")) continue;
        const int now = std::stoi(line.substr(5)), minutes = std::stoi(line.substr(line.find('R') + 1));
        EXPECT_GE(now, percent);
        EXPECT_LE(now - percent, 6); // a move at most at a time
        EXPECT_LE(minutes, left);
        percent = now;
        left = minutes;
        ++seen;
    }
    EXPECT_EQ(percent, 100);
    EXPECT_EQ(left, 0);
    EXPECT_GT(seen, 30);
}

TEST(Printing, PartsAreNamed) {
    auto spans = tower(2);
    const auto second = tower(2, 20, {50, 0});
    spans.push_back({Role::travel, 2, 0, 0, {spans.back().points.back(), second[0].points[0]}, {}, {}});
    spans.insert(spans.end(), second.begin(), second.end());
    const std::vector<postproc::LabelledPart> parts{{"left", {{0, 0}, {20, 0}, {20, 20}, {0, 20}}},
                                                    {"right", {{50, 0}, {70, 0}, {70, 20}, {50, 20}}}};
    const auto klipper = lines(program(printer("", "objects = \"exclude_object\"\n"), spans, "", "", parts));
    std::vector<std::string> told;
    for (const auto& line : klipper)
        if (line.starts_with("EXCLUDE")) told.push_back(line);
    const std::vector<std::string> wanted = {
        "EXCLUDE_OBJECT_DEFINE NAME=left CENTER=10,10 POLYGON=[[0,0],[20,0],[20,20],[0,20]]",
        "EXCLUDE_OBJECT_DEFINE NAME=right CENTER=60,10 POLYGON=[[50,0],[70,0],[70,20],[50,20]]",
        "EXCLUDE_OBJECT_START NAME=left",
        "EXCLUDE_OBJECT_END NAME=left",
        "EXCLUDE_OBJECT_START NAME=right",
        "EXCLUDE_OBJECT_END NAME=right"};
    EXPECT_EQ(told, wanted);
    const std::string marlin = program(printer("", "objects = \"m486\"\n"), spans, "", "", parts);
    EXPECT_EQ(count(marlin, "\nM486 T2\n"), 1U);
    EXPECT_EQ(count(marlin, "\nM486 S0\nM486 Aleft\n"), 1U);
    EXPECT_EQ(count(marlin, "\nM486 S1\nM486 Aright\n"), 1U);
    EXPECT_EQ(count(marlin, "\nM486 S-1\n"), 2U);
}

} // namespace
