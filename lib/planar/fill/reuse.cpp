#include "fill/reuse.hpp"

#include "polygon/content_hash.hpp"
#include "toolpath/identify.hpp"

#include <algorithm>

namespace filum::fill {

namespace {

using polygon::same;

bool same(const polygon::Area& a, const polygon::Area& b) {
    return a.kind == b.kind && a.direction == b.direction && a.spacing == b.spacing && a.pattern == b.pattern &&
           a.gap == b.gap && a.walls == b.walls && a.width == b.width && a.solid == b.solid && same(a.loops, b.loops);
}

// What the fill of a region depends on. The height is 0 if it has no influence.
polygon::Region content(const polygon::Region& r) {
    polygon::Region out;
    out.loops = r.loops;
    out.walls = r.walls;
    out.is = r.is;
    out.areas = r.areas;
    const auto depends = [](const polygon::Area& a) { return a.pattern == polygon::InfillPattern::wave; };
    if (std::any_of(r.areas.begin(), r.areas.end(), depends)) out.z = r.z;
    return out;
}

bool same(const polygon::Region& a, const polygon::Region& b) {
    return a.walls == b.walls && a.is == b.is && a.z == b.z && same(a.loops, b.loops) &&
           std::equal(a.areas.begin(), a.areas.end(), b.areas.begin(), b.areas.end(),
                      [](const polygon::Area& l, const polygon::Area& r) { return same(l, r); });
}

std::uint64_t key_of(const polygon::Region& r, double layer) {
    polygon::ContentHash h;
    h.add(layer);
    h.add(r.z);
    h.add(std::uint64_t{r.walls});
    h.add(static_cast<std::uint64_t>(r.is));
    h.add(r.loops);
    for (const polygon::Area& a : r.areas) {
        h.add(static_cast<std::uint64_t>(a.kind));
        h.add(static_cast<std::uint64_t>(a.pattern));
        h.add(std::uint64_t{a.walls});
        h.add(a.width);
        h.add(a.solid);
        h.add(a.direction);
        h.add(a.spacing);
        h.add(a.gap);
        h.add(a.loops);
    }
    return h.value();
}

std::size_t points_of(const polygon::Region& r) {
    std::size_t out = r.loops.points.size();
    for (const polygon::Area& a : r.areas) out += a.loops.points.size();
    return out;
}

} // namespace

Reuse::Reuse(Options options, std::size_t most)
    : Reuse([options](const polygon::Region& region, Notes& notes) { return fill(region, options, notes); },
            [angles = options.angles_deg](std::uint32_t layer) {
                return angles.empty() ? 0 : angles[layer % angles.size()];
            },
            most) {}

std::shared_ptr<Reuse::CachedFill> Reuse::find(const polygon::Region& region) {
    auto fresh = std::make_shared<CachedFill>();
    fresh->region = content(region);
    fresh->layer = of_layer_(region.own_layer());
    fresh->key = key_of(fresh->region, fresh->layer);
    const std::scoped_lock lock(mutex_);
    const auto before = filled_.try_emplace(fresh->key, fresh).first->second;
    const bool equal =
        before->layer == fresh->layer && same(before->region, fresh->region); // keys may be equal by chance
    return equal ? before : fresh;
}

void Reuse::work_out(const polygon::Region& region, const std::shared_ptr<CachedFill>& filled) {
    const std::scoped_lock lock(filled->mutex);
    if (filled->done) return;
    filled->paths = work_(region, filled->notes);
    filled->points = points_of(filled->region);
    for (const auto& c : filled->paths.curves) filled->points += c.points.size();
    for (const auto& s : filled->paths.stacked) filled->points += s.size();
    filled->done = true;
    hold(filled);
}

void Reuse::hold(const std::shared_ptr<CachedFill>& filled) {
    const std::scoped_lock lock(mutex_);
    done_.push_back(filled);
    held_ += filled->points;
    for (; held_ > most_; done_.pop_front()) {
        const CachedFill& oldest = *done_.front();
        held_ -= oldest.points;
        const auto it = filled_.find(oldest.key);
        if (it != filled_.end() && it->second == done_.front()) filled_.erase(it);
    }
}

Reuse& ReuseByWidth::of(double width) {
    const std::scoped_lock lock(mutex_);
    auto& fill = fills_[width];
    if (fill == nullptr) fill.reset(new Reuse(make_(width)));
    return *fill;
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
