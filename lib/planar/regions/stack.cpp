#include "regions/stack.hpp"

#include "parallel/parallel.hpp"

#include <algorithm>
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

// What lies on the layer `index` below layer k of a batch: the bed, the regions of that layer, or none.
Ground Stack::ground(const std::vector<std::vector<polygon::Region>>& batch, std::size_t k, std::int64_t index) const {
    // Nothing came before this layer, so it begins on the bed, as does a high one with the same lower side.
    if (index < first_) return {true, {}};
    for (; k-- > 0;)
        if (waiting_[k].front().index == index) return {false, batch[k]};
    const std::int64_t back = last_ - index;
    if (back >= 0 && back < static_cast<std::int64_t>(below_.size()))
        return {false, below_[below_.size() - 1 - static_cast<std::size_t>(back)]};
    return {false, {}};
}

// Keeps the regions of the layers on which later ones may rest: as many as one of them can be high. Missing layers are
// kept as empty ones.
void Stack::keep(std::vector<std::vector<polygon::Region>> batch) {
    for (std::size_t k = 0; k < batch.size(); ++k) {
        const std::int64_t index = waiting_[k].front().index;
        if (last_ >= 0 && index - last_ > polygon::kMostLayers)
            below_.clear();
        else
            for (; last_ >= 0 && last_ + 1 < index; ++last_) below_.emplace_back();
        below_.push_back(std::move(batch[k]));
        last_ = index;
        while (below_.size() > polygon::kMostLayers) below_.pop_front();
    }
}

std::vector<polygon::Region> Stack::done(Notes& notes) {
    const std::size_t n = waiting_.size();
    std::vector<std::vector<polygon::Region>> batch(n);
    std::vector<Notes> said(n);
    const auto each = [&](auto&& f) {
        parallel::for_chunks(n, 1, threads_, [&](std::size_t k, std::size_t) { f(k); });
    };
    const auto high = [](const std::vector<polygon::Layer>& layer) {
        return std::ranges::any_of(layer, [](const polygon::Layer& body) { return body.layers > 1; });
    };
    for (const auto& layer : waiting_) {
        coarse_ = coarse_ || high(layer);
        for (const polygon::Layer& body : layer) {
            const std::int64_t lower = std::int64_t{body.index} - body.layers + 1;
            first_ = first_ < 0 ? lower : std::min(first_, lower);
        }
    }
    std::vector<Gaps> gaps(n);
    each([&](std::size_t k) {
        const bool whole = !coarse_ || high(waiting_[k]); // else bodies may be missing that fill a gap
        batch[k] = body_regions(waiting_[k], options_, whole ? &gaps[k] : nullptr, said[k]);
    });
    number(batch);
    std::vector<Air> air(n);
    each([&](std::size_t k) {
        air[k].reach = air_.reach; // only worse places than before count
        lay_bodies_on(
            batch[k], [&](std::int64_t index) { return ground(batch, k, index); }, options_, air[k]);
    });
    std::vector<polygon::Region> out;
    for (std::size_t k = 0; k < n; ++k) {
        regions::add(air_, air[k]);
        gaps_.add(gaps[k]);
        for (Note& note : said[k]) notes.push_back(std::move(note));
        out.insert(out.end(), batch[k].begin(), batch[k].end());
    }
    keep(std::move(batch));
    waiting_.clear();
    return out;
}

} // namespace filum::regions
