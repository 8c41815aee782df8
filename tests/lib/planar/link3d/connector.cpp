#include "stacks.hpp"

namespace filum::link3d {

using namespace test;

namespace {

// Two towers, layer by layer: one join from tower to tower in each layer, there and back in turn.
std::vector<RegionPaths> towers(std::uint32_t layers, Join other) {
    std::vector<RegionPaths> regions;
    for (std::uint32_t layer = 0; layer < layers; ++layer)
        for (std::uint32_t k = 0; k < 2; ++k) {
            const bool second = (layer + k) % 2 == 1;
            const Join join = layer + k == 0 ? Join::start : k == 0 ? Join::vertical : other;
            regions.push_back(region(2 * layer + k, layer, join, {rings({second ? 12.0 : 0.0, 0}, 2, 4)}));
        }
    return regions;
}

Options with(Connect connect) {
    Options o;
    o.connect = connect;
    return o;
}

std::size_t count(const Result& r, const std::string& what) {
    return static_cast<std::size_t>(
        std::count_if(r.notes.begin(), r.notes.end(), [&](const Note& n) { return code_name(n) == what; }));
}

} // namespace

TEST(Connectors, BreakWhereNothingElseIsAskedFor) {
    const auto regions = towers(6, Join::start);
    const auto r = link(regions);
    check(regions, r);
    EXPECT_EQ(r.counts.breaks, 6U);
    EXPECT_TRUE(r.notes.empty()) << "a break is what was asked for";
}

// Fig. 8b: around the bounding box, thin at both ends, on the same way in all layers.
TEST(Connectors, GoOutsideThePartAndStack) {
    const auto regions = towers(6, Join::start);
    const auto r = link(regions, with(Connect::outside));
    check(regions, r);
    EXPECT_EQ(r.counts.connectors, 6U);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(count(r, "connector-to-trim"), 6U);
    double volume = 0;
    Box2 part;
    part.add({-2, -2});
    part.add({14, 2});
    for (const auto& s : r.spans) {
        if (s.role != Role::connector) continue;
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i) volume += toolpath::volume(s, i);
        EXPECT_NEAR(s.width.front(), 0.4 * kWidth, 1e-9);
        EXPECT_NEAR(s.width.back(), 0.4 * kWidth, 1e-9);
        EXPECT_NEAR(*std::max_element(s.width.begin(), s.width.end()), kWidth, 1e-9);
        for (std::size_t i = 1; i + 1 < s.points.size(); ++i) {
            const Vec2 p = s.points[i].xy();
            const bool out = p.x < part.lo.x || p.x > part.hi.x || p.y < part.lo.y || p.y > part.hi.y;
            EXPECT_TRUE(out || s.width[i] < kWidth + 1e-9);
        }
    }
    EXPECT_NEAR(r.counts.connector_volume, volume, 1e-9);
    EXPECT_LT(r.counts.connector_free, 0.3 * r.counts.connector_length) << "most lies on the one below";
}

TEST(Connectors, CarriedOnesHangNowhere) {
    auto regions = towers(8, Join::start);
    Options o = with(Connect::outside);
    o.connector_support = ConnectorSupport::carried;
    const auto on_bed = link(regions, o);
    check(regions, on_bed);
    EXPECT_GE(on_bed.counts.connectors, 1U);
    EXPECT_LE(on_bed.counts.connector_free, 0.1 * on_bed.counts.connector_length);
    std::vector<RegionPaths> high; // one tower of five layers, then another from the bed: the way down is free
    for (std::uint32_t k = 0; k < 2; ++k)
        for (std::uint32_t i = 0; i < 5; ++i)
            high.push_back(region(5 * k + i, i, i == 0 ? Join::start : Join::vertical, {rings({30.0 * k, 0}, 2, 4)}));
    const auto broken = link(high, o);
    check(high, broken);
    EXPECT_EQ(broken.counts.connectors, 0U);
    EXPECT_EQ(count(broken, "connector-impossible"), 1U);
    o.connector_support = ConnectorSupport::free;
    const auto free = link(high, o);
    EXPECT_EQ(free.counts.strokes, 1U);
    EXPECT_GT(free.counts.connector_free, 20);
}

// A tall tower: the head cannot come down beside it, but far away from it.
TEST(Connectors, KeepTheHeadClear) {
    for (const double apart : {8.0, 60.0}) {
        std::vector<RegionPaths> regions;
        for (std::uint32_t i = 0; i < 60; ++i)
            regions.push_back(region(i, i, i == 0 ? Join::start : Join::vertical, {rings({0, 0}, 2, 4)}));
        regions.push_back(region(60, 0, Join::start, {rings({apart, 0}, 2, 4)}));
        Options o = with(Connect::outside);
        auto r = link(regions, o);
        EXPECT_EQ(r.counts.connectors, apart > 20 ? 1U : 0U) << apart;
        EXPECT_EQ(count(r, "connector-impossible"), apart > 20 ? 0U : 1U);
        o.head.none = true;
        r = link(regions, o);
        EXPECT_EQ(r.counts.connectors, 1U);
    }
}

