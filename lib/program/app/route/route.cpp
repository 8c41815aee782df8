#include "app/route/route.hpp"

#include "app/collide/things.hpp"
#include "base/number.hpp"
#include "cli/output.hpp"
#include "collision/report.hpp"
#include "geom/angle.hpp"
#include "route/job.hpp"
#include "route/rim.hpp"
#include "wire/planar.hpp"

namespace filum::app::route {

namespace {

using geom::kDegree;

void write_leaning(const std::string& file, const std::vector<filum::route::TiltSummary>& leaning) {
    if (file.empty()) return;
    std::string text = "stroke\tlayer\tlength\tleaning\tmost\tmean\n";
    for (const auto& l : leaning)
        text += std::to_string(l.stroke) + "\t" + std::to_string(l.layer) + "\t" + fixed_text(l.length, 3) + "\t" +
                fixed_text(l.leaning, 3) + "\t" + fixed_text(l.most / kDegree, 3) + "\t" +
                fixed_text(l.mean / kDegree, 3) + "\n";
    stream::Sink sink(file, stream::Sink::Content::text);
    sink.write(text);
    sink.commit();
}

Facts facts(const filum::route::RoutedToolpath& job) {
    Facts out{{"", "travels", 0, ""}};
    for (std::size_t k = 0; k < job.kinds.size(); ++k) {
        out[0].value += static_cast<double>(job.kinds[k]);
        out.push_back(
            {"", std::string("travels-") + filum::route::kKindNames[k], static_cast<double>(job.kinds[k]), ""});
    }
    out.push_back({"", "travel-length-before", job.before, "mm"});
    out.push_back({"", "travel-length", job.after, "mm"});
    double most = 0, sum = 0, length = 0;
    for (const auto& l : job.leaning) {
        most = std::max(most, l.most);
        sum += l.mean * l.leaning;
        length += l.leaning;
    }
    out.push_back({"", "leaning-strokes", static_cast<double>(job.leaning.size()), ""});
    out.push_back({"", "leaning-length", length, "mm"});
    out.push_back({"", "tilt-max", most / kDegree, "deg"});
    out.push_back({"", "tilt-mean", length > 0 ? sum / length / kDegree : 0, "deg"});
    return out;
}

} // namespace

void run(const Options& o, const cli::Io& given) {
    const machine::Profile profile = collide::profile_of(o.machine, o.set, o.head);
    if (o.tilt > 0 && !o.machine.empty() && !profile.axes.active())
        throw Error(Exit::usage, "cannot use --tilt: '" + profile.name + "' has three axes; leave it out");
    filum::route::Options how{
        collide::machine_of(profile), o.check, {}, {o.tilt * kDegree, o.tilt_rate * kDegree}, o.bed};
    how.travel.lift = o.lift.empty() ? profile.travel.lift : o.lift[0];
    how.travel.min_length = profile.travel.min_length;
    how.travel.under = o.bath;
    how.check.margin = std::max(how.check.margin, o.bath);
    cli::Io io = given;
    collide::add_settings(profile.head, io);
    stream::Reader reader(io.input, stream::Payload::toolpath);
    std::vector<stream::RawFrame> remarks;
    std::vector<toolpath::Span> spans;
    while (auto frame = reader.next()) {
        if (stream::is_remark(frame->tag)) {
            remarks.push_back(std::move(*frame));
            continue;
        }
        spans.push_back(wire::span(*frame));
        for (const auto& p : spans.back().points) collide::check_place(p, "the toolpath");
    }
    collide::Things things(o.part, o.fixture);
    io.settings.insert(io.settings.end(), things.settings.begin(), things.settings.end());
    if (o.bath > 0) filum::route::add_rim_ways(spans, how.machine.head, o.bath + how.travel.lift);
    const auto job = filum::route::route(std::move(spans), std::move(things.solids), how, io.threads);
    const collision::ReportInput answer{job.moves, job.found, how.check, collision::Source::point};
    collide::write_places(o.places, answer);
    write_leaning(o.leaning, job.leaning);
    if (!job.found.collisions.empty() && o.strict) throw Error(Exit::failure, collision::complaint(answer));
    cli::Output output(io, cli::header(io, stream::Payload::toolpath, {&reader.header()}));
    output.add(things.notes);
    output.add(collision::notes(answer));
    output.add(facts(job));
    output.add(collision::facts(answer));
    for (const auto& frame : remarks) output.write(frame);
    for (const auto& span : job.spans) output.write(wire::frame(span));
    output.close();
}

} // namespace filum::app::route
