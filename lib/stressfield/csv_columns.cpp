#include "stressfield/csv_columns.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace filum::stressfield {

namespace {

// What a role is called, the option's word first.
const std::array<std::vector<std::string_view>, kRoles> kNames = {{
    {"x", "posx", "xpos", "coordx", "xcoord", "xcoordinate", "xlocation", "points0", "nodex"},
    {"y", "posy", "ypos", "coordy", "ycoord", "ycoordinate", "ylocation", "points1", "nodey"},
    {"z", "posz", "zpos", "coordz", "zcoord", "zcoordinate", "zlocation", "points2", "nodez"},
    {"s1x", "vx", "d1x", "dirx", "v1x"},
    {"s1y", "vy", "d1y", "diry", "v1y"},
    {"s1z", "vz", "d1z", "dirz", "v1z"},
    {"s1", "sigma1", "maxprincipal", "maximumprincipal", "maximumprincipalstress", "smaxprincipal"},
    {"s2", "sigma2", "midprincipal", "middleprincipal", "middleprincipalstress", "smidprincipal"},
    {"s3", "sigma3", "minprincipal", "minimumprincipal", "minimumprincipalstress", "sminprincipal"},
    {"sxx", "sx", "s11", "ss11", "sigmaxx", "stressxx"},
    {"syy", "sy", "s22", "ss22", "sigmayy", "stressyy"},
    {"szz", "sz", "s33", "ss33", "sigmazz", "stresszz"},
    {"sxy", "s12", "ss12", "sigmaxy", "stressxy", "txy", "tauxy"},
    {"syz", "s23", "ss23", "sigmayz", "stressyz", "tyz", "tauyz"},
    {"szx", "sxz", "s13", "s31", "ss13", "sigmazx", "sigmaxz", "stressxz", "stresszx", "tzx", "txz", "tauzx", "tauxz"},
}};

// Lower case, without a unit in brackets, letters and digits only.
std::string plain(std::string_view name) {
    std::string out;
    for (const char c : name.substr(0, name.find_first_of("[("))) {
        const char l = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c;
        if ((l >= 'a' && l <= 'z') || (l >= '0' && l <= '9')) out += l;
    }
    return out;
}

std::size_t role_of(std::string_view name) {
    const std::string word = plain(name);
    for (std::size_t r = 0; r < kRoles; ++r)
        if (std::find(kNames[r].begin(), kNames[r].end(), word) != kNames[r].end()) return r;
    return kRoles;
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

Columns columns_of_header(const std::vector<std::string_view>& names) {
    Columns out = none();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const std::size_t r = role_of(names[i]); r < kRoles && out[r] == kNoColumn) out[r] = i;
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

bool has_tensor(const Columns& c) { return has(c, kXx, 6); }

std::string missing(const Columns& c) {
    if (!has(c, kX, 3)) return "column for x, y and z";
    if (!has(c, kVx, 3) && !has_tensor(c)) return "set of columns s1x,s1y,s1z or sxx,syy,szz,sxy,syz,szx";
    return "";
}

} // namespace filum::stressfield
