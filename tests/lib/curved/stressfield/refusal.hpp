// What a reader says to a text that it cannot use.
#pragma once

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace filum::stressfield {

// The words with which `read` refuses `text`, by the exit code expected.
template <class Read>
std::string refusal(Exit exit, const std::string& text, const Read& read) {
    try {
        read();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), exit) << e.what();
        return e.what();
    }
    ADD_FAILURE() << "read: " << text;
    return "";
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The text with the first `what` in it replaced.
inline std::string with(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

} // namespace filum::stressfield
