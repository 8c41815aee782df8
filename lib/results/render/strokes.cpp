#include "render/strokes.hpp"

#include "base/mix.hpp"
#include "geom/segment.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace filum::render {

namespace {

using geom::Vec3;

constexpr double kMostCells = 1 << 20; // largest number of cells along an axis: 20 bits each in a key
// Largest number of pieces one cell long; bounds the memory for very thin strokes.
constexpr double kMostPieces = 1 << 17;
// Share of the half width that counts for overlaps; farther out, two passes share only their border.
constexpr double kTouch = 0.9;
constexpr double kNear = 3; // widths along the path within which passes count as neighbours

// The largest distance from its line of a point that the stroke covers.
double radius(const Stroke& s) { return std::hypot(std::max(s.half_a, s.half_b), s.reach); }

} // namespace

Strokes::Strokes(std::vector<Stroke> strokes) : strokes_(std::move(strokes)) {
    if (strokes_.empty()) return;
    Vec3 lo{INFINITY, INFINITY, INFINITY}, hi{-INFINITY, -INFINITY, -INFINITY};
    double widest = 0, length = 0;
    for (const Stroke& s : strokes_) {
        widest = std::max(widest, radius(s));
        length += geom::distance(s.a, s.b);
        for (const Vec3 p : {s.a, s.b}) {
            lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
            hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
        }
    }
    const double size = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z}) + 2 * widest;
    cell_ = std::max({1.5 * widest, size / (kMostCells - 4), length / kMostPieces, 1e-12});
    lo_ = lo - Vec3{widest + cell_, widest + cell_, widest + cell_};
    fill();
}

std::uint64_t Strokes::key(Vec3 p) const {
    const auto number = [&](double v) {
        return static_cast<std::uint64_t>(std::clamp(std::floor(v / cell_), 0.0, kMostCells - 1));
    };
    return number(p.x - lo_.x) << 40 | number(p.y - lo_.y) << 20 | number(p.z - lo_.z);
}

void Strokes::fill() {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> in; // pairs of cell and stroke
    const double half_diagonal = std::sqrt(0.75) * cell_;
    for (std::uint32_t k = 0; k < strokes_.size(); ++k) {
        const Stroke& s = strokes_[k];
        const double r = radius(s);
        const auto pieces = std::max(1.0, std::ceil(geom::distance(s.a, s.b) / (2 * cell_)));
        for (double i = 0; i < pieces; ++i) {
            const Vec3 a = s.a + i / pieces * (s.b - s.a), b = s.a + (i + 1) / pieces * (s.b - s.a);
            const auto from = [&](double u, double v, double lo) {
                return std::floor((std::min(u, v) - r - lo) / cell_);
            };
            const auto to = [&](double u, double v, double lo) {
                return std::floor((std::max(u, v) + r - lo) / cell_);
            };
            for (double x = from(a.x, b.x, lo_.x); x <= to(a.x, b.x, lo_.x); ++x)
                for (double y = from(a.y, b.y, lo_.y); y <= to(a.y, b.y, lo_.y); ++y)
                    for (double z = from(a.z, b.z, lo_.z); z <= to(a.z, b.z, lo_.z); ++z) {
                        const Vec3 middle = lo_ + cell_ * Vec3{x + 0.5, y + 0.5, z + 0.5};
                        const Vec3 q = a + nearest_parameter(a, b, middle) * (b - a);
                        if (geom::distance(q, middle) <= r + half_diagonal) in.emplace_back(key(middle), k);
                    }
        }
    }
    std::sort(in.begin(), in.end());
    in.erase(std::unique(in.begin(), in.end()), in.end());
    slots_.resize(std::bit_ceil(2 * in.size() + 1));
    for (std::size_t i = 0; i < in.size();) {
        Slot slot{in[i].first, static_cast<std::uint32_t>(i), 0};
        for (; i < in.size() && in[i].first == slot.key; ++i) items_.push_back(in[i].second);
        slot.end = static_cast<std::uint32_t>(i);
        std::size_t at = mixed(slot.key) & (slots_.size() - 1);
        while (slots_[at].end != 0) at = (at + 1) & (slots_.size() - 1);
        slots_[at] = slot;
    }
}

Cover Strokes::at(Vec3 p, Vec3 normal) const {
    Cover out;
    if (strokes_.empty()) return out;
    const std::uint64_t here = key(p);
    std::size_t slot = mixed(here) & (slots_.size() - 1);
    while (slots_[slot].end != 0 && slots_[slot].key != here) slot = (slot + 1) & (slots_.size() - 1);
    double least = INFINITY, first = INFINITY, last = -INFINITY;
    for (std::uint32_t i = slots_[slot].begin; i < slots_[slot].end; ++i) {
        const Stroke& s = strokes_[items_[i]];
        const bool sided = s.normal.x != 0 || s.normal.y != 0 || s.normal.z != 0;
        if ((sided && dot(s.normal, normal) <= 0) || (out.stroke != nullptr && s.layer < out.stroke->layer)) continue;
        const double t = nearest_parameter(s.a, s.b, p), half = s.half_a + t * (s.half_b - s.half_a);
        const Vec3 d = p - (s.a + t * (s.b - s.a));
        const double off_surface = dot(d, s.normal), aside = dot(d, d) - off_surface * off_surface;
        const double off = aside / (half * half);
        if (std::abs(off_surface) > s.reach || !(off <= 1)) continue;
        if (out.stroke == nullptr || s.layer > out.stroke->layer) {
            least = first = INFINITY;
            last = -INFINITY;
        }
        if (off <= kTouch * kTouch) {
            const double along = s.along + t * geom::distance(s.a, s.b);
            first = std::min(first, along);
            last = std::max(last, along);
        }
        if (off < least) {
            least = off;
            out.stroke = &s;
            out.outwards = d - off_surface * s.normal;
        }
    }
    if (out.stroke == nullptr) return out;
    out.off = std::sqrt(std::max(0.0, least));
    out.twice = last - first > kNear * (out.stroke->half_a + out.stroke->half_b);
    return out;
}

} // namespace filum::render
