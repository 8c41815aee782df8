#include "metrics/planar/pores.hpp"

#include "figures/meanings.hpp"

#include "base/number.hpp"
#include "geom/angle.hpp"
#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::metrics::planar {

namespace {

using geom::kDegree;
using polygon::Loops;
using toolpath::Role;

constexpr double kPi = std::numbers::pi;
constexpr double kStraight = 0.5 * kDegree; // greatest angle between segments of one straight run
constexpr double kSame = kDegree;           // greatest angle between strands of one direction
constexpr double kLong = 3;                 // bead widths
constexpr double kApart = 1.1;              // bead widths; nearer strands are side by side
constexpr double kChink = 0.125;            // bead widths
constexpr double kExact = 0.002;            // mm

double median(std::vector<double> v) {
    if (v.empty()) return 0;
    const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
    std::nth_element(v.begin(), middle, v.end());
    if (v.size() % 2 != 0) return *middle;
    return (*middle + *std::max_element(v.begin(), middle)) / 2;
}

// Median by length.
double weighted_median(std::vector<std::pair<double, double>> v) {
    std::sort(v.begin(), v.end());
    double all = 0, sum = 0;
    for (const auto& [value, weight] : v) all += weight;
    for (const auto& [value, weight] : v)
        if ((sum += weight) >= all / 2) return value;
    return 0;
}

struct Straight {
    Vec2 a, b;
    double width = 0; // mm
    [[nodiscard]] double length() const { return geom::distance(a, b); }
};

// Difference of two directions, [0, pi / 2].
double apart(double a, double b) {
    const double d = std::fmod(std::abs(a - b), kPi);
    return std::min(d, kPi - d);
}

double direction(const Straight& s) {
    const double a = std::atan2(s.b.y - s.a.y, s.b.x - s.a.x);
    return a < 0 ? a + kPi : a >= kPi ? a - kPi : a;
}

std::vector<Straight> straights(const LayerBeads& beads) {
    std::vector<Straight> out;
    for (std::size_t k = 0; k < beads.runs.size(); ++k) {
        if (!toolpath::fills(beads.runs[k].role)) continue;
        bool open = false;
        for (std::size_t i = beads.runs[k].first; i + 1 < beads.end(k); ++i) {
            const Straight s{beads.points[i], beads.points[i + 1], beads.width[i]};
            if (s.length() == 0) continue;
            const auto ahead = [&](const Straight& t) {
                const Vec2 u = t.b - t.a, v = s.b - s.a;
                return std::abs(std::atan2(geom::cross(u, v), geom::dot(u, v))) < kStraight;
            };
            if (open && ahead(out.back()) && std::abs(out.back().width - s.width) < 0.01 * s.width)
                out.back().b = s.b;
            else
                out.push_back(s);
            open = true;
        }
    }
    return out;
}

// The direction of greatest length, within a degree. Ties: the smallest.
double main_direction(const std::vector<Straight>& all) {
    double best = 0, most = 0;
    std::vector<double> bin(180, 0.0);
    for (const auto& s : all) bin[static_cast<std::size_t>(direction(s) / kDegree) % 180] += s.length();
    for (std::size_t k = 0; k < 180; ++k)
        if (const double sum = bin[k] + bin[(k + 1) % 180]; sum > most) {
            most = sum;
            best = (static_cast<double>(k) + 1) * kDegree;
        }
    double turn = 0, length = 0;
    for (const auto& s : all) {
        double d = direction(s) - best;
        d -= kPi * std::round(d / kPi);
        if (std::abs(d) <= kSame) {
            turn += d * s.length();
            length += s.length();
        }
    }
    best += length > 0 ? turn / length : 0;
    return best < 0 ? best + kPi : best >= kPi ? best - kPi : best;
}

double median_width(const LayerBeads& beads) {
    std::vector<std::pair<double, double>> v;
    for (std::size_t k = 0; k < beads.runs.size(); ++k)
        for (std::size_t i = beads.runs[k].first; i + 1 < beads.end(k); ++i)
            v.emplace_back(beads.width[i], geom::distance(beads.points[i], beads.points[i + 1]));
    return weighted_median(std::move(v));
}

// The area of the layer's beads, without connectors.
Loops swept(const LayerBeads& beads) {
    Loops all;
    std::vector<Vec2> line;
    const auto flush = [&](double width) {
        if (line.size() < 2 || width <= 0) return;
        const Loops bead = polygon::around(line, width / 2);
        for (std::size_t i = 0; i < bead.size(); ++i) all.add(bead[i]);
    };
    for (std::size_t k = 0; k < beads.runs.size(); ++k) {
        if (beads.runs[k].role == Role::connector) continue;
        line.clear();
        double width = 0;
        for (std::size_t i = beads.runs[k].first; i + 1 < beads.end(k); ++i) {
            const double w = beads.width[i];
            if (line.empty() || std::abs(w - width) > 0.002 * width) {
                flush(width);
                line = {beads.points[i]}, width = w;
            }
            line.push_back(beads.points[i + 1]);
        }
        flush(width);
    }
    return polygon::unite(all);
}

double deposited(const LayerBeads& beads) {
    double sum = 0;
    for (std::size_t k = 0; k < beads.runs.size(); ++k) {
        if (beads.runs[k].role == Role::connector) continue;
        for (std::size_t i = beads.runs[k].first; i + 1 < beads.end(k); ++i)
            sum += beads.width[i] * beads.thickness(i) * beads.runs[k].layers *
                   geom::distance(beads.points[i], beads.points[i + 1]);
    }
    return sum;
}

// The circles in the openings that the united beads enclose within `outline`.
std::vector<Opening> openings(const Loops& beads, const Loops& outline, double least) {
    std::vector<Opening> out;
    Loops filled;
    for (std::size_t i = 0; i < beads.size(); ++i)
        if (polygon::signed_area(beads[i]) > 0) filled.add(beads[i]);
    const Loops enclosed = polygon::intersect(polygon::subtract(filled, beads), outline);
    for (const auto& part : polygon::split(enclosed).part)
        if (const double d = inscribed_circle(part); d >= least) out.push_back({d, polygon::centroid(part)});
    std::ranges::stable_sort(out, {}, &Opening::diameter);
    return out;
}

std::vector<double> diameters(const std::vector<Opening>& openings) {
    std::vector<double> out;
    out.reserve(openings.size());
    for (const Opening& o : openings) out.push_back(o.diameter);
    return out;
}

// A layer before its pores are known.
struct SweptLayer {
    const LayerBeads* beads = nullptr;
    Loops outline;
    double height = 0;
    Loops swept;
};

// The layers visible together from layer i: [first, last].
std::pair<std::size_t, std::size_t> seen_from(std::size_t i, const std::vector<LayerPores>& layers) {
    const auto differs = [&](std::size_t k) { return apart(layers[k].direction, layers[i].direction) > kSame; };
    std::size_t last = i, first = i;
    while (last + 1 < layers.size() && !differs(last)) ++last;
    if (differs(last)) return {i, last};
    while (first > 0 && !differs(first)) --first;
    return {first, i};
}

// Sets the lateral throats. Precondition: strands and spacings are known.
void channels(std::vector<LayerPores>& layers) {
    for (std::size_t first = 0, last = 0; first < layers.size(); first = last) {
        double height = 0;
        while (last < layers.size() && apart(layers[last].direction, layers[first].direction) <= kSame)
            height += layers[last++].height;
        for (std::size_t i = first; i < last; ++i)
            if (const double gap = layers[i].spacing - layers[i].width; layers[i].spacing > 0)
                layers[i].lateral = std::max(0.0, std::min(gap, height));
    }
}

void through_all(const std::vector<SweptLayer*>& list, Pores& out) {
    if (list.empty()) return;
    Loops beads, outline = list[0]->outline;
    std::vector<double> width;
    for (std::size_t i = 0; i < list.size(); ++i) {
        beads = polygon::unite(beads, list[i]->swept);
        if (i > 0) outline = polygon::intersect(outline, list[i]->outline);
        width.push_back(out.layers[i].width);
    }
    out.through = diameters(openings(beads, outline, kChink * median(width)));
}

} // namespace

