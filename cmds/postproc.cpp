// postproc - a toolpath to machine code
// reads:  Toolpath
// writes: text
// memory: one span; what else arrives is kept, beyond 48 MiB in a temporary file
#include "cli/command.hpp"
#include "postproc/about.hpp"
#include "postproc/measure.hpp"
#include "postproc/program.hpp"
#include "stream/spool.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Writes the program that a machine runs: every bead as straight moves with its own material, every break as a "
    "travel with the retraction and lift of the machine's profile. Within a stroke there is no move without material "
    "and nothing is taken back. Material is counted exactly: what rounding leaves over goes into the next move.\n\n"
    "The toolpath is read to its end before the first line is written: a toolpath that is cut short or breaks a limit "
    "gives no program at all. A program cut short later (a full disk, a killed process) lacks its last line, 'end of "
    "program'.\n\n"
    "A machine is a TOML file: NAME.toml in the folders of $FILUM_PROFILES or in share/filum/profiles, or any file "
    "given by its path. Copy the nearest one and edit it; each key is explained there. A bead "
    "above limits.section, a place off the bed, a feed above motion.max_speed is an error "
    "that names the place or the key; feeds are lowered by themselves to keep limits.flow and motion.max_speed_z.\n\n"
    "A profile with a section [kinematics] has rotary axes (linuxcnc-xyzac, linuxcnc-xyzbc, linuxcnc-head-table, "
    "linuxcnc-head-head, polar-xzbc, open5x-duet, klipper-xyzac): the tool follows the toolpath's normals, upright "
    "without. The numbers are the tip in the part's frame, or where the axes stand, cut so fine that the tip keeps to "
    "its line; the program's head says which. Of both ways to stand that one is taken whose axes travel least over the "
    "stroke and keep their limits; where none goes on, the stroke is broken and the axes unwound in the air, which a "
    "note and the fact 'unwinds' tell. Near upright the tool may lean a little, so that the turn axis does not spin. "
    "Rotary speeds slow the path down, never the reverse. kuka-krl, abb-rapid and ur write tool frames in the "
    "languages of robots. What the axes cannot reach is an error with the place.\n\n"
    "Templates in the profile hold the codes of the start, the end, and each layer; {names} in them stand for "
    "numbers: every name of the profile's [values], and x_min x_max y_min y_max z_min z_max (the part), x_start "
    "y_start z_start (the first stroke), bed_x_min bed_x_max bed_y_min bed_y_max bed_z_max, z_park (10 mm above the "
    "part), layer layers z height, path_len travel_len (mm), time (s), strokes, material_mm3, material_e (in units of "
    "the extruder), travel_feed z_feed (mm/min).";

cli::Spec spec(postproc::Options& o) {
    return {
        .name = "postproc",
        .synopsis = "a toolpath to machine code",
        .description = kDescription,
        .in = cli::reads(stream::Payload::toolpath),
        .out = cli::text("machine code"),
        .memory = "one span; what else arrives is kept, beyond 48 MiB in a temporary file in $TMPDIR",
        .options = {cli::Option{"machine", &o.machine, "NAME|FILE", "machine profile"}.not_a_setting(),
                    cli::Option{"place", &o.place, "",
                                "where the part goes: center puts the middle of the toolpath on the middle of the "
                                "bed, as-is keeps its coordinates"}
                        .one_of({"center", "as-is"}),
                    {"orient", &o.orient, "",
                     "how the part is turned on a machine with rotary axes: as-is; RX,RY,RZ: degrees about x, then y, "
                     "then z; up:X,Y,Z: this direction points up; auto: the largest tilt is the least there is"},
                    {"set", &o.set, "KEY=VALUE,...",
                     "change keys of the profile, as feeds.bead=40; a key without a section is one of [values], as "
                     "nozzle_temp=230"}},
        .examples = {{"slice part.stl | regions | sequence | fill | link3d | postproc --machine marlin > part.gcode",
                      "G-code for a filament printer"},
                     {"slice part.stl | regions | sequence | fill | link3d | postproc --machine linuxcnc --set "
                      "feeds.bead=40 -o part.ngc",
                      "for LinuxCNC, slower"}},
        .see_also = {"link3d", "metrics", "sequence"}};
}

std::vector<postproc::Stage> stages(const stream::Header& before, const cli::Io& io, const machine::Profile& profile) {
    std::vector<postproc::Stage> out;
    const auto add = [&out](const std::string& program, const std::vector<stream::Setting>& settings) {
        out.push_back({program, {}});
        for (const auto& s : settings) out.back().settings.emplace_back(s.name, s.value);
    };
    for (const auto& run : before.history) add(run.program, run.settings);
    add(io.program, io.settings);
    auto& own = out.back().settings;
    own.insert(own.begin(), {"machine", profile.name + " (profile " + profile.fingerprint + ")"});
    return out;
}

void run(const postproc::Options& o, const cli::Io& io) {
    const auto profile = machine::load_profile(o.machine, o.set);
    stream::Reader reader(io.input, stream::Payload::toolpath);
    stream::Sink sink(io.output, stream::Sink::Content::text);
    stream::Spool spool;
    cli::Progress progress(io, reader.header().expected);
    Notes notes;
    Facts facts;
    postproc::Measure measure(profile, postproc::parse_place(o.place), postproc::parse_orient(o.orient));
    while (auto frame = reader.next()) {
        if (frame->tag == stream::Tag::note) notes.push_back(stream::parse_note(frame->body));
        if (frame->tag == stream::Tag::fact) facts.push_back(stream::parse_fact(frame->body));
        if (frame->tag != stream::Tag::span) continue;
        measure.add(wire::span(*frame));
        spool.add(std::move(*frame));
        progress.step();
    }
    while (measure.again()) {
        while (const auto frame = spool.next()) measure.add(wire::span(*frame));
        spool.rewind();
    }
    const auto survey = measure.end();
    postproc::add_efforts(profile, survey, io.program, notes, facts);

    const auto program =
        postproc::writer(profile, survey, measure.program_shift(), [&](auto text) { sink.write(text); });
    program->begin(postproc::about(profile, survey, stages(reader.header(), io, profile), notes, facts));
    const auto written = postproc::walker(profile, measure.walk_shift(), [&](auto steps) { program->add(steps); });
    while (const auto frame = spool.next()) written->add(measure.turned(wire::span(*frame)));
    written->end();
    program->end();
    sink.commit();
    cli::Report report(io);
    for (const Note& note : notes) report.add(note);
    report.say();
}

} // namespace

int main(int argc, char** argv) { return cli::main<postproc::Options>(argc, argv, spec, run); }
