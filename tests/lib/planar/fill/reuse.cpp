#include "fill/reuse.hpp"

#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::fill {

namespace {

using namespace test;

polygon::Region stroke_region(Loops loops, std::uint32_t layer) {
    polygon::Region r;
    r.id = 7 * layer;
    r.layer = layer;
    r.z = 0.2 * (layer + 1);
    r.height = 0.2;
    r.stroke = layer / 2;
    r.join = layer % 2 == 0 ? Join::start : Join::vertical;
    r.area = polygon::signed_area(loops);
    r.loops = std::move(loops);
    return r;
}

void expect_same(const toolpath::RegionPaths& a, const toolpath::RegionPaths& b) {
    EXPECT_EQ(a.region, b.region);
    EXPECT_EQ(a.layer, b.layer);
    EXPECT_EQ(a.z, b.z);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.area, b.area);
    EXPECT_EQ(a.stroke, b.stroke);
    EXPECT_EQ(a.join, b.join);
    EXPECT_EQ(a.unplaced, b.unplaced);
    EXPECT_EQ(a.stacked, b.stacked);
    ASSERT_EQ(a.curves.size(), b.curves.size());
    for (std::size_t i = 0; i < a.curves.size(); ++i) {
        EXPECT_EQ(a.curves[i].points, b.curves[i].points);
        EXPECT_EQ(a.curves[i].width, b.curves[i].width);
    }
}

// Two columns of upright walls, and one whose outline changes by the last bit.
std::vector<polygon::Region> column() {
    std::vector<polygon::Region> out;
    for (std::uint32_t layer = 0; layer < 6; ++layer) {
        out.push_back(stroke_region(rectangle(0, 0, 6, 0.5), layer)); // thin: with notes
        out.push_back(stroke_region(disc({9, 9}, 3), layer));
        out.push_back(stroke_region(rectangle(20, 0, layer % 2 == 0 ? 24 : std::nextafter(24.0, 25.0), 3), layer));
    }
    return out;
}

void expect_as(Reuse& reuse, const Reuse::Work& work) {
    for (const auto& r : column()) {
        Notes expected, notes;
        const auto plain = work(r, expected);
        expect_same(reuse(r, notes), plain);
        ASSERT_EQ(notes.size(), expected.size());
        for (std::size_t i = 0; i < notes.size(); ++i) {
            EXPECT_EQ(code_name(notes[i]), code_name(expected[i]));
            EXPECT_EQ(notes[i].layer, expected[i].layer);
            EXPECT_EQ(notes[i].amount, expected[i].amount);
        }
    }
}

TEST(Reuse, GivesWhatFillGives) {
    for (const Pattern pattern : {Pattern::spiral, Pattern::zigzag, Pattern::rectilinear})
        for (const std::size_t most : {0U, 150U, 1U << 20}) { // none held, some forgotten, all held
            Options o;
            o.pattern = pattern;
            o.min_width = 0.3;
            o.angles_deg = {0, 90};
            Reuse reuse(o, most);
            expect_as(reuse, [&](const polygon::Region& r, Notes& notes) { return fill(r, o, notes); });
        }
}

// A way to fill whose curves move on from layer to layer, and begin anew every third.
TEST(Reuse, GivesWhatAnotherWayGives) {
    const auto of_layer = [](std::uint32_t layer) { return 0.1 * (layer % 3); };
    const auto lay = [&](const polygon::Region& r, Notes& notes) {
        toolpath::Curve curve{true, {}, {0.4}};
        for (const auto p : r.loops[0]) curve.points.push_back({p.x + of_layer(r.layer), p.y});
        notes.push_back({NoteCode::wall_doubled, of_layer(r.layer)});
        return std::vector{curve};
    };
    const auto work = [&](const polygon::Region& r, Notes& notes) { return fill_by(lay, r, notes); };
    for (const std::size_t most : {0U, 30U, 1U << 20}) {
        Reuse reuse(work, of_layer, most);
        expect_as(reuse, work);
    }
}

TEST(Reuse, WorksOutEqualOutlinesOnce) {
    int worked_out = 0;
    const auto work = [&](const polygon::Region& r, Notes& notes) {
        ++worked_out;
        return fill(r, {}, notes);
    };
    Reuse reuse(work, [](std::uint32_t) { return 0.0; });
    Notes notes;
    for (std::uint32_t layer = 0; layer < 5; ++layer) (void)reuse(stroke_region(sieve(5, 1.5, 1), layer), notes);
    EXPECT_EQ(worked_out, 1);
}

// Regions with the same outline differ by their walls, by every field of their areas, and by their height if the lines
// are waves.
TEST(Reuse, TellsAreasApart) {
    int worked_out = 0;
    const auto work = [&](const polygon::Region& r, Notes& notes) {
        ++worked_out;
        return fill(r, {}, notes);
    };
    Reuse reuse(work, [](std::uint32_t) { return 0.0; });
    Notes notes;
    const auto trial = [&](auto&& change) {
        const int before = worked_out;
        for (const std::uint32_t layer : {3U, 9U}) {
            polygon::Region r = stroke_region(rectangle(0, 0, 9, 9), layer);
            r.walls = 2;
            r.areas.push_back({.loops = rectangle(2, 2, 6, 6), .direction = 0.5, .spacing = 3});
            change(r, r.areas[0]);
            (void)reuse(r, notes);
        }
        return worked_out - before;
    };
    using polygon::Area;
    using polygon::Region;
    EXPECT_EQ(trial([](Region&, Area&) {}), 1); // the layer and the height have no influence
    EXPECT_EQ(trial([](Region&, Area&) {}), 0);
    EXPECT_EQ(trial([](Region& r, Area&) { r.walls = 3; }), 1);
    EXPECT_EQ(trial([](Region& r, Area&) { r.is = polygon::RegionClass::support; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.kind = polygon::AreaKind::bridge; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.direction = 1; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.spacing = 2; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.gap = 2; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.walls = 1; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.width = 1; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.loops = rectangle(2, 2, 6, 7); }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.pattern = polygon::InfillPattern::concentric; }), 1);
    EXPECT_EQ(trial([](Region&, Area& a) { a.pattern = polygon::InfillPattern::wave; }),
              2); // waves shift with the height
}

} // namespace
} // namespace filum::fill
