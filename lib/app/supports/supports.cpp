#include "app/supports/supports.hpp"

#include "app/modifier/modifier.hpp"
#include "cli/output.hpp"
#include "geom/angle.hpp"
#include "regions/air.hpp"
#include "wire/planar.hpp"

#include <algorithm>

namespace filum::app::supports {

void run(const Options& o, const cli::Io& io) {
    filum::supports::Options options = o.how;
    options.angle = geom::radians(o.angle_deg);
    options.taper = geom::radians(o.taper_deg);
    options.on_part = o.on == "everywhere";
    std::vector<polygon::Region> given;
    auto whole = cli::read_all(io.input, stream::Payload::regions,
                               [&](stream::RawFrame frame) { given.push_back(wire::region(frame)); });
    Facts facts;
    Notes notes;
    cli::Io self = io;
    const auto read = [&](const std::string& option, const std::string& file, std::vector<polygon::Loops>& to) {
        if (file.empty()) return;
        auto [body, painted] =
            modifier::support_places(file, option == "support-in", whole.header, given, io.threads, notes);
        to = std::move(body.outlines);
        if (painted > 0) facts.push_back({"", option + "-painted", painted, "mm2"});
        self.settings.push_back({option, "FILE", true}); // in the history a file has no name
        self.settings.push_back({option + "_crc32c", body.crc32c});
    };
    read("support-in", o.wanted, options.wanted);
    read("no-support-in", o.unwanted, options.unwanted);
    const auto all = filum::supports::supports(std::move(given), options, facts, notes);
    // what hung without supports; this stage tells what still does
    if (options.carries())
        std::erase_if(whole.notes, [](const Note& n) { return n.what.starts_with(regions::kMidAir); });
    whole.header.expected = all.size();
    cli::Output output(io, cli::header(self, stream::Payload::regions, {&whole.header}));
    output.pass_on(whole);
    output.add(notes);
    output.add(facts);
    for (const auto& r : all) output.write(wire::frame(r));
    output.close();
}

} // namespace filum::app::supports
