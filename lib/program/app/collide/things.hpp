// The meshes, machine and files of the commands about collisions, `collide` and `route`.
#pragma once

#include "cli/command.hpp"
#include "collision/beads.hpp"
#include "collision/report.hpp"
#include "machine/profile.hpp"

#include <array>
#include <string>
#include <vector>

namespace filum::app::collide {

// The obstacles that are there from the start, indexed by collision::Obstacle.
struct Things {
    // `part`, `fixture`: names of mesh files, with commas between.  Throws Error: usage for an empty name, bad_input
    // for a file that is no mesh, and for a coordinate beyond 10000 m.
    Things(const std::string& part, const std::string& fixture);

    std::array<std::vector<collision::Solid>, 4> solids;
    Notes notes;
    std::vector<stream::Setting> settings; // checksums of the files

  private:
    void meshes(const std::string& files, collision::Obstacle against);
};

// Throws Error(bad_input) if a coordinate of `p` is beyond 10000 m.  `what`: the name of the input, for the message.
void check_place(const geom::Vec3& p, const std::string& what);

// The machine profile `name`, changed by `set`.  It has its own head unless `head` names another one.  Without a name
// the machine has three axes and the head that `head` describes.  Throws Error(usage) for changes without a name.
machine::Profile profile_of(const std::string& name, const std::string& set, const machine::HeadChoice& head);

collision::Heads heads_of(const machine::Profile& profile); // the heads of all tools
collision::Machine machine_of(const machine::Profile& profile);

// Adds the dimensions of the head to the settings in `io`, for the history.
void add_settings(const machine::Head& head, cli::Io& io);

// Writes the list of collisions to `file` (TSV); nothing if the name is empty.
void write_places(const std::string& file, const collision::ReportInput& answer);

} // namespace filum::app::collide
