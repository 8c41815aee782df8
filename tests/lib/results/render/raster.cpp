// What a picture of a surface is made from: which bead lies over a place, which triangle a pixel shows.
#include "render/paint.hpp"
#include "render/plan.hpp"
#include "render/sampling.hpp"
#include "render/strokes.hpp"
#include "sheets.hpp"

#include <gtest/gtest.h>

namespace filum::render {
namespace {

TEST(Strokes, FindWhatASearchOfAllFinds) {
    std::vector<Stroke> all;
    auto random = [k = 0U]() mutable { return hash(++k) * 0x1p-32; };
    const auto point = [&] { return Vec3{20 * random(), 20 * random(), 4 * random()}; };
    for (std::uint32_t k = 0; k < 300; ++k) {
        Stroke s;
        s.a = point();
        s.b = k % 5 == 0 ? s.a : s.a + 0.2 * (point() - Vec3{10, 10, 2});
        s.half_a = s.half_b = 0.3 + random();
        s.reach = 0.4;
        s.layer = k % 3;
        all.push_back(s);
    }
    const Strokes strokes(all);
    int covered = 0;
    for (int k = 0; k < 3000; ++k) {
        const Vec3 p = point();
        std::uint32_t layer = 0;
        double least = INFINITY;
        for (const Stroke& s : all) {
            const Vec3 d = s.b - s.a;
            const double t = dot(d, d) > 0 ? std::clamp(dot(p - s.a, d) / dot(d, d), 0.0, 1.0) : 0;
            const double off = geom::distance(p, s.a + t * d) / s.half_a;
            if (off > 1 || (least <= 1 && s.layer < layer)) continue;
            if (least > 1 || s.layer > layer || off < least) {
                least = off;
                layer = s.layer;
            }
        }
        const Cover c = strokes.at(p, {0, 0, 1});
        ASSERT_EQ(c.stroke != nullptr, least <= 1) << k;
        if (c.stroke == nullptr) continue;
        ++covered;
        EXPECT_NEAR(c.off, least, 1e-9);
        EXPECT_EQ(c.stroke->layer, layer);
    }
    EXPECT_GT(covered, 300);
}

TEST(Raster, HasNoHolesAndShowsTheNearest) {
    const auto sheet = sphere(5);
    for (const Vec3 from : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0.3, -2, 0.7}}) {
        const Plan plan = lay_out(sheet.surface.vertices, from, upwards(from), 160, 160);
        const Raster raster(sheet.surface, plan, 2);
        const Vec3 middle = plan.place({0, 0, 0});
        for (int b = 0; b < raster.bands(); ++b) {
            const Sights sights = raster.band(b);
            for (int y = 0; y < sights.rows; ++y)
                for (int x = 0; x < sights.columns; ++x) {
                    const int row = b * raster.rows() * 2 + y;
                    const double far = std::hypot((x + 0.5) / 2 - middle.x, (row + 0.5) / 2 - middle.y) / plan.scale;
                    const Sight& s = sights.at(x, y);
                    if (far > 4.9) {
                        if (far > 5.01) {
                            ASSERT_EQ(s.triangle, surface::kNone);
                        }
                        continue;
                    }
                    ASSERT_NE(s.triangle, surface::kNone);
                    ASSERT_NEAR(s.height - middle.z, std::sqrt(25 - far * far), 0.1);
                    const Vec3 share = raster.shares(s.triangle, x, row);
                    const auto& t = sheet.surface.triangles[s.triangle];
                    const Vec3 p = share.x * sheet.surface.vertices[t[0]] + share.y * sheet.surface.vertices[t[1]] +
                                   share.z * sheet.surface.vertices[t[2]];
                    ASSERT_NEAR(plan.place(p).x, (x + 0.5) / 2, 1e-9);
                    ASSERT_NEAR(plan.place(p).z, s.height, 1e-5);
                }
        }
    }
}

} // namespace
} // namespace filum::render
