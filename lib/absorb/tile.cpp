#include "absorb/tile.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace filum::absorb {

namespace {

int whole(double v) { return static_cast<int>(std::clamp(v, -1e9, 1e9)); }

// ceil and floor without a call.
int up(double v) {
    const int i = whole(v);
    return i + (i < v ? 1 : 0);
}
int down(double v) {
    const int i = whole(v);
    return i - (i > v ? 1 : 0);
}

constexpr std::uint64_t each(std::uint8_t byte) { return 0x0101010101010101U * std::uint64_t{byte}; }

std::uint64_t eight(const std::uint8_t* p) {
    std::uint64_t v = 0;
    for (int k = 0; k < 8; ++k) v |= std::uint64_t{p[k]} << (8 * k);
    return v;
}

// The highest bits of eight bytes, gathered into one.
std::uint64_t high_bits(std::uint64_t bytes) { return (((bytes & each(0x80)) >> 7) * 0x0102040810204080U) >> 56; }

} // namespace

Tile::Tile(std::span<const geom::Segment> edges, const Box2& box, double pixel)
    : origin_(box.lo), pixel_(pixel), width_(up(((box.hi.x - box.lo.x) / pixel)) + 1),
      height_(up(((box.hi.y - box.lo.y) / pixel)) + 1),
      value_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {
    mark_inside(edges);
}

Pixel Tile::at(Vec2 p) const {
    return {std::clamp(down(((p.x - origin_.x) / pixel_)), 0, width_ - 1),
            std::clamp(down(((p.y - origin_.y) / pixel_)), 0, height_ - 1)};
}

bool Tile::well_inside(Vec2 p) const {
    const Pixel c = at(p);
    if (!holds(p) || c.x == 0 || c.y == 0 || c.x + 1 == width_ || c.y + 1 == height_) return false;
    return inside(c) && inside({c.x + 1, c.y}) && inside({c.x - 1, c.y}) && inside({c.x, c.y + 1}) &&
           inside({c.x, c.y - 1});
}

// Every edge flips the pixels to its right; what is flipped an odd number of times is inside.
void Tile::mark_inside(std::span<const geom::Segment> edges) {
    for (const auto& edge : edges) {
        Vec2 a = edge.a, b = edge.b;
        if (a.y > b.y) std::swap(a, b);
        const int y0 = std::max(0, up((a.y - origin_.y) / pixel_ - 0.5));
        const int y1 = std::min(height_ - 1, up((b.y - origin_.y) / pixel_ - 0.5) - 1);
        for (int y = y0; y <= y1; ++y) {
            const double cy = origin_.y + (y + 0.5) * pixel_;
            const double x = a.x + (b.x - a.x) * ((cy - a.y) / (b.y - a.y));
            const int from = std::max(0, up((x - origin_.x) / pixel_ - 0.5));
            if (from < width_) value_[index({from, y})] ^= kInside;
        }
    }
    for (int y = 0; y < height_; ++y) {
        std::uint8_t* const row = value_.data() + index({0, y});
        for (int from = next_empty(0, width_, y); from < width_;) { // from flip to flip
            const int to = next_empty(from + 1, width_, y);
            std::memset(row + from, kInside, static_cast<std::size_t>(to - from));
            if (to < width_) row[to] = 0;
            from = next_empty(to + 1, width_, y);
        }
    }
}

int Tile::next_empty(int x, int end, int y) const {
    const std::uint8_t* row = value_.data() + index({0, y});
    const void* found = x < end ? std::memchr(row + x, kInside, static_cast<std::size_t>(end - x)) : nullptr;
    return found == nullptr ? end : static_cast<int>(static_cast<const std::uint8_t*>(found) - row);
}

Tile::Counts Tile::count(Pixel lo, Pixel hi) const {
    Counts c;
    for (int y = lo.y; y <= hi.y; ++y) {
        const auto row = value_.begin() + static_cast<std::ptrdiff_t>(index({0, y}));
        int inside = 0, empty = 0;
        for (int x = lo.x; x <= hi.x; ++x) inside += row[x] >> 7, empty += row[x] == kInside ? 1 : 0;
        c.inside += inside, c.empty += empty;
    }
    return c;
}

