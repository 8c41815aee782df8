#include "base/error.hpp"
#include "stressfield/principal.hpp"
#include "stressfield/triangle.hpp"

#include "parts.hpp"

#include <gtest/gtest.h>

namespace filum::stressfield {
namespace {

// s1 = 5 along (0.6, 0.8, 0), s2 = 2 along z, s3 = -1.
Tensor known() {
    const Vec3 a{0.6, 0.8, 0}, b{0, 0, 1}, c{0.8, -0.6, 0};
    const auto part = [&](double Vec3::*i, double Vec3::*j) {
        return 5 * a.*i * (a.*j) + 2 * b.*i * (b.*j) - c.*i * (c.*j);
    };
    return {part(&Vec3::x, &Vec3::x), part(&Vec3::y, &Vec3::y), part(&Vec3::z, &Vec3::z),
            part(&Vec3::x, &Vec3::y), part(&Vec3::y, &Vec3::z), part(&Vec3::z, &Vec3::x)};
}

surface::Sheet put(const Samples& samples, const Options& options, Notes& notes, Facts& facts) {
    surface::Sheet sheet{square(4, 4), {{"kept", std::vector<double>(25, 1), 1}}, {}};
    add(sheet, samples, options, 1, notes, facts);
    return sheet;
}

// One tensor at all vertices of the square.
Samples even(const Tensor& t) {
    Samples out;
    out.points = square(4, 4).vertices;
    out.cases.push_back({"X", std::vector<Tensor>(out.points.size(), t), {}, {}});
    return out;
}

TEST(Principal, ValuesAndFirstAxis) {
    const PrincipalAxes a = principal_axes(known());
    EXPECT_NEAR(a.values[0], 5, 1e-12);
    EXPECT_NEAR(a.values[1], 2, 1e-12);
    EXPECT_NEAR(a.values[2], -1, 1e-12);
    ASSERT_TRUE(a.first);
    EXPECT_NEAR(std::abs(dot(*a.first, {0.6, 0.8, 0})), 1, 1e-12);
    EXPECT_FALSE(principal_axes({3, 3, 1, 0, 0, 0}).first);
    EXPECT_FALSE(principal_axes({}).first);
}

TEST(Principal, InThePlane) {
    // within the plane across x the stresses are those along y and z
    const auto d = in_plane_axis({100, 1, 4, 0, 0, 0}, {1, 0, 0});
    ASSERT_TRUE(d);
    EXPECT_NEAR(std::abs(d->z), 1, 1e-12);
    EXPECT_FALSE(in_plane_axis({100, 4, 4, 0, 0, 0}, {1, 0, 0}));
}

TEST(Principal, OneSignOfTwo) {
    EXPECT_EQ(signed_direction({-0.8, 0.6, 0}), (Vec3{0.8, -0.6, 0}));
    EXPECT_EQ(signed_direction({0.6, -0.8, 0}), (Vec3{-0.6, 0.8, 0}));
    const double r = std::sqrt(0.5);
    EXPECT_EQ(signed_direction({-r, r + 1e-12, 0}), (Vec3{r, -r - 1e-12, 0}));
}

TEST(Principal, AboutADirection) {
    const PrincipalAxes a = principal_axes(about({0, 3, 4}, {2, 1, -5}));
    EXPECT_NEAR(a.values[0], 2, 1e-12);
    EXPECT_NEAR(a.values[1], -2, 1e-12);
    EXPECT_NEAR(std::abs(dot(*a.first, {0, 0.6, 0.8})), 1, 1e-12);
    const PrincipalAxes pressed = principal_axes(about({0, 0, 1}, {-2, kInfinity, kInfinity}));
    EXPECT_NEAR(pressed.values[0], -2, 1e-12);
    EXPECT_NEAR(std::abs(pressed.first->z), 1, 1e-12);
}

TEST(Fields, PrincipalStressesOfTensors) {
    Notes notes;
    Facts facts;
    const auto sheet = put(even(known()), {}, notes, facts);
    EXPECT_EQ(sheet.fields.size(), 5U);
    EXPECT_EQ(sheet.fields[0].name, "kept");
    for (std::size_t v = 0; v < 25; ++v) {
        EXPECT_NEAR(field(sheet, "stress.X.s1").values[v], 5, 1e-9);
        EXPECT_NEAR(field(sheet, "stress.X.s2").values[v], 2, 1e-9);
        EXPECT_NEAR(field(sheet, "stress.X.s3").values[v], -1, 1e-9);
        EXPECT_NEAR(distance(field(sheet, "stress.X.d1").vector(v), {0.6, 0.8, 0}), 0, 1e-9);
    }
    EXPECT_TRUE(notes.empty());
}

TEST(Fields, SignsOfVectorsDoNotMatter) {
    Samples plus, minus;
    plus.cases.push_back({"X", {}, {}, {}});
    minus.cases.push_back({"X", {}, {}, {}});
    Dice dice;
    for (double y = 0; y <= 4; y += 0.7)
        for (double x = 0; x <= 4; x += 0.7) {
            const double angle = 0.3 * x;
            const Vec3 d{std::cos(angle), std::sin(angle), 0};
            plus.points.push_back({x, y, 0});
            plus.cases[0].principals.push_back({1, kInfinity, kInfinity});
            plus.cases[0].directions.push_back(d);
            minus.cases[0].directions.push_back(dice() < 0.5 ? -1.0 * d : d);
        }
    minus.points = plus.points;
    minus.cases[0].principals = plus.cases[0].principals;
    Notes notes;
    Facts facts;
    const auto a = put(plus, {}, notes, facts), b = put(minus, {}, notes, facts);
    EXPECT_EQ(field(a, "stress.X.d1").values, field(b, "stress.X.d1").values);
    for (std::size_t v = 0; v < 25; ++v) {
        const double angle = 0.3 * a.surface.vertices[v].x;
        EXPECT_NEAR(std::abs(dot(field(a, "stress.X.d1").vector(v), {std::cos(angle), std::sin(angle), 0})), 1, 5e-4);
        EXPECT_NEAR(field(a, "stress.X.s1").values[v], 1, 1e-9);
        EXPECT_TRUE(std::isinf(field(a, "stress.X.s2").values[v]));
    }
}

// Pressed along x: the greatest stress is 0, along the normal.
TEST(Fields, OutOfTheSurfaceIsNotedAndTheTangentPlaneHelps) {
    Notes notes;
    Facts facts;
    const Samples pressed = even({-9, -2, 0, 0, 0, 0});
    auto sheet = put(pressed, {}, notes, facts);
    EXPECT_NEAR(field(sheet, "stress.X.d1").vector(7).z, 1, 1e-9);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].count, 25U);
    EXPECT_NEAR(notes[0].amount, 100, 1e-9);
    notes.clear();
    sheet = put(pressed, {.tangent = true}, notes, facts);
    EXPECT_NEAR(field(sheet, "stress.X.d1").vector(7).y, 1, 1e-9);
    EXPECT_NEAR(field(sheet, "stress.X.s1").values[7], 0, 1e-9);
    EXPECT_TRUE(notes.empty());
}

