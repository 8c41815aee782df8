// The settings of a part and of modifiers, as users write them.
#include "base/error.hpp"
#include "base/number.hpp"
#include "skins/skins.hpp"

#include <algorithm>
#include <cmath>

namespace filum::skins {

namespace {

// The whole number of a setting "name=value" of a modifier.
std::int64_t whole(const std::string& setting, const std::string& value, std::int64_t least) {
    const double n = parse_number(value, "--modifier");
    if (n != std::floor(n) || n < static_cast<double>(least) || n > 1e6)
        throw Error(Exit::usage, "cannot use '" + setting + "' of --modifier: it takes a whole number of at least " +
                                     std::to_string(least));
    return static_cast<std::int64_t>(n);
}

// One setting; no fewer than `walls` walls.
void set(Options& o, const std::string& setting, std::int64_t walls) {
    const auto equals = std::min(setting.find('='), setting.size());
    const std::string name = setting.substr(0, equals), value = setting.substr(std::min(equals + 1, setting.size()));
    if (name == "infill")
        o.infill = share(value);
    else if (name == "infill-pattern")
        o.pattern = pattern(value);
    else if (name == "walls")
        o.walls = whole(setting, value, walls);
    else if (name == "top")
        o.top = whole(setting, value, 0);
    else if (name == "bottom")
        o.bottom = whole(setting, value, 0);
    else
        throw Error(Exit::usage, "cannot use '" + setting +
                                     "' of --modifier: a setting is one of infill, infill-pattern, walls, top, bottom, "
                                     "as infill=40%");
}

} // namespace

double share(const std::string& text) {
    const bool percent = !text.empty() && text.back() == '%';
    const double number = parse_number(percent ? text.substr(0, text.size() - 1) : text, "--infill");
    const double out = percent ? number / 100 : number;
    if (!(out > 0 && out <= 1))
        throw Error(Exit::usage, "cannot use '" + text + "' as --infill: it is not above 0% and up to 100%");
    return out;
}

polygon::Pattern pattern(const std::string& text) {
    if (text == "rows") return polygon::Pattern::rows;
    if (text == "wave") return polygon::Pattern::wave;
    if (text == "concentric") return polygon::Pattern::concentric;
    throw Error(Exit::usage, "cannot use '" + text + "' as --infill-pattern: it is rows, wave or concentric");
}

Options modified(Options o, const std::string& settings) {
    const std::int64_t walls = o.walls;
    for (std::size_t from = 0; from < settings.size();) {
        const std::size_t comma = std::min(settings.find(',', from), settings.size());
        set(o, settings.substr(from, comma - from), walls);
        from = comma + 1;
    }
    return o;
}

} // namespace filum::skins
