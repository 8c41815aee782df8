#include "parallel/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace filum::parallel {
namespace {

TEST(ForChunks, CoversEverythingOnceInTheSameChunksForAnyThreads) {
    for (const std::size_t n : {0U, 1U, 7U, 8U, 9U, 1000U}) {
        std::set<std::pair<std::size_t, std::size_t>> first;
        for (const int threads : {1, 2, 8, 0}) {
            std::vector<std::atomic<int>> seen(n);
            std::set<std::pair<std::size_t, std::size_t>> chunks;
            std::mutex guard;
            for_chunks(n, 8, threads, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) ++seen[i];
                const std::lock_guard lock(guard);
                chunks.emplace(begin, end);
            });
            for (const auto& s : seen) EXPECT_EQ(s, 1);
            if (threads == 1) first = chunks;
            EXPECT_EQ(chunks, first);
        }
    }
}

TEST(ForChunks, OneThreadIsAllThatWorkWithinGets) {
    for (const std::size_t outer : {1U, 3U}) {
        std::set<std::thread::id> ids;
        std::mutex guard;
        for_chunks(outer, 1, 1, [&](std::size_t, std::size_t) {
            for_chunks(64, 1, 0, [&](std::size_t, std::size_t) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1)); // so that others had time to help
                const std::lock_guard lock(guard);
                ids.insert(std::this_thread::get_id());
            });
        });
        EXPECT_EQ(ids, std::set{std::this_thread::get_id()});
    }
}

TEST(ForChunks, ThrowsTheFirstFailureByPlace) {
    for (const int threads : {1, 2, 8}) {
        try {
            for_chunks(100, 1, threads, [](std::size_t i, std::size_t) {
                if (i >= 30) throw std::runtime_error(std::to_string(i));
            });
            FAIL();
        } catch (const std::runtime_error& e) {
            EXPECT_STREQ(e.what(), "30");
        }
    }
}

// What the sink saw, and what was thrown, "" for nothing.
struct Observation {
    std::vector<int> seen;
    std::string thrown;
    bool operator==(const Observation&) const = default;
};

Observation run(int threads, int n, int work_fails, int source_fails) {
    Observation out;
    int i = 0;
    try {
        ordered<int, int>(
            threads,
            [&]() -> std::optional<int> {
                if (i == source_fails) throw std::runtime_error("source");
                return i < n ? std::optional(i++) : std::nullopt;
            },
            [&](int v) {
                if (v % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
                if (v >= work_fails) throw std::runtime_error("work " + std::to_string(v));
                return v * v;
            },
            [&](int v) { out.seen.push_back(v); });
    } catch (const std::runtime_error& e) {
        out.thrown = e.what();
    }
    return out;
}

TEST(Ordered, TheSinkSeesTheOrderOfTheSource) {
    for (const int threads : {1, 2, 8}) {
        const Observation r = run(threads, 500, 1000, -1);
        ASSERT_EQ(r.seen.size(), 500U);
        for (std::size_t k = 0; k < 500; ++k) ASSERT_EQ(r.seen[k], static_cast<int>(k * k));
    }
}

TEST(Ordered, FailuresAreTheSameForAnyThreads) {
    const Observation work = run(1, 500, 100, -1), source = run(1, 500, 1000, 50), both = run(1, 500, 40, 50);
    EXPECT_EQ(work.thrown, "work 100");
    EXPECT_EQ(work.seen.size(), 100U);
    EXPECT_EQ(source.thrown, "source");
    EXPECT_EQ(source.seen.size(), 50U);
    EXPECT_EQ(both.thrown, "work 40");
    for (const int threads : {2, 8}) {
        EXPECT_EQ(run(threads, 500, 100, -1), work);
        EXPECT_EQ(run(threads, 500, 1000, 50), source);
        EXPECT_EQ(run(threads, 500, 40, 50), both);
    }
}

TEST(Ordered, OnlyAFewItemsAreInFlight) {
    std::atomic<int> taken{0};
    int given = 0, most = 0;
    ordered<int, int>(
        2, [&]() -> std::optional<int> { return taken < 1000 ? std::optional(taken++) : std::nullopt; },
        [](int v) { return v; },
        [&](int) {
            ++given;
            most = std::max(most, taken - given);
        });
    EXPECT_LE(most, 16);
}

} // namespace
} // namespace filum::parallel
