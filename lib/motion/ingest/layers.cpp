#include "ingest/layers.hpp"

#include <algorithm>
#include <cmath>

namespace filum::ingest {

namespace {

constexpr double kMicro = 1000; // steps per mm: levels in the same um are one

} // namespace

void Layers::take(const Remark& remark) {
    if (remark.height) said_ = *remark.height;
    if (!remark.layer) return;
    if (remark.layer_index)
        index_ = static_cast<std::uint32_t>(*remark.layer_index - traits_->lowest_layer);
    else if (begun_)
        ++index_;
    begun_ = true;
}

void Layers::level(double z) {
    const auto at = static_cast<std::int64_t>(std::llround(z * kMicro));
    const auto found = levels_.try_emplace(at, static_cast<std::uint32_t>(levels_.size())).first;
    const double below = found == levels_.begin() ? 0 : static_cast<double>(std::prev(found)->first) / kMicro;
    if (z > below) height_ = z - below;
    if (!traits_->layers) index_ = found->second;
    z_ = z;
}

void Layers::bead(double from_z, double z) {
    if (from_z == z) {
        if (z_ != z) level(z);
    } else if (height() == 0) {
        level(std::min(from_z, z));
    } else if (const double h = height();
               h > 0 && (!z_ || std::llround(z * kMicro) >= std::llround((*z_ + h) * kMicro))) {
        const double kept = height_;
        level(z);
        height_ = kept;
    }
}

} // namespace filum::ingest
