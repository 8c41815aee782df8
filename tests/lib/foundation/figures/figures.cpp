// Named numbers as text.
#include "figures/figures.hpp"
#include "figures/meanings.hpp"
#include "figures/records.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>

namespace filum::figures {

namespace {

TEST(Figures, AreWrittenThreeWays) {
    const Figures f{{"one", "a count", std::uint64_t{7}},
                    {"one", "a length", 1.5, 2, "mm"},
                    {"two", "none", INFINITY},
                    {"two", "text", std::string("say \"hi\"\tthere")},
                    {"two", "zero", -1e-12, 1}};
    EXPECT_EQ(text(f, Format::table), "one\n  a count      7\n  a length  1.50 mm\n\ntwo\n  none         -\n  text     "
                                      " say \"hi\"\\tthere\n  zero       0.0\n");
    EXPECT_EQ(
        text(f, Format::tsv),
        "key\tvalue\tunit\nreport\tmetrics\t\nversion\t1\t\na_count\t7\t\na_length_mm\t1.50\tmm\nnone\t-\t\ntext\tsay "
        "\"hi\"\\tthere\t\nzero\t0.0\t\n");
    EXPECT_EQ(text(f, Format::json, "some"), "{\n  \"report\": \"some\",\n  \"version\": 1,\n  \"a_count\": 7,\n  "
                                             "\"a_length_mm\": 1.50,\n  \"none\": null,\n  "
                                             "\"text\": \"say \\\"hi\\\"\\u0009there\",\n  \"zero\": 0.0\n}\n");
    EXPECT_EQ(text({}, Format::json), "{\n  \"report\": \"metrics\",\n  \"version\": 1\n}\n");
}

TEST(Meanings, AreToldByKey) {
    Figures out;
    tell(out, planar_meanings(), "strokes", std::uint64_t{3});
    tell(out, planar_meanings(), "width_share.*", 0.5, "from 0.40");
    tell(out, surface_meanings(), "load.*.mean", 0.25, "Case B");
    ASSERT_EQ(out.size(), 3U);
    EXPECT_EQ(out[0].key + "/" + out[0].group + "/" + out[0].name, "strokes/continuity/strokes");
    EXPECT_EQ(out[1].key + "/" + out[1].name, "width_share.from_0.40/share from 0.40");
    EXPECT_EQ(out[2].key + "/" + out[2].group, "load.case_b.mean/load case Case B");
    EXPECT_THROW(tell(out, planar_meanings(), "stroke", 1.0), std::logic_error);
}

TEST(Meanings, AreShortAndStableAndEndWithTheirUnit) {
    const std::regex allowed("[a-z0-9_]+(\\.[a-z0-9_]+)*|[a-z0-9_]+(\\.\\*|\\*)(\\.[a-z0-9_]+)?");
    std::map<std::string, std::string> units;
    for (const auto all : {planar_meanings(), surface_meanings(), head_meanings(), job_meanings()}) {
        std::set<std::string> seen;
        for (const Meaning& m : all) {
            const std::string key(m.key), unit(m.unit);
            EXPECT_TRUE(std::regex_match(key, allowed)) << key;
            EXPECT_LE(key.size(), 28U) << key;
            EXPECT_TRUE(seen.insert(key).second) << key;
            EXPECT_FALSE(m.says.empty()) << key;
            EXPECT_EQ(key.find('*') == std::string::npos,
                      (std::string(m.group) + std::string(m.name)).find('*') == std::string::npos ||
                          key == "head_moves")
                << key;
            const std::string end = unit.empty() ? "" : "_" + (unit == "1/mm" ? "per_mm" : unit);
            EXPECT_TRUE(key.ends_with(end)) << key;
            EXPECT_EQ(units.emplace(key, unit).first->second, unit) << key; // the same in every report
        }
    }
}

TEST(Said, FactsAreNumbersAndNotesAreCounted) {
    Figures out;
    const auto note = [](double amount, std::uint64_t count) {
        return Note{.code = NoteCode::area_unreached, .amount = amount, .count = count, .stage = "fill"};
    };
    add_records({note(1.5, 2), note(0.5, 1)}, {{"sequence", "lower-bound", 14, "strokes"}}, out);
    EXPECT_EQ(text(out, Format::tsv),
              "key\tvalue\tunit\nreport\tmetrics\t\nversion\t1\t\nsaid.sequence.lower_bound\t14\tstrokes\n"
              "noted.fill.area_unreached.grade\tlook\t\nnoted.fill.area_unreached.cases\t3\tcases\n"
              "noted.fill.area_unreached.mm2\t2\tmm2\n");
}

} // namespace

} // namespace filum::figures
