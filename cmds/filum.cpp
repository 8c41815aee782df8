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
    return {
        .name = "filum",
        .synopsis = "turn parts into unbroken toolpaths: runs the stages",
        .description =
            "filum STAGE ... runs a stage, as its own name would if the stages were on the PATH. filum list names the "
            "stages, and filum help STAGE explains one.\n\n"
            "filum print PART [OPTIONS] [-o FILE] runs the whole planar chain (slice, regions, sequence, fill, link3d, "
            "postproc) and writes machine code. An option goes to every stage that has it, so one --bead-width serves "
            "all. "
            "--fill.bead-width goes to fill alone and wins there. If a stage fails, the exit code is that of the first "
            "one "
            "that failed by itself, and no output file appears. --dry-run prints the pipeline instead. filum help "
            "print "
            "explains more. On a terminal it prints a short summary. --report x.html makes a page of it, --keep FOLDER "
            "keeps "
            "every stage's stream, and --stage fill=./mine replaces a stage by a program of your own.\n\n"
            "filum check ./mine --as fill runs such a program on a small part and on damaged streams, and reports "
            "which of a "
            "stage's promises it keeps. filum machines lists the profiles, filum printers also the printers of "
            "slicers' presets, makes one of your own (--new) and "
            "checks it (--check). filum compare covers a surface by all algorithms. filum patterns lists the patterns "
            "of fill and surfpath. filum NAME runs filum-NAME if that is on the PATH.\n\n"
            "filum env prints shell lines that put the stages on the PATH, with their manual pages and completion: "
            "eval "
            "\"$(filum env)\".",
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
