#include "stressfield/components.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace filum::stressfield {

namespace {

bool is_alnum(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 'a' - 'A') : c; }

struct GreekLetter {
    std::string_view bytes, word;
};
constexpr GreekLetter kGreek[] = {
    {"\xcf\x83", "sigma"}, {"\xcf\x84", "tau"}, {"\xce\xb5", "epsilon"}, {"\xce\xb3", "gamma"}};

// Whether a bracket contains indices, as in "S(XX)", "S[0,1]".
bool holds_indices(std::string_view inside) {
    std::string only;
    for (const char c : inside)
        if (is_alnum(lower(c))) only += lower(c);
    const bool letters = only.find_first_not_of("xyz") == only.npos;
    const bool digits = only.find_first_not_of("0123") == only.npos;
    return only.size() == 2 && (letters || digits);
}

// The name without brackets that do not contain indices, and without an explanation: "SX: X Normal Stress".
std::string without_brackets(std::string_view name) {
    name = name.substr(0, name.find(": "));
    std::string out;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const char close = c == '[' ? ']' : c == '(' ? ')' : c == '{' ? '}' : '\0';
        if (close == '\0') {
            out += c;
            continue;
        }
        const std::size_t end = name.find(close, i);
        if (!holds_indices(name.substr(i + 1, std::min(end, name.size()) - i - 1))) return out; // the rest is a unit
        out += name.substr(i + 1, end - i - 1);
        if (end == name.npos) return out;
        i = end;
    }
    return out;
}

// Words of a name, in lower case.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> out(1);
    for (const char c : without_brackets(name)) {
        if (is_alnum(lower(c)))
            out.back() += lower(c);
        else if (!out.back().empty())
            out.emplace_back();
    }
    return out;
}

bool contains_any(const std::string& text, std::initializer_list<std::string_view> parts) {
    return std::any_of(parts.begin(), parts.end(), [&](auto p) { return text.find(p) != text.npos; });
}

// Parts of words with a unique meaning. Code_Aster has SIGM, SIEF, EPSI; Ansys EPEL, EPTO; CalculiX TOSTRAIN.
Quantity by_part(const std::string& text) {
    if (contains_any(text, {"strain", "epsi", "epel", "eppl", "epto", "epth", "epcr", "deform", "dehnung", "gamma",
                            "lagrange", "almansi", "hencky", "displacement"}))
        return Quantity::strain;
    if (contains_any(text,
                     {"stress", "sigma", "sigm", "sief", "sieq", "cauchy", "kirchhoff", "contrainte", "spannung"}))
        return Quantity::stress;
    return Quantity::unknown;
}

// Short words that only count as whole words. Abaqus has S, and E, LE, EE, PE, NE, IE, THE, CE, ER.
Quantity by_word(const std::string& word) {
    static const std::set<std::string, std::less<>> stress = {"s", "ss", "si", "sg", "sig", "t", "tau", "solids"};
    static const std::set<std::string, std::less<>> strain = {
        "e", "ee", "le", "lele", "pe", "pepe", "ne", "er", "ie", "ce", "me", "eps", "ep", "the", "g", "eeps", "solide"};
    return stress.contains(word) ? Quantity::stress : strain.contains(word) ? Quantity::strain : Quantity::unknown;
}

constexpr std::string_view kEntries[] = {"xx", "yy", "zz", "xy", "yz", "zx"};

int entry_of(int row, int column) {
    constexpr int at[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    return at[row][column];
}

} // namespace

std::string plain(std::string_view name) {
    std::string out;
    const std::string text = without_brackets(name);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_alnum(lower(text[i]))) out += lower(text[i]);
        for (const auto& letter : kGreek)
            if (std::string_view(text).substr(i).starts_with(letter.bytes)) out += letter.word;
    }
    return out;
}

Quantity quantity_of(std::string_view name) {
    const std::string all = plain(name);
    if (const Quantity q = by_part(all); q != Quantity::unknown) return q;
    if (const Quantity q = by_word(all); q != Quantity::unknown) return q;
    for (const auto& word : words_of(name))
        if (const Quantity q = by_word(word); q != Quantity::unknown) return q;
    return Quantity::unknown;
}

