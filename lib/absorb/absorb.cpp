#include "absorb/absorb.hpp"

#include "absorb/cracks.hpp"
#include "absorb/nose.hpp"
#include "absorb/turn.hpp"
#include "geom/segment.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <cmath>

namespace filum::absorb {

namespace {

constexpr double kUsual = 1.25;                     // of the mean width: beads are hardly wider
constexpr double kLarge = 300;                      // bead widths squared: regions that one void matters little to,
constexpr double kSmall = 150;                      // and much
constexpr double kTiny = 80;                        // and most
constexpr double kDot = 3;                          // bead widths squared: of no weight in any box
constexpr double kSharp = 1.2;                      // rad
constexpr double kSpare = 0.02;                     // share of the area that may be laid beyond it,
constexpr double kCorners = 1.5;                    // and bead widths squared, for corners
constexpr double kCoarse = 1.0 / 9;                 // bead widths: their pixels
constexpr double kPixel = 1.0 / 16;                 // bead widths
constexpr int kCore = 896, kMargin = 64, kRim = 10; // pixels: tiles lap over each other by what an edit can reach
constexpr int kRounds = 3;
constexpr double kGood = 0.0015;  // share of the area: if no more is uncovered, that is enough
constexpr double kPoor = 0.008;   // if more is, the search is thorough,
constexpr double kFair = 0.005;   // until no more than this is
constexpr double kLowPrice = 0.1; // and laying twice is cheaper then
constexpr double kEnough = 0.5;   // share of a void: a course that gains so much is taken
constexpr double kWorth = 0.0;    // share of a void: a course that gains less only spoils the place for better ones
constexpr std::size_t kLeastVoid = 8, kLeastLarge = 9, kLeastThorough = 3, kMostVoid = 600; // pixels
constexpr double kClear = 0.02;                                                             // bead widths

bool has_corner(std::span<const Vec2> loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 u = loop[i] - loop[i == 0 ? loop.size() - 1 : i - 1], v = loop[(i + 1) % loop.size()] - loop[i];
        if (std::atan2(geom::cross(u, v), geom::dot(u, v)) > kSharp) return true;
    }
    return false;
}

// The curve without points that lie on the line between their neighbours and have its width: noses want room between
// the corners.
toolpath::Curve straightened(const toolpath::Curve& curve, double width) {
    constexpr double kOff = 0.0006, kWider = 0.004; // mm; bead widths
    constexpr std::size_t kMost = 60;               // points left out in a row: bounds the work
    const std::size_t n = curve.points.size();
    toolpath::Curve out{curve.closed, {curve.points[0]}, {curve.width_at(0)}};
    for (std::size_t kept = 0, i = 1; i < n; ++i) {
        const Vec2 a = curve.points[kept], b = curve.points[(i + 1) % n];
        const double wa = curve.width_at(kept), wb = curve.width_at((i + 1) % n);
        bool straight = i + 1 < n && i - kept < kMost && std::abs(wa - wb) < kWider * width;
        for (std::size_t k = kept + 1; k <= i && straight; ++k)
            straight = geom::point_segment_distance(a, b, curve.points[k]) < kOff &&
                       geom::dot(curve.points[k] - curve.points[k - 1], b - a) > 0 &&
                       std::abs(curve.width_at(k) - wa) < kWider * width;
        if (straight) continue;
        out.points.push_back(curve.points[i]), out.width.push_back(curve.width_at(i));
        kept = i;
    }
    return out.points.size() < 4 ? curve : out;
}

std::vector<toolpath::Curve> straightened(const std::vector<toolpath::Curve>& curves, double width) {
    std::vector<toolpath::Curve> out;
    for (const auto& c : curves) out.push_back(straightened(c, width));
    return out;
}

class Absorber {
  public:
    Absorber(const polygon::Loops& region, const std::vector<toolpath::Curve>& curves, const Options& o)
        : region_(region), chain_(straightened(curves, o.bead_width)),
          width_(std::min(o.bead_width, kUsual * mean_width())), box_(polygon::bounds(region)) {
        const Vec2 size = box_.hi - box_.lo;
        const double area = polygon::signed_area(region) / (width_ * width_);
        large_ = area > kLarge, small_ = area < kSmall,
        dot_ = area * width_ * width_ < kDot * o.bead_width * o.bead_width;
        tiny_ = area < kTiny && has_corner(region[0]);
        most_ = (1 + kSpare) * area * width_ * width_ + kCorners * o.bead_width * o.bead_width;
        for (std::uint32_t i = 0; i < chain_.size(); ++i) {
            const Bead b = chain_.bead(i);
            course_.add(b.a), laid_ += geom::distance(b.a, b.b) * b.width;
        }
        pixel_ = std::min((large_ ? kCoarse : kPixel) * width_, std::max(size.x, size.y) / 48);
        pixel_ = std::max({pixel_, kPixel / 8 * o.bead_width, 1e-3});
    }

