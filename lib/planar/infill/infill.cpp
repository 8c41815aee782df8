#include "infill/infill.hpp"

#include "infill/cells.hpp"
#include "infill/corridors.hpp"
#include "infill/links.hpp"
#include "infill/opening.hpp"
#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"
#include "polygon/content_hash.hpp"

#include <algorithm>
#include <cmath>

namespace filum::infill {

namespace {

using polygon::InfillPattern;

constexpr double kSeam = 1e-3; // mm: cells of different parts are made larger by this, so that rounding leaves no gap
                               // along the border of the parts
constexpr double kWidest = 64; // spacings of endless lines: the widest that is tried
constexpr double kSame = 1e-3; // relative precision of the spacing
constexpr double kNear = 5e-3; // the same, if areas are filled to find it: a quarter of the 2 % tolerance of the share
constexpr std::size_t kTried = 48; // areas, at least, that are filled to measure how much corners take,
constexpr std::size_t kLeast = 9;  // or fewer, but as many as this,
constexpr double kEnough = 1e5;    // where they have this many mm of lines together: corners take little of large areas
constexpr int kRounds = 2;         // of filling
constexpr double kAround = 1.25;   // concentric lines, which come and go whole: the spacing is sought by filling,
                                   // within this factor
// Few lines: the spacing is sought by filling, within a factor of kFarther, at spacings that grow by kTrial.
constexpr double kFarther = 3, kTrial = 1.03;

// The area where loops may run.
Loops inner(const Loops& area, double bead_width) { return polygon::offset(area, -bead_width / 2, polygon::kBeadArc); }

// `lines` with a rim: `area` if they have none.
Lines drawn_in(const Loops& area, Lines lines) {
    if (lines.rim == nullptr) lines.rim = &area;
    return lines;
}

// Links the outlines of cells along a rim, which come near to each other where the rim does. Before that, gaps narrower
// than a bead are filled, then cells narrower than a bead left out.
Loops linked(const Loops& cells, const Loops& room, double w) {
    const Loops wide = polygon::intersect(polygon::closed(cells, w / 2, polygon::kBeadArc), room);
    return with_links(polygon::opened(wide, w / 2, polygon::kBeadArc), room, w);
}

// The loops in `room`, where they may run.
Loops loops_in(const Loops& room, const Loops& area, const Lines& o) {
    if (o.spacing >= kHollow || room.empty()) return {};
    const Loops cells = cells_in(room, drawn_in(area, o));
    return o.pattern == InfillPattern::concentric ? linked(cells, room, o.bead_width)
                                                  : opened_cells(cells, o.bead_width / 2);
}

// The parts of `room` where the lines of each task hold.
std::vector<Loops> divided(Loops room, std::span<const Task> parts) {
    std::vector<Loops> out;
    for (const Task& t : parts.first(parts.size() - 1)) {
        out.push_back(polygon::intersect(room, *t.area));
        if (!out.back().empty()) room = polygon::subtract(room, *t.area);
    }
    out.push_back(std::move(room));
    return out;
}

// True if two areas have the same loops.
bool alike(const Task& a, const Task& b) {
    const bool waves = a.lines.pattern == InfillPattern::wave, circles = a.lines.pattern == InfillPattern::concentric;
    return a.lines.pattern == b.lines.pattern && a.lines.direction == b.lines.direction &&
           (!waves || a.lines.z == b.lines.z) && a.area->start == b.area->start && a.area->points == b.area->points &&
           (!circles || a.lines.rim == b.lines.rim ||
            (a.lines.rim != nullptr && b.lines.rim != nullptr && a.lines.rim->points == b.lines.rim->points));
}

// Areas that are alike, as those of a prism's layers are, and their number.
struct Group {
    Task task;
    double count;
    Loops room; // where loops may run
};

std::vector<Group> groups(std::span<const Task> tasks, double bead_width) {
    const auto first = polygon::first_alike(
        tasks.size(),
        [&](std::size_t i) {
            polygon::ContentHash h;
            h.add(tasks[i].lines.direction);
            h.add(*tasks[i].area);
            return h.value();
        },
        [&](std::size_t i, std::size_t k) { return alike(tasks[i], tasks[k]); });
    std::vector<Group> out;
    std::vector<std::size_t> group(tasks.size());
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (first[i] == i) {
            group[i] = out.size();
            out.push_back({tasks[i], 0, inner(*tasks[i].area, bead_width)});
        }
        ++out[group[first[i]]].count;
    }
    return out;
}

// A sample of the areas, filled to measure the length of their loops.
class Sample {
  public:
    // `spacing`: about the spacing of the lines, mm.
    Sample(std::span<const Task> all, double spacing) {
        double lines = 0;
        for (const Task& t : all) lines += polygon::signed_area(*t.area) / spacing;
        const double enough = kEnough * static_cast<double>(all.size()) / std::max(lines, 1.0);
        const auto tried =
            static_cast<std::size_t>(std::clamp(enough, static_cast<double>(kLeast), static_cast<double>(kTried)));
        const std::size_t apart = std::max<std::size_t>(1, all.size() / tried);
        const std::size_t stride = apart - (apart % 2 == 0 ? 1 : 0); // odd, as directions alternate
        for (std::size_t i = stride / 2; i < all.size(); i += stride) add(all[i]);
        rooms_.resize(task_.size());
        parallel::for_chunks(task_.size(), 1, 0, [&](std::size_t k, std::size_t) {
            rooms_[k] = inner(*task_[k].area, task_[k].lines.bead_width);
        });
    }
    [[nodiscard]] double area() const {
        return sum([&](std::size_t k) { return polygon::signed_area(*task_[k].area); });
    }
    // mm of loops at this spacing
    [[nodiscard]] double laid(double spacing) const {
        std::vector<double> each(task_.size());
        parallel::for_chunks(task_.size(), 1, 0, [&](std::size_t k, std::size_t) {
            each[k] = length(loops_in(rooms_[k], *task_[k].area, lines(k, spacing)));
        });
        return sum([&](std::size_t k) { return each[k]; });
    }
    // The same by calculation.
    [[nodiscard]] double calculated(double spacing) const {
        return sum([&](std::size_t k) { return even_length(rooms_[k], lines(k, spacing)); });
    }

