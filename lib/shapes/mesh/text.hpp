// A cursor over text, for the readers of text formats; private to lib/shapes/mesh.
#pragma once

#include "base/error.hpp"

#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>

namespace filum::mesh {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
// Lines end with LF, with CR LF, or with CR alone as on old Macintosh systems.
inline bool is_line_end(char c) { return c == '\n' || c == '\r'; }
inline char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

// True if `text` begins with the lower-case `word`, in any case.
inline bool begins_with(std::string_view text, std::string_view word) {
    if (text.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (lower(text[i]) != word[i]) return false;
    return true;
}

struct Text {
    const char* at;
    const char* end;
    const char* begin;
    char comment; // starts a comment up to the end of the line; '\0': no comments

    explicit Text(std::string_view t, char comment_mark = '\0')
        : at(t.data()), end(t.data() + t.size()), begin(t.data()), comment(comment_mark) {
        if (t.starts_with("\xef\xbb\xbf")) at += 3; // byte order mark
    }

    // The number of the cursor's line, from 1.  Counts from the start each time, so it is only for messages.
    [[nodiscard]] std::size_t line() const {
        std::size_t n = 1;
        for (const char* p = begin; p < at; ++p) n += *p == '\n' || (*p == '\r' && (p + 1 == end || p[1] != '\n'));
        return n;
    }
    // Moves to the end of the line, not beyond it.
    void skip_line() {
        while (at < end && !is_line_end(*at)) ++at;
    }
    // Skips blanks and a comment.  True if something is left on this line.
    bool more_on_line() {
        while (at < end && is_blank(*at)) ++at;
        if (at < end && comment != '\0' && *at == comment) skip_line();
        return at < end && !is_line_end(*at);
    }
    // Skips one line end, if the cursor is at one.
    void pass_line_end() {
        if (at < end && *at == '\r' && at + 1 < end && at[1] == '\n') ++at;
        if (at < end && is_line_end(*at)) ++at;
    }
    // Skips blanks, comments and line ends.  True if something is left.
    bool more() {
        while (!more_on_line()) {
            if (at == end) return false;
            ++at;
        }
        return true;
    }
    // True if only blanks precede the cursor on its line.
    [[nodiscard]] bool begins_line() const {
        const char* p = at;
        while (p > begin && is_blank(p[-1])) --p;
        return p == begin || is_line_end(p[-1]);
    }
    // The next word of this line, "" if there is none.
    std::string_view word() {
        if (!more_on_line()) return {};
        const char* from = at;
        while (at < end && !is_blank(*at) && !is_line_end(*at)) ++at;
        return {from, static_cast<std::size_t>(at - from)};
    }
    // Reads a number at the cursor.  Returns false, and does not move, if there is none.  "nan" and "inf" are numbers.
    bool number(double& value) {
        const char* from = at;
        if (from < end && *from == '+') ++from;
        const auto [stop, error] = std::from_chars(from, end, value);
        if (error == std::errc::result_out_of_range)
            value = std::strtod(std::string(from, stop).c_str(), nullptr);
        else if (error != std::errc())
            return false;
        at = stop;
        return true;
    }
    bool whole(long long& value) {
        const char* from = at;
        if (from < end && *from == '+') ++from;
        const auto [stop, error] = std::from_chars(from, end, value);
        if (error != std::errc()) return false;
        at = stop;
        return true;
    }
};

// Throws Error(bad_input) with the file, the cursor's line and the fault.
[[noreturn]] inline void malformed_line(const std::string& name, const Text& text, const std::string& why) {
    throw Error(Exit::bad_input, "cannot read " + name + ": line " + std::to_string(text.line()) + ": " + why);
}

} // namespace filum::mesh
