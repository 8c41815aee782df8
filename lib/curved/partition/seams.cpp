#include "partition/seams.hpp"
#include "geom/angle.hpp"
#include "partition/flood.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace filum::partition {

namespace {

constexpr double kBlunt = std::numbers::pi / 3;

class CreaseFilter {
  public:
    CreaseFilter(const Surface& s, double least) : s_(s), seam_(s.twin.size(), 0) {
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t) normal_.push_back(surface::normal(s, t));
        for (std::uint32_t h = 0; h < seam_.size(); ++h)
            if (inner(h) && bend(h) > least) set(h, 1);
    }

    // Removes seams that end inside the surface, starting from their ends.
    void drop_dead_ends() {
        std::vector<std::uint32_t> count(s_.vertices.size(), 0), pending;
        for (std::uint32_t h = 0; h < seam_.size(); ++h)
            if (seam_[h] != 0 || s_.twin[h] == kNone) {
                ++count[s_.tail(h)];
                if (s_.twin[h] == kNone) ++count[s_.head(h)];
            }
        for (std::uint32_t v = 0; v < count.size(); ++v)
            if (count[v] == 1) pending.push_back(v);
        while (!pending.empty()) {
            const std::uint32_t v = pending.back();
            pending.pop_back();
            surface::each_outgoing(s_, v, [&](std::uint32_t h) {
                if (count[v] != 1 || seam_[h] == 0) return;
                set(h, 0);
                --count[v];
                if (--count[s_.head(h)] == 1) pending.push_back(s_.head(h));
            });
        }
    }

    // Merges small faces with the neighbour along the longest crease, if that is blunt or the face is tiny, until
    // nothing changes.
    void drop_round_small(double least_area, double detail_area) {
        for (bool changed = true; changed;) {
            changed = false;
            const std::vector<std::uint32_t> face = faces();
            std::vector<double> area(1 + *std::max_element(face.begin(), face.end()), 0);
            for (std::uint32_t t = 0; t < face.size(); ++t) area[face[t]] += size(t);
            std::map<std::uint32_t, std::vector<std::uint32_t>> sides; // of each small face
            for (std::uint32_t h = 0; h < seam_.size(); ++h)
                if (seam_[h] != 0 && area[face[h / 3]] < least_area && face[h / 3] != face[s_.twin[h] / 3])
                    sides[face[h / 3]].push_back(h);
            for (const auto& [f, list] : sides) changed = drop_border(list, face, area[f] < detail_area) || changed;
        }
    }

    std::vector<char> take() { return std::move(seam_); }

  private:
    struct Border {
        double length = 0, bend = 0; // bend times length
    };

    [[nodiscard]] bool inner(std::uint32_t h) const { return s_.twin[h] != kNone; }
    [[nodiscard]] double bend(std::uint32_t h) const { return geom::angle(normal_[h / 3], normal_[s_.twin[h] / 3]); }
    void set(std::uint32_t h, char to) { seam_[h] = seam_[s_.twin[h]] = to; }
    [[nodiscard]] double length(std::uint32_t h) const { return surface::side_length(s_, h); }
    [[nodiscard]] double size(std::uint32_t t) const { return surface::area(s_, t); }

    // Per triangle the number of the face that seams enclose.
    [[nodiscard]] std::vector<std::uint32_t> faces() const {
        return flood(s_, [&](std::uint32_t h) { return seam_[h] == 0; });
    }

    // `sides`: those of one face towards others; `sharp`: remove them however much they bend.
    bool drop_border(const std::vector<std::uint32_t>& sides, const std::vector<std::uint32_t>& face, bool sharp) {
        std::map<std::uint32_t, Border> all;
        for (const std::uint32_t h : sides) {
            Border& b = all[face[s_.twin[h] / 3]];
            b.length += length(h);
            b.bend += length(h) * bend(h);
        }
        const auto longest = std::max_element(
            all.begin(), all.end(), [](const auto& a, const auto& b) { return a.second.length < b.second.length; });
        if (!sharp && longest->second.bend > kBlunt * longest->second.length) return false;
        bool changed = false;
        for (const std::uint32_t h : sides)
            if (face[s_.twin[h] / 3] == longest->first && seam_[h] != 0) {
                set(h, 0);
                changed = true;
            }
        return changed;
    }

    const Surface& s_;
    std::vector<Vec3> normal_;
    std::vector<char> seam_;
};

} // namespace

std::vector<char> seams(const Sheet& sheet, const SeamOptions& options) {
    const Surface& s = sheet.surface;
    if (options.faces && sheet.faces.empty())
        throw Error(Exit::usage, "cannot use --faces: the surface has no CAD faces, as it comes from a mesh file");
    CreaseFilter creases(s, geom::radians(options.crease_deg));
    creases.drop_round_small(options.least_area, options.detail_area);
    creases.drop_dead_ends();
    std::vector<char> out = creases.take();
    for (std::uint32_t h = 0; h < out.size() && options.faces; ++h)
        if (s.twin[h] != kNone && sheet.faces[h / 3] != sheet.faces[s.twin[h] / 3]) out[h] = 1;
    return out;
}

} // namespace filum::partition
