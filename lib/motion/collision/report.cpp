#include "collision/report.hpp"

#include "base/number.hpp"
#include "figures/meanings.hpp"

namespace filum::collision {

namespace {

const char* name(Obstacle a) { return kAgainstNames[static_cast<std::size_t>(a)]; }
const char* name(HeadPiece p) { return kPieceNames[static_cast<std::size_t>(p)]; }
const char* name(Source s) { return s == Source::line ? "line" : "point"; }

std::string text(const Vec3& p) {
    return "x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) + ", z " + fixed_text(p.z, 3);
}

std::string where(const ReportInput& a, const Place& p) {
    const Move& m = a.moves[p.move];
    std::string out = text(p.tip) + " (";
    if (a.source == Source::point)
        out += "layer " + std::to_string(m.layer) + ", stroke " + std::to_string(m.stroke) + ", ";
    return out + name(a.source) + " " + std::to_string(m.source) + ")";
}

const char* clearance_name(Obstacle a) {
    constexpr std::array<const char*, 4> names{"clearance-beads", "clearance-part", "clearance-fixture",
                                               "clearance-bed"};
    return names[static_cast<std::size_t>(a)];
}

std::size_t sources(const ReportInput& a) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < a.moves.size(); ++i) out += i == 0 || a.moves[i].source != a.moves[i - 1].source;
    return out;
}

} // namespace

std::size_t colliding(const ReportInput& a) {
    std::size_t out = 0;
    std::int64_t last = -1;
    for (const Place& p : a.found.collisions) {
        const std::int64_t source = a.moves[p.move].source;
        out += source != last;
        last = source;
    }
    return out;
}

std::string complaint(const ReportInput& a) {
    const Place& first = a.found.collisions.front();
    const Move& m = a.moves[first.move];
    return "the head collides at " + std::to_string(colliding(a)) + " of " + std::to_string(sources(a)) + " " +
           name(a.source) + "s; first the " + name(first.piece) + " meets the " + name(first.against) +
           (m.travel ? " on a travel" : "") + ", the tip at " + where(a, first) +
           "; use a slimmer head, continue with --strict=false, or look at it: 'collide --places LIST', 'render "
           "--collisions "
           "LIST'";
}

Notes notes(const ReportInput& a) {
    constexpr std::array kMeets{NoteCode::head_meets_beads, NoteCode::head_meets_part, NoteCode::head_meets_fixture,
                                NoteCode::head_meets_bed};
    static_assert(kMeets.size() == kAgainstNames.size());
    Notes out;
    for (std::size_t k = 0; k < kAgainstNames.size(); ++k) {
        Note note;
        note.code = kMeets[k];
        note.count = 0;
        for (const Place& p : a.found.collisions) {
            if (static_cast<std::size_t>(p.against) != k) continue;
            const double depth = std::max(0.0, a.options.margin - p.clearance);
            if (note.count++ == 0 || depth > note.amount) {
                note.amount = depth;
                note.layer = a.moves[p.move].layer;
                note.x = p.tip.x;
                note.y = p.tip.y;
                note.z = p.tip.z;
            }
        }
        if (note.count > 0) out.push_back(note);
    }
    return out;
}

Facts facts(const ReportInput& a) {
    Facts out{{"", "moves", static_cast<double>(sources(a)), ""},
              {"", "colliding-moves", static_cast<double>(colliding(a)), ""},
              {"", "step", a.options.step, "mm"}};
    for (const auto& least : a.found.least)
        if (least) out.push_back({"", clearance_name(least->against), least->clearance, "mm"});
    return out;
}

figures::Figures summary(const ReportInput& a) {
    figures::Figures out;
    const auto tell = [&](const std::string& key, decltype(figures::Figure::value) value, const std::string& of = {}) {
        figures::tell(out, figures::head_meanings(), key, std::move(value), of);
    };
    tell("head_moves", std::uint64_t{sources(a)}, std::string(name(a.source)) + "s");
    tell("collisions", std::uint64_t{colliding(a)});
    tell("step_mm", a.options.step);
    for (const auto& least : a.found.least) {
        if (!least) continue;
        const std::string key = std::string("clearance_") + name(least->against);
        tell(key + "_mm", least->clearance);
        tell(key + "_piece", std::string(name(least->piece)));
        tell(key + "_at", where(a, *least));
    }
    return out;
}

std::string places(const ReportInput& a) {
    std::string out = std::string(name(a.source)) + "\tlayer\tstroke\tmove\tmeets\twith\tclearance\tx\ty\tz\ti\tj\tk\n";
    for (const Place& p : a.found.collisions) {
        const Move& m = a.moves[p.move];
        const Vec3 axis = at(m, p.along).axis;
        out += std::to_string(m.source) + "\t" + std::to_string(m.layer) + "\t" + std::to_string(m.stroke) + "\t" +
               (m.travel ? "travel" : "bead") + "\t" + name(p.against) + "\t" + name(p.piece) + "\t" +
               fixed_text(p.clearance, 4) + "\t" + fixed_text(p.tip.x, 4) + "\t" + fixed_text(p.tip.y, 4) + "\t" +
               fixed_text(p.tip.z, 4) + "\t" + fixed_text(axis.x, 6) + "\t" + fixed_text(axis.y, 6) + "\t" +
               fixed_text(axis.z, 6) + "\n";
    }
    return out;
}

} // namespace filum::collision
