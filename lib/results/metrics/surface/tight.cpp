#include "metrics/surface/tight.hpp"

#include "surface/curve/turns.hpp"

#include <algorithm>
#include <limits>

namespace filum::metrics::surface {

namespace {

// The part of a chain between two positions that is not in hairpins.
struct UndeclaredPart {
    double length = 0, first = 0; // mm; position of its start
};

UndeclaredPart undeclared_part(const Chain& c, double from, double to) {
    const auto after = std::upper_bound(c.along.begin() + 1, c.along.end() - 1, from);
    UndeclaredPart out;
    for (auto i = static_cast<std::size_t>(after - c.along.begin()) - 1; i < c.role.size() && c.along[i] < to; ++i) {
        if (c.role[i] == toolpath::Role::hairpin) continue;
        const double begin = std::max(from, c.along[i]), length = std::min(to, c.along[i + 1]) - begin;
        if (length > 0 && out.length == 0) out.first = begin;
        out.length += std::max(0.0, length);
    }
    return out;
}

} // namespace

TightTurns tight(const Fibres& fibres, std::span<const std::vector<Vec3>> normals, double radius) {
    TightTurns out;
    double least_undeclared = std::numeric_limits<double>::infinity();
    out.least = least_undeclared;
    for (std::size_t k = 0; k < fibres.chains.size(); ++k) {
        const Chain& c = fibres.chains[k];
        out.least = std::min(out.least, filum::surface::curve::least_radius(c.points, normals[k]));
        for (const auto& t : filum::surface::curve::tight_turns(c.points, normals[k], radius)) {
            const UndeclaredPart undeclared = undeclared_part(c, t.from, t.to);
            std::size_t stretch = 0;
            if (t.radius <= out.least) out.tightest = point_at(c, t.at, stretch);
            ++out.count;
            out.length += t.to - t.from;
            out.undeclared += undeclared.length;
            if (!(undeclared.length > 0) || t.radius >= least_undeclared) continue;
            least_undeclared = t.radius;
            stretch = 0;
            out.undeclared_at = point_at(c, undeclared.first, stretch);
        }
    }
    return out;
}

} // namespace filum::metrics::surface
