// A cursor over the characters and words of a template.
#pragma once

#include "macro/parser.hpp"

#include <string>
#include <string_view>

namespace filum::macro {

class Cursor {
  public:
    explicit Cursor(std::string_view text) : text_(text) {}

    [[nodiscard]] bool done() const { return at_ == text_.size(); }
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    [[nodiscard]] std::string_view text() const { return text_; }
    void move(std::size_t to) { at_ = to; }
    void step(std::size_t by = 1) { at_ += by; }

    void blanks();                          // skips blanks
    bool take(std::string_view sign);       // skips blanks, then `sign`; false if it does not follow
    void need(char sign, const char* what); // throws FaultAt: "a ')' is missing: what"
    bool take_word(std::string_view word);  // the same for a whole word
    [[nodiscard]] std::string peek_name();  // the next name or keyword, or ""
    std::string name(const char* what);     // takes a name that is not a keyword; throws FaultAt
    [[noreturn]] void fail(const std::string& why) const { throw FaultAt{why, at_}; }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

bool is_keyword(std::string_view word);

} // namespace filum::macro
