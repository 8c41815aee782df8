#include "metrics/figures/meanings.hpp"

#include <algorithm>
#include <stdexcept>

namespace filum::metrics::figures {

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
    "# The keys of reports\n\n"
    "Made by `scripts/generate-docs` from the programs (`metrics --print-keys`). What `metrics`, `collide` and "
    "`postproc --job`\n"
    "write for programs has these keys, the same everywhere; tables for people have headings and names instead.\n\n"
    "    metrics --format json ...    {\"report\": \"metrics\", \"version\": 1, \"strokes\": 1, ...}\n"
    "    metrics --format tsv ...     a head line, then key, value, unit; the first two keys are `report` and "
    "`version`\n\n"
    "A key ends with its unit (`_per_mm`: 1/mm); counts and shares have none, a share of all is 1. What is not known "
    "is "
    "`null` in JSON, `-`\n"
    "in TSV. `*` stands for what the figure is of: the number of a tool, the name of a load case (in lower case, other "
    "signs but points "
    "as `_`), a\n"
    "range. A key that has nothing to tell of is left out. `version` goes up when a key goes away or changes its "
    "meaning, not when one is\n"
    "added. More of how figures are measured: [figures.md](figures.md), [surface-metrics.md](surface-metrics.md). In "
    "Python: `stream.figures()`.\n";

constexpr const char* kSaid =
    "\n## What the stages before said\n\n"
    "In every report of `metrics`, at its end. Names and phrases are the stages' own, in lower case, other signs as "
    "`_`.\n\n"
    "| key | unit | definition |\n|---|---|---|\n"
    "| `said.STAGE.NAME` | the column `unit` | a fact: what that stage found out about the whole job |\n"
    "| `noted.STAGE.PHRASE.cases` | | a note: in how many cases the stage dropped, repaired or could not place "
    "something |\n"
    "| `noted.STAGE.PHRASE.UNIT` | its last word | how much in all |\n"
    "\nThose of `surfpath`, `said.surfpath.NAME`:\n\n"
    "| name | unit | definition |\n|---|---|---|\n"
    "| `rows`, `rings` | | lines that are laid |\n"
    "| `turns` | | from a row to another |\n"
    "| `transits` | mm | ways along rims and rows, from where no turn leads on |\n"
    "| `loops_joined` | | of field and hybrid: how often a closed line was opened and joined to what lies beside it, "
    "by shifts that cross or by an exchange of ends, which does not |\n"
    "| `births` | | of field: places within the surface where lines are born or end; of ortheo: where they are born |\n"
    "| `deaths`, `births_lower_bound` | | of ortheo: where lines end; how many births there must be at least |\n"
    "| `cuts`, `cuts_bound` | | cuts of the fibre of field and hybrid, and how many there must be at least for whoever "
    "covers all |\n"
    "| `rings_bound` | | share of the area that closed lines of the least radius can cover, at most |\n"
    "| `branches`, `branches_open` | | parts of the surface that rings go round; those of which the innermost ring "
    "does not come up to the middle |\n"
    "| `spacing_change` | | the most by which two rings or laps are nearer or farther than the spacing, of it, so that "
    "the last one lies in the middle |\n"
    "| `seam_lanes` | | rings that one seam joins to a stroke |\n"
    "| `seam_length` | mm | along the shortest of them |\n"
    "| `tightest_bend` | 1/mm | of the directions that field follows |\n"
    "| `hairpins` | | turns tighter than the least radius, all of them declared |\n"
    "| `hairpin_length`, `least_radius` | mm | of those: in all, and of the tightest |\n"
    "| `trims` | | how often the path crosses rims that it turns beyond |\n"
    "| `outside` | mm | of the path beyond them |\n"
    "| `bare`, `uncovered` | mm2 | farther than a spacing from any line, and than half of one |\n"
    "| `laid_twice` | mm2 | length times spacing, less what is covered |\n";

constexpr const char* kTables =
    "\n## Tables of columns\n\n"
    "`metrics --per-layer` and `--per-region` write a line per layer or region; columns of the names above mean the "
    "same, of that layer or\n"
    "region alone. The others: `layer`, `region` (numbers), `z_mm` (top of the layer), `curves`, `moves` and "
    "`length_mm` (closed lines,\n"
    "segments and length of the beads), `x_mm`, `y_mm` (where the region's largest bare place is), and with `--pores` "
    "`direction_deg` (of the\n"
    "strands), `width_mm`, `spacing_mm`, `lateral_throat_mm`, `openings`, `pore_median_mm`, `pore_smallest_mm`, "
    "`pore_largest_mm`. Their\n"
    "version is that of the report made with them.\n\n"
    "| file | columns |\n|---|---|\n"
    "| `choose --report` | `patch`, `area_mm2`, `algorithm`, `seed`, `estimate` and `rough` (scores before it is "
    "laid), "
    "`coverage`, `load`, `paper_load`, `angle_deg` (mean of the top 1 % of angles of the path, a quarter of the "
    "spacing apart), `cuts`, `length_mm`, "
    "`overlap`, `score`, `chosen` (`*`), `failed` (why), `rings_bound` (of algorithms that run round something: the "
    "share "
    "that closed lines of the least radius can cover, at most) |\n"
    "| `sequence --ends` | `stroke`, `region`, `layer`, `z_mm`, `x_mm`, `y_mm` (where it ends), `cause`, `ahead` and "
    "`awaited` (regions), `rise_mm`, `distance_mm` (how far the head would have to reach) |\n"
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

Spoken spoken(std::string_view key, bool on_surface) {
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
    section(out, "Layers: metrics", "Of a toolpath laid in layers, or of the curves of `fill`.", planar_meanings());
    section(out, "Curved surfaces: metrics --surface",
            "Of a path on a surface; d is `--spacing`. [surface-metrics.md](surface-metrics.md) has the methods.",
            surface_meanings());
    section(out, "The head: collide", "`report` is `collide`.", head_meanings());
    section(out, "The job: postproc --job", "`report` is `job`; always TSV.", job_meanings());
    return out + kSaid + kTables;
}

} // namespace filum::metrics::figures
