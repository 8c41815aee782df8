#include "fill/scaffold/gradient.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::fill::scaffold {

namespace {

const std::vector<std::string> kVariables{"x", "y", "z", "r"};
constexpr std::size_t kX = 0, kY = 1, kR = 3; // numbers of variables

} // namespace

bool Gradient::within_layers() const {
    return formula.given() && (formula.uses(kX) || formula.uses(kY) || formula.uses(kR));
}

double Gradient::at(const geom::Vec3& p, bool strict) const {
    if (formula.given()) {
        const std::array<double, 4> place{p.x, p.y, p.z, std::hypot(p.x, p.y)};
        const double value = formula(place);
        if (value >= least && value <= most) return value;
        if (!strict) return value > most ? most : least;
        throw Error(Exit::usage, "cannot use '" + formula.text() + "' for --" + name +
                                     ": at x = " + fixed_text(p.x, 2) + ", y = " + fixed_text(p.y, 2) +
                                     ", z = " + fixed_text(p.z, 2) + " it is " + fixed_text(value, 4) +
                                     ", not between " + shortest_text(least) + " and " + shortest_text(most) +
                                     "; bound it by min() and max()");
    }
    const auto above = std::find_if(stops.begin(), stops.end(), [&](const Stop& s) { return s.z > p.z; });
    if (above == stops.begin()) return stops.front().value;
    if (above == stops.end()) return stops.back().value;
    const Stop &a = *std::prev(above), &b = *above;
    return a.value + (b.value - a.value) * (p.z - a.z) / (b.z - a.z);
}

Gradient parse_gradient(const std::string& text, const std::string& name, double least, double most) {
    const auto refuse = [&](const std::string& why) {
        throw Error(Exit::usage, "cannot use '" + text + "' for --" + name + ": " + why +
                                     "; give one number, VALUE@Z,VALUE@Z with ascending heights in mm, or a formula of "
                                     "x, y, z and r");
    };
    Gradient out;
    out.name = name;
    out.least = least;
    out.most = most;
    const bool operators = text.find('@') == std::string::npos && text.find_first_of("xyzrp(*/^") != std::string::npos;
    if (operators) {
        out.formula = Formula(text, kVariables, name);
        return out;
    }
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
