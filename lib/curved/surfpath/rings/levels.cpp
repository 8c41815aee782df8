#include "surfpath/rings/levels.hpp"

#include "geodesic/query.hpp"
#include "geodesic/superlevel_set.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/line.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace filum::surfpath::rings {

namespace {

using geodesic::EdgePlace;
using geodesic::SuperlevelSet;
using surface::Isoline;
using surface::kNone;
using surface::Surface;

struct LevelIsolines {
    std::vector<double> levels;
    std::vector<Isoline> lines; // closed
    std::vector<EdgePlace> begins;
    std::vector<std::size_t> first; // per level, and one more: index of its first line
};

LevelIsolines level_isolines(const Surface& s, const geodesic::ExactField& field, std::vector<double> levels) {
    LevelIsolines out;
    std::vector<EdgePlace> begins;
    auto lines = geodesic::isolines(s, field, levels, &begins);
    out.levels = std::move(levels);
    std::size_t i = 0;
    for (const double level : out.levels) {
        out.first.push_back(out.lines.size());
        for (; i < lines.size() && lines[i].level == level; ++i) {
            if (!lines[i].closed) continue;
            out.lines.push_back(std::move(lines[i]));
            out.begins.push_back(begins[i]);
        }
    }
    out.first.push_back(out.lines.size());
    return out;
}

class RingLevels {
  public:
    RingLevels(const Surface& s, const geodesic::ExactField& field, const BranchOptions& o)
        : s_(s), field_(field), o_(o) {
        std::vector<double> even;
        const double top = geodesic::farthest(s, field);
        for (double i = 0.5; i * o.spacing < top; ++i) even.push_back(i * o.spacing);
        even_ = level_isolines(s, field, geodesic::off_vertices(std::move(even), field.distance, o.spacing));
    }

    Levels run(Facts& facts, Notes& notes) {
        find_isles();
        branches_ = rings::branches(isles_, o_, branch_of_);
        report(facts, notes);
        return chosen();
    }

