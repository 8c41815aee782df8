#include "regions/inradius.hpp"

#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::regions {

double inradius_bound(const polygon::Loops& area, double enough, double least) {
    constexpr double kArc = 0.001, kSlack = 0.0015; // mm; the erosion is rounded to arcs and to the grid
    double a = 0, p = 0;
    int holes = 0;
    for (std::size_t l = 0; l < area.size(); ++l) {
        const double s = polygon::signed_area(area[l]);
        a += s;
        p += polygon::perimeter(area[l]);
        if (s < 0) ++holes;
    }
    if (a <= 0) return 0;
    const double sure = 2 * a / (p + std::sqrt(p * p + 4 * std::numbers::pi * holes * a));
    if (sure >= enough) return sure;
    for (double r = enough; r > sure || sure < least; r = std::max(r / 2, least)) {
        if (!polygon::offset(area, -r - kSlack, kArc).empty()) return r;
        if (r <= least) return 0;
    }
    return sure;
}

} // namespace filum::regions