TEST(Connectors, GoInsideWithinALayer) {
    const auto regions = towers(6, Join::start);
    auto r = link(regions, with(Connect::inside));
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.strands, 6U);
    EXPECT_NEAR(r.counts.strand_length, 6 * 8, 6 * 2);
}

// A strand that is there already is in the way of the head: a lower strand that would pass below it is not made.
TEST(Connectors, GoInsideNotBelowAnEarlierStrand) {
    for (const std::uint32_t layer : {0U, 4U, 8U}) { // of the later pair; the earlier one is on layer 9
        std::vector<RegionPaths> regions;
        std::uint32_t id = 0;
        for (const geom::Vec2 at : {geom::Vec2{0, 0}, geom::Vec2{24, 0}})
            regions.push_back(region(id++, 9, Join::start, {rings(at, 2, 4)}));
        for (const geom::Vec2 at : {geom::Vec2{12, -14}, geom::Vec2{12, 14}})
            regions.push_back(region(id++, layer, Join::start, {rings(at, 2, 4)}));
        Options o = with(Connect::inside);
        o.head.carriage_x = o.head.carriage_y = 1;
        EXPECT_EQ(link(regions, o).counts.strands, 1U) << layer;
        o.head.none = true;
        EXPECT_EQ(link(regions, o).counts.strands, 2U) << layer;
    }
}

// A third tower between two is in the way, printed before or after, be it long after.
TEST(Connectors, GoInsideAroundNothing) {
    for (const bool before : {true, false})
        for (const std::uint32_t layers : {1U, 40U}) {
            std::vector<RegionPaths> three{region(0, 0, Join::start, {rings({0, 0}, 2, 4)})};
            for (std::uint32_t i = 0; i < layers; ++i)
                three.push_back(region(1 + i, i, i == 0 ? Join::start : Join::vertical, {rings({24, 0}, 2, 4)}));
            const auto third = region(1 + layers, 0, Join::start, {rings({12, 0}, 2, 4)});
            three.insert(before ? three.begin() : three.end(), third);
            const auto r = link(three, with(Connect::inside));
            check(three, r);
            EXPECT_EQ(crossings(r.spans), 0U);
            // one to the neighbour, if the nozzle gets there from where it was last on this layer
            EXPECT_EQ(r.counts.strands, before || layers == 1 ? 1U : 0U) << before << layers;
        }
}

// The brim about a region is of its stroke, and in the way of strands that leave it.
TEST(Connectors, GoInsideAcrossNoBrim) {
    const auto square = [](double r) { return Curve{true, {{-r, -r}, {r, -r}, {r, r}, {-r, r}}, {kWidth}}; };
    const std::vector<RegionPaths> regions{region(0, 0, Join::start, {square(4)}),
                                           region(1, 0, Join::beside, {square(4 - kWidth)}),
                                           region(2, 0, Join::start, {rings({12, 0}, 2, 4)})};
    const auto r = link(regions, with(Connect::inside));
    EXPECT_EQ(crossings(r.spans), 0U);
    EXPECT_EQ(r.counts.brims, 1U);
    EXPECT_EQ(r.counts.strands, 0U);
    EXPECT_EQ(count(r, "connector-impossible"), 1U);
}

// A strand may run between two lines that are printed later; no jog joins these then.
TEST(Connectors, AreCrossedByNoJog) {
    const auto line = [](double y) { return Curve{false, {{10, y}, {14, y}}, {kWidth}}; };
    std::vector<RegionPaths> regions{region(0, 0, Join::start, {rings({0, 0}, 2, 4)}),
                                     region(1, 0, Join::start, {rings({24, 0}, 2, 4)})};
    const auto alone = link(regions, with(Connect::inside));
    ASSERT_EQ(alone.counts.strands, 1U);
    const auto strand = std::find_if(alone.spans.begin(), alone.spans.end(),
                                     [](const Span& s) { return s.role == Role::jog && geom::length(s.points) > 4; });
    ASSERT_NE(strand, alone.spans.end());
    const double y = (strand->points.front().y + strand->points.back().y) / 2;
    regions.push_back(region(2, 0, Join::start, {line(y - 0.25), line(y + 0.25)}));
    const auto r = link(regions, with(Connect::inside));
    EXPECT_EQ(r.counts.strands, 2U);
    EXPECT_EQ(crossings(r.spans), 0U);
    EXPECT_EQ(r.counts.parted, 1U);
}

} // namespace filum::link3d
