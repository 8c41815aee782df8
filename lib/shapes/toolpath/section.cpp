#include "toolpath/reach.hpp"

#include <algorithm>
#include <cmath>

namespace filum::toolpath {

namespace {

constexpr double kSlack = 1e-9; // of a mean section: tolerance of rounding

} // namespace

double full_share(const Line& line, std::uint32_t from, double length) {
    return full_share(line.width[from], length * length);
}

Section::Section(const Line& line, std::uint32_t from, double share) : line_(&line), from_(from), share_(share) {}

void Section::piece(double a, double b, double width, double length) {
    low_ = std::max(low_, std::max(a, b) * (1 - share_));
    high_ = std::min(high_, std::min(a, b) * (1 + share_));
    // The volume so far may differ by a fraction of that of one bead width. Within the segment it deviates from its
    // chord by an eighth of the change.
    const double may = share_ * std::min(a, b) * width - std::abs(b - a) * length / 8;
    if (may < 0) return void(sum_low_ = std::numeric_limits<double>::infinity());
    if (!(length_ > 0)) return;
    sum_low_ = std::max(sum_low_, (volume_ - may) / length_);
    sum_high_ = std::min(sum_high_, (volume_ + may) / length_);
}

void Section::take(std::uint32_t k) {
    const Line& l = *line_;
    length_ = l.at[k] - l.at[from_];
    volume_ = l.volume[k] - l.volume[from_];
    piece(l.area[k - 1], l.area[k], std::min(l.width[k - 1], l.width[k]), l.step(k - 1));
}

bool Section::any() const { return low_ <= high_ * (1 + kSlack) || sum_low_ <= sum_high_ * (1 + kSlack); }

bool Section::suits() const {
    const auto within = [](double v, double low, double high) {
        return v >= low * (1 - kSlack) && v <= high * (1 + kSlack);
    };
    const double mean = length_ > 0 ? volume_ / length_ : 0;
    return within(mean, low_, high_) || within(mean, sum_low_, sum_high_);
}

} // namespace filum::toolpath
