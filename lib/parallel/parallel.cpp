#include "parallel/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <vector>

namespace filum::parallel {

namespace tbb = oneapi::tbb;

namespace {

int thread_count(int threads) { return threads > 0 ? threads : std::max(1, tbb::info::default_concurrency()); }

} // namespace

void for_chunks(std::size_t n, std::size_t grain, int threads,
                const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t chunks = (n + grain - 1) / grain;
    const int count = thread_count(threads);
    if (count == 1 || chunks <= 1) {
        for (std::size_t c = 0; c < chunks; ++c) body(c * grain, std::min(n, (c + 1) * grain));
        return;
    }
    std::vector<std::exception_ptr> failed(chunks);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
    tbb::task_arena arena(count);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
            try {
                body(c * grain, std::min(n, (c + 1) * grain));
            } catch (...) {
                failed[c] = std::current_exception();
            }
        });
    });
    for (const auto& f : failed)
        if (f) std::rethrow_exception(f);
}

namespace detail {

void ordered(int threads, const std::function<Item()>& source, const std::function<Item(Item)>& work,
             const std::function<void(Item)>& sink) {
    const int count = thread_count(threads);
    if (count == 1) {
        while (Item item = source()) sink(work(std::move(item)));
        return;
    }
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
    tbb::task_arena arena(count);
    arena.execute([&] {
        tbb::parallel_pipeline(static_cast<std::size_t>(4 * count),
                               tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order,
                                                            [&](tbb::flow_control& flow) -> Item {
                                                                Item item = source();
                                                                if (!item) flow.stop();
                                                                return item;
                                                            }) &
                                   tbb::make_filter<Item, Item>(tbb::filter_mode::parallel, work) &
                                   tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order, sink));
    });
}

} // namespace detail

} // namespace filum::parallel
