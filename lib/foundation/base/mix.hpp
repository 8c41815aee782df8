// Pseudorandom numbers that are the same on every machine: for hashes, and for choices by a seed.
#pragma once

#include <cstdint>

namespace filum {

// 2^64 divided by the golden ratio, made odd: the step of splitmix64.
inline constexpr std::uint64_t kMixStep = 0x9e3779b97f4a7c15U;

// A permutation of the 64-bit numbers. Every bit depends on all bits of the input, and 0 stays 0. (Stafford's variant
// 13, the finaliser of splitmix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014.)
constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

// The number in [0, 1) given by the upper 53 bits.
constexpr double as_share(std::uint64_t bits) { return static_cast<double>(bits >> 11U) * 0x1p-53; }

// The next number of the generator splitmix64, in [0, 1). Advances `state`.
constexpr double next_share(std::uint64_t& state) { return as_share(mixed(state += kMixStep)); }

} // namespace filum
