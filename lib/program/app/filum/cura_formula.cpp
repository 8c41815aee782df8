#include "app/filum/cura_formula.hpp"

#include "app/filum/slicer_text.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <utility>

namespace filum::app::filum {

namespace {

using List = CuraValue::List;

constexpr int kDeepestBrackets = 60; // most brackets, signs, powers and conditions within each other

// The syntax of a formula is none that Filum reads.
struct SyntaxFault {
    std::string why;
};

// Reads and evaluates a formula in one pass.  Throws SyntaxFault.
class Formula {
  public:
    Formula(std::string_view text, const std::function<CuraValue(const std::string&)>& setting)
        : text_(text), setting_(setting) {}

    CuraValue all() {
        CuraValue out = choice();
        blanks();
        if (at_ != text_.size()) fault();
        return out;
    }

  private:
    [[noreturn]] void fault() const {
        throw SyntaxFault{at_ < text_.size()
                              ? "Filum cannot read it from '" + std::string(text_.substr(at_, 12)) + "' on"
                              : "its end is missing"};
    }
    void blanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    }
    static bool letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
    [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    // Takes a sign, or a whole word.
    bool take(std::string_view sign) {
        blanks();
        if (!text_.substr(at_).starts_with(sign)) return false;
        const std::size_t end = at_ + sign.size();
        if (letter(sign.back()) && end < text_.size() && letter(text_[end])) return false;
        at_ = end;
        return true;
    }
    // Takes the first of the signs that is there; "" if none is.
    std::string_view take_one(std::initializer_list<std::string_view> signs) {
        const auto* const at = std::ranges::find_if(signs, [&](std::string_view sign) { return take(sign); });
        return at == signs.end() ? "" : *at;
    }
    void need(std::string_view sign) {
        if (!take(sign)) fault();
    }

    // What `read` reads, one level deeper.
    CuraValue deeper(CuraValue (Formula::*read)()) {
        if (++depth_ > kDeepestBrackets) throw SyntaxFault{"it is nested too deep"};
        CuraValue out = (this->*read)();
        --depth_;
        return out;
    }

    CuraValue choice() {
        CuraValue out = deeper(&Formula::either);
        if (take("if")) {
            const CuraValue condition = either();
            need("else");
            CuraValue otherwise = deeper(&Formula::choice);
            if (!condition.known())
                out = condition;
            else if (!condition.truth())
                out = std::move(otherwise);
        }
        return out;
    }
    CuraValue either() {
        CuraValue out = both();
        while (take("or")) {
            CuraValue further = both();
            if (out.known() && !out.truth()) out = std::move(further);
        }
        return out;
    }
    CuraValue both() {
        CuraValue out = inverse();
        while (take("and")) {
            CuraValue further = inverse();
            if (out.known() && out.truth()) out = std::move(further);
        }
        return out;
    }
    CuraValue inverse() {
        if (!take("not")) return comparison();
        CuraValue out = deeper(&Formula::inverse);
        return out.known() ? CuraValue{!out.truth()} : out;
    }

    // Python takes a < b < c as a < b and b < c.
    CuraValue comparison() {
        CuraValue left = sum();
        std::optional<CuraValue> out;
        for (;;) {
            const std::string_view sign = comparing();
            if (sign.empty()) return out ? *out : left;
            CuraValue right = sum();
            CuraValue holds = compared(sign, left, right);
            if (!out || (out->known() && out->truth())) out = std::move(holds);
            left = std::move(right);
        }
    }
    std::string_view comparing() {
        if (const auto sign = take_one({"==", "!=", "<=", ">=", "<", ">", "in"}); !sign.empty()) return sign;
        const std::size_t before = at_;
        if (take("not") && take("in")) return "not in";
        at_ = before;
        return "";
    }
    CuraValue sum() {
        CuraValue out = product();
        for (auto with = take_one({"+", "-"}); !with.empty(); with = take_one({"+", "-"}))
            out = arithmetic(with, out, product());
        return out;
    }
    CuraValue product() {
        CuraValue out = sign();
        const auto next_sign = [&] { return take_one({"*", "//", "/", "%"}); };
        for (auto with = next_sign(); !with.empty(); with = next_sign()) out = arithmetic(with, out, sign());
        return out;
    }
    CuraValue sign() {
        const std::string_view leading = take_one({"-", "+"});
        if (leading.empty()) return power();
        return arithmetic(leading, CuraValue{0.0}, deeper(&Formula::sign));
    }
    CuraValue power() {
        CuraValue base = primary();
        return take("**") ? arithmetic("**", base, deeper(&Formula::sign)) : base;
    }

    CuraValue primary() {
        blanks();
        if (take("(")) {
            CuraValue out = choice();
            need(")");
            return out;
        }
        if (take("[")) return {values_up_to("]")};
        if (next() == '\'' || next() == '"') return quoted();
        if (std::isdigit(static_cast<unsigned char>(next())) != 0 || next() == '.') return number();
        return named();
    }

    List values_up_to(std::string_view end) {
        List out;
        std::size_t size = 0;
        while (!take(end)) {
            if (!out.empty()) need(",");
            if (take(end)) break; // behind a last comma
            out.push_back(choice());
            size += size_of(out.back());
            if (size > kLargestValue) throw SyntaxFault{"a list is too long"};
        }
        return out;
    }

    CuraValue quoted() {
        const char quote = next();
        std::string out;
        for (++at_; next() != quote; ++at_) {
            if (at_ >= text_.size()) fault();
            if (next() != '\\') {
                out += next();
                continue;
            }
            ++at_;
            constexpr std::string_view kLetters = "nt\\'\"", kMeant = "\n\t\\'\"";
            const auto which = kLetters.find(next());
            if (at_ >= text_.size() || which == std::string_view::npos) fault();
            out += kMeant[which];
        }
        ++at_;
        return {std::move(out)};
    }
    CuraValue number() {
        std::size_t end = at_;
        while (end < text_.size() &&
               (letter(text_[end]) || text_[end] == '.' ||
                ((text_[end] == '-' || text_[end] == '+') && std::tolower(text_[end - 1]) == 'e')))
            ++end;
        const auto value = plain_number(text_.substr(at_, end - at_));
        if (!value) fault();
        at_ = end;
        return {*value};
    }

    CuraValue named() {
        std::size_t end = at_;
        while (end < text_.size() && (letter(text_[end]) || (text_[end] == '.' && end > at_))) ++end;
        const std::string name(text_.substr(at_, end - at_));
        if (name.empty() || name == "if" || name == "else" || name == "for" || name == "lambda") fault();
        at_ = end;
        if (take("(")) return call(name, values_up_to(")"));
        if (name == "True" || name == "False") return {name == "True"};
        if (name == "math.pi") return {std::numbers::pi};
        return setting_(name);
    }

    // Cura's own functions; one extruder prints.
    CuraValue call(const std::string& name, const List& arguments) {
        const std::size_t count = arguments.size();
        const auto* key = count > 0 ? std::get_if<std::string>(&arguments.back().as) : nullptr;
        if (key != nullptr && count == 1 && name == "resolveOrValue") return setting_(*key);
        if (key != nullptr && count == 2 && name == "extruderValue") return setting_(*key);
        if (key != nullptr && count == 1 && name == "extruderValues") return {List{setting_(*key)}};
        if (count == 0 && name == "defaultExtruderPosition") return {std::string("0")};
        return python_function(name, arguments);
    }

    std::string_view text_;
    const std::function<CuraValue(const std::string&)>& setting_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

} // namespace

CuraValue calculated(std::string_view formula, const std::function<CuraValue(const std::string&)>& setting) {
    try {
        return Formula(formula, setting).all();
    } catch (const SyntaxFault& fault) {
        return {MissingValue{fault.why}};
    }
}

} // namespace filum::app::filum
