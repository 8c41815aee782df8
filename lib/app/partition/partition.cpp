#include "app/partition/partition.hpp"

#include "app/geodesic/model.hpp"
#include "app/partition/patches.hpp"
#include "geodesic/lines.hpp"
#include "partition/names.hpp"
#include "wire/surface.hpp"

namespace filum::app::partition {

void run(const Options& o, const cli::Io& io) {
    filum::partition::Options how = o.how;
    how.pull.cases = filum::partition::words(o.cases, "case");
    cli::Io self = io; // with what identifies the lines
    if (!o.seam.empty())
        how.lines =
            filum::geodesic::read_lines(geodesic::load(o.seam, "seam_crc32c", self).view(), mesh::spoken_name(o.seam));
    const auto names = filum::partition::words(o.names, "names"), only = filum::partition::words(o.only, "only");
    std::vector<cli::Whole> before;
    std::vector<surface::Sheet> patches;
    Notes notes;
    const auto add = [&](const stream::RawFrame& f) {
        surface::Sheet sheet = wire::sheet(f);
        if (o.as_is || !sheet.name.empty()) return patches.push_back(std::move(sheet));
        for (auto& p : filum::partition::divide(std::move(sheet), how, io.threads, notes))
            patches.push_back(std::move(p));
    };
    for (const auto& input : io.inputs.empty() ? std::vector<std::string>{"-"} : io.inputs)
        before.push_back(cli::read_all(input, stream::Payload::surface, add));
    filum::partition::name(patches, names);
    filum::partition::keep_only(patches, only);
    write(before, patches, notes, filum::partition::facts(patches, how.pull), self);
}

} // namespace filum::app::partition
