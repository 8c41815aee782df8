// Evaluates expressions.
#pragma once

#include "macro/macro.hpp"
#include "macro/parser.hpp"

namespace filum::macro {

// The variables of one template during its expansion.
struct Variables {
    Scope* scope = nullptr;
    std::map<std::string, Variable, std::less<>> locals{};

    // Throws FaultAt for an unknown name.
    [[nodiscard]] const Variable& at(const std::string& name, std::size_t place) const;
    [[nodiscard]] const Variable* find(std::string_view name) const;
};

// The value of an expression.  Throws FaultAt.
Value evaluate(const Expression& e, const Variables& variables);

// The value of a condition.  Throws FaultAt if it is not true or false.
bool holds(const Expression& e, const Variables& variables);

// The value of an index.  Throws FaultAt if it is not a whole number, or below 0.
std::size_t index_of(const Expression& e, const Variables& variables);

// An item of a list.  An index beyond its end gives the first item, as in slicers.
const Value& item(const Variable& list, std::size_t index, const std::string& name, std::size_t place);

Value call(const Expression& e, const Variables& variables);
double number_of(const Value& value, std::size_t place);

} // namespace filum::macro
