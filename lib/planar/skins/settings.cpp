// Reads the settings of a part and of modifiers, as users write them.
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/number.hpp"
#include "skins/skins.hpp"

#include <algorithm>
#include <cmath>

namespace filum::skins {

namespace {

constexpr double kNarrowestBead = 0.01, kWidestBead = 100; // mm, the limits of --bead-width

[[noreturn]] void refuse(const std::string& setting, const std::string& takes) {
    throw Error(Exit::usage, "cannot use '" + setting + "' of --modifier: it takes " + takes);
}

double number(const std::string& setting, const std::string& value, const std::string& takes) {
    try {
        return parse_number(value, "--modifier");
    } catch (const Error&) {
        refuse(setting, takes);
    }
}

// The whole number of a setting "name=value" of a modifier.
std::int64_t whole(const std::string& setting, const std::string& value, std::int64_t least) {
    const std::string takes = "a whole number of at least " + std::to_string(least);
    const double n = number(setting, value, takes);
    if (n != std::floor(n) || n < static_cast<double>(least) || n > 1e6) refuse(setting, takes);
    return static_cast<std::int64_t>(n);
}

double width(const std::string& setting, const std::string& value) {
    const std::string takes =
        "mm from " + shortest_text(kNarrowestBead) + " to " + shortest_text(kWidestBead) + ", as bead-width=0.6";
    const double out = number(setting, value, takes);
    if (out < kNarrowestBead || out > kWidestBead) refuse(setting, takes);
    return out;
}

std::string names() {
    std::string out;
    for (const std::string& name : kModifierSettings) out += (out.empty() ? "" : ", ") + name;
    return out;
}

void set(Options& o, const std::string& setting) {
    const auto equals = std::min(setting.find('='), setting.size());
    const std::string name = setting.substr(0, equals), value = setting.substr(std::min(equals + 1, setting.size()));
    if (name == "infill")
        o.infill = share(value);
    else if (name == "infill-pattern")
        o.pattern = pattern(value);
    else if (name == "walls")
        o.walls = whole(setting, value, 1);
    else if (name == "top")
        o.top = whole(setting, value, 0);
    else if (name == "bottom")
        o.bottom = whole(setting, value, 0);
    else if (name == "bead-width") {
        o.bead_width = width(setting, value);
        o.inner_width = o.infill_width = o.solid_width = 0; // all beads of the modifier have this width
    } else
        throw Error(Exit::usage, "cannot use '" + setting + "' of --modifier: a setting is one of " + names() +
                                     ", as infill=40%" + did_you_mean(name, kModifierSettings));
}

} // namespace

double share(const std::string& text) {
    const bool percent = !text.empty() && text.back() == '%';
    const double number = parse_number(percent ? text.substr(0, text.size() - 1) : text, "--infill");
    const double out = percent ? number / 100 : number;
    if (!(out >= 0 && out <= 1))
        throw Error(Exit::usage, "cannot use '" + text + "' as --infill: it is not from 0% to 100%");
    return out;
}

polygon::InfillPattern pattern(const std::string& text) {
    if (text == "rows") return polygon::InfillPattern::rows;
    if (text == "wave") return polygon::InfillPattern::wave;
    if (text == "concentric") return polygon::InfillPattern::concentric;
    throw Error(Exit::usage, "cannot use '" + text + "' as --infill-pattern: it is rows, wave or concentric");
}

Options modified(Options o, const std::string& settings) {
    for (std::size_t from = 0; from < settings.size();) {
        const std::size_t comma = std::min(settings.find(',', from), settings.size());
        set(o, settings.substr(from, comma - from));
        from = comma + 1;
    }
    return o;
}

} // namespace filum::skins
