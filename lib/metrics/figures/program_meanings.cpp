#include "metrics/figures/meanings.hpp"

namespace filum::metrics::figures {

namespace {

constexpr Meaning kHead[] = {
    {"head_moves", "moves", "*", "", 0, "points of the toolpath, or lines of the program, that were looked at"},
    {"collisions", "moves", "colliding", "", 0, "of these, how many the head meets something on"},
    {"step_mm", "moves", "step", "mm", 3, "how closely moves were looked at"},
    {"clearance_beads_mm", "clearance", "beads", "mm", 4, "least distance of the head from beads; below 0: how deep"},
    {"clearance_beads_piece", "clearance", "beads to", "", 0, "text: which piece of the head comes so near"},
    {"clearance_beads_at", "clearance", "beads at", "", 0, "text: where"},
    {"clearance_part_mm", "clearance", "part", "mm", 4, "the same from the part"},
    {"clearance_part_piece", "clearance", "part to", "", 0, "text: which piece"},
    {"clearance_part_at", "clearance", "part at", "", 0, "text: where"},
    {"clearance_fixture_mm", "clearance", "fixture", "mm", 4, "the same from the fixtures"},
    {"clearance_fixture_piece", "clearance", "fixture to", "", 0, "text: which piece"},
    {"clearance_fixture_at", "clearance", "fixture at", "", 0, "text: where"},
    {"clearance_bed_mm", "clearance", "bed", "mm", 4, "the same from the bed"},
    {"clearance_bed_piece", "clearance", "bed to", "", 0, "text: which piece"},
    {"clearance_bed_at", "clearance", "bed at", "", 0, "text: where"},
    {"program_lines", "program", "lines that move", "", 0, "of a program: lines that move"},
    {"program_lines_unknown", "program", "from or to an unknown place", "", 0,
     "lines that move from or to a place that is not known yet: not looked at"},
    {"program_lines_other", "program", "other lines", "", 0, "lines that do not move"},
};

constexpr Meaning kJob[] = {
    {"tool.*.strokes", "tool *", "strokes", "", 0, "runs of moves of the tool that lay"},
    {"tool.*.cuts", "tool *", "cuts", "", 0, "of fibre: one per stroke"},
    {"tool.*.laid_mm", "tool *", "laid", "mm", 1, "along the path"},
    {"tool.*.fibre_used_mm", "tool *", "fibre used", "mm", 1, "laid, and pushed into the air before each stroke"},
    {"tool.*.travel_mm", "tool *", "travel", "mm", 1, "with lifts and approaches"},
    {"tool.*.material_mm3", "tool *", "material", "mm3", 2, "volume times the profile's flow"},
    {"tool.*.mass_g", "tool *", "mass", "g", 3, "by the density of the profile; left out where it has none"},
    {"tool.*.print_time_s", "tool *", "print time", "s", 1, "while it lays"},
    {"tool.*.travel_time_s", "tool *", "travel time", "s", 1, "while it travels"},
    {"job.strokes", "job", "strokes", "", 0, "the sum over all tools"},
    {"job.cuts", "job", "cuts", "", 0, "the sum over all tools"},
    {"job.laid_mm", "job", "laid", "mm", 1, "the sum over all tools"},
    {"job.fibre_used_mm", "job", "fibre used", "mm", 1, "the sum over all tools"},
    {"job.travel_mm", "job", "travel", "mm", 1, "the sum over all tools"},
    {"job.material_mm3", "job", "material", "mm3", 2, "the sum over all tools"},
    {"job.mass_g", "job", "mass", "g", 3, "the sum over all tools"},
    {"job.print_time_s", "job", "print time", "s", 1, "the sum over all tools"},
    {"job.travel_time_s", "job", "travel time", "s", 1, "the sum over all tools"},
};

} // namespace

std::span<const Meaning> head_meanings() { return kHead; }
std::span<const Meaning> job_meanings() { return kJob; }

} // namespace filum::metrics::figures
