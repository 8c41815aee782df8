#include "laminate/stack.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace filum::laminate {

namespace {

constexpr double kSameAngle = 1e-6; // degrees: angles are given as text, so only rounding differs

// The angle in [0, 180), as fibres have no sign.
double line_angle(double degrees) {
    const double a = std::fmod(std::fmod(degrees, 180) + 180, 180);
    return a > 180 - kSameAngle ? 0 : a;
}

bool alike(const Ply& a, const Ply& b) {
    return std::abs(line_angle(a.angle) - line_angle(b.angle)) < kSameAngle && a.height == b.height &&
           a.spacing == b.spacing && a.within == b.within;
}

std::vector<Ply> finished(std::vector<Ply> plies, bool mirrored) {
    if (mirrored) plies.insert(plies.end(), plies.rbegin(), plies.rend());
    return plies;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> out;
    line = line.substr(0, line.find('#'));
    while (true) {
        const auto from = line.find_first_not_of(" \t\r");
        if (from == std::string_view::npos) return out;
        line.remove_prefix(from);
        const auto to = std::min(line.find_first_of(" \t\r"), line.size());
        out.push_back(line.substr(0, to));
        line.remove_prefix(to);
    }
}

// A number of a table, within limits.
double number(std::string_view word, const char* column, double least, double most) {
    const double v = parse_number(word, column);
    if (!(v >= least && v <= most))
        throw Error(Exit::usage, std::string(column) + " " + std::string(word) + " is not within " +
                                     shortest_text(least) + " and " + shortest_text(most));
    return v;
}

void set(Ply& ply, std::string_view column, std::string_view word) {
    if (column == "angle") ply.angle = number(word, "angle", -360, 360);
    if (column == "spacing") ply.spacing = number(word, "spacing", 0.001, 1000);
    if (column == "height") ply.height = number(word, "height", 0.001, 100);
    if (column == "tool") {
        const double tool = number(word, "tool", 0, 1e6);
        if (tool != std::floor(tool)) throw Error(Exit::usage, "a tool must be a whole number");
        ply.tool = static_cast<std::uint32_t>(tool);
    }
    if (column == "side") {
        if (word != "over" && word != "under") throw Error(Exit::usage, "a side must be 'over' or 'under'");
        ply.under = word == "under";
    }
    if (column == "within") ply.within = word == "all" ? "" : word;
}

} // namespace

std::vector<Ply> plies_of(std::string_view words, const Ply& like, bool mirrored) {
    std::vector<Ply> out;
    for (std::size_t at = 0; at <= words.size() && !words.empty();) {
        const std::size_t end = std::min(words.find(',', at), words.size());
        Ply ply = like;
        ply.angle = parse_number(words.substr(at, end - at), "--plies");
        if (!(std::abs(ply.angle) <= 360))
            throw Error(Exit::usage,
                        "cannot use --plies '" + std::string(words) + "': angles must be from -360 to 360 degrees");
        out.push_back(ply);
        at = end + 1;
    }
    if (out.empty()) throw Error(Exit::usage, "a laminate needs plies; give --plies 0,45,-45,90, or --table");
    return finished(std::move(out), mirrored);
}

std::vector<Ply> plies_of_table(std::string_view text, const std::string& file, const Ply& like, bool mirrored) {
    static constexpr std::string_view kColumns[] = {"angle", "spacing", "height", "tool", "side", "within"};
    std::vector<Ply> out;
    std::vector<std::string_view> columns;
    std::size_t line = 0;
    const auto fail = [&](const std::string& why) {
        throw Error(Exit::bad_input,
                    "cannot read plies from '" + file + "', line " + std::to_string(line) + ": " + why);
    };
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const auto words = words_of(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++line;
        if (words.empty()) continue;
        if (columns.empty()) {
            columns = words;
            for (const auto c : columns)
                if (std::find(std::begin(kColumns), std::end(kColumns), c) == std::end(kColumns))
                    fail("unknown column '" + std::string(c) +
                         "'; they are angle, spacing, height, tool, side, within");
            continue;
        }
        if (words.size() != columns.size())
            fail("it has " + std::to_string(words.size()) + " words, the first line " + std::to_string(columns.size()));
        Ply ply = like;
        for (std::size_t k = 0; k < words.size(); ++k) {
            try {
                set(ply, columns[k], words[k]);
            } catch (const Error& e) {
                fail(e.what());
            }
        }
        out.push_back(ply);
    }
    if (out.empty()) fail("it contains no ply; write a line 'angle', then one line per ply");
    return finished(std::move(out), mirrored);
}

std::vector<std::size_t> through(std::span<const Ply> plies) {
    std::vector<std::size_t> under, over;
    for (std::size_t k = 0; k < plies.size(); ++k) (plies[k].under ? under : over).push_back(k);
    std::reverse(under.begin(), under.end());
    under.insert(under.end(), over.begin(), over.end());
    return under;
}

Symmetry symmetry(std::span<const Ply> plies) {
    const auto order = through(plies);
    Symmetry out;
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (alike(plies[order[k]], plies[order[order.size() - 1 - k]])) continue;
        if (out.unlike++ == 0) out.first = order[k];
    }
    std::map<long, long> more; // by angle from 0 to 90, in millionths of a degree
    for (const Ply& p : plies) {
        const double a = line_angle(p.angle), folded = std::min(a, 180 - a);
        if (folded > kSameAngle && folded < 90 - kSameAngle) more[std::lround(folded / kSameAngle)] += a < 90 ? 1 : -1;
    }
    for (const auto& [angle, n] : more) out.unequal += static_cast<std::size_t>(std::abs(n));
    return out;
}

} // namespace filum::laminate
