// `filum machines`: lists the machine profiles, writes a copy of one, and checks one.
#pragma once

#include "machine/profile.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

inline constexpr const char* kMachinesHelp =
    "usage: filum machines\n"
    "       filum machines --new FILE --from NAME | --base NAME\n"
    "       filum machines --check FILE\n\n"
    "Lists the machines that Filum knows: the name for --machine, the size of the bed and the height, and what kind\n"
    "of machine it is.\n\n"
    "  --new FILE --from NAME   writes a profile of your own, a copy of NAME to be edited: mine.toml of clay\n"
    "  --new FILE --base NAME   writes a short profile that states only what differs from NAME\n"
    "  --check FILE             reads a profile and lists what is wrong or surprising: codes that heat a cold\n"
    "                           material, a nozzle that is missing, ...; exit code 1 if there is anything, 3 if it\n"
    "                           cannot be used\n\n"
    "A profile is a text (TOML); docs/machines.md explains its keys.\n\n"
    "  postproc --machine marlin --set bed.x_max=300   changes a key\n"
    "  postproc --machine mine.toml                    reads a file\n";

// Runs the command; `words` are its arguments.  Returns the exit code.  Throws Error.
int machines(const std::vector<std::string>& words);

// Surprising settings of a profile: one sentence for each, which says what to do.  `text`: the profile's file (TOML).
std::vector<std::string> surprises(const machine::Profile& profile, const std::string& text);

} // namespace filum::app::filum
