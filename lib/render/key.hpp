// The legend of a picture, item by item from its lower left corner.
#pragma once

#include "render/image.hpp"

#include <string>

namespace filum::render {

class Key {
  public:
    explicit Key(Image& image);
    void clear(Rgb paper); // makes room where there is a picture: before the first item
    // Each leaves the item out if there is no room for it.
    void text(const std::string& text);
    void swatch(Rgb colour, const std::string& text);
    void ramp(const std::string& lo, const std::string& hi);
    // A bar of a round length at the right border; `scale`: pixels per mm.
    void ruler(double scale);

  private:
    [[nodiscard]] bool room(double width) const;
    Image* image_;
    double size_;    // of a capital, pixels
    geom::Vec2 at_;  // lower left corner of the next item
    double end_ = 0; // right border for items
};

} // namespace filum::render
