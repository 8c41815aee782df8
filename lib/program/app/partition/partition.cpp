#include "app/partition/partition.hpp"

#include "app/geodesic/model.hpp"
#include "cli/output.hpp"
#include "geodesic/lines.hpp"
#include "partition/names.hpp"
#include "wire/surface.hpp"

namespace filum::app::partition {

namespace {

// Writes the notes and facts of the input streams, then the patches.  Earlier facts of this program are left out, since
// they describe earlier patches.
void write(const std::vector<cli::WholeInput>& before, const std::vector<surface::Sheet>& patches, const Notes& notes,
           const Facts& facts, const cli::Io& self) {
    std::vector<const stream::Header*> headers;
    headers.reserve(before.size());
    for (const auto& b : before) headers.push_back(&b.header);
    auto header = cli::header(self, stream::Payload::surface, headers);
    header.expected = patches.size();
    cli::Output output(self, header);
    for (const auto& b : before) output.pass_on(b, [&](const Fact& fact) { return fact.stage != self.program; });
    output.add(notes);
    output.add(facts);
    for (const auto& p : patches) output.write(wire::frame(p));
    output.close();
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    filum::partition::Options how = o.how;
    how.pull.cases = filum::partition::words(o.cases, "case");
    cli::Io self = io; // its settings get the checksum of the lines
    if (!o.seam.empty())
        how.lines =
            filum::geodesic::read_lines(geodesic::load(o.seam, "seam_crc32c", self).view(), mesh::spoken_name(o.seam));
    const auto names = filum::partition::words(o.names, "names"), only = filum::partition::words(o.only, "only");
    std::vector<cli::WholeInput> before;
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
