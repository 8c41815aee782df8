// Programs as slicers write them, line by line: what each code means, and what becomes of it in a toolpath.
#include "base/error.hpp"
#include "ingest/arc.hpp"
#include "read.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

using namespace filum;
using ingested::kUnit;
using ingested::read;
using toolpath::Feature;
using toolpath::Retraction;
using toolpath::Role;

TEST(Ingest, AbsoluteAndRelativeExtrusionAreTheSame) {
    const auto absolute = read("M82\nG92 E0\nG1 Z0.2\nG1 X10 E1\nG1 X10 Y10 E2\nG92 E0\nG1 X0 E1\n");
    const auto relative = read("M83\nG1 Z0.2\nG1 X10 E1\nG1 X10 Y10 E1\nG1 X0 E1\n");
    const auto places = read("G91\nM83\nG1 Z0.2\nG1 X10 E1\nG1 Y10 E1\nG1 X-10 E1\n");
    for (const auto& r : {absolute, relative, places}) {
        EXPECT_NEAR(ingested::volume(r.spans), 3 * kUnit, 1e-9);
        EXPECT_NEAR(ingested::length(r.spans), 30, 1e-9);
        EXPECT_EQ(r.found.counts.strokes, 1u);
        EXPECT_EQ(r.found.counts.stops, 0u);
    }
}

// Until a code of the extruder's own says otherwise G91 counts for it, too, as Marlin takes it.
TEST(Ingest, PlacesRelativeMeanTheExtruderUntilItIsTold) {
    EXPECT_NEAR(ingested::volume(read("G1 Z0.2\nG91\nG1 X5 E1\nG1 X5 E1\n").spans), 2 * kUnit, 1e-9);
    EXPECT_NEAR(ingested::volume(read("M82\nG1 Z0.2\nG91\nG1 X5 E1\nG1 X5 E1\n").spans), kUnit, 1e-9);
    EXPECT_NEAR(ingested::volume(read("M83\nG90\nG1 Z0.2\nG1 X5 E1\nG1 X9 E1\n").spans), 2 * kUnit, 1e-9);
}

// Start codes such as Z0.3[first_layer_height] write numbers with two points: Marlin reads them up to the second one.
// In the part itself they are refused.
TEST(Ingest, NumbersWithTwoPointsCountInPurgeLinesOnly) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 60; ++trial) {
        const std::string x = std::to_string(1 + random() % 90) + "." + std::to_string(random() % 90);
        const std::string cut = x + "." + std::to_string(random() % 50) + (random() % 2 == 0 ? ".7" : "");
        const auto program = [](const std::string& start, const std::string& part, const char* flavour) {
            return std::string("; gcode_flavor = ") + flavour + "\nM83\nG1 Z0.2\nG1 X" + start +
                   " Y3 E1 F900\n;LAYER_CHANGE\nG1 X" + part + " Y9 E2\n";
        };
        const auto whole = read(program(x, "99", "marlin")), two = read(program(cut, "99", "marlin"));
        EXPECT_EQ(ingested::length(two.spans), ingested::length(whole.spans)) << cut;
        EXPECT_EQ(two.found.notes.size(), whole.found.notes.size());
        EXPECT_THROW(read(program(cut, "99", "klipper")), Error);
        EXPECT_THROW(read(program(x, cut, "marlin")), Error);
    }
}

TEST(Ingest, InchesAreMillimetres) {
    const auto r = read("G20\nM83\nG1 Z0.01\nG1 X1 E0.1\n");
    EXPECT_NEAR(ingested::length(r.spans), 25.4, 1e-9);
    EXPECT_NEAR(ingested::volume(r.spans), 2.54 * kUnit, 1e-9);
}

