#include "app/collide/collide.hpp"

#include "app/collide/things.hpp"
#include "cli/output.hpp"
#include "collision/report.hpp"
#include "figures/meanings.hpp"
#include "mesh/read.hpp"
#include "stream/spool.hpp"
#include "wire/planar.hpp"

#include <algorithm>

namespace filum::app::collide {

namespace {

using collision::Obstacle;
using geom::Vec3;

collision::CheckResult check(Things& t, std::vector<collision::Solid> beads, const collision::Heads& head,
                             const std::vector<collision::Move>& moves, const Options& o, int threads) {
    if (o.bed) t.solids[static_cast<std::size_t>(Obstacle::bed)] = collision::bed(moves);
    const collision::Scene scene{collision::Tree(std::move(beads)), collision::Tree(std::move(t.solids[1])),
                                 collision::Tree(std::move(t.solids[2])), collision::Tree(std::move(t.solids[3]))};
    auto out = collision::check(scene, head, moves, o.check, threads);
    std::stable_sort(out.collisions.begin(), out.collisions.end(), [&](const auto& a, const auto& b) {
        return moves[a.move].source < moves[b.move].source; // the moves of idle heads come last
    });
    return out;
}

void program(const Options& o, const machine::Profile& profile, const cli::Io& io) {
    const mesh::Bytes bytes = mesh::load(o.program);
    collision::ProgramOptions how;
    if (!o.bead.empty()) {
        how.width = o.bead[0];
        how.height = o.bead[1];
    }
    if (!o.shift.empty()) how.shift = {o.shift[0], o.shift[1], o.shift[2]};
    const collision::Heads heads = heads_of(profile);
    auto read = collision::read_program(bytes.view(), mesh::spoken_name(o.program), profile, how);
    if (read.moves.empty())
        throw Error(Exit::bad_input, "cannot find a move in the program " + mesh::spoken_name(o.program));
    collision::add_idle(heads, read.moves);
    Things t(o.part, o.fixture);
    const auto found = check(t, std::move(read.beads), heads, read.moves, o, io.threads);
    const collision::ReportInput answer{read.moves, found, o.check, collision::Source::line};
    write_places(o.places, answer);
    auto figures = collision::summary(answer);
    for (const auto& [key, count] : {std::pair{"program_lines", read.lines},
                                     {"program_lines_unknown", read.unknown},
                                     {"program_lines_other", read.ignored}})
        figures::tell(figures, figures::head_meanings(), key, count);
    cli::Report report(io);
    for (Note& note : t.notes) {
        note.stage = io.program;
        report.add(note);
    }
    report.say();
    if (!found.collisions.empty() && o.strict) throw Error(Exit::failure, collision::complaint(answer));
    stream::Sink sink(io.output, stream::Sink::Content::text);
    sink.write(figures::text(figures, figures::format_named(o.format), "collide"));
    sink.commit();
}

void toolpath(const Options& o, const collision::Machine& machine, const cli::Io& given) {
    cli::Io io = given;
    add_settings(machine.head.common, io);
    stream::Reader reader(io.input, stream::Payload::toolpath);
    stream::Spool spool;
    collision::MoveReader walk(machine);
    while (auto frame = reader.next()) {
        if (!stream::is_remark(frame->tag)) {
            const auto span = wire::span(*frame);
            for (const Vec3& p : span.points) check_place(p, "the toolpath");
            walk.add(span);
        }
        spool.add(std::move(*frame));
    }
    Things t(o.part, o.fixture);
    io.settings.insert(io.settings.end(), t.settings.begin(), t.settings.end());
    auto& moves = walk.growth.moves;
    collision::add_idle(machine.head, moves);
    const auto found = check(t, std::move(walk.growth.beads), machine.head, moves, o, io.threads);
    const collision::ReportInput answer{moves, found, o.check, collision::Source::point};
    write_places(o.places, answer);
    if (!found.collisions.empty() && o.strict) throw Error(Exit::failure, collision::complaint(answer));
    cli::Output output(io, cli::header(io, stream::Payload::toolpath, {&reader.header()}));
    output.add(t.notes);
    output.add(collision::notes(answer));
    output.add(collision::facts(answer));
    while (const auto frame = spool.next()) output.write(*frame);
    output.close();
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    if (o.machine.empty() && !o.program.empty())
        throw Error(Exit::usage, "cannot read --program without --machine; name its profile");
    const machine::Profile profile = profile_of(o.machine, o.set, o.head);
    if (!o.program.empty()) {
        if (io.input != "-")
            throw Error(Exit::usage, "cannot check '" + io.input + "' and --program at once; give one");
        if (profile.axes.chain.carrier == kinematics::Carrier::frame)
            throw Error(Exit::usage, "cannot read --program of the robot '" + profile.name +
                                         "': only G-code is understood; check its toolpath");
        return program(o, profile, io);
    }
    if (!o.bead.empty() || !o.shift.empty())
        throw Error(Exit::usage, "cannot use --bead or --shift without --program: a toolpath says both itself");
    toolpath(o, machine_of(profile), io);
}

} // namespace filum::app::collide
