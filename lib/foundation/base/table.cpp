#include "base/table.hpp"

#include <algorithm>

namespace filum {

std::string_view cut(std::string_view& from, char at) {
    const auto end = std::min(from.find(at), from.size());
    const std::string_view out = from.substr(0, end);
    from.remove_prefix(std::min(end + 1, from.size()));
    return out;
}

std::vector<std::vector<std::string_view>> table_rows(std::string_view text) {
    std::vector<std::vector<std::string_view>> out;
    while (!text.empty()) {
        std::string_view line = cut(text, '\n');
        if (line.empty() || line[0] == '#') continue;
        auto& row = out.emplace_back();
        while (!line.empty()) {
            const std::string_view cell = cut(line, '\t');
            row.push_back(cell == "-" ? std::string_view{} : cell);
        }
    }
    return out;
}

} // namespace filum
