// Numbers from a seed, the same on every machine.
#pragma once

#include "geom/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace filum::trials {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double unit() { return static_cast<double>(engine_() >> 11) / 9007199254740992.0; } // [0, 1)
    double in(double lo, double hi) { return lo + (hi - lo) * unit(); }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(unit() * static_cast<double>(n)); }
    bool chance(double share) { return unit() < share; }
    template <class T>
    const T& of(const std::vector<T>& choices) {
        return choices[below(choices.size())];
    }
    geom::Vec3 direction() { // unit
        while (true) {
            const geom::Vec3 v{in(-1, 1), in(-1, 1), in(-1, 1)};
            if (const double l = norm(v); l > 0.1 && l < 1) return 1 / l * v;
        }
    }

  private:
    std::mt19937_64 engine_;
};

} // namespace filum::trials
