// Finds the layer and the height of each bead.
#pragma once

#include "ingest/remarks.hpp"

#include <map>
#include <optional>

namespace filum::ingest {

class Layers {
  public:
    // `height`: mm, the default where the program gives none; 0: unknown.
    Layers(const ProgramTraits& traits, double height) : traits_(&traits), usual_(height) {}

    void take(const Remark& remark);
    // Takes a bead from `from_z` to `z`. A level bead at a new z gives the height of its layer. A climbing bead keeps
    // the last height and starts a layer each time it has climbed by that height. If no height is known yet, as on the
    // slope of a purge line, the lower end of the bead gives it.
    void bead(double from_z, double z);

    [[nodiscard]] bool begun() const { return begun_ || !traits_->layers; } // true once the first layer has begun
    [[nodiscard]] std::uint32_t index() const { return index_; }
    [[nodiscard]] double height() const { return said_ > 0 ? said_ : height_ > 0 ? height_ : usual_; } // mm; 0: unknown

  private:
    void level(double z);

    const ProgramTraits* traits_;
    double usual_, said_ = 0, height_ = 0;
    std::map<std::int64_t, std::uint32_t> levels_; // z in um of each level with a bead, and the level's number
    std::optional<double> z_;                      // z of the last level bead
    std::uint32_t index_ = 0;
    bool begun_ = false;
};

} // namespace filum::ingest
