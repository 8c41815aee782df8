#include "base/note.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

namespace filum {
namespace {

std::size_t words(const std::string& text) {
    std::istringstream in(text);
    std::size_t n = 0;
    for (std::string word; in >> word;) ++n;
    return n;
}

std::vector<NoteCode> all_codes() {
    return {
#define NOTE(code, grade, unit, sum, sentence, advice) NoteCode::code,
#include "base/notes.def"
#undef NOTE
    };
}

TEST(Note, EveryCodeHasAShortSentenceAndAdviceUnlessHarmless) {
    std::set<std::string> names;
    for (const NoteCode code : all_codes()) {
        for (const std::uint64_t count : {1, 2}) {
            Note n{.code = code, .amount = 1.5, .count = count};
            n.detail = "it";
            const std::string text = sentence(n);
            EXPECT_LE(words(text), 25U) << text;
            EXPECT_GE(words(text), 3U - (code == NoteCode::setting_differs ? 2U : 0U)) << text; // its detail says all
            EXPECT_EQ(text.find_first_of("{}|"), std::string::npos) << text;
            EXPECT_NE(text.back(), '.') << text;
            EXPECT_EQ(advice(n).empty(), grade(n) == Grade::harmless) << text;
        }
        const Note n{.code = code};
        EXPECT_TRUE(names.insert(code_name(n)).second) << code_name(n);
        EXPECT_EQ(note_code(code_name(n)), code);
    }
    EXPECT_EQ(note_code("no-such-code"), NoteCode::foreign);
    EXPECT_EQ(note_code(""), NoteCode::foreign);
}

TEST(Note, SentencesHaveNumbersAndPlaces) {
    Note n{NoteCode::overhang, 647.6685, 8, 1, 12.346, 7};
    n.detail = "4.3 mm";
    EXPECT_EQ(line(n), "648 mm2 of unsupported overhang on 8 layers, reaching out up to 4.3 mm; worst on layer 1 at "
                       "12.35,7; add --support [overhang]");
    EXPECT_EQ(sentence({NoteCode::path_runs_twice, 226.6542, 168}),
              "the path runs twice along 227 mm of outline; the beads share the width there (168 places)");
    EXPECT_EQ(sentence({NoteCode::turn_too_tight, 1}), "1 turn is tighter than the least radius");
}

TEST(Note, SumsGoByKindAndGrade) {
    Note a{NoteCode::hairline_gap_closed, 1}, b{NoteCode::heat_inexact, 3}, c{NoteCode::overhang_floating, 2};
    Note other = b;
    other.amount = 5;
    other.layer = 4;
    Note on_patch = b;
    on_patch.patch = "A";
    const Notes sums = summed({a, b, a, c, other, on_patch});
    ASSERT_EQ(sums.size(), 4U);
    EXPECT_EQ(sums[0].code, NoteCode::overhang_floating);
    EXPECT_EQ(sums[1].amount, 5); // the greatest, not the sum
    EXPECT_EQ(sums[1].layer, 4);
    EXPECT_EQ(sums[2].patch, "A");
    EXPECT_EQ(sums[3].amount, 2);
    EXPECT_EQ(sums[3].count, 2U);
}

// Whether less than a dot is harmless by this code: its amount is an area or a length that adds up, and not every
// amount of it matters.
bool adds_up(NoteCode code) {
    const Note one{.code = code, .amount = 1};
    return (unit(one) == "mm2" || unit(one) == "mm") && summed({one, one})[0].amount == 2 &&
           code != NoteCode::layer_empty && code != NoteCode::bend_too_tight && code != NoteCode::inside_by_parity;
}

// Amounts on both sides of the limit, for all codes, beads of many widths, and sums of 1 to 1,000 cases.
TEST(Note, AreasAndLengthsBelowADotAreHarmless) {
    std::size_t below = 0, above = 0;
    for (const NoteCode code : all_codes())
        for (const double w : {0.05, 0.4, 1.0, 6.35, 100.0})
            for (const std::uint64_t cases : {1, 7, 1000})
                for (const double share : {1e-9, 0.5, 0.999, 1.001, 2.0, 1e6}) {
                    Note one{.code = code, .bead = w};
                    const double dot = unit(one) == "mm2" ? std::numbers::pi / 4 * w * w : w;
                    one.amount = share * dot / static_cast<double>(cases);
                    const Notes sums = summed(Notes(cases, one));
                    const bool small = adds_up(code) && share < 1;
                    ASSERT_EQ(sums.size(), 1U);
                    EXPECT_EQ(code_grade(one), grade({.code = code}));
                    EXPECT_EQ(grade(sums[0]), small ? Grade::harmless : grade({.code = code}))
                        << code_name(one) << ' ' << w << ' ' << cases << ' ' << share;
                    ++(small ? below : above);
                }
    EXPECT_GT(below, 1000U);
    EXPECT_GT(above, 1000U);
}

TEST(Note, OfUnknownBeadsNothingIsADot) {
    const Note known{.code = NoteCode::sliver_dropped, .amount = 0.01, .bead = 0.4};
    Note unknown = known;
    unknown.bead = 0;
    EXPECT_EQ(grade(known), Grade::harmless);
    EXPECT_EQ(grade(unknown), Grade::look);
    EXPECT_EQ(grade(summed({known, unknown})[0]), Grade::look);
    Note narrow = known;
    narrow.bead = 0.1; // a dot of .008 mm2
    EXPECT_EQ(grade(summed({known, narrow})[0]), Grade::look);
    EXPECT_EQ(grade(summed({narrow, known})[0]), Grade::look);
    for (const double amount : {std::nan(""), -1.0, HUGE_VAL}) {
        Note odd = known;
        odd.amount = amount;
        EXPECT_EQ(grade(odd), Grade::look) << amount;
    }
}

TEST(Note, ForeignOnesObeyTheSameRule) {
    for (const auto& [in, dot] : {std::pair{"mm2", std::numbers::pi / 4 * 0.16}, {"mm", 0.4}, {"cases", 0.0}})
        for (const std::size_t cases : {1, 2, 1000})
            for (const double share : {0.5, 0.999, 1.001, 1e3}) {
                Note n{.amount = share * dot / static_cast<double>(cases), .stage = "mine", .bead = 0.4};
                n.foreign = {"left-open", "left open", in, Grade::will_fail};
                Notes all(cases, n);
                for (std::size_t i = 0; i < cases; ++i) all[i].foreign.text += std::to_string(i); // as with its amount
                ASSERT_EQ(summed(all).size(), 1U);
                EXPECT_EQ(grade(summed(all)[0]), dot > 0 && share < 1 ? Grade::harmless : Grade::will_fail);
                EXPECT_EQ(code_grade(n), Grade::will_fail);
                n.bead = 0;
                EXPECT_EQ(grade(n), Grade::will_fail);
            }
}

TEST(Note, ThePageHasEveryCode) {
    const std::string page = notes_page();
    for (const NoteCode code : all_codes()) {
        const Note n{.code = code};
        EXPECT_NE(page.find("| `" + code_name(n) + "` |"), std::string::npos) << code_name(n);
    }
    EXPECT_EQ(page.find('{'), std::string::npos);
}

} // namespace
} // namespace filum
