// Surfaces and paths on them: true to scale, voids where no bead is, for any mesh.
#include "render/drape.hpp"

#include "base/error.hpp"
#include "decoded.hpp"
#include "render/draw.hpp"
#include "render/sampling.hpp"
#include "render/view.hpp"
#include "sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::render {

namespace {

using geom::Vec3;

toolpath::Span lane(Vec3 a, Vec3 b, Vec3 normal = {0, 0, 1}, std::uint32_t layer = 0) {
    return {toolpath::Role::bead, 0, layer, 0, {a, b}, {1.0}, {0.2}, {normal, normal}};
}

// Lanes of 1 mm that fill the square except for the first `missing`, `z` above it.
std::vector<toolpath::Span> lanes(int missing, double z = 0, Vec3 normal = {0, 0, 1}) {
    std::vector<toolpath::Span> out;
    for (int k = missing; k < 10; ++k) out.push_back(lane({0, k + 0.5, z}, {10, k + 0.5, z}, normal));
    return out;
}

Options plain(const char* view = "top") {
    Options o;
    o.view = view;
    o.size = {300, 300};
    o.no_centres = true;
    o.voids = true;
    return o;
}

// Share of such a picture of the square that `mm2` of it take.
double share_of(double mm2) {
    const double scale = std::min(300 * 0.92, 300 * 0.86) / 10;
    return mm2 * scale * scale / 90000;
}

TEST(Drape, ShowsVoidsOfTheirSizeOnAnyMesh) {
    for (const std::uint32_t n : {1U, 20U}) {
        for (const int missing : {0, 2, 5}) {
            Scene s;
            s.sheet = square(n);
            s.spans = lanes(missing);
            const Decoded d = decode(draw(s, plain(), "class", 1));
            EXPECT_NEAR(d.share(red), share_of(10.0 * missing), 0.012) << n << " " << missing;
        }
    }
}

TEST(Drape, CountsWhatIsUncovered) {
    for (const std::uint32_t n : {1U, 20U}) {
        for (const int missing : {0, 2, 5}) {
            Scene s;
            s.sheet = square(n);
            s.spans = lanes(missing);
            const SurfaceBeads laid = surface_beads(s, tint(s, ColourBy::role, nullptr));
            EXPECT_NEAR(uncovered(s.sheet->surface, laid), missing / 10.0, 0.002);
            EXPECT_EQ(laid.loose.size(), 0u);
            EXPECT_FALSE(laid.behind);
        }
    }
}

TEST(Drape, TellsTheTwoSidesOfAThinWallApart) {
    Scene s;
    mesh::Mesh m;
    add_square(m, 4, 0, false);
    add_square(m, 4, 0.3, true);
    s.sheet = sheet_of(std::move(m));
    s.spans = lanes(0, 0.3);
    EXPECT_LT(decode(draw(s, plain("top"), "class", 1)).share(red), 0.02);
    EXPECT_NEAR(decode(draw(s, plain("bottom"), "class", 1)).share(red), share_of(100), 0.03);
    EXPECT_NEAR(uncovered(s.sheet->surface, surface_beads(s, tint(s, ColourBy::role, nullptr))), 0.5, 0.002);
}

TEST(Drape, KnowsTheSideOfPathsWithoutNormals) {
    Scene s;
    mesh::Mesh m;
    add_square(m, 4, 0, false);
    add_square(m, 4, 0.3, true);
    s.sheet = sheet_of(std::move(m));
    s.spans = lanes(0, 0.3);
    for (auto& span : s.spans) span.normals.clear();
    const SurfaceBeads laid = surface_beads(s, tint(s, ColourBy::role, nullptr));
    EXPECT_TRUE(laid.loose.empty());
    EXPECT_NEAR(uncovered(s.sheet->surface, laid), 0.5, 0.002);
}

TEST(Drape, FollowsThePathToTheBack) {
    Scene s;
    s.sheet = square(3);
    s.spans = lanes(3, 0, {0, 0, -1});
    const SurfaceBeads laid = surface_beads(s, tint(s, ColourBy::role, nullptr));
    EXPECT_TRUE(laid.behind);
    EXPECT_TRUE(laid.loose.empty());
    EXPECT_NEAR(uncovered(s.sheet->surface, laid), 0.3, 0.002);
    EXPECT_LT(decode(draw(s, plain("top"), "class", 1)).share(red), 0.01);
    EXPECT_NEAR(decode(draw(s, plain("bottom"), "class", 1)).share(red), share_of(30), 0.012);
    EXPECT_EQ(draw(s, plain("bottom"), "class", 1), draw(s, plain("auto"), "class", 1)); // face to face with the path
}

TEST(Drape, ShowsBeadsThatDoNotLieOnTheSurface) {
    Scene s;
    s.sheet = square();
    s.spans = {lane({1, 5, 4}, {9, 5, 4}), lane({1, 2, 0.4}, {9, 2, 0.4})};
    const SurfaceBeads laid = surface_beads(s, tint(s, ColourBy::role, nullptr));
    double loose = 0; // mm
    for (const Stroke& b : laid.loose) loose += geom::distance(b.a, b.b);
    EXPECT_NEAR(loose, 8, 1e-9);
    const auto blue = [](Srgb8 c) { return c.b > c.r + 40; };
    const double seen = decode(draw(s, plain("front"), "class", 1)).share(blue);
    s.spans.erase(s.spans.begin());
    const double lying = decode(draw(s, plain("front"), "class", 1)).share(blue);
    EXPECT_GT(seen, lying + 0.005); // thin
    EXPECT_LT(seen, lying + 0.02);
}

TEST(Drape, LeansFromTheFaceToTheNamedSide) {
    const auto green = [](Srgb8 c) { return c.g > c.r + 60 && c.g > c.b + 40; }; // the dot where the path starts
    Scene s;
    s.sheet = square(2);
    Options o = plain("face");
    o.voids = false;
    // The foot of a mast in the middle of the square, and its tip: seen from the left, the tip appears at the right.
    for (const auto& [view, x, y] : {std::tuple{"face", 0, 0},
                                     {"face-left", 1, 0},
                                     {"face-right", -1, 0},
                                     {"face-up", 0, 1},
                                     {"face-down", 0, -1}}) {
        o.view = view;
        double at[2][2];
        for (const double height : {0.0, 4.0}) {
            // The travel is there for the same extent.
            s.spans = {lane({5, 5, height}, {5, 5.001, height}),
                       {toolpath::Role::travel, 0, 0, 0, {{5, 5, 0}, {5, 5, 4}}, {}, {}}};
            const Decoded d = decode(draw(s, o, "class", 1));
            double n = 0, sx = 0, sy = 0;
            for (unsigned j = 0; j < d.height * 17 / 20; ++j) // the legend below has a green swatch, too
                for (unsigned i = 0; i < d.width; ++i)
                    if (green(d.at(i, j))) {
                        ++n;
                        sx += i;
                        sy += j;
                    }
            at[height > 0][0] = sx / n;
            at[height > 0][1] = sy / n;
        }
        const double dx = at[1][0] - at[0][0], dy = at[1][1] - at[0][1];
        EXPECT_NEAR(dx / 30, x, x == 0 ? 0.2 : 2) << view;
        EXPECT_NEAR(dy / 30, y, y == 0 ? 0.2 : 2) << view;
        EXPECT_GE(dx * x + dy * y, (x != 0 || y != 0) ? 20 : 0) << view;
    }
}

TEST(Drape, PutsLaterLayersOnTop) {
    Scene s;
    s.sheet = square();
    s.spans = lanes(0);
    for (int k = 0; k < 10; ++k) {
        s.spans.push_back(lane({k + 0.5, 0, 0.2}, {k + 0.5, 10, 0.2}, {0, 0, 1}, 1));
        s.spans.back().stroke = 1;
    }
    const auto alone = [&](int from, int to) {
        Scene part = s;
        part.spans.assign(s.spans.begin() + from, s.spans.begin() + to);
        Options o = plain();
        o.color = "stroke";
        o.around = {5, 5, 0, 4};
        return decode(draw(part, o, "class", 1)).at(150, 120);
    };
    const Srgb8 both = alone(0, 20), lower = alone(0, 10), upper = alone(10, 20);
    EXPECT_EQ(hex(from_srgb8(both)), hex(from_srgb8(upper)));
    EXPECT_NE(hex(from_srgb8(both)), hex(from_srgb8(lower)));
}

TEST(Drape, MarksOverlapButNoTurns) {
    const auto dark = [](Srgb8 c) { return c.r < 70 && c.g < 100 && c.b < 150; };
    Options o = plain();
    o.overlap = true;
    o.size = {400, 400};
    Scene s;
    s.sheet = square();
    toolpath::Span turn = lane({1, 2, 0}, {8, 2, 0});
    turn.points.push_back({8, 3, 0});
    turn.points.push_back({1, 3, 0});
    turn.normals.assign(4, {0, 0, 1});
    s.spans = {turn};
    EXPECT_LT(decode(draw(s, o, "class", 1)).share(dark), 0.01);
    turn.points[2].y = turn.points[3].y = 2.5;
    s.spans = {turn};
    // 0.42 mm wide, up to where the turn is 3 widths away along the path.
    EXPECT_NEAR(decode(draw(s, o, "class", 1)).share(dark), share_of(0.42 * 5.75), 0.002);
}

TEST(Drape, ColoursByAFieldAndSaysWhichThereAre) {
    Scene s;
    s.sheet = square(10);
    surface::Field x{"x", {}, 1}, across{"dir", {}, 3};
    for (const Vec3& v : s.sheet->surface.vertices) {
        x.values.push_back(v.x);
        across.values.insert(across.values.end(), {1, 0, 0});
    }
    s.sheet->fields = {x, across};
    Options o = plain();
    o.voids = false;
    o.by = "x";
    const Decoded d = decode(draw(s, o, "class", 1));
    EXPECT_GT(d.at(240, 140).g, d.at(60, 140).g + 60); // blue to yellow
    for (const auto& [by, arrows] : {std::pair{"y", ""}, {"", "x"}, {"x", "y"}}) {
        o.by = by;
        o.arrows = arrows;
        try {
            draw(s, o, "class", 1);
            FAIL();
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find("it has "), std::string::npos) << e.what();
        }
    }
}

