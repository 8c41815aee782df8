// Pores of a scaffold that change along z, as the user types them.
#pragma once

#include <string>
#include <vector>

namespace filum::fill::scaffold {

struct Gradient {
    struct Stop {
        double z = 0, value = 0; // z in mm
    };
    std::vector<Stop> stops; // ascending z; none: not given

    [[nodiscard]] bool given() const { return !stops.empty(); }
    // The value at a height: linear between two stops, and that of the nearest one beyond them. Requires given().
    [[nodiscard]] double at(double z) const;
};

// Parses "60" (the same everywhere) or "40@0,80@10" (40 at z = 0, 80 at z = 10 mm, linear between); "" gives no stops.
// Throws Error(usage) for text that is neither, values outside `least` to `most`, and heights that do not ascend.
// `name`: the option, for the message.
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
    // The distance of strands that are `width` mm wide, at a height: they fill width / spacing of the volume. Requires
    // given().
    [[nodiscard]] double spacing(double width, double z) const {
        return porosity_.given() ? width / (1 - porosity_.at(z) / 100) : size_.at(z) + width;
    }

  private:
    Gradient size_, porosity_;
};

} // namespace filum::fill::scaffold
