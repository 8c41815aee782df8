// Brings triangles to given sizes on a surface.
#pragma once

#include "surface/curve/locate.hpp"
#include "surface/fit/editable.hpp"

namespace filum::surface::fit {

// Sizes above which sides are halved, and below which they are collapsed (Botsch, Kobbelt 2004).
inline constexpr double kLong = 4.0 / 3, kShort = 4.0 / 5;

class Fitter {
  public:
    // Vertices stay on `from`, whose places `locator` finds; `m` are the triangles. `sizes` are per vertex of `from`,
    // linear in between. All except `m` must outlive the object. One pass of splitting makes at most `most_splits` new
    // vertices; sides that are still long then wait for the next pass.
    Fitter(const Surface& from, const curve::Locator& locator, std::span<const double> sizes, Editable m,
           std::size_t most_splits)
        : from_(from), locator_(locator), sizes_(sizes), m_(std::move(m)), most_splits_(most_splits) {}

    // Splits long sides, collapses short ones, flips and moves, in several rounds.
    void run();

    // The same, but halves the longest sides first and collapses short ones before the next halving, so that long thin
    // triangles never create many more triangles than there are in the end.
    void run_by_halves();

    // Updates the sizes at vertices after they have changed.
    void resize(std::size_t most_splits);

    [[nodiscard]] const Editable& result() const { return m_; }
    [[nodiscard]] std::size_t splits() const { return splits_; } // in all passes

  private:
    [[nodiscard]] double target(std::uint32_t a, std::uint32_t b) const { return std::min(m_.size[a], m_.size[b]); }
    [[nodiscard]] double size_at(const curve::Place& p) const;
    [[nodiscard]] double opposite(std::uint32_t h) const;
    [[nodiscard]] Vec3 middle(std::uint32_t vertex) const;
    // With sides up to `scale` times their final length.
    void split_long(double scale = 1);
    void collapse_short(double scale = 1);
    void flip_all();
    void move_all();

    const Surface& from_;
    const curve::Locator& locator_;
    std::span<const double> sizes_;
    Editable m_;
    std::size_t most_splits_, splits_ = 0;
};

} // namespace filum::surface::fit
