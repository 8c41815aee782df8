#include "fill/scaffold/formula.hpp"

#include "base/error.hpp"

#include <muParser.h>

#include <algorithm>
#include <mutex>
#include <numbers>

namespace filum::fill::scaffold {

struct Formula::Parsed {
    mu::Parser parser;
    std::vector<double> values; // of the variables; the parser reads them
    std::vector<char> used;     // per variable
    std::mutex mutex;
};

namespace {

// The place of an assignment, which muParser would carry out; the length of the text if there is none.
std::size_t assignment(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '=') continue;
        const bool compares = i > 0 && std::string("=!<>").find(text[i - 1]) != std::string::npos;
        const bool doubled = i + 1 < text.size() && text[i + 1] == '=';
        if (!compares && !doubled) return i;
    }
    return text.size();
}

} // namespace

Formula::Formula(const std::string& text, const std::vector<std::string>& variables, const std::string& what)
    : text_(text), parsed_(std::make_shared<Parsed>()) {
    const auto refuse = [&](const std::string& why, std::size_t at) {
        std::string names;
        for (const std::string& v : variables) names += (names.empty() ? "" : ", ") + v;
        throw Error(Exit::usage, "cannot use '" + text_ + "' for --" + what + ": " + why + " at character " +
                                     std::to_string(at + 1) + "; a formula has numbers, " + names +
                                     ", pi, + - * / ^, brackets, sqrt, abs, exp, sin, cos, min and max");
    };
    if (const std::size_t at = assignment(text); at < text.size()) refuse("'=' does not belong there", at);
    Parsed& p = *parsed_;
    p.values.resize(variables.size());
    try {
        p.parser.DefineConst("pi", std::numbers::pi);
        for (std::size_t i = 0; i < variables.size(); ++i) p.parser.DefineVar(variables[i], &p.values[i]);
        p.parser.SetExpr(text);
        const mu::varmap_type used = p.parser.GetUsedVar();
        for (const std::string& v : variables) p.used.push_back(used.contains(v) ? 1 : 0);
        static_cast<void>(p.parser.Eval());
    } catch (const mu::Parser::exception_type& e) {
        const std::size_t at = std::min(static_cast<std::size_t>(std::max(e.GetPos(), 0)), text.size());
        const bool named = at < text.size() && !e.GetToken().empty();
        refuse(named ? "'" + e.GetToken() + "' does not belong there" : "something is missing", at);
    }
    if (p.parser.GetNumResults() != 1) refuse("',' does not belong there", text.find(','));
}

bool Formula::uses(std::size_t variable) const { return parsed_->used[variable] != 0; }

double Formula::operator()(std::span<const double> variables) const {
    const std::lock_guard lock(parsed_->mutex);
    std::copy(variables.begin(), variables.end(), parsed_->values.begin());
    return parsed_->parser.Eval();
}

} // namespace filum::fill::scaffold
