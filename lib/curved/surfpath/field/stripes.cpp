#include "surfpath/field/stripes.hpp"

#include "base/error.hpp"
#include "sparse/factor.hpp"
#include "surfpath/field/frequencies.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace filum::surfpath::field {

namespace {

using sparse::Matrix;
using surface::kNone;
using Vector = Eigen::VectorXd; // real and imaginary part for each vertex

constexpr double kMost =
    100; // largest squared slope integrated over a triangle, so that slivers do not outweigh the rest
// rad: initial phase between that of a line and that of the middle between lines, so that a patch can have an odd or an
// even number of lines.
constexpr double kBegin = std::numbers::pi / 4;
constexpr double kPairWide = 3;   // spacings: width of a pair of births, as one gap becomes three
constexpr double kTimesFall = 16; // ratio of consecutive times; the longest diffuses over the whole surface
constexpr int kDiffusions = 12;   // diffusions for every time
// Cosine of the largest angle to a rim at which that attracts lines, and the strength of the attraction, per mm of rim
// and spacing. Tuned: that of rules::kAlong and pi cost field six cuts on 18 faces, and cover .0016 less.
constexpr double kRimParallel = 0.9;
constexpr double kRimPull = 4;

using Rotation = Eigen::Matrix2d;

// The rotation that a phase at `k` has relative to `root` if the growth between them is the intended one.
Rotation transported(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> w,
                     std::uint32_t root, std::uint32_t k) {
    if (root == k) return Rotation::Identity();
    const EdgeGrowth g = edge_growth(s, cells, along, w, root, k);
    const double x = std::cos(g.growth), y = std::sin(g.growth), sign = g.flipped ? -1 : 1;
    Rotation out;
    out << x, sign * y, -y, sign * x;
    return out;
}

// Adds a 2 x 2 block to the lower triangle of the matrix.
void add_block(std::uint32_t row, std::uint32_t column, const Rotation& block,
               std::vector<Eigen::Triplet<double>>& to) {
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x)
            if (row != column || y >= x)
                to.emplace_back(2 * static_cast<int>(row) + y, 2 * static_cast<int>(column) + x, block(y, x));
}

Vec3 middle(const Surface& s, std::uint32_t t) {
    const auto& [a, b, c] = s.triangles[t];
    return 1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
}

// Factor of the cost of slopes near places that repel births: it falls by 1 over a spacing, to 1 where the next pair
// has room.
double slope_cost(const Vec3& p, const StripeOptions& o) {
    double out = 1;
    for (const Vec3& q : o.apart) out = std::max(out, 1 + kPairWide - distance(p, q) / o.spacing);
    return out;
}

// Adds the squared gradient of psi over every triangle, with slopes along the lines weighted by `stiff`. Each corner
// serves as root for a third of the weight.
void add_triangles(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> w,
                   const StripeOptions& o, std::vector<Eigen::Triplet<double>>& to) {
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& c = s.triangles[t];
        const Vec3 n = surface::normal(s, t), d = mean_direction(cells, along, c, n);
        const double area = surface::area(s, t);
        std::array<Vec3, 3> slope; // of the hat function of each corner
        for (std::size_t k = 0; k < 3; ++k)
            slope[k] = 1 / (2 * area) * cross(n, s.vertices[c[(k + 2) % 3]] - s.vertices[c[(k + 1) % 3]]);
        double most = 0;
        for (const Vec3& g : slope) most = std::max(most, area * norm2(g));
        const double weight = slope_cost(middle(s, t), o) * area * std::min(1.0, kMost / most) / 3;
        for (std::size_t r = 0; r < 3; ++r) {
            std::array<Rotation, 3> from;
            for (std::size_t k = 0; k < 3; ++k) from[k] = transported(s, cells, along, w, c[r], c[k]);
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j) {
                    if (c[i] < c[j]) continue;
                    const double k =
                        weight * (dot(slope[i], slope[j]) + (o.stiff - 1) * dot(slope[i], d) * dot(slope[j], d));
                    add_block(c[i], c[j], k * from[i].transpose() * from[j], to);
                }
        }
    }
}

// Adds the attraction of rims that lines run along: there the angle should be 0 or half a turn, which is the middle
// between two lines, so that the first line is half a spacing from the rim.
void add_rims(const Surface& s, std::span<const Vec3> along, double spacing, std::vector<Eigen::Triplet<double>>& to) {
    for (const auto& rim : s.rims)
        for (const std::uint32_t h : rim.sides) {
            const Vec3 e = s.vertices[s.head(h)] - s.vertices[s.tail(h)];
            const double l = norm(e);
            for (const std::uint32_t v : {s.tail(h), s.head(h)}) {
                const double c = std::abs(dot(along[v], e)) / l;
                const double pull = std::max(0.0, (c - kRimParallel) / (1 - kRimParallel));
                const int i = 2 * static_cast<int>(v) + 1;
                to.emplace_back(i, i, kRimPull / spacing * pull * l / 2);
            }
        }
}

void scale(Vector& psi) {
    for (Eigen::Index i = 0; i + 1 < psi.size(); i += 2) {
        const double l = std::hypot(psi[i], psi[i + 1]);
        psi[i] = l > 0 ? psi[i] / l : 1;
        psi[i + 1] = l > 0 ? psi[i + 1] / l : 0;
    }
}

// The phase, moved to at least rules::kTiny from a line, so that rounding does not decide on which side a vertex lies.
Complex beside_lines(const Complex& phase) {
    return std::abs(phase.real()) < rules::kTiny ? Complex{rules::kTiny, phase.imag() < 0 ? -1.0 : 1.0} : phase;
}

} // namespace

