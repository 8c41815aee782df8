// The description of a command as data. Help, man page, completion, docs and contract tests are made from it.
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

// A field of an enum type. Its values are numbered like the choices of the option.
struct EnumTarget {
    void* field;
    void (*set)(void* field, std::size_t choice);
    std::size_t (*choice)(const void* field);

    template <class E>
    requires std::is_enum_v<E> EnumTarget(E* of) // NOLINT(google-explicit-constructor): &o.field says it all
        : field(of), set([](void* f, std::size_t k) { *static_cast<E*>(f) = static_cast<E>(k); }),
          choice([](const void* f) { return static_cast<std::size_t>(*static_cast<const E*>(f)); }) {}
};

// One option: `--name VALUE`, bound to a field of the command's Options.
struct Option {
    using Target = std::variant<double*, std::int64_t*, bool*, std::string*, std::vector<double>*, EnumTarget>;
    std::string name; // without the dashes
    Target target;
    std::string unit; // "mm", "deg", "FILE"; shown as the value's name
    std::string help; // one sentence, lower case, no full stop
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool open_min = false;                 // min itself is not allowed
    bool zero = false;                     // 0 is allowed, although it is below min
    std::vector<std::string> choices = {}; // the values allowed: of texts, or of enums in their order
    std::size_t count = 0;                 // for lists: the exact number of numbers, 0 for any
    bool setting = true;                   // false for files and other values that do not belong into the history
    std::string needs = "";                // the conditions on other options under which it has an effect: see when()
    std::vector<std::string> same = {};    // settings of earlier stages, PROGRAM.NAME, that should have the same value
    bool repeats = false;                  // given several times, all values count: see repeated()
    bool limit = false;                    // a limit: it may rightly change nothing, if the input does not reach it

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
    // States the condition under which the option has an effect. Without it, giving the option a value other than its
    // default is an error. All conditions, separated by blanks, must hold. "pattern=spiral|zigzag": the other option
    // has one of these values. "surface": the other option is not at its default. '/' separates alternatives, and '!'
    // in front means that none of them holds. Example: "method=cyc !surface/regions".
    Option& when(const std::string& condition) {
        needs += (needs.empty() ? "" : " ") + condition;
        return *this;
    }
    // Names settings of earlier stages that should have the same value. If one differs, the program warns and adds a
    // note.
    Option& same_as(std::vector<std::string> settings) {
        same = std::move(settings);
        return *this;
    }
    // All uses of the option count. A list gets the numbers of each; a text gets the texts, with ';' between.
    Option& repeated() {
        repeats = true;
        return *this;
    }
    Option& a_limit() {
        limit = true;
        return *this;
    }
};

// `options` followed by `more`.
inline std::vector<Option> with(std::vector<Option> options, const std::vector<Option>& more) {
    options.insert(options.end(), more.begin(), more.end());
    return options;
}

// The options, each with one more condition.
std::vector<Option> when(const std::string& condition, std::vector<Option> options);

// Options, by name, that help and pages show under one heading. The heading is a noun: "support", "rows and strands".
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
    std::string text;                                   // its name in texts: "mesh file", "Regions"
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
    std::string memory; // what the command keeps in memory at once: "two layers"
    std::vector<Option> options;
    // The groups of options, in the order of the help; options without a group come first.
    std::vector<Group> groups = {};
    std::vector<Example> examples;
    std::vector<std::string> see_also = {};
    std::string arguments = "[INPUT]"; // how the usage line names positional arguments
    bool many_inputs = false;          // takes any number of positional arguments
    std::string leading = "";          // an option whose value may be given as first argument, without the name
    struct Page {
        std::string name; // --print-NAME
        std::string (*text)();
    };
    std::vector<Page> pages = {}; // more documents about the command, for scripts/generate-docs
};

} // namespace filum::cli
