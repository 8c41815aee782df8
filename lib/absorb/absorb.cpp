#include "absorb/absorb.hpp"

#include "absorb/nose.hpp"

#include <algorithm>
#include <cmath>

namespace filum::absorb {

namespace {

constexpr double kPixel = 1.0 / 16;                 // bead widths
constexpr int kCore = 896, kMargin = 64, kRim = 10; // pixels: tiles lap over each other by what an edit can reach
constexpr int kRounds = 3;
constexpr double kGood = 0.0012;  // share of the area: if no more is uncovered, that is enough
constexpr double kPoor = 0.0095;  // if more is, the search is thorough,
constexpr double kFair = 0.007;   // until no more than this is
constexpr double kLowPrice = 0.1; // and laying twice is cheaper then
constexpr double kEnough = 0.5;   // share of a void: a course that gains so much is taken
constexpr std::size_t kLeastVoid = 8, kLeastThorough = 3, kMostVoid = 600; // pixels
constexpr double kClear = 0.02;                                            // bead widths

class Absorber {
  public:
    Absorber(const polygon::Loops& region, const std::vector<toolpath::Curve>& curves, const Options& o)
        : region_(region), chain_(curves), width_(o.bead_width), box_(polygon::bounds(region)) {
        const Vec2 size = box_.hi - box_.lo;
        pixel_ = std::min(kPixel * width_, std::max(std::max(size.x, size.y) / 48, 1e-3));
    }

    std::vector<toolpath::Curve> run() {
        const double core = kCore * pixel_;
        const int nx = std::max(1, static_cast<int>(std::ceil((box_.hi.x - box_.lo.x) / core)));
        const int ny = std::max(1, static_cast<int>(std::ceil((box_.hi.y - box_.lo.y) / core)));
        spread(nx, ny);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) tile(x, y, nx);
        return chain_.curves();
    }

  private:
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

    // The original segments of every tile.
    void spread(int nx, int ny) {
        of_tile_.resize(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
        const double core = kCore * pixel_, margin = (kMargin + 32) * pixel_;
        const auto cell = [&](double v, int n) {
            return static_cast<int>(std::clamp(std::floor(v / core), 0.0, n - 1.0));
        };
        for (std::uint32_t i = 0; i < chain_.size(); ++i) {
            const Bead b = chain_.bead(i);
            const int x0 = cell(std::min(b.a.x, b.b.x) - margin - box_.lo.x, nx),
                      x1 = cell(std::max(b.a.x, b.b.x) + margin - box_.lo.x, nx);
            const int y0 = cell(std::min(b.a.y, b.b.y) - margin - box_.lo.y, ny),
                      y1 = cell(std::max(b.a.y, b.b.y) + margin - box_.lo.y, ny);
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x)
                    of_tile_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x)]
                        .push_back(i);
        }
    }

    void tile(int x, int y, int nx) {
        const Place p = place(x, y);
        Tile tile(region_, p.all, pixel_);
        Near near(chain_, p.all, std::max(width_, 16 * pixel_));
        for (const std::uint32_t original :
             of_tile_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x)])
            chain_.pieces(original, [&](std::uint32_t i) { tile.add(chain_.bead(i), 1), near.add(i); });
        const Pixel lo = tile.at(p.own.lo), hi = tile.at(p.own.hi);
        const auto inside = static_cast<double>(tile.count(lo, hi).inside);
        Search search;
        search.width = width_;
        rounds(tile, near, lo, hi, kGood * inside, search);
        if (static_cast<double>(tile.count(lo, hi).empty) < kPoor * inside) return;
        search.thorough = true, search.prices.twice = kLowPrice;
        rounds(tile, near, lo, hi, kFair * inside, search);
    }

    // Reaches into voids until no more than `goal` pixels are left.
    void rounds(Tile& tile, Near& near, Pixel lo, Pixel hi, double goal, Search& search) {
        auto left = static_cast<double>(tile.count(lo, hi).empty);
        for (int round = 0; round < kRounds; ++round) {
            double gained = 0;
            for (const Void& v : voids(tile, lo, hi, search.thorough ? kLeastThorough : kLeastVoid, kMostVoid)) {
                if (left - gained <= goal) return;
                gained += reach(tile, near, v, search);
            }
            left -= gained;
            if (gained == 0) return;
        }
    }

    // Pixels gained.
    double reach(Tile& tile, Near& near, const Void& v, Search& search) {
        if (!tile.empty(v.deepest)) return 0; // covered meanwhile
        std::vector<Course> found;
        search.enough = search.thorough ? 1e9 : kEnough * static_cast<double>(v.pixels.size());
        for (const Root& r : roots(tile, chain_, near, v, search)) {
            blades(tile, chain_, r, search, found);
            if (search.done(found)) break;
            noses(tile, chain_, r, v, search, found);
            if (search.done(found)) break;
            if (search.thorough) ears(tile, chain_, r, search, found);
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const Course& a, const Course& b) { return a.score > b.score; });
        if (found.size() > 8) found.resize(8);
        for (const Course& c : found) {
            if (!clear(chain_, near, c, kClear * width_)) continue;
            make(tile, chain_, near, c);
            return c.score;
        }
        return 0;
    }

    const polygon::Loops& region_;
    Chain chain_;
    double width_;
    Box2 box_;
    double pixel_ = 0;
    std::vector<std::vector<std::uint32_t>> of_tile_;
};

} // namespace

std::vector<toolpath::Curve> absorb(const polygon::Loops& region, const std::vector<toolpath::Curve>& curves,
                                    const Options& options) {
    if (region.empty() || curves.empty()) return curves;
    return Absorber(region, curves, options).run();
}

} // namespace filum::absorb
