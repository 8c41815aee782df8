#ifndef FILUM_PLAIN_THREADS // with it, plain.cpp takes the place of this file

#include "parallel/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <vector>

namespace filum::parallel {

namespace tbb = oneapi::tbb;

namespace {

int thread_count(int threads) { return threads > 0 ? threads : std::max(1, tbb::info::default_concurrency()); }

} // namespace

void for_chunks(std::size_t n, std::size_t grain, int threads,
                const std::function<void(std::size_t, std::size_t)>& body) {
    grain = std::max<std::size_t>(grain, 1);
    const std::size_t chunks = n / grain + (n % grain != 0 ? 1 : 0);
    const auto run = [&](std::size_t c) { body(c * grain, c * grain + std::min(n - c * grain, grain)); };
    const int count = thread_count(threads);
    const bool alone = count == 1 || chunks <= 1;
    std::optional<tbb::global_control> limit;
    if (threads > 0 || !alone)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
    if (alone) {
        for (std::size_t c = 0; c < chunks; ++c) run(c);
        return;
    }
    std::vector<std::exception_ptr> failed(chunks);
    tbb::task_arena arena(count);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
            try {
                run(c);
            } catch (...) {
                failed[c] = std::current_exception();
            }
        });
    });
    for (const auto& f : failed)
        if (f) std::rethrow_exception(f);
}

namespace detail {

namespace {

// What passes through the pipeline: an item or an exception. The sink throws the exception when its turn comes, so the
// items written before, and the exception that is thrown, do not depend on the number of threads.
struct Slot {
    Item item;
    std::exception_ptr failed;
};

template <class Make>
Slot guarded(const Make& make) {
    try {
        return {make(), nullptr};
    } catch (...) {
        return {nullptr, std::current_exception()};
    }
}

} // namespace

void ordered(int threads, const std::function<Item()>& source, const std::function<Item(Item)>& work,
             const std::function<void(Item)>& sink) {
    const int count = thread_count(threads);
    std::optional<tbb::global_control> limit;
    if (threads > 0 || count > 1)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
    if (count == 1) {
        while (Item item = source()) sink(work(std::move(item)));
        return;
    }
    bool last = false;              // only used by the source
    std::atomic<bool> stop = false; // set by the sink; the pipeline then runs empty, since cancelled items would leak
    std::exception_ptr failed;      // only used by the sink
    const auto from_source = [&](tbb::flow_control& flow) -> Slot {
        Slot slot = last || stop ? Slot{} : guarded(source);
        if (slot.failed)
            last = true;
        else if (!slot.item)
            flow.stop();
        return slot;
    };
    const auto at_work = [&](Slot slot) -> Slot {
        return slot.failed || stop ? slot : guarded([&] { return work(std::move(slot.item)); });
    };
    const auto to_sink = [&](Slot slot) {
        if (stop) return;
        failed = slot.failed ? slot.failed : guarded([&] {
                                                 sink(std::move(slot.item));
                                                 return Item();
                                             }).failed;
        stop = failed != nullptr;
    };
    tbb::task_arena arena(count);
    arena.execute([&] {
        constexpr auto kInOrder = tbb::filter_mode::serial_in_order;
        tbb::parallel_pipeline(4 * static_cast<std::size_t>(count),
                               tbb::make_filter<void, Slot>(kInOrder, from_source) &
                                   tbb::make_filter<Slot, Slot>(tbb::filter_mode::parallel, at_work) &
                                   tbb::make_filter<Slot, void>(kInOrder, to_sink));
    });
    if (failed) std::rethrow_exception(failed);
}

} // namespace detail

} // namespace filum::parallel

#endif
