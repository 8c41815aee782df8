#include "app/filum/show_settings.hpp"

#include "app/filum/printers.hpp"
#include "app/filum/slicer_machine.hpp"
#include "app/filum/slicer_settings.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <utility>

namespace filum::app::filum {

namespace {

constexpr std::size_t kLongest = 40; // most characters of a value that are printed

std::string shown(const std::string& value) {
    const std::string text = printable(value);
    return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

std::string line(const ReadSetting& s) {
    std::string out = "  " + s.key + " = " + shown(s.value);
    out.resize(std::max<std::size_t>(out.size() + 2, 58), ' ');
    for (const std::string& word : s.words) out += word + " ";
    return out + s.why + "\n";
}

std::string report(const std::string& file) {
    const SlicerFile read = merged({slicer_file(file)}).front();
    const SlicerWishes all = wishes(read, [](std::string_view) { return true; });
    std::string out = printable(file) + ": " + std::to_string(all.settings.size()) + " settings, written by " +
                      name_of(read.slicer) + "\n";
    constexpr std::pair<Use, const char*> kGroups[] = {{Use::used, "used"},
                                                       {Use::harm, "not followed, and a print without it can go wrong"},
                                                       {Use::later, "not used yet"},
                                                       {Use::unknown, "not known"},
                                                       {Use::none, "without meaning here"}};
    for (const auto& [use, title] : kGroups) {
        const auto count = std::ranges::count(all.settings, use, &ReadSetting::use);
        if (count == 0) continue;
        out += "\n" + std::string(title) + " (" + std::to_string(count) + ")\n";
        for (const ReadSetting& s : all.settings)
            if (s.use == use) out += line(s);
    }
    for (const std::string& remark : all.remarks) out += "\nnote: " + remark;
    return out + (all.remarks.empty() ? "" : "\n");
}

// Prints the machine profile of the printer that the files describe.
int show_machine(const std::vector<std::string>& files) {
    PrinterNames names;
    std::vector<SlicerFile> read;
    for (const std::string& file : files)
        if (!names.take(file)) read.push_back(slicer_file(file));
    std::vector<SlicerFile> all = chosen_printer(names).settings;
    all.insert(all.end(), read.begin(), read.end());
    const std::string text = SlicerMachine(std::move(all), files).text();
    if (text.empty())
        throw Error(Exit::bad_input,
                    "cannot make a machine profile: the settings describe no printer; they have no start "
                    "G-code and no bed shape");
    stream::Sink to("-", stream::Sink::Content::text);
    to.write(text);
    to.commit();
    return 0;
}

} // namespace

int show_settings(const std::vector<std::string>& files) {
    if (files.empty()) throw Error(Exit::usage, "cannot show settings without a file; as in 'filum settings my.ini'");
    if (files.front() == "--machine") return show_machine({files.begin() + 1, files.end()});
    std::string out;
    for (const std::string& file : files) out += (out.empty() ? "" : "\n") + report(file);
    stream::Sink to("-", stream::Sink::Content::text);
    to.write(out);
    to.commit();
    return 0;
}

} // namespace filum::app::filum
