// Templates of G-code as trees.
#pragma once

#include "macro/regex.hpp"
#include "macro/value.hpp"

#include <memory>
#include <string>
#include <vector>

namespace filum::macro {

enum class Operator : std::uint8_t {
    add,
    subtract,
    multiply,
    divide,
    remainder, // numbers; add also joins texts
    equal,
    unequal,
    below,
    above,
    at_most,
    at_least,
    both,
    either,
    negate,
    no, // and, or, -, not
};

enum class Function : std::uint8_t {
    min,
    max,
    random,
    digits,
    zdigits,
    integer,
    round,
    floor,
    ceil,
    absolute,
    is_nil,
    empty,
    size,
    one_of,
    interpolate,
    exists,
    otherwise, // default_float(name, value) and similar functions
};

struct Expression {
    enum class Kind : std::uint8_t { literal, variable, item, unary, binary, choice, match, call } kind = Kind::literal;
    Value value{};                        // of a literal
    std::string name{};                   // of a variable, or of one of its items
    Operator op = Operator::add;          // of unary and binary expressions, and of a match: unequal inverts it
    Function function = Function::min;    // of a call
    std::shared_ptr<const Regex> regex{}; // of a match, and of an argument of one_of
    std::vector<Expression> parts{};      // operands; arguments; condition, then, else; index of an item
    std::size_t at = 0;                   // its offset in the template, bytes
};

struct TemplateNode;
using Block = std::vector<TemplateNode>;

struct Assignment {
    enum class Scope : std::uint8_t { known, local, global } scope = Scope::known;
    std::string name{};
    std::vector<Expression> index{};   // empty, or one index
    bool list = false, repeat = false; // (a, b, c); repeat(count, value)
    std::vector<Expression> values{};
};

struct Branch {
    std::vector<Expression> conditions{}; // one for each block; the block of `else` has none
    std::vector<Block> blocks{};
};

struct TemplateNode {
    enum class Kind : std::uint8_t { text, expression, bracket, branch, assignment } kind = Kind::text;
    std::string text{}; // the text; of a bracket, its name
    Expression expression{};
    std::string index{}; // of a bracket with an index: the variable that holds the index
    Branch branch{};
    Assignment assignment{};
    std::size_t at = 0;
};

// The dialects of templates.
enum class Style : std::uint8_t {
    slicer, // {expression} and [name]
    own,    // of machine profiles: {expression}; {{ and }} are braces, [ is plain text
};

// A fault of a template; line and column count from 1.
struct Fault {
    std::string why{};
    std::size_t line = 1, column = 1;
};

} // namespace filum::macro
