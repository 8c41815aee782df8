#include "report/assets.hpp"

#include "base/embed.hpp"
#include "base/error.hpp"

#include <string>

FILUM_EMBED(style, FILUM_PAGE "/style.css");
FILUM_EMBED(body, FILUM_PAGE "/body.html");
FILUM_EMBED(data, FILUM_PAGE "/data.js");
FILUM_EMBED(colours, FILUM_PAGE "/colours.js");
FILUM_EMBED(detail, FILUM_PAGE "/detail.js");
FILUM_EMBED(beads, FILUM_PAGE "/beads.js");
FILUM_EMBED(view, FILUM_PAGE "/view.js");
FILUM_EMBED(layer, FILUM_PAGE "/layer.js");
FILUM_EMBED(panel, FILUM_PAGE "/panel.js");
FILUM_EMBED(main, FILUM_PAGE "/main.js");
FILUM_EMBED(three, FILUM_THREE_JS);

namespace filum::report {

std::string_view asset(std::string_view name) {
    if (name == "style.css") return FILUM_EMBEDDED(style);
    if (name == "body.html") return FILUM_EMBEDDED(body);
    if (name == "data.js") return FILUM_EMBEDDED(data);
    if (name == "colours.js") return FILUM_EMBEDDED(colours);
    if (name == "detail.js") return FILUM_EMBEDDED(detail);
    if (name == "beads.js") return FILUM_EMBEDDED(beads);
    if (name == "view.js") return FILUM_EMBEDDED(view);
    if (name == "layer.js") return FILUM_EMBEDDED(layer);
    if (name == "panel.js") return FILUM_EMBEDDED(panel);
    if (name == "main.js") return FILUM_EMBEDDED(main);
    if (name == "three.js") return FILUM_EMBEDDED(three);
    throw Error(Exit::failure, "internal error: no asset '" + std::string(name) + "'");
}

} // namespace filum::report
