#include "cli/agree.hpp"

#include <algorithm>

namespace filum::cli {

namespace {

const stream::Run* last_run(const std::vector<stream::Run>& history, const std::string& program) {
    for (std::size_t i = history.size(); i-- > 1;) // without this run, the last one
        if (history[i - 1].program == program) return &history[i - 1];
    return nullptr;
}

std::string spoken(const stream::Setting* s) { return s == nullptr ? "not given" : s->value; }

bool differ(const stream::Setting* a, const stream::Setting* b) {
    if (a != nullptr && b != nullptr) return a->value != b->value;
    return (a != nullptr && a->changed) || (b != nullptr && b->changed);
}

} // namespace

const stream::Setting* setting(const stream::Run& run, std::string_view name) {
    const auto at = std::ranges::find(run.settings, name, &stream::Setting::name);
    return at == run.settings.end() ? nullptr : &*at;
}

Notes disagreements(const Io& io, const stream::Header& header) {
    Notes out;
    if (header.history.empty()) return out;
    for (const Io::Same& same : io.same) {
        const stream::Setting* own = setting(header.history.back(), same.name);
        for (const std::string& as : same.as) {
            const auto dot = as.find('.');
            const std::string program = as.substr(0, dot), name = as.substr(dot + 1);
            const stream::Run* run = last_run(header.history, program);
            if (run == nullptr || !differ(own, setting(*run, name))) continue;
            out.push_back({.code = NoteCode::setting_differs,
                           .detail = "--" + same.name + " is " + spoken(own) + ", but '" + program + "' had --" + name +
                                     " " + spoken(setting(*run, name))});
        }
    }
    return out;
}

} // namespace filum::cli
