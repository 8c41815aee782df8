#include "regions/stack.hpp"

#include "parallel/parallel.hpp"

#include <iterator>
#include <utility>

namespace filum::regions {

namespace {

constexpr std::size_t kBatch = 16; // layers; enough for many threads

} // namespace

std::vector<polygon::Region> Stack::add(polygon::Layer layer, Notes& notes) {
    waiting_.push_back(std::move(layer));
    if (waiting_.size() < kBatch) return {};
    return done(notes);
}

std::vector<polygon::Region> Stack::end(Notes& notes) { return done(notes); }

void Stack::number(std::vector<std::vector<polygon::Region>>& batch) {
    for (auto& regions : batch) {
        for (polygon::Region& r : regions) {
            r.id += next_id_;
            if (r.parent >= 0) r.parent += next_id_;
        }
        next_id_ += static_cast<std::uint32_t>(regions.size());
    }
}

std::vector<polygon::Region> Stack::done(Notes& notes) {
    const std::size_t n = waiting_.size();
    std::vector<std::vector<polygon::Region>> batch(n);
    std::vector<Notes> said(n);
    const auto each = [&](auto&& f) {
        parallel::for_chunks(n, 1, threads_, [&](std::size_t k, std::size_t) { f(k); });
    };
    each([&](std::size_t k) { batch[k] = regions(waiting_[k], options_, said[k]); });
    number(batch);
    std::vector<Air> air(n);
    each([&](std::size_t k) {
        const std::int64_t under = k == 0 ? last_ : waiting_[k - 1].index;
        Ground ground{under < 0, k == 0 ? below_ : batch[k - 1]};
        if (waiting_[k].index != under + 1) ground.regions = {}; // a gap in the stack carries nothing
        air[k].reach = air_.reach;                               // only worse places than before count
        lay_on(batch[k], ground, options_, air[k]);
    });
    std::vector<polygon::Region> out;
    for (std::size_t k = 0; k < n; ++k) {
        regions::add(air_, air[k]);
        for (Note& note : said[k]) notes.push_back(std::move(note));
        last_ = waiting_[k].index;
    }
    if (n > 0) below_ = batch.back();
    for (auto& regions : batch) std::move(regions.begin(), regions.end(), std::back_inserter(out));
    waiting_.clear();
    return out;
}

} // namespace filum::regions
