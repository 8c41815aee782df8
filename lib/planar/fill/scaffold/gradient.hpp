// Pores of a scaffold that change with the place, as the user types them.
#pragma once

#include "fill/scaffold/formula.hpp"
#include "geom/vec.hpp"

#include <string>
#include <vector>

namespace filum::fill::scaffold {

struct Gradient {
    struct Stop {
        double z = 0, value = 0; // z in mm
    };
    std::vector<Stop> stops; // ascending z; none: not given
    Formula formula;         // of x, y, z and r; replaces the stops
    std::string name;        // the option, for messages
    double least = 0, most = 0;

    [[nodiscard]] bool given() const { return !stops.empty() || formula.given(); }
    // Whether the value differs within a layer.
    [[nodiscard]] bool within_layers() const;
    // The value at a place: linear between two stops, and that of the nearest one beyond them. Requires given(). Where
    // the formula is outside of `least` to `most`, it is Error(usage) if `strict`, else the nearer of both.
    [[nodiscard]] double at(const geom::Vec3& place, bool strict) const;
};

// Parses "60" (the same everywhere), "40@0,80@10" (40 at z = 0, 80 at z = 10 mm, linear between), or a formula of the
// place, as "0.3 + 0.02 * r"; "" gives no stops. Throws Error(usage) for text that is none of these, values outside
// `least` to `most`, and heights that do not ascend. `name`: the option, for the message.
Gradient parse_gradient(const std::string& text, const std::string& name, double least, double most);

// The pores of a scaffold: their size in mm or the empty share of the volume in %, as the options --pore-size and
// --porosity give them.
class Pores {
  public:
    // Throws Error(usage) as parse_gradient() does.
    Pores(const std::string& size, const std::string& porosity)
        : size_(parse_gradient(size, "pore-size", 0.001, 1e6)), porosity_(parse_gradient(porosity, "porosity", 1, 99)) {
    }

    [[nodiscard]] bool given() const { return size_.given() || porosity_.given(); }
    [[nodiscard]] bool within_layers() const { return size_.within_layers() || porosity_.within_layers(); }
    // Whether the empty share was given, not the size.
    [[nodiscard]] bool by_share() const { return porosity_.given(); }
    // The distance of strands that are `width` mm wide, at a place: they fill width / spacing of the volume. Requires
    // given(). `strict` as in Gradient::at().
    [[nodiscard]] double spacing(double width, const geom::Vec3& place, bool strict) const {
        return porosity_.given() ? width / (1 - porosity_.at(place, strict) / 100) : size_.at(place, strict) + width;
    }

  private:
    Gradient size_, porosity_;
};

} // namespace filum::fill::scaffold
