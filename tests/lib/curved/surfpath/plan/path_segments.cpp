// Whether a stretch comes near is found as by its distance.
#include "surfpath/plan/path_segments.hpp"

#include "../../../trials.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::surfpath {

using namespace plan;
namespace {

TEST(PathSegments, WithinIsWhatTheDistanceSays) {
    std::mt19937 random(3);
    const auto in = [&](double most) { return most * (2 * double(random()) / double(random.max()) - 1); };
    const auto place = [&](double most) { return Vec3{in(most), in(most), in(most)}; };
    int near = 0, far = 0, even = 0;
    for (int k = 0; k < trials(20'000); ++k) {
        PathSegment l{place(2), {}, {0, 0, 1}};
        l.b = k % 7 == 0 ? l.a : l.a + place(k % 5 == 0 ? 300 : 1); // points and long ones, too
        const Vec3 p = 0.5 * (l.a + l.b) + place(2);
        const double off = nearest_place(l, p).off;
        for (const double reach :
             {off, std::nextafter(off, 0.0), std::nextafter(off, 10.0), 0.9999999 * off, 0.5, 1.0}) {
            ASSERT_EQ(within(l, p, reach), off <= reach) << k << " " << off << " " << reach;
            ++(reach == off ? even : off <= reach ? near : far);
        }
    }
    EXPECT_GT(std::min({near, far, even}), trials(1000));
}

} // namespace
} // namespace filum::surfpath
