#include "app/slice/fitting.hpp"

#include "geom/vec.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <set>

namespace filum::app::slice {

namespace {

using filum::slice::Level;
using geom::Vec3;

constexpr double kTouch = 2 * filum::slice::kLift; // mm: boxes nearer than this touch, since meshes jitter
constexpr int kSections = 5;                       // heights at which two parts are compared
constexpr double kShared = 0.01;                   // share of the smaller sections that two parts may have in common
constexpr std::size_t kMostParts = 12;             // more parts than this are a plate, not a construct

// The box of a part as its file places it.
mesh::Box3 file_box(const BedPart& part) {
    const auto& t = part.placement.map.t;
    const Vec3 moved{t[0], t[1], t[2]};
    return {part.box.lo - moved, part.box.hi - moved};
}

// The sections of a part at these heights of its file, in the coordinates of the file.
std::vector<polygon::Loops> sections(const BedPart& part, const std::vector<double>& heights, int threads) {
    const auto& t = part.placement.map.t;
    std::vector<Level> levels;
    levels.reserve(heights.size());
    for (const double z : heights) levels.push_back({z + t[2], kTouch, z + t[2]});
    const auto sweep = filum::slice::sweep_over(*part.part, {}, levels, threads);
    std::vector<polygon::Loops> out;
    for (std::size_t chunk = 0; chunk < sweep.chunks(); ++chunk)
        for (polygon::Layer& layer : filum::slice::cut(sweep, chunk).layers) {
            for (geom::Vec2& p : layer.contours.points) p = p - geom::Vec2{t[0], t[1]};
            out.push_back(std::move(layer.contours));
        }
    return out;
}

bool fit(const BedPart& a, const BedPart& b, int threads) {
    const mesh::Box3 one = file_box(a), two = file_box(b);
    const Vec3 lo{std::max(one.lo.x, two.lo.x), std::max(one.lo.y, two.lo.y), std::max(one.lo.z, two.lo.z)};
    const Vec3 hi{std::min(one.hi.x, two.hi.x), std::min(one.hi.y, two.hi.y), std::min(one.hi.z, two.hi.z)};
    const Vec3 common = hi - lo;
    int flat = 0; // directions in which the boxes only touch
    for (const double length : {common.x, common.y, common.z}) {
        if (length < -kTouch) return false;
        if (length <= kTouch) ++flat;
    }
    if (flat > 0) return flat == 1;
    std::vector<double> heights;
    heights.reserve(kSections);
    for (int k = 0; k < kSections; ++k) heights.push_back(lo.z + (k + 0.5) / kSections * common.z);
    const auto first = sections(a, heights, threads), second = sections(b, heights, threads);
    double own = 0, other = 0, shared = 0; // mm2
    for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) {
        own += polygon::signed_area(first[k]);
        other += polygon::signed_area(second[k]);
        if (!first[k].empty() && !second[k].empty())
            shared += polygon::signed_area(polygon::intersect(first[k], second[k]));
    }
    return own > 0 && other > 0 && shared < kShared * std::min(own, other);
}

} // namespace

Notes fitting_parts(const std::vector<BedPart>& parts, int threads) {
    if (parts.size() < 2 || parts.size() > kMostParts) return {};
    std::set<std::size_t> fitting;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t k = i + 1; k < parts.size(); ++k) {
            if (parts[i].carved || parts[k].carved || !fit(parts[i], parts[k], threads)) continue;
            fitting.insert(i);
            fitting.insert(k);
        }
    if (fitting.empty()) return {};
    return {{.code = NoteCode::parts_fit, .amount = static_cast<double>(fitting.size()), .count = fitting.size()}};
}

} // namespace filum::app::slice
