#include "stream/crc32c.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace filum::stream {
namespace {

// RFC 3720, appendix B.4.
TEST(Crc32c, KnownAnswers) {
    std::string zeros(32, '\0'), ones(32, '\xff'), up, down;
    for (int i = 0; i < 32; ++i) {
        up.push_back(static_cast<char>(i));
        down.push_back(static_cast<char>(31 - i));
    }
    EXPECT_EQ(crc32c(0, zeros.data(), 32), 0x8a9136aaU);
    EXPECT_EQ(crc32c(0, ones.data(), 32), 0x62a8ab43U);
    EXPECT_EQ(crc32c(0, up.data(), 32), 0x46dd794eU);
    EXPECT_EQ(crc32c(0, down.data(), 32), 0x113fdb5cU);
    EXPECT_EQ(crc32c(0, "123456789", 9), 0xe3069283U);
    EXPECT_EQ(crc32c(0, "", 0), 0U);
}

std::uint32_t bit_by_bit(const std::string& s) {
    std::uint32_t crc = ~0U;
    for (const char c : s) {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k) crc = (crc & 1) != 0 ? 0x82f63b78 ^ (crc >> 1) : crc >> 1;
    }
    return ~crc;
}

// Sizes around the lanes of the fast path, and any split of the bytes.
TEST(Crc32c, EqualsTheDefinitionWholeAndInPieces) {
    std::mt19937 random(1);
    for (const std::size_t size : {1U, 7U, 8U, 9U, 4095U, 12287U, 12288U, 12289U, 40000U}) {
        std::string s(size, '\0');
        for (auto& c : s) c = static_cast<char>(random());
        const std::uint32_t want = bit_by_bit(s);
        EXPECT_EQ(crc32c(0, s.data(), size), want) << size;
        const std::size_t cut = random() % (size + 1);
        EXPECT_EQ(crc32c(crc32c(0, s.data(), cut), s.data() + cut, size - cut), want) << size << " cut at " << cut;
    }
}

} // namespace
} // namespace filum::stream
