#include "metrics/planar/directions.hpp"

#include "toolpaths.hpp"

namespace filum::metrics::planar {

namespace {

Directions of(const std::vector<toolpath::Span>& spans) {
    Beads beads;
    for (const auto& s : spans) add(beads, s);
    return directions(beads);
}

geom::Vec3 at(double length, double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return {length * std::cos(a), length * std::sin(a), 0.2};
}

TEST(Directions, EachLineCountsByItsLength) {
    for (int k = 0; k < 12; ++k)
        for (const double off : {-7.0, 0.0, 7.0})
            for (const double turn : {0.0, 180.0}) { // forth and back are the same direction
                const auto d =
                    of({bead({{0, 0, 0.2}, at(3, 15 * k + off + turn)}), bead({{0, 0, 0.2}, at(1, 15 * k + 30)})});
                EXPECT_NEAR(d.share[static_cast<std::size_t>(k)], 0.75, 1e-6);
                EXPECT_NEAR(d.share[static_cast<std::size_t>((k + 2) % 12)], 0.25, 1e-6);
            }
}

TEST(Directions, ACircleRunsEverywhereAlike) {
    std::vector<geom::Vec3> p;
    for (int k = 0; k <= 3600; ++k) p.push_back(at(5, k / 10.0));
    for (const double s : of({bead(p)}).share) EXPECT_NEAR(s, 1.0 / 12, 1e-3);
}

TEST(Directions, JoinsDoNotCount) {
    auto join = bead({{0, 0, 0.2}, {0, 5, 0.2}});
    join.role = toolpath::Role::connector;
    EXPECT_EQ(of({bead({{0, 0, 0.2}, {1, 0, 0.2}}), join}).share[0], 1);
    for (const double s : of({join}).share) EXPECT_EQ(s, 0);
}

} // namespace

} // namespace filum::metrics::planar
