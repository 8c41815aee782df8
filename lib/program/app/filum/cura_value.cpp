#include "app/filum/cura_value.hpp"

#include "app/filum/slicer_text.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace filum::app::filum {

namespace {

using List = CuraValue::List;

CuraValue unknown(std::string why) { return {MissingValue{std::move(why)}}; }
CuraValue finite(double value) {
    return std::isfinite(value) ? CuraValue{value} : unknown("a number is beyond all bounds");
}

bool equal(const CuraValue& a, const CuraValue& b) {
    if (const auto x = a.number(), y = b.number(); x && y) return *x == *y;
    const auto* one = std::get_if<List>(&a.as);
    const auto* other = std::get_if<List>(&b.as);
    if (one != nullptr && other != nullptr) return std::ranges::equal(*one, *other, equal);
    const auto* text = std::get_if<std::string>(&a.as);
    const auto* second = std::get_if<std::string>(&b.as);
    return text != nullptr && second != nullptr && *text == *second;
}

// The first argument that cannot be calculated; null if there is none.
const CuraValue* first_unknown(const List& values) {
    const auto at = std::ranges::find_if(values, [](const CuraValue& v) {
        const auto* list = std::get_if<List>(&v.as);
        return !v.known() || (list != nullptr && first_unknown(*list) != nullptr);
    });
    if (at == values.end()) return nullptr;
    return at->known() ? first_unknown(std::get<List>(at->as)) : &*at;
}

CuraValue sum_of(const CuraValue& a, const CuraValue& b) {
    if (size_of(a) + size_of(b) > kLargestValue) return unknown("a text or a list is too long");
    const auto* one = std::get_if<std::string>(&a.as);
    const auto* other = std::get_if<std::string>(&b.as);
    if (one != nullptr && other != nullptr) return {*one + *other};
    const auto* list = std::get_if<List>(&a.as);
    const auto* further = std::get_if<List>(&b.as);
    if (list == nullptr || further == nullptr) return unknown("it adds values that cannot be added");
    List all = *list;
    all.insert(all.end(), further->begin(), further->end());
    return {std::move(all)};
}

// As in Python, halves become even numbers, and decimals are those of the number as it is stored.
CuraValue rounded(double value, double decimals) {
    if (decimals == 0) return {std::nearbyint(value)};
    if (decimals != std::floor(decimals) || decimals < 0 || decimals > 15)
        return unknown("it rounds to " + shortest_text(decimals) + " decimals");
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f", static_cast<int>(decimals), value);
    return {plain_number(text.data()).value_or(value)};
}

using OfNumber = double (*)(double);
constexpr std::pair<std::string_view, OfNumber> kMath[] = {
    {"math.ceil", [](double x) { return std::ceil(x); }},
    {"math.floor", [](double x) { return std::floor(x); }},
    {"math.sqrt", [](double x) { return std::sqrt(x); }},
    {"math.sin", [](double x) { return std::sin(x); }},
    {"math.cos", [](double x) { return std::cos(x); }},
    {"math.tan", [](double x) { return std::tan(x); }},
    {"math.atan", [](double x) { return std::atan(x); }},
    {"math.degrees", [](double x) { return x * 180 / std::numbers::pi; }},
    {"math.radians", [](double x) { return x * std::numbers::pi / 180; }},
    {"abs", [](double x) { return std::abs(x); }},
    {"float", [](double x) { return x; }},
    {"int", [](double x) { return std::trunc(x); }}};

// A function of one list, or of all arguments: max, min, sum, any, all, len.
CuraValue of_list(const std::string& name, const List& arguments) {
    const auto* only = arguments.size() == 1 ? std::get_if<List>(&arguments.front().as) : nullptr;
    const List& values = only != nullptr ? *only : arguments;
    if (name == "len" && only != nullptr) return {static_cast<double>(values.size())};
    if (name == "any" && only != nullptr) return {std::ranges::any_of(values, &CuraValue::truth)};
    if (name == "all" && only != nullptr) return {std::ranges::all_of(values, &CuraValue::truth)};
    const bool sum = name == "sum" && only != nullptr, extreme = name == "max" || name == "min";
    if ((!sum && !extreme) || (extreme && values.empty())) return unknown("it calls " + name + "() without a list");
    double out = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto number = values[i].number();
        if (!number) return unknown("it calculates with a word");
        out = sum ? out + *number : i == 0 ? *number : name == "max" ? std::max(out, *number) : std::min(out, *number);
    }
    return finite(out);
}

} // namespace

