#include "fill/scaffold/gradient.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>

namespace filum::fill::scaffold {

double Gradient::at(double z) const {
    const auto above = std::find_if(stops.begin(), stops.end(), [z](const Stop& s) { return s.z > z; });
    if (above == stops.begin()) return stops.front().value;
    if (above == stops.end()) return stops.back().value;
    const Stop &a = *std::prev(above), &b = *above;
    return a.value + (b.value - a.value) * (z - a.z) / (b.z - a.z);
}

Gradient parse_gradient(const std::string& text, const std::string& name, double least, double most) {
    const auto refuse = [&](const std::string& why) {
        throw Error(Exit::usage, "cannot use '" + text + "' for --" + name + ": " + why +
                                     "; give one number, or VALUE@Z,VALUE@Z with ascending heights in mm");
    };
    Gradient out;
    for (std::size_t from = 0; from < text.size() || (from == text.size() && from > 0);) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        const std::string item = text.substr(from, end - from);
        const auto divider = item.find('@');
        const double value = parse_number(item.substr(0, divider), "--" + name);
        const double z = divider == std::string::npos ? 0 : parse_number(item.substr(divider + 1), "--" + name);
        if (divider == std::string::npos && (from > 0 || end < text.size())) refuse("'" + item + "' has no height");
        if (!(value >= least && value <= most))
            refuse("a value is between " + shortest_text(least) + " and " + shortest_text(most));
        if (!out.stops.empty() && !(z > out.stops.back().z)) refuse("'" + item + "' is not above the height before it");
        out.stops.push_back({z, value});
        from = end + 1;
    }
    return out;
}

} // namespace filum::fill::scaffold
