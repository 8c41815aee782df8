// race chunks|queue|none: a sum that every thread adds to without a lock, in a loop or in the ordered queue, or with
// one.
#include "parallel/parallel.hpp"

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string_view>
#include <thread>

namespace {

using namespace filum;

constexpr std::size_t kItems = 64;
constexpr int kThreads = 4;

std::size_t sum_in_chunks(bool locked) {
    std::size_t sum = 0;
    std::mutex one;
    parallel::for_chunks(kItems, 1, kThreads, [&](std::size_t begin, std::size_t) {
        std::unique_lock lock(one, std::defer_lock);
        if (locked) lock.lock();
        sum += begin;
    });
    return sum;
}

// The queue's source and sink run on one thread at a time and need no lock; its work does.
std::size_t sum_in_queue(bool in_work) {
    std::size_t next = 0, sum = 0;
    parallel::ordered<std::size_t, std::size_t>(
        kThreads, [&] { return next < kItems ? std::optional(next++) : std::nullopt; },
        [&](std::size_t i) {
            if (in_work) sum += i;
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // so that the others are at work, too
            return i;
        },
        [&](std::size_t i) {
            if (!in_work) sum += i;
        });
    return sum;
}

} // namespace

int main(int argc, char** argv) {
    const std::string_view way = argc > 1 ? argv[1] : "none";
    if (way == "chunks") std::printf("%zu\n", sum_in_chunks(false));
    if (way == "queue") std::printf("%zu\n", sum_in_queue(true));
    if (way == "none") std::printf("%zu %zu\n", sum_in_chunks(true), sum_in_queue(false));
    return 0;
}
