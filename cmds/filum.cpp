// filum - the front command: runs the stages
// reads:  what the stage reads
// writes: what the stage writes
// memory: nothing of its own
#include "app/filum/front.hpp"
#include "cli/command.hpp"

namespace {

using namespace filum;

struct Options {};

cli::Spec spec(Options&) {
    return {.name = "filum",
            .synopsis = "turn parts into unbroken toolpaths: runs the stages",
            .description = cli::kDescription,
            .in = cli::nothing(),
            .out = cli::text("what the command writes"),
            .memory = "nothing of its own",
            .options = {},
            .examples = {{"filum print part.stl --machine marlin -o part.gcode", "a part to G-code, in one command"},
                         {"filum print part.stl --layer-height 0.3 --dry-run", "the pipeline that this would run"},
                         {"filum slice part.stl | filum peek", "two stages by hand"},
                         {"eval \"$(filum env)\" && slice part.stl | regions | peek", "the stages on the PATH"},
                         {"filum list", "all stages, what they read and write"}},
            .see_also = {"filum-slice", "filum-peek"},
            .arguments = "COMMAND [ARGUMENTS]"};
}

void refuse(const Options&, const cli::Io&) {
    throw Error(Exit::usage, "cannot go on without a command; see 'filum --help'");
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return cli::main<Options>(argc, argv, spec, refuse);
    return cli::guarded("filum", [&] { return app::filum::front({argv + 1, argv + argc}); });
}
