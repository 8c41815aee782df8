#include "base/length_unit.hpp"

#include <gtest/gtest.h>

namespace filum {
namespace {

TEST(LengthUnit, EveryNameOfAUnitIsTheSameLengthAndOfNoOther) {
    for (const LengthUnit& u : kLengthUnits) {
        EXPECT_EQ(length_of_symbol(u.symbol), u.mm);
        EXPECT_EQ(length_of_word(u.word), u.mm);
        EXPECT_EQ(length_of_name(u.symbol), u.mm);
        EXPECT_EQ(length_of_name(u.word), u.mm);
        for (const auto& other : u.others)
            if (!other.empty()) {
                EXPECT_EQ(length_of_name(other), u.mm);
            }
    }
    for (const char* name : {"", "mpa", "yard", "MM"}) EXPECT_FALSE(length_of_name(name)) << name;
}

} // namespace
} // namespace filum
