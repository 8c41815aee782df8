#include "app/postproc/postproc.hpp"

#include "app/postproc/ahead.hpp"
#include "app/postproc/program_file.hpp"
#include "app/postproc/thumbnails.hpp"
#include "base/number.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "machine/feed.hpp"
#include "postproc/about.hpp"
#include "postproc/job.hpp"
#include "postproc/measure.hpp"
#include "postproc/program.hpp"
#include "stream/spool.hpp"
#include "wire/planar.hpp"

#include <algorithm>
#include <deque>
#include <optional>

namespace filum::app::postproc {

namespace {

// Writes the files of a program's modules to a folder.
class Modules {
  public:
    explicit Modules(std::string folder) : folder_(std::move(folder)) {}

    // The function that adds a module; empty without a folder.  It is valid as long as this object.
    filum::postproc::ModuleFile file() {
        if (folder_.empty()) return {};
        return [this](const std::string& name) {
            stream::Sink& to = files_.emplace_back(folder_ + "/" + name, stream::Sink::Content::text);
            return [&to](std::string_view text) { to.write(text); };
        };
    }

    void commit() {
        for (stream::Sink& file : files_) file.commit();
    }

  private:
    std::string folder_;
    std::deque<stream::Sink> files_;
};

std::vector<filum::postproc::Stage> stages(const stream::Header& before, const cli::Io& io,
                                           const machine::Profile& profile) {
    std::vector<filum::postproc::Stage> out;
    for (const auto& run : cli::header(io, stream::Payload::unknown, {&before}).history) {
        out.push_back({run.program, {}});
        for (const auto& s : run.settings) out.back().settings.emplace_back(s.name, s.value);
    }
    auto& own = out.back().settings;
    own.insert(own.begin(), {"machine", profile.name + " (profile " + profile.fingerprint + ")"});
    return out;
}

// The parts on the bed, from the last run in the history that placed several parts; empty if there is none.
std::vector<filum::postproc::LabelledPart> parts_on_bed(const stream::Header& header) {
    std::vector<filum::postproc::LabelledPart> out;
    for (const stream::Run& run : header.history) {
        if (!run.objects.empty()) out.clear();
        for (const stream::Object& object : run.objects) {
            out.push_back({object.name, {}});
            for (std::size_t i = 0; i < object.x.size(); ++i) out.back().outline.push_back({object.x[i], object.y[i]});
        }
    }
    return out;
}

// Refuses paths that reach farther beyond a part's rims than the machine allows.  Throws Error(usage).
void check_outside(const stream::Header& header, const machine::Profile& profile) {
    for (const stream::Run& run : header.history)
        for (const auto& s : run.settings)
            if (s.name == "turn-outside" && (run.program == "surfpath" || run.program == "laminate"))
                machine::allow_outside(profile, parse_number(s.value, "turn-outside"),
                                       "a path by " + run.program + " --turn-outside");
}

void say(const Notes& notes, const cli::Io& io) {
    cli::Report report(io);
    for (const Note& n : notes) report.add(n);
    report.say();
}

void tell_idle(const filum::postproc::FirstPass& found, const cli::Io& io) {
    if (found.waits.count < found.pauses.count())
        io.idle("pause-at", std::to_string(found.pauses.count() - found.waits.count) +
                                " of its places are above the part's " + std::to_string(found.layers) + " layers");
    const bool beyond = std::all_of(found.by_layer.begin(), found.by_layer.end(),
                                    [&](const auto& v) { return v.layer >= found.layers; });
    if (beyond) io.idle("by-layer", "the part has " + std::to_string(found.layers) + " layers");
}

// Writes the lines of the summary to the file `path`; nothing if the path is empty.
void write_summary(const std::string& path, const std::vector<std::string>& lines) {
    if (path.empty()) return;
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    cli::write_text(path, text);
}

// Draws the pictures of the given sizes and those that the file requires.  They become tables of the file, or comments
// at the head of a text.
void add_pictures(stream::Spool& spool, const std::vector<PictureSize>& sizes, int threads, ProgramFile& file,
                  std::vector<std::string>& about) {
    auto all = file.own_pictures();
    const std::size_t own = all.size();
    all.insert(all.end(), sizes.begin(), sizes.end());
    if (all.empty()) return;
    const auto pictures = thumbnails(spool, all, threads);
    spool.rewind();
    for (std::size_t i = 0; i < (file.tables() ? all.size() : own); ++i) file.add(all[i], pictures[i]);
    if (file.tables()) return;
    for (auto& line : thumbnail_lines(sizes, {pictures.begin() + static_cast<std::ptrdiff_t>(own), pictures.end()}))
        about.push_back(std::move(line));
}

} // namespace

void run(const filum::postproc::Options& o, const cli::Io& io) {
    auto profile = filum::postproc::profile_for(o);
    const auto sizes = thumbnail_sizes(o.thumbnails);
    if (!profile.fibre.active()) io.idle("short", "'" + profile.name + "' has no section [fibre]");
    if (profile.format.dialect == machine::Dialect::gcode) io.idle("modules", "'" + profile.name + "' is no robot");
    stream::Reader reader(io.input, stream::Payload::toolpath);
    check_outside(reader.header(), profile);
    ProgramFile file(io.output, profile);
    stream::Spool spool;
    cli::Progress progress(io, reader.header().expected);
    Notes notes;
    Facts facts;
    filum::postproc::Measure measure(profile, o.place, filum::postproc::parse_orient(o.orient), o.flatten,
                                     machine::parse_pauses(o.pause_at));
    machine::LayerTimes times;
    filum::postproc::FirstPass first_pass;
    std::optional<MoveQueue> ahead;
    try {
        while (auto frame = reader.next()) {
            if (frame->tag == stream::Tag::note) notes.push_back(stream::parse_note(frame->body));
            if (frame->tag == stream::Tag::fact) facts.push_back(stream::parse_fact(frame->body));
            if (frame->tag != stream::Tag::span) continue;
            const auto span = wire::span(*frame);
            measure.add(span);
            if (profile.limits.layer_time > 0) times.add(profile, span);
            spool.add(std::move(*frame));
            progress.step();
        }
        // The walkers start after the first pass over the spans, so the feeds of layers can still change.
        if (profile.limits.layer_time > 0) machine::set_pace(profile, machine::pace(times, profile.limits.layer_time));
        ahead.emplace(profile, *measure.joins(), io.threads);
        for (; measure.again(); spool.rewind())
            ahead->each(spool, [&](auto span, auto* moves) { measure.add(span, moves); });
        first_pass = measure.end();
    } catch (const Error&) {              // notes of the stages before may explain why a stage failed
        for (Note& n : notes) n.bead = 0; // nothing is less than a bead if there is none
        say(notes, io);
        throw;
    }
    if (!o.pause_at.empty()) std::erase_if(notes, [](const Note& n) { return n.code == NoteCode::project_codes; });
    first_pass.by_layer = filum::postproc::parse_by_layer(o.by_layer, profile);
    if (!profile.axes.active()) first_pass.parts = parts_on_bed(reader.header());
    tell_idle(first_pass, io);
    Notes own = filum::postproc::omissions(first_pass);
    filum::postproc::add_waits(first_pass, own);
    filum::postproc::add_efforts(profile, first_pass, io.program, own, facts);
    for (Note& n : own) {
        n.stage = io.program;
        notes.push_back(std::move(n));
    }
    say(notes, io);
    if (!o.job.empty())
        cli::write_text(
            o.job, filum::figures::text(filum::postproc::job(profile, first_pass), filum::figures::Format::tsv, "job"));
    Modules modules(o.modules);
    const auto program = filum::postproc::writer(
        profile, first_pass, measure.program_shift(), [&](auto text) { file.write(text); }, modules.file());
    const auto told = filum::postproc::summary(profile, first_pass, measure.program_shift(), notes, facts);
    auto about = filum::postproc::about(profile, first_pass, told, notes);
    add_pictures(spool, sizes, io.threads, file, about);
    program->begin(about);
    const auto add = [&](std::span<const filum::postproc::Step> steps) { program->add(steps); };
    const auto written = filum::postproc::walker(profile, measure.walk_shift(), add, measure.joins());
    ahead->each(spool, [&](auto span, auto* moves) { written->add(measure.turned(std::move(span)), moves); });
    written->end();
    const auto made_by = stages(reader.header(), io, profile);
    program->end(filum::postproc::history(made_by, notes, facts));
    modules.commit();
    file.describe(profile, first_pass, measure.program_shift(), made_by);
    file.commit();
    write_summary(o.summary, told);
}

} // namespace filum::app::postproc
