// Computes the moves of spans on all cores, ahead of the walker that takes them one after the other.
#pragma once

#include "postproc/walk.hpp"
#include "stream/spool.hpp"

#include <functional>

namespace filum::app::postproc {

// The moves of a machine with three axes.  With rotary axes none are computed, since their moves depend on the previous
// positions of all axes.
class MoveQueue {
  public:
    // `joins`: those of the whole toolpath; they must be complete when each() is called first.
    MoveQueue(const machine::Profile& profile, const filum::postproc::Joins& joins, int threads)
        : profile_(&profile), joins_(&joins), threads_(threads) {}

    // Passes the remaining spans of `spool` to `take`, in their order.  `moves` is null for a span that does not
    // extrude. The first call keeps up to kMost moves for later calls, and the steps of all further ones.
    using Take = std::function<void(toolpath::Span span, const toolpath::MergeResult* moves)>;
    void each(stream::Spool& spool, const Take& take);

  private:
    static constexpr std::size_t kMost = std::size_t{1} << 19; // moves: 46 MB
    struct Item;
    const machine::Profile* profile_;
    const filum::postproc::Joins* joins_;
    int threads_;
    std::vector<toolpath::MergeResult> kept_; // moves of the first spans, one item for each
    std::size_t moves_ = 0;                   // number of moves in kept_
    // The steps of the spans after those in kept_, in few lists, as most spans may be short.
    struct Steps {
        std::vector<std::uint32_t> begins;
        std::vector<toolpath::MergeSteps::Turn> turns;
        struct End {
            std::size_t begins, turns; // of all spans up to this one
            double off;
        };
        std::vector<End> ends;

        void add(const toolpath::MergeSteps& steps);
        [[nodiscard]] toolpath::MergeSteps of(std::size_t span) const;
    };
    Steps steps_;
    bool first_ = true;
};

} // namespace filum::app::postproc
