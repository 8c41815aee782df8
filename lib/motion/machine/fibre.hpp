// The tools of a machine, and a head that lays continuous fibre: [tools] and [fibre] of a profile.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace filum::machine {

class Document;

struct Tools {
    std::string change; // codes when another tool takes over; "": there is no other
    double raised = 0;  // mm that the tips of idle tools on the carriage are above their tips in use
    int first = 0;      // {tool_no} of the toolpath's tool 0, which is in use after the start template
};

// The cutter sits `cut_to_nozzle` before the nozzle, so the cut is that much before the end of the stroke.  After the
// cut nothing can be fed: the nozzle drags the tail out.  So no stroke can be shorter than `cut_to_nozzle`.
struct Fibre {
    int tool = 1;             // the tool that lays fibre
    double cut_to_nozzle = 0; // mm of fibre between cutter and nozzle; 0: there is no fibre head
    double least_path = 0;    // mm: shortest stroke
    double most_path = 1e5;   // mm: longest stroke
    double spool = 0;         // mm of fibre for the whole program; 0: no limit
    std::string cut, tension; // codes at the cut; codes of a pause that lets the tension settle
    std::string on, off;      // codes before and after a stroke; "": none
    double cut_dwell = 0;     // s, duration of the codes at the cut, {cut_dwell}, {cut_dwell_ms}
    double tension_dwell = 0; // s, {tension_dwell}, {tension_dwell_ms}; 0: no pause
    double tension_every = 0; // mm between pauses; the first is after the anchor; 0: only the first
    double prime = 0;         // mm pushed into the air before each stroke
    double prime_speed = 3;   // mm/s
    double anchor = 5;        // mm at the start of a stroke that are laid slowly, with the fibre fed
    double anchor_feed = 0.3; // mm/s
    double feed = 10;         // mm/s after the anchor
    double tail_feed = 5;     // mm/s after the cut
    bool push = false;        // fibre is fed up to the cut; else only over the anchor, then it is pulled
    double ratio = 1;         // mm of fibre fed per mm of path, where it is fed
    double density = 0;       // g/cm3; 0: unknown
    bool omit_short = false;  // strokes shorter than least_path are left out; else they are an error

    [[nodiscard]] bool active() const { return cut_to_nozzle > 0; }
    [[nodiscard]] bool lays(std::uint32_t with) const { return active() && with == static_cast<std::uint32_t>(tool); }
};

// Reads the sections [tools] and [fibre].  Throws Error(bad_input) as parse_profile does.
void read_tools(Document& doc, Tools& out);
void read_fibre(Document& doc, Fibre& out);

// The event before a stretch of a stroke.
enum class Event : std::uint8_t { none, tension, cut };

// A stretch of a fibre stroke, by arc length from its start, mm.
struct Stretch {
    double from = 0, to = 0;
    double feed = 0; // mm/s
    double fed = 0;  // mm of fibre fed per mm of path
    Event before = Event::none;
};

// Divides a fibre stroke of `length` mm, at least cut_to_nozzle, into stretches.  They follow one another from 0 to
// `length`, and none is empty.  The last one begins with the cut and is cut_to_nozzle long.
std::vector<Stretch> stretches(const Fibre& fibre, double length);

} // namespace filum::machine
