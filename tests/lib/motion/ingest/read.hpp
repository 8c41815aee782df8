// A program given as text, read whole.
#pragma once

#include "ingest/reader.hpp"

#include <string>
#include <vector>

namespace ingested {

struct Result {
    std::vector<filum::toolpath::Span> spans;
    filum::ingest::ReadResult found;
};

inline Result read(const std::string& text, const filum::ingest::Options& options = {},
                   const filum::machine::Profile& profile = {}) {
    Result out;
    out.found = filum::ingest::read(text, "test", profile, options,
                                    [&](const filum::toolpath::Span& s) { out.spans.push_back(s); });
    return out;
}

inline double volume(const std::vector<filum::toolpath::Span>& spans) {
    double sum = 0;
    for (const auto& s : spans)
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i) sum += filum::toolpath::volume(s, i);
    return sum;
}

inline double length(const std::vector<filum::toolpath::Span>& spans) {
    double sum = 0;
    for (const auto& s : spans)
        for (std::size_t i = 0; s.role != filum::toolpath::Role::travel && i + 1 < s.points.size(); ++i)
            sum += distance(s.points[i], s.points[i + 1]);
    return sum;
}

// A unit of filament of 1.75 mm, mm3.
inline constexpr double kUnit = 3.14159265358979323846 * 1.75 * 1.75 / 4;

} // namespace ingested
