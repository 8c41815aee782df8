#include "render/image.hpp"

#include "base/error.hpp"
#include "geom/segment.hpp"

#include <png.h>

#include <array>
#include <cctype>

namespace filum::render {

namespace {

[[noreturn]] void png_failed(png_structp, png_const_charp why) {
    throw Error(Exit::failure, std::string("cannot write the picture: ") + why);
}

void png_warned(png_structp, png_const_charp) {}

void png_append(png_structp png, png_bytep data, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

void png_flushed(png_structp) {}

// Polylines of a glyph on a grid of 4 x 6, as pairs of digits x y; blanks between polylines.
struct Glyph {
    char c;
    const char* lines;
};

constexpr std::array kGlyphs = {
    Glyph{'A', "0004264440 0242"},
    Glyph{'B', "00063645443303 3342413000"},
    Glyph{'C', "4536160501103041"},
    Glyph{'D', "00062644422000"},
    Glyph{'E', "46060040 0333"},
    Glyph{'F', "460600 0333"},
    Glyph{'G', "45361605011030414323"},
    Glyph{'H', "0006 4046 0343"},
    Glyph{'I', "1030 1636 2026"},
    Glyph{'J', "4641301001"},
    Glyph{'K', "0006 4603 1340"},
    Glyph{'L', "060040"},
    Glyph{'M', "0006234640"},
    Glyph{'N', "00064046"},
    Glyph{'O', "010516364541301001"},
    Glyph{'P', "00063645443303"},
    Glyph{'Q', "010516364541301001 2240"},
    Glyph{'R', "00063645443303 2340"},
    Glyph{'S', "453616050413334241301001"},
    Glyph{'T', "0646 2620"},
    Glyph{'U', "060110304146"},
    Glyph{'V', "062046"},
    Glyph{'W', "0610243046"},
    Glyph{'X', "0046 0640"},
    Glyph{'Y', "062346 2320"},
    Glyph{'Z', "06460040"},
    Glyph{'0', "010516364541301001"},
    Glyph{'1', "152620 1030"},
    Glyph{'2', "05163645440040"},
    Glyph{'3', "05163645443313 334241301001"},
    Glyph{'4', "30360242"},
    Glyph{'5', "460603334241301001"},
    Glyph{'6', "4536160501103041423303"},
    Glyph{'7', "064610"},
    Glyph{'8', "13040516364544331302011030414233"},
    Glyph{'9', "01103041453616050413 1343"},
    Glyph{'.', "2021"},
    Glyph{',', "2110"},
    Glyph{'-', "1333"},
    Glyph{'+', "1333 2224"},
    Glyph{'/', "0046"},
    Glyph{':', "2122 2425"},
    Glyph{'=', "0242 0444"},
    Glyph{'%', "0046 0605 4041"},
};

constexpr double kAdvance = 6; // grid units from glyph to glyph

} // namespace

std::string encode_png(const Image& image) {
    std::string out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, png_failed, png_warned);
    if (png == nullptr) throw Error(Exit::failure, "cannot write the picture: libpng does not start");
    png_infop info = png_create_info_struct(png);
    try {
        png_set_write_fn(png, &out, png_append, png_flushed);
        png_set_compression_level(png, 6);
        png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                     PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_write_info(png, info);
        for (int y = 0; y < image.height; ++y)
            png_write_row(png,
                          image.rgb.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * 3);
        png_write_end(png, info);
    } catch (...) {
        png_destroy_write_struct(&png, &info);
        throw;
    }
    png_destroy_write_struct(&png, &info);
    return out;
}

void draw_line(Image& image, geom::Vec2 a, geom::Vec2 b, double width, Rgb colour, double alpha) {
    const double h = width / 2 + 1, dy = b.y - a.y;
    const auto row = [&](double y) { return static_cast<int>(std::clamp(y, 0.0, static_cast<double>(image.height))); };
    const auto column = [&](double x) {
        return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(image.width)));
    };
    const int y1 = row(std::max(a.y, b.y) + h + 1);
    for (int y = row(std::min(a.y, b.y) - h); y < y1; ++y) {
        double from = 0, to = 1; // the part of the line that may touch this row
        if (dy != 0) {
            from = std::clamp((y - h - a.y) / dy, 0.0, 1.0);
            to = std::clamp((y + 1 + h - a.y) / dy, 0.0, 1.0);
            if (from > to) std::swap(from, to);
        }
        const double xa = geom::lerp(a, b, from).x, xb = geom::lerp(a, b, to).x;
        const int x1 = column(std::max(xa, xb) + h + 1);
        for (int x = column(std::min(xa, xb) - h); x < x1; ++x) {
            const double d = geom::point_segment_distance(a, b, {x + 0.5, y + 0.5});
            const double cover = alpha * std::clamp(width / 2 + 0.5 - d, 0.0, 1.0);
            if (cover > 0) image.set(x, y, mix(image.get(x, y), colour, static_cast<float>(cover)));
        }
    }
}

void draw_box(Image& image, int x0, int y0, int x1, int y1, Rgb colour, double alpha) {
    for (int y = std::max(0, y0); y < std::min(image.height, y1); ++y)
        for (int x = std::max(0, x0); x < std::min(image.width, x1); ++x)
            image.set(x, y, mix(image.get(x, y), colour, static_cast<float>(alpha)));
}

double text_width(double size, std::string_view text) { return static_cast<double>(text.size()) * kAdvance * size / 6; }

void draw_text(Image& image, geom::Vec2 at, double size, std::string_view text, Rgb colour) {
    const double unit = size / 6;
    for (const char small : text) {
        const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(small)));
        for (const Glyph& g : kGlyphs) {
            if (g.c != c) continue;
            const std::string_view lines = g.lines;
            bool pen = false;
            geom::Vec2 last;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                if (lines[i] == ' ') {
                    pen = false;
                    continue;
                }
                const geom::Vec2 p{at.x + (lines[i] - '0') * unit, at.y - (lines[i + 1] - '0') * unit};
                if (pen) draw_line(image, last, p, std::max(1.0, 0.75 * unit), colour);
                last = p;
                pen = true;
                ++i;
            }
        }
        at.x += kAdvance * unit;
    }
}

} // namespace filum::render
