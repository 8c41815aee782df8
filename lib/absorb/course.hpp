// Other courses for a short stretch of the curve, and what they cover.
#pragma once

#include "absorb/chain.hpp"

#include <span>
#include <vector>

namespace filum::absorb {

// The chain between the nodes `from` and `to`, which stay: now over `nodes`, then over `knots` (as many or more).
struct Course {
    std::uint32_t from = 0, to = 0;
    std::vector<std::uint32_t> nodes;
    std::vector<Knot> knots;
    double score = 0;
};

// What is gained and lost, in pixels, is added up at these prices, against 1 for a pixel of the region covered.
struct Prices {
    double twice = 0.25; // laid where there is material already
    double starved = 1;  // covered without the material for it
    double outside = 2;  // laid out of the region
};

// Scores courses of one stretch of up to seven segments within the 64 x 64 pixels at `corner`, beyond which nothing may
// change.
class Scores {
  public:
    Scores(const Tile& tile, const Chain& chain, std::uint32_t from, std::uint32_t to, Pixel corner,
           const Prices& prices);

    // A part of a course, to be used for many.
    struct Part {
        Mask mask;
        double laid = 0; // pixels
    };
    void add(Part& part, const Knot& a, const Knot& b) const;
    // Against the present course: `part` and the line over `knots`.
    [[nodiscard]] double operator()(const Part& part, std::span<const Knot> knots) const;
    // The whole course.
    [[nodiscard]] double operator()(std::span<const Knot> knots) const;

    [[nodiscard]] const Knot& from() const { return from_; }
    [[nodiscard]] const Knot& to() const { return to_; }

  private:
    struct Sum {
        double covered = 0, outside = 0, laid = 0;
    };
    [[nodiscard]] Sum sum(const Part& part) const;

    const Tile& tile_;
    Pixel corner_;
    Prices prices_;
    Knot from_, to_;
    Mask in_, out_;
    Sum now_;
};

// The window's corner that has `middle` at its centre, as far as the tile allows.
Pixel window(const Tile& tile, Vec2 middle);

// To the micrometre, which machines are told.
Vec2 snapped(Vec2 p);

// Whether the course crosses nothing and keeps `distance` from all of the curve but its next neighbours.
bool clear(const Chain& chain, const Near& near, const Course& course, double distance);

// Makes the course part of the chain, the grid and the tile.
void make(Tile& tile, Chain& chain, Near& near, const Course& course);

} // namespace filum::absorb
