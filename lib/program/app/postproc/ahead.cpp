#include "app/postproc/ahead.hpp"

#include "parallel/parallel.hpp"
#include "wire/planar.hpp"

#include <utility>

namespace filum::app::postproc {

struct MoveQueue::Item {
    std::size_t index = 0;
    stream::RawFrame frame;
    toolpath::Span span;
    toolpath::MergeResult moves; // empty if an earlier call has kept them
};

void MoveQueue::each(stream::Spool& spool, const Take& take) {
    const bool merges = !profile_->axes.active(), keeps = std::exchange(first_, false) && merges;
    std::size_t count = 0;
    const auto next = [&]() -> std::optional<Item> {
        auto frame = spool.next();
        if (!frame) return std::nullopt;
        return Item{count++, std::move(*frame), {}, {}};
    };
    const auto kept = [&](const Item& item) { return !keeps && item.index < kept_.size(); };
    const auto work = [&](Item item) {
        item.span = wire::span(item.frame);
        if (!merges || kept(item) || !toolpath::extrudes(item.span.role)) return item;
        if (keeps)
            item.moves = filum::postproc::merged(*profile_, item.span, joins_);
        else
            item.moves = toolpath::merge_again(item.span, steps_[item.index - kept_.size()]);
        return item;
    };
    bool room = keeps;
    const auto hand_on = [&](Item item) {
        const bool laid = merges && toolpath::extrudes(item.span.role);
        take(std::move(item.span), !laid ? nullptr : kept(item) ? &kept_[item.index] : &item.moves);
        if (!keeps) return;
        room = room && moves_ + item.moves.moves.size() <= kMost;
        if (!room) return steps_.push_back(std::move(item.moves.steps));
        moves_ += item.moves.moves.size();
        item.moves.steps = {};
        kept_.push_back(std::move(item.moves));
    };
    parallel::ordered<Item, Item>(threads_, next, work, hand_on);
}

} // namespace filum::app::postproc
