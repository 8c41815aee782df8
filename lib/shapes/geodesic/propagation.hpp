// The state of window propagation; private to lib/shapes/geodesic.
#pragma once

#include "geodesic/exact.hpp"

namespace filum::geodesic {

using surface::kNone;

// A queue of ids by a key that grows slowly: buckets of width `step`, first in, first out within a bucket.
class BucketQueue {
  public:
    BucketQueue(std::size_t ids, double step) : row_of_(ids, kNone), step_(step) {}

    // Adds an id, or moves it from a later bucket to an earlier one.
    void push(std::uint32_t id, double key) {
        const double r = key / step_;
        const auto row = std::max(row_, r < kRows ? static_cast<std::uint32_t>(r) : kRows);
        if (row_of_[id] <= row) return;
        row_of_[id] = row;
        if (rows_.size() <= row) rows_.resize(row + 1);
        rows_[row].push_back(id);
    }
    // Lower bound of the keys in the current bucket.
    [[nodiscard]] double begin() const { return row_ * step_; }
    // The next id, or kNone if no other has a key below `end`, up to the width of a bucket.
    std::uint32_t pop(double end) {
        for (; row_ < rows_.size() && row_ * step_ < end; ++row_, at_ = 0) {
            while (at_ < rows_[row_].size()) {
                const std::uint32_t id = rows_[row_][at_++];
                if (row_of_[id] != row_) continue; // it was moved to an earlier bucket
                row_of_[id] = kNone;
                return id;
            }
            std::vector<std::uint32_t>().swap(rows_[row_]); // "= {}" would keep the memory
        }
        return kNone;
    }

  private:
    static constexpr std::uint32_t kRows = 1U << 20; // all farther keys share the last bucket
    std::vector<std::vector<std::uint32_t>> rows_;
    std::vector<std::uint32_t> row_of_; // kNone: not in the queue
    double step_;
    std::uint32_t row_ = 0;
    std::size_t at_ = 0;
};

inline constexpr double kSlack = 1e-10; // mean edges, or distances: smaller differences count as none

class Propagation {
  public:
    // If `forgets`, windows are freed once they can no longer matter.
    Propagation(const Surface& surface, bool forgets, std::shared_ptr<const Unfolding> unfolding);

    void shut(std::span<const char> triangles) { shut_ = triangles; } // must outlive the object
    void add(const Sources& sources);
    // Returns the distance up to which everything is found.
    double run(double farthest, std::uint64_t most);
    ExactField take() { return std::move(field_); }

  private:
    // A side of a triangle by which windows leave, in the frame of the list that they reach.
    struct ExitSide {
        std::uint32_t list;
        std::uint32_t tail, head; // its ends
        double length;
        std::uint32_t third; // the opposite corner of the triangle
        double tx, ty;       // position of that corner
        bool from_right;     // which end of a window is compared with the path via that corner: the upper one if true
        std::uint32_t cursor = kNone; // a window of the list before which no new one comes
    };
    [[nodiscard]] ExitSide exit_across(std::uint32_t h, bool from_right) const;

    void add_vertex(std::uint32_t vertex);
    void add_point(std::uint32_t triangle, const Vec3& p);
    void add_on_side(std::uint32_t h, double x);
    void add_line(const Segment& s);
    void leave_vertex(std::uint32_t vertex);
    void reach(std::uint32_t vertex, double distance);
    void cross(std::uint32_t h);
    void reach_missed(std::uint32_t h);
    void offer(ExitSide& exit, double b0, double b1, double sx, double sy, double sigma, bool line);
    void insert(ExitSide& exit, const Window& w);
    void rewrite(ExitSide& exit, std::uint32_t before, std::uint32_t first, std::uint32_t after);
    [[nodiscard]] double slack(double distance, double length) const;
    std::uint32_t fresh();
    void forget(std::uint32_t list);

    struct EnvelopePiece {
        std::uint32_t owner; // index into owners_
        double b0, b1;
    };
    void add_piece(std::uint32_t owner, double b0, double b1, double length);
    void add_overlap(std::uint32_t old, double lo, double hi, double length);

    const Surface& surface_;
    bool forgets_;
    ExactField field_;
    std::vector<std::uint32_t> free_;
    std::vector<Window> owners_; // of the pieces: the new window, then the old ones
    std::vector<EnvelopePiece> pieces_;
    bool changed_ = false; // whether a piece belongs to the new window
    std::shared_ptr<const Unfolding> unfolding_;
    std::span<const char> shut_; // per triangle, or empty: windows do not cross it
    std::vector<char> bends_;    // per vertex: paths may start or bend there: saddle vertices and sources
    double slack_;               // mm: smaller differences count as none
    BucketQueue queue_;          // of half-edges, then vertices
};

} // namespace filum::geodesic
