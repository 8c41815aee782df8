#include "stressfield/units.hpp"

#include "base/length_unit.hpp"

#include <algorithm>
#include <array>

namespace filum::stressfield {

namespace {

struct Unit {
    std::string_view name; // in lower case
    double factor;         // to MPa
};

constexpr double kPsi = 0.006894757293168361, kStandardGravity = 9.80665;

constexpr Unit kStresses[] = {{"pa", 1e-6},
                              {"pascal", 1e-6},
                              {"hpa", 1e-4},
                              {"kpa", 1e-3},
                              {"mpa", 1},
                              {"megapascal", 1},
                              {"gpa", 1e3},
                              {"n/m2", 1e-6},
                              {"kn/m2", 1e-3},
                              {"mn/m2", 1},
                              {"n/mm2", 1},
                              {"kn/mm2", 1e3},
                              {"n/cm2", 1e-2},
                              {"kn/cm2", 10},
                              {"bar", 0.1},
                              {"mbar", 1e-4},
                              {"kbar", 100},
                              {"atm", 0.101325},
                              {"psi", kPsi},
                              {"lb/in2", kPsi},
                              {"lbf/in2", kPsi},
                              {"ksi", 1e3 * kPsi},
                              {"kip/in2", 1e3 * kPsi},
                              {"msi", 1e6 * kPsi},
                              {"psf", kPsi / 144},
                              {"lbf/ft2", kPsi / 144},
                              {"kgf/mm2", kStandardGravity},
                              {"kgf/cm2", kStandardGravity / 100},
                              {"dyn/cm2", 1e-7}};

// Lower case without blanks, '^', '*'; superscript digits become plain ones: "N m^-2" becomes "n/m2".
std::string canonical(std::string_view unit) {
    std::string out;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        if (unit.substr(i).starts_with("\xc2\xb2")) { // superscript 2
            out += '2';
            ++i;
        } else if (unit.substr(i).starts_with("^-2") || unit.substr(i).starts_with("**-2")) {
            const std::size_t letters = out.find_last_not_of("abcdefghijklmnopqrstuvwxyz");
            const std::size_t blank = unit.rfind(' ', i);
            if (blank != unit.npos && letters == out.npos) out.insert(out.size() - (i - blank - 1), "/");
            out += '2';
            i += unit[i] == '^' ? 2 : 3;
        } else if (unit[i] != ' ' && unit[i] != '^' && unit[i] != '*' && unit[i] != '.') {
            out += unit[i] >= 'A' && unit[i] <= 'Z' ? static_cast<char>(unit[i] + 'a' - 'A') : unit[i];
        }
    }
    return out;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t");
    return from == text.npos ? std::string_view() : text.substr(from, text.find_last_not_of(" \t") + 1 - from);
}

// The text in the last brackets, including nested ones.
std::string_view last_brackets(std::string_view name) {
    const std::size_t close = name.find_last_of("])}"), open = name.find_last_of("[({");
    if (close == name.npos) return open == name.npos ? std::string_view() : name.substr(open + 1);
    int depth = 0;
    for (std::size_t i = close + 1; i-- > 0;) {
        if (std::string_view("])}").find(name[i]) != std::string_view::npos) ++depth;
        if (std::string_view("[({").find(name[i]) != std::string_view::npos) --depth;
        if (depth == 0) return name.substr(i + 1, close - i - 1);
    }
    return {};
}

std::optional<double> find(Dimension dimension, const std::string& name) {
    if (dimension == Dimension::length) return length_of_name(name);
    for (const Unit& u : kStresses)
        if (u.name == name) return u.factor;
    return {};
}

} // namespace

std::optional<double> factor_of(Dimension dimension, std::string_view unit) {
    unit = trimmed(unit);
    if (unit == "mPa") return {};
    if (dimension == Dimension::stress && unit == "mN/m2") return {};
    return find(dimension, canonical(unit));
}

std::string_view without_unit(std::string_view name) {
    const std::size_t at = name.find_last_of(" _,:;.-");
    if (at == name.npos) return name;
    const std::string_view last = trimmed(name.substr(at + 1));
    const bool unit = factor_of(Dimension::length, last) || factor_of(Dimension::stress, last);
    return unit ? name.substr(0, at) : name;
}

std::string unit_in(Dimension dimension, std::string_view name) {
    if (const std::string_view rest = without_unit(name); rest.size() < name.size())
        return std::string(name.substr(rest.size() + 1)); // of either dimension: a wrong one is rejected
    const std::string_view inside = trimmed(last_brackets(name));
    if (factor_of(dimension, inside)) return std::string(inside);
    if (inside.find_first_not_of("0123456789xyzXYZ, ") == inside.npos) return ""; // indices: "Points[0]", "S(XX)"
    // "N/mm^2 (MPa)": two names of one unit.
    const std::size_t more = inside.find_first_of("[({");
    if (more != inside.npos && factor_of(dimension, inside.substr(0, more)))
        return std::string(trimmed(inside.substr(0, more)));
    return std::string(inside);
}

} // namespace filum::stressfield
