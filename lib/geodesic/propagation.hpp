// The state of window propagation; private to lib/geodesic.
#pragma once

#include "geodesic/exact.hpp"

namespace filum::geodesic {

using surface::kNone;

// Ids in the order of a key that grows slowly: rows of width `step`, within a row first in, first out.
class BucketQueue {
  public:
    BucketQueue(std::size_t ids, double step) : row_of_(ids, kNone), step_(step) {}

    // Also moves an id forward that waits in a later row.
    void push(std::uint32_t id, double key) {
        const double r = key / step_;
        const auto row = std::max(row_, r < kRows ? static_cast<std::uint32_t>(r) : kRows);
        if (row_of_[id] <= row) return;
        row_of_[id] = row;
        if (rows_.size() <= row) rows_.resize(row + 1);
        rows_[row].push_back(id);
    }
    // What the keys of the row that is at work are at least.
    [[nodiscard]] double begin() const { return row_ * step_; }
    // The next id, or kNone if no other has a key below `end`, but for the width of a row.
    std::uint32_t pop(double end) {
        for (; row_ < rows_.size() && row_ * step_ < end; ++row_, at_ = 0) {
            while (at_ < rows_[row_].size()) {
                const std::uint32_t id = rows_[row_][at_++];
                if (row_of_[id] != row_) continue; // it moved forward
                row_of_[id] = kNone;
                return id;
            }
            std::vector<std::uint32_t>().swap(rows_[row_]); // "= {}" would keep the memory
        }
        return kNone;
    }

  private:
    static constexpr std::uint32_t kRows = 1U << 20; // all that is farther shares the last row
    std::vector<std::vector<std::uint32_t>> rows_;
    std::vector<std::uint32_t> row_of_; // kNone: waits nowhere
    double step_;
    std::uint32_t row_ = 0;
    std::size_t at_ = 0;
};

inline constexpr double kSlack = 1e-10; // of a mean edge, and of a distance: differences that count as none

class Propagation {
  public:
    // Keeps no windows but those that count for what is still to come, if it `forgets`.
    Propagation(const Surface& surface, bool forgets, std::shared_ptr<const Ground> ground);

    void shut(std::span<const char> triangles) { shut_ = triangles; } // which must live on
    void add(const Sources& sources);
    // Returns up to where all is found.
    double run(double farthest, std::uint64_t most);
    ExactField take() { return std::move(field_); }

  private:
    // A side of a triangle that windows leave by, in the frame of the list that they come to.
    struct Side {
        std::uint32_t list;
        std::uint32_t tail, head; // its ends
        double length;
        std::uint32_t third;          // the triangle's corner opposite to it,
        double tx, ty;                // which lies here,
        bool from_right;              // and beats what it beats from the far end of windows: the upper one if true
        std::uint32_t cursor = kNone; // a window of the list that lies before whatever comes
    };
    [[nodiscard]] Side exit_across(std::uint32_t h, bool from_right) const;

    void add_vertex(std::uint32_t vertex);
    void add_point(std::uint32_t triangle, const Vec3& p);
    void add_on_side(std::uint32_t h, double x);
    void add_line(const Segment& s);
    void leave_vertex(std::uint32_t vertex);
    void reach(std::uint32_t vertex, double distance);
    void cross(std::uint32_t h);
    void reach_missed(std::uint32_t h);
    void offer(Side& exit, double b0, double b1, double sx, double sy, double sigma, bool line);
    void insert(Side& exit, const Window& w);
    void rewrite(Side& exit, std::uint32_t before, std::uint32_t first, std::uint32_t after);
    [[nodiscard]] double slack(double distance, double length) const;
    std::uint32_t fresh();
    void forget(std::uint32_t list);

    struct Piece {
        std::uint32_t owner; // index into owners_
        double b0, b1;
    };
    void add_piece(std::uint32_t owner, double b0, double b1, double length);
    void add_overlap(std::uint32_t old, double lo, double hi, double length);

    const Surface& surface_;
    bool forgets_;
    ExactField field_;
    std::vector<std::uint32_t> free_;
    std::vector<Window> owners_; // of the pieces: first the new window, then the old ones
    std::vector<Piece> pieces_;
    bool changed_ = false; // some piece is of the new window
    std::shared_ptr<const Ground> ground_;
    std::span<const char> shut_; // per triangle, or none: windows do not cross it
    std::vector<char> spreads_;  // per vertex: paths may start or bend there, the sources included
    double slack_;               // mm: smaller differences count as none
    BucketQueue queue_;          // half-edges, then vertices
};

} // namespace filum::geodesic
