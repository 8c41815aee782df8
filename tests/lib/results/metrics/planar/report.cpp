#include "metrics/planar/report.hpp"

#include "toolpaths.hpp"

#include <algorithm>

namespace filum::metrics::planar {

namespace {

using figures::Format;

const figures::Figure* find(const Figures& figures, const std::string& name) {
    for (const figures::Figure& f : figures)
        if (f.name == name) return &f;
    return nullptr;
}

std::uint64_t count(const Figures& f, const std::string& name) {
    const figures::Figure* one = find(f, name);
    return one == nullptr ? 999999 : std::get<std::uint64_t>(one->value);
}

double number(const Figures& f, const std::string& name) {
    const figures::Figure* one = find(f, name);
    return one == nullptr ? NAN : std::get<double>(one->value);
}

// A square of 8 x 4 mm on two layers: the first filled by lines, the second half empty and crossed.
struct Job {
    std::vector<polygon::Region> regions{region(0, 0, box(0, 0, 8, 4)), region(1, 1, box(0, 0, 8, 4))};
    Beads beads;
    Input input;
    Job() {
        beads.marks = layer_marks(regions);
        auto all = lines(8, 4, 0.4, 0.4, 0.2, 0);
        for (auto& s : lines(8, 2, 0.4, 0.4, 0.4, 1)) {
            s.region = 1;
            all.push_back(s);
        }
        all.push_back(bead({{4, -1, 0.4}, {4, 1, 0.4}}, 0.4, 0.2, 1, 1));
        for (const auto& s : all) {
            add(beads, s);
            follow(input.statistics, s);
        }
    }
    [[nodiscard]] Figures figures(int threads = 1) const {
        return report(input, beads, regions, measure_layers(beads, regions, 0, threads), Options{}, threads);
    }
};

TEST(Report, OfAKnownJob) {
    const Figures f = Job{}.figures();
    EXPECT_EQ(count(f, "strokes"), 16);
    EXPECT_EQ(count(f, "stops"), 15);
    EXPECT_EQ(count(f, "crossings"), 2); // with the lines at 0.2 and 0.6
    EXPECT_EQ(count(f, "regions"), 2);
    EXPECT_EQ(count(f, "with exactly one curve"), 0);
    EXPECT_EQ(count(f, "worst layer"), 1);
    EXPECT_NEAR(number(f, "coverage of the worst layer"), 0.5, 1e-6);
    EXPECT_NEAR(number(f, "coverage"), 0.75, 1e-6);
    EXPECT_NEAR(number(f, "unplaced"), 16, 1e-4);
    EXPECT_NEAR(number(f, "coverage of the worst region"), 0.5, 1e-6);
    EXPECT_NEAR(number(f, "volume"), (15 * 8 + 2) * 0.08, 1e-9);
    EXPECT_NEAR(number(f, "extruded"), 122, 1e-9);
}

TEST(Report, IsTheSameForAnyThreads) {
    const Job job;
    EXPECT_EQ(text(job.figures(1), Format::json), text(job.figures(2), Format::json));
    EXPECT_EQ(region_table(measure_layers(job.beads, job.regions, 0, 1)),
              region_table(measure_layers(job.beads, job.regions, 0, 8)));
}

TEST(Report, OfNothingHasNoNumbersThatAreNone) {
    const Figures f = report({}, {}, {}, {}, Options{}, 1);
    const std::string json = text(f, Format::json);
    EXPECT_EQ(json.find("nan"), std::string::npos);
    EXPECT_EQ(json.find("inf"), std::string::npos);
    EXPECT_EQ(count(f, "strokes"), 0);
}

TEST(Report, RepeatsWhatStagesSaid) {
    Job job;
    job.input.notes = {{.code = NoteCode::contour_gap_closed, .amount = 0.5, .count = 2, .stage = "slice"},
                       {.code = NoteCode::contour_gap_closed, .amount = 0.25, .count = 1, .stage = "slice"},
                       {.code = NoteCode::ring_unjoined, .amount = 3, .count = 3, .stage = "fill"}};
    job.input.facts = {{"sequence", "lower-bound", 3, "strokes"}};
    const Figures f = job.figures();
    EXPECT_EQ(number(f, "sequence: lower-bound"), 3);
    const auto by_key = [&](const std::string& key) {
        const auto at = std::find_if(f.begin(), f.end(), [&](const auto& figure) { return figure.key == key; });
        return at == f.end() ? nullptr : &*at;
    };
    ASSERT_NE(by_key("noted.slice.contour_gap_closed.cases"), nullptr);
    EXPECT_EQ(std::get<std::uint64_t>(by_key("noted.slice.contour_gap_closed.cases")->value), 3U);
    ASSERT_NE(by_key("noted.slice.contour_gap_closed.mm"), nullptr);
    EXPECT_EQ(std::get<double>(by_key("noted.slice.contour_gap_closed.mm")->value), 0.75);
    EXPECT_EQ(std::get<std::string>(by_key("noted.slice.contour_gap_closed.grade")->value), "harmless");
    ASSERT_NE(by_key("noted.fill.ring_unjoined.cases"), nullptr);
    EXPECT_EQ(std::get<std::uint64_t>(by_key("noted.fill.ring_unjoined.cases")->value), 3U);
    EXPECT_EQ(by_key("noted.fill.ring_unjoined."), nullptr); // without a unit there is no amount
}

TEST(Report, HoldsFarFromTheOrigin) {
    Job here, there;
    there.beads = {};
    const Vec2 far{1e7, -1e7};
    for (auto& r : there.regions)
        for (Vec2& p : r.loops.points) p = p + far;
    there.beads.marks = layer_marks(there.regions);
    for (const auto& [index, layer] : here.beads.layer) {
        auto moved = layer;
        for (Vec2& p : moved.points) p = p + far;
        there.beads.layer[index] = moved;
    }
    const auto a = here.figures(), b = there.figures();
    EXPECT_NEAR(number(a, "coverage"), number(b, "coverage"), 1e-6);
    EXPECT_EQ(count(a, "crossings"), count(b, "crossings"));
}

} // namespace

} // namespace filum::metrics::planar