TEST(Ingest, StrokesStopsAndTravels) {
    const std::string head = "M83\nG1 Z0.2\nG1 X10 E1\n";
    const auto count = [&](const std::string& gap) { return read(head + gap + "G1 X50 Y50 E1\n").found.counts; };
    const auto none = count("");
    EXPECT_EQ(none.strokes, 1u);
    const auto hop = count("G0 X10.3\n"); // a stop, but the stroke goes on
    EXPECT_EQ(hop.strokes, 1u);
    EXPECT_EQ(hop.stops, 1u);
    EXPECT_EQ(hop.travels, 0u);
    const auto crumb = count("G0 X10.04\n");
    EXPECT_EQ(crumb.stops, 0u);
    const auto travel = count("G0 X12\n");
    EXPECT_EQ(travel.strokes, 2u);
    EXPECT_EQ(travel.travels, 1u);
    const auto there_and_back = count("G0 X12\nG0 X10\n"); // travelled, and still the same stroke
    EXPECT_EQ(there_and_back.strokes, 1u);
    EXPECT_EQ(there_and_back.travels, 1u);
    const auto pulled = count("G1 E-1\nG1 E1\n");
    EXPECT_EQ(pulled.strokes, 2u);
    EXPECT_EQ(pulled.stops, 1u);
    EXPECT_EQ(pulled.retractions, 1u);
    const auto wiped = count("G1 X9 E-0.5\nG1 X8 E-0.5\nG0 X10\nG1 E1\n"); // one retraction in two moves
    EXPECT_EQ(wiped.retractions, 1u);
    const auto firmware = count("G10\nG0 X20\nG11\n");
    EXPECT_EQ(firmware.retractions, 1u);
    EXPECT_EQ(count("G10 P0 S200\n").retractions, 0u); // a temperature
    const auto up = count("G0 Z0.4\n");
    EXPECT_EQ(up.strokes, 1u);
    EXPECT_EQ(up.stops, 0u);
    EXPECT_EQ(count("G0 Z2\n").strokes, 2u);
}

TEST(Ingest, TravelsTellWhetherMaterialIsTakenBack) {
    const auto r =
        read("M83\nG1 Z0.2\nG1 X10 E1\nG0 X20\nG1 X30 E1\nG1 E-1\nG0 X40\nG1 E1\nG1 X50 E1\nG0 Z0.4\nG1 X60 E1\n");
    ASSERT_EQ(r.spans.size(), 7u);
    EXPECT_EQ(r.spans[1].role, Role::travel);
    EXPECT_EQ(r.spans[1].retraction, Retraction::none);
    EXPECT_EQ(r.spans[3].retraction, Retraction::taken);
    EXPECT_EQ(r.spans[5].role, Role::lift); // straight up, nothing taken back: the bead goes on
    EXPECT_EQ(r.spans[6].stroke, r.spans[4].stroke);
    for (std::size_t i = 1; i < r.spans.size(); ++i)
        EXPECT_EQ(r.spans[i].points.front(), r.spans[i - 1].points.back()) << i;
}

TEST(Ingest, HeightsComeFromCommentsElseFromLevels) {
    const auto said = read(";HEIGHT:0.3\nM83\nG1 Z0.5\nG1 X10 E1\n");
    EXPECT_DOUBLE_EQ(said.spans[0].height[0], 0.3);
    EXPECT_NEAR(said.spans[0].width[0], kUnit / 10 / 0.3, 1e-9);
    // two towers, one after the other: each level lies on the one below it
    const auto seen = read("M83\nG1 Z0.3\nG1 X10 E1\nG1 Z0.5\nG1 X0 E1\nG0 X50 Z0.3\nG1 X60 E1\nG1 Z0.5\nG1 X50 E1\n");
    std::vector<double> heights;
    std::vector<std::uint32_t> layers;
    for (const auto& s : seen.spans)
        if (s.role == Role::bead) {
            heights.push_back(s.height[0]);
            layers.push_back(s.layer);
        }
    ASSERT_EQ(heights.size(), 4u);
    for (const std::size_t i : {0U, 2U}) EXPECT_NEAR(heights[i], 0.3, 1e-9);
    for (const std::size_t i : {1U, 3U}) EXPECT_NEAR(heights[i], 0.2, 1e-9);
    EXPECT_EQ(layers, (std::vector<std::uint32_t>{0, 1, 0, 1}));
}

// A wall that climbs all the way round: it keeps the height of the layers before, and counts a layer each time round.
TEST(Ingest, SpiralsKeepTheirHeight) {
    std::string text = "M83\nG1 Z0.2\nG1 X10 E0.5\nG1 Y10 E0.5\nG1 X0 E0.5\nG1 Y0 E0.5\n";
    double z = 0.2;
    for (int turn = 0; turn < 5; ++turn)
        for (const char* to : {"X10", "Y10", "X0", "Y0"})
            text += "G1 " + std::string(to) + " Z" + std::to_string(z += 0.05) + " E0.5\n";
    const auto r = read(text);
    for (const auto& s : r.spans) EXPECT_NEAR(s.height[0], 0.2, 1e-6);
    EXPECT_EQ(r.spans.back().layer, 5u);
    EXPECT_EQ(r.found.counts.strokes, 1u);
}

