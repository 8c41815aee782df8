// Spans made moves on all cores, ahead of the walker that takes them one after the other.
#pragma once

#include "postproc/walk.hpp"
#include "stream/spool.hpp"

#include <functional>

namespace filum::app::postproc {

// Moves of a machine of three axes; those of rotary axes need to know how all axes stood before.
class Ahead {
  public:
    // `joins`: of the whole toolpath, when each() is first called.
    Ahead(const machine::Profile& profile, const filum::postproc::Joins& joins, int threads)
        : profile_(&profile), joins_(&joins), threads_(threads) {}

    // Hands on what `spool` still has, in its order, with the moves of what is laid (else none).  Those of the first
    // time are kept for the second, up to kMost; the others are worked out again.
    using Take = std::function<void(toolpath::Span span, const toolpath::Merged* moves)>;
    void each(stream::Spool& spool, const Take& take);

  private:
    static constexpr std::size_t kMost = std::size_t{1} << 19; // moves: 46 MB
    struct Item;
    const machine::Profile* profile_;
    const filum::postproc::Joins* joins_;
    int threads_;
    std::vector<toolpath::Merged> kept_; // of the first spans, one for each
    std::size_t moves_ = 0;              // of all of them
    bool first_ = true;
};

} // namespace filum::app::postproc