  private:
    template <class F>
    void each_level(std::size_t count, const F& f) const {
        parallel::for_chunks(count, 1, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) f(i);
        });
    }

    void find_isles() {
        const std::size_t n = even_.levels.size();
        struct LevelIsles {
            // the isle of each line of the level; the isle that contains each line of the next level
            std::vector<std::uint32_t> parts{}, outer{};
            std::vector<double> highest{};
        };
        std::vector<LevelIsles> found(n);
        each_level(n, [&](std::size_t i) {
            const SuperlevelSet beyond(s_, field_, even_.levels[i]);
            for (std::size_t l = even_.first[i]; l < even_.first[i + 1]; ++l) {
                found[i].parts.push_back(beyond.component(even_.begins[l]));
                found[i].highest.push_back(found[i].parts.back() == kNone ? 0 : beyond.highest(found[i].parts.back()));
            }
            for (std::size_t l = even_.first[i + 1]; i + 1 < n && l < even_.first[i + 2]; ++l)
                found[i].outer.push_back(beyond.component(even_.begins[l]));
        });
        isle_.resize(n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < found[i].parts.size(); ++k) {
                const std::uint32_t part = found[i].parts[k];
                if (part == kNone) continue;
                const Isoline& line = even_.lines[even_.first[i] + k];
                const double length = surface::curve::length(surface::curve::line(line));
                const auto [at, fresh] = isle_[i].insert({part, static_cast<std::uint32_t>(isles_.size())});
                if (fresh)
                    isles_.push_back({static_cast<std::uint32_t>(i), i > 0 ? isle(i - 1, found[i - 1].outer[k]) : kNone,
                                      found[i].highest[k], 0, 0, line.points[0]});
                Isle& own = isles_[at->second];
                own.around += length;
                own.longest = std::max(own.longest, length);
            }
    }

    [[nodiscard]] std::uint32_t isle(std::size_t level, std::uint32_t part) const {
        const auto at = isle_[level].find(part);
        return at == isle_[level].end() ? kNone : at->second;
    }

    // The isolines at the levels of all branches, each on its own branch only.
    [[nodiscard]] Levels chosen() {
        std::map<double, std::vector<std::pair<std::uint32_t, std::uint32_t>>> wanted; // branch and ring, by level
        for (std::uint32_t b = 0; b < branches_.size(); ++b)
            for (std::uint32_t k = 0; k < branches_[b].levels.size(); ++k)
                wanted[branches_[b].levels[k]].push_back({b, isles_[branches_[b].first].ring + k});
        Levels out;
        for (const auto& [level, by] : wanted) {
            out.at.push_back(level);
            out.ring.push_back(by[0].second);
        }
        out.at = geodesic::off_vertices(std::move(out.at), field_.distance, o_.spacing);
        LevelIsolines all = at_levels(out.at);
        const std::vector<std::uint32_t> owner = owners(all);
        auto by = wanted.begin();
        for (std::uint32_t i = 0; i < out.at.size(); ++i, ++by)
            for (std::size_t l = all.first[i]; l < all.first[i + 1]; ++l) {
                const auto takes = [&](const auto& one) { return one.first == owner[l]; };
                if (std::none_of(by->second.begin(), by->second.end(), takes)) continue;
                out.lines.push_back(std::move(all.lines[l]));
                out.begins.push_back(all.begins[l]);
                out.of.push_back(i);
            }
        return out;
    }

    // The isolines at `levels`; those at even levels are moved from even_.
    [[nodiscard]] LevelIsolines at_levels(const std::vector<double>& levels) {
        std::vector<double> other;
        std::set_difference(levels.begin(), levels.end(), even_.levels.begin(), even_.levels.end(),
                            std::back_inserter(other));
        LevelIsolines moved = level_isolines(s_, field_, std::move(other)), out;
        out.levels = levels;
        for (const double level : levels) {
            const bool even = std::binary_search(even_.levels.begin(), even_.levels.end(), level);
            LevelIsolines& from = even ? even_ : moved;
            const auto i = static_cast<std::size_t>(std::lower_bound(from.levels.begin(), from.levels.end(), level) -
                                                    from.levels.begin());
            out.first.push_back(out.lines.size());
            for (std::size_t l = from.first[i]; l < from.first[i + 1]; ++l) {
                out.lines.push_back(std::move(from.lines[l]));
                out.begins.push_back(from.begins[l]);
            }
        }
        out.first.push_back(out.lines.size());
        return out;
    }

    // Per line the branch of the isle that contains it, at the highest even level not above the line's.
    [[nodiscard]] std::vector<std::uint32_t> owners(const LevelIsolines& all) const {
        if (branches_.size() == 1) return std::vector<std::uint32_t>(all.lines.size(), 0);
        std::vector<std::uint32_t> out(all.lines.size(), kNone);
        each_level(even_.levels.size(), [&](std::size_t i) {
            const auto begin = static_cast<std::size_t>(
                std::lower_bound(all.levels.begin(), all.levels.end(), even_.levels[i]) - all.levels.begin());
            const auto end = i + 1 == even_.levels.size()
                                 ? all.levels.size()
                                 : static_cast<std::size_t>(
                                       std::lower_bound(all.levels.begin(), all.levels.end(), even_.levels[i + 1]) -
                                       all.levels.begin());
            if (begin == end) return;
            const SuperlevelSet beyond(s_, field_, even_.levels[i]);
            for (std::size_t l = all.first[begin]; l < all.first[end]; ++l)
                if (const std::uint32_t own = isle(i, beyond.component(all.begins[l])); own != kNone)
                    out[l] = branch_of_[own];
        });
        return out;
    }

    void report(Facts& facts, Notes& notes) const {
        double open = 0, most = 0, strips = 0;
        const Branch* widest = nullptr;
        for (const Branch& b : branches_) {
            most = std::max(most, b.widest / o_.spacing);
            if (!(b.off > 0)) continue;
            ++open;
            strips += 2 * b.off;
            if (widest == nullptr || b.off > widest->off) widest = &b;
        }
        facts.push_back({"", "branches", static_cast<double>(branches_.size()), ""});
        facts.push_back({"", "branches-open", open, ""});
        facts.push_back({"", "spacing-change", most, ""});
        if (widest == nullptr) return;
        const geom::Vec3 at = isles_[widest->last].at;
        notes.push_back(
            {NoteCode::rings_below_maximum, strips, static_cast<std::uint64_t>(open), -1, at.x, at.y, at.z});
    }

    const Surface& s_;
    const geodesic::ExactField& field_;
    const BranchOptions& o_;
    LevelIsolines even_;
    // per even level: isles by the part that geodesic::SuperlevelSet numbers
    std::vector<std::map<std::uint32_t, std::uint32_t>> isle_;
    std::vector<Isle> isles_;
    std::vector<Branch> branches_;
    std::vector<std::uint32_t> branch_of_;
};

} // namespace

Levels levels(const Surface& s, const geodesic::ExactField& field, const BranchOptions& o, Facts& facts, Notes& notes) {
    return RingLevels(s, field, o).run(facts, notes);
}

} // namespace filum::surfpath::rings
