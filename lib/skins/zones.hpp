// Where in a part which settings hold.
#pragma once

#include "skins/skins.hpp"

namespace filum::skins {

// Setting 0 is the part's, setting k that of the k-th modifier; where several modifiers overlap the last one counts.
class Zones {
  public:
    // `layers`: how many the part has; two zones keep `apart` mm from their border, each.
    Zones(std::span<const Modifier> modifiers, std::size_t layers, double apart);

    // What of `area` is of a setting, away from its border: what is left over between two zones is a wall.
    [[nodiscard]] polygon::Loops of(std::size_t setting, std::uint32_t layer, const polygon::Loops& area) const;

  private:
    std::vector<polygon::Loops> beyond_;            // per layer: what is too near to a modifier for the part's setting
    std::vector<std::vector<polygon::Loops>> deep_; // per modifier and layer: what is deep enough in it
};

} // namespace filum::skins
