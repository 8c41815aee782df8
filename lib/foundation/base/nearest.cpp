#include "base/nearest.hpp"

#include <algorithm>
#include <vector>

namespace filum {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> two(b.size() + 1), one(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) one[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = a[i - 1] == b[j - 1];
            now[j] = std::min({one[j] + 1, now[j - 1] + 1, one[j - 1] + (same ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) now[j] = std::min(now[j], two[j - 2] + 1);
        }
        two.swap(one);
        one.swap(now);
    }
    return one[b.size()];
}

namespace {

// The name that contains `word` or is contained in it, if there is exactly one such name; else "". Shorter than three
// letters: not compared.
std::string only_with_part(std::string_view word, std::span<const std::string> names) {
    constexpr std::size_t kLeast = 3;
    std::string out;
    for (const std::string& name : names) {
        if (word.size() < kLeast || name.size() < kLeast) continue;
        if (name.find(word) == std::string::npos && word.find(name) == std::string_view::npos) continue;
        if (!out.empty()) return "";
        out = name;
    }
    return out;
}

} // namespace

std::string nearest(std::string_view word, std::span<const std::string> names) {
    constexpr std::size_t kLongest = 64; // longer words are not compared, which bounds the cost
    if (word.size() > kLongest) return "";
    const std::string* best = nullptr;
    std::size_t least = 0;
    for (const std::string& name : names) {
        if (name.size() > kLongest) continue;
        const std::size_t far = edit_distance(word, name);
        if (3 * far > std::max(word.size(), name.size()) || (best != nullptr && far >= least)) continue;
        best = &name;
        least = far;
    }
    return best != nullptr ? *best : only_with_part(word, names);
}

std::string did_you_mean(std::string_view word, std::span<const std::string> names, const std::string& before) {
    const std::string name = nearest(word, names);
    return name.empty() ? "" : "; did you mean '" + before + name + "'?";
}

} // namespace filum
