#include "base/error.hpp"
#include "surface/remesh.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface {

namespace {

// Splits triangles along a plane: every crossed edge gets one new vertex, which its two triangles share.
class Cutter {
  public:
    Cutter(const Surface& s, std::span<const double> side) : surface_(s), side_(side) {
        out_.vertices = s.vertices;
        on_edge_.assign(s.twin.size(), kNone);
    }

    void keep_lower(std::uint32_t t) {
        corners_.clear();
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const double a = side_[surface_.tail(h)], b = side_[surface_.head(h)];
            if (a <= 0) corners_.push_back(surface_.tail(h));
            if (a * b < 0) corners_.push_back(crossing(h));
        }
        for (std::size_t k = 2; k < corners_.size(); ++k)
            out_.triangles.push_back({corners_[0], corners_[k - 1], corners_[k]});
    }
    mesh::Mesh take() { return std::move(out_); }

  private:
    std::uint32_t crossing(std::uint32_t h) {
        const std::uint32_t edge = std::min(h, surface_.twin[h]); // kNone is the greatest number
        std::uint32_t& v = on_edge_[edge];
        if (v == kNone) {
            const std::uint32_t a = surface_.tail(edge), b = surface_.head(edge);
            v = static_cast<std::uint32_t>(out_.vertices.size());
            out_.vertices.push_back(surface_.vertices[a] +
                                    side_[a] / (side_[a] - side_[b]) * (surface_.vertices[b] - surface_.vertices[a]));
        }
        return v;
    }

    const Surface& surface_;
    std::span<const double> side_;
    std::vector<std::uint32_t> on_edge_, corners_;
    mesh::Mesh out_;
};

constexpr double kSliver = 0.01; // share of the change along a side below which a corner moves onto the cut

// The part below, triangle by triangle; empty if nothing is below.
mesh::Mesh lower(const Surface& s, std::span<const double> side) {
    Cutter cutter(s, side);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        if (std::min({side[a], side[b], side[c]}) < 0) cutter.keep_lower(t);
    }
    return cutter.take();
}

} // namespace

Surface cut(const Surface& s, const Plane& plane, Notes& notes) {
    if (!(norm(plane.normal) > 0)) throw Error(Exit::usage, "cannot use --cut: the plane's normal is (0, 0, 0)");
    mesh::Mesh out = lower(s, sides(s, plane));
    if (out.triangles.empty())
        throw Error(Exit::usage, "cannot use --cut: nothing of the surface lies on the plane's lower side");
    return connect(std::move(out), notes);
}

Surface cut(const Surface& s, std::span<const double> side, Notes& notes) {
    std::vector<double> clear(side.begin(), side.end());
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t v = s.tail(h), w = s.head(h);
        for (const auto& [at, other] : {std::pair(v, w), std::pair(w, v)})
            if (std::abs(side[at]) < kSliver * std::abs(side[at] - side[other])) clear[at] = 0;
    }
    mesh::Mesh out = lower(s, clear);
    if (out.triangles.empty()) throw Error(Exit::usage, "cannot cut the surface: nothing would be left of it");
    return connect(std::move(out), notes);
}

} // namespace filum::surface
