#include "base/formula.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace filum {

namespace {

using What = Formula::What;
using Step = Formula::Step;

constexpr int kDeepest = 100; // brackets within brackets

struct Function {
    const char* name;
    What what;
    int arguments;
};
constexpr std::array<Function, 7> kFunctions{{{"sqrt", What::sqrt, 1},
                                              {"abs", What::abs, 1},
                                              {"exp", What::exp, 1},
                                              {"sin", What::sin, 1},
                                              {"cos", What::cos, 1},
                                              {"min", What::min, 2},
                                              {"max", What::max, 2}}};

// Recursive descent: sum, product, sign, power, operand. The steps come in the order of the evaluation.
class Parser {
  public:
    Parser(const std::string& text, const std::vector<std::string>& variables, const std::string& what)
        : text_(text), variables_(variables), what_(what) {}

    std::vector<Step> all() {
        sum();
        if (peek() != '\0') fail("'" + std::string(1, peek()) + "' does not belong there");
        return std::move(steps_);
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        std::string names;
        for (const std::string& v : variables_) names += (names.empty() ? "" : ", ") + v;
        throw Error(Exit::usage, "cannot use '" + text_ + "' for --" + what_ + ": " + why + " at character " +
                                     std::to_string(at_ + 1) + "; a formula has numbers, " + names +
                                     ", + - * / ^, brackets, sqrt, abs, exp, sin, cos, min and max");
    }
    char peek() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    void need(char c) {
        if (!take(c)) fail("'" + std::string(1, c) + "' is missing");
    }
    void put(What what) { steps_.push_back({what, 0, 0}); }

    void sum() {
        if (++depth_ > kDeepest) fail("too many brackets");
        chain(&Parser::product, {{{'+', What::add}, {'-', What::subtract}}});
        --depth_;
    }
    void product() { chain(&Parser::sign, {{{'*', What::multiply}, {'/', What::divide}}}); }

    // Operands with one of two signs between them, from left to right.
    void chain(void (Parser::*operand)(), const std::array<std::pair<char, What>, 2>& signs) {
        (this->*operand)();
        for (bool more = true; more;) {
            more = false;
            for (const auto& [sign, what] : signs)
                if (!more && take(sign)) {
                    (this->*operand)();
                    put(what);
                    more = true;
                }
        }
    }
    void sign() {
        if (++depth_ > kDeepest) fail("too many signs");
        if (take('-')) {
            sign();
            put(What::negate);
        } else {
            power();
        }
        --depth_;
    }
    void power() {
        operand();
        if (!take('^')) return;
        sign(); // 2^3^2 is 2^(3^2)
        put(What::power);
    }
    void operand() {
        if (take('(')) {
            sum();
            need(')');
        } else if (std::isalpha(static_cast<unsigned char>(peek())) != 0) {
            name();
        } else {
            number();
        }
    }
    void number() {
        double value = 0;
        const char* first = text_.data() + at_;
        const auto [end, fault] = std::from_chars(first, text_.data() + text_.size(), value);
        if (fault != std::errc{} || !std::isfinite(value)) fail("a number is missing");
        at_ += static_cast<std::size_t>(end - first);
        steps_.push_back({What::number, value, 0});
    }
    void name() {
        const std::size_t from = at_;
        while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
        const std::string word = text_.substr(from, at_ - from);
        if (word == "pi") {
            steps_.push_back({What::number, std::numbers::pi, 0});
            return;
        }
        const auto function =
            std::find_if(kFunctions.begin(), kFunctions.end(), [&](const Function& f) { return f.name == word; });
        if (function != kFunctions.end()) {
            need('(');
            sum();
            for (int i = 1; i < function->arguments; ++i) {
                need(',');
                sum();
            }
            need(')');
            put(function->what);
            return;
        }
        const auto variable = std::find(variables_.begin(), variables_.end(), word);
        if (variable == variables_.end()) {
            at_ = from;
            fail("'" + word + "' is unknown");
        }
        steps_.push_back({What::variable, 0, static_cast<std::size_t>(variable - variables_.begin())});
    }

    const std::string& text_;
    const std::vector<std::string>& variables_;
    const std::string& what_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::vector<Step> steps_;
};

double applied(What what, double a) {
    switch (what) {
    case What::negate:
        return -a;
    case What::sqrt:
        return std::sqrt(a);
    case What::abs:
        return std::abs(a);
    case What::exp:
        return std::exp(a);
    case What::sin:
        return std::sin(a);
    default:
        return std::cos(a);
    }
}

double applied(What what, double a, double b) {
    switch (what) {
    case What::add:
        return a + b;
    case What::subtract:
        return a - b;
    case What::multiply:
        return a * b;
    case What::divide:
        return a / b;
    case What::power:
        return std::pow(a, b);
    case What::min:
        return std::min(a, b);
    default:
        return std::max(a, b);
    }
}

bool takes_one(What what) {
    return what == What::negate || what == What::sqrt || what == What::abs || what == What::exp || what == What::sin ||
           what == What::cos;
}

} // namespace

Formula::Formula(const std::string& text, const std::vector<std::string>& variables, const std::string& what)
    : text_(text), steps_(Parser(text, variables, what).all()) {}

bool Formula::uses(std::size_t variable) const {
    return std::any_of(steps_.begin(), steps_.end(),
                       [&](const Step& s) { return s.what == What::variable && s.variable == variable; });
}

double Formula::operator()(std::span<const double> variables) const {
    std::vector<double> stack;
    for (const Step& s : steps_) {
        if (s.what == What::number) {
            stack.push_back(s.number);
        } else if (s.what == What::variable) {
            stack.push_back(variables[s.variable]);
        } else if (takes_one(s.what)) {
            stack.back() = applied(s.what, stack.back());
        } else {
            const double b = stack.back();
            stack.pop_back();
            stack.back() = applied(s.what, stack.back(), b);
        }
    }
    return stack.back();
}

} // namespace filum
