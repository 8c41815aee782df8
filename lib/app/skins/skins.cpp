#include "app/skins/skins.hpp"

#include "app/modifier/modifier.hpp"
#include "base/error.hpp"
#include "cli/output.hpp"
#include "wire/planar.hpp"

namespace filum::app::skins {

namespace {

using filum::skins::Modifier;
using polygon::Region;

// FILE:SETTINGS, both as they stand; the last colon counts, as files may have one in their names.
struct Asked {
    std::string file, settings;
};

std::vector<Asked> asked(const std::string& text) {
    std::vector<Asked> out;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(';', from), text.size());
        const std::string one = text.substr(from, end - from);
        const std::size_t colon = one.rfind(':');
        if (colon == std::string::npos || colon == 0 || colon + 1 == one.size())
            throw Error(Exit::usage,
                        "cannot use '" + one + "' as --modifier: it is FILE:SETTINGS, as knob.stl:infill=40%");
        out.push_back({one.substr(0, colon), one.substr(colon + 1)});
        from = end + 1;
    }
    return out;
}

std::vector<Modifier> read_modifiers(const std::vector<Asked>& all, const filum::skins::Options& part,
                                     const stream::Header& header, const std::vector<Region>& regions, cli::Io& self,
                                     Notes& notes) {
    std::vector<Modifier> out;
    std::string said, crc; // in the history a file has no name
    for (const Asked& a : all) {
        const auto how = filum::skins::modified(part, a.settings);
        modifier::Body body = modifier::body(a.file, header, regions, self.threads, notes);
        said += (said.empty() ? "FILE:" : ";FILE:") + a.settings;
        crc += (crc.empty() ? "" : ",") + body.crc32c;
        out.push_back({std::move(body.outlines), how});
    }
    if (all.empty()) return out;
    self.settings.push_back({"modifier", said, true});
    self.settings.push_back({"modifier_crc32c", crc});
    return out;
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    filum::skins::Options options = o.how;
    options.infill = filum::skins::share(o.infill);
    options.pattern = filum::skins::pattern(o.pattern);
    const auto bodies = asked(o.modifiers);
    std::vector<Region> regions;
    auto whole = cli::read_all(io.input, stream::Payload::regions,
                               [&](stream::RawFrame frame) { regions.push_back(wire::region(frame)); });
    cli::Io self = io;
    Notes notes;
    const auto modifiers = read_modifiers(bodies, options, whole.header, regions, self, notes);
    Facts facts;
    filum::skins::skins(regions, options, modifiers, facts);
    whole.header.expected = regions.size();
    cli::Output output(io, cli::header(self, stream::Payload::regions, {&whole.header}));
    output.pass_on(whole);
    output.add(notes);
    output.add(facts);
    for (const auto& r : regions) output.write(wire::frame(r));
    output.close();
}

} // namespace filum::app::skins
