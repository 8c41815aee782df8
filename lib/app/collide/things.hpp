// What the commands about collisions read besides their stream; private to lib/app/collide.
#pragma once

#include "cli/command.hpp"
#include "collision/beads.hpp"
#include "collision/report.hpp"
#include "machine/profile.hpp"

#include <array>
#include <string>
#include <vector>

namespace filum::app::collide {

// What stands there from the start, by collision::Against.
struct Things {
    // Mesh files, commas between.  Throws Error: usage for an empty name, bad_input for what is no mesh.
    Things(const std::string& part, const std::string& fixture);

    std::array<std::vector<collision::Solid>, 4> solids;
    Notes notes;
    std::vector<stream::Setting> settings; // what identifies the files

  private:
    void meshes(const std::string& files, collision::Obstacle against);
};

// Throws Error(bad_input) if a coordinate of `what` is beyond 10000 m.
void check_place(const geom::Vec3& p, const std::string& what);

// The profile, with its own head unless another one is named; without a name, three axes and that head.
// Throws Error(usage) for changes without a profile.
machine::Profile profile_of(const std::string& name, const std::string& set, const machine::HeadChoice& head);

collision::Heads heads_of(const machine::Profile& profile); // of all tools
collision::Machine machine_of(const machine::Profile& profile);

// The head, as settings for the history.
void add_settings(const machine::Head& head, cli::Io& io);

// The list of collisions, if a file is named.
void write_places(const std::string& file, const collision::ReportInput& answer);

} // namespace filum::app::collide
