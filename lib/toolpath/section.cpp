#include "toolpath/reach.hpp"

#include <algorithm>
#include <cmath>

namespace filum::toolpath {

namespace {

constexpr double kFullLength = 3; // bead widths
constexpr double kSlack = 1e-9;   // of a mean section, for rounding

} // namespace

double length_at(const Line& line, const Place& p) {
    return p.t > 0 ? line.at[p.i] + p.t * line.step(p.i) : line.at[p.i];
}

double volume_at(const Line& line, const Place& p) {
    if (!(p.t > 0)) return line.volume[p.i];
    // Along a segment the section changes evenly; scaled so that the whole is exactly the segment's.
    const double a = line.area[p.i], b = line.area[p.i + 1], whole = (a + b) / 2;
    const double share = whole > 0 ? p.t * (a + p.t * (b - a) / 2) / whole : p.t;
    return line.volume[p.i] + share * (line.volume[p.i + 1] - line.volume[p.i]);
}

double full_share(const Line& line, const Place& from, double length) {
    return std::min(1.0, kFullLength * line.width[from.i] / length);
}

Section::Section(const Line& line, const Place& from, double share)
    : line_(&line), from_(from), share_(share), begun_length_(length_at(line, from)),
      begun_volume_(volume_at(line, from)) {}

void Section::piece(double a, double b, double width, double length) {
    low_ = std::max(low_, std::max(a, b) * (1 - share_));
    high_ = std::min(high_, std::min(a, b) * (1 + share_));
    // What is laid so far may be off by the share of what a bead's width holds.  Within the piece it bends off its
    // chord by an eighth of the change.
    const double may = share_ * std::min(a, b) * width - std::abs(b - a) * length / 8;
    if (may < 0) return void(sum_low_ = std::numeric_limits<double>::infinity());
    if (!(length_ > 0)) return;
    sum_low_ = std::max(sum_low_, (volume_ - may) / length_);
    sum_high_ = std::min(sum_high_, (volume_ + may) / length_);
}

void Section::take(std::uint32_t k) {
    const Line& l = *line_;
    const double b = l.area[k];
    double a = l.area[k - 1], length = l.step(k - 1);
    if (k - 1 == from_.i && from_.t > 0) {
        a += from_.t * (b - a);
        length *= 1 - from_.t;
    }
    length_ = l.at[k] - begun_length_;
    volume_ = l.volume[k] - begun_volume_;
    piece(a, b, std::min(l.width[k - 1], l.width[k]), length);
}

bool Section::any() const { return low_ <= high_ * (1 + kSlack) || sum_low_ <= sum_high_ * (1 + kSlack); }

bool Section::suits(double volume, double length) const {
    const auto within = [](double v, double low, double high) {
        return v >= low * (1 - kSlack) && v <= high * (1 + kSlack);
    };
    const double mean = length > 0 ? volume / length : 0;
    return within(mean, low_, high_) || within(mean, sum_low_, sum_high_);
}

bool Section::suits_at(const Place& p) const {
    if (!(p.t > 0)) return suits();
    const Line& l = *line_;
    Section further = *this;
    const double a = l.area[p.i], b = a + p.t * (l.area[p.i + 1] - a);
    further.length_ = length_at(l, p) - begun_length_;
    further.volume_ = volume_at(l, p) - begun_volume_;
    further.piece(a, b, std::min(l.width[p.i], l.width[p.i + 1]), p.t * l.step(p.i));
    return further.suits();
}

} // namespace filum::toolpath
