#include "surfpath/field/stripes.hpp"

#include "base/error.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::surfpath::field {

namespace {

using surface::kNone;
using surface::directions::turned;
using Matrix = Eigen::SparseMatrix<double>; // symmetric, its lower triangle
using Vector = Eigen::VectorXd;             // real and imaginary parts of each vertex

constexpr double kPi = std::numbers::pi;
constexpr double kTimes[] = {64, 16, 4, 1, 0.25}; // spacings squared, that the phase is diffused over
constexpr int kDiffusions = 12;                   // of each
constexpr double kRimParallel = 0.9;              // cosine of the angle to a rim from where on that attracts lines
constexpr double kRimPull = 4;                    // how much, per mm of rim and spacing

// From vertex a to vertex b: how the angle should grow, and whether it counts the other way round there.
struct Step {
    double growth = 0;
    bool flipped = false;
};

Step step(const Surface& s, const Cells& cells, std::span<const Vec3> along, double w, std::uint32_t a,
          std::uint32_t b) {
    const Vec3 e = s.vertices[b] - s.vertices[a];
    const Vec3 &na = cells.normal[a], &nb = cells.normal[b];
    const bool flipped = dot(turned(along[a], na, nb), along[b]) < 0;
    const double from = dot(cross(na, along[a]), e), to = dot(cross(nb, along[b]), e);
    return {w * (from + (flipped ? -to : to)) / 2, flipped};
}

// |psi_b - e^{i growth} psi_a|^2 summed over sides, by their conductance; of a flipped side the conjugate of psi_b.
void add_sides(const Surface& s, const Cells& cells, std::span<const Vec3> along, double w,
               std::vector<Eigen::Triplet<double>>& to) {
    for (const auto& side : cells.sides) {
        const Step g = step(s, cells, along, w, side.a, side.b);
        const int a = 2 * static_cast<int>(side.a), b = 2 * static_cast<int>(side.b);
        const double c = side.conductance, x = c * std::cos(g.growth), y = c * std::sin(g.growth);
        const double sign = g.flipped ? -1 : 1;
        for (const int i : {a, a + 1, b, b + 1}) to.emplace_back(i, i, c);
        to.emplace_back(b, a, -x);
        to.emplace_back(b, a + 1, y);
        to.emplace_back(b + 1, a, -sign * y);
        to.emplace_back(b + 1, a + 1, -sign * x);
    }
}

// At rims that lines run along the angle shall be 0 or half a turn: there is no line on the rim, but one half a spacing
// from it.
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

} // namespace

Stripes stripes(const Surface& s, const Cells& cells, std::span<const Vec3> along, double spacing) {
    const double w = kPi / spacing;
    const auto n = static_cast<Eigen::Index>(s.vertices.size());
    std::vector<Eigen::Triplet<double>> entries, mass;
    add_sides(s, cells, along, w, entries);
    add_rims(s, along, spacing, entries);
    Matrix energy(2 * n, 2 * n), area(2 * n, 2 * n);
    energy.setFromTriplets(entries.begin(), entries.end());
    Vector m(2 * n);
    for (Eigen::Index i = 0; i < 2 * n; ++i) {
        m[i] = cells.area[static_cast<std::size_t>(i / 2)];
        mass.emplace_back(static_cast<int>(i), static_cast<int>(i), m[i]);
    }
    area.setFromTriplets(mass.begin(), mass.end());
    Vector psi = Vector::Zero(2 * n);
    for (Eigen::Index i = 0; i < 2 * n; i += 2) psi[i] = 1;
    Eigen::SimplicialLDLT<Matrix> factor;
    factor.analyzePattern(energy + area);
    for (const double time : kTimes) {
        factor.factorize(area + time * spacing * spacing * energy);
        if (factor.info() != Eigen::Success)
            throw Error(Exit::failure, "cannot lay stripes: the surface's triangles are too uneven; remesh it");
        for (int round = 0; round < kDiffusions; ++round) {
            psi = factor.solve(m.cwiseProduct(psi)).eval();
            scale(psi);
        }
    }
    Stripes out;
    for (Eigen::Index i = 0; i < 2 * n; i += 2) out.phase.emplace_back(psi[i], psi[i + 1]);
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t a = std::min(s.tail(h), s.head(h)), b = std::max(s.tail(h), s.head(h));
        const Step g = step(s, cells, along, w, a, b);
        const Complex to = g.flipped ? std::conj(out.phase[b]) : out.phase[b];
        out.flipped.push_back(g.flipped ? 1 : 0);
        out.growth.push_back(g.growth + std::arg(to * std::conj(out.phase[a]) * std::polar(1.0, -g.growth)));
    }
    return out;
}

bool singular(const Surface& s, const Stripes& stripes, std::uint32_t triangle) {
    double sum = 0, sign = 1; // as the first corner counts
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const bool ahead = s.tail(h) < s.head(h), flipped = stripes.flipped[h] != 0;
        sum += sign * (ahead || flipped ? stripes.growth[h] : -stripes.growth[h]);
        sign = flipped ? -sign : sign;
    }
    return sign < 0 || std::abs(sum) > kPi;
}

} // namespace filum::surfpath::field
