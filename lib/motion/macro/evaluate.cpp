#include "macro/evaluate.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace filum::macro {

namespace {

using Kind = Expression::Kind;
using Whole = std::int64_t;

constexpr std::size_t kLongestText = std::size_t{16} << 20;
constexpr double kEqual = 1e-8; // numbers that differ by less are equal, as in PrusaSlicer

bool is_number(const Value& v) { return std::holds_alternative<Whole>(v) || std::holds_alternative<double>(v); }
bool is_text(const Value& v) { return std::holds_alternative<std::string>(v); }

[[noreturn]] void mismatch(const char* what, const Value& left, const Value& right, std::size_t at) {
    throw FaultAt{std::string(what) + " " + type_name(left) + " and " + type_name(right), at};
}

Value whole_result(Operator op, Whole a, Whole b, std::size_t at) {
    Whole out = 0;
    bool beyond = false;
    switch (op) {
    case Operator::add:
        beyond = __builtin_add_overflow(a, b, &out);
        break;
    case Operator::subtract:
        beyond = __builtin_sub_overflow(a, b, &out);
        break;
    case Operator::multiply:
        beyond = __builtin_mul_overflow(a, b, &out);
        break;
    default:
        beyond = a == std::numeric_limits<Whole>::min() && b == -1;
        if (!beyond) out = op == Operator::divide ? a / b : a % b;
        break;
    }
    if (beyond) throw FaultAt{"the result is a number beyond all bounds", at};
    return out;
}

Value arithmetic(Operator op, const Value& left, const Value& right, const Variables& in, std::size_t at) {
    if (op == Operator::add && (is_text(left) || is_text(right))) {
        std::string out = text_of(left, in.scope->numbers) + text_of(right, in.scope->numbers);
        if (out.size() > kLongestText) throw FaultAt{"a text grows beyond 16 MB", at};
        return out;
    }
    if (!is_number(left) || !is_number(right)) mismatch("cannot calculate with", left, right, at);
    const double a = number_of(left, at), b = number_of(right, at);
    if ((op == Operator::divide || op == Operator::remainder) && b == 0) throw FaultAt{"division by zero", at};
    if (std::holds_alternative<Whole>(left) && std::holds_alternative<Whole>(right))
        return whole_result(op, std::get<Whole>(left), std::get<Whole>(right), at);
    const double out = op == Operator::add        ? a + b
                       : op == Operator::subtract ? a - b
                       : op == Operator::multiply ? a * b
                       : op == Operator::divide   ? a / b
                                                  : std::fmod(a, b);
    if (!std::isfinite(out)) throw FaultAt{"the result is a number beyond all bounds", at};
    return out;
}

// Compares two values: below 0, 0 or above 0 if left is below, equal to or above right.
int order(const Value& left, const Value& right, bool equality, const Variables& in, std::size_t at) {
    if (is_number(left) && is_number(right)) {
        if (std::holds_alternative<Whole>(left) && std::holds_alternative<Whole>(right)) {
            const Whole a = std::get<Whole>(left), b = std::get<Whole>(right);
            return a < b ? -1 : a > b ? 1 : 0;
        }
        const double a = number_of(left, at), b = number_of(right, at);
        if (equality && std::abs(a - b) < kEqual) return 0;
        return a < b ? -1 : a > b ? 1 : 0;
    }
    if (is_text(left) || is_text(right))
        return text_of(left, in.scope->numbers).compare(text_of(right, in.scope->numbers));
    if (equality && left.index() == right.index() && std::holds_alternative<bool>(left)) return left == right ? 0 : 1;
    mismatch("cannot compare", left, right, at);
}

// The value of a condition; none if the value is not a condition.
std::optional<bool> truth(const Value& value, const Variables& in) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag;
    const auto* number = std::get_if<Whole>(&value);
    if (in.scope->numbers_hold && number != nullptr && (*number == 0 || *number == 1)) return *number == 1;
    return {};
}

Value binary(const Expression& e, const Variables& in) {
    const Value left = evaluate(e.parts[0], in), right = evaluate(e.parts[1], in);
    switch (e.op) {
    case Operator::equal:
        return order(left, right, true, in, e.at) == 0;
    case Operator::unequal:
        return order(left, right, true, in, e.at) != 0;
    case Operator::below:
        return order(left, right, false, in, e.at) < 0;
    case Operator::above:
        return order(left, right, false, in, e.at) > 0;
    case Operator::at_most:
        return order(left, right, false, in, e.at) <= 0;
    case Operator::at_least:
        return order(left, right, false, in, e.at) >= 0;
    case Operator::both:
    case Operator::either: {
        const auto a = truth(left, in), b = truth(right, in);
        if (!a || !b) mismatch("'and' and 'or' need conditions, not", left, right, e.at);
        return e.op == Operator::both ? *a && *b : *a || *b;
    }
    default:
        return arithmetic(e.op, left, right, in, e.at);
    }
}

