// Strict reader of TOML documents: each key is read by its name and checked, and a key that nothing reads is an error.
// Private to lib/motion/machine; only this header's source includes the TOML library.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

class Document {
  public:
    // Parses `text`, then replaces or adds the keys of `set` ("a.b=1,c=2").  `file` and `kind` are for messages.
    Document(std::string_view text, const std::string& file, const std::string& set,
             const std::string& kind = "profile");
    ~Document();

    // Adds the keys of another text that the document lacks, section by section.  `set` still wins.
    void add_base(std::string_view text, const std::string& file);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    struct Range {
        double min = -1e9, max = 1e9;
        bool open = false; // min itself is not allowed
    };
    // Each function leaves `out` unchanged if the key is missing.  `key` is dotted: "feeds.bead", "tool.1.feeds.bead".
    void number(const std::string& key, double& out, Range range);
    void whole(const std::string& key, int& out, int min, int max);
    void flag(const std::string& key, bool& out);
    void text(const std::string& key, std::string& out);
    void choice(const std::string& key, std::string& out, const std::vector<std::string>& choices);
    void pair(const std::string& key, double& a, double& b, Range range);         // [a, b]
    bool list(const std::string& key, std::span<double> out, Range range);        // fills `out`; is it there?
    void numbers(const std::string& section, std::map<std::string, double>& out); // a table with any names
    // Reads a table with any names, each with a text or a list of texts.
    void texts(const std::string& section, std::map<std::string, std::vector<std::string>, std::less<>>& out);
    void uses(const std::string& text) const; // names in braces in `text` count as used, see finish()

    // The names of the sections within a section, sorted; empty if it is missing.
    [[nodiscard]] std::vector<std::string> tables(const std::string& section) const;

    // From enter() to leave() every key is read within that section, and require() does nothing.
    void enter(const std::string& section);
    void leave();

    [[nodiscard]] bool has(const std::string& key) const;
    void require(const std::string& key) const;
    // Throws Error(bad_input) for the first key, in the file's order, that nothing read.  Then it throws for the first
    // name of numbers() that is in braces in no text.
    void finish() const;

    // Throws Error(bad_input): the value of `key` cannot be used. If the text lacks the key and has a name that nothing
    // has read and that is nearly its name, the message asks about it.
    [[noreturn]] void fail(const std::string& key, const std::string& why) const;
    // Throws Error(bad_input) for a fault on line `line`, counted from 0, of the text of `key`.
    [[noreturn]] void fail_in_text(const std::string& key, const std::string& why, std::size_t line) const;

  private:
    void check_names() const;
    struct State;
    std::unique_ptr<State> state_;
};

inline constexpr double kInf = std::numeric_limits<double>::infinity();

// A positive number not above `max`.
inline Document::Range above_zero(double max) { return {0, max, true}; }

} // namespace filum::machine
