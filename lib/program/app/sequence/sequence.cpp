#include "app/sequence/sequence.hpp"

#include "base/number.hpp"
#include "cli/output.hpp"
#include "sequence/slabs_apart.hpp"
#include "wire/planar.hpp"

namespace filum::app::sequence {

namespace {

// Writes the facts on standard error.
void report(const filum::sequence::SequenceResult& result, const cli::Io& io) {
    for (const auto& fact : result.facts) io.say(fact.name + " " + fixed_text(fact.value, 4));
    io.say("bound-by " + result.bound_by);
}

} // namespace

void run(const Work& work, const cli::Io& given) {
    cli::Io io = given;
    filum::sequence::Options how = work.how;
    how.heads = machine::heads(work.head);
    if (how.first != filum::sequence::Priority::strokes) io.settings.push_back({"tool-changes", "first", true});
    for (const auto& [name, value, changed] : machine::settings(how.heads.common))
        io.settings.push_back({name, value, changed});
    if (how.from_inside) io.settings.push_back({"from-inside", "true", true});
    if (work.clearance > 0) {
        how.heads.common = machine::widened(how.heads.common, work.clearance);
        for (auto& [tool, head] : how.heads.own) head = machine::widened(head, work.clearance);
        io.settings.push_back({"clearance", shortest_text(work.clearance), true});
    }
    std::vector<stream::RawFrame> frames;
    std::vector<polygon::Region> regions;
    auto whole = cli::read_all(io.input, stream::Payload::regions, [&](stream::RawFrame frame) {
        regions.push_back(wire::region(frame));
        frames.push_back(std::move(frame));
    });
    const auto pauses = machine::parse_pauses(work.pause_at);
    const auto passed = [&](const polygon::Region& r) { return pauses.before(r.layer, r.z, r.height); };
    if (regions.empty() || passed(regions.back()) == passed(regions.front()))
        io.idle("pause-at", "the part has nothing on both sides of it");
    auto result = pauses.count() > 0 ? filum::sequence::sequence_apart(regions, how, pauses)
                                     : filum::sequence::sequence(std::move(regions), how);

    whole.header.expected = frames.size();
    cli::Output output(io, cli::header(io, stream::Payload::regions, {&whole.header}));
    output.pass_on(whole);
    output.add(result.facts);
    for (const Fact& fact : result.facts)
        if (fact.name == "collisions-assumed")
            output.add(Note{.code = NoteCode::distance_not_measured, .count = static_cast<std::uint64_t>(fact.value)});
    for (const Fact& fact : result.facts)
        if (fact.name == "outer-first" && fact.value > 0)
            output.add(Note{.code = NoteCode::outer_first, .count = static_cast<std::uint64_t>(fact.value)});
    if (work.report) report(result, io);
    if (!work.ends.empty()) {
        stream::Sink table(work.ends, stream::Sink::Content::text);
        table.write(filum::sequence::table(result.graph, result.ends));
        table.commit();
    }
    for (std::size_t i = 0; i < result.order.size(); ++i) {
        const auto frame = std::move(frames[result.order[i]]);
        auto region = wire::region(frame);
        region.stroke = result.stroke[i];
        region.join = result.join[i];
        output.write(wire::frame(region));
    }
    output.close();
}

} // namespace filum::app::sequence