std::optional<double> CuraValue::number() const {
    if (const auto* flag = std::get_if<bool>(&as)) return *flag ? 1 : 0;
    const auto* value = std::get_if<double>(&as);
    return value == nullptr ? std::nullopt : std::optional(*value);
}

std::size_t size_of(const CuraValue& value) {
    if (const auto* text = std::get_if<std::string>(&value.as)) return text->size();
    const auto* list = std::get_if<List>(&value.as);
    std::size_t out = 1;
    if (list != nullptr)
        for (const CuraValue& item : *list) out += size_of(item);
    return out;
}

bool CuraValue::truth() const {
    if (const auto* text = std::get_if<std::string>(&as)) return !text->empty();
    if (const auto* list = std::get_if<List>(&as)) return !list->empty();
    return number().value_or(0) != 0;
}

std::string text_of(const CuraValue& value) {
    if (const auto* text = std::get_if<std::string>(&value.as)) return *text;
    const auto* list = std::get_if<List>(&value.as);
    if (list == nullptr) return fixed_text(value.number().value_or(0), 9);
    std::string out = "[";
    for (const CuraValue& item : *list) out += (out.size() > 1 ? ", " : "") + text_of(item);
    return out + "]";
}

CuraValue value_of(std::string_view text) {
    if (const auto number = plain_number(text)) return {*number};
    if (text == "True" || text == "False") return {text == "True"};
    return {std::string(text)};
}

CuraValue arithmetic(std::string_view sign, const CuraValue& a, const CuraValue& b) {
    for (const CuraValue* v : {&a, &b})
        if (!v->known()) return *v;
    const auto x = a.number(), y = b.number();
    if (sign == "+" && !(x && y)) return sum_of(a, b);
    if (!x || !y) return unknown("it calculates with a word");
    if (sign == "+") return finite(*x + *y);
    if (sign == "-") return finite(*x - *y);
    if (sign == "*") return finite(*x * *y);
    if (sign == "**") return finite(std::pow(*x, *y));
    if (*y == 0) return unknown("it divides by zero");
    if (sign == "/") return finite(*x / *y);
    if (sign == "//") return finite(std::floor(*x / *y));
    return finite(*x - *y * std::floor(*x / *y));
}

CuraValue compared(std::string_view sign, const CuraValue& a, const CuraValue& b) {
    for (const CuraValue* v : {&a, &b})
        if (!v->known()) return *v;
    if (sign == "==" || sign == "!=") return {equal(a, b) == (sign == "==")};
    if (sign.ends_with("in")) {
        const auto* list = std::get_if<List>(&b.as);
        const auto *text = std::get_if<std::string>(&b.as), *part = std::get_if<std::string>(&a.as);
        if (list == nullptr && (text == nullptr || part == nullptr)) return unknown("'in' needs a list or a text");
        const bool within = list != nullptr ? std::ranges::any_of(*list, [&](const auto& v) { return equal(a, v); })
                                            : text->find(*part) != std::string::npos;
        return {within == (sign == "in")};
    }
    const auto x = a.number(), y = b.number();
    if (!x || !y) return unknown("it compares a number with a word");
    return {sign == "<" ? *x < *y : sign == ">" ? *x > *y : sign == "<=" ? *x <= *y : *x >= *y};
}

CuraValue python_function(const std::string& name, const List& arguments) {
    if (const CuraValue* bad = first_unknown(arguments)) return *bad;
    const std::size_t count = arguments.size();
    const bool numeric = count > 0 && arguments[0].number().has_value();
    const double first = numeric ? *arguments[0].number() : 0;
    if (name == "bool" && count == 1) return {arguments[0].truth()};
    if (name == "str" && count == 1) return {text_of(arguments[0])};
    if (const auto* text = count == 1 ? std::get_if<std::string>(&arguments[0].as) : nullptr;
        text != nullptr && (name == "int" || name == "float"))
        return plain_number(*text) ? CuraValue{*plain_number(*text)} : unknown("'" + *text + "' is no number");
    if (name == "round" && numeric && count <= 2)
        return rounded(first, count == 2 ? arguments[1].number().value_or(-1) : 0);
    for (const auto& [known, function] : kMath)
        if (name == known && count == 1 && numeric) return finite(function(first));
    for (const char* known : {"max", "min", "sum", "any", "all", "len"})
        if (name == known) return of_list(name, arguments);
    return unknown("it calls " + name + "()");
}

} // namespace filum::app::filum
