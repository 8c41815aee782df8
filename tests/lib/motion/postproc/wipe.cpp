#include "postproc/wipe.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::postproc {
namespace {

double length(Vec3 from, const std::vector<Vec3>& places) {
    double out = 0;
    for (const Vec3& p : places) {
        out += geom::distance(from, p);
        from = p;
    }
    return out;
}

TEST(WipePath, GoesBackAsFarAsWanted) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> step(-1, 1);
    for (int job = 0; job < 200; ++job) {
        WipePath path;
        std::vector<Vec3> all{{0, 0, 1}};
        const double most = 0.1 + job % 5;
        double whole = 0;
        for (int i = 0; i < job % 40; ++i) {
            const Vec3 to = all.back() + Vec3{step(random), step(random), 0};
            path.add(all.back(), to, most);
            whole += geom::distance(all.back(), to);
            all.push_back(to);
        }
        const auto back = path.back(most);
        EXPECT_NEAR(length(all.back(), back), std::min(most, whole), 1e-9);
        for (std::size_t i = 0; i + 1 < back.size(); ++i) EXPECT_EQ(back[i], all[all.size() - 2 - i]);
    }
}

TEST(WipePath, EndsWhereTheBeadRises) {
    WipePath path;
    path.add({0, 0, 1}, {5, 0, 2}, 10);
    path.add({5, 0, 2}, {6, 0, 2}, 10);
    EXPECT_EQ(path.back(10), (std::vector<Vec3>{{5, 0, 2}}));
    path.add({9, 9, 2}, {9, 8, 2}, 10); // another stroke
    EXPECT_EQ(path.back(10), (std::vector<Vec3>{{9, 9, 2}}));
    path.clear();
    EXPECT_TRUE(path.back(10).empty());
}

} // namespace
} // namespace filum::postproc
