#include "link3d/ramp.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

// Splits a bead at the given places along it, and into pieces of at most `step` mm on its ramps.
struct Splitter {
    const Bead& bead;
    std::vector<double> marks; // mm along the bead, ascending
    double step;

    // Calls visit(point, width, mm along the bead) for every point.
    template <class Visit>
    void run(double rise, double fall, Visit visit) const {
        const auto width = [&](std::size_t i) { return bead.width.size() == 1 ? bead.width[0] : bead.width[i]; };
        double s = 0;
        visit(bead.points[0], width(0), 0.0);
        for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
            const double l = geom::distance(bead.points[i], bead.points[i + 1]);
            std::vector<double> cuts;
            for (const double m : marks)
                if (m > s + kLeast && m < s + l - kLeast) cuts.push_back(m - s);
            cuts.push_back(l);
            double before = 0;
            for (const double c : cuts) {
                const bool on = s + before < rise - kLeast || s + c > fall + kLeast;
                const int pieces = on ? std::max(1, static_cast<int>(std::ceil((c - before) / step))) : 1;
                for (int k = 1; k <= pieces; ++k) {
                    const double at = before + (c - before) * k / pieces, t = l > 0 ? at / l : 1;
                    visit(geom::lerp(bead.points[i], bead.points[i + 1], t), width(i) + t * (width(i + 1) - width(i)),
                          s + at);
                }
                before = c;
            }
            s += l;
        }
    }

    static constexpr double kLeast = 0.02; // mm; shorter pieces of a ramp get no step of z of their own
};

} // namespace

SpatialBead lay(const Bead& bead, double z, double height, const Ramp& ramp, double step) {
    SpatialBead out;
    if (ramp.length == 0) {
        for (const auto p : bead.points) out.points.push_back({p.x, p.y, z});
        out.width = bead.width;
        out.height = {height};
        return out;
    }
    const double rise = ramp.length - ramp.lead, all = length(bead.points), fall = all - rise;
    Splitter{bead, {rise, fall}, step}.run(rise, fall, [&](Vec2 p, double w, double s) {
        const double up = std::min(1.0, (ramp.lead + s) / ramp.length);
        const double over = s > fall ? std::min(1.0, (ramp.lead + s - fall) / ramp.length) : 0;
        out.points.push_back({p.x, p.y, z - (z - ramp.from) * (1 - up)});
        out.width.push_back(w);
        out.height.push_back(height * std::max(kFaint, up - over));
    });
    return out;
}

} // namespace filum::link3d
