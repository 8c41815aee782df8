// peek - shows what is in a stream
// reads:  any stream
// writes: text
// memory: one frame
#include "cli/command.hpp"
#include "stream/reader.hpp"

namespace {

struct Options {
    bool check = false;
};

filum::cli::Spec spec(Options& o) {
    using namespace filum::cli;
    return {.name = "peek",
            .synopsis = "show what is in a stream",
            .description = "Prints the header.",
            .in = reads(filum::stream::Payload::unknown),
            .out = text("text"),
            .memory = "one frame",
            .options = {{"check", &o.check, "", "only verify"}},
            .examples = {}};
}

void run(const Options&, const filum::cli::Io& io) {
    filum::stream::Reader reader(io.input, filum::stream::Payload::unknown);
    std::size_t n = 0;
    while (reader.next()) ++n;
    io.say(std::to_string(n));
}

} // namespace

int main(int argc, char** argv) { return filum::cli::main<Options>(argc, argv, spec, run); }