  private:
    void add(const Task& t) {
        for (std::size_t k = 0; k < task_.size(); ++k)
            if (alike(task_[k], t)) {
                ++count_[k];
                return;
            }
        task_.push_back(t);
        count_.push_back(1);
    }
    [[nodiscard]] Lines lines(std::size_t k, double spacing) const {
        Lines out = task_[k].lines;
        out.spacing = spacing;
        return out;
    }
    template <class Value>
    [[nodiscard]] double sum(Value&& value) const {
        double out = 0;
        for (std::size_t k = 0; k < task_.size(); ++k) out += count_[k] * value(k);
        return out;
    }

    std::vector<Task> task_;    // all different
    std::vector<double> count_; // areas like each
    std::vector<Loops> rooms_;
};

// The spacing between lo and hi at which `length_of` is `wanted`; hi if the length is greater even there. `from`: a
// first guess. Length times spacing changes little, so a guess times the ratio of lengths is a good next one.
template <class LengthOf>
double spacing_of(double lo, double hi, double wanted, double from, LengthOf&& length_of) {
    if (length_of(hi) > wanted) return hi;
    for (double at = from; hi - lo > kSame * lo;) {
        if (!(at > lo && at < hi)) at = (lo + hi) / 2;
        const double length = length_of(at);
        (length > wanted ? lo : hi) = at;
        // Less or more by half of the precision: so the bracket closes from both sides.
        at *= length / wanted * (length > wanted ? 1 + kSame / 2 : 1 - kSame / 2);
    }
    return (lo + hi) / 2;
}

// Seeks the spacing at which the loops of a sample have a length.
class Search {
  public:
    Search(const Sample& sample, double wanted, double from) : sample_(&sample), wanted_(wanted), best_(from) {}

    [[nodiscard]] double best() const { return best_; }
    [[nodiscard]] bool found() const { return off_ <= kNear; }

