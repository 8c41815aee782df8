// The font of pictures: DejaVu Sans, which the build puts into the program, so that letters look the same everywhere.
#pragma once

#include <cairo.h>

namespace filum::render {

// Makes it the font of what is drawn next. `size` is the height of a capital in cairo's user units.
void use_font(cairo_t* cairo, double size);

} // namespace filum::render
