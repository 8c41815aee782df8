// Pictures as the tests see them.
#pragma once

#include "render/colour.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <string>
#include <vector>

namespace filum::render {

// Decoded by libpng's simple interface, which shares nothing with the writer's calls.
struct Decoded {
    unsigned width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
    [[nodiscard]] Srgb8 at(unsigned x, unsigned y) const {
        const auto* p = &rgb[(std::size_t{y} * width + x) * 3];
        return {p[0], p[1], p[2]};
    }
    // Share of pixels that `test` holds for.
    template <class F>
    [[nodiscard]] double share(F&& test) const {
        std::size_t n = 0;
        for (unsigned y = 0; y < height; ++y)
            for (unsigned x = 0; x < width; ++x) n += test(at(x, y)) ? 1 : 0;
        return static_cast<double>(n) / (static_cast<double>(width) * height);
    }
};

inline Decoded decode(const std::string& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
    image.format = PNG_FORMAT_RGB;
    Decoded out{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
    EXPECT_NE(png_image_finish_read(&image, nullptr, out.rgb.data(), 0, nullptr), 0);
    return out;
}

inline bool colourful(Srgb8 c) { return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) > 40; }
inline bool red(Srgb8 c) { return c.r > 190 && c.g < 110 && c.b < 110; }

} // namespace filum::render
