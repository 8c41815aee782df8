#include "stressfield/csv_columns.hpp"

#include "base/error.hpp"
#include "stressfield/components.hpp"
#include "stressfield/units.hpp"

#include <algorithm>

namespace filum::stressfield {

namespace {

// Names of roles, the option's word first. Entries of a tensor have further names, see component_of.
const std::array<std::vector<std::string_view>, kRoles> kNames = {{
    {"x", "posx", "xpos", "coordx", "coorx", "xcoord", "xcoordinate", "xlocation", "points0", "pointsx", "nodex"},
    {"y", "posy", "ypos", "coordy", "coory", "ycoord", "ycoordinate", "ylocation", "points1", "pointsy", "nodey"},
    {"z", "posz", "zpos", "coordz", "coorz", "zcoord", "zcoordinate", "zlocation", "points2", "pointsz", "nodez"},
    {"s1x", "vx", "d1x", "dirx", "v1x"},
    {"s1y", "vy", "d1y", "diry", "v1y"},
    {"s1z", "vz", "d1z", "dirz", "v1z"},
    {"s1", "sigma1", "maxprincipal", "maximumprincipal", "maximumprincipalstress", "smaxprincipal"},
    {"s2", "sigma2", "midprincipal", "middleprincipal", "middleprincipalstress", "smidprincipal"},
    {"s3", "sigma3", "minprincipal", "minimumprincipal", "minimumprincipalstress", "sminprincipal"},
    {"sxx"},
    {"syy"},
    {"szz"},
    {"sxy"},
    {"syz"},
    {"szx"},
}};

// The role with this name.
std::size_t role_of(std::string_view name) {
    name = without_unit(name);
    const std::string word = plain(name);
    for (std::size_t r = 0; r < kRoles; ++r)
        if (std::find(kNames[r].begin(), kNames[r].end(), word) != kNames[r].end()) return r;
    const auto c = component_of(name);
    if (!c || quantity_of(c->prefix) != Quantity::stress || c->has_zero) return kRoles;
    const int base = c->digits ? 1 : 0;
    constexpr Role entries[3][3] = {{kXx, kXy, kZx}, {kXy, kYy, kYz}, {kZx, kYz, kZz}};
    return entries[c->row - base][c->column - base];
}

bool has(const Columns& c, std::size_t first, std::size_t count) {
    for (std::size_t r = first; r < first + count; ++r)
        if (c[r] == kNoColumn) return false;
    return true;
}

Columns none() {
    Columns out;
    out.fill(kNoColumn);
    return out;
}

} // namespace

Columns columns_of_header(const std::vector<std::string_view>& names, std::string& doubt) {
    Columns out = none();
    std::array<std::size_t, kRoles> second = none();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t r = role_of(names[i]);
        if (r == kRoles) continue;
        (out[r] == kNoColumn ? out[r] : second[r]) = i;
    }
    doubt = "";
    for (std::size_t r = 0; r < kRoles && doubt.empty(); ++r)
        if (second[r] != kNoColumn && is_used(out, r))
            doubt = "its columns '" + std::string(names[out[r]]) + "' and '" + std::string(names[second[r]]) +
                    "' both may be " + std::string(kNames[r].front());
    return out;
}

Columns columns_of_option(const std::string& words) {
    Columns out = none();
    std::size_t column = 0;
    for (std::size_t from = 0; from <= words.size(); ++column) {
        const std::size_t end = std::min(words.find(',', from), words.size());
        const std::string word = words.substr(from, end - from);
        from = end + 1;
        if (word == "-") continue;
        const std::size_t r = role_of(word);
        if (r == kRoles || out[r] != kNoColumn)
            throw Error(Exit::usage, "cannot use '" + word +
                                         "' for --columns: it is no role, or one given twice; roles are " +
                                         "x,y,z and s1x,s1y,s1z,s1,s2,s3 or sxx,syy,szz,sxy,syz,szx, and - for none");
        out[r] = column;
    }
    if (const std::string what = missing(out); !what.empty())
        throw Error(Exit::usage, "cannot use '" + words + "' for --columns: there is no " + what);
    return out;
}

Columns columns_of_count(std::size_t count) {
    Columns out = none();
    if (count == 6 || count == 7)
        for (std::size_t r = 0; r < count; ++r) out[r] = r;
    return out;
}

bool has_position(const Columns& c) { return has(c, kX, 3); }
bool has_tensor(const Columns& c) { return has(c, kXx, 6); }

bool is_used(const Columns& c, std::size_t role) {
    return c[role] != kNoColumn && (role <= kZ || (has_tensor(c) ? role >= kXx : role < kXx));
}

std::string missing(const Columns& c) {
    if (!has_position(c)) return "column for x, y and z";
    if (!has(c, kVx, 3) && !has_tensor(c)) return "set of columns s1x,s1y,s1z or sxx,syy,szz,sxy,syz,szx";
    return "";
}

bool tells_cases(std::string_view name) {
    static constexpr std::string_view kWords[] = {
        "step", "stepname", "stepid",     "stepnumber", "frame",      "frameid",     "increment",
        "inc",  "loadcase", "lc",         "case",       "subcase",    "substep",     "loadstep",
        "time", "timestep", "steptime",   "timevalue",  "mode",       "modenumber",  "frequency",
        "freq", "set",      "resultcase", "layer",      "outputcase", "sectionpoint"};
    const std::string word = plain(name);
    return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

} // namespace filum::stressfield
