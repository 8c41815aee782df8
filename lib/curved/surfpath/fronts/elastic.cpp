#include "surfpath/fronts/elastic.hpp"

#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath::fronts {

namespace {

using surface::kNone;

constexpr double kOver = 1.6; // over-relaxation
// Slope relative to a rim from which on the rim does not pull a line. It is less than rules::kAlong, since the pull
// turns lines away from their right angle to the source.
constexpr double kSteepest = 0.2;
// Smoothings after the relaxation: without them the lines' direction changes by twice as much from step to step.
constexpr int kSmoothings = 4;

// A spot of a line with its neighbours along the front and along the line.
struct Knot {
    std::uint32_t left = kNone, right = kNone, before = kNone, behind = kNone;
    double left_gap = 0, right_gap = 0; // mm, before anything moved
    double rim = 0, rim_weight = 0;     // mm by which it is too near to rims, and the weight of that
    double moved = 0;                   // mm along the front
    bool held = false;
};

class ElasticSheet {
  public:
    ElasticSheet(const std::vector<FrontLine>& lines, const Fronts& fronts, double d) : fronts_(fronts), d_(d) {
        for (const FrontLine& s : lines) {
            first_.push_back(static_cast<std::uint32_t>(knots_.size()));
            for (std::size_t j = 0; j < s.spots.size(); ++j) {
                Knot k;
                const auto own = static_cast<std::uint32_t>(knots_.size());
                if (j > 0) k.before = own - 1;
                if (j + 1 < s.spots.size()) k.behind = own + 1;
                k.held = s.first + j == 0;
                knots_.push_back(k);
            }
        }
        std::vector<std::vector<FrontKnot>> rows(fronts.levels());
        for (std::size_t i = 0; i < lines.size(); ++i)
            for (std::size_t j = 0; j < lines[i].spots.size(); ++j)
                rows[lines[i].first + j].push_back({lines[i].spots[j], first_[i] + static_cast<std::uint32_t>(j)});
        for (std::size_t level = 0; level < rows.size(); ++level) connect(level, rows[level]);
        for (std::size_t i = 0; i < lines.size(); ++i) add_rims(lines[i], first_[i]);
    }

    void relax() {
        for (int sweep = 0; sweep < rules::kMostSweeps; ++sweep) {
            double most = 0;
            for (Knot& k : knots_)
                if (!k.held) most = std::max(most, std::abs(pull(k)));
            if (most < rules::kRest * d_) break;
        }
        for (int i = 0; i < kSmoothings; ++i) smooth();
    }

    [[nodiscard]] double moved(std::size_t line, std::size_t spot) const { return knots_[first_[line] + spot].moved; }

  private:
    struct FrontKnot {
        Spot spot;
        std::uint32_t knot;
    };

    void connect(std::size_t level, std::vector<FrontKnot>& row) {
        std::stable_sort(row.begin(), row.end(), [](const FrontKnot& a, const FrontKnot& b) {
            return a.spot.front != b.spot.front ? a.spot.front < b.spot.front : a.spot.x < b.spot.x;
        });
        for (std::size_t begin = 0, i = 0; i < row.size(); ++i) {
            const FrontKnot& here = row[i];
            if (i == 0 || row[i - 1].spot.front != here.spot.front)
                begin = i;
            else
                link(row[i - 1].knot, here.knot, here.spot.x - row[i - 1].spot.x);
            const Front& front = fronts_.at(level)[here.spot.front];
            const bool last = i + 1 == row.size() || row[i + 1].spot.front != here.spot.front;
            if (last && front.line.closed && i > begin + 1)
                link(here.knot, row[begin].knot, row[begin].spot.x + front.length() - here.spot.x);
        }
    }

    void link(std::uint32_t a, std::uint32_t b, double gap) {
        if (gap > rules::kBeside * d_) return;
        knots_[a].right = b;
        knots_[a].right_gap = gap;
        knots_[b].left = a;
        knots_[b].left_gap = gap;
    }

    // Adds the attraction of rims to the outermost lines of open fronts. It is weaker the more a line diverges
    // from the rim.
    void add_rims(const FrontLine& s, std::size_t first) {
        for (std::size_t j = 0; j < s.spots.size(); ++j) {
            Knot& k = knots_[first + j];
            const Front& front = fronts_.at(s.first + j)[s.spots[j].front];
            if (front.line.closed) continue;
            const std::size_t other = j > 0 ? j - 1 : j + 1;
            if (other >= s.spots.size()) continue;
            const Front& beside = fronts_.at(s.first + other)[s.spots[other].front];
            if (beside.line.closed) continue;
            const auto feel = [&](double x, double x_beside, double sign) {
                const double slope = std::abs(x - x_beside) / fronts_.step();
                if (x > rules::kBeside / 2 * d_ || slope > kSteepest) return;
                const double weight = 2 * (1 - slope / kSteepest);
                k.rim_weight += weight;
                k.rim += sign * weight * (d_ / 2 - x);
            };
            const double x = s.spots[j].x, y = s.spots[other].x;
            if (k.left == kNone) feel(x, y, 1);
            if (k.right == kNone) feel(front.length() - x, beside.length() - y, -1);
        }
    }

    double pull(Knot& k) {
        const double across = 1 / (d_ * d_), along = 1 / (fronts_.step() * fronts_.step());
        double weight = k.rim_weight * across, sum = k.rim * across;
        if (k.left != kNone) {
            weight += across;
            sum += across * (d_ - k.left_gap + knots_[k.left].moved);
        }
        if (k.right != kNone) {
            weight += across;
            sum += across * (k.right_gap - d_ + knots_[k.right].moved);
        }
        if (k.before != kNone) {
            weight += along;
            sum += along * knots_[k.before].moved;
        }
        if (k.behind != kNone) {
            weight += along;
            sum += along * knots_[k.behind].moved;
        }
        if (!(weight > 0)) return 0;
        const double way = kOver * (sum / weight - k.moved);
        k.moved += way;
        return way;
    }

    // Removes oscillations from step to step.
    void smooth() {
        std::vector<double> next;
        next.reserve(knots_.size());
        for (const Knot& k : knots_) {
            const bool inner = k.before != kNone && k.behind != kNone && !k.held;
            next.push_back(inner ? (knots_[k.before].moved + 2 * k.moved + knots_[k.behind].moved) / 4 : k.moved);
        }
        for (std::size_t i = 0; i < knots_.size(); ++i) knots_[i].moved = next[i];
    }

    const Fronts& fronts_;
    double d_;
    std::vector<Knot> knots_;
    std::vector<std::uint32_t> first_; // per line: index of its first knot
};

} // namespace

void make_room(std::vector<FrontLine>& lines, const Fronts& fronts, double spacing) {
    ElasticSheet sheet(lines, fronts, spacing);
    sheet.relax();
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t j = 0; j < lines[i].spots.size(); ++j) {
            Spot& spot = lines[i].spots[j];
            const Front& front = fronts.at(lines[i].first + j)[spot.front];
            const double l = front.length(), x = spot.x + sheet.moved(i, j);
            spot.x = front.line.closed ? x - l * std::floor(x / l) : std::clamp(x, 0.0, l);
        }
}

} // namespace filum::surfpath::fronts
