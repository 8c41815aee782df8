// draw_axis axis|levels SLICE BEAD_WIDTH: an SVG on standard output for scripts/draw-docs, of what no stream holds.
//   axis    the medial axis of the slice's largest region: walls thick, corners thin
//   levels  its strips between whole lane coordinates
#include "fill/rings/beading.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/rings/level.hpp"
#include "fill/rings/wall_lanes.hpp"
#include "polygon/clip.hpp"
#include "polygon/sites.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace {

using namespace filum;
using geom::Vec2;
using polygon::Loops;

constexpr double kWide = 400, kMargin = 6; // pixels

// The largest connected part of a slice: two numbers, then for each loop the number of its points, and those.
Loops largest_part(const char* file) {
    std::ifstream in(file);
    double least = 0, most = 0;
    std::size_t count = 0;
    in >> least >> most;
    Loops loops;
    while (in >> count) {
        std::vector<Vec2> loop(count);
        for (Vec2& p : loop) in >> p.x >> p.y;
        loops.add(loop);
    }
    Loops best;
    for (const Loops& part : polygon::split(polygon::unite(loops, polygon::Fill::even_odd)).part)
        if (best.empty() || polygon::signed_area(part) > polygon::signed_area(best)) best = part;
    return best;
}

class Drawing {
  public:
    explicit Drawing(const Loops& region)
        : box_(polygon::bounds(region)), scale_((kWide - 2 * kMargin) / (box_.hi.x - box_.lo.x)) {
        const double high = scale_ * (box_.hi.y - box_.lo.y) + 2 * kMargin;
        std::printf(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\">"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
            kWide, high, kWide, high);
    }
    void area(const Loops& loops, const char* colour) const {
        std::printf("<path fill=\"%s\" fill-rule=\"evenodd\" d=\"", colour);
        for (std::size_t l = 0; l < loops.size(); ++l) {
            for (std::size_t i = 0; i < loops[l].size(); ++i) point(i == 0 ? 'M' : 'L', loops[l][i]);
            std::printf("Z");
        }
        std::printf("\"/>\n");
    }
    // The pieces of the axis that are walls, or those that are not.
    void pieces(const fill::rings::Beading& b, bool walls, const char* colour, double width) const {
        std::printf("<path stroke=\"%s\" stroke-width=\"%.1f\" stroke-linecap=\"round\" fill=\"none\" d=\"", colour,
                    width);
        for (std::uint32_t e = 0; e < b.wall.size(); ++e)
            if ((b.wall[e] != 0) == walls) {
                point('M', b.axis.node[b.axis.from[2 * e]]);
                point('L', b.axis.node[b.axis.to(2 * e)]);
            }
        std::printf("\"/>\n");
    }
    void end() const { std::printf("</svg>\n"); }

  private:
    void point(char how, Vec2 p) const {
        std::printf("%c%.1f %.1f", how, kMargin + scale_ * (p.x - box_.lo.x), kMargin + scale_ * (box_.hi.y - p.y));
    }

    geom::Box2 box_;
    double scale_;
};

} // namespace

int main(int argc, char** argv) {
    const std::string what = argc == 4 ? argv[1] : "";
    if (what != "axis" && what != "levels") {
        std::fprintf(stderr, "usage: draw_axis axis|levels SLICE BEAD_WIDTH\n");
        return 2;
    }
    const Loops region = largest_part(argv[2]);
    const double w = std::atof(argv[3]);
    if (region.empty() || w <= 0) {
        std::fprintf(stderr, "draw_axis: cannot draw '%s': no region or no width\n", argv[2]);
        return 3;
    }
    const double fine = w / 64;
    const fill::rings::Beading b = fill::rings::beading(
        polygon::medial_axis(region, fine, fine, fill::rings::kWallSlope), w, fill::rings::kLeastVoid * w * w);
    const Drawing out(region);
    out.area(region, "#dde6ee");
    if (what == "axis") {
        out.pieces(b, false, "#4a6fa5", 0.7);
        out.pieces(b, true, "#c03020", 2);
    } else {
        int lane = 1;
        for (Loops rest = fill::rings::beyond(b, lane, fine); !rest.empty();
             rest = fill::rings::beyond(b, ++lane, fine))
            out.area(rest, lane % 2 != 0 ? "#8fb0cc" : "#dde6ee");
        out.pieces(b, true, "#c03020", 1);
    }
    out.end();
}
