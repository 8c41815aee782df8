// The output of a program: its stream with notes and facts, and a summary of the notes on standard error.
#pragma once

#include "cli/command.hpp"

namespace filum::cli {

class Output {
  public:
    // Begins the stream with `header` in the file `io.output`. Adds a note for each setting that differs from that of
    // an earlier stage: see agree.hpp.
    Output(const Io& io, const stream::Header& header);
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    // Writes a frame unchanged: payload, or a note or fact of an earlier program.
    void write(const stream::RawFrame& frame) { writer_.write(frame); }

    // Passes on the notes, then the facts, of the stream `before`, unchanged. Facts for which `keep` returns false are
    // dropped.
    void pass_on(const WholeInput& before, const std::function<bool(const Fact&)>& keep = {});

    // Adds notes or facts of this program. Notes and facts get its name, and notes the width of the job's beads.
    void add(Note note);
    void add(const Notes& notes);
    void add(Fact fact);
    void add(const Facts& facts);

    // Ends the stream, commits the file and prints the summary of the notes. Call it only after all input was read to
    // its end frame.
    void close();

  private:
    Io io_;
    stream::Writer writer_;
    Report report_;
    double bead_; // mm, width of the job's beads; 0: unknown
};

} // namespace filum::cli
