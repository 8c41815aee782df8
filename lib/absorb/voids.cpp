#include "absorb/voids.hpp"

#include <algorithm>

namespace filum::absorb {

namespace {

void flood(Tile& tile, Pixel seed, std::size_t most, std::vector<Pixel>& out) {
    out.assign(1, seed);
    tile.see(seed);
    for (std::size_t k = 0; k < out.size() && out.size() < most; ++k) {
        const Pixel p = out[k];
        for (const Pixel q : {Pixel{p.x + 1, p.y}, Pixel{p.x - 1, p.y}, Pixel{p.x, p.y + 1}, Pixel{p.x, p.y - 1}}) {
            if (q.x < 0 || q.y < 0 || q.x >= tile.width() || q.y >= tile.height()) continue;
            if (!tile.empty(q) || tile.seen(q)) continue;
            tile.see(q);
            out.push_back(q);
        }
    }
}

int bare_around(const Tile& tile, Pixel p) {
    int n = 0;
    for (int y = std::max(0, p.y - 2); y <= std::min(tile.height() - 1, p.y + 2); ++y)
        for (int x = std::max(0, p.x - 2); x <= std::min(tile.width() - 1, p.x + 2); ++x)
            n += tile.empty({x, y}) ? 1 : 0;
    return n;
}

} // namespace

std::vector<Void> voids(Tile& tile, Pixel lo, Pixel hi, std::size_t least, std::size_t most) {
    std::vector<Void> out;
    std::vector<Pixel> seen, now;
    for (int y = lo.y; y <= hi.y; ++y)
        for (int x = tile.next_empty(lo.x, hi.x + 1, y); x <= hi.x; x = tile.next_empty(x, hi.x + 1, y)) {
            flood(tile, {x, y}, most, now);
            seen.insert(seen.end(), now.begin(), now.end());
            if (now.size() < least) continue;
            Void v{now, now[0]};
            int best = -1;
            for (const Pixel p : now)
                if (const int n = bare_around(tile, p); n > best) best = n, v.deepest = p;
            out.push_back(std::move(v));
        }
    for (const Pixel p : seen) tile.forget(p);
    std::stable_sort(out.begin(), out.end(),
                     [](const Void& a, const Void& b) { return a.pixels.size() > b.pixels.size(); });
    return out;
}

} // namespace filum::absorb