    std::vector<toolpath::Curve> run() {
        const double core = kCore * pixel_;
        columns_ = std::max(1, static_cast<int>(std::ceil((box_.hi.x - box_.lo.x) / core)));
        rows_ = std::max(1, static_cast<int>(std::ceil((box_.hi.y - box_.lo.y) / core)));
        spread();
        for (int y = 0; y < rows_; ++y)
            for (int x = 0; x < columns_; ++x) tile(x, y);
        return chain_.curves();
    }

  private:
    // Of the beads, by length: much less than the usual width where all walls are thin.
    [[nodiscard]] double mean_width() const {
        double length = 0, laid = 0;
        for (std::uint32_t i = 0; i < chain_.size(); ++i) {
            const Bead b = chain_.bead(i);
            const double l = geom::distance(b.a, b.b);
            length += l, laid += l * b.width;
        }
        return length > 0 ? laid / length : 1;
    }

    // A tile's own part, and as much around it as an edit can reach, or as beads can stick out of the region.
    struct Place {
        Box2 own, all;
    };
    [[nodiscard]] Place place(int x, int y) const {
        const double core = kCore * pixel_, margin = kMargin * pixel_, rim = kRim * pixel_;
        Place p;
        p.own.lo = box_.lo + Vec2{x * core, y * core};
        p.own.hi = {std::min(p.own.lo.x + core, box_.hi.x), std::min(p.own.lo.y + core, box_.hi.y)};
        p.all.lo = {std::max(p.own.lo.x - margin, box_.lo.x - rim), std::max(p.own.lo.y - margin, box_.lo.y - rim)};
        p.all.hi = {std::min(p.own.hi.x + margin, box_.hi.x + rim), std::min(p.own.hi.y + margin, box_.hi.y + rim)};
        return p;
    }

    [[nodiscard]] int cell(double v, int n) const {
        return static_cast<int>(std::clamp(std::floor(v / (kCore * pixel_)), 0.0, n - 1.0));
    }

    // The segments of the curves near every tile, and the edges of the region on the level of every row of tiles.
    void spread() {
        const auto nx = static_cast<std::size_t>(columns_);
        of_tile_.resize(nx * static_cast<std::size_t>(rows_)), of_row_.resize(static_cast<std::size_t>(rows_));
        const double margin = (kMargin + 32) * pixel_;
        for (std::uint32_t i = 0; i < chain_.size(); ++i) {
            const Bead b = chain_.bead(i);
            const Vec2 lo = Vec2{std::min(b.a.x, b.b.x) - margin, std::min(b.a.y, b.b.y) - margin} - box_.lo;
            const Vec2 hi = Vec2{std::max(b.a.x, b.b.x) + margin, std::max(b.a.y, b.b.y) + margin} - box_.lo;
            for (int y = cell(lo.y, rows_); y <= cell(hi.y, rows_); ++y)
                for (int x = cell(lo.x, columns_); x <= cell(hi.x, columns_); ++x)
                    of_tile_[static_cast<std::size_t>(y) * nx + static_cast<std::size_t>(x)].push_back(i);
        }
        for (const geom::Segment& e : polygon::segments(region_)) {
            const int y0 = cell(std::min(e.a.y, e.b.y) - margin - box_.lo.y, rows_);
            const int y1 = cell(std::max(e.a.y, e.b.y) + margin - box_.lo.y, rows_);
            for (int y = y0; y <= y1; ++y) of_row_[static_cast<std::size_t>(y)].push_back(e);
        }
    }

