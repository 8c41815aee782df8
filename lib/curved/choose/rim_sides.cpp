#include "choose/rim_sides.hpp"

#include <algorithm>

namespace filum::choose {

namespace {

constexpr double kTurn = 0.866;     // cosine of 30 degrees
constexpr double kReach = 1.0 / 40; // of the rim's length

// A rim as points with arc lengths.
struct RimLine {
    std::vector<Vec3> points;
    std::vector<double> ways; // one more than points

    [[nodiscard]] Vec3 at(double way) const {
        const double all = ways.back();
        way = std::fmod(way + all, all);
        const auto after = std::upper_bound(ways.begin(), ways.end(), way);
        const auto i = std::min(static_cast<std::size_t>(after - ways.begin()) - 1, points.size() - 1);
        const double part = (way - ways[i]) / (ways[i + 1] - ways[i]);
        return points[i] + part * (points[(i + 1) % points.size()] - points[i]);
    }
};

RimLine loop(const Surface& s, const surface::Rim& rim) {
    RimLine out{{}, {0}};
    for (const std::uint32_t h : rim.sides) {
        out.points.push_back(s.vertices[s.tail(h)]);
        out.ways.push_back(out.ways.back() + surface::side_length(s, h));
    }
    return out;
}

// The points where the rim turns more than anywhere within reach.
std::vector<std::size_t> corners(const RimLine& rim) {
    const double all = rim.ways.back(), reach = kReach * all;
    const std::size_t n = rim.points.size();
    std::vector<double> straight(n); // cosine of the turn
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 in = rim.points[i] - rim.at(rim.ways[i] - reach), on = rim.at(rim.ways[i] + reach) - rim.points[i];
        straight[i] = dot(in, on) / std::max(norm(in) * norm(on), 1e-300);
    }
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < n; ++i) {
        bool sharpest = straight[i] < kTurn;
        for (std::size_t j = 0; sharpest && j < n; ++j) {
            const double way = std::abs(rim.ways[i] - rim.ways[j]);
            const bool near = j != i && std::min(way, all - way) < reach;
            if (near && (straight[j] < straight[i] || (straight[j] == straight[i] && j < i))) sharpest = false;
        }
        if (sharpest) out.push_back(i);
    }
    return out;
}

} // namespace

std::vector<RimSide> longest_sides(const Surface& s, std::size_t most) {
    std::vector<RimSide> out;
    for (const auto& rim : s.rims) {
        const RimLine way = loop(s, rim);
        auto at = corners(way);
        if (at.empty()) at.push_back(0);
        for (std::size_t k = 0; k < at.size(); ++k) {
            const std::size_t from = at[k], to = at[(k + 1) % at.size()];
            const double length = way.ways[to] - way.ways[from] + (to <= from ? way.ways.back() : 0);
            out.push_back({way.points[from], way.points[to], length});
        }
    }
    std::stable_sort(out.begin(), out.end(), [](const RimSide& a, const RimSide& b) { return a.length > b.length; });
    if (out.size() > most) out.resize(most);
    return out;
}

} // namespace filum::choose
