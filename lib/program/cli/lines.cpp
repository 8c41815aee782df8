#include "cli/lines.hpp"

#include <algorithm>
#include <sys/ioctl.h>
#include <unistd.h>

namespace filum::cli {

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
    std::string out, line;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        const std::string word = text.substr(at, end - at);
        if (!line.empty() && line.size() + 1 + word.size() + indent > width) {
            out += line + "\n" + std::string(indent, ' ');
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
        if (end < text.size() && text[end] == '\n') {
            out += line + "\n" + std::string(indent, ' ');
            line.clear();
        }
        at = end + 1;
    }
    return out + line;
}

std::string for_terminal(const std::string& line) {
    constexpr std::size_t kIndent = 4, kNarrowest = 40; // characters
    winsize size{};
    if (::isatty(STDERR_FILENO) == 0 || ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < kNarrowest)
        return line;
    return wrapped(line, kIndent, size.ws_col);
}

} // namespace filum::cli
