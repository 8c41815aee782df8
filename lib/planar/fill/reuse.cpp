#include "fill/reuse.hpp"

#include "base/mix.hpp"
#include "toolpath/identify.hpp"

#include <bit>

namespace filum::fill {

namespace {

std::uint64_t key_of(const polygon::Loops& loops, double layer) {
    std::uint64_t h = 0;
    const auto add = [&](std::uint64_t bits) { h = mixed((h ^ bits) + kMixStep); };
    add(std::bit_cast<std::uint64_t>(layer));
    for (const std::uint32_t s : loops.start) add(s);
    for (const geom::Vec2 p : loops.points) {
        add(std::bit_cast<std::uint64_t>(p.x));
        add(std::bit_cast<std::uint64_t>(p.y));
    }
    return h;
}

} // namespace

Reuse::Reuse(Options options, std::size_t most)
    : Reuse([options](const polygon::Region& region, Notes& notes) { return fill(region, options, notes); },
            [angles = options.angles_deg](std::uint32_t layer) {
                return angles.empty() ? 0 : angles[layer % angles.size()];
            },
            most) {}

std::shared_ptr<Reuse::Filled> Reuse::find(const polygon::Region& region) {
    auto fresh = std::make_shared<Filled>();
    fresh->loops = region.loops;
    fresh->layer = of_layer_(region.layer);
    fresh->key = key_of(fresh->loops, fresh->layer);
    const std::scoped_lock lock(mutex_);
    const auto before = filled_.try_emplace(fresh->key, fresh).first->second;
    const bool same = before->layer == fresh->layer && before->loops.start == fresh->loops.start &&
                      before->loops.points == fresh->loops.points; // keys may be equal by chance
    return same ? before : fresh;
}

void Reuse::work_out(const polygon::Region& region, const std::shared_ptr<Filled>& filled) {
    const std::scoped_lock lock(filled->mutex);
    if (filled->done) return;
    filled->paths = work_(region, filled->notes);
    filled->points = filled->loops.points.size();
    for (const auto& c : filled->paths.curves) filled->points += c.points.size();
    for (const auto& s : filled->paths.stacked) filled->points += s.size();
    filled->done = true;
    hold(filled);
}

void Reuse::hold(const std::shared_ptr<Filled>& filled) {
    const std::scoped_lock lock(mutex_);
    done_.push_back(filled);
    held_ += filled->points;
    for (; held_ > most_; done_.pop_front()) {
        const Filled& oldest = *done_.front();
        held_ -= oldest.points;
        const auto it = filled_.find(oldest.key);
        if (it != filled_.end() && it->second == done_.front()) filled_.erase(it);
    }
}

toolpath::RegionPaths Reuse::operator()(const polygon::Region& region, Notes& notes) {
    const auto filled = find(region);
    work_out(region, filled);
    toolpath::RegionPaths paths = filled->paths;
    toolpath::identify(paths, region);
    for (Note n : filled->notes) {
        n.layer = region.layer;
        notes.push_back(std::move(n));
    }
    return paths;
}

} // namespace filum::fill
