#include "machine/fibre.hpp"

#include "base/number.hpp"
#include "machine/reader.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace filum::machine {

namespace {

constexpr double kSpeed = 1e5;      // mm/s
constexpr double kPath = 1e6;       // mm
constexpr double kLeast = 1;        // mm from cutter to nozzle
constexpr double kEvery = 1;        // mm: least distance between tension pauses
constexpr double kDwell = 3600;     // s
constexpr double kNoStretch = 1e-9; // mm

void lengths(Document& doc, Fibre& f) {
    f.least_path = f.cut_to_nozzle;
    doc.number("fibre.least_path", f.least_path, {0, kPath});
    if (f.least_path < f.cut_to_nozzle)
        doc.fail("fibre.least_path", "it must not be below cut_to_nozzle, " + shortest_text(f.cut_to_nozzle) +
                                         ": the cutter reaches no shorter stroke");
    doc.number("fibre.most_path", f.most_path, {0, kPath, true});
    if (f.most_path < f.least_path)
        doc.fail("fibre.most_path", "it must not be below least_path, " + shortest_text(f.least_path));
    doc.number("fibre.spool", f.spool, {0, 1e9});
    doc.number("fibre.prime", f.prime, {0, 1000});
    doc.number("fibre.anchor", f.anchor, {0, kPath});
    doc.number("fibre.tension_every", f.tension_every, {0, kPath});
    if (f.tension_every > 0 && f.tension_every < kEvery)
        doc.fail("fibre.tension_every", "it must be 0, for no more pauses, or at least " + shortest_text(kEvery));
}

} // namespace

void read_tools(Document& doc, Tools& t) {
    doc.text("tools.change", t.change);
    doc.number("tools.raised", t.raised, {0, 1e4});
    doc.whole("tools.first", t.first, 0, 1000);
}

void read_fibre(Document& doc, Fibre& f) {
    doc.number("fibre.cut_to_nozzle", f.cut_to_nozzle, {0, 1e4});
    if (f.active() && f.cut_to_nozzle < kLeast)
        doc.fail("fibre.cut_to_nozzle", "it must be 0, for no fibre head, or at least " + shortest_text(kLeast));
    doc.whole("fibre.tool", f.tool, 0, 1000);
    lengths(doc, f);
    doc.text("fibre.cut", f.cut);
    doc.text("fibre.tension", f.tension);
    doc.text("fibre.on", f.on);
    doc.text("fibre.off", f.off);
    doc.number("fibre.cut_dwell", f.cut_dwell, {0, kDwell});
    doc.number("fibre.tension_dwell", f.tension_dwell, {0, kDwell});
    const std::pair<const char*, double*> speeds[] = {{"fibre.prime_speed", &f.prime_speed},
                                                      {"fibre.anchor_feed", &f.anchor_feed},
                                                      {"fibre.feed", &f.feed},
                                                      {"fibre.tail_feed", &f.tail_feed}};
    for (const auto& [key, speed] : speeds) doc.number(key, *speed, {0.01, kSpeed});
    std::string mode = "pull";
    doc.choice("fibre.mode", mode, {"pull", "push"});
    f.push = mode == "push";
    doc.number("fibre.ratio", f.ratio, {0, 100, true});
    doc.number("fibre.density", f.density, {0, 100});
    if (f.active() && f.cut.empty()) doc.fail("fibre.cut", "a fibre head needs the codes that cut");
    if (!f.active() && !f.cut.empty())
        doc.fail("fibre.cut_to_nozzle", "a fibre head needs its distance from cutter to nozzle, above 0");
    if (f.tension_dwell > 0 && f.tension.empty())
        doc.fail("fibre.tension", "a pause of tension_dwell seconds needs the codes that wait");
}

std::vector<Stretch> stretches(const Fibre& f, double length) {
    const double cut = std::max(0.0, length - f.cut_to_nozzle);
    const double anchored = std::min(f.anchor, cut);
    const bool pauses = f.tension_dwell > 0;
    std::vector<Stretch> out;
    const auto add = [&out](const Stretch& s) {
        if (s.to - s.from > kNoStretch) out.push_back(s);
    };
    add({0, anchored, f.anchor_feed, f.ratio, Event::none});
    const double step = pauses && f.tension_every > 0 ? f.tension_every : std::numeric_limits<double>::infinity();
    // Each place is computed from its number, so that no rounding error adds up.
    for (double k = 0, from = anchored; from < cut; ++k) {
        const double to = std::min(anchored + (k + 1) * step, cut);
        add({from, to, f.feed, f.push ? f.ratio : 0, pauses && from > 0 ? Event::tension : Event::none});
        from = to;
    }
    add({cut, length, f.tail_feed, 0, Event::cut});
    return out;
}

} // namespace filum::machine
