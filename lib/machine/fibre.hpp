// What a profile says of the tools of a machine, and of a head that lays continuous fibre.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace filum::machine {

class Document;

struct Tools {
    std::string change; // codes when another tool takes over, may be empty: there is no other
    int first = 0;      // {tool_no} of the toolpath's tool 0; the start template leaves that one in use
};

// The cutter sits `cut_to_nozzle` before the nozzle: the cut comes that much before the end of the stroke, and the
// tail, which nothing can be fed to any more, is dragged out.  So no shorter stroke can be laid.
struct Fibre {
    int tool = 1;             // strokes of this tool are of fibre
    double cut_to_nozzle = 0; // mm of fibre between cutter and nozzle; 0: there is no fibre head
    double least_path = 0;    // mm; a shorter stroke cannot be laid
    double most_path = 1e5;   // mm; nor can a longer one
    double spool = 0;         // mm of fibre for the whole program; 0: endless
    std::string cut, tension; // codes at the cut; of a pause that lets the tension settle
    std::string on, off;      // codes before and after a stroke, may be empty
    double cut_dwell = 0;     // s: what those codes take, {cut_dwell}, {cut_dwell_ms}
    double tension_dwell = 0; // s, {tension_dwell}, {tension_dwell_ms}; 0: no pause
    double tension_every = 0; // mm between pauses after the first, which comes behind the anchor; 0: no more
    double prime = 0;         // mm pushed in the air before each stroke
    double prime_speed = 3;   // mm/s
    double anchor = 5;        // mm at the start of a stroke that are laid slowly, and pushed
    double anchor_feed = 0.3; // mm/s
    double feed = 10;         // mm/s behind the anchor ...
    double tail_feed = 5;     // ... and after the cut
    bool push = false;        // fed all the way to the cut; else only over the anchor, then the nozzle pulls
    double ratio = 1;         // mm of fibre fed per mm of path, where it is fed
    double density = 0;       // g/cm3; 0: unknown
    bool omit_short = false;  // strokes below least_path are left out; else they are an error

    [[nodiscard]] bool active() const { return cut_to_nozzle > 0; }
    [[nodiscard]] bool lays(std::uint32_t with) const { return active() && with == static_cast<std::uint32_t>(tool); }
};

// Reads the sections [tools] and [fibre].  Throws Error(bad_input) as parse_profile does.
void read_tools(Document& doc, Tools& out);
void read_fibre(Document& doc, Fibre& out);

// What comes before a stretch of a stroke.
enum class Event : std::uint8_t { none, tension, cut };

// A stretch of a fibre stroke, by arc length from its start, mm.
struct Stretch {
    double from = 0, to = 0;
    double feed = 0; // mm/s
    double fed = 0;  // mm of fibre fed per mm of path
    Event before = Event::none;
};

// How a fibre stroke of `length` mm, which must be at least cut_to_nozzle, is laid: stretches of more than no length,
// one behind the other, from 0 to `length`.  The last one begins with the cut and is cut_to_nozzle long.
std::vector<Stretch> stretches(const Fibre& fibre, double length);

} // namespace filum::machine
