// Which layer a bead belongs to, and how high it is.
#pragma once

#include "ingest/remarks.hpp"

#include <map>
#include <optional>

namespace filum::ingest {

class Layers {
  public:
    // `height`: mm, where nothing tells; 0 for unknown.
    Layers(const Told& told, double height) : told_(&told), usual_(height) {}

    void take(const Remark& remark);
    // A bead from one z to another.  A level one at a new z says how high its layer is; one that climbs goes on with
    // the height before, and is a layer higher each time that it has climbed by that.  Where no height is known, such
    // as on the slope of a purge line, its lower end says it.
    void bead(double from_z, double z);

    [[nodiscard]] bool begun() const { return begun_ || !told_->layers; } // the first layer's mark has come
    [[nodiscard]] std::uint32_t index() const { return index_; }
    [[nodiscard]] double height() const { return said_ > 0 ? said_ : height_ > 0 ? height_ : usual_; } // 0: unknown

  private:
    void level(double z);

    const Told* told_;
    double usual_, said_ = 0, height_ = 0;
    std::map<std::int64_t, std::uint32_t> levels_; // um, on which something was laid, and their numbers
    std::optional<double> z_;                      // of the last level bead
    std::uint32_t index_ = 0;
    bool begun_ = false;
};

} // namespace filum::ingest
