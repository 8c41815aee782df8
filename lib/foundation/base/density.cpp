#include "base/density.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>

namespace filum {

std::string rounded_up(double value) {
    const int decimals = 1 - static_cast<int>(std::floor(std::log10(value)));
    const double unit = std::pow(10, -decimals);
    return fixed_text(std::ceil(value / unit) * unit, std::max(0, decimals));
}

void check_density(double area, double spacing, Exit exit, std::string_view subject) {
    if (spacing > 0 && area <= kMostSquares * spacing * spacing) return;
    throw Error(exit, "cannot use '" + shortest_text(spacing) + "' for " + std::string(subject) + ": " +
                          fixed_text(area, 1) + " mm2 would hold more than " + fixed_text(kMostSquares / 1e6, 0) +
                          " million squares of that side; give at least " + rounded_up(std::sqrt(area / kMostSquares)) +
                          " mm");
}

void check_spacing(double spacing, double width, Exit exit, std::string_view subject) {
    if (spacing >= kLeastSpacing * width) return;
    throw Error(exit, "cannot use '" + shortest_text(spacing) + "' for " + std::string(subject) + ": beads " +
                          shortest_text(width) + " mm wide would lie one on the other; give at least " +
                          shortest_text(kLeastSpacing * width) + " mm");
}

} // namespace filum
