#include "regions/stack.hpp"

#include "parallel/parallel.hpp"

#include <iterator>
#include <utility>

namespace filum::regions {

namespace {

constexpr std::size_t kBatch = 16; // layers; enough for many threads

} // namespace

std::vector<polygon::Region> Stack::add(polygon::Layer layer, Notes& notes) {
    if (!waiting_.empty() && waiting_.back().front().index == layer.index) {
        waiting_.back().push_back(std::move(layer));
        return {};
    }
    std::vector<polygon::Region> out;
    if (waiting_.size() == kBatch) out = done(notes);
    waiting_.emplace_back().push_back(std::move(layer));
    return out;
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
    std::vector<Gaps> gaps(n);
    each([&](std::size_t k) { batch[k] = body_regions(waiting_[k], options_, gaps[k], said[k]); });
    number(batch);
    std::vector<Air> air(n);
    each([&](std::size_t k) {
        const std::int64_t under = k == 0 ? last_ : waiting_[k - 1].front().index;
        Ground ground{under < 0, k == 0 ? below_ : batch[k - 1]};
        if (waiting_[k].front().index != under + 1) ground.regions = {}; // a gap in the stack carries nothing
        air[k].reach = air_.reach;                                       // only worse places than before count
        lay_bodies_on(batch[k], ground, options_, air[k]);
    });
    std::vector<polygon::Region> out;
    for (std::size_t k = 0; k < n; ++k) {
        regions::add(air_, air[k]);
        gaps_.add(gaps[k]);
        for (Note& note : said[k]) notes.push_back(std::move(note));
        last_ = waiting_[k].front().index;
    }
    if (n > 0) below_ = batch.back();
    for (auto& regions : batch) std::move(regions.begin(), regions.end(), std::back_inserter(out));
    waiting_.clear();
    return out;
}

} // namespace filum::regions