double inscribed_circle(const Loops& area) {
    double lo = 0, hi = std::sqrt(std::max(0.0, polygon::signed_area(area)) / kPi) + kExact;
    while (hi - lo > kExact / 2) {
        const double r = (lo + hi) / 2;
        (polygon::offset(area, -r, kExact / 2).empty() ? hi : lo) = r;
    }
    return 2 * lo;
}

LayerPores find_strands(const LayerBeads& beads) {
    LayerPores out;
    out.height = beads.height;
    const double w = median_width(beads);
    const auto all = straights(beads);
    out.direction = main_direction(all);
    const Vec2 normal{-std::sin(out.direction), std::cos(out.direction)};
    std::vector<double> lines, gaps;
    std::vector<std::pair<double, double>> widths;
    for (const auto& s : all) {
        if (s.length() < kLong * w || apart(direction(s), out.direction) > kSame) continue;
        ++out.strands;
        lines.push_back(geom::dot(normal, geom::lerp(s.a, s.b, 0.5)));
        widths.emplace_back(s.width, s.length());
    }
    std::sort(lines.begin(), lines.end());
    for (std::size_t i = 1; i < lines.size(); ++i)
        if (const double gap = lines[i] - lines[i - 1]; gap > kApart * w) gaps.push_back(gap);
    out.width = weighted_median(std::move(widths));
    out.spacing = median(std::move(gaps));
    return out;
}

