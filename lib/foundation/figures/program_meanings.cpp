#include "figures/meanings.hpp"

namespace filum::figures {

namespace {

constexpr Meaning kHead[] = {
    {"head_moves", "moves", "*", "", 0, "points of the toolpath, or lines of the program, that were checked"},
    {"collisions", "moves", "colliding", "", 0, "of these, the number on which the head touches something"},
    {"step_mm", "moves", "step", "mm", 3, "resolution of the check"},
    {"clearance_beads_mm", "clearance", "beads", "mm", 4, "least distance of the head from beads; negative: depth"},
    {"clearance_beads_piece", "clearance", "beads to", "", 0, "text: the piece of the head that comes nearest"},
    {"clearance_beads_at", "clearance", "beads at", "", 0, "text: place"},
    {"clearance_part_mm", "clearance", "part", "mm", 4, "least distance from the part"},
    {"clearance_part_piece", "clearance", "part to", "", 0, "text: the piece of the head"},
    {"clearance_part_at", "clearance", "part at", "", 0, "text: place"},
    {"clearance_fixture_mm", "clearance", "fixture", "mm", 4, "least distance from the fixtures"},
    {"clearance_fixture_piece", "clearance", "fixture to", "", 0, "text: the piece of the head"},
    {"clearance_fixture_at", "clearance", "fixture at", "", 0, "text: place"},
    {"clearance_bed_mm", "clearance", "bed", "mm", 4, "least distance from the bed"},
    {"clearance_bed_piece", "clearance", "bed to", "", 0, "text: the piece of the head"},
    {"clearance_bed_at", "clearance", "bed at", "", 0, "text: place"},
    {"program_lines", "program", "lines that move", "", 0, "lines of a program that move"},
    {"program_lines_unknown", "program", "from or to an unknown place", "", 0,
     "lines that move from or to a place that is not known yet; they are not checked"},
    {"program_lines_other", "program", "other lines", "", 0, "lines that do not move"},
};

constexpr Meaning kJob[] = {
    {"tool.*.strokes", "tool *", "strokes", "", 0, "runs of moves of the tool with material"},
    {"tool.*.cuts", "tool *", "cuts", "", 0, "cuts of the fibre: one per stroke"},
    {"tool.*.laid_mm", "tool *", "laid", "mm", 1, "length along the path"},
    {"tool.*.fibre_used_mm", "tool *", "fibre used", "mm", 1,
     "length on the path, and length pushed out before each stroke"},
    {"tool.*.travel_mm", "tool *", "travel", "mm", 1, "length of travels, with lifts and approaches"},
    {"tool.*.material_mm3", "tool *", "material", "mm3", 2, "volume times the profile's flow"},
    {"tool.*.mass_g", "tool *", "mass", "g", 3, "volume times the density of the profile; absent if it has none"},
    {"tool.*.cost", "tool *", "cost", "", 2, "mass times the price of the material, extrusion.cost of the profile"},
    {"tool.*.print_time_s", "tool *", "print time", "s", 1, "time with material"},
    {"tool.*.travel_time_s", "tool *", "travel time", "s", 1, "time of its travels"},
    {"job.strokes", "job", "strokes", "", 0, "the sum over all tools"},
    {"job.cuts", "job", "cuts", "", 0, "the sum over all tools"},
    {"job.laid_mm", "job", "laid", "mm", 1, "the sum over all tools"},
    {"job.fibre_used_mm", "job", "fibre used", "mm", 1, "the sum over all tools"},
    {"job.travel_mm", "job", "travel", "mm", 1, "the sum over all tools"},
    {"job.material_mm3", "job", "material", "mm3", 2, "the sum over all tools"},
    {"job.mass_g", "job", "mass", "g", 3, "the sum over all tools"},
    {"job.cost", "job", "cost", "", 2,
     "mass times the price of the material, extrusion.cost of the profile, in its money"},
    {"job.print_time_s", "job", "print time", "s", 1, "the sum over all tools"},
    {"job.travel_time_s", "job", "travel time", "s", 1, "the sum over all tools"},
};

} // namespace

std::span<const Meaning> head_meanings() { return kHead; }
std::span<const Meaning> job_meanings() { return kJob; }

} // namespace filum::figures
