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
    remainder, // numbers; add joins texts
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
    otherwise, // default_float(name, value) and its like
};

struct Expression {
    enum class Kind : std::uint8_t { literal, variable, item, unary, binary, choice, match, call } kind = Kind::literal;
    Value value{};                        // of a literal
    std::string name{};                   // of a variable, or of one of its items
    Operator op = Operator::add;          // of unary and binary ones; unequal: a match that must not be
    Function function = Function::min;    // of a call
    std::shared_ptr<const Regex> regex{}; // of a match, and of an argument of one_of
    std::vector<Expression> parts{};      // operands, arguments; condition, then, else; the index of an item
    std::size_t at = 0;                   // where it begins in the template, bytes
};

struct Piece;
using Block = std::vector<Piece>;

struct Assignment {
    enum class Scope : std::uint8_t { known, local, global } scope = Scope::known;
    std::string name{};
    std::vector<Expression> index{};   // none, or one
    bool list = false, repeat = false; // (a, b, c); repeat(count, value)
    std::vector<Expression> values{};
};

struct Branch {
    std::vector<Expression> conditions{}; // one for each block; the block of `else` has none
    std::vector<Block> blocks{};
};

struct Piece {
    enum class Kind : std::uint8_t { text, expression, bracket, branch, assignment } kind = Kind::text;
    std::string text{}; // as it stands; of a bracket, the name
    Expression expression{};
    std::string index{}; // of a bracket with an index: the variable that holds it
    Branch branch{};
    Assignment assignment{};
    std::size_t at = 0;
};

// Which templates they are.
enum class Style : std::uint8_t {
    slicer, // {expression} and [name]
    own,    // of machine profiles: {expression}; {{ and }} are braces, [ is a bracket
};

// What is wrong with a template; counted from 1.
struct Fault {
    std::string why{};
    std::size_t line = 1, column = 1;
};

} // namespace filum::macro
