#include "app/ingest/ingest.hpp"

#include "base/error.hpp"
#include "cli/output.hpp"
#include "ingest/container.hpp"
#include "mesh/read.hpp"
#include "stream/crc32c.hpp"
#include "wire/planar.hpp"

namespace filum::app::ingest {

void run(const Options& o, const cli::Io& given) {
    machine::Profile profile;
    if (!o.machine.empty()) profile = machine::load_profile(o.machine, o.set);
    if (profile.axes.chain.carrier == kinematics::Carrier::frame)
        throw Error(Exit::usage,
                    "cannot read a program of the robot '" + profile.name + "': only G-code is understood");
    const mesh::Bytes bytes = mesh::load(given.input);
    const std::string name = mesh::spoken_name(given.input);
    if (bytes.size == 0) throw Error(Exit::truncated, "cannot follow the program in " + name + ": it is empty");
    std::string kept;
    Notes notes;
    const std::string_view program =
        filum::ingest::program_in(bytes.view(), name, static_cast<std::uint32_t>(o.plate), kept, notes);
    cli::Io io = given;
    if (!profile.name.empty())
        io.settings.push_back({"machine_profile", profile.name + " " + profile.fingerprint, true});
    io.settings.push_back({"input_crc32c", stream::crc32c_text(bytes.view()), true});
    cli::Output output(io, cli::header(io, stream::Payload::toolpath));
    auto found = filum::ingest::read(program, name, profile, o,
                                     [&](const toolpath::Span& span) { output.write(wire::frame(span)); });
    for (Fact& f : found.facts) f.stage = io.program;
    found.notes.insert(found.notes.begin(), notes.begin(), notes.end());
    for (Note& n : found.notes) n.stage = io.program;
    output.add(found.notes);
    output.add(found.facts);
    output.close();
}

} // namespace filum::app::ingest