TEST(Ingest, FeaturesOfThreeSlicers) {
    const std::string line = "G1 X10 E1\nG1 X0 E1\n";
    const auto feature = [&](const std::string& comment) {
        return read("M83\nG1 Z0.2\n" + comment + "\n" + line).spans.front().feature;
    };
    EXPECT_EQ(feature(";TYPE:External perimeter"), Feature::outer_wall);
    EXPECT_EQ(feature(";TYPE:Skirt/Brim"), Feature::skirt);
    EXPECT_EQ(feature(";TYPE:WALL-OUTER"), Feature::outer_wall);
    EXPECT_EQ(feature(";TYPE:SUPPORT-INTERFACE"), Feature::interface);
    EXPECT_EQ(feature("; FEATURE: Sparse infill"), Feature::infill);
    EXPECT_EQ(feature(";TYPE:Inner wall"), Feature::wall);
    EXPECT_EQ(feature(";TYPE:Something new"), Feature::none);
    EXPECT_EQ(feature("(TYPE:Bridge infill)"), Feature::bridge);
}

TEST(Ingest, LayersByMarks) {
    const auto cura = read("M83\nG1 Z0.3\nG1 X5 Y99 E9\n;LAYER:-1\nG1 X0 E1\n;LAYER:0\nG1 Z0.5\nG1 X10 E1\n");
    EXPECT_EQ(cura.spans.front().layer, 0u);
    EXPECT_EQ(cura.spans.back().layer, 1u);
    ASSERT_EQ(cura.found.notes.size(), 1u); // the purge line
    EXPECT_EQ(cura.found.notes[0].count, 1u);
    EXPECT_NEAR(ingested::volume(cura.spans), 2 * kUnit, 1e-9);
    ingest::Options all;
    all.start_code = true;
    EXPECT_NEAR(ingested::volume(read("M83\nG1 Z0.3\nG1 X5 E9\n;LAYER:0\nG1 X0 E1\n", all).spans), 10 * kUnit, 1e-9);
    const auto prusa = read(";LAYER_CHANGE\nM83\nG1 Z0.2\nG1 X9 E1\n;LAYER_CHANGE\nG1 Z0.4\nG1 X0 E1\n");
    EXPECT_EQ(prusa.spans.front().layer, 0u);
    EXPECT_EQ(prusa.spans.back().layer, 1u);
}

// The extruder of these flavours is A if no move has the word E: Slic3r writes E for some of them.
TEST(Ingest, TheExtruderIsTheAxisThatMoves) {
    for (const std::string flavour : {";FLAVOR:Mach3\n", "; gcode_flavor = mach3\n", "; gcode_flavor = machinekit\n",
                                      "; gcode_flavor = makerware\n", "; gcode_flavor = sailfish\n"})
        for (const std::string axis : {"A", "E"}) {
            SCOPED_TRACE(flavour + axis);
            const std::string moves = "M82\nG92 " + axis + "0\nG1 Z0.2\nG1 X10 " + axis + "1\nG1 X20 " + axis + "2\n";
            EXPECT_NEAR(ingested::volume(read(moves + flavour).spans), 2 * ingested::kUnit, 1e-9);
            EXPECT_NEAR(ingested::volume(read(flavour + moves).spans), 2 * ingested::kUnit, 1e-9);
        }
    EXPECT_THROW(read("M82\nG1 Z0.2\nG1 X10 A1\n"), Error);
}

TEST(Ingest, VolumesOfTheExtruderAreTakenAsTheSlicerSays) {
    const std::string moves = "M83\nG1 Z0.2\nG1 X10 E1\n; filament_diameter = 2.85\n";
    EXPECT_NEAR(ingested::volume(read(moves + "; use_volumetric_e = 1\n").spans), 1, 1e-9);
    EXPECT_NEAR(ingested::volume(read(moves + "; use_volumetric_e = 0\n").spans), 6.3794, 1e-3);
}

TEST(Ingest, FilamentByCommentOptionAndVolume) {
    const std::string line = "M83\nG1 Z0.2\nG1 X10 E1\n";
    EXPECT_NEAR(ingested::volume(read(line + "; filament_diameter = 2.85\n").spans), 6.3794, 1e-3);
    ingest::Options thick;
    thick.filament = 3;
    EXPECT_NEAR(ingested::volume(read(line + "; filament_diameter = 2.85\n", thick).spans), 7.0686, 1e-3);
    EXPECT_NEAR(ingested::volume(read(";FLAVOR:UltiGCode\n" + line).spans), 1, 1e-9);
    EXPECT_NEAR(ingested::volume(read("M200 D1.75\n" + line).spans), 1, 1e-9);
    EXPECT_NEAR(ingested::volume(read("M200 D0\n" + line).spans), kUnit, 1e-9);
    const auto two = read("M83\nG1 Z0.2\nT1\nG1 X10 E1\nT0\nG1 X0 E1\n; filament_diameter = 1.75,2.85\n");
    EXPECT_NEAR(ingested::volume(two.spans), 6.3794 + kUnit, 1e-3);
    EXPECT_EQ(two.spans.front().tool, 1u);
    EXPECT_EQ(two.spans.back().tool, 0u);
}

