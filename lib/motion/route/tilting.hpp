// Attempts at tilting the strokes of a toolpath. Private to lib/motion/route.
#pragma once

#include "collision/check.hpp"
#include "route/tilt.hpp"

namespace filum::route {

class StrokeTilter {
  public:
    // `rotary`: see collision::Machine. Spans must have at least two points.
    StrokeTilter(const std::vector<toolpath::Span>& spans, bool rotary);

    // Evaluates the last attempt, `spans`, by the collisions of its moves and by the room at starts and ends of
    // strokes, which check() may miss. Keeps the attempt at each stroke if it has fewer collisions than all before.
    // Returns whether another attempt at some stroke makes sense.
    bool judge(const std::vector<collision::Move>& moves, const collision::CheckResult& found,
               const std::vector<toolpath::Span>& spans, const collision::Rooms& rooms);

    // Makes another attempt at each stroke with avoidable collisions: changes `spans`.
    void lean(const collision::Rooms& rooms, const TiltOptions& options, const TestDensity& pace, int threads,
              std::vector<toolpath::Span>& spans);

    // Allows another attempt at strokes that are stuck, because the last one demanded more room than necessary.
    void hope();

    // Sets `spans` to the best attempts, and returns their summaries where the tool is tilted.
    std::vector<TiltSummary> best(std::vector<toolpath::Span>& spans) const;

  private:
    struct Attempt {
        std::size_t first = 0, last = 0; // indices of spans
        Stroke stroke;                   // as given; blocked: in any attempt so far
        TiltedStroke now, best;
        std::size_t met = 0, fewest = 0; // number of colliding moves: in this attempt, and in the best
        std::size_t hopeful = 0;         // number of those in this attempt for which some tilt may give room
        bool tried = false;
    };
    // The original segment of a segment that was divided; the span is counted over all.
    [[nodiscard]] static std::uint32_t origin(const Attempt& a, std::size_t span, std::uint32_t segment);

    // As in collision::MoveReader.
    [[nodiscard]] collision::ToolFrame stance(const toolpath::Span& span, std::size_t i) const;

    std::vector<toolpath::Span> given_;
    std::vector<Attempt> strokes_;
    std::vector<std::int64_t> stroke_of_; // per span; -1: a travel
    bool rotary_;
};

} // namespace filum::route
