// What curves cover twice at sharp turns, against areas that are counted on a fine grid.
#include "fill/doubled.hpp"

#include "fill/spiral.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace filum;
using geom::Vec2;

namespace {

double doubled(const toolpath::Curve& c) { return fill::doubled_at_turns({&c, 1}).area; }

double laid(const toolpath::Curve& c) {
    double out = 0;
    for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i) {
        const std::size_t j = (i + 1) % c.points.size();
        out += geom::distance(c.points[i], c.points[j]) * (c.width[i] + c.width[j]) / 2;
    }
    return out;
}

// Legs of random lengths to and fro, `pitch` apart.
toolpath::Curve to_and_fro(std::mt19937& chance, double width, double pitch) {
    std::uniform_real_distribution<double> share(0, 1);
    toolpath::Curve out;
    const int legs = 2 + static_cast<int>(chance() % 30);
    for (int k = 0; k <= legs; ++k) out.add({k * pitch, k % 2 == 0 ? 0 : width * (1 + 10 * share(chance))}, width);
    return out;
}

// mm2 under an open curve of one width with round ends.
double united(const toolpath::Curve& c) {
    const double w = c.width[0], cell = w / 40;
    geom::Box2 box;
    for (const Vec2& p : c.points) box.add(p);
    double out = 0;
    for (double y = box.lo.y - w; y < box.hi.y + w; y += cell)
        for (double x = box.lo.x - w; x < box.hi.x + w; x += cell)
            for (std::size_t i = 0; i + 1 < c.points.size(); ++i) {
                const Vec2 a = c.points[i], d = c.points[i + 1] - a, p = Vec2{x, y} - a;
                const double t = std::clamp(geom::dot(p, d) / geom::dot(d, d), 0.0, 1.0);
                if (geom::norm(p - t * d) > w / 2) continue;
                out += cell * cell;
                break;
            }
    return out;
}

} // namespace

TEST(Doubled, WhatRunsToAndFroIsALowerBoundAndMostOfIt) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        std::mt19937 chance(seed);
        std::uniform_real_distribution<double> share(0, 1);
        const double width = 0.1 + share(chance), pitch = width * 0.5 * share(chance);
        const toolpath::Curve c = to_and_fro(chance, width, pitch);
        const double right = laid(c) - united(c), found = doubled(c);
        // Round ends are under the curve, and not part of its length times width: half a disc at each turn.
        const double ends = std::numbers::pi / 8 * width * width * static_cast<double>(c.points.size());
        EXPECT_LT(found, right + ends) << seed;
        EXPECT_GT(found, 0.4 * right) << seed;
    }
}

TEST(Doubled, NothingWhereTurnsAreAsWideAsABeadOrWider) {
    const double w = 0.4;
    for (const double radius : {w / 2, 0.75 * w, 2 * w, 20 * w})
        for (const int corners : {24, 100, 1000}) {
            toolpath::Curve c;
            c.closed = true;
            for (int side : {0, 1}) // a stadium
                for (int k = 0; k <= corners / 2; ++k) {
                    const double a = std::numbers::pi * (side + 2.0 * k / corners);
                    c.add({radius * std::cos(a), radius * std::sin(a) + (side == 0 ? 30 : 0)}, w);
                }
            EXPECT_LT(doubled(c), 0.02 * w * w) << radius << " " << corners;
        }
    toolpath::Curve square;
    square.closed = true;
    for (const Vec2 p : {Vec2{0, 0}, {10, 0}, {10, 10}, {0, 10}}) square.add(p, w);
    EXPECT_LT(doubled(square), 4 * 0.07 * w * w);
}

TEST(Doubled, AStarOfNeedlesIsNoted) {
    polygon::Loops star;
    for (int k = 0; k < 180; ++k) {
        const double a = std::numbers::pi * k / 90, r = k % 2 != 0 ? 20 : 0.3;
        star.points.push_back({r * std::cos(a), r * std::sin(a)});
    }
    star.close();
    Notes notes;
    fill::spiral(star, {.bead_width = 0.4}, notes);
    const auto at = std::ranges::find(notes, NoteCode::area_doubled, &Note::code);
    ASSERT_NE(at, notes.end());
    EXPECT_GT(at->amount, 1);
}
