// Colours: linear light for calculations, sRGB for output, and OKLCH for choosing colours, since equal steps there look
// equal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace filum::render {

struct Rgb { // linear light, 0 to 1
    float r = 0, g = 0, b = 0;
};
struct Srgb8 {
    std::uint8_t r = 0, g = 0, b = 0;
};

constexpr Rgb operator+(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Rgb operator*(float s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }
constexpr Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Rgb mix(Rgb a, Rgb b, float t) { return (1 - t) * a + t * b; }

Srgb8 to_srgb8(Rgb c);
Rgb from_srgb8(Srgb8 c);
std::string hex(Rgb c); // "#rrggbb"

// The colour with lightness 0 to 1, chroma 0 to 0.4 and hue in degrees, clipped to the range of sRGB.
Rgb oklch(double lightness, double chroma, double hue);

// The colour ramp for amounts, t from 0 to 1: dark blue to yellow, with evenly rising lightness.
Rgb ramp(double t);

// The colour of the numbered thing `i`. Hues step by the golden angle, so neighbours differ most.
Rgb distinct(std::size_t i);

} // namespace filum::render