TEST(Fields, MaskTakesDirectionsOnly) {
    Samples s = even({1, 0, 0, 0, 0, 0});
    for (std::size_t v = 0; v < 25; ++v) s.cases[0].tensors[v][0] = s.points[v].x; // 0 to 4 MPa
    Notes notes;
    Facts facts;
    const auto sheet = put(s, {.mask = 0.6}, notes, facts);
    for (std::size_t v = 0; v < 25; ++v) {
        const double x = s.points[v].x;
        EXPECT_NEAR(field(sheet, "stress.X.s1").values[v], x, 1e-9);
        EXPECT_EQ(std::isfinite(field(sheet, "stress.X.d1").values[3 * v]), x > 2.5);
    }
}

TEST(Fields, UnknownIsInfiniteAndNoted) {
    Samples s = even(known());
    s.cases[0].tensors[12][3] = std::nan("");
    Notes notes;
    Facts facts;
    const auto sheet = put(s, {}, notes, facts);
    EXPECT_TRUE(std::isinf(field(sheet, "stress.X.s1").values[12]));
    EXPECT_TRUE(std::isinf(field(sheet, "stress.X.d1").vector(12).y));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].amount, 1, 1e-9); // mm2: a third of its six triangles
    EXPECT_EQ(notes[0].x, 2);
}

TEST(Fields, FarOrTwiceIsRefused) {
    Samples far = even(known());
    for (auto& p : far.points) p.z = 50;
    Notes notes;
    Facts facts;
    EXPECT_THROW(put(far, {}, notes, facts), Error);
    surface::Sheet sheet = put(even(known()), {}, notes, facts);
    EXPECT_THROW(add(sheet, even(known()), {}, 1, notes, facts), Error);
}

} // namespace
} // namespace filum::stressfield
