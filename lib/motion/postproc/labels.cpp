#include "postproc/labels.hpp"

#include "base/number.hpp"
#include "base/printable.hpp"
#include "geom/segment.hpp"

#include <algorithm>
#include <limits>

namespace filum::postproc {

namespace {

// The distance from a part's outline, mm; 0 within it.
double distance_to(const LabelledPart& part, Vec2 at) {
    const auto& ring = part.outline;
    bool within = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        within = within && geom::orient(a, b, at) >= 0;
        nearest = std::min(nearest, geom::point_segment_distance(a, b, at));
    }
    return within ? 0 : nearest;
}

std::string point(Vec2 p) { return fixed_text(p.x, 3) + "," + fixed_text(p.y, 3); }

} // namespace

std::vector<LabelledPart> with_plain_names(std::vector<LabelledPart> parts) {
    std::vector<std::string> words;
    words.reserve(parts.size());
    for (const LabelledPart& part : parts) words.push_back(plain_word(part.name, "part"));
    words = told_apart(words);
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].name = std::move(words[i]);
    return parts;
}

std::size_t part_at(const std::vector<LabelledPart>& parts, Vec2 at) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double d = distance_to(parts[i], at);
        if (d < least) {
            least = d;
            best = i;
        }
    }
    return best;
}

std::vector<std::string> define_parts(machine::Objects how, const std::vector<LabelledPart>& parts, Vec2 shift) {
    if (how == machine::Objects::m486) return {"M486 T" + std::to_string(parts.size())};
    std::vector<std::string> out;
    for (const LabelledPart& part : parts) {
        geom::Box2 box;
        std::string ring;
        for (const Vec2& p : part.outline) {
            box.add(p + shift);
            ring += (ring.empty() ? "[" : ",[") + point(p + shift) + "]";
        }
        out.push_back("EXCLUDE_OBJECT_DEFINE NAME=" + part.name + " CENTER=" + point(0.5 * (box.lo + box.hi)) +
                      " POLYGON=[" + ring + "]");
    }
    return out;
}

std::vector<std::string> begin_part(machine::Objects how, const std::vector<LabelledPart>& parts, std::size_t part,
                                    bool first) {
    if (how == machine::Objects::exclude_object) return {"EXCLUDE_OBJECT_START NAME=" + parts[part].name};
    std::vector<std::string> out{"M486 S" + std::to_string(part)};
    if (first) out.push_back("M486 A" + parts[part].name);
    return out;
}

std::string end_part(machine::Objects how, const std::vector<LabelledPart>& parts, std::size_t part) {
    return how == machine::Objects::exclude_object ? "EXCLUDE_OBJECT_END NAME=" + parts[part].name : "M486 S-1";
}

} // namespace filum::postproc
