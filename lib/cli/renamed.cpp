#include "cli/renamed.hpp"

#include <algorithm>
#include <utility>

namespace filum::cli {

std::string renamed(const std::string& old, const std::vector<std::string>& names, const std::string& prefix) {
    const auto known = [&](const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    constexpr std::pair<const char*, const char*> kRenamed[] = {{"least-radius", "min-radius"},
                                                                {"least-spacing", "min-spacing"},
                                                                {"least-area", "min-area"},
                                                                {"height", "layer-height"}};
    for (const auto& [before, now] : kRenamed)
        if (old == before && known(now) && !known(old)) return "; it is called '" + prefix + now + "' now";
    return "";
}

} // namespace filum::cli
