// Hashes of outlines and numbers: finds what has the same content as something before.
#pragma once

#include "base/mix.hpp"
#include "polygon/loops.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace filum::polygon {

class ContentHash {
  public:
    void add(std::uint64_t bits) { value_ = mixed((value_ ^ bits) + kMixStep); }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
    void add(const Loops& loops) {
        for (const std::uint32_t s : loops.start) add(std::uint64_t{s});
        for (const Vec2 p : loops.points) {
            add(p.x);
            add(p.y);
        }
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0;
};

inline bool same(const Loops& a, const Loops& b) { return a.start == b.start && a.points == b.points; }

// For each of n things the first one that is the same, itself if there is none before. `hash(i)` is equal for things
// that are the same; same(i, k) decides.
template <class Hash, class Same>
std::vector<std::size_t> first_alike(std::size_t n, Hash&& hash, Same&& same) {
    std::vector<std::size_t> out(n);
    std::unordered_multimap<std::uint64_t, std::size_t> known;
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint64_t key = hash(i);
        auto [at, end] = known.equal_range(key);
        while (at != end && !same(at->second, i)) ++at;
        out[i] = at != end ? at->second : i;
        if (at == end) known.emplace(key, i);
    }
    return out;
}

} // namespace filum::polygon
