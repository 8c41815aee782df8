#include "report/assets.hpp"

#include "base/error.hpp"

#include <string>

// Embeds each file between two labels by the assembler. The build defines FILUM_PAGE and FILUM_THREE_JS.
#define FILUM_ASSET(label, file)                                                                                       \
    __asm__(".section .rodata\n.global filum_asset_" #label "\nfilum_asset_" #label ":\n.incbin \"" file               \
            "\"\n.global filum_asset_" #label "_end\nfilum_asset_" #label "_end:\n.byte 0\n.previous\n");              \
    extern "C" const char filum_asset_##label[], filum_asset_##label##_end[]

FILUM_ASSET(style, FILUM_PAGE "/style.css");
FILUM_ASSET(body, FILUM_PAGE "/body.html");
FILUM_ASSET(data, FILUM_PAGE "/data.js");
FILUM_ASSET(colours, FILUM_PAGE "/colours.js");
FILUM_ASSET(beads, FILUM_PAGE "/beads.js");
FILUM_ASSET(view, FILUM_PAGE "/view.js");
FILUM_ASSET(layer, FILUM_PAGE "/layer.js");
FILUM_ASSET(panel, FILUM_PAGE "/panel.js");
FILUM_ASSET(main, FILUM_PAGE "/main.js");
FILUM_ASSET(three, FILUM_THREE_JS);

namespace filum::report {

std::string_view asset(std::string_view name) {
    const auto between = [](const char* begin, const char* end) {
        return std::string_view(begin, static_cast<std::size_t>(end - begin));
    };
    if (name == "style.css") return between(filum_asset_style, filum_asset_style_end);
    if (name == "body.html") return between(filum_asset_body, filum_asset_body_end);
    if (name == "data.js") return between(filum_asset_data, filum_asset_data_end);
    if (name == "colours.js") return between(filum_asset_colours, filum_asset_colours_end);
    if (name == "beads.js") return between(filum_asset_beads, filum_asset_beads_end);
    if (name == "view.js") return between(filum_asset_view, filum_asset_view_end);
    if (name == "layer.js") return between(filum_asset_layer, filum_asset_layer_end);
    if (name == "panel.js") return between(filum_asset_panel, filum_asset_panel_end);
    if (name == "main.js") return between(filum_asset_main, filum_asset_main_end);
    if (name == "three.js") return between(filum_asset_three, filum_asset_three_end);
    throw Error(Exit::failure, "internal error: no asset '" + std::string(name) + "'");
}

} // namespace filum::report
