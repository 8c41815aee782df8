// A page for pixels, lines, areas and letters, which becomes a PNG, SVG or PDF file (cairo).
#pragma once

#include "geom/vec.hpp"
#include "render/image.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace filum::render {

enum class Format : std::uint8_t { png, svg, pdf };

inline constexpr double kScreenPixels = 96 / 25.4; // pixels per mm of a screen, as SVG defines them

// How a line is drawn. Its ends are round.
struct Pen {
    double width = 1; // pixels
    Rgb colour;
    double alpha = 1;
    double dash = 0; // pixels: length of dashes and of the gaps between them; 0: none
};

// Coordinates are pixels, y downwards, with pixel centres at halves. Equal calls give equal bytes,
// except the numbers of names in SVG files, which cairo counts on from picture to picture of a process.
class Canvas {
  public:
    // A white page. In an SVG or PDF file it is width / pixels_per_mm mm wide. Throws Error(failure) if cairo fails.
    Canvas(int width, int height, Format format, double pixels_per_mm = kScreenPixels);

    // A part of the same page with its own origin. What is drawn on it beyond its size is cut off.
    [[nodiscard]] Canvas part(int x, int y, int width, int height) const;

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool vector() const; // whether lines stay lines in the file

    void image(const Image& image); // at the upper left corner
    void line(geom::Vec2 a, geom::Vec2 b, const Pen& pen);
    void polyline(std::span<const geom::Vec2> points, bool closed, const Pen& pen);
    void box(geom::Vec2 from, geom::Vec2 to, Rgb colour);

    // An area with holes, by the even-odd rule: call loop() for each of its outlines, then fill().
    void loop(std::span<const geom::Vec2> points);
    void fill(Rgb colour);

    // `at` is the left end of the base line, `size` the height of a capital in pixels. `text` is UTF-8.
    void text(geom::Vec2 at, double size, std::string_view text, Rgb colour);
    [[nodiscard]] double text_width(double size, std::string_view text) const; // pixels

    // The bytes of the file. Nothing can be drawn after it.
    [[nodiscard]] std::string bytes();

  private:
    struct Page;
    struct Brush; // cairo's state of drawing
    Canvas(std::shared_ptr<Page> page, int x, int y, int width, int height);
    void ink(Rgb colour, double alpha);
    void stroke(const Pen& pen);
    std::shared_ptr<Page> page_;
    std::shared_ptr<Brush> brush_;
    int width_, height_;
};

} // namespace filum::render
