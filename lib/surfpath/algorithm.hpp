// The algorithms that cover a surface.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace filum::surfpath {

enum class Algorithm : std::uint8_t { fina, fexa, ortheo, geo_fiso, geo_contour, geo_spiral, field, hybrid };

// The field of vectors that `field` follows, if a sheet carries it.
inline constexpr const char* kDirection = "direction";

// As users and streams have them, in that order.
inline constexpr std::array kAlgorithms{"fina",        "fexa",       "ortheo", "geo-fiso",
                                        "geo-contour", "geo-spiral", "field",  "hybrid"};

inline const char* name(Algorithm a) { return kAlgorithms[static_cast<std::size_t>(a)]; }

// Whether its lines run round something: rims, or a point.
inline bool runs_round(Algorithm a) {
    return a == Algorithm::geo_fiso || a == Algorithm::geo_contour || a == Algorithm::geo_spiral ||
           a == Algorithm::hybrid;
}

// None for a name that is none of them.
inline std::optional<Algorithm> algorithm(const std::string& name) {
    for (std::size_t k = 0; k < kAlgorithms.size(); ++k)
        if (name == kAlgorithms[k]) return static_cast<Algorithm>(k);
    return std::nullopt;
}

} // namespace filum::surfpath
