#include "render/font.hpp"

#include "base/embed.hpp"
#include "base/error.hpp"

#include <cairo-ft.h>
#include <ft2build.h>
#include FT_FREETYPE_H

FILUM_EMBED(font, FILUM_FONT);

namespace filum::render {

namespace {

constexpr double kCapital = 1493.0 / 2048; // height of a capital of DejaVu Sans, in font sizes

class Font {
  public:
    Font() {
        const std::string_view file = FILUM_EMBEDDED(font);
        if (FT_Init_FreeType(&library_) != 0 ||
            FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(file.data()),
                               static_cast<FT_Long>(file.size()), 0, &outlines_) != 0)
            throw Error(Exit::failure, "cannot draw the picture: FreeType does not read its font");
        face_ = cairo_ft_font_face_create_for_ft_face(outlines_, FT_LOAD_NO_HINTING);
        // Outlines without hints have the same shape on every machine.
        options_ = cairo_font_options_create();
        cairo_font_options_set_antialias(options_, CAIRO_ANTIALIAS_GRAY);
        cairo_font_options_set_hint_style(options_, CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options_, CAIRO_HINT_METRICS_OFF);
    }
    void use(cairo_t* cairo, double size) const {
        cairo_set_font_face(cairo, face_);
        cairo_set_font_options(cairo, options_);
        cairo_set_font_size(cairo, size / kCapital);
    }

  private: // cairo keeps the face until the program ends
    FT_Library library_ = nullptr;
    FT_Face outlines_ = nullptr;
    cairo_font_face_t* face_ = nullptr;
    cairo_font_options_t* options_ = nullptr;
};

} // namespace

void use_font(cairo_t* cairo, double size) {
    static const Font font;
    font.use(cairo, size);
}

} // namespace filum::render
