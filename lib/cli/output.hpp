// What a program writes: its stream, what it notes and found out in it, and the sum of the notes on standard error.
#pragma once

#include "cli/command.hpp"

namespace filum::cli {

class Output {
  public:
    // Begins the stream `header` in the file that `io` names, with what this run was told otherwise than those before.
    Output(const Io& io, const stream::Header& header);
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    // A frame as it is: payload, or a remark of a program before.
    void write(const stream::RawFrame& frame) { writer_.write(frame); }

    // Notes, then facts, that came by a stream before, as they are; of the facts those that `keep` asks for.
    void pass_on(const Whole& before, const std::function<bool(const Fact&)>& keep = {});

    // As this program's, whatever stage they name.
    void add(Note note);
    void add(const Notes& notes);
    void add(Fact fact);
    void add(const Facts& facts);

    // The end of the stream: call it only when all input was read to its own end.  Then says the notes' sum.
    void close();

  private:
    Io io_;
    stream::Writer writer_;
    Report report_;
};

} // namespace filum::cli
