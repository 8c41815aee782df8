#include "cli/command.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/printable.hpp"
#include "cli/document.hpp"
#include "cli/lines.hpp"
#include "cli/output.hpp"
#include "cli/parse.hpp"
#include "cli/progress.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <malloc.h>
#include <new>
#include <sys/stat.h>
#include <unistd.h>

namespace filum::cli {

void Io::say(const std::string& text) const {
    // One write, so that lines of different stages do not mix. On a terminal the line replaces a progress bar.
    const std::string line =
        (::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + for_terminal(program + ": " + printable(text)) + "\n";
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return;
}

void Io::idle(const std::string& option, const std::string& why) const {
    if (quiet || std::find(given.begin(), given.end(), option) == given.end()) return;
    say("--" + option + " has no effect: " + why);
}

stream::Header header(const Io& io, stream::Payload payload, const std::vector<const stream::Header*>& before) {
    stream::Header out;
    out.payload = payload;
    stream::Run self{io.program, version(), io.settings, {}};
    for (const auto* h : before) {
        const auto shift = static_cast<std::uint32_t>(out.history.size());
        for (stream::Run run : h->history) {
            for (auto& parent : run.parents) parent += shift;
            out.history.push_back(std::move(run));
        }
        if (!h->history.empty()) self.parents.push_back(static_cast<std::uint32_t>(out.history.size() - 1));
        out.expected = std::max(out.expected, h->expected);
    }
    out.history.push_back(std::move(self));
    return out;
}

void write_text(const std::string& file, const std::string& text) {
    stream::Sink out(file, stream::Sink::Content::text);
    out.write(text);
    out.commit();
}

Report::Report(const Io& io) : io_(&io) {
    const char* whose = std::getenv("FILUM_NOTES");
    all_ = whose != nullptr && std::string_view(whose) == "all";
    none_ = whose != nullptr && std::string_view(whose) == "later";
}

void Report::add(const Note& note) {
    if (!all_ && note.stage != io_->program) return;
    const auto same = [&](const Note& sum) { return same_kind(sum, note); };
    if (const auto sum = std::find_if(sums_.begin(), sums_.end(), same); sum != sums_.end())
        filum::add(*sum, note);
    else
        sums_.push_back(note);
}

void Report::say() const {
    if (io_->quiet || none_) return;
    for (const Note& n : summed(sums_))
        if (grade(n) >= io_->notes) io_->say(std::string(name(grade(n))) + ": " + line(n));
}

namespace {

struct MapResult {
    std::vector<stream::RawFrame> frames;
    Notes notes;
};

} // namespace

void map_stage(const Io& io, stream::Payload in, stream::Payload out, const MapWork& work) {
    stream::Reader reader(io.input, in);
    Output output(io, header(io, out, {&reader.header()}));
    Progress progress(io, reader.header().expected);
    parallel::ordered<stream::RawFrame, MapResult>(
        io.threads, [&] { return reader.next(); },
        [&](stream::RawFrame frame) {
            MapResult result;
            if (stream::is_remark(frame.tag))
                result.frames.push_back(std::move(frame));
            else
                result.frames = work(std::move(frame), result.notes);
            return result;
        },
        [&](MapResult result) {
            for (const auto& frame : result.frames) output.write(frame);
            output.add(result.notes);
            progress.step();
        });
    output.close();
}

void scan_stage(const Io& io, stream::Payload in, stream::Payload out, const ScanWork& work, const ScanEnd& end,
                const ScanBegin& begin) {
    stream::Reader reader(io.input, in);
    Output output(io, header(io, out, {&reader.header()}));
    Notes first;
    if (begin.begin) begin.begin(reader.header(), first);
    output.add(first);
    Progress progress(io, reader.header().expected);
    const auto emit = [&](stream::RawFrame frame) { output.write(frame); };
    while (auto frame = reader.next()) {
        if (stream::is_remark(frame->tag)) {
            const bool note = begin.drop && frame->tag == stream::Tag::note;
            if (!note || !begin.drop(stream::parse_note(frame->body))) output.write(*frame);
            continue;
        }
        Notes notes;
        work(*frame, emit, notes);
        output.add(notes);
        progress.step();
    }
    Notes notes;
    if (end) end(emit, notes);
    output.add(notes);
    output.close();
}

void source_stage(const Io& io, const stream::Header& header, std::size_t parts, Notes found, const SourceWork& work,
                  const SourceEnd& end) {
    Output output(io, header);
    Progress progress(io, parts);
    output.add(found);
    std::size_t next = 0;
    parallel::ordered<std::size_t, MapResult>(
        io.threads, [&]() -> std::optional<std::size_t> { return next < parts ? std::optional(next++) : std::nullopt; },
        [&](std::size_t part) {
            MapResult result;
            result.frames = work(part, result.notes);
            return result;
        },
        [&](MapResult result) {
            for (const auto& frame : result.frames) output.write(frame);
            output.add(result.notes);
            progress.step();
        });
    if (end) {
        Notes last;
        end(last);
        output.add(last);
    }
    output.close();
}

WholeInput read_all(const std::string& path, stream::Payload expected,
                    const std::function<void(stream::RawFrame)>& frame) {
    return read_all(stream::Reader(path, expected), frame);
}

WholeInput read_all(stream::Reader reader, const std::function<void(stream::RawFrame)>& frame) {
    WholeInput out{reader.header(), {}, {}};
    while (auto f = reader.next()) {
        if (f->tag == stream::Tag::note)
            out.notes.push_back(stream::parse_note(f->body));
        else if (f->tag == stream::Tag::fact)
            out.facts.push_back(stream::parse_fact(f->body));
        else
            frame(std::move(*f));
    }
    return out;
}

namespace {

// Keeps freed memory in the process. Frames take megabytes, and returning each of them to the system costs three times
// as much as copying it.
void keep_freed_memory() {
#ifdef __GLIBC__
    ::mallopt(M_MMAP_THRESHOLD, 256 << 20);
    ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

int fail(const std::string& program, Exit exit, const std::string& what) {
    Io io;
    io.program = program;
    // In a chain started by the front command, the stage that failed reports why the stream ends early.
    if (exit != Exit::truncated || std::getenv("FILUM_CHAIN") == nullptr) io.say(what);
    return static_cast<int>(exit);
}

} // namespace

void write_all(const Io& io, const stream::Header& header, const WholeInput& before, const Notes& notes,
               const Facts& facts, std::span<const stream::RawFrame> frames) {
    Output output(io, header);
    output.pass_on(before);
    output.add(notes);
    output.add(facts);
    for (const auto& frame : frames) output.write(frame);
    output.close();
}

namespace {

// Opens /dev/null for closed standard files. A parent such as cron may start a program with standard input or output
// closed. The next file to be opened would get that number, and be read or written by mistake.
void open_standard_files() {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(fd, F_GETFD) < 0) (void)!::open("/dev/null", fd == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

// Throws Error(usage) if the output file is one of the inputs. Writing it while it is read would leave a partial file,
// or replace the original by its result.
void refuse_input_as_output(const Io& io) {
    struct stat out {};
    if (io.output.empty() || io.output == "-" || ::stat(io.output.c_str(), &out) != 0 || !S_ISREG(out.st_mode)) return;
    std::vector<std::string> inputs = io.inputs;
    inputs.push_back(io.input);
    for (const std::string& input : inputs) {
        struct stat in {};
        if (input.empty() || input == "-" || ::stat(input.c_str(), &in) != 0) continue;
        if (in.st_dev == out.st_dev && in.st_ino == out.st_ino)
            throw Error(Exit::usage,
                        "cannot write '" + io.output + "': it is the input; give another name by --output");
    }
}

} // namespace

int guarded(const std::string& program, const std::function<int()>& work) {
    open_standard_files();
    std::signal(SIGPIPE, SIG_DFL); // the program ends silently when its reader closes the pipe
    std::signal(SIGXFSZ, SIG_IGN); // writing beyond the limit of `ulimit -f` is an error like a full disk
    try {
        return work();
    } catch (const Error& e) {
        return fail(program, e.exit(), e.what());
    } catch (const std::bad_alloc&) {
        return fail(program, Exit::failure, "cannot go on: out of memory; see MEMORY USAGE in the manual");
    } catch (const std::exception& e) {
        const std::string what = e.what();
        if (what.starts_with("pthread_create has failed")) // of oneTBB
            return fail(program, Exit::failure,
                        "cannot start a thread: out of memory or of processes; see MEMORY USAGE in the manual");
        return fail(program, Exit::failure, "internal error: " + what);
    }
}

int detail::run(int argc, char** argv, const Spec& spec, const std::function<void(const Io&)>& work) {
    keep_freed_memory();
    return guarded(spec.name, [&] {
        Io io;
        const std::string text = parse(argc, argv, spec, io);
        if (text.empty()) {
            refuse_input_as_output(io);
            const Clock clock(io);
            work(io);
            return 0;
        }
        stream::Sink out("-", stream::Sink::Content::text);
        out.write(text);
        out.commit();
        return 0;
    });
}

} // namespace filum::cli
