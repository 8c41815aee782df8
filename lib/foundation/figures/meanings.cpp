#include "figures/meanings.hpp"

#include "base/embed.hpp"
#include "base/table.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

FILUM_EMBED(meanings, FILUM_FIGURES "/meanings.tsv");
FILUM_EMBED(page, FILUM_FIGURES "/page.txt");

namespace filum::figures {

namespace {

std::string with(std::string_view pattern, std::string_view of) {
    std::string out(pattern);
    if (const auto at = out.find('*'); at != std::string::npos) out.replace(at, 1, of);
    return out;
}

std::string in_table(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
    return out;
}

// The columns of meanings.tsv.
enum Column : std::uint8_t { at_report, at_key, at_group, at_name, at_unit, at_decimals, at_says, columns };

// All figures, by report in the order of the file.
const std::map<std::string_view, std::vector<Meaning>>& reports() {
    static const auto all = [] {
        std::map<std::string_view, std::vector<Meaning>> out;
        for (const auto& row : table_rows(FILUM_EMBEDDED(meanings))) {
            if (row.size() != columns)
                throw std::logic_error("meanings.tsv: " + std::string(row[0]) + " has a wrong row");
            out[row[at_report]].push_back(
                {row[at_key], row[at_group], row[at_name], row[at_unit], row[at_decimals][0] - '0', row[at_says]});
        }
        return out;
    }();
    return all;
}

std::string page_table(std::span<const Meaning> meanings) {
    std::string out = "| key | unit | in tables | definition |\n|---|---|---|---|\n";
    for (const Meaning& m : meanings)
        out += "| `" + in_table(m.key) + "` | " + std::string(m.unit) + " | " + in_table(m.group) + ": " +
               in_table(m.name) + " | " + in_table(m.says) + " |\n";
    return out;
}

} // namespace

std::span<const Meaning> planar_meanings() { return reports().at("planar"); }
std::span<const Meaning> surface_meanings() { return reports().at("surface"); }
std::span<const Meaning> head_meanings() { return reports().at("head"); }
std::span<const Meaning> job_meanings() { return reports().at("job"); }

std::string key_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool small = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.';
        const bool large = c >= 'A' && c <= 'Z';
        const char is = small ? c : large ? static_cast<char>(c - 'A' + 'a') : '_';
        if (is != '_' || (!out.empty() && out.back() != '_')) out += is;
    }
    while (!out.empty() && out.back() == '_') out.pop_back();
    return out;
}

void tell(Figures& out, std::span<const Meaning> meanings, std::string_view key, decltype(Figure::value) value,
          std::string_view of) {
    const auto m = std::find_if(meanings.begin(), meanings.end(), [&](const Meaning& a) { return a.key == key; });
    if (m == meanings.end()) throw std::logic_error("no figure has the key " + std::string(key));
    out.push_back({with(m->group, of), with(m->name, of), std::move(value), m->decimals, std::string(m->unit),
                   with(m->key, m->key.find('*') == std::string_view::npos ? of : key_text(of))});
}

FigureLabel spoken(std::string_view key, bool on_surface) {
    for (const Meaning& m : on_surface ? surface_meanings() : planar_meanings()) {
        const auto star = std::min(m.key.find('*'), m.key.size());
        const auto before = m.key.substr(0, star), after = star < m.key.size() ? m.key.substr(star + 1) : "";
        const bool fits = star == m.key.size() ? key == m.key
                                               : key.size() > before.size() + after.size() && key.starts_with(before) &&
                                                     key.ends_with(after);
        if (!fits) continue;
        const auto of = key.substr(before.size(), key.size() - before.size() - after.size());
        return {with(m.group, of), with(m.name, of)};
    }
    return {};
}

std::string meanings_page() {
    std::string out(FILUM_EMBEDDED(page));
    for (const auto& [report, meanings] : reports()) {
        const std::string mark = "{" + std::string(report) + "}\n";
        out.replace(out.find(mark), mark.size(), page_table(meanings));
    }
    return out;
}

} // namespace filum::figures