Value unary(const Expression& e, const Variables& in) {
    const Value part = evaluate(e.parts[0], in);
    if (e.op == Operator::no) {
        const auto flag = truth(part, in);
        if (!flag) throw FaultAt{std::string("'not' needs a condition, not ") + type_name(part), e.at};
        return !*flag;
    }
    return arithmetic(Operator::subtract, Whole{0}, part, in, e.at);
}

Value match(const Expression& e, const Variables& in) {
    const Value subject = evaluate(e.parts[0], in);
    const auto* text = std::get_if<std::string>(&subject);
    if (text == nullptr)
        throw FaultAt{std::string("a regular expression needs a text before it, not ") + type_name(subject), e.at};
    return e.regex->matches(*text) == (e.op == Operator::equal);
}

} // namespace

double number_of(const Value& value, std::size_t place) {
    if (const auto* whole = std::get_if<Whole>(&value)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value)) return *number;
    throw FaultAt{std::string("a number is needed, not ") + type_name(value), place};
}

const Variable* Variables::find(std::string_view name) const {
    if (const auto local = locals.find(name); local != locals.end()) return &local->second;
    if (const auto global = scope->globals.find(name); global != scope->globals.end()) return &global->second;
    return scope->find ? scope->find(name) : nullptr;
}

const Variable& Variables::at(const std::string& name, std::size_t place) const {
    if (const Variable* found = find(name)) return *found;
    throw FaultAt{"'" + name + "' is no known name", place};
}

std::size_t index_of(const Expression& e, const Variables& variables) {
    const Value value = evaluate(e, variables);
    const auto* whole = std::get_if<Whole>(&value);
    if (whole == nullptr) throw FaultAt{std::string("an index must be a whole number, not ") + type_name(value), e.at};
    if (*whole < 0) throw FaultAt{"the index " + std::to_string(*whole) + " is below 0", e.at};
    return static_cast<std::size_t>(*whole);
}

const Value& item(const Variable& list, std::size_t index, const std::string& name, std::size_t place) {
    if (!list.list && !list.either)
        throw FaultAt{"'" + name + "' is one value, not a list; leave its index out", place};
    if (list.items.empty()) throw FaultAt{"'" + name + "' is an empty list", place};
    return list.items[index < list.items.size() ? index : 0];
}

// The value in an expression NAME[INDEX]. An index below 0 or beyond the end stands for the first value, as in
// PrusaSlicer 2.5, SuperSlicer and Bambu Studio; newer versions of PrusaSlicer and OrcaSlicer refuse those below 0.
static const Value& item_at(const Expression& e, const Variables& variables) {
    const Value index = evaluate(e.parts[0], variables);
    const auto* whole = std::get_if<Whole>(&index);
    const bool below = whole != nullptr && *whole < 0;
    return item(variables.at(e.name, e.at), below ? 0 : index_of(e.parts[0], variables), e.name, e.at);
}

bool holds(const Expression& e, const Variables& variables) {
    const Value value = evaluate(e, variables);
    if (const auto flag = truth(value, variables)) return *flag;
    throw FaultAt{std::string("a condition must be true or false, not ") + type_name(value), e.at};
}

Value evaluate(const Expression& e, const Variables& variables) {
    switch (e.kind) {
    case Kind::literal:
        return e.value;
    case Kind::variable: {
        const Variable& found = variables.at(e.name, e.at);
        if (found.list && !(found.either && !found.items.empty()))
            throw FaultAt{"'" + e.name + "' is a list; say which of its values, as " + e.name + "[0]", e.at};
        return found.items.at(0);
    }
    case Kind::item:
        return item_at(e, variables);
    case Kind::unary:
        return unary(e, variables);
    case Kind::binary:
        return binary(e, variables);
    case Kind::choice:
        return evaluate(e.parts[holds(e.parts[0], variables) ? 1 : 2], variables);
    case Kind::match:
        return match(e, variables);
    case Kind::call:
        return call(e, variables);
    }
    return {};
}

} // namespace filum::macro
