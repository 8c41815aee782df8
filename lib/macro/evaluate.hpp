// The value of expressions.
#pragma once

#include "macro/macro.hpp"
#include "macro/parser.hpp"

namespace filum::macro {

// The variables of one template while it is written.
struct Variables {
    Scope* scope = nullptr;
    std::map<std::string, Variable, std::less<>> locals{};

    // Throws FaultAt for an unknown name.
    [[nodiscard]] const Variable& at(const std::string& name, std::size_t place) const;
    [[nodiscard]] const Variable* find(std::string_view name) const;
};

// Throws FaultAt.
Value evaluate(const Expression& e, const Variables& variables);

// A condition's value; a value that is neither true nor false is a fault.
bool holds(const Expression& e, const Variables& variables);

// An index of a list: a whole number; below 0 is a fault.
std::size_t index_of(const Expression& e, const Variables& variables);

// An item of a list.  An index behind its end means the first item, as in slicers.
const Value& item(const Variable& list, std::size_t index, const std::string& name, std::size_t place);

Value call(const Expression& e, const Variables& variables);
double number_of(const Value& value, std::size_t place);

} // namespace filum::macro
