// The strokes of a toolpath that lean, over several attempts; private to lib/route.
#pragma once

#include "collision/check.hpp"
#include "route/tilt.hpp"

namespace filum::route {

class Tilting {
  public:
    // `rotary`: see collision::Machine.  Spans have two points at least.
    Tilting(const std::vector<toolpath::Span>& spans, bool rotary);

    // Takes the collisions of the moves along `spans`, the last attempt, and whether the head has room where strokes
    // begin and end, which is between two places that check() looks at; keeps the attempt at each stroke if it has
    // fewer than all before.  True if another attempt at some stroke makes sense.
    bool judge(const std::vector<collision::Move>& moves, const collision::Found& found,
               const std::vector<toolpath::Span>& spans, const collision::Rooms& rooms);

    // Another attempt at each stroke whose head meets something it need not: changes `spans`.
    void lean(const collision::Rooms& rooms, const TiltOptions& options, const Pace& pace, int threads,
              std::vector<toolpath::Span>& spans);

    // What is stuck after the last attempt may not be after the next: it asked for more room than is needed.
    void hope();

    // Puts the best attempts into `spans`, and says what they are, where the tool leans.
    std::vector<Leaning> best(std::vector<toolpath::Span>& spans) const;

  private:
    struct Attempt {
        std::size_t first = 0, last = 0; // spans
        Stroke stroke;                   // as given; blocked: by any attempt so far
        Leant now, best;
        std::size_t met = 0, fewest = 0; // moves that collide: now, and in the best
        std::size_t hopeful = 0;         // of those now, where some tilt may give room
        bool tried = false;
    };
    // Of a segment that was cut, the one it was; per span of all.
    [[nodiscard]] static std::uint32_t origin(const Attempt& a, std::size_t span, std::uint32_t segment);

    // As a collision::Walk has it.
    [[nodiscard]] collision::Stance stance(const toolpath::Span& span, std::size_t i) const;

    std::vector<toolpath::Span> given_;
    std::vector<Attempt> strokes_;
    std::vector<std::int64_t> stroke_of_; // by span; -1: a travel
    bool rotary_;
};

} // namespace filum::route
