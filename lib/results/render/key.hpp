// Draws the legend of a picture, item by item from the lower left corner.
#pragma once

#include "render/canvas.hpp"

#include <string>

namespace filum::render {

// A ramp of colours that stands for amounts.
struct RampScale {
    std::string name; // of what is measured
    double lo = 0, hi = 1;
    std::string unit = {};
    bool below = false, above = false; // whether amounts lie beyond the ends
};

class Key {
  public:
    explicit Key(Canvas& canvas);
    void clear(Rgb paper); // covers the picture under the legend with `paper`; call it before the first item
    // Add one item each. An item is left out if there is no room for it.
    void text(const std::string& text);
    void swatch(Rgb colour, const std::string& text);
    void ramp(const std::string& lo, const std::string& hi); // without amounts
    void ramp(const RampScale& scale);                       // with ticks at round amounts
    // A scale bar with a round length at the right border; `scale`: pixels per mm.
    void ruler(double scale);

  private:
    [[nodiscard]] bool room(double width) const;
    [[nodiscard]] double bar() const { return 14 * size_; } // width of a ramp, pixels
    bool bar_between(const std::string& lo, const std::string& hi, double& x);
    Canvas* canvas_;
    double size_;    // height of a capital, pixels
    geom::Vec2 at_;  // lower left corner of the next item
    double end_ = 0; // right border of the items
};

} // namespace filum::render
