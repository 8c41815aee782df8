#include "link3d/interlace.hpp"
#include "stacks.hpp"

#include <set>

namespace filum::link3d {

using namespace test;

namespace {

// Where the region's first bead begins.
std::map<std::uint32_t, Vec2> starts(const Result& r) {
    std::map<std::uint32_t, Vec2> out;
    for (const auto& s : r.spans)
        if (s.role == Role::bead) out.try_emplace(s.layer, s.points.front().xy());
    return out;
}

const std::vector kSchemes{Interlace::alternate, Interlace::golden};

} // namespace

TEST(StartOffset, SetsNeighboursApart) {
    for (const Interlace scheme : kSchemes) {
        double before = start_offset(scheme, 0);
        for (std::uint32_t layer = 1; layer < 2000; ++layer) {
            const double at = start_offset(scheme, layer);
            EXPECT_GT(std::abs(at - before), kApart);
            EXPECT_GE(at, 0);
            EXPECT_LE(at, 12);
            before = at;
        }
    }
}

TEST(StartOffset, SpreadsAsTheSchemeSays) {
    std::set<double> alternate, golden;
    for (std::uint32_t layer = 0; layer < 100; ++layer) {
        alternate.insert(start_offset(Interlace::alternate, layer));
        golden.insert(start_offset(Interlace::golden, layer));
    }
    EXPECT_EQ(alternate.size(), 2U);
    EXPECT_EQ(golden.size(), 100U);
}

// One stroke still, nothing crossed, no material more, and neighbouring starts are apart.
TEST(Interlacing, SetsStartsApartWithoutAStop) {
    Random random{4};
    for (const Interlace scheme : kSchemes) {
        for (const Curve& plain : {comb({0, 0}, 9, 16), rings({4, 4}, 4, 9)}) {
            for (const Curve& c : {plain, refined(plain, 0.35, random)}) {
                const auto regions = column(std::vector<std::vector<Curve>>(24, {c}));
                Options o;
                o.interlace = scheme;
                const auto r = link(regions, o);
                check(regions, r);
                EXPECT_EQ(r.counts.strokes, 1U);
                EXPECT_EQ(r.counts.shifts, 23U);
                EXPECT_TRUE(r.notes.empty());
                const auto at = starts(r);
                for (std::uint32_t layer = 1; layer < 24; ++layer)
                    EXPECT_GE(geom::distance(at.at(layer), at.at(layer - 1)), 3 * kWidth) << layer;
                const double none = volume(link(regions), false);
                EXPECT_NEAR(volume(r, false), none, 0.005 * none);
            }
        }
    }
}

TEST(Interlacing, HidesStartsInsideWhereAsked) {
    const auto regions = column(std::vector<std::vector<Curve>>(20, {comb({0, 0}, 9, 16)}));
    Options o;
    o.interlace = Interlace::golden;
    o.seam = Seam::inside;
    const auto r = link(regions, o);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    for (const auto& [layer, p] : starts(r)) {
        EXPECT_GT(p.y, kWidth / 2) << layer;
        EXPECT_LT(p.y, 14.5 * kWidth) << layer;
    }
}

TEST(Interlacing, SaysWhatIsTooSmall) {
    const auto regions = column(std::vector<std::vector<Curve>>(5, {comb({0, 0}, 0.9, 2)}));
    Options o;
    o.interlace = Interlace::alternate;
    const auto r = link(regions, o);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.kept, 4U);
    ASSERT_EQ(r.notes.size(), 4U);
    EXPECT_EQ(r.notes[0].code, NoteCode::interlace_impossible);
}

// Open curves begin at their two ends in turn: nothing is cut, and no lane is needed.
TEST(Interlacing, RunsOpenCurvesThereAndBack) {
    Curve line{false, {}, {kWidth}};
    for (int k = 0; k < 20; ++k) {
        const Vec2 a{0, k * 1.0}, b{10, k * 1.0};
        for (const Vec2 p : k % 2 == 0 ? std::vector{a, b} : std::vector{b, a}) line.points.push_back(p);
    }
    const auto regions = column(std::vector<std::vector<Curve>>(6, {line}));
    Options o;
    o.interlace = Interlace::golden;
    const auto r = link(regions, o);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.shifts + r.counts.kept, 0U);
    for (const auto& [layer, p] : starts(r)) EXPECT_EQ(p, layer % 2 == 0 ? line.points.front() : line.points.back());
    EXPECT_NEAR(volume(r, true), 6 * length(line.points) * kWidth * kHeight, 1e-6);
}

TEST(Direction, AlternatesUnlessTold) {
    const auto regions = column(std::vector<std::vector<Curve>>(4, {comb({0, 0}, 8, 10)}));
    for (const bool alternate : {true, false}) {
        Options o;
        o.alternate_direction = alternate;
        const auto r = link(regions, o);
        check(regions, r);
        std::vector<bool> left; // turning
        for (const auto& s : r.spans) {
            if (s.role != Role::bead) continue;
            double area = 0;
            for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
                area += geom::cross(s.points[i].xy(), s.points[i + 1].xy());
            left.push_back(area > 0);
        }
        ASSERT_EQ(left.size(), 4U);
        for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(left[i] != left[i - 1], alternate) << i;
    }
}

} // namespace filum::link3d
