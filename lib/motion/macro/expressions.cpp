#include "macro/expressions.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <utility>

namespace filum::macro {

namespace {

using Kind = Expression::Kind;

struct FunctionName {
    std::string_view name;
    Function function;
    std::size_t least, most; // least and largest number of arguments
};
constexpr std::size_t kAny = 10'000;
constexpr std::array kFunctions{
    FunctionName{"min", Function::min, 2, 2},
    FunctionName{"max", Function::max, 2, 2},
    FunctionName{"random", Function::random, 2, 2},
    FunctionName{"digits", Function::digits, 2, 3},
    FunctionName{"zdigits", Function::zdigits, 2, 3},
    FunctionName{"int", Function::integer, 1, 1},
    FunctionName{"round", Function::round, 1, 1},
    FunctionName{"floor", Function::floor, 1, 1},
    FunctionName{"ceil", Function::ceil, 1, 1},
    FunctionName{"abs", Function::absolute, 1, 1},
    FunctionName{"is_nil", Function::is_nil, 1, 1},
    FunctionName{"empty", Function::empty, 1, 1},
    FunctionName{"size", Function::size, 1, 1},
    FunctionName{"one_of", Function::one_of, 1, kAny},
    FunctionName{"interpolate_table", Function::interpolate, 2, kAny},
    FunctionName{"exists", Function::exists, 1, 1},
    FunctionName{"default_float", Function::otherwise, 2, 2},
    FunctionName{"default_double", Function::otherwise, 2, 2},
    FunctionName{"default_int", Function::otherwise, 2, 2},
    FunctionName{"default_bool", Function::otherwise, 2, 2},
    FunctionName{"default_string", Function::otherwise, 2, 2},
};

// A sign between two values. A higher level binds tighter.
struct BinarySign {
    int level;
    std::string_view text;
    Operator op;
    bool matches = false; // a regular expression follows, no value
};
constexpr std::array kBinarySigns{
    BinarySign{0, "||", Operator::either},        BinarySign{0, "or", Operator::either},
    BinarySign{1, "&&", Operator::both},          BinarySign{1, "and", Operator::both},
    BinarySign{2, "==", Operator::equal},         BinarySign{2, "!=", Operator::unequal},
    BinarySign{2, "<>", Operator::unequal},       BinarySign{2, "=~", Operator::equal, true},
    BinarySign{2, "!~", Operator::unequal, true}, BinarySign{3, "<=", Operator::at_most},
    BinarySign{3, ">=", Operator::at_least},      BinarySign{3, "<", Operator::below},
    BinarySign{3, ">", Operator::above},          BinarySign{4, "+", Operator::add},
    BinarySign{4, "-", Operator::subtract},       BinarySign{5, "*", Operator::multiply},
    BinarySign{5, "/", Operator::divide},         BinarySign{5, "%", Operator::remainder}};
constexpr int kSumLevel = 4, kTightestLevel = 5;

Expression binary(Operator op, Expression left, Expression right, std::size_t at) {
    Expression out;
    out.kind = Kind::binary;
    out.op = op;
    out.at = at;
    out.parts.push_back(std::move(left));
    out.parts.push_back(std::move(right));
    return out;
}

class ExpressionReader {
  public:
    ExpressionReader(Cursor& in, int depth) : in_(in), depth_(depth) {}

    Expression whole() {
        if (++depth_ > kDeepestTemplate) in_.fail("its brackets are nested too deep");
        Expression out = from_level(0);
        if (in_.take("?")) {
            Expression choice;
            choice.kind = Kind::choice;
            choice.at = out.at;
            choice.parts.push_back(std::move(out));
            choice.parts.push_back(whole());
            in_.need(':', "between the two values of '?'");
            choice.parts.push_back(whole());
            out = std::move(choice);
        }
        --depth_;
        return out;
    }

    Expression sum() { return from_level(kSumLevel); }

  private:
    // Values with signs of this level and tighter ones between them, from left to right.
    Expression from_level(int level) {
        if (level > kTightestLevel) return unary();
        Expression out = from_level(level + 1);
        for (;;) {
            const BinarySign* sign = next_sign();
            if (sign == nullptr || sign->level != level) return out;
            const std::size_t at = in_.at();
            in_.step(sign->text.size());
            out = sign->matches ? match(sign->op, std::move(out), at)
                                : binary(sign->op, std::move(out), from_level(level + 1), at);
        }
    }

    // The longest sign that comes next, as "<>" and not "<", or none. Words must be whole. Skips blanks before it.
    const BinarySign* next_sign() {
        const std::string word = in_.peek_name();
        const std::string_view rest = in_.text().substr(in_.at());
        const BinarySign* out = nullptr;
        for (const BinarySign& s : kBinarySigns)
            if ((word.empty() ? rest.starts_with(s.text) : word == s.text) &&
                (out == nullptr || s.text.size() > out->text.size()))
                out = &s;
        return out;
    }

    Expression match(Operator op, Expression left, std::size_t at) {
        Expression out;
        out.kind = Kind::match;
        out.op = op;
        out.at = at;
        out.parts.push_back(std::move(left));
        in_.blanks();
        if (in_.peek() != '/') in_.fail("a regular expression between '/' is missing");
        out.regex = regex();
        return out;
    }

    std::shared_ptr<const Regex> regex() {
        const std::size_t at = in_.at();
        const std::string pattern = quoted('/', false);
        try {
            return std::make_shared<const Regex>(pattern);
        } catch (const std::invalid_argument& e) {
            throw FaultAt{"the regular expression cannot be used: " + std::string(e.what()), at};
        }
    }

