// Running a command: options in, one Error caught, an exit code out.
#pragma once

#include "base/error.hpp"
#include "base/note.hpp"
#include "cli/spec.hpp"
#include "stream/reader.hpp"
#include "stream/writer.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace filum::cli {

// What every command has besides its own options.
struct Io {
    std::string program;
    std::string input = "-";               // first positional argument, "-" for standard input
    std::vector<std::string> inputs;       // all positional arguments
    std::string output = "-";              // --output
    int threads = 0;                       // --threads, 0 for all cores
    bool quiet = false;                    // --quiet: no warnings
    Grade notes = Grade::look;             // --notes: notes below that grade are not said
    std::vector<stream::Setting> settings; // the resolved options, for the history
    std::vector<std::string> given;        // options that are not at their defaults
    struct Same {
        std::string name;
        std::vector<std::string> as; // PROGRAM.NAME
    };
    std::vector<Same> same; // settings that stages before should have been told, too

    // A line on standard error: "program: text", as printable() makes it.
    void say(const std::string& text) const;
    // Warns, unless quiet, if the option was given: on this input it does nothing, since `why`.
    void idle(const std::string& option, const std::string& why) const;
};

// A header for `payload` whose history is that of `before`, if any, plus this run.
stream::Header header(const Io& io, stream::Payload payload, const std::vector<const stream::Header*>& before = {});

// Sums notes by kind and says each sum once on standard error, grade by grade (unless --quiet).  Says the notes of this
// program.  In a chain that the front command started (environment variable FILUM_NOTES) only the last program speaks,
// for all stages.
class Report {
  public:
    explicit Report(const Io& io);
    void add(const Note& note);
    void say() const;

  private:
    const Io* io_;
    bool all_ = false, none_ = false; // whose notes it says
    Notes sums_;
};

// Shape "map": one payload frame in, any number out, on all cores, in order.  Notes and facts of the input pass
// through; `work` adds its own notes.  Writes the end frame only if the input's was read.
using MapWork = std::function<std::vector<stream::RawFrame>(stream::RawFrame, Notes&)>;
void map_stage(const Io& io, stream::Payload reads, stream::Payload writes, const MapWork& work);

// Shape "scan": like map, but strictly one frame after the other, with something to say at the end of the input.
using ScanWork = std::function<void(const stream::RawFrame&, const std::function<void(stream::RawFrame)>&, Notes&)>;
using ScanEnd = std::function<void(const std::function<void(stream::RawFrame)>&, Notes&)>;
void scan_stage(const Io& io, stream::Payload reads, stream::Payload writes, const ScanWork& work,
                const ScanEnd& end = {});

// Shape "source": no stream comes in; `parts` pieces of work, on all cores, give the frames of the output in order.
// `found` is what was noted before, `end` notes what is known when all is done.  The header's settings may be more than
// io.settings: what identifies the input.
using SourceWork = std::function<std::vector<stream::RawFrame>(std::size_t, Notes&)>;
using SourceEnd = std::function<void(Notes&)>;
void source_stage(const Io& io, const stream::Header& header, std::size_t parts, Notes found, const SourceWork& work,
                  const SourceEnd& end = {});

// Reads a whole stream: calls `frame` per payload frame and collects the notes and facts.  For folds and sinks.
struct Whole {
    stream::Header header;
    Notes notes;
    Facts facts;
};
Whole read_all(const std::string& path, stream::Payload expected, const std::function<void(stream::RawFrame)>& frame);
Whole read_all(stream::Reader reader, const std::function<void(stream::RawFrame)>& frame);

// Writes a text file, whole or not at all.
void write_text(const std::string& file, const std::string& text);
// Shape "fold" of such: writes what came by the stream before, then notes and facts as this program's, then all frames.
void write_all(const Io& io, const stream::Header& header, const Whole& before, const Notes& notes, const Facts& facts,
               std::span<const stream::RawFrame> frames);

// Runs `work` as the program of that name: its exit code, or that of the Error it throws, said on standard error.
int guarded(const std::string& program, const std::function<int()>& work);

namespace detail {
int run(int argc, char** argv, const Spec& spec, const std::function<void(const Io&)>& work);
}

// The whole of main(): `spec` binds to `options`, `work` does the job.
template <class Options>
int main(int argc, char** argv, Spec (*spec)(Options&), void (*work)(const Options&, const Io&)) {
    Options options;
    return detail::run(argc, argv, spec(options), [&](const Io& io) { work(options, io); });
}

} // namespace filum::cli