TEST(Drape, DrawsVectorsAlongTheirDirection) {
    const auto runs = [](Vec3 v) { // dark pixels followed by dark ones: to the right, and downwards
        Scene s;
        s.sheet = square(4);
        surface::Field f{"dir", {}, 3};
        for (std::size_t k = 0; k < s.sheet->surface.vertices.size(); ++k)
            f.values.insert(f.values.end(), {v.x, v.y, v.z});
        s.sheet->fields = {f};
        Options o = plain();
        o.voids = false;
        o.arrows = "dir";
        o.around = {5, 5, 0, 3};
        const Decoded d = decode(draw(s, o, "class", 1));
        std::pair<int, int> out;
        for (unsigned y = 10; y < 250; ++y)
            for (unsigned x = 10; x < 290; ++x) {
                if (d.at(x, y).r > 110) continue;
                out.first += d.at(x + 1, y).r <= 110 ? 1 : 0;
                out.second += d.at(x, y + 1).r <= 110 ? 1 : 0;
            }
        return out;
    };
    const auto along_x = runs({1, 0, 0}), along_y = runs({0, 2, 0}), none = runs({0, 0, 0});
    EXPECT_GT(along_x.first, 3 * along_x.second + 100);
    EXPECT_GT(along_y.second, 3 * along_y.first + 100);
    EXPECT_EQ(none.first + none.second, 0);
}