    void tile(int x, int y) {
        const auto& segments =
            of_tile_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
        if (segments.empty()) return;
        const Place p = place(x, y);
        Tile tile(of_row_[static_cast<std::size_t>(y)], p.all, pixel_);
        Near near(chain_, p.all, std::max(width_, 16 * pixel_));
        for (const std::uint32_t original : segments)
            chain_.pieces(original, [&](std::uint32_t i) { tile.add(chain_.bead(i), 1), near.add(i); });
        const Pixel lo = tile.at(p.own.lo), hi = tile.at(p.own.hi);
        const auto inside = static_cast<double>(tile.count(lo, hi).inside);
        Search search;
        search.width = width_, search.small = small_;
        rounds(tile, near, lo, hi, kGood * inside, search);
        if (static_cast<double>(tile.count(lo, hi).empty) < kPoor * inside) return;
        close_cracks(tile, chain_, near, segments, width_);
        search.thorough = true, search.prices.twice = kLowPrice;
        rounds(tile, near, lo, hi, kFair * inside, search);
    }

    // Reaches into voids until no more than `goal` pixels are left.
    void rounds(Tile& tile, Near& near, Pixel lo, Pixel hi, double goal, Search& search) {
        auto left = static_cast<double>(tile.count(lo, hi).empty);
        const std::size_t least = search.thorough ? kLeastThorough : large_ ? kLeastLarge : kLeastVoid;
        for (int round = 0; round < kRounds; ++round) {
            double gained = 0;
            for (const Void& v : voids(tile, lo, hi, least, kMostVoid)) {
                if (left - gained <= goal) return;
                gained += reach(tile, near, v, search);
            }
            left -= gained;
            if (gained == 0) return;
        }
    }

    // Whether a course leaves the box about the curves: programs are placed and compared by that box, and noses on one
    // side would shift the part.  Only in small regions with corners, where these matter most, corners may.
    [[nodiscard]] bool sticks_out(const Course& c) const {
        if (dot_) return false;
        const bool out = std::any_of(c.knots.begin(), c.knots.end(), [&](const Knot& k) {
            return k.at.x < course_.lo.x || k.at.y < course_.lo.y || k.at.x > course_.hi.x || k.at.y > course_.hi.y;
        });
        if (!out || !tiny_) return out;
        return std::none_of(c.nodes.begin(), c.nodes.end(),
                            [&](std::uint32_t i) { return std::abs(turn(chain_, i)) > kSharp; });
    }

    // mm2 laid between the ends of the course as it is now.
    [[nodiscard]] double deposit(const Course& c) const {
        double sum = 0;
        for (std::uint32_t i = c.from; i != c.to; i = chain_[i].next) {
            const Bead b = chain_.bead(i);
            sum += geom::distance(b.a, b.b) * b.width;
        }
        return sum;
    }

    // Pixels gained.
    double reach(Tile& tile, Near& near, const Void& v, Search& search) {
        if (!tile.empty(v.deepest) || (search.thorough && laid_ > most_)) return 0; // covered meanwhile; or enough
        std::vector<Course> found;
        search.enough = (search.thorough ? 0.7 : kEnough) * static_cast<double>(v.pixels.size());
        for (const Root& r : roots(tile, chain_, near, v, search)) {
            blades(tile, chain_, r, search, found);
            if (search.done(found)) break;
            noses(tile, chain_, r, v, search, found);
            if (search.done(found)) break;
            if (search.thorough) ears(tile, chain_, r, search, found);
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const Course& a, const Course& b) { return a.score > b.score; });
        const double least = search.thorough ? 0 : kWorth * static_cast<double>(v.pixels.size());
        std::erase_if(found, [&](const Course& c) { return c.score < least || sticks_out(c); });
        if (found.size() > 8) found.resize(8);
        for (const Course& c : found) {
            if (!clear(chain_, near, c, kClear * width_)) continue;
            const double more = deposit(c);
            make(tile, chain_, near, c);
            laid_ += deposit(c) - more;
            return c.score;
        }
        return 0;
    }

    const polygon::Loops& region_;
    Chain chain_;
    double width_;
    Box2 box_;
    double pixel_ = 0;
    double laid_ = 0, most_ = 0; // mm2: so far; from where on no void is worth more
    Box2 course_;                // about the nodes, before
    bool large_ = false, small_ = false, tiny_ = false, dot_ = false;
    int columns_ = 1, rows_ = 1; // of tiles
    std::vector<std::vector<std::uint32_t>> of_tile_;
    std::vector<std::vector<geom::Segment>> of_row_;
};

} // namespace

std::vector<toolpath::Curve> absorb(const polygon::Loops& region, const std::vector<toolpath::Curve>& curves,
                                    const Options& options) {
    if (region.empty() || curves.empty()) return curves;
    return Absorber(region, curves, options).run();
}

} // namespace filum::absorb
