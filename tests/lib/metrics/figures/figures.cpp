// Named numbers as text.
#include "metrics/figures/figures.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace filum::metrics::figures {

namespace {

TEST(Figures, AreWrittenThreeWays) {
    const Figures f{{"one", "a count", std::uint64_t{7}},
                    {"one", "a length", 1.5, 2, "mm"},
                    {"two", "none", INFINITY},
                    {"two", "text", std::string("say \"hi\"\tthere")},
                    {"two", "zero", -1e-12, 1}};
    EXPECT_EQ(text(f, Format::table), "one\n  a count      7\n  a length  1.50 mm\n\ntwo\n  none         -\n  text     "
                                      " say \"hi\"\\tthere\n  zero       0.0\n");
    EXPECT_EQ(text(f, Format::tsv),
              "group\tname\tvalue\tunit\none\ta count\t7\t\none\ta length\t1.50\tmm\ntwo\tnone\t-\t\ntwo\ttext\tsay "
              "\"hi\"\\tthere\t\ntwo\tzero\t0.0\t\n");
    EXPECT_EQ(text(f, Format::json),
              "{\n  \"one\": {\n    \"a_count\": 7,\n    \"a_length_mm\": 1.50\n  },\n  \"two\": {\n    \"none\": "
              "null,\n    \"text\": \"say \\\"hi\\\"\\u0009there\",\n    \"zero\": 0.0\n  }\n}\n");
    EXPECT_EQ(text({}, Format::json), "{}\n");
}

} // namespace

} // namespace filum::metrics::figures