    // Returns by how many mm the loops are longer than wanted.
    double more(double spacing) {
        const double more = sample_->laid(spacing) - wanted_;
        // By their ratio, since widths of lines can make up for a ratio.
        const double laid = wanted_ + more, off = laid > 0 && wanted_ > 0 ? std::abs(std::log(laid / wanted_)) : 1e300;
        if (off < off_) {
            best_ = spacing;
            off_ = off;
        }
        return more;
    }
    // Bisects between a spacing with longer loops and one with shorter ones, the first not necessarily the lower one.
    void between(double longer, double shorter) {
        while (!found() && std::abs(shorter - longer) > kSame * longer) {
            const double middle = (longer + shorter) / 2;
            (more(middle) > 0 ? longer : shorter) = middle;
        }
    }
    // Tries spacings around `from`, in both directions, and bisects wherever the length passes the wanted one.
    void around(double from) {
        const double here = more(from);
        struct Side {
            double spacing, more, factor;
        } sides[] = {{from, here, kTrial}, {from, here, 1 / kTrial}};
        for (double reach = kTrial; reach < kFarther && !found(); reach *= kTrial)
            for (Side& side : sides) {
                const double next = side.spacing * side.factor, then = more(next);
                if ((then > 0) != (side.more > 0))
                    between(then > 0 ? next : side.spacing, then > 0 ? side.spacing : next);
                side.spacing = next;
                side.more = then;
            }
    }

  private:
    const Sample* sample_;
    double wanted_, best_; // mm of loops, mm
    double off_ = 1e300;   // logarithm of the ratio of the best length to the wanted one
};

// The spacing, among those tried around `from`, at which the loops of the sample are nearest to the wanted share.
double nearest_by_filling(const Sample& sample, double from, double density, double bead_width) {
    const double wanted = density * sample.area() / bead_width;
    Search search(sample, wanted, from);
    if (density < kFew) {
        search.around(from);
        return search.best();
    }
    double lo = from / kAround, hi = from * kAround;
    while (hi - lo > kNear * lo) {
        const double middle = (lo + hi) / 2;
        (search.more(middle) > 0 ? lo : hi) = middle;
    }
    return search.best();
}

} // namespace

Loops loops(const Loops& area, const Lines& o) { return loops_in(inner(area, o.bead_width), area, o); }

Loops loops(const Loops& area, std::span<const Task> parts) {
    if (parts.empty() || area.empty()) return {};
    const double w = parts[0].lines.bead_width;
    const Loops room = inner(area, w);
    const std::vector<Loops> rooms = divided(room, parts);
    const auto filled = std::count_if(rooms.begin(), rooms.end(), [](const Loops& r) { return !r.empty(); });
    Loops cells;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (filled == 1 && !rooms[k].empty()) return loops_in(room, area, parts[k].lines);
        if (parts[k].lines.spacing < kHollow) cells.add(cells_in(rooms[k], drawn_in(area, parts[k].lines)));
    }
    if (cells.empty()) return {};
    cells = polygon::offset(cells, kSeam, polygon::kBeadArc);
    if (std::any_of(parts.begin(), parts.end(),
                    [](const Task& t) { return t.lines.pattern == InfillPattern::concentric; }))
        return linked(cells, room, w);
    return with_corridors(opened_cells(cells, w / 2), room, w);
}

double length(const Loops& loops) {
    double sum = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) sum += polygon::perimeter(loops[i]);
    return sum;
}

double spacing_for(std::span<const Task> tasks, double density, double bead_width) {
    const std::vector<Group> all = groups(tasks, bead_width);
    double area = 0;
    for (const Group& g : all) area += g.count * polygon::signed_area(*g.task.area);
    const double wanted = density * area / bead_width, endless = bead_width / density;
    const auto by_calculation = [&](double spacing) {
        double sum = 0;
        for (const Group& g : all) {
            Lines lines = g.task.lines;
            lines.spacing = spacing;
            sum += g.count * even_length(g.room, lines);
        }
        return sum;
    };
    const Sample sample(tasks, endless);
    double laid = 1; // mm per calculated mm: corners are rounded, and narrow cells left out
    double spacing = spacing_of(bead_width, kWidest * endless, wanted, endless, by_calculation);
    for (int round = 0; round < kRounds; ++round) {
        const double calculated = sample.calculated(spacing), real = sample.laid(spacing);
        if (real > 0) laid = real / calculated;
        spacing = spacing_of(bead_width, kWidest * endless, wanted / laid, spacing, by_calculation);
    }
    const auto circles = [](const Task& t) { return t.lines.pattern == InfillPattern::concentric; };
    if (density >= kFew && std::none_of(tasks.begin(), tasks.end(), circles)) return spacing;
    return nearest_by_filling(sample, spacing, density, bead_width);
}

double share_laid(std::span<const Task> tasks, double spacing, double bead_width) {
    const Sample sample(tasks, spacing);
    return bead_width * sample.laid(spacing) / sample.area();
}

} // namespace filum::infill