TEST(Scale, LeavesOutPeaksAndWhatIsUnknown) {
    surface::Field f{"s", {INFINITY, 1e6, -1e6}, 1};
    for (int k = 0; k <= 1000; ++k) f.values.push_back(k);
    const Scale s = scale_of(f);
    EXPECT_NEAR(s.lo, 10, 2);
    EXPECT_NEAR(s.hi, 990, 2);
    EXPECT_TRUE(s.below && s.above);
    f.values.erase(f.values.begin(), f.values.begin() + 3);
    EXPECT_EQ(scale_of(f).lo, 0);
    EXPECT_EQ(scale_of(f).hi, 1000);
    EXPECT_FALSE(scale_of(f).below || scale_of(f).above);
    f.values.assign(5, INFINITY);
    EXPECT_EQ(scale_of(f).hi, scale_of(f).lo);
}

TEST(Looks, AreNamesAndDirections) {
    const auto all = looks("iso,1,-2,0.5,back", "views");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[1].from, (Vec3{1, -2, 0.5}));
    EXPECT_EQ(all[2].name, "back");
    for (const char* bad : {"", "iso,", "1,2", "iso,1,2", "0,0,0", "up", "nan,0,1", "1,2,x"})
        EXPECT_THROW(looks(bad, "views"), Error) << bad;
}

TEST(ContactSheet, HasEveryViewOnce) {
    for (const int n : {2, 4, 7}) {
        int drawn = 0;
        Canvas page(320, 240, Format::png);
        const std::vector<ViewDirection> looks(static_cast<std::size_t>(n), ViewDirection{"", {0, 0, 1}});
        contact_sheet(page, looks, [&](Canvas& cell, const ViewDirection&) {
            cell.box({0, 0}, {400, 400}, {0.1F * static_cast<float>(++drawn), 0, 0});
        });
        const Decoded sheet = decode(page.bytes());
        EXPECT_EQ(drawn, n);
        std::vector<bool> seen(static_cast<std::size_t>(n));
        for (unsigned y = 0; y < 240; ++y)
            for (unsigned x = 0; x < 320; ++x)
                for (int k = 0; k < n; ++k)
                    if (to_srgb8({0.1F * static_cast<float>(k + 1), 0, 0}).r == sheet.at(x, y).r)
                        seen[static_cast<std::size_t>(k)] = true;
        EXPECT_EQ(std::count(seen.begin(), seen.end(), true), n);
    }
}

