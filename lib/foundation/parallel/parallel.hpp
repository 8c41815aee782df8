// Parallel loops and pipelines whose results do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace filum::parallel {

// Calls body(begin, end) for chunks of size `grain` that cover [0, n), on `threads` threads (0: all cores). Chunks
// depend on n and grain only. Throws the first exception by the order of chunks. If `threads` is positive, parallel
// work inside `body` shares these threads.
void for_chunks(std::size_t n, std::size_t grain, int threads,
                const std::function<void(std::size_t, std::size_t)>& body);

namespace detail {
using Item = std::shared_ptr<void>;
void ordered(int threads, const std::function<Item()>& source, const std::function<Item(Item)>& work,
             const std::function<void(Item)>& sink);
} // namespace detail

// Runs source -> work -> sink: work runs on all cores, and sink gets the results in the order of the source. `source`
// returns nullopt at the end. A few items per thread are in flight at most, which bounds memory.
// An exception of source or work is thrown when its turn comes, after sink has got all items before it.
template <class In, class Out>
void ordered(int threads, const std::function<std::optional<In>()>& source, const std::function<Out(In)>& work,
             const std::function<void(Out)>& sink) {
    detail::ordered(
        threads,
        [&]() -> detail::Item {
            auto item = source();
            return item ? std::make_shared<In>(std::move(*item)) : nullptr;
        },
        [&](detail::Item in) -> detail::Item {
            return std::make_shared<Out>(work(std::move(*std::static_pointer_cast<In>(in))));
        },
        [&](detail::Item out) { sink(std::move(*std::static_pointer_cast<Out>(out))); });
}

} // namespace filum::parallel
