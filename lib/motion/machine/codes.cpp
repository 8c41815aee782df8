#include "machine/codes.hpp"

#include "base/number.hpp"
#include "geom/angle.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

namespace filum::machine {

namespace {

constexpr double kFarthestNumber = 1e7; // mm, degrees

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool is_place(char letter) { return letter >= 'X' && letter <= 'Z'; }

} // namespace

std::string_view trimmed(std::string_view s) {
    while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
    while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
    return s;
}

std::string first_line(const std::string& text) { return std::string(trimmed(text.substr(0, text.find('\n')))); }

CodeLine::CodeLine(std::string_view text) {
    const std::size_t mark = text.find_first_of(";(*");
    if (mark == std::string_view::npos || text[mark] == ';') {
        code_ = trimmed(text.substr(0, mark));
        comment_ = mark == std::string_view::npos ? std::string_view() : trimmed(text.substr(mark + 1));
        return;
    }
    bool inside = false, checksum = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == ';' && !inside) {
            inner_ += text.substr(i + 1);
            break;
        }
        if (c == '*' && !inside) checksum = true;
        if (c == '(' || c == ')')
            inside = c == '(';
        else if (inside)
            inner_ += c;
        else if (!checksum)
            own_ += c;
    }
    own_ = trimmed(own_);
    inner_ = trimmed(inner_);
}

namespace {

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

// True if the code begins with a name, that is, a letter followed by a letter or '_': "SET_PIN", "print_start", "Tx".
bool begins_with_name(std::string_view code) {
    const auto is_letter = [](char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; };
    return code.size() > 1 && is_letter(code[0]) && (is_letter(code[1]) || code[1] == '_');
}

// Reads the number at the beginning of `text`; returns the length of its text, or 0 if there is none.
std::size_t number_at(std::string_view text, Word& to) {
    std::size_t i = 0;
    while (i < text.size() && (is_blank(text[i]) || text[i] == '+')) ++i;
    const auto [end, error] =
        std::from_chars(text.data() + i, text.data() + text.size(), to.value, std::chars_format::fixed);
    if (error != std::errc{} || !(std::abs(to.value) <= kFarthestNumber)) return 0;
    const auto written = std::string_view(text.data() + i, static_cast<std::size_t>(end - text.data()) - i);
    const auto point = written.find('.');
    to.decimals = point == written.npos ? 0 : static_cast<int>(written.size() - point - 1);
    return i + written.size();
}

} // namespace

void split(std::string_view code, Words& to) {
    to.words.clear();
    to.cut = false;
    to.fault = "";
    to.own = begins_with_name(code);
    if (to.own) return;
    std::uint32_t seen = 0; // a bit for each letter
    const auto fault = [&](const char* why) {
        if (*to.fault == 0) to.fault = why;
    };
    for (std::size_t i = 0; i < code.size();) {
        if (is_blank(code[i])) {
            ++i;
            continue;
        }
        Word word;
        word.letter = upper(code[i++]);
        if (word.letter == '.' && !to.words.empty() && !to.words.back().flag) {
            to.cut = true;
            i = std::min(code.find_first_not_of("0123456789.", i), code.size());
            continue;
        }
        if (word.letter < 'A' || word.letter > 'Z') return fault("holds what is no word");
        const std::size_t length = number_at(code.substr(i), word);
        word.flag = length == 0;
        if (word.flag) {
            word.value = 0;
            fault("holds a word without a proper number");
        }
        const std::uint32_t bit = 1U << (word.letter - 'A');
        const bool many = word.letter == 'G' || word.letter == 'M';
        if (!many && (seen & bit) != 0) fault("holds a word twice");
        seen |= bit;
        to.words.push_back(word);
        i += length;
    }
}

namespace {

// The first word after the line number; null if there is none.
const Word* first_word(const Words& line) {
    for (const Word& w : line.words)
        if (w.letter != 'N') return &w;
    return nullptr;
}

} // namespace

bool is_command(const Words& line) {
    const Word* const first = first_word(line);
    if (first == nullptr || first->letter != 'M') return false;
    const auto within = [m = first->value](double low, double high) { return m >= low && m <= high; };
    return !(within(3, 9) || within(48, 53) || within(60, 68) || within(128, 129));
}

bool lacks_code(const Words& line) {
    const Word* const first = first_word(line);
    return first != nullptr && first->letter == 'G' && first->flag;
}

std::map<std::string, std::uint32_t> tool_lines(const Profile& p) {
    std::map<std::string, std::set<std::uint32_t>> holders;
    std::map<std::uint32_t, std::vector<std::string>> codes;
    std::set<std::uint32_t> tools{0};
    for (const auto& [tool, own] : p.own) tools.insert(tool);
    if (p.fibre.active()) tools.insert(static_cast<std::uint32_t>(p.fibre.tool));
    for (const std::uint32_t tool : tools) {
        std::istringstream text(change_codes(p, tool));
        for (std::string line; std::getline(text, line);) {
            constexpr std::string_view number = "{tool_no}";
            if (const auto at = line.find(number); at != std::string::npos)
                line.replace(at, number.size(), shortest_text(p.tools.first + static_cast<double>(tool)));
            if (line.find('{') != std::string::npos) continue; // its value depends on the whole job
            line = std::string(CodeLine(line).code());
            if (line.empty()) continue;
            codes[tool].push_back(line);
            holders[line].insert(tool);
        }
    }
    std::map<std::string, std::uint32_t> out;
    for (const auto& [tool, lines] : codes)
        for (const auto& line : lines)
            if (holders[line].size() == 1) {
                out[line] = tool;
                break;
            }
    return out;
}

kinematics::Joints joints_of(const Profile& profile, std::uint32_t tool, const AxisNumbers& a, bool tip) {
    using geom::kDegree;
    const Profile& own = of_tool(profile, tool);
    const geom::Vec3 xyz{a[0], a[1], a[2]};
    if (tip) return kinematics::place(own.axes.chain, xyz, a[3] * kDegree, a[4] * kDegree);
    return {xyz + own.offset, a[3] * kDegree, a[4] * kDegree}; // the positions of the axes are those of tool 0's tip
}

std::size_t axis_of(const Profile& profile, char letter) {
    if (is_place(letter)) return static_cast<std::size_t>(letter - 'X');
    if (!profile.axes.active()) return 5;
    return letter == profile.axes.tilt_letter ? 3 : letter == profile.axes.turn_letter ? 4 : 5;
}

} // namespace filum::machine
