// Colours: linear light inside, sRGB outside, OKLCH where they are chosen (equal steps there look equal).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace filum::render {

struct Rgb { // linear
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

// Lightness 0..1, chroma 0..0.4, hue in degrees; cut off at what sRGB can show.
Rgb oklch(double lightness, double chroma, double hue);

// Dark blue to yellow, 0..1, with steady lightness: for amounts.
Rgb ramp(double t);

// Distinct colours for numbered things; neighbours differ most (hues by the golden angle).
Rgb distinct(std::size_t i);

} // namespace filum::render
