// Frames come back as they were added, whether they were kept in memory or in a file.
#include "stream/spool.hpp"

#include <gtest/gtest.h>

using namespace filum;

namespace {

std::string body(int i) {
    return std::string(static_cast<std::size_t>((i * 7919) % 90000), static_cast<char>('a' + i % 26));
}

} // namespace

TEST(Spool, GivesBackWhatItGot) {
    for (const std::size_t memory : {std::size_t{0}, std::size_t{100000}, stream::Spool::kMemory}) {
        stream::Spool spool(memory);
        for (int i = 0; i < 100; ++i) spool.add({i % 2 == 0 ? stream::Tag::span : stream::Tag::paths, body(i)});
        for (int i = 0; i < 100; ++i) {
            const auto frame = spool.next();
            ASSERT_TRUE(frame.has_value()) << i;
            EXPECT_EQ(frame->tag, i % 2 == 0 ? stream::Tag::span : stream::Tag::paths);
            EXPECT_TRUE(frame->body == body(i)) << i;
        }
        EXPECT_FALSE(spool.next().has_value());
        EXPECT_FALSE(spool.next().has_value());
    }
}

TEST(Spool, HoldsNothingAtFirst) {
    stream::Spool spool;
    EXPECT_FALSE(spool.next().has_value());
}
