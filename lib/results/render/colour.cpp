#include "render/colour.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace filum::render {

namespace {

float encode(float v) {
    v = std::clamp(v, 0.0F, 1.0F);
    return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
}

float decode(float v) { return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F); }

std::uint8_t byte(float v) { return static_cast<std::uint8_t>(std::lround(255 * encode(v))); }

} // namespace

Srgb8 to_srgb8(Rgb c) { return {byte(c.r), byte(c.g), byte(c.b)}; }

Rgb from_srgb8(Srgb8 c) {
    static const auto kTable = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = decode(static_cast<float>(i) / 255);
        return t;
    }();
    return {kTable[c.r], kTable[c.g], kTable[c.b]};
}

std::string hex(Rgb c) {
    constexpr const char* kHex = "0123456789abcdef";
    const Srgb8 s = to_srgb8(c);
    std::string out = "#";
    for (const auto v : {s.r, s.g, s.b}) {
        out += kHex[v >> 4];
        out += kHex[v & 15];
    }
    return out;
}

// Ottosson, "A perceptual color space for image processing" (2020).
Rgb oklch(double lightness, double chroma, double hue) {
    const double a = chroma * std::cos(geom::radians(hue)), b = chroma * std::sin(geom::radians(hue));
    const auto cube = [](double v) { return v * v * v; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    const auto cut = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
    return {cut(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            cut(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            cut(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Rgb ramp(double t) {
    t = std::clamp(t, 0.0, 1.0);
    // The hue runs from violet over blue, teal and green to yellow, while the lightness rises evenly.
    const double hue = 292 - 192 * t, chroma = 0.135 + 0.03 * std::sin(std::numbers::pi * t);
    return oklch(0.36 + 0.49 * t, chroma, hue);
}

Rgb distinct(std::size_t i) {
    const double hue = std::fmod(232 + 137.50776 * static_cast<double>(i), 360);
    constexpr std::array kLightness = {0.68, 0.76, 0.60};
    return oklch(kLightness[(i / 5) % kLightness.size()], 0.13, hue);
}

} // namespace filum::render
