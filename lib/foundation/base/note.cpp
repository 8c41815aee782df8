#include "base/note.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>

namespace filum {

namespace {

enum class Sum : std::uint8_t { total, every, most, least };

struct Row {
    NoteCode code;
    std::string_view name; // words joined by '_'
    Grade grade;
    std::string_view unit;
    Sum sum;
    std::string_view sentence, advice;
};

constexpr std::array kRows = {
#define NOTE(code, grade, unit, sum, sentence, advice)                                                                 \
    Row{NoteCode::code, #code, Grade::grade, unit, Sum::sum, sentence, advice},
#include "base/notes.def"
#undef NOTE
};

constexpr std::array<std::string_view, 3> kGradeNames{"harmless", "look", "will fail"};

const Row* row(const Note& n) {
    return n.code == NoteCode::foreign ? nullptr : &kRows[static_cast<std::size_t>(n.code) - 1];
}

std::string kebab(std::string_view name) {
    std::string out(name);
    std::replace(out.begin(), out.end(), '_', '-');
    return out;
}

// The amount as text with about three digits: 227, 22.7, 2.27, 0.23, 0.0042.
std::string amount_text(double v) {
    if (!std::isfinite(v)) return "an unknown amount";
    const double size = std::abs(v);
    constexpr double least = 1e-4;
    if (size > 0 && size < least) return "less than " + fixed_text(least, 4);
    return fixed_text(v, size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 ? 2 : 4);
}

// The amount with its unit. Units that are words agree with the number: "1 turn", "3 turns".
std::string with_unit(double amount, std::string_view unit) {
    const bool word = unit.size() > 3 && unit.ends_with('s');
    if (word && amount == 1) unit.remove_suffix(1);
    return amount_text(amount) + (unit.empty() ? "" : " " + std::string(unit));
}

// The number with its word in singular or plural: "3 bodies" for "body|bodies", "3 gaps" for "gap".
std::string counted(std::uint64_t n, std::string_view words) {
    const auto bar = words.find('|');
    std::string word(n == 1 ? words.substr(0, bar) : bar == std::string_view::npos ? words : words.substr(bar + 1));
    if (n != 1 && bar == std::string_view::npos) word += "s";
    return std::to_string(n) + " " + word;
}

std::string placeholder(std::string_view what, const Note& n, const Row& r) {
    if (what == "a") return with_unit(n.amount, r.unit);
    if (what == "d") return n.detail;
    if (what == "was") return n.count == 1 ? "was" : "were";
    if (what == "is") return n.count == 1 ? "is" : "are";
    return counted(n.count, what.substr(std::min<std::size_t>(2, what.size()))); // "n word"
}

std::string filled_in(const Note& n, const Row& r) {
    std::string out;
    for (std::string_view rest = r.sentence; !rest.empty();) {
        const auto open = std::min(rest.find('{'), rest.size()), close = std::min(rest.find('}', open), rest.size());
        out += rest.substr(0, open);
        if (open < close) out += placeholder(rest.substr(open + 1, close - open - 1), n, r);
        rest.remove_prefix(std::min(close + 1, rest.size()));
    }
    if (out.starts_with("there are 1 ")) out.replace(0, std::string_view("there are").size(), "there is");
    return out;
}

std::string place(const Note& n) {
    std::string out;
    if (n.layer >= 0) out += "on layer " + std::to_string(n.layer);
    if (!std::isfinite(n.x) || !std::isfinite(n.y)) return out;
    out += (out.empty() ? "at " : " at ") + fixed_text(n.x, 2) + "," + fixed_text(n.y, 2);
    if (std::isfinite(n.z)) out += "," + fixed_text(n.z, 2);
    return out;
}

// The average severity of the cases of a sum. A worse case gives the sum its place.
double badness(const Note& n, Sum sum) {
    if (sum == Sum::least) return -n.amount;
    return sum == Sum::most ? n.amount : n.amount / static_cast<double>(std::max<std::uint64_t>(1, n.count));
}

Sum way_to_sum(const Note& n) { return row(n) != nullptr ? row(n)->sum : Sum::total; }

// The sentence for docs/notes.md: placeholders are replaced by their names, such as *amount*.
std::string for_the_page(std::string_view sentence) {
    std::string out;
    for (std::string_view rest = sentence; !rest.empty();) {
        const auto open = std::min(rest.find('{'), rest.size()), close = std::min(rest.find('}', open), rest.size());
        out += rest.substr(0, open);
        if (open < close) {
            const std::string_view what = rest.substr(open + 1, close - open - 1);
            if (what == "a")
                out += "*amount*";
            else if (what == "d")
                out += "*...*";
            else if (what == "was")
                out += "were";
            else if (what == "is")
                out += "are";
            else
                out += "*n*" + counted(2, what.substr(2)).substr(1);
        }
        rest.remove_prefix(std::min(close + 1, rest.size()));
    }
    return out;
}

} // namespace

std::string_view name(Grade grade) { return kGradeNames[static_cast<std::size_t>(grade)]; }

std::string code_name(const Note& n) {
    if (const Row* r = row(n)) return kebab(r->name);
    std::string out;
    for (const char c : n.foreign.code.empty() ? n.foreign.text : n.foreign.code) {
        const auto u = static_cast<unsigned char>(c);
        if (std::isalnum(u) != 0)
            out += static_cast<char>(std::tolower(u));
        else if (!out.empty() && out.back() != '-')
            out += '-';
    }
    while (out.ends_with('-')) out.pop_back();
    return out.empty() ? "foreign" : out;
}

NoteCode note_code(std::string_view name) {
    for (const Row& r : kRows)
        if (kebab(r.name) == name) return r.code;
    return NoteCode::foreign;
}

Grade code_grade(const Note& n) { return row(n) != nullptr ? row(n)->grade : n.foreign.grade; }

bool goes_by_amount(const Note& n) {
    const std::string in = unit(n);
    return way_to_sum(n) == Sum::total && (in == "mm2" || in == "mm");
}

Grade grade(const Note& n) {
    const double dot = unit(n) == "mm2" ? std::numbers::pi / 4 * n.bead * n.bead : n.bead;
    const bool less = goes_by_amount(n) && n.amount >= 0 && n.amount < dot;
    return less ? Grade::harmless : code_grade(n);
}

std::string unit(const Note& n) { return row(n) != nullptr ? std::string(row(n)->unit) : n.foreign.unit; }

std::string sentence(const Note& n) {
    const std::string on = n.patch.empty() ? "" : ", on patch " + n.patch;
    if (const Row* r = row(n)) return filled_in(n, *r) + on;
    std::string out = n.foreign.text + ": " + counted(n.count, "case");
    if (!n.foreign.unit.empty()) out += ", " + amount_text(n.amount) + " " + n.foreign.unit;
    return out + on;
}

std::string advice(const Note& n) { return row(n) != nullptr ? std::string(row(n)->advice) : ""; }

std::string line(const Note& n) {
    std::string out = sentence(n);
    if (const std::string at = place(n); !at.empty()) out += (n.count > 1 ? "; worst " : "; ") + at;
    if (const std::string what = advice(n); !what.empty()) out += "; " + what;
    return out + " [" + code_name(n) + "]";
}

bool same_kind(const Note& a, const Note& b) {
    if (a.code != b.code || a.stage != b.stage || a.detail != b.detail || a.patch != b.patch) return false;
    const ForeignNote &f = a.foreign, &g = b.foreign;
    return a.code != NoteCode::foreign ||
           (f.code == g.code && f.unit == g.unit && (!f.code.empty() || f.text == g.text));
}

void add(Note& sum, const Note& n) {
    const Sum how = way_to_sum(n);
    if (badness(n, how) > badness(sum, how)) {
        sum.layer = n.layer;
        sum.x = n.x;
        sum.y = n.y;
        sum.z = n.z;
    }
    sum.amount = how == Sum::most    ? std::max(sum.amount, n.amount)
                 : how == Sum::least ? std::min(sum.amount, n.amount)
                                     : sum.amount + n.amount;
    sum.count += n.count;
    sum.bead = std::min(sum.bead, n.bead);
}

Notes summed(const Notes& notes) {
    Notes sums;
    for (const Note& n : notes) {
        const auto it = std::find_if(sums.begin(), sums.end(), [&](const Note& s) { return same_kind(s, n); });
        if (it == sums.end())
            sums.push_back(n);
        else
            add(*it, n);
    }
    std::stable_sort(sums.begin(), sums.end(), [](const Note& a, const Note& b) { return grade(a) > grade(b); });
    return sums;
}

std::string notes_page() {
    std::string out =
        "# Notes\n\nMade by `scripts/generate-docs` from `lib/foundation/base/notes.def`.\n\n"
        "A stage writes a note into its stream for everything that it drops, repairs or cannot place. A note has a "
        "code, an amount, a place and a grade. Programs print each kind once, at their end: `filum print` those of all "
        "stages, a single stage its own. Harmless notes appear with `--notes all` only. JSON of `metrics` and `peek`, "
        "reports and Python contain codes and grades.\n\n"
        "The tables below have the grade of each code. **Less than a dot is harmless**, for every code: a sum of "
        "areas below pi/4 w^2 or a sum of lengths below w, where w is the width of the job's beads. With beads of "
        "0.4 mm these are 0.126 mm2 and 0.4 mm. All cases of a code in the job are added up before they are compared, "
        "so many small losses still show. The rule holds where the unit is mm2 or mm and amounts add up. It does not "
        "hold for";
    std::string last;
    for (const Row& r : kRows) {
        if (r.sum != Sum::every) continue;
        if (!last.empty()) out += " " + last + ",";
        last = "`" + kebab(r.name) + "`";
    }
    out += " and " + last +
           ", for depths and distances, for notes of stages without --bead-width (`slice`, and those of surfaces), and "
           "if the job lays no bead.\n";
    for (const Grade g : {Grade::will_fail, Grade::look, Grade::harmless}) {
        const bool advised = g != Grade::harmless;
        out += "\n## " +
               std::string(g == Grade::will_fail ? "Will fail"
                           : g == Grade::look    ? "Look"
                                                 : "Harmless") +
               "\n\n| code | what it says | " + (advised ? "what to do |\n|---|---|---|\n" : "unit |\n|---|---|---|\n");
        for (const Row& r : kRows)
            if (r.grade == g)
                out += "| `" + kebab(r.name) + "` | " + for_the_page(r.sentence) + " | " +
                       std::string(advised ? r.advice : r.unit) + " |\n";
    }
    return out;
}

} // namespace filum
