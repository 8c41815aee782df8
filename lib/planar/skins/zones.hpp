// Which settings hold in which part of a layer.
#pragma once

#include "skins/skins.hpp"

namespace filum::skins {

// The zones of a region: its parts with other walls or bead widths than those of its outer wall.
struct RegionZones {
    std::uint32_t walls = 0;          // rings along the whole outline
    std::vector<polygon::Area> zones; // with walls and bead widths of their own; none if the whole region is alike
    std::vector<std::size_t> kind;    // the kind of each zone
    bool mixed = false;               // some bead width differs from that of the outer wall
    // where a modifier has a bead width that the region does not take, since it has one of its own; empty: nowhere
    polygon::Loops idle_width;
};

// The zones of all layers. Setting 0 is that of the part, setting k that of the k-th modifier. Where modifiers overlap,
// the last one counts. Settings with equal walls and equal bead widths are of one kind.
class Zones {
  public:
    // `layers`: the number of layers of the part.
    Zones(const Options& part, std::span<const Modifier> modifiers, std::size_t layers);

    // True if some setting has another bead width than the part's outer wall.
    [[nodiscard]] bool widths_differ() const;

    // The zones of `region`: one for each kind that has room for a bead in it. A kind that needs no walls and no bead
    // width of its own gets none. The region keeps as many walls as the kind with the fewest. If the widths of walls
    // differ it keeps one wall, the outer one. The zones have the remaining walls. A region with a bead width of its
    // own has zones for other walls only.
    [[nodiscard]] RegionZones cut(const polygon::Region& region) const;

    // The part of `area` where `setting` holds, in a region with the zones `cut`. A modifier of the part's kind keeps
    // one bead away from the border, and so does the part: a wall fits between them. Settings of other kinds stay
    // inside the walls of their zone.
    [[nodiscard]] polygon::Loops of(std::size_t setting, const polygon::Region& region, const RegionZones& cut,
                                    const polygon::Loops& area) const;

  private:
    struct Kind {
        std::int64_t walls;
        double width; // mm, of the walls inside the outer one
        double solid; // mm, of solid areas
        double lines; // mm, of sparse areas
        bool operator==(const Kind&) const = default;
    };
    static Kind kind(const Options& options);
    [[nodiscard]] bool has_own_width(const Kind& kind) const { return kind.width != outer_ || kind.solid != outer_; }

    double outer_ = 0;                                // mm, width of the outer wall
    std::vector<Kind> kinds_;                         // that of the part is first
    std::vector<std::size_t> kind_of_;                // per setting
    std::vector<std::vector<polygon::Loops>> inside_; // per kind and layer: the area of its modifiers; empty for kind 0
    std::vector<polygon::Loops> beyond_;              // per layer: where the setting of the part does not hold
    std::vector<std::vector<polygon::Loops>> deep_;   // per modifier and layer: where its setting holds
};

} // namespace filum::skins
