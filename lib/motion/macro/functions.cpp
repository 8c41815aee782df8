#include "macro/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace filum::macro {

namespace {

using Whole = std::int64_t;

bool is_whole(const Value& v) { return std::holds_alternative<Whole>(v); }

Value to_whole(double value, std::size_t at) {
    constexpr double most = 9e18;
    if (!(std::abs(value) < most)) throw FaultAt{"the result is a number beyond all bounds", at};
    return static_cast<Whole>(value);
}

Value rounded(Function f, const Value& value, std::size_t at) {
    const double number = number_of(value, at);
    if (f == Function::absolute) {
        if (is_whole(value) && number > 0) return value;
        return is_whole(value) ? to_whole(-number, at) : Value(std::abs(number));
    }
    if (is_whole(value)) return value;
    return to_whole(f == Function::round   ? std::round(number)
                    : f == Function::floor ? std::floor(number)
                    : f == Function::ceil  ? std::ceil(number)
                                           : std::trunc(number),
                    at);
}

// The next 64 random bits (SplitMix64).  Equal jobs get equal bits.
std::uint64_t next(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

Value random(const Value& low, const Value& high, std::uint64_t& state, std::size_t at) {
    const double a = number_of(low, at), b = number_of(high, at);
    if (b < a) throw FaultAt{"random needs its lower bound first", at};
    const std::uint64_t bits = next(state);
    if (is_whole(low) && is_whole(high)) {
        const std::uint64_t span =
            static_cast<std::uint64_t>(std::get<Whole>(high)) - static_cast<std::uint64_t>(std::get<Whole>(low)) + 1;
        const std::uint64_t offset = span == 0 ? bits : bits % span;
        return static_cast<Whole>(static_cast<std::uint64_t>(std::get<Whole>(low)) + offset);
    }
    constexpr double scale = 1.0 / (std::uint64_t{1} << 53);
    return a + (b - a) * (static_cast<double>(bits >> 11) * scale);
}

// Writes a number in a field of a given width, with given decimals.
Value digits(const Expression& e, const Variables& in) {
    const Value value = evaluate(e.parts[0], in);
    const double number = number_of(value, e.at);
    const auto count = [&](std::size_t part) {
        const Value v = evaluate(e.parts[part], in);
        if (!is_whole(v)) throw FaultAt{e.name + " needs a whole number of digits", e.parts[part].at};
        return static_cast<int>(std::clamp(std::get<Whole>(v), Whole{0}, Whole{64}));
    };
    const int wide = count(1);
    const bool zeros = e.function == Function::zdigits;
    std::array<char, 512> out{};
    if (e.parts.size() == 3)
        std::snprintf(out.data(), out.size(), zeros ? "%0*.*f" : "%*.*f", wide, count(2), number);
    else
        std::snprintf(out.data(), out.size(), zeros ? "%0*lld" : "%*lld", wide,
                      static_cast<long long>(std::get<Whole>(rounded(Function::round, value, e.at))));
    return std::string(out.data());
}

// The variable that an argument names.  Throws FaultAt if the argument is not a name.
const Variable& named(const Expression& argument, const Variables& in, const std::string& function) {
    if (argument.kind != Expression::Kind::variable && argument.kind != Expression::Kind::item)
        throw FaultAt{function + " needs a name in its brackets", argument.at};
    return in.at(argument.name, argument.at);
}

bool is_nil(const Expression& e, const Variables& in) {
    const Expression& argument = e.parts[0];
    const Variable& variable = named(argument, in, e.name);
    const auto nil = [](const Value& v) { return std::holds_alternative<std::monostate>(v); };
    if (argument.kind == Expression::Kind::item)
        return nil(item(variable, index_of(argument.parts[0], in), argument.name, argument.at));
    if (variable.list)
        throw FaultAt{"'" + argument.name + "' is a list; say which of its values, as " + argument.name + "[0]",
                      argument.at};
    return nil(variable.items.at(0));
}

Value length(const Expression& e, const Variables& in) {
    const Variable& variable = named(e.parts[0], in, e.name);
    if (!variable.list) throw FaultAt{"'" + e.parts[0].name + "' is one value, not a list", e.parts[0].at};
    if (e.function == Function::empty) return variable.items.empty();
    return static_cast<Whole>(variable.items.size());
}

bool one_of(const Expression& e, const Variables& in) {
    const std::string subject = text_of(evaluate(e.parts[0], in), in.scope->numbers);
    for (std::size_t i = 1; i < e.parts.size(); ++i) {
        const Expression& part = e.parts[i];
        if (part.kind == Expression::Kind::match && part.regex != nullptr && part.parts.empty()) {
            if (part.regex->matches(subject)) return true;
        } else if (part.kind == Expression::Kind::match && part.regex == nullptr) {
            const std::string pattern = text_of(evaluate(part.parts[0], in), in.scope->numbers);
            try {
                if (Regex(pattern).matches(subject)) return true;
            } catch (const std::invalid_argument& wrong) {
                throw FaultAt{"the regular expression cannot be used: " + std::string(wrong.what()), part.at};
            }
        } else if (text_of(evaluate(part, in), in.scope->numbers) == subject) {
            return true;
        }
    }
    return false;
}

// Interpolates between the pairs of a table.  Beyond its ends the first or last value holds.
double interpolated(const Expression& e, const Variables& in) {
    const auto number = [&](std::size_t i) { return number_of(evaluate(e.parts[i], in), e.parts[i].at); };
    const double x = number(0);
    double before_x = number(1), before_y = number(2);
    if (x <= before_x) return before_y;
    for (std::size_t i = 3; i + 1 < e.parts.size(); i += 2) {
        const double next_x = number(i), next_y = number(i + 1);
        if (next_x <= before_x) throw FaultAt{"interpolate_table needs rising values of x", e.parts[i].at};
        if (x <= next_x) return before_y + (next_y - before_y) * (x - before_x) / (next_x - before_x);
        before_x = next_x;
        before_y = next_y;
    }
    return before_y;
}

Value least(const Expression& e, const Variables& in) {
    const Value a = evaluate(e.parts[0], in), b = evaluate(e.parts[1], in);
    const double x = number_of(a, e.parts[0].at), y = number_of(b, e.parts[1].at);
    const bool first = e.function == Function::min ? !(y < x) : !(x < y);
    if (is_whole(a) && is_whole(b)) return first ? a : b;
    return first ? x : y;
}

} // namespace

Value call(const Expression& e, const Variables& in) {
    switch (e.function) {
    case Function::min:
    case Function::max:
        return least(e, in);
    case Function::random:
        return random(evaluate(e.parts[0], in), evaluate(e.parts[1], in), in.scope->random, e.at);
    case Function::digits:
    case Function::zdigits:
        return digits(e, in);
    case Function::integer:
    case Function::round:
    case Function::floor:
    case Function::ceil:
    case Function::absolute:
        return rounded(e.function, evaluate(e.parts[0], in), e.at);
    case Function::is_nil:
        return is_nil(e, in);
    case Function::empty:
    case Function::size:
        return length(e, in);
    case Function::one_of:
        return one_of(e, in);
    case Function::interpolate:
        return interpolated(e, in);
    case Function::exists:
        return e.parts[0].kind == Expression::Kind::variable && in.find(e.parts[0].name) != nullptr;
    case Function::otherwise:
        if (e.parts[0].kind == Expression::Kind::variable && in.find(e.parts[0].name) == nullptr)
            return evaluate(e.parts[1], in);
        return evaluate(e.parts[0], in);
    }
    return {};
}

} // namespace filum::macro
