#include "collision/program_text.hpp"

#include "base/number.hpp"

#include <set>
#include <sstream>
#include <vector>

namespace filum::collision {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view s) {
    while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
    while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
    return s;
}

std::string first_line(const std::string& text) { return std::string(trimmed(text.substr(0, text.find('\n')))); }

ProgramLine::ProgramLine(std::string_view text) {
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == ';' && !inside) {
            comment += text.substr(i + 1);
            break;
        }
        if (c == '(' || c == ')')
            inside = c == '(';
        else
            (inside ? comment : code) += c;
    }
    code = trimmed(code);
}

std::map<std::string, std::uint32_t> tool_lines(const machine::Profile& p) {
    std::map<std::string, std::set<std::uint32_t>> holders;
    std::map<std::uint32_t, std::vector<std::string>> codes;
    std::set<std::uint32_t> tools{0};
    for (const auto& [tool, own] : p.own) tools.insert(tool);
    if (p.fibre.active()) tools.insert(static_cast<std::uint32_t>(p.fibre.tool));
    for (const std::uint32_t tool : tools) {
        std::istringstream text(machine::change_codes(p, tool));
        for (std::string line; std::getline(text, line);) {
            constexpr std::string_view number = "{tool_no}";
            if (const auto at = line.find(number); at != std::string::npos)
                line.replace(at, number.size(), shortest_text(p.tools.first + static_cast<double>(tool)));
            if (line.find('{') != std::string::npos) continue; // what only the whole job knows
            line = ProgramLine(line).code;
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

} // namespace filum::collision