namespace {

// Minimises the energy of phases of size 1, from several initial phases.
class PhaseDiffusion {
  public:
    PhaseDiffusion(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> w,
                   const StripeOptions& o)
        : shortest_(o.spacing * o.spacing / 4), total_(cells.total) {
        const auto n = static_cast<Eigen::Index>(2 * s.vertices.size());
        std::vector<Eigen::Triplet<double>> entries, mass;
        add_triangles(s, cells, along, w, o, entries);
        add_rims(s, along, o.spacing, entries);
        energy_.resize(n, n);
        energy_.setFromTriplets(entries.begin(), entries.end());
        m_.resize(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            m_[i] = cells.area[static_cast<std::size_t>(i / 2)];
            mass.emplace_back(static_cast<int>(i), static_cast<int>(i), m_[i]);
        }
        area_.resize(n, n);
        area_.setFromTriplets(mass.begin(), mass.end());
        factor_.analyse(energy_ + area_);
    }

    // Diffuses every phase for falling times and scales it to size 1 after each diffusion.
    void run(std::vector<Vector>& psis) {
        double longest = shortest_;
        while (longest * kTimesFall < total_) longest *= kTimesFall;
        for (double time = longest; time >= shortest_; time /= kTimesFall) {
            if (!factor_.factorise(area_ + time * energy_))
                throw Error(Exit::failure,
                            "cannot place stripes: the surface's triangles are too uneven; run geodesic --remesh");
            for (Vector& psi : psis)
                for (int round = 0; round < kDiffusions; ++round) {
                    psi = factor_.solve(m_.cwiseProduct(psi));
                    scale(psi);
                }
        }
    }

    [[nodiscard]] double sum(const Vector& psi) const { return psi.dot(energy_.selfadjointView<Eigen::Lower>() * psi); }

  private:
    double shortest_; // mm2, of time: phases diffuse over half a spacing
    double total_;    // mm2
    Matrix energy_, area_;
    Vector m_;
    sparse::Factor factor_;
};

Vector initial_phase(std::size_t n, const Complex& everywhere, std::span<const Complex> like) {
    Vector out(2 * static_cast<Eigen::Index>(n));
    for (std::size_t v = 0; v < n; ++v) {
        const Complex at = like.empty() || like[v] == Complex{} ? everywhere : like[v];
        out[2 * static_cast<Eigen::Index>(v)] = at.real();
        out[2 * static_cast<Eigen::Index>(v) + 1] = at.imag();
    }
    return out;
}

} // namespace

namespace {

Stripes with_growth(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> w,
                    const Vector& psi) {
    Stripes out;
    for (Eigen::Index i = 0; i < psi.size(); i += 2) out.phase.push_back(beside_lines({psi[i], psi[i + 1]}));
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t a = std::min(s.tail(h), s.head(h)), b = std::max(s.tail(h), s.head(h));
        const EdgeGrowth g = edge_growth(s, cells, along, w, a, b);
        const Complex to = g.flipped ? std::conj(out.phase[b]) : out.phase[b];
        out.flipped.push_back(g.flipped ? 1 : 0);
        out.growth.push_back(g.growth + std::arg(to * std::conj(out.phase[a]) * std::polar(1.0, -g.growth)));
    }
    return out;
}

// The stripes whose angle grows by w[v] rad/mm across the directions at vertex v, as nearly as possible.
Stripes at_frequency(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> w,
                     const StripeOptions& o) {
    const Complex everywhere = std::polar(1.0, kBegin + std::numbers::pi * o.shift);
    std::vector<Vector> psis{initial_phase(s.vertices.size(), everywhere, {})};
    if (!o.like.empty()) psis.push_back(initial_phase(s.vertices.size(), everywhere, o.like));
    PhaseDiffusion diffusion(s, cells, along, w, o);
    diffusion.run(psis);
    const Vector& psi = psis.size() > 1 && diffusion.sum(psis[1]) < diffusion.sum(psis[0]) ? psis[1] : psis[0];
    return with_growth(s, cells, along, w, psi);
}

} // namespace

Stripes stripes(const Surface& s, const Cells& cells, std::span<const Vec3> along, const StripeOptions& o) {
    std::vector<double> w = frequencies(s, cells, along, o.change);
    for (double& f : w) f *= std::numbers::pi / o.spacing;
    return at_frequency(s, cells, along, w, o);
}

// rad: growth of the angle around a triangle, as counted by its first corner; none if the corners' directions have no
// common sign.
static std::optional<double> winding(const Surface& s, const Stripes& stripes, std::uint32_t triangle) {
    double sum = 0, sign = 1;
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const bool ahead = s.tail(h) < s.head(h), flipped = stripes.flipped[h] != 0;
        sum += sign * (ahead || flipped ? stripes.growth[h] : -stripes.growth[h]);
        sign = flipped ? -sign : sign;
    }
    return sign < 0 ? std::nullopt : std::optional(sum);
}

bool singular(const Surface& s, const Stripes& stripes, std::uint32_t triangle) {
    const auto turns = winding(s, stripes, triangle);
    return !turns || std::abs(*turns) > std::numbers::pi;
}

std::vector<Vec3> births(const Surface& s, const Stripes& stripes) {
    std::vector<Vec3> out;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto turns = winding(s, stripes, t);
        if (turns && std::abs(*turns) > std::numbers::pi) out.push_back(middle(s, t));
    }
    return out;
}

} // namespace filum::surfpath::field
