#include "postproc/digits.hpp"

#include "base/printable.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

// True if LinuxCNC executes a comment with this text: comments can open files and run Python.  Blanks between letters
// are skipped, as in the interpreter that LinuxCNC is derived from.
bool is_active(std::string_view text) {
    constexpr std::string_view kWords[] = {"msg,",       "debug,",   "print,",    "log,",       "logopen,",
                                           "logappend,", "logclose", "probeopen", "probeclose", "py,",
                                           "pyrun",      "pyreload", "abort,"};
    std::string start;
    for (const char c : text) {
        if (start.size() > 12) break; // longer than any of the words
        if (c != ' ' && c != '\t') start += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return std::any_of(std::begin(kWords), std::end(kWords), [&](std::string_view w) { return start.starts_with(w); });
}

} // namespace

void append_comment(std::string& out, std::string_view text, machine::CommentStyle style) {
    const bool round = style == machine::CommentStyle::parentheses;
    const char begin[] = {';', '(', '!', '#'};
    out += begin[static_cast<std::size_t>(style)];
    if (is_active(text)) out += '-'; // now LinuxCNC does not execute it
    std::string shown = printable(text);
    if (round) {
        std::replace(shown.begin(), shown.end(), '(', '[');
        std::replace(shown.begin(), shown.end(), ')', ']');
        shown += ')';
    }
    out += shown;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::string_view indent) {
    std::vector<std::string> lines;
    std::string lead;
    while (lead.size() + text.size() > width) {
        const std::size_t room = width - lead.size();
        std::size_t cut = text.rfind(' ', room);
        if (cut == std::string_view::npos || cut == 0) cut = room; // a word longer than a line
        lines.push_back(lead + std::string(text.substr(0, cut)));
        text.remove_prefix(std::min(text.size(), text[cut] == ' ' ? cut + 1 : cut));
        lead = indent;
    }
    lines.push_back(lead + std::string(text));
    return lines;
}

std::string duration(double seconds) {
    auto left = static_cast<std::int64_t>(std::ceil(std::min(seconds, 1e15)));
    std::string out;
    constexpr std::int64_t sizes[] = {86400, 3600, 60, 1};
    constexpr char names[] = {'d', 'h', 'm', 's'};
    for (int k = 0; k < 4; ++k) {
        const std::int64_t n = left / sizes[k];
        left %= sizes[k];
        if (n == 0 && out.empty() && k < 3) continue;
        out += (out.empty() ? "" : " ") + std::to_string(n) + names[k];
    }
    return out;
}

} // namespace filum::postproc
