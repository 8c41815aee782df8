// Draws the legend of a picture, item by item from the lower left corner.
#pragma once

#include "render/image.hpp"

#include <string>

namespace filum::render {

class Key {
  public:
    explicit Key(Image& image);
    void clear(Rgb paper); // covers the picture under the legend with `paper`; call it before the first item
    // Add one item each. An item is left out if there is no room for it.
    void text(const std::string& text);
    void swatch(Rgb colour, const std::string& text);
    void ramp(const std::string& lo, const std::string& hi);
    // A scale bar with a round length at the right border; `scale`: pixels per mm.
    void ruler(double scale);

  private:
    [[nodiscard]] bool room(double width) const;
    Image* image_;
    double size_;    // height of a capital, pixels
    geom::Vec2 at_;  // lower left corner of the next item
    double end_ = 0; // right border of the items
};

} // namespace filum::render
