#include "cli/other_values.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

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

// The code held by the value of one option, as a text in quotes for --set; \n in it stands for a line break.
std::string code(const std::string& text) {
    std::string out = "\"";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool line_break = text.compare(i, 2, "\\n") == 0;
        if (!line_break && (text[i] == '"' || text[i] == '\\')) out += '\\';
        if (text[i] == '\n')
            out += "\\n";
        else
            out += text[i];
    }
    return out + '"';
}

// The words for --set of a size 220x220 or 220x220x250, or of the box about the corners 0x0,220x0,220x220,0x220.
std::string bed(const std::string& text, const std::string& of) {
    const auto misused = [&](const char* why) {
        throw Error(Exit::usage, "cannot use '" + text + "' for --" + of + ": " + why);
    };
    std::vector<std::vector<double>> corners;
    std::istringstream all(text);
    for (std::string corner; std::getline(all, corner, ',');) {
        std::istringstream one(corner);
        auto& numbers = corners.emplace_back();
        for (std::string part; std::getline(one, part, 'x');) numbers.push_back(parse_number(part, "--" + of));
    }
    if (corners.size() == 1) corners.insert(corners.begin(), std::vector<double>(corners[0].size(), 0));
    const std::size_t axes = corners.empty() ? 0 : corners[0].size();
    if (axes < 2 || axes > 3 || (axes == 3 && corners.size() > 2) ||
        !std::ranges::all_of(corners, [&](const auto& c) { return c.size() == axes; }))
        misused("it must be a size, as 220x220 or 220x220x250, or corners, as 0x0,220x0,220x220,0x220");
    std::string out = "--set=";
    for (std::size_t axis = 0; axis < axes; ++axis) {
        double lo = corners[0][axis], hi = lo;
        for (const auto& c : corners) {
            lo = std::min(lo, c[axis]);
            hi = std::max(hi, c[axis]);
        }
        if (!(hi > lo)) misused("a side has no length");
        out += (axis > 0 ? ",bed." : "bed.") + std::string(1, "xyz"[axis]) + "=[" + shortest_text(lo) + "," +
               shortest_text(hi) + "]";
    }
    return out;
}

// The words for --set of a fan's speed in per cent. They end the control of the fan by the time of layers.
std::string fan(const std::string& text, const std::string& of) {
    const double share = number(text, of) / 100;
    if (!(share >= 0 && share <= 1))
        throw Error(Exit::usage, "cannot use '" + text + "' for --" + of + ": it must be 0% to 100%");
    return "--set=fan=" + shortest_text(std::round(255 * share)) + ",cooling.most=-1";
}

// The seam option of Filum for a seam position of another slicer; "" for an unknown one.  Layers that continue a stroke
// begin above each other, so `nearest` aligns their seams.  Cura's `shortest` is the nearest place.
std::string seam(const std::string& option, const std::string& theirs) {
    if (theirs == "random") return "--interlace=random";
    if (theirs == "rear" || theirs == "back" || theirs == "aligned_back") return option + "=back";
    return theirs == "nearest" || theirs == "aligned" || theirs == "shortest" ? option + "=nearest" : "";
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
        return "--set=" + std::string(n.ours) + "=" + code(value);
    case Value::bed:
        return bed(value, theirs);
    case Value::fan:
        return fan(value, theirs);
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