TEST(Ingest, ArcsByCentreAndRadius) {
    constexpr double pi = std::numbers::pi;
    const auto length = [](const std::string& arc) {
        return ingested::length(read("M83\nG1 Z0.2\nG0 X10\n" + arc + "\n").spans);
    };
    EXPECT_NEAR(length("G3 X-10 Y0 I-10 J0 E1"), 10 * pi, 0.01);
    EXPECT_NEAR(length("G3 X0 Y10 I-10 E1"), 5 * pi, 0.01);
    EXPECT_NEAR(length("G2 X0 Y10 I-10 E1"), 15 * pi, 0.02);
    EXPECT_NEAR(length("G3 X10 Y0 I-10 E1"), 20 * pi, 0.02);        // all round
    EXPECT_NEAR(length("G3 X0 Y10 R10 E1"), 5 * pi, 0.01);          // the short way
    EXPECT_NEAR(length("G3 X0 Y10 R-10 E1"), 15 * pi, 0.02);        // the long one
    EXPECT_NEAR(length("G3 X0 Y10 I-10 P2 E1"), 25 * pi, 0.04);     // and once more round
    EXPECT_NEAR(length("G90.1\nG3 X0 Y10 I0 J0 E1"), 5 * pi, 0.01); // the centre itself
    EXPECT_NEAR(length("G1 X9 E1\nG1 X10 E1\nG3 X0 Y10 Z5.2 I-10 E1"), 2 + std::hypot(5 * pi, 5), 0.01);
    EXPECT_THROW(length("G3 X0 Y10 E1"), Error);
}

// The lines of an arc stay within the tolerance of it, whichever way it turns.
TEST(Ingest, ArcsKeepTheTolerance) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int k = 0; k < 200; ++k) {
        const geom::Vec2 centre{50 * any(random), 50 * any(random)};
        const double radius = 0.05 + 30 * std::abs(any(random)), a = 7 * any(random), b = 7 * any(random);
        const auto on = [&](double angle) {
            return geom::Vec3{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), 1};
        };
        ingest::ArcWords words;
        words.i = centre.x - on(a).x;
        words.j = centre.y - on(a).y;
        words.clockwise = k % 2 == 0;
        geom::Vec3 before = on(a);
        for (const auto& p : ingest::arc_points(on(a), on(b), words, 0.002)) {
            EXPECT_NEAR(distance(p.xy(), centre), radius, 1e-9);
            const geom::Vec2 middle = 0.5 * (before.xy() + p.xy());
            EXPECT_GE(distance(middle, centre), radius - 0.00201);
            before = p;
        }
        EXPECT_LT(distance(before, on(b)), 1e-9);
    }
}

// Volumes of single moves are known to the decimals of the program only: neighbours share a width, and no volume is
// lost.
TEST(Ingest, WidthsAreSharedAndVolumesKept) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> step(0.2, 2);
    std::string text = "M83\n;HEIGHT:0.2\nG1 Z0.2\n";
    double x = 0, sum = 0, laid = 0, written = 0;
    for (int k = 0; k < 500; ++k) {
        const double way = std::round(1000 * step(random)) / 1000, width = k < 250 ? 0.4 : 0.5;
        x += way;
        sum += way * width * 0.2 / kUnit;
        const double e = std::round(1e5 * (sum - laid)) / 1e5;
        laid += e;
        written += e * kUnit;
        char line[80];
        std::snprintf(line, sizeof line, "G1 X%.3f E%.5f\n", x, e);
        text += line;
    }
    const auto r = read(text);
    EXPECT_NEAR(ingested::volume(r.spans), written, 1e-6);
    EXPECT_LE(r.spans.size(), 12u); // two, and a few where rounding piles up
    EXPECT_NEAR(r.spans.front().width[0], 0.4, 1e-4);
    EXPECT_NEAR(r.spans.back().width[0], 0.5, 1e-4);
}

TEST(Ingest, LinesThatAreNoMovesAreCounted) {
    const auto r =
        read("START_PRINT BED=60\nM117 Printing X5 Y5\nN12 G1 Z0.2*71\nM83\nG1 X10 E1 ; right\n(a G1 X99 E9)\n%\n"
             "ACTIVATE_EXTRUDER EXTRUDER=extruder1\nG1 X20 E1\n");
    EXPECT_NEAR(ingested::length(r.spans), 20, 1e-9);
    EXPECT_EQ(r.spans.back().tool, 1u);
}
