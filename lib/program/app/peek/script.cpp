#include "app/peek/text.hpp"
#include "base/shell.hpp"

namespace filum::app::peek {

namespace {

// A setting with '_' in its name is not an option but a mark of the input, such as its checksum.
bool is_option(const stream::Setting& s) { return s.name.find('_') == std::string::npos; }

// The commands that lead to run `i`.  A run that reads several streams gets each by a process substitution.
std::string pipeline(const stream::Header& header, std::size_t i, bool defaults) {
    const auto& run = header.history[i];
    std::string self = shell_word(run.program);
    for (const auto& s : run.settings)
        if (is_option(s) && (s.changed || (defaults && !s.value.empty())))
            self += " " + shell_word("--" + s.name + "=" + s.value);
    if (run.parents.empty()) return self + " \"$1\"";
    if (run.parents.size() == 1) return pipeline(header, run.parents[0], defaults) + " |\n    " + self;
    for (const auto parent : run.parents) self += " <(" + pipeline(header, parent, defaults) + ")";
    return self;
}

} // namespace

std::string script(const stream::Header& header, bool defaults) {
    std::string out = "#!/bin/bash\nset -euo pipefail\n";
    if (header.history.empty()) return out + "# the stream tells no history\n";
    return out + pipeline(header, header.history.size() - 1, defaults) + "\n";
}

} // namespace filum::app::peek
