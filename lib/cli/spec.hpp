// What a command says about itself, as data.  Help, man page, completion, docs and contract tests come from it.
#pragma once

#include "stream/frame.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace filum::cli {

// A field that is an enum, its values numbered as the option's choices are.
struct Enumerated {
    void* field;
    void (*set)(void* field, std::size_t choice);
    std::size_t (*choice)(const void* field);

    template <class E>
    requires std::is_enum_v<E> Enumerated(E* of) // NOLINT(google-explicit-constructor): &o.field says it all
        : field(of), set([](void* f, std::size_t k) { *static_cast<E*>(f) = static_cast<E>(k); }),
          choice([](const void* f) { return static_cast<std::size_t>(*static_cast<const E*>(f)); }) {}
};

// One option: `--name VALUE`, bound to a field of the command's Options.
struct Option {
    using Target = std::variant<double*, std::int64_t*, bool*, std::string*, std::vector<double>*, Enumerated>;
    std::string name; // without the dashes
    Target target;
    std::string unit; // "mm", "deg", "FILE"; shown as the value's name
    std::string help; // one sentence, lower case, no full stop
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool open_min = false;                 // min itself is not allowed
    bool zero = false;                     // 0 is, though below min
    std::vector<std::string> choices = {}; // for texts, and for enums in their order
    std::size_t count = 0;                 // for lists: how many numbers exactly, 0 for any
    bool setting = true;                   // false for files and whatever must not enter the history
    std::string needs = "";                // what other options it needs to have an effect: see when()
    std::vector<std::string> same = {};    // settings of stages before, PROGRAM.NAME, that should have its value
    bool limit = false;                    // acts only where the input reaches it: nothing may change, rightly

    Option& at_least(double v) {
        min = v;
        return *this;
    }
    Option& above(double v) {
        min = v;
        open_min = true;
        return *this;
    }
    Option& zero_or_at_least(double v) {
        min = v;
        zero = true;
        return *this;
    }
    Option& at_most(double v) {
        max = v;
        return *this;
    }
    Option& within(double from, double to) {
        min = from;
        max = to;
        return *this;
    }
    Option& one_of(std::vector<std::string> c) {
        choices = std::move(c);
        return *this;
    }
    template <std::size_t N>
    Option& one_of(const std::array<const char*, N>& names) {
        return one_of(std::vector<std::string>(names.begin(), names.end()));
    }
    Option& numbers(std::size_t n) {
        count = n;
        return *this;
    }
    Option& not_a_setting() {
        setting = false;
        return *this;
    }
    // Where it has an effect: given elsewhere, not at its default, it is an error.  Conditions with blanks between, all
    // of which must hold: "pattern=spiral|zigzag", the other option has one of these values; "surface", it is not at
    // its default; with '/' one of several; with '!' in front none of them.  As "method=cyc !surface/regions".
    Option& when(const std::string& condition) {
        needs += (needs.empty() ? "" : " ") + condition;
        return *this;
    }
    // A stage before that was told otherwise is told of in a warning and a note.
    Option& same_as(std::vector<std::string> settings) {
        same = std::move(settings);
        return *this;
    }
    Option& a_limit() {
        limit = true;
        return *this;
    }
};

// Options under one more condition.
std::vector<Option> when(const std::string& condition, std::vector<Option> options);

// Options that stand together in help and pages, by name, under a heading: a noun, as "support" or "rows and strands".
struct Group {
    std::string heading;
    std::vector<std::string> options;
};

struct Example {
    std::string command; // shell text, run by the tests in a folder that holds part.stl; must exit 0
    std::string says;    // what it does
};

// The shape of a command's input or output.
struct Port {
    enum class Kind : std::uint8_t { none, file, stream, text };
    Kind kind = Kind::none;
    stream::Payload payload = stream::Payload::unknown; // for streams; unknown: any
    std::string text;                                   // how to name it: "mesh file", "Regions"
};
Port reads(stream::Payload p);
Port writes(stream::Payload p);
Port file(std::string text); // an input file in a foreign format, or standard input
Port text(std::string text); // readable text
Port nothing();

struct Spec {
    std::string name;
    std::string synopsis;    // one line: what it does
    std::string description; // paragraphs, separated by empty lines
    Port in, out;
    std::string memory; // what it keeps in memory at once: "two layers"
    std::vector<Option> options;
    std::vector<Group> groups = {}; // of options, in the order of the help; those in none come first
    std::vector<Example> examples;
    std::vector<std::string> see_also = {};
    std::string arguments = "[INPUT]"; // how the usage line names what is no option
    bool many_inputs = false;          // takes any number of positional arguments
    std::string leading = "";          // an option one of whose choices may come first, without its name
    struct Page {
        std::string name; // --print-NAME
        std::string (*text)();
    };
    std::vector<Page> pages = {}; // more that it can say about itself, for scripts/generate-docs
};

} // namespace filum::cli
