#include "cli/output.hpp"

#include "cli/agree.hpp"

namespace filum::cli {

Output::Output(const Io& io, const stream::Header& header) : io_(io), writer_(io.output, header), report_(io) {
    add(disagreements(io, header));
}

void Output::pass_on(const WholeInput& before, const std::function<bool(const Fact&)>& keep) {
    for (const Note& note : before.notes) writer_.write(note);
    for (const Fact& fact : before.facts)
        if (!keep || keep(fact)) writer_.write(fact);
}

void Output::add(Note note) {
    note.stage = io_.program;
    writer_.write(note);
    report_.add(note);
}

void Output::add(const Notes& notes) {
    for (const Note& note : notes) add(note);
}

void Output::add(Fact fact) {
    fact.stage = io_.program;
    writer_.write(fact);
}

void Output::add(const Facts& facts) {
    for (const Fact& fact : facts) add(fact);
}

void Output::close() {
    writer_.close();
    report_.say();
}

} // namespace filum::cli
