#include "render/key.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>

namespace filum::render {

namespace {

const Rgb kTextInk = oklch(0.42, 0.02, 260);

// The largest of 1, 2, 5 times a power of ten that is not above v.
double round_down(double v) {
    const double ten = std::pow(10, std::floor(std::log10(v)));
    return v >= 5 * ten ? 5 * ten : (v >= 2 * ten ? 2 * ten : ten);
}

// Decimal digits that show `step`.
int digits(double step) { return std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9); }

// The number at an end of the scale to a hundredth of its range, followed by "..." if amounts lie beyond it.
std::string end_text(const RampScale& s, double v, bool more) {
    const double range = s.hi > s.lo ? s.hi - s.lo : std::max(std::abs(v), 1e-9);
    return fixed_text(v, digits(range / 100)) + (more ? "..." : "");
}

} // namespace

Key::Key(Canvas& canvas)
    : canvas_(&canvas),
      size_(std::clamp(canvas.height() / 80.0, 7.0, 24.0)), at_{1.8 * size_, canvas.height() - 2.2 * size_},
      end_(canvas.height() < 12 * size_ ? 0 : canvas.width() - 1.8 * size_) {}

bool Key::room(double width) const { return at_.x + width <= end_; }

void Key::clear(Rgb paper) {
    if (end_ > 0)
        canvas_->box({0, at_.y - 2.2 * size_},
                     {static_cast<double>(canvas_->width()), static_cast<double>(canvas_->height())}, paper);
}

void Key::text(const std::string& text) {
    const double wide = canvas_->text_width(size_, text);
    if (!room(wide)) return;
    canvas_->text(at_, size_, text, kTextInk);
    at_.x += wide + 2 * size_;
}

void Key::swatch(Rgb colour, const std::string& text) {
    if (!room(2 * size_ + canvas_->text_width(size_, text))) return;
    canvas_->line({at_.x + 0.4 * size_, at_.y - size_ / 2}, {at_.x + size_, at_.y - size_ / 2},
                  {.width = 0.9 * size_, .colour = colour});
    at_.x += 2 * size_;
    this->text(text);
}

// Draws a ramp between two texts if there is room. `x` becomes its left end.
bool Key::bar_between(const std::string& lo, const std::string& hi, double& x) {
    const double low = canvas_->text_width(size_, lo), high = canvas_->text_width(size_, hi), gap = 0.7 * size_;
    if (!room(low + high + bar() + 2 * gap)) return false;
    canvas_->text(at_, size_, lo, kTextInk);
    x = at_.x + low + gap;
    const int steps = static_cast<int>(bar());
    for (int k = 0; k < steps; ++k) { // each box reaches under the next, so that no gap shows
        const double from = x + bar() * k / steps;
        canvas_->box({from, at_.y - size_}, {std::min(from + 2, x + bar()), at_.y}, render::ramp((k + 0.5) / steps));
    }
    canvas_->text({x + bar() + gap, at_.y}, size_, hi, kTextInk);
    at_.x = x + bar() + gap + high + 2 * size_;
    return true;
}

void Key::ramp(const std::string& lo, const std::string& hi) {
    double x = 0;
    bar_between(lo, hi, x);
}

void Key::ramp(const RampScale& s) {
    double x = 0;
    const std::string unit = s.unit.empty() ? "" : " " + s.unit;
    if (!bar_between(s.name + " " + end_text(s, s.lo, s.below), end_text(s, s.hi, s.above) + unit, x)) return;
    if (!(s.hi > s.lo)) return;
    const double small = 0.75 * size_, step = round_down((s.hi - s.lo) / 2.5);
    double free = x; // right end of the last number
    for (double v = std::ceil(s.lo / step) * step; v <= s.hi; v += step) {
        const double at = x + bar() * (v - s.lo) / (s.hi - s.lo);
        const std::string text = fixed_text(v, digits(step));
        const double half = canvas_->text_width(small, text) / 2;
        canvas_->line({at, at_.y}, {at, at_.y + 0.3 * size_}, {.width = std::max(1.0, size_ / 8), .colour = kTextInk});
        if (at - half < free) continue;
        canvas_->text({at - half, at_.y + 0.6 * size_ + small}, small, text, kTextInk);
        free = at + half + small / 2;
    }
}

void Key::ruler(double scale) {
    const double length = round_down(0.16 * canvas_->width() / scale);
    const std::string text = fixed_text(length, 9) + " mm";
    const double wide = canvas_->text_width(size_, text), bar = length * scale, x1 = end_, x0 = x1 - bar;
    if (!std::isfinite(bar) || !room(bar + wide + 2 * size_)) return;
    const double y = at_.y - size_ / 2;
    const Pen pen{.width = std::max(1.0, size_ / 6), .colour = kTextInk};
    canvas_->line({x0, y}, {x1, y}, pen);
    for (const double x : {x0, x1}) canvas_->line({x, y - size_ / 2}, {x, y + size_ / 2}, pen);
    canvas_->text({x0 - wide - size_, at_.y}, size_, text, kTextInk);
    end_ = x0 - wide - 2.5 * size_;
}

} // namespace filum::render
