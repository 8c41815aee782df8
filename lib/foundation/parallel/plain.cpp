// The same loops and queue as in parallel.cpp, on plain threads.  ThreadSanitizer (preset `threads`) sees every lock
// and every join of these; of oneTBB, as Debian builds it, it sees neither, and would report races that there are not.
#ifdef FILUM_PLAIN_THREADS

#include "parallel/parallel.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace filum::parallel {

namespace {

// Loops within loops start threads of their own up to this depth; deeper ones run where they are.
constexpr int kDeepest = 2;
thread_local int depth = 0;

std::size_t thread_count(int threads) {
    return threads > 0 ? static_cast<std::size_t>(threads) : std::max(2U, std::thread::hardware_concurrency());
}

// Runs body(k) on `count` threads at once, k from 0, and waits for all of them.
void on_threads(std::size_t count, const std::function<void(std::size_t)>& body) {
    std::vector<std::thread> team;
    team.reserve(count);
    const int below = depth + 1;
    if (count == 1) return body(0);
    for (std::size_t k = 0; k < count; ++k)
        team.emplace_back([&body, below, k] {
            depth = below;
            body(k);
        });
    for (auto& t : team) t.join();
}

} // namespace

void for_chunks(std::size_t n, std::size_t grain, int threads,
                const std::function<void(std::size_t, std::size_t)>& body) {
    grain = std::max<std::size_t>(grain, 1);
    const std::size_t chunks = n / grain + (n % grain != 0 ? 1 : 0),
                      count = depth < kDeepest ? std::min(thread_count(threads), chunks) : 1;
    std::vector<std::exception_ptr> failed(chunks);
    // Thread k takes chunk k and every `count`th after it: each takes its part however short the work is.
    const auto work = [&](std::size_t k) {
        for (std::size_t c = k; c < chunks; c += count) {
            try {
                body(c * grain, c * grain + std::min(n - c * grain, grain));
            } catch (...) {
                failed[c] = std::current_exception();
            }
        }
    };
    on_threads(count, work);
    for (const auto& f : failed)
        if (f) std::rethrow_exception(f);
}

namespace detail {

namespace {

// Who takes an item from the source and who hands one to the sink does so alone, in the order of the source; the
// threads take turns.
struct Line {
    std::size_t threads = 1;
    std::mutex at_source, at_sink;
    std::condition_variable next, turn;
    std::size_t taken = 0, given = 0;
    bool last = false;         // the source is at its end, or failed
    bool stop = false;         // an item failed
    std::exception_ptr failed; // why
};

// Thread `k` takes, works on and hands over one item; false at the end.
bool pass_one(Line& line, std::size_t k, const std::function<Item()>& source, const std::function<Item(Item)>& work,
              const std::function<void(Item)>& sink) {
    Item item;
    std::exception_ptr failed;
    std::size_t number = 0;
    {
        std::unique_lock lock(line.at_source);
        line.next.wait(lock, [&] { return line.last || line.taken % line.threads == k; });
        if (line.last) return false;
        try {
            item = source();
        } catch (...) {
            failed = std::current_exception();
        }
        line.last = !item;
        number = line.taken++;
        line.next.notify_all();
        if (!item && !failed) return false;
    }
    try {
        if (!failed) item = work(std::move(item));
    } catch (...) {
        failed = std::current_exception();
    }
    std::unique_lock lock(line.at_sink);
    line.turn.wait(lock, [&] { return line.given == number; });
    if (!line.stop) {
        try {
            if (failed) std::rethrow_exception(failed);
            sink(std::move(item));
        } catch (...) {
            line.failed = std::current_exception();
            line.stop = true;
        }
    }
    ++line.given;
    line.turn.notify_all();
    if (!line.stop) return true;
    lock.unlock();
    const std::lock_guard end(line.at_source); // nobody waits for this thread's turn any more
    line.last = true;
    line.next.notify_all();
    return false;
}

} // namespace

void ordered(int threads, const std::function<Item()>& source, const std::function<Item(Item)>& work,
             const std::function<void(Item)>& sink) {
    Line line;
    line.threads = thread_count(threads);
    on_threads(line.threads, [&](std::size_t k) {
        while (pass_one(line, k, source, work, sink)) {
        }
    });
    if (line.failed) std::rethrow_exception(line.failed);
}

} // namespace detail

} // namespace filum::parallel

#endif // FILUM_PLAIN_THREADS
