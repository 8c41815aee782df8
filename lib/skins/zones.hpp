// Where in a part which settings hold.
#pragma once

#include "skins/skins.hpp"

namespace filum::skins {

// What a region is cut into, as other walls or beads hold in parts of it.
struct Cut {
    std::uint32_t walls = 0;          // rings along the whole outline
    std::vector<polygon::Area> zones; // with walls and beads of their own; none if all of it has the same
    std::vector<std::size_t> kind;    // of each zone
    bool mixed = false;               // not all of its beads are as wide as the part's
};

// Setting 0 is the part's, setting k that of the k-th modifier; where several modifiers overlap the last one counts.
// Settings with as many walls and as wide beads are of one kind.
class Zones {
  public:
    // `layers`: how many the part has.
    Zones(const Options& part, std::span<const Modifier> modifiers, std::size_t layers);

    // Whether settings differ in the width of beads.
    [[nodiscard]] bool widths_differ() const;

    // A zone of each kind that has room for a bead in the region, but for those that have nothing of their own.  The
    // region keeps the fewest walls of any kind in it, or one if beads differ, as wide as the part's; zones have the
    // others.
    [[nodiscard]] Cut cut(const polygon::Region& region) const;

    // What of `area` in a region so cut is of a setting.  Those of the part's kind keep a bead from the border with the
    // part's, and that as much from theirs: what is left over there is a wall.  Others keep within their zone's walls.
    [[nodiscard]] polygon::Loops of(std::size_t setting, const polygon::Region& region, const Cut& cut,
                                    const polygon::Loops& area) const;

  private:
    struct Kind {
        std::int64_t walls;
        double width; // mm
    };
    std::vector<Kind> kinds_;                         // the part's first
    std::vector<std::size_t> kind_of_;                // per setting
    std::vector<std::vector<polygon::Loops>> inside_; // per kind and layer: in its modifiers; none of the part's
    std::vector<polygon::Loops> beyond_;              // per layer: what is not for the part's setting
    std::vector<std::vector<polygon::Loops>> deep_;   // per modifier and layer: what is for its setting
};

} // namespace filum::skins
