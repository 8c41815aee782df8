// Runs a command: parses its options, catches its Error and returns its exit code.
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

// The paragraphs of cmds/NAME.md, with empty lines between them. The build puts the text into the program NAME.
extern const char* const kDescription;

// The options that every command has, and the name of the program.
struct Io {
    std::string program;
    std::string input = "-";               // first positional argument, "-" for standard input
    std::vector<std::string> inputs;       // all positional arguments
    std::string output = "-";              // --output
    int threads = 0;                       // --threads, 0 for all cores
    bool quiet = false;                    // --quiet: no warnings
    Grade notes = Grade::look;             // --notes: notes below this grade are not printed
    std::vector<stream::Setting> settings; // the options with their values, for the history
    std::vector<std::string> given;        // names of the options that are not at their defaults
    struct Same {
        std::string name;
        std::vector<std::string> as; // PROGRAM.NAME
    };
    std::vector<Same> same; // settings that earlier stages should share

    // Prints the line "program: text" on standard error, with `text` as printable() makes it.
    void say(const std::string& text) const;
    // Warns that `option` has no effect on this input, for the reason `why`. Prints nothing if the option was not
    // given, or with --quiet.
    void idle(const std::string& option, const std::string& why) const;
};

// A header for `payload`. Its history is that of every header in `before`, one after the other, followed by this run.
stream::Header header(const Io& io, stream::Payload payload, const std::vector<const stream::Header*>& before = {});

// Sums the notes of this program by kind. say() prints one line for each sum on standard error, the worst grade first.
// It prints nothing with --quiet. In a chain that the front command started (environment variable FILUM_NOTES) only the
// last program prints, and it prints the notes of all stages.
class Report {
  public:
    explicit Report(const Io& io);
    void add(const Note& note);
    void say() const;

  private:
    const Io* io_;
    bool all_ = false, none_ = false; // prints the notes of all stages; prints none
    Notes sums_;
};

// Runs a stage of shape "map": `work` turns each payload frame into any number of frames. Frames are processed on all
// cores and written in the order of the input. Notes and facts of the input are passed on, and `work` adds its own
// notes. Writes the end frame only after the input's end frame was read.
using MapWork = std::function<std::vector<stream::RawFrame>(stream::RawFrame, Notes&)>;
void map_stage(const Io& io, stream::Payload reads, stream::Payload writes, const MapWork& work);

// Runs a stage of shape "scan": like map, but one frame after the other. `end` is called after the last frame of the
// input and may write more frames and notes.
using ScanWork = std::function<void(const stream::RawFrame&, const std::function<void(stream::RawFrame)>&, Notes&)>;
using ScanEnd = std::function<void(const std::function<void(stream::RawFrame)>&, Notes&)>;
struct ScanBegin {
    std::function<void(const stream::Header&, Notes&)> begin{}; // called with the header of the input, before any frame
    std::function<bool(const Note&)> drop{};                    // whether a note of the input is not passed on
};
void scan_stage(const Io& io, stream::Payload reads, stream::Payload writes, const ScanWork& work,
                const ScanEnd& end = {}, const ScanBegin& begin = {});

// Runs a stage of shape "source", which reads no stream. It calls `work` for the numbers 0 to `parts` - 1 on all cores
// and writes their frames in this order. `found` are the notes made before, and `end` adds the notes known only after
// all parts. The settings of `header` may be more than io.settings: they may also identify the input.
using SourceWork = std::function<std::vector<stream::RawFrame>(std::size_t, Notes&)>;
using SourceEnd = std::function<void(Notes&)>;
void source_stage(const Io& io, const stream::Header& header, std::size_t parts, Notes found, const SourceWork& work,
                  const SourceEnd& end = {});

// Reads a whole stream: calls `frame` for each payload frame and collects the notes and facts. For folds and sinks.
// Throws Error as stream::Reader does.
struct WholeInput {
    stream::Header header;
    Notes notes;
    Facts facts;
};
WholeInput read_all(const std::string& path, stream::Payload expected,
                    const std::function<void(stream::RawFrame)>& frame);
WholeInput read_all(stream::Reader reader, const std::function<void(stream::RawFrame)>& frame);

// Writes a text file as stream::Sink does: it appears only when it is complete. Throws Error(io).
void write_text(const std::string& file, const std::string& text);
// Writes the output of a stage of shape "fold": the notes and facts of the stream `before`, then those of this program,
// then all frames.
void write_all(const Io& io, const stream::Header& header, const WholeInput& before, const Notes& notes,
               const Facts& facts, std::span<const stream::RawFrame> frames);

// Runs `work` as the program of that name. Returns its exit code; if it throws, prints the message on standard error
// and returns the code of the Error, or Exit::failure for other exceptions.
int guarded(const std::string& program, const std::function<int()>& work);

namespace detail {
int run(int argc, char** argv, const Spec& spec, const std::function<void(const Io&)>& work);
}

// The body of main(): `spec` describes the options and binds them to `options`, then `work` runs with them.
template <class Options>
int main(int argc, char** argv, Spec (*spec)(Options&), void (*work)(const Options&, const Io&)) {
    Options options;
    return detail::run(argc, argv, spec(options), [&](const Io& io) { work(options, io); });
}

} // namespace filum::cli