std::optional<Component> component_of(std::string_view name) {
    static const std::set<std::string, std::less<>> one_letter = {
        "",       "s",           "ss",           "sig", "sigma", "stress", "solids",
        "cauchy", "nodalstress", "normalstress", "e",   "ep",    "strain"};
    const std::string text = plain(name);
    const auto axis = [&](std::size_t from_end, std::string_view letters) {
        const std::size_t at = from_end <= text.size() ? letters.find(text[text.size() - from_end]) : letters.npos;
        return at == letters.npos ? -1 : static_cast<int>(at);
    };
    const auto part = [&](std::size_t less, int row, int column) {
        return Component{text.substr(0, text.size() - less), row, column, less == 1, false, false};
    };
    if (axis(1, "xyz") >= 0 && axis(2, "xyz") >= 0) return part(2, axis(2, "xyz"), axis(1, "xyz"));
    if (axis(1, "xyz") >= 0 && one_letter.contains(text.substr(0, text.size() - 1)))
        return part(1, axis(1, "xyz"), axis(1, "xyz"));
    if (axis(1, "0123") < 0 || axis(2, "0123") < 0) return {};
    // unchanged; the set of names determines whether digits start at 0 or 1
    Component out = part(2, axis(2, "0123"), axis(1, "0123"));
    out.digits = true;
    out.has_zero = out.row == 0 || out.column == 0;
    return out;
}

std::string text_of(const Order& order) {
    std::string out;
    for (const int e : order)
        out += (out.empty() ? "" : " ") + std::string(e == kUnused ? std::string_view("-") : kEntries[e]);
    return out;
}

Order vtk_order(std::size_t width) { return width == 9 ? Order{0, 3, 5, 3, 1, 4, 5, 4, 2} : Order{0, 1, 2, 3, 4, 5}; }

std::optional<Order> order_of_names(const std::vector<std::string>& names) {
    std::vector<std::optional<Component>> parts;
    bool zero = false, three = false;
    for (const auto& name : names) {
        parts.push_back(component_of(name));
        if (!parts.back() || !parts.back()->digits) continue;
        zero |= parts.back()->has_zero;
        three |= parts.back()->row == 3 || parts.back()->column == 3;
    }
    if (zero && three) return {};
    Order out;
    std::array<std::array<int, 3>, 3> times{};
    for (auto& c : parts) {
        out.push_back(kUnused);
        if (!c) continue;
        const int base = c->digits && !zero ? 1 : 0;
        if (c->row - base < 0 || c->column - base < 0) return {};
        ++times[static_cast<std::size_t>(c->row - base)][static_cast<std::size_t>(c->column - base)];
        out.back() = entry_of(c->row - base, c->column - base);
    }
    bool six = true, nine = true;
    for (std::size_t i = 0; i < 3; ++i) {
        six = six && times[i][i] == 1 && times[i][(i + 1) % 3] + times[(i + 1) % 3][i] == 1;
        for (std::size_t j = 0; j < 3; ++j) nine = nine && times[i][j] == 1;
    }
    if (!six && !nine) return {};
    return out;
}

Order order_of_option(const std::string& words, std::size_t width) {
    static const std::pair<std::string_view, Order> known[] = {{"vtk", {0, 1, 2, 3, 4, 5}},
                                                               {"abaqus", {0, 1, 2, 3, 5, 4}},
                                                               {"voigt", {0, 1, 2, 4, 5, 3}},
                                                               {"upper", {0, 3, 5, 1, 4, 2}}};
    for (const auto& [name, order] : known)
        if (words == name && width == 6) return order;
    if (words == "vtk") return vtk_order(width);
    std::vector<std::string> names;
    for (std::size_t from = 0; from <= words.size();) {
        const std::size_t end = std::min(words.find(',', from), words.size());
        names.push_back(words.substr(from, end - from));
        from = end + 1;
    }
    const auto order = order_of_names(names);
    if (!order || order->size() != width)
        throw Error(Exit::usage, "cannot use '" + words + "' for --order: it does not name the " +
                                     std::to_string(width) +
                                     " numbers of a tensor; give vtk, abaqus, voigt, upper, or names as in "
                                     "xx,yy,zz,xy,yz,xz");
    return *order;
}

} // namespace filum::stressfield
