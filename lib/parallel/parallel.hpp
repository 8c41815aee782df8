// Work on all cores with results that do not depend on how many there are.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace filum::parallel {

// Calls body(begin, end) for chunks of fixed size `grain` covering [0, n), on `threads` threads (0: all cores).
// Chunk borders depend on n and grain alone.  The first exception, by chunk order, is thrown on.  What `body` runs in
// parallel in its turn takes no more than these threads, all together, if they are a number.
void for_chunks(std::size_t n, std::size_t grain, int threads,
                const std::function<void(std::size_t, std::size_t)>& body);

namespace detail {
using Item = std::shared_ptr<void>;
void ordered(int threads, const std::function<Item()>& source, const std::function<Item(Item)>& work,
             const std::function<void(Item)>& sink);
} // namespace detail

// source -> work -> sink, where work runs on all cores and sink sees the results in the order of the source.
// `source` returns nullopt at the end; at most a few items per thread are in flight, so memory stays bounded.
// An exception of source or work is thrown on when its turn comes: the sink has then seen all items before it.
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
