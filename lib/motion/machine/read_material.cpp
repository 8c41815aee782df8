#include "machine/read_material.hpp"

#include <array>

namespace filum::machine {

void read_extrusion(Document& doc, Extrusion& e) {
    doc.require("extrusion.kind");
    const std::array kinds{"filament", "plunger", "volume", "valve"};
    std::string kind = kinds[static_cast<std::size_t>(e.feeding)], mode = e.relative ? "relative" : "absolute",
                letter(1, e.letter);
    doc.choice("extrusion.kind", kind, {"filament", "plunger", "volume", "valve"});
    e.feeding = kind == "filament"  ? Feeding::filament
                : kind == "plunger" ? Feeding::plunger
                : kind == "volume"  ? Feeding::volume
                                    : Feeding::valve;
    doc.choice("extrusion.letter", letter, {"E", "A", "B", "C", "U", "V", "W"});
    e.letter = letter.front();
    doc.choice("extrusion.mode", mode, {"relative", "absolute"});
    e.relative = mode == "relative";
    if (e.relative && e.letter != 'E') doc.fail("extrusion.mode", "an axis other than E counts absolutely");
    if (e.feeding == Feeding::plunger || e.feeding == Feeding::filament) doc.require("extrusion.diameter");
    doc.number("extrusion.diameter", e.diameter, {0.1, 200});
    doc.number("extrusion.nozzle", e.nozzle, {0, 200});
    doc.number("extrusion.flow", e.flow, above_zero(100));
    doc.number("extrusion.density", e.density, {0, 100});
    doc.number("extrusion.cost", e.cost, {0, 1e9});
    doc.text("extrusion.on", e.on);
    doc.text("extrusion.off", e.off);
    doc.text("extrusion.on_trigger", e.on_trigger);
    doc.text("extrusion.off_trigger", e.off_trigger);
    if (e.on_trigger.empty() != e.off_trigger.empty())
        doc.fail("extrusion.on_trigger", "a trigger that opens needs one that closes, off_trigger, and it one");
    if (e.feeding == Feeding::valve && e.on_trigger.empty() && (e.on.empty() || e.off.empty()))
        doc.fail(e.on.empty() ? "extrusion.on" : "extrusion.off", "a valve needs codes to open and to close");
}

void read_limits(Document& doc, Limits& l) {
    doc.number("limits.section", l.section, above_zero(kInf));
    doc.number("limits.flow", l.flow, above_zero(kInf));
    doc.number("limits.layer_time", l.layer_time, {0, 1e5});
    doc.number("limits.least_feed", l.least_feed, {0, 1e5});
    doc.number("limits.turn_outside", l.turn_outside, {0, kInf});
    doc.pair("limits.width", l.narrowest, l.widest, {0, kInf});
    if (l.narrowest >= l.widest) doc.fail("limits.width", "the first number must be below the second");
}

void read_travel(Document& doc, Travel& t) {
    doc.number("travel.lift", t.lift, {0, 1000});
    doc.number("travel.above", t.above, {0, 1e5});
    doc.number("travel.retract", t.retract, {0, 1000});
    doc.number("travel.retract_speed", t.retract_speed, {0.001, 1e5});
    doc.number("travel.prime_speed", t.prime_speed, {0, 1e5});
    doc.number("travel.retract_acceleration", t.retract_acceleration, above_zero(kInf));
    doc.number("travel.extra", t.extra, {-1000, 1000});
    if (t.extra < -t.retract) doc.fail("travel.extra", "it takes back more than travel.retract gives");
    doc.number("travel.wipe", t.wipe, {0, 100});
    doc.number("travel.before_wipe", t.before_wipe, {0, 1});
    doc.number("travel.min_length", t.min_length, {0, 1e5});
    doc.text("travel.retract_codes", t.retract_codes);
    doc.text("travel.prime_codes", t.prime_codes);
    if (t.retract_codes.empty() != t.prime_codes.empty())
        doc.fail("travel.retract_codes", "retract_codes and prime_codes must be set together");
}

} // namespace filum::machine
