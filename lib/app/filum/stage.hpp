// The stages as programs: where they are, and what they say about themselves.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

struct StageOption {
    std::string name;
    bool takes_value = false;
    std::string value = {}; // its default
    std::string needs = {}; // as cli::Option::when
};

// What a stage answers to --print-contract.
struct Stage {
    std::string name;
    std::string program; // its file
    std::string synopsis, in, out;
    std::vector<StageOption> options;
};

// The folder of the stages: ../libexec/filum of this program's own folder once installed, else that folder itself.
// Throws Error(failure).
std::string stage_folder();

// The folder above this program's own: the install prefix.
std::string prefix();

// The file of a stage.  Throws Error(usage) if there is none of that name.
std::string stage_program(const std::string& name);

bool is_stage(const std::string& name);

// The planar chain, first to last, and those of it that take part only where one of their own options is given.
inline constexpr const char* kPlanar[] = {"slice",    "regions", "vase",   "skins",   "supports",
                                          "sequence", "fill",    "link3d", "postproc"};
inline constexpr const char* kByWish[] = {"vase", "skins", "supports"};

// Names of all stages, in alphabetical order.
std::vector<std::string> stage_names();

// A program of somebody's own in place of `stage`: it takes the options that it answers with to --print-contract, or
// none where it does not answer.  Throws Error(usage) if the file is no program.
Stage foreign(const Stage& stage, const std::string& file);

// Programs "filum-NAME" on the PATH, by NAME and in its order; none that hide a stage.
std::vector<std::string> extra_names();
// The file of one, or "".
std::string extra_program(const std::string& name);

// Asks the stage.  Throws Error: usage if there is none of that name, failure if it gives no answer.
Stage ask(const std::string& name);

} // namespace filum::app::filum
