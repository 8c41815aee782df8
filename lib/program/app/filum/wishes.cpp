#include "app/filum/wishes.hpp"

#include <algorithm>
#include <iterator>

namespace filum::app::filum {

namespace {

constexpr const char* kVase = "vase"; // it replaces `skins`

bool has(const Stage& stage, const std::string& name) {
    return std::any_of(stage.options.begin(), stage.options.end(),
                       [&](const StageOption& o) { return o.name == name; });
}

std::string option_in(const std::string& word) {
    return word.starts_with("--") ? word.substr(2, word.find('=') - 2) : "";
}

// Whether one of the words names the stage, such as --skins.walls=3.
bool named(const std::vector<std::string>& words, const Stage& stage) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return word.starts_with("--" + stage.name + ".") || word.starts_with("--stage=" + stage.name + "=") ||
               word.starts_with(stage.name + "=");
    });
}

// Whether the stage has the option and no other stage has it.  Options of `vase` do not count, since it shares them
// with `skins`.
bool only_in(const Stage& stage, const std::string& name, const std::vector<Stage>& stages) {
    return has(stage, name) && std::none_of(stages.begin(), stages.end(), [&](const Stage& other) {
               return other.name != stage.name && other.name != kVase && has(other, name);
           });
}

bool wished(const std::vector<std::string>& words, const std::vector<Stage>& stages, const Stage& stage) {
    return named(words, stage) || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
               return only_in(stage, option_in(word), stages);
           });
}

} // namespace

bool by_wish(const Stage& stage) {
    return std::find(std::begin(kByWish), std::end(kByWish), stage.name) != std::end(kByWish);
}

std::vector<std::string> keep_wished(const std::vector<std::string>& words, Request& request,
                                     std::vector<Stage>& stages) {
    const std::vector<Stage> all = stages;
    const Request given = request;
    const auto vase = std::find_if(all.begin(), all.end(), [](const Stage& s) { return s.name == kVase; });
    const bool as_vase = vase != all.end() && (request.vase || named(words, *vase));
    std::vector<std::string> idle;
    stages.clear();
    request.arguments.clear();
    for (std::size_t s = 0; s < all.size(); ++s) {
        if (all[s].name == kVase && !as_vase) continue;
        if (all[s].name == "skins" && as_vase) {
            for (const std::string& word : words) {
                const std::string name = option_in(word);
                if (only_in(all[s], name, all) && !has(*vase, name)) idle.push_back("--" + name);
            }
            continue;
        }
        if (all[s].name != kVase && by_wish(all[s]) && !wished(words, all, all[s])) continue;
        stages.push_back(all[s]);
        request.arguments.push_back(given.arguments[s]);
    }
    return idle;
}

} // namespace filum::app::filum
