// Lines with fixed columns, as FORTRAN writes them; private to lib/curved/stressfield.
#pragma once

#include <cstddef>
#include <string_view>

namespace filum::stressfield {

// The columns [from, from + width) of a line, or fewer at its end.
inline std::string_view columns(std::string_view line, std::size_t from, std::size_t width) {
    return from < line.size() ? line.substr(from, width) : std::string_view{};
}

// The whole number in `field`, between blanks; false if there is none.
bool whole(std::string_view field, long long& value);

// The number in `field`, between blanks; the E before an exponent of three digits may be missing; "nan" and "inf" are
// accepted.
bool number(std::string_view field, double& value);

// `count` numbers of twelve columns each from column `from`, without separators. A negative number with three digits
// of exponent needs thirteen columns and shifts the rest; then numbers are separated by their form: one digit, a
// point, five digits, an exponent. False if they are missing.
bool numbers(std::string_view line, std::size_t from, std::size_t count, double* values);

// A cursor over lines, which end with "\n" or "\r\n".
class Lines {
  public:
    explicit Lines(std::string_view text) : text_(text) {}
    // The next line without line end and blanks before it; false if there is none.
    bool next(std::string_view& line) {
        if (at_ == text_.size()) return false;
        std::size_t end = text_.find('\n', at_);
        ended_ = end != std::string_view::npos;
        if (!ended_) end = text_.size();
        last_ = at_;
        at_ = end + (ended_ ? 1 : 0);
        while (end > last_ && (text_[end - 1] == '\r' || text_[end - 1] == ' ')) --end;
        line = text_.substr(last_, end - last_);
        return true;
    }
    // Moves before the next line that begins with `word`; if there is none, to the end, and returns false.
    bool seek(std::string_view word);
    [[nodiscard]] bool ended() const { return ended_; } // the last line had an end
    [[nodiscard]] std::size_t left() const { return text_.size() - at_; }
    [[nodiscard]] std::size_t line() const; // number of the last line, from 1; counts from the start

  private:
    std::string_view text_;
    std::size_t at_ = 0, last_ = 0;
    bool ended_ = true;
};

} // namespace filum::stressfield