// Calls f(y, first, last) for the rows of pixels whose centres lie in the bead, within lo .. hi.  On either side the
// border is the lower round end, then a straight edge, then the upper round end.
template <class F>
void Tile::rows(const Bead& bead, Pixel lo, Pixel hi, F&& f) const {
    const double scale = 1 / pixel_, r = bead.width / 2 * scale; // all in pixels from here on
    Vec2 a = scale * (bead.a - origin_), b = scale * (bead.b - origin_);
    if (a.y > b.y) std::swap(a, b);
    const Vec2 d = b - a;
    const double length = geom::norm(d);
    const Vec2 u = length > 0 ? (1 / length) * d : Vec2{0, 1}, n{u.y, -u.x}; // n: to the right
    const double slope = u.y > 0 ? u.x / u.y : 0;
    const double right_a = a.y + r * n.y, right_b = b.y + r * n.y, left_a = a.y - r * n.y, left_b = b.y - r * n.y;
    const auto half = [&](double y, Vec2 c) { return std::sqrt(std::max(0.0, r * r - (y - c.y) * (y - c.y))); };
    const int y0 = std::max(lo.y, up(a.y - r - 0.5)), y1 = std::min(hi.y, down(b.y + r - 0.5));
    for (int y = y0; y <= y1; ++y) {
        const double cy = y + 0.5;
        const double to = cy < right_a    ? a.x + half(cy, a)
                          : cy <= right_b ? a.x + r * n.x + slope * (cy - right_a)
                                          : b.x + half(cy, b);
        const double from = cy < left_a    ? a.x - half(cy, a)
                            : cy <= left_b ? a.x - r * n.x + slope * (cy - left_a)
                                           : b.x - half(cy, b);
        const int x0 = std::max(lo.x, up(from - 0.5)), x1 = std::min(hi.x, down(to - 0.5));
        if (x0 <= x1) f(y, x0, x1);
    }
}

void Tile::paint(const Bead& bead, Pixel lo, Pixel hi, int times) {
    rows(bead, lo, hi, [&](int y, int x0, int x1) {
        std::uint8_t* const row = value_.data() + index({0, y});
        const auto by = static_cast<std::uint8_t>(times);
        for (int x = x0; x <= x1; ++x)
            row[x] = static_cast<std::uint8_t>(row[x] + ((row[x] & kCount) == kCount ? 0 : by));
    });
}

void Tile::stamp(const Bead& bead, Pixel corner, Mask& mask) const {
    const Pixel hi{std::min(corner.x + 63, width_ - 1), std::min(corner.y + 63, height_ - 1)};
    rows(bead, corner, hi, [&](int y, int x0, int x1) {
        const std::uint64_t ones = ~std::uint64_t{0} >> (63 - (x1 - x0));
        mask.rows[static_cast<std::size_t>(y - corner.y)] |= ones << (x0 - corner.x);
    });
}

// How many of the beads cover a pixel is added up in three bit planes, and must be the number that the tile has.
void Tile::uncovered(Pixel corner, std::span<const Bead> beads, Mask& in, Mask& out) const {
    std::array<Mask, 3> sum;
    for (const Bead& b : beads) {
        Mask carry;
        stamp(b, corner, carry);
        for (Mask& plane : sum)
            for (std::size_t y = 0; y < 64; ++y) {
                const std::uint64_t c = carry.rows[y];
                carry.rows[y] &= plane.rows[y], plane.rows[y] ^= c;
            }
    }
    const int w = std::min(64, width_ - corner.x), h = std::min(64, height_ - corner.y);
    for (int y = 0; y < h; ++y) {
        const auto j = static_cast<std::size_t>(y);
        const std::uint8_t* row = value_.data() + index({corner.x, corner.y + y});
        for (int x = 0; x < w; x += 8) {    // eight pixels at once
            std::uint64_t v = each(kCount); // beyond the tile nothing is to be had
            const int n = std::min(8, w - x);
            if (n == 8)
                v = eight(row + x);
            else
                for (int k = 0; k < n; ++k)
                    v = (v & ~(std::uint64_t{0xff} << (8 * k))) | std::uint64_t{row[x + k]} << (8 * k);
            const auto plane = [&](int bit) { return high_bits(v << (7 - bit)); };
            const auto told = [&](std::size_t bit) { return (sum[bit].rows[j] >> x) & 0xff; };
            const std::uint64_t few = high_bits(~((v & each(0x38)) + each(0x78))); // below eight
            const std::uint64_t bare =
                ~(plane(0) ^ told(0)) & ~(plane(1) ^ told(1)) & ~(plane(2) ^ told(2)) & few & 0xff;
            const std::uint64_t inside = high_bits(v);
            in.rows[j] |= (bare & inside) << x, out.rows[j] |= (bare & ~inside) << x;
        }
    }
}

} // namespace filum::absorb
