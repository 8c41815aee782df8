// The stages as programs: finds them and reads their contracts.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace filum::app::filum {

struct StageOption {
    std::string name;
    bool takes_value = false;
    std::string value = {}; // its default
    std::string needs = {}; // the condition under which it has an effect, as in cli::Option::when
};

// The answer of a stage to --print-contract.
struct Stage {
    std::string name;
    std::string program; // path of its file
    std::string synopsis, in, out;
    std::vector<StageOption> options;
};

// The folder of the stages.  In an installation it is ../libexec/filum, seen from the folder of this program; otherwise
// it is the folder of this program.  Throws Error(failure) if that is unknown.
std::string stage_folder();

// The install prefix: the parent of the folder of this program.
std::string prefix();

// The path of the program of a stage.  Throws Error(usage) if there is no stage of that name.
std::string stage_program(const std::string& name);

bool is_stage(const std::string& name);

// The stages of the planar chain, first to last.  kByWish: those that run only if the user gives one of their own
// options.
inline constexpr const char* kPlanar[] = {"slice",    "regions", "vase",   "skins", "supports",
                                          "sequence", "fill",    "link3d", "route", "postproc"};
inline constexpr const char* kByWish[] = {"vase", "skins", "supports", "route"};

// An option that means something else in this stage than in the others of the chain; only --STAGE.NAME reaches it.
struct OwnMeaning {
    const char *stage, *option;
};
inline constexpr OwnMeaning kOwnMeanings[] = {{"route", "lift"}, {"route", "bed"}};
inline bool has_own_meaning(std::string_view stage, std::string_view option) {
    return std::ranges::any_of(kOwnMeanings,
                               [&](const OwnMeaning& own) { return stage == own.stage && option == own.option; });
}

// Names of all stages, in alphabetical order.
std::vector<std::string> stage_names();

// A program of the user's own in place of `stage`.  Its options are those of its answer to --print-contract; without an
// answer it has none.  `file` without a '/' is searched on the PATH.  Throws Error(usage) if the file is no program.
Stage foreign(const Stage& stage, const std::string& file);

// The NAMEs of programs "filum-NAME" on the PATH, in alphabetical order.  Names of stages are left out.
std::vector<std::string> extra_names();
// The path of the program "filum-NAME", or "".
std::string extra_program(const std::string& name);

// Runs the stage with --print-contract and parses its answer.  Throws Error: usage if there is no stage of that name,
// failure if it gives no answer.
Stage ask(const std::string& name);

} // namespace filum::app::filum
