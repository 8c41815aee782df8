#include "collision/room.hpp"

#include <algorithm>
#include <cmath>

namespace filum::collision {

namespace {

constexpr double kStep = 0.02; // mm: movement of points of the head within the shortest pieces

// The first place between two shares of a move at which stand(share, half) finds no room.
template <class Look>
std::optional<double> first(double begin, double end, int depth, const Look& look) {
    const double middle = (begin + end) / 2;
    const auto near = look(middle, (end - begin) / 2);
    if (near == Tree::Proximity::nothing) return std::nullopt;
    if (near == Tree::Proximity::steady || depth == kHalvings) return middle;
    if (const auto found = first(begin, middle, depth + 1, look)) return found;
    return first(middle, end, depth + 1, look);
}

} // namespace

Room::Room(const Scene& scene, const Shape& shape, const Options& options, double more)
    : scene_(&scene), shape_(&shape), options_(&options), more_(more) {}

Probe Room::probe(const ToolFrame& stance, std::uint32_t before, std::size_t kind) const {
    const bool beads = static_cast<Obstacle>(kind) == Obstacle::beads;
    const double demanded = beads ? options_->margin - options_->press : std::max(options_->margin + more_, kTouch);
    return {stance, beads ? before : 1, options_->press, demanded};
}

bool Room::at(const ToolFrame& stance, std::uint32_t before) const {
    for (std::size_t k = 0; k < scene_->size(); ++k)
        if ((*scene_)[k].any(*shape_, probe(stance, before, k), {stance, stance}, 0) != Tree::Proximity::nothing)
            return false;
    return true;
}

std::optional<double> Room::blocked(const Move& m) const {
    const Motion all = motion(m);
    std::optional<double> out;
    for (std::size_t k = 0; k < scene_->size(); ++k) {
        const Tree& tree = (*scene_)[k];
        if (tree.empty()) continue;
        const auto found = first(0, out.value_or(1), 0, [&](double middle, double half) {
            Probe p = probe(collision::at(m, middle), m.before, k);
            p.shift = half * all.length;
            p.turn = half * all.turn;
            p.sink = half * std::abs(dot(all.way, p.stance.axis));
            auto near = tree.any(*shape_, p, {collision::at(m, middle - half), collision::at(m, middle + half)}, kStep);
            if (near != Tree::Proximity::steady) return near;
            p.shift = p.turn = p.sink = 0;
            return tree.any(*shape_, p, {p.stance, p.stance}, 0);
        });
        if (found) out = found;
    }
    return out;
}

} // namespace filum::collision
