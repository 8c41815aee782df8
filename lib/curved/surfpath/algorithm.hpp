// The algorithms that cover a surface.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace filum::surfpath {

enum class Algorithm : std::uint8_t { fina, fexa, ortheo, geo_fiso, geo_contour, geo_spiral, field, hybrid };

// Name of the vector field on a sheet that `field` follows if it is there.
inline constexpr const char* kDirection = "direction";

// The names in options and streams, in the order of the enumeration.
inline constexpr std::array kAlgorithms{"fina",        "fexa",       "ortheo", "geo-fiso",
                                        "geo-contour", "geo-spiral", "field",  "hybrid"};

inline const char* name(Algorithm a) { return kAlgorithms[static_cast<std::size_t>(a)]; }

// Whether the algorithm's lines are closed curves around rims or around a point.
inline bool runs_round(Algorithm a) {
    return a == Algorithm::geo_fiso || a == Algorithm::geo_contour || a == Algorithm::geo_spiral ||
           a == Algorithm::hybrid;
}

// The algorithm of that name; nullopt if there is none.
inline std::optional<Algorithm> algorithm(const std::string& name) {
    for (std::size_t k = 0; k < kAlgorithms.size(); ++k)
        if (name == kAlgorithms[k]) return static_cast<Algorithm>(k);
    return std::nullopt;
}

} // namespace filum::surfpath