TEST(Drape, IsTheSameForAnyThreads) {
    Scene s;
    s.sheet = sphere(5);
    for (int k = 0; k < 30; ++k) {
        const double z = 0.3 * k - 4.5, r = std::sqrt(25 - z * z);
        s.spans.push_back(lane({r, 0, z}, {0, r, z}, {r / 7, r / 7, z / 5}));
    }
    Options o = plain("auto");
    o.views = "face,iso,-1,2,0.3";
    o.overlap = true;
    const std::string one = draw(s, o, "class", 1);
    EXPECT_EQ(one, draw(s, o, "class", 2));
    EXPECT_EQ(one, draw(s, o, "class", 8));
}

TEST(Drape, BearsExtremes) {
    const auto at = [](double size, Vec3 place) {
        Scene s;
        s.sheet = sheet_of({{place, place + Vec3{size, 0, 0}, place + Vec3{0, size, 0}}, {{0, 1, 2}}});
        s.spans = {lane(place, place + Vec3{size, size, 0})};
        return s;
    };
    Options o = plain("auto");
    o.size = {64, 48};
    o.voids = false;
    o.overlap = true;
    o.views = "face,front,1,1,1";
    for (const double size : {1e-6, 1.0, 1e6})
        for (const Vec3 place : {Vec3{}, Vec3{1e8, -1e8, 1e8}}) {
            Scene s = at(size, place);
            EXPECT_EQ(decode(draw(s, o, "class", 1)).width, 64u);
            for (const double width : {1e-6, 1e6}) {
                s.spans[0].width = {width};
                EXPECT_EQ(decode(draw(s, o, "class", 1)).width, 64u);
            }
        }
    Scene s = at(10, {});
    s.spans = {lane({1, 1, 0}, {1, 1, 0}), lane({1e9, 1e9, 0}, {-1e9, 1e9, 0}), lane({1, 2, 0}, {5, 2, 0}, {})};
    s.spans[2].normals.clear();
    s.spans.push_back({toolpath::Role::travel, 0, 0, 0, {{5, 2, 0}, {1e10, 2, 7}}, {}, {}});
    EXPECT_EQ(decode(draw(s, o, "class", 1)).width, 64u);
    s.spans[3].points[1].x = 1e300;
    EXPECT_THROW(draw(s, o, "class", 1), Error);
    s.spans.pop_back();
    o.samples = 4096;
    o.views = "";
    o.around = {2, 2, 0, 1e-3};
    EXPECT_EQ(decode(draw(s, o, "class", 1)).width, 64u);
}

TEST(Drape, RefusesWhatHasNoSurface) {
    Scene s;
    s.spans = lanes(0);
    EXPECT_THROW(draw(s, plain(), "class", 1), Error);
    s.sheet = square();
    EXPECT_NO_THROW(draw(s, plain(), "class", 1));
    s.spans.clear();
    EXPECT_THROW(draw(s, plain(), "class", 1), Error);
    for (const double r : {0.0, -1.0, 1e300}) {
        Options o;
        o.around = {0, 0, 0, r};
        EXPECT_THROW(check(o), Error) << r;
    }
}

TEST(Drape, DrawsSeveralSurfacesInColoursOfTheirOwn) {
    Scene s;
    surface::Sheet left = square(4), right = square(4);
    left.name = "A";
    right.name = "B";
    for (Vec3& v : right.surface.vertices) v.x += 10;
    left.fields = {{"x", std::vector<double>(left.surface.vertices.size(), 1.0), 1}};
    add(s, left);
    add(s, right);
    ASSERT_EQ(s.patches.size(), 2U);
    EXPECT_EQ(s.sheet->surface.rims.size(), 2U);
    Options o = plain();
    o.voids = false;
    o.size = {600, 300};
    const Decoded d = decode(draw(s, o, "class", 1));
    const Srgb8 a = d.at(180, 80), b = d.at(420, 80);
    EXPECT_GT(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 60);
    EXPECT_TRUE(colourful(a) || colourful(b));
    const auto dark = [](Srgb8 c) { return std::max({c.r, c.g, c.b}) < 110; };
    std::size_t ink = 0; // of the name, in the middle of the left one
    for (unsigned y = 125; y < 150; ++y)
        for (unsigned x = 150; x < 210; ++x) ink += dark(d.at(x, y)) ? 1 : 0;
    EXPECT_GT(ink, 8U);
    o.by = "x"; // known on one only
    const Decoded by = decode(draw(s, o, "class", 1));
    EXPECT_FALSE(colourful(by.at(420, 80)));
    right.fields = {{"x", std::vector<double>(3 * right.surface.vertices.size(), 1.0), 3}};
    EXPECT_THROW(add(s, right), Error);
}

} // namespace

} // namespace filum::render
