#include "laminate/rims.hpp"

#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace filum::laminate {

namespace {

using surfpath::rules::kRounding;

constexpr int kHalvings = 50; // of the interval in which the distance of depths is searched

struct Limits {
    long most = 0;     // beads
    double change = 0; // of their widths, share
};

// At most `number` depths from `first` inwards, at least `apart` spacings from each other, as near to it as possible.
std::vector<RimBeads> depths_apart(const RimBeads& first, double apart, const Limits& o, std::size_t number) {
    std::vector<RimBeads> out{first};
    while (out.size() < number) {
        const double next = out.back().depth() + apart;
        const auto count = static_cast<long>(std::max(1.0, std::ceil(next / (1 + o.change) - kRounding)));
        if (count > o.most) break;
        out.push_back({count, std::clamp(next / static_cast<double>(count), 1 - o.change, 1 + o.change)});
    }
    return out;
}

// That many depths, as far apart as possible; fewer if there are not so many.
std::vector<RimBeads> depths(const RimBeads& first, const Limits& o, std::size_t number) {
    double lo = 0, hi = (1 + o.change) * static_cast<double>(o.most);
    for (int i = 0; i < kHalvings; ++i) {
        const double apart = (lo + hi) / 2;
        (depths_apart(first, apart, o, number).size() < number ? hi : lo) = apart;
    }
    return depths_apart(first, o.change > 0 ? lo : std::max(1.0, std::floor(lo + kRounding)), o, number);
}

// Between two depths the sum decreases from the rim inwards.
double greatest_sum(std::span<const RimBeads> depths, std::size_t plies) {
    double most = 0;
    for (const RimBeads& at : depths) {
        double sum = 0;
        for (std::size_t k = 0; k < plies; ++k) sum += open_share(depths[k % depths.size()], at.depth());
        most = std::max(most, sum);
    }
    return most;
}

} // namespace

double open_share(const RimBeads& ply, double from_rim) {
    const double inside = from_rim - ply.depth() + (ply.count > 0 ? surfpath::rules::kOnRimBead : 0);
    if (from_rim < ply.depth() - kRounding || inside >= 1) return 0;
    const double out = 1 - std::max(inside, 0.0);
    return 1 - std::sqrt(std::max(0.0, 1 - out * out));
}

std::vector<RimBeads> rim_beads(std::size_t plies, long most, double change) {
    const Limits limits{most, change};
    std::vector<RimBeads> best{{0, 1}};
    double least = greatest_sum(best, plies);
    for (std::size_t number = 1; number <= plies && most > 0; ++number)
        for (const RimBeads& first : {RimBeads{0, 1}, RimBeads{1, 1 - change}}) {
            auto now = depths(first, limits, number);
            const double sum = greatest_sum(now, plies);
            if (now.size() < number || !(sum < least - kRounding)) continue;
            least = sum;
            best = std::move(now);
        }
    std::vector<RimBeads> out;
    for (std::size_t k = 0; k < plies; ++k) out.push_back(best[k % best.size()]);
    return out;
}

} // namespace filum::laminate
