// Closed curves as linked nodes, into which points can be put anywhere, and the segments near a place.
#pragma once

#include "absorb/tile.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <vector>

namespace filum::absorb {

struct Knot {
    Vec2 at;
    double width = 0; // mm
};

struct Node {
    Knot knot;
    std::uint32_t next = 0, before = 0;
};

// Segment i runs from node i to the next.  Nodes are put in and moved, never taken out.
class Chain {
  public:
    explicit Chain(const std::vector<toolpath::Curve>& curves);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
    [[nodiscard]] const Node& operator[](std::uint32_t i) const { return nodes_[i]; }
    [[nodiscard]] Vec2 point(std::uint32_t i) const { return nodes_[i].knot.at; }
    [[nodiscard]] Bead bead(std::uint32_t i) const {
        const Node &a = nodes_[i], &b = nodes_[a.next];
        return {a.knot.at, b.knot.at, (a.knot.width + b.knot.width) / 2};
    }
    // Its former segments end where the first node of the curves did: walks from i to there, calling f(segment).
    template <class F>
    void pieces(std::uint32_t original, F&& f) const {
        for (std::uint32_t i = original;;) {
            f(i);
            i = nodes_[i].next;
            if (i < originals_) return;
        }
    }
    void set(std::uint32_t i, const Knot& k) { nodes_[i].knot = k; }
    std::uint32_t put_after(std::uint32_t i, const Knot& k); // the new node

    // The curves as they are now.
    [[nodiscard]] std::vector<toolpath::Curve> curves() const;

  private:
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> first_; // per curve
    std::uint32_t originals_ = 0;
};

// Segments of a chain by the cells of a grid over a tile.
class Near {
  public:
    Near(const Chain& chain, const Box2& box, double cell);
    void add(std::uint32_t segment); // again where it was moved

    // Calls f(segment) for all whose cells meet the box, perhaps several times, and for some that do not any more.
    template <class F>
    void visit(Vec2 lo, Vec2 hi, F&& f) const {
        const int x0 = column(lo.x), x1 = column(hi.x), y0 = row(lo.y), y1 = row(hi.y);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                for (const std::uint32_t s : cells_[cell(x, y)]) f(s);
    }

  private:
    [[nodiscard]] int column(double x) const { return clamped((x - origin_.x) / size_, columns_); }
    [[nodiscard]] int row(double y) const { return clamped((y - origin_.y) / size_, rows_); }
    [[nodiscard]] std::size_t cell(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    static int clamped(double v, int n) { return static_cast<int>(std::clamp(v, 0.0, n - 1.0)); }

    const Chain* chain_;
    Vec2 origin_;
    double size_;
    int columns_, rows_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

} // namespace filum::absorb
