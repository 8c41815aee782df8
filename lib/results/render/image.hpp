// Pictures as pixels.
#pragma once

#include "render/colour.hpp"

#include <cstdint>
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
    [[nodiscard]] Srgb8 pixel(int x, int y) const {
        const auto* p =
            &rgb[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3];
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] Rgb get(int x, int y) const { return from_srgb8(pixel(x, y)); }
};

} // namespace filum::render
