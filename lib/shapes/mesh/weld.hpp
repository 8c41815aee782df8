// Merges vertices with equal bits, by a hash table with open addressing; private to lib/shapes/mesh.
#pragma once

#include "mesh/mesh.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace filum::mesh {

// `Word` holds the bits of one coordinate: uint32_t for float, uint64_t for double.
template <class Word>
class Weld {
  public:
    using Key = std::array<Word, 3>;

    // Up to `expected` vertices need no rehash.
    explicit Weld(std::size_t expected) : slots_(std::bit_ceil(std::max<std::size_t>(64, expected + expected / 2))) {
        vertices.reserve(expected);
    }

    std::vector<Vec3> vertices; // in order of first appearance

    static std::uint64_t hash(const Key& k) {
        std::uint64_t h = k[0] * 0x9e3779b97f4a7c15ULL;
        h = (std::rotl(h, 29) ^ k[1]) * 0xbf58476d1ce4e5b9ULL;
        h = (std::rotl(h, 31) ^ k[2]) * 0x94d049bb133111ebULL;
        return h ^ (h >> 32);
    }

    // Prefetches the slot that add() will read, as the table is far larger than the cache.
    void prefetch(std::uint64_t h) const { __builtin_prefetch(&slots_[h & (slots_.size() - 1)]); }

    // Makes room for `more` vertices.  Required before add(), which does not check.
    void reserve(std::size_t more) {
        if ((vertices.size() + more) * 4 > slots_.size() * 3) grow();
    }

    // The index of the vertex with the bits `key`; appends `v` if it is new.  `h` is hash(key).
    std::uint32_t add(const Key& key, std::uint64_t h, const Vec3& v) {
        for (std::size_t i = h & (slots_.size() - 1);; i = (i + 1) & (slots_.size() - 1)) {
            Slot& s = slots_[i];
            if (s.id == kFree) {
                s = {key, static_cast<std::uint32_t>(vertices.size())};
                vertices.push_back(v);
                return s.id;
            }
            // compared word by word, as operator== would call memcmp
            if (s.key[0] == key[0] && s.key[1] == key[1] && s.key[2] == key[2]) return s.id;
        }
    }

  private:
    static constexpr std::uint32_t kFree = ~std::uint32_t{0};
    struct Slot {
        Key key{};
        std::uint32_t id = kFree;
    };

    void grow() {
        std::vector<Slot> old(slots_.size() * 2);
        old.swap(slots_);
        for (const Slot& s : old) {
            if (s.id == kFree) continue;
            std::size_t i = hash(s.key) & (slots_.size() - 1);
            while (slots_[i].id != kFree) i = (i + 1) & (slots_.size() - 1);
            slots_[i] = s;
        }
    }

    std::vector<Slot> slots_;
};

// The bits of a vertex.  Adding 0 turns -0 into 0, so that both weld.
inline std::array<std::uint64_t, 3> bits(const Vec3& v) {
    return {std::bit_cast<std::uint64_t>(v.x + 0.0), std::bit_cast<std::uint64_t>(v.y + 0.0),
            std::bit_cast<std::uint64_t>(v.z + 0.0)};
}

} // namespace filum::mesh
