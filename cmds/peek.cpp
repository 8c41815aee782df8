// peek - show or verify what is in a stream
// reads:  any stream
// writes: text
// memory: one frame
#include "app/peek/peek.hpp"

namespace {

using namespace filum;

cli::Spec spec(app::peek::Options& o) {
    return {
        .name = "peek",
        .synopsis = "show or verify what is in a stream",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::unknown),
        .out = cli::text("text or JSON"),
        .memory = "one frame",
        .options = {{"check", &o.check, "", "only verifies: prints nothing, and answers by the exit code"},
                    {"text", &o.text, "", "print every frame, a line for each point"},
                    cli::Option{"decimals", &o.decimals, "N", "digits behind the point"}.within(0, 9).when("text"),
                    {"json", &o.json, "", "print header, frames and summary as one JSON object"},
                    {"frames", &o.frames, "", "print a line for each frame: offset of its first byte, and its kind"},
                    {"script", &o.script, "", "print a bash script that makes the stream from its input again"},
                    cli::Option{"defaults", &o.defaults, "", "shows options with their default values, too"}.when(
                        "script")},
        .examples = {{"slice part.stl | peek", "what slice made of a part"},
                     {"slice part.stl | regions | peek --text", "every region, point by point"},
                     {"slice part.stl | regions | sequence | fill | peek --check && echo fine", "verify a chain"},
                     {"slice part.stl --output part.layers && peek --script part.layers", "how a file was made"}},
        .see_also = {"filum", "filum-slice"},
        .arguments = "[STREAM]",
        .pages = {{"notes", notes_page}}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::peek::Options>(argc, argv, spec, app::peek::run); }
