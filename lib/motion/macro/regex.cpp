#include "macro/regex.hpp"

#include <re2/re2.h>

#include <stdexcept>

namespace filum::macro {

namespace {

re2::RE2::Options options() {
    re2::RE2::Options out(re2::RE2::Latin1);
    out.set_dot_nl(true);
    out.set_never_capture(true);
    out.set_log_errors(false);
    return out;
}

re2::StringPiece piece(std::string_view text) { return {text.data(), text.size()}; }

} // namespace

Regex::Regex(std::string_view pattern) : pattern_(std::make_shared<const re2::RE2>(piece(pattern), options())) {
    if (!pattern_->ok()) throw std::invalid_argument(pattern_->error());
}

bool Regex::matches(std::string_view text) const { return re2::RE2::FullMatch(piece(text), *pattern_); }

} // namespace filum::macro
