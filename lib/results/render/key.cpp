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

} // namespace

Key::Key(Image& image)
    : image_(&image), size_(std::clamp(image.height / 70.0, 7.0, 24.0)), at_{1.6 * size_, image.height - 1.6 * size_},
      end_(image.height < 12 * size_ ? 0 : image.width - 1.6 * size_) {}

bool Key::room(double width) const { return at_.x + width <= end_; }

void Key::clear(Rgb paper) {
    if (end_ > 0) draw_box(*image_, 0, static_cast<int>(at_.y - 2.2 * size_), image_->width, image_->height, paper);
}

void Key::text(const std::string& text) {
    const double wide = text_width(size_, text);
    if (!room(wide)) return;
    draw_text(*image_, at_, size_, text, kTextInk);
    at_.x += wide + 2 * size_;
}

void Key::swatch(Rgb colour, const std::string& text) {
    if (!room(2 * size_ + text_width(size_, text))) return;
    draw_line(*image_, {at_.x, at_.y - size_ / 2}, {at_.x + size_, at_.y - size_ / 2}, 0.8 * size_, colour);
    at_.x += 2 * size_;
    this->text(text);
}

void Key::ramp(const std::string& lo, const std::string& hi) {
    const double low = text_width(size_, lo), high = text_width(size_, hi);
    const int n = static_cast<int>(12 * size_);
    if (!room(low + high + n + 1.4 * size_)) return;
    draw_text(*image_, at_, size_, lo, kTextInk);
    const double x0 = at_.x + low + 0.6 * size_;
    for (int k = 0; k < n; ++k) {
        const int x = static_cast<int>(x0) + k, y = static_cast<int>(at_.y);
        draw_box(*image_, x, y - static_cast<int>(size_), x + 1, y, render::ramp((k + 0.5) / n));
    }
    draw_text(*image_, {x0 + n + 0.8 * size_, at_.y}, size_, hi, kTextInk);
    at_.x = x0 + n + 0.8 * size_ + high + 2 * size_;
}

void Key::ruler(double scale) {
    const double length = round_down(0.16 * image_->width / scale);
    const std::string text = fixed_text(length, 9) + " mm";
    const double wide = text_width(size_, text), bar = length * scale, x1 = end_, x0 = x1 - bar;
    if (!std::isfinite(bar) || !room(bar + wide + 2 * size_)) return;
    const double y = at_.y - size_ / 2, line = std::max(1.0, size_ / 5);
    draw_line(*image_, {x0, y}, {x1, y}, line, kTextInk);
    for (const double x : {x0, x1}) draw_line(*image_, {x, y - size_ / 2}, {x, y + size_ / 2}, line, kTextInk);
    draw_text(*image_, {x0 - wide - size_ / 2, at_.y}, size_, text, kTextInk);
    end_ = x0 - wide - 2 * size_;
}

} // namespace filum::render
