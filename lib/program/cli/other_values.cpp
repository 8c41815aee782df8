#include "cli/other_values.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

namespace filum::cli {

namespace {

bool percent(const std::string& text) { return !text.empty() && text.back() == '%'; }

double number(const std::string& text, const std::string& of) {
    return parse_number(percent(text) ? text.substr(0, text.size() - 1) : text, "--" + of);
}

// The pattern of Filum that replaces a pattern of another slicer: rows for straight lines, waves, or concentric lines.
// "" if there is none.
std::string pattern(const std::string& theirs) {
    for (const char* rows : {"rectilinear", "alignedrectilinear", "line", "lines", "grid", "zigzag", "zig-zag", "rows"})
        if (theirs == rows) return "rows";
    if (theirs == "concentric") return "concentric";
    return theirs == "gyroid" || theirs == "wave" ? "wave" : "";
}

// The code held by the value of one option, with
// replaced by a line break. Throws Error(usage) for text with a comma, since --set separates its keys at commas.
std::string code(const std::string& text, const std::string& of) {
    if (text.find(',') != std::string::npos)
        throw Error(Exit::usage,
                    "cannot use --" + of + ": '" + text +
                        "' holds a comma; write it as templates.start or templates.end of a profile of your "
                        "own, see docs/machines.md");
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape = text.compare(i, 2, "\\n") == 0;
        out += escape ? '\n' : text[i];
        i += escape ? 1 : 0;
    }
    return out;
}

// The seam option of Filum for a seam position of another slicer; "" for an unknown one.  Layers that continue a stroke
// begin above each other, so `nearest` aligns their seams.
std::string seam(const std::string& option, const std::string& theirs) {
    if (theirs == "random") return "--interlace=random";
    if (theirs == "rear" || theirs == "back" || theirs == "aligned_back") return option + "=back";
    return theirs == "nearest" || theirs == "aligned" ? option + "=nearest" : "";
}

// The option that scales up a part that loses `lost` % of its size in x and y, or in z. None if it loses nothing.
std::optional<std::string> shrinkage(const std::string& option, double lost, bool in_z = false) {
    if (!(lost > 0)) return std::nullopt;
    const std::string text = shortest_text(lost);
    return option + (in_z ? "=0,0," + text : "=" + text + "," + text + ",0");
}

// The % of the height that is lost. PrusaSlicer's value is the loss, at most 10 %; OrcaSlicer's value of the same name
// is the remaining height.
double lost_in_z(double value) { return value > 10 ? 100 - value : value; }

} // namespace

std::optional<std::string> our_word(const OtherName& n, const std::string& value) {
    const std::string option = "--" + std::string(n.ours), theirs(n.theirs);
    switch (n.value) {
    case Value::same:
        return option + "=" + value;
    case Value::length:
        if (percent(value) || number(value, theirs) <= 0) return std::nullopt;
        return option + "=" + value;
    case Value::share:
        return option + "=" + (percent(value) ? value : shortest_text(number(value, theirs)) + "%");
    case Value::flag:
        if (!value.empty() && value != "1") return std::nullopt;
        return option;
    case Value::steepness:
        if (number(value, theirs) <= 0) return std::nullopt;
        return option + "=" + shortest_text(90 - number(value, theirs));
    case Value::pattern:
        if (pattern(value).empty()) return std::nullopt;
        return option + "=" + pattern(value);
    case Value::seam:
        if (seam(option, value).empty()) return std::nullopt;
        return seam(option, value);
    case Value::shrinks_by:
        return shrinkage(option, number(value, theirs));
    case Value::shrinks_to:
        return shrinkage(option, 100 - number(value, theirs));
    case Value::shrinks_z:
        return shrinkage(option, lost_in_z(number(value, theirs)), true);
    case Value::key:
        if (percent(value)) return std::nullopt;
        number(value, theirs);
        return "--set=" + std::string(n.ours) + "=" + value;
    case Value::text:
        return "--set=" + std::string(n.ours) + "=" + code(value, theirs);
    case Value::bed_only:
        if (value != "1") return std::nullopt;
        return option + "=bed";
    case Value::turn_x:
        return option + "=" + value + ",0,0";
    case Value::turn_y:
        return option + "=0," + value + ",0";
    case Value::turn_z:
        return option + "=0,0," + value;
    case Value::none:
        break;
    }
    return std::nullopt;
}

} // namespace filum::cli
