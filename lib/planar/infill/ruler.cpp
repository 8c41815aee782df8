#include "infill/ruler.hpp"

#include <algorithm>
#include <cmath>

namespace filum::infill {

namespace {

constexpr double kNearest = 1.25; // bead widths: nearer lines leave no cell between them

int odd_above(double x) { return 2 * static_cast<int>(std::ceil((x - 1) / 2)) + 1; }
int odd_below(double x) { return 2 * static_cast<int>(std::floor((x - 1) / 2)) + 1; }

// The widths of the cells of a period, an odd number of them for the odd cell if it is `divided`.
std::vector<double> cells(const Lines& o, bool divided) {
    constexpr double kSlack = 1e-9; // of a cell: rounding does not add two cells
    const double even = even_width(o, o.spacing), odd = 2 * o.spacing - even;
    const int parts = divided ? std::max(1, odd_above(odd / even - kSlack)) : 1;
    std::vector<double> out{even};
    for (int k = 0; k < parts; ++k) out.push_back(odd / parts);
    return out;
}

} // namespace

double even_width(const Lines& o, double spacing) {
    return o.pattern == polygon::InfillPattern::concentric ? spacing : std::min(spacing, kWidestCell * o.bead_width);
}

Ruler::Ruler(const Lines& o) : Ruler(o, false) {}

Ruler Ruler::of_squares(const Lines& o) { return {o, true}; }

Ruler::Ruler(const Lines& o, bool squares) : begin_(o.spacing - even_width(o, o.spacing)), period_(2 * o.spacing) {
    for (const double width : cells(o, squares || o.gap > 0))
        if (squares)
            at_.push_back(at_.back() + width);
        else
            add_cell(width, o);
    at_.back() = period_;
    steps_ = static_cast<double>(at_.size() - 1);
    even_.push_back(0);
    for (std::size_t k = 1; k < at_.size(); ++k) even_.push_back(even_.back() + (k % 2 == 1 ? at_[k] - at_[k - 1] : 0));
}

void Ruler::add_cell(double width, const Lines& o) {
    const double least = kNearest * o.bead_width, third = width / 3, begin = at_.back();
    if (o.gap > 0 && width > o.gap + o.bead_width && third >= least) {
        const double first = std::min(third, std::max(least, o.gap / 2)), rest = width - 2 * first;
        const int most = odd_below(rest / least), wanted = odd_above(rest / (o.gap + o.bead_width));
        const int steps = std::max(1, std::min(most, wanted));
        for (int k = 0; k <= steps; ++k) at_.push_back(begin + first + rest * k / steps);
    }
    at_.push_back(begin + width);
}

double Ruler::place(double j) const {
    const double whole = std::floor(j / steps_);
    return begin_ + whole * period_ + at_[static_cast<std::size_t>(j - whole * steps_)];
}

Ruler::Step Ruler::step_at(double v) const {
    v -= begin_;
    const double whole = std::floor(v / period_), rest = v - whole * period_;
    const auto next = std::upper_bound(at_.begin() + 1, at_.end() - 1, rest);
    return {whole, static_cast<std::size_t>(next - at_.begin() - 1), (rest - *(next - 1)) / (*next - *(next - 1))};
}

double Ruler::line(double v) const {
    const auto [whole, k, share] = step_at(v);
    return whole * steps_ + static_cast<double>(k) + share;
}

double Ruler::below(double v) const {
    double j = std::floor(line(v));
    while (place(j) > v) --j; // rounding
    while (place(j + 1) <= v) ++j;
    return j;
}

double Ruler::even(double v) const {
    const auto [whole, k, share] = step_at(v);
    return whole * even_.back() + std::lerp(even_[k], even_[k + 1], share);
}

double near_enough(const Lines& o) {
    if (!(o.gap > 0)) return o.spacing;
    const double parts = std::ceil(o.spacing / (o.gap + o.bead_width));
    return o.spacing / (2 * std::floor(parts / 2) + 1); // odd, so that all lines of the plain spacing remain
}

} // namespace filum::infill
