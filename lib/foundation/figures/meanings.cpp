#include "figures/meanings.hpp"

#include <algorithm>
#include <stdexcept>

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

void section(std::string& out, const std::string& title, const std::string& before, std::span<const Meaning> meanings) {
    out += "\n## " + title + "\n\n" + before + "\n\n| key | unit | in tables | definition |\n|---|---|---|---|\n";
    for (const Meaning& m : meanings)
        out += "| `" + in_table(m.key) + "` | " + std::string(m.unit) + " | " + in_table(m.group) + ": " +
               in_table(m.name) + " | " + in_table(m.says) + " |\n";
}

constexpr const char* kBegin =
    "# The keys of reports\n"
    "\n"
    "`scripts/generate-docs` makes this page from the programs (`metrics --print-keys`). `metrics`, `collide` and "
    "`postproc --job` write\n"
    "these keys for programs. Tables for people have headings and names instead.\n"
    "\n"
    "    metrics --format json ...    {\"report\": \"metrics\", \"version\": 1, \"strokes\": 1, ...}\n"
    "    metrics --format tsv ...     a head line, then key, value, unit; the first two keys are `report` and "
    "`version`\n"
    "\n"
    "- A key ends with its unit (`_per_mm`: 1/mm). Counts and shares have none; the whole is the share 1.\n"
    "- An unknown value is `null` in JSON and `-` in TSV.\n"
    "- `*` stands for the subject of the figure: the number of a tool, the name of a load case, or a range. Names are "
    "in lower case, with `_`\n"
    "  for other signs except points.\n"
    "- A key without a value in this job is left out.\n"
    "- `version` increases when a key disappears or changes its meaning, not when one is added.\n"
    "\n"
    "[figures.md](figures.md) and [surface-metrics.md](surface-metrics.md) explain the methods. In Python: "
    "`stream.figures()`.\n";

constexpr const char* kSaid =
    "\n"
    "## Facts and notes of earlier stages\n"
    "\n"
    "Every report of `metrics` ends with them. Names and phrases are those of the stages, in lower case, with `_` for "
    "other signs.\n"
    "\n"
    "| key | unit | definition |\n"
    "|---|---|---|\n"
    "| `said.STAGE.NAME` | the column `unit` | a fact: a result of that stage about the whole job |\n"
    "| `noted.STAGE.PHRASE.cases` | | a note: the number of cases in which the stage dropped, repaired or could not "
    "place something |\n"
    "| `noted.STAGE.PHRASE.UNIT` | its last word | the amount in all |\n"
    "\n"
    "Facts of `surfpath`, `said.surfpath.NAME`:\n"
    "\n"
    "| name | unit | definition |\n"
    "|---|---|---|\n"
    "| `rows`, `rings` | | lines of the path |\n"
    "| `turns` | | turns from one row to another |\n"
    "| `transits` | mm | ways along rims and rows, where no turn leads on |\n"
    "| `loops_joined` | | of field and hybrid: how often a closed line was opened and joined to its neighbour, by a "
    "crossed shift or an exchange |\n"
    "| `births` | | of field: places inside the surface where lines are born or end; of ortheo: where they are born |\n"
    "| `deaths`, `births_lower_bound` | | of ortheo: places where lines end; the least possible number of births |\n"
    "| `cuts`, `cuts_bound` | | cuts of the fibre of field and hybrid; a lower bound on the cuts of any path that "
    "covers the surface |\n"
    "| `rings_bound` | | an upper bound on the share of the area that closed lines of the minimum radius can cover |\n"
    "| `branches`, `branches_open` | | parts of the surface with rings of their own; those whose innermost ring is not "
    "at its goal |\n"
    "| `spacing_change` | | greatest change of the spacing between two rings or laps, as a share, made to fit the last "
    "one |\n"
    "| `seam_lanes` | | rings that one seam joins to a stroke |\n"
    "| `seam_length` | mm | length of the seam on the shortest of them |\n"
    "| `tightest_bend` | 1/mm | greatest curvature of the directions that field follows |\n"
    "| `tight_turns` | | stretches that turn tighter than the minimum radius |\n"
    "| `tight_length`, `kink_length` | mm | their length; length that turns tighter than 0.45 spacings |\n"
    "| `least_radius` | mm | the tightest radius |\n"
    "| `trims` | | number of crossings with rims that the path turns beyond |\n"
    "| `outside` | mm | length of the path beyond these rims |\n"
    "| `bare`, `uncovered` | mm2 | area farther than one spacing, and farther than half a spacing, from every line |\n"
    "| `laid_twice` | mm2 | length times spacing, less the covered area |\n";

constexpr const char* kTables =
    "\n"
    "## Tables of columns\n"
    "\n"
    "`metrics --per-layer` and `--per-region` write a line per layer or region. Columns with the names above mean the "
    "same, for that layer or\n"
    "region alone. Further columns are:\n"
    "\n"
    "- `layer`, `region`: numbers; `z_mm`: top of the layer;\n"
    "- `curves`, `moves`, `length_mm`: closed lines, segments and length of the beads;\n"
    "- `x_mm`, `y_mm`: place of the region's largest void;\n"
    "- with `--pores`: `direction_deg` (of the strands), `width_mm`, `spacing_mm`, `lateral_throat_mm`, `openings`, "
    "`pore_median_mm`,\n"
    "  `pore_smallest_mm`, `pore_largest_mm`.\n"
    "\n"
    "Their version is that of the report made with them.\n"
    "\n"
    "| file | columns |\n"
    "|---|---|\n"
    "| `choose --report` | `patch`, `area_mm2`, `algorithm`, `seed`, `estimate` and `rough` (scores before planning), "
    "`coverage`, `load`, `paper_load`, `angle_deg` (mean of the top 1 % of angles of the path, a quarter of the "
    "spacing apart), `cuts`, `length_mm`, `overlap`, `score`, `chosen` (`*`), `failed` (reason), `rings_bound` (of "
    "algorithms with rings: an upper bound on the share that closed lines of the minimum radius can cover), `tight_mm` "
    "and `kink_mm` (length that "
    "turns tighter than the minimum radius, and than 0.45 spacings) |\n"
    "| `sequence --ends` | `stroke`, `region`, `layer`, `z_mm`, `x_mm`, `y_mm` (place of the end), `cause`, `ahead` "
    "and `awaited` (regions), `rise_mm`, `distance_mm` (how far the head would have to reach) |\n"
    "| `collide --places` | `point` or `line`, `layer`, `stroke`, `move`, `meets`, `with`, `clearance`, `x`, `y`, `z` "
    "(mm, of the tip), `i`, `j`, `k` (unit, the tool axis) |\n";

} // namespace

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
    std::string out = kBegin;
    section(out, "Layers: metrics", "Figures of a toolpath in layers, or of the curves of `fill`.", planar_meanings());
    section(out, "Curved surfaces: metrics --surface",
            "Figures of a path on a surface; d is `--spacing`. [surface-metrics.md](surface-metrics.md) explains the "
            "methods.",
            surface_meanings());
    section(out, "The head: collide", "`report` is `collide`.", head_meanings());
    section(out, "The job: postproc --job", "`report` is `job`; always TSV.", job_meanings());
    return out + kSaid + kTables;
}

} // namespace filum::figures
