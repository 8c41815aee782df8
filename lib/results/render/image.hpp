// Pictures as pixels and as PNG files.
#pragma once

#include "geom/vec.hpp"
#include "render/colour.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::render {

// A picture of 8-bit sRGB pixels, rows from top to bottom.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    Image(int w, int h)
        : width(w), height(h), rgb(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3, 255) {}
    void set(int x, int y, Rgb c) {
        const Srgb8 s = to_srgb8(c);
        auto* p =
            &rgb[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3];
        p[0] = s.r;
        p[1] = s.g;
        p[2] = s.b;
    }
    [[nodiscard]] Rgb get(int x, int y) const {
        const auto* p =
            &rgb[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3];
        return from_srgb8({p[0], p[1], p[2]});
    }
};

// The bytes of the PNG file. Equal pictures give equal bytes. Throws Error(failure) if libpng fails.
std::string encode_png(const Image& image);

// Draws a line from a to b with round ends, blended by `alpha`. Coordinates are pixels, y downwards, with pixel centres
// at halves.
void draw_line(Image& image, geom::Vec2 a, geom::Vec2 b, double width, Rgb colour, double alpha = 1);

void draw_box(Image& image, int x0, int y0, int x1, int y1, Rgb colour, double alpha = 1);

// Writes `text` in a simple stroke font with capitals, digits and . , - + / : = %. Small letters become capitals. `at`
// is the lower left corner, `size` the height of a capital in pixels.
void draw_text(Image& image, geom::Vec2 at, double size, std::string_view text, Rgb colour);
double text_width(double size, std::string_view text);

} // namespace filum::render
