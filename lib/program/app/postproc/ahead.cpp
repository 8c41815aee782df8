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

void MoveQueue::Steps::add(const toolpath::MergeSteps& steps) {
    begins.insert(begins.end(), steps.begins.begin(), steps.begins.end());
    turns.insert(turns.end(), steps.turns.begin(), steps.turns.end());
    ends.push_back({begins.size(), turns.size(), steps.off});
}

toolpath::MergeSteps MoveQueue::Steps::of(std::size_t span) const {
    const End from = span > 0 ? ends[span - 1] : End{0, 0, 0}, to = ends[span];
    const auto part = [](const auto& list, std::size_t first, std::size_t last) {
        return std::vector(list.begin() + static_cast<std::ptrdiff_t>(first),
                           list.begin() + static_cast<std::ptrdiff_t>(last));
    };
    return {part(begins, from.begins, to.begins), part(turns, from.turns, to.turns), to.off};
}

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
            item.moves = toolpath::merge_again(item.span, steps_.of(item.index - kept_.size()));
        return item;
    };
    bool room = keeps;
    const auto hand_on = [&](Item item) {
        const bool laid = merges && toolpath::extrudes(item.span.role);
        take(std::move(item.span), !laid ? nullptr : kept(item) ? &kept_[item.index] : &item.moves);
        if (!keeps) return;
        room = room && moves_ + item.moves.moves.size() <= kMost;
        if (!room) return steps_.add(item.moves.steps);
        moves_ += item.moves.moves.size();
        item.moves.steps = {};
        kept_.push_back(std::move(item.moves));
    };
    parallel::ordered<Item, Item>(threads_, next, work, hand_on);
}

} // namespace filum::app::postproc