    // Takes a text between two quotes.  `unescape`: replaces escapes by their characters.
    std::string quoted(char quote, bool unescape) {
        const std::size_t at = in_.at();
        in_.step();
        std::string out;
        for (;; in_.step()) {
            if (in_.done()) throw FaultAt{std::string("its closing ") + quote + " is missing", at};
            char c = in_.peek();
            if (c == quote) break;
            if (c == '\\') {
                in_.step();
                if (in_.done()) continue;
                if (!unescape) out += c;
                c = in_.peek();
                if (unescape && c == 'n') c = '\n';
                if (unescape && c == 'r') c = '\r';
            }
            out += c;
        }
        in_.step();
        return out;
    }

    Expression unary() {
        in_.blanks();
        Expression out;
        out.at = in_.at();
        const bool minus = in_.peek() == '-', plus = in_.peek() == '+';
        const bool no = (in_.peek() == '!' && in_.peek(1) != '~') || in_.peek_name() == "not";
        if (!minus && !plus && !no) return primary();
        in_.step(in_.peek() == 'n' ? 3 : 1);
        if (++depth_ > kDeepestTemplate) in_.fail("its signs are nested too deep");
        Expression part = unary();
        --depth_;
        if (plus) return part;
        out.kind = Kind::unary;
        out.op = minus ? Operator::negate : Operator::no;
        out.parts.push_back(std::move(part));
        return out;
    }

    Expression primary() {
        const std::size_t at = in_.at();
        const char c = in_.peek();
        Expression out;
        out.at = at;
        if (in_.take("(")) {
            out = whole();
            in_.need(')', "behind an expression");
        } else if (c == '"') {
            out.value = quoted('"', true);
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 ||
                   (c == '.' && std::isdigit(static_cast<unsigned char>(in_.peek(1))) != 0)) {
            out.value = number();
        } else if (in_.take_word("true") || in_.take_word("false")) {
            out.value = in_.text()[at] == 't';
        } else {
            out = named();
        }
        return out;
    }

    Value number() {
        const std::string_view rest = in_.text().substr(in_.at());
        double value = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
        const auto length = static_cast<std::size_t>(end - rest.data());
        const std::string_view word = rest.substr(0, length);
        if (error != std::errc()) in_.fail("'" + std::string(word) + "' is a number beyond all bounds");
        if (word.find_first_of(".eE") == std::string_view::npos) {
            std::int64_t whole = 0;
            if (std::from_chars(word.data(), word.data() + length, whole).ec != std::errc())
                in_.fail("'" + std::string(word) + "' is a number beyond all bounds");
            in_.step(length);
            return whole;
        }
        in_.step(length);
        return value;
    }

    // Takes a variable, an item of one, or a function.
    Expression named() {
        Expression out;
        out.at = in_.at();
        const std::string word = in_.peek_name();
        for (const FunctionName& f : kFunctions)
            if (f.name == word) {
                in_.step(word.size());
                return call(f, out.at);
            }
        out.name = in_.name("where a value should stand");
        out.kind = Kind::variable;
        if (!in_.take("[")) return out;
        out.kind = Kind::item;
        if (++depth_ > kDeepestTemplate) in_.fail("its brackets are nested too deep");
        out.parts.push_back(sum());
        --depth_;
        in_.need(']', "behind an index");
        return out;
    }

    Expression call(const FunctionName& f, std::size_t at) {
        Expression out;
        out.kind = Kind::call;
        out.function = f.function;
        out.name = f.name;
        out.at = at;
        in_.need('(', "behind the name of a function");
        while (!in_.take(")")) {
            if (!out.parts.empty() && !in_.take(",") && f.function != Function::one_of &&
                f.function != Function::interpolate)
                in_.fail("',' or ')' is missing between arguments of " + std::string(f.name));
            argument(f, out);
            if (out.parts.size() > kAny) in_.fail("a function has too many arguments");
        }
        if (out.parts.size() < f.least || out.parts.size() > f.most)
            throw FaultAt{std::string(f.name) + " has " + std::to_string(out.parts.size()) + " arguments; it takes " +
                              std::to_string(f.least) +
                              (f.most == f.least ? ""
                               : f.most == kAny  ? " or more"
                                                 : " or " + std::to_string(f.most)),
                          at};
        return out;
    }

    void argument(const FunctionName& f, Expression& out) {
        in_.blanks();
        if (in_.peek() == ')' && (f.function == Function::one_of || f.function == Function::interpolate))
            return; // after a last comma
        if (f.function == Function::one_of && !out.parts.empty()) return candidate(out);
        if (f.function == Function::interpolate && !out.parts.empty()) { // (x, y): two arguments
            in_.need('(', "before a pair of interpolate_table");
            out.parts.push_back(whole());
            in_.need(',', "in a pair of interpolate_table");
            out.parts.push_back(whole());
            in_.need(')', "behind a pair of interpolate_table");
            return;
        }
        out.parts.push_back(whole());
    }

    // Takes an argument of one_of: a value, /a pattern/, or ~ and a text that holds a pattern.
    void candidate(Expression& to) {
        Expression one;
        one.at = in_.at();
        one.kind = Kind::match;
        if (in_.peek() == '/') {
            one.regex = regex();
        } else if (in_.take("~")) {
            one.parts.push_back(unary());
        } else {
            one = unary();
        }
        to.parts.push_back(std::move(one));
    }

    Cursor& in_;
    int depth_;
};

} // namespace

Expression parse_expression(Cursor& in, int depth) { return ExpressionReader(in, depth).whole(); }
Expression parse_sum(Cursor& in, int depth) { return ExpressionReader(in, depth).sum(); }

} // namespace filum::macro
