#include "render/canvas.hpp"

#include "base/error.hpp"
#include "render/font.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cstring>

namespace filum::render {

namespace {

constexpr double kPoints = 72 / 25.4; // points per mm: cairo measures SVG and PDF pages in points

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw Error(Exit::failure, std::string("cannot draw the picture: ") + cairo_status_to_string(status));
}

cairo_status_t append(void* to, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* surface(Format format, std::string& bytes, double width, double height, double to_points) {
    if (format == Format::png)
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height));
    const double w = width * to_points, h = height * to_points;
    cairo_surface_t* out = format == Format::svg ? cairo_svg_surface_create_for_stream(append, &bytes, w, h)
                                                 : cairo_pdf_surface_create_for_stream(append, &bytes, w, h);
    if (format == Format::svg) cairo_svg_surface_set_document_unit(out, CAIRO_SVG_UNIT_PT);
    // The date of the drawing would make the bytes of equal pictures differ.
    if (format == Format::pdf) cairo_pdf_surface_set_metadata(out, CAIRO_PDF_METADATA_CREATE_DATE, "");
    return out;
}

} // namespace

struct Canvas::Page {
    Format format;
    double scale; // cairo's units per pixel
    std::string bytes;
    cairo_surface_t* surface;

    Page(Format f, int width, int height, double pixels_per_mm)
        : format(f), scale(f == Format::png ? 1 : kPoints / pixels_per_mm),
          surface(render::surface(f, bytes, width, height, scale)) {
        check(cairo_surface_status(surface));
    }
    ~Page() { cairo_surface_destroy(surface); }
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;
};

struct Canvas::Brush {
    cairo_t* cairo;

    explicit Brush(cairo_surface_t* surface) : cairo(cairo_create(surface)) { check(cairo_status(cairo)); }
    ~Brush() { cairo_destroy(cairo); }
    Brush(const Brush&) = delete;
    Brush& operator=(const Brush&) = delete;
};

Canvas::Canvas(int width, int height, Format format, double pixels_per_mm)
    : Canvas(std::make_shared<Page>(format, width, height, pixels_per_mm), 0, 0, width, height) {
    box({0, 0}, {static_cast<double>(width), static_cast<double>(height)}, {1, 1, 1});
}

Canvas::Canvas(std::shared_ptr<Page> page, int x, int y, int width, int height)
    : page_(std::move(page)), brush_(std::make_shared<Brush>(page_->surface)), width_(width), height_(height) {
    cairo_t* cairo = brush_->cairo;
    cairo_scale(cairo, page_->scale, page_->scale);
    cairo_translate(cairo, x, y);
    cairo_rectangle(cairo, 0, 0, width, height);
    cairo_clip(cairo);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
}

Canvas Canvas::part(int x, int y, int width, int height) const {
    double x0 = x, y0 = y;
    cairo_user_to_device(brush_->cairo, &x0, &y0);
    return {page_, static_cast<int>(std::lround(x0 / page_->scale)), static_cast<int>(std::lround(y0 / page_->scale)),
            width, height};
}

bool Canvas::vector() const { return page_->format != Format::png; }

void Canvas::ink(Rgb colour, double alpha) {
    const Srgb8 s = to_srgb8(colour);
    cairo_set_source_rgba(brush_->cairo, s.r / 255.0, s.g / 255.0, s.b / 255.0, alpha);
}

void Canvas::image(const Image& image) {
    const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_RGB24, image.width);
    std::vector<unsigned char> pixels(static_cast<std::size_t>(stride) * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Srgb8 c = image.pixel(x, y);
            const std::uint32_t word = std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | c.b;
            std::memcpy(&pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(stride) +
                                4 * static_cast<std::size_t>(x)],
                        &word, 4);
        }
    cairo_surface_t* source =
        cairo_image_surface_create_for_data(pixels.data(), CAIRO_FORMAT_RGB24, image.width, image.height, stride);
    cairo_set_source_surface(brush_->cairo, source, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(brush_->cairo), CAIRO_FILTER_NEAREST);
    cairo_paint(brush_->cairo);
    cairo_set_source_rgb(brush_->cairo, 0, 0, 0); // lets go of the source
    cairo_surface_finish(source);
    cairo_surface_destroy(source);
}

void Canvas::stroke(const Pen& pen) {
    ink(pen.colour, pen.alpha);
    cairo_set_line_width(brush_->cairo, pen.width);
    cairo_set_dash(brush_->cairo, &pen.dash, pen.dash > 0 ? 1 : 0, 0);
    cairo_stroke(brush_->cairo);
}

void Canvas::line(geom::Vec2 a, geom::Vec2 b, const Pen& pen) {
    cairo_move_to(brush_->cairo, a.x, a.y);
    cairo_line_to(brush_->cairo, b.x, b.y);
    stroke(pen);
}

void Canvas::polyline(std::span<const geom::Vec2> points, bool closed, const Pen& pen) {
    for (const geom::Vec2 p : points) cairo_line_to(brush_->cairo, p.x, p.y);
    if (closed) cairo_close_path(brush_->cairo);
    stroke(pen);
}

void Canvas::box(geom::Vec2 from, geom::Vec2 to, Rgb colour) {
    cairo_rectangle(brush_->cairo, from.x, from.y, to.x - from.x, to.y - from.y);
    fill(colour);
}

void Canvas::loop(std::span<const geom::Vec2> points) {
    cairo_new_sub_path(brush_->cairo);
    for (const geom::Vec2 p : points) cairo_line_to(brush_->cairo, p.x, p.y);
    cairo_close_path(brush_->cairo);
}

void Canvas::fill(Rgb colour) {
    ink(colour, 1);
    cairo_fill(brush_->cairo);
}

void Canvas::text(geom::Vec2 at, double size, std::string_view text, Rgb colour) {
    use_font(brush_->cairo, size);
    ink(colour, 1);
    cairo_move_to(brush_->cairo, at.x, at.y);
    cairo_show_text(brush_->cairo, std::string(text).c_str());
    cairo_new_path(brush_->cairo);
}

double Canvas::text_width(double size, std::string_view text) const {
    use_font(brush_->cairo, size);
    cairo_text_extents_t extents;
    cairo_text_extents(brush_->cairo, std::string(text).c_str(), &extents);
    return extents.x_advance;
}

std::string Canvas::bytes() {
    check(cairo_status(brush_->cairo));
    if (page_->format == Format::png) {
        check(cairo_surface_write_to_png_stream(page_->surface, append, &page_->bytes));
    } else {
        cairo_surface_finish(page_->surface);
        check(cairo_surface_status(page_->surface));
    }
    return std::move(page_->bytes);
}

} // namespace filum::render