Pores measure_pores(const Beads& beads, const std::vector<polygon::Region>& regions,
                    const std::vector<LayerFigures>& layers, int threads) {
    Pores out;
    std::map<std::uint32_t, SweptLayer> work;
    for (const auto& r : regions) {
        SweptLayer& w = work[r.layer];
        for (std::size_t i = 0; i < r.loops.size(); ++i) w.outline.add(r.loops[i]);
        w.height = r.height / r.layers;
        out.part += r.area * r.height;
    }
    for (const auto& l : layers) {
        out.area += l.cover.area;
        out.covered += l.cover.covered;
    }
    std::vector<SweptLayer*> list;
    for (auto& [layer, w] : work) {
        const auto found = beads.layer.find(layer);
        w.beads = found == beads.layer.end() ? nullptr : &found->second;
        if (w.beads != nullptr) out.material += deposited(*w.beads) * w.height;
        out.layers.push_back({});
        out.layers.back().layer = layer;
        out.layers.back().height = w.height;
        list.push_back(&w);
    }
    parallel::for_chunks(list.size(), 1, threads, [&](std::size_t i, std::size_t) {
        SweptLayer& w = *list[i];
        if (w.beads == nullptr) return;
        const auto layer = out.layers[i].layer;
        out.layers[i] = find_strands(*w.beads);
        out.layers[i].layer = layer;
        out.layers[i].height = w.height;
        w.swept = swept(*w.beads);
    });
    channels(out.layers);
    parallel::for_chunks(list.size(), 1, threads, [&](std::size_t i, std::size_t) {
        const auto [first, last] = seen_from(i, out.layers);
        Loops beads_seen = list[first]->swept, outline = list[first]->outline;
        for (std::size_t k = first + 1; k <= last; ++k) {
            beads_seen = polygon::unite(beads_seen, list[k]->swept);
            outline = polygon::intersect(outline, list[k]->outline);
        }
        out.layers[i].openings = openings(beads_seen, outline, kChink * out.layers[i].width);
    });
    through_all(list, out);
    return out;
}

void pore_figures(const Pores& p, Figures& out) {
    std::vector<double> strands, spacing, width, circles, lateral;
    std::uint64_t count = 0;
    for (const auto& l : p.layers) {
        count += l.strands;
        strands.push_back(static_cast<double>(l.strands));
        for (const Opening& o : l.openings) circles.push_back(o.diameter);
        if (l.spacing <= 0) continue;
        spacing.push_back(l.spacing);
        width.push_back(l.width);
        lateral.push_back(l.lateral);
    }
    const auto tell = [](Figures& to, std::string_view key, decltype(figures::Figure::value) value) {
        figures::tell(to, figures::planar_meanings(), key, std::move(value));
    };
    tell(out, "porosity_volume", p.part > 0 ? 1 - p.material / p.part : 0);
    tell(out, "porosity_area", p.area > 0 ? 1 - p.covered / p.area : 0);
    if (!spacing.empty()) tell(out, "porosity_lattice", 1 - median(width) / median(spacing));
    tell(out, "strands", count);
    tell(out, "strands_per_layer", median(strands));
    if (!spacing.empty()) {
        tell(out, "strand_spacing_mm", median(spacing));
        tell(out, "strand_width_mm", median(width));
    }
    const auto range = [&](const std::string& name, const std::vector<double>& v) {
        if (v.empty()) return;
        tell(out, name + "_mm", median(v));
        tell(out, name + "_least_mm", *std::min_element(v.begin(), v.end()));
        tell(out, name + "_greatest_mm", *std::max_element(v.begin(), v.end()));
    };
    tell(out, "openings", std::uint64_t{circles.size()});
    range("pore", circles);
    tell(out, "openings_through", std::uint64_t{p.through.size()});
    range("throat_vertical", p.through);
    range("throat_lateral", lateral);
}

std::string pore_columns() {
    return "strands\tdirection_deg\twidth_mm\tspacing_mm\tlateral_throat_mm\topenings\tpore_median_mm\t"
           "pore_smallest_mm\tpore_largest_mm";
}

std::string pore_cells(const Pores& p, std::uint32_t layer) {
    LayerPores l;
    const auto at = std::lower_bound(p.layers.begin(), p.layers.end(), layer,
                                     [](const LayerPores& a, std::uint32_t number) { return a.layer < number; });
    if (at != p.layers.end() && at->layer == layer) l = *at;
    const std::vector<double> c = diameters(l.openings);
    return std::to_string(l.strands) + "\t" + fixed_text(l.direction / kDegree, 2) + "\t" + fixed_text(l.width, 4) +
           "\t" + fixed_text(l.spacing, 4) + "\t" + fixed_text(l.lateral, 4) + "\t" + std::to_string(c.size()) + "\t" +
           fixed_text(median(c), 4) + "\t" + fixed_text(c.empty() ? 0 : c.front(), 4) + "\t" +
           fixed_text(c.empty() ? 0 : c.back(), 4);
}

std::string pore_table(const Pores& p) {
    std::string out = "layer\tx_mm\ty_mm\tpore_mm\n";
    for (const LayerPores& l : p.layers)
        for (const Opening& o : l.openings)
            out += std::to_string(l.layer) + "\t" + fixed_text(o.at.x, 4) + "\t" + fixed_text(o.at.y, 4) + "\t" +
                   fixed_text(o.diameter, 4) + "\n";
    return out;
}

} // namespace filum::metrics::planar
