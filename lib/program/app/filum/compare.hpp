// `filum compare`: compares the algorithms of surfpath on one surface, in a table and in pictures.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

inline constexpr const char* kCompareHelp =
    "usage: filum compare MESH|SURFACE [OPTIONS] -o FOLDER\n\n"
    "Lays a path on the surface by each algorithm of surfpath, from where 'choose' finds it best, and prints a table:\n"
    "coverage, cuts, overlap, length that turns tighter than --min-radius and than 0.45 spacings, length of fibre.\n"
    "The folder gets table.tsv, of each algorithm ALGORITHM.surface, .toolpath and .png, and index.html with the\n"
    "table and the pictures.\n\n"
    "Options are those of geodesic (--cut, --remesh ...), choose and surfpath (--spacing, --min-radius ...); each goes "
    "to\n"
    "every stage that has it. An algorithm that finds no path has a line without figures that says why.\n\n"
    "  -o, --output FOLDER   where to write; made if it is not there\n"
    "  --among NAME,...      only these algorithms\n"
    "  --dry-run             print the commands instead of running them\n";

// Runs the command; `words` are its arguments.  Returns the exit code.  Throws Error.
int compare(const std::vector<std::string>& words);

} // namespace filum::app::filum
