#include "cli/output.hpp"

#include "cli/agree.hpp"

#include <cstdlib>

namespace filum::cli {

namespace {

// The width of the narrowest bead among the runs of this history, mm; 0 if no run has --bead-width. Paths on surfaces
// have none: their beads may be wider than the surface, and their notes go by shares of it.
double bead_width(const stream::Header& header) {
    double out = 0;
    for (const stream::Run& run : header.history) {
        const stream::Setting* given = setting(run, "bead-width");
        const double width = given == nullptr ? 0 : std::strtod(given->value.c_str(), nullptr);
        if (width > 0 && (out == 0 || width < out)) out = width;
    }
    return out;
}

} // namespace

Output::Output(const Io& io, const stream::Header& header)
    : io_(io), writer_(io.output, header), report_(io), bead_(bead_width(header)) {
    add(disagreements(io, header));
}

void Output::pass_on(const WholeInput& before, const std::function<bool(const Fact&)>& keep) {
    for (const Note& note : before.notes) writer_.write(note);
    for (const Fact& fact : before.facts)
        if (!keep || keep(fact)) writer_.write(fact);
}

void Output::add(Note note) {
    note.stage = io_.program;
    note.bead = goes_by_amount(note) ? bead_ : 0;
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
