#include "surface/directions/rosy.hpp"

#include "base/error.hpp"

#include <Eigen/SparseCholesky>

namespace filum::surface::directions {

namespace {

constexpr double kNothing = 1e-9; // keeps the system definite where nothing is known

using ComplexMatrix = Eigen::SparseMatrix<Complex>;

ComplexMatrix system(const Cells& cells, std::span<const double> weight, double length) {
    std::vector<Eigen::Triplet<Complex>> entries;
    entries.reserve(weight.size() + 3 * cells.sides.size());
    const auto at = [](std::uint32_t v) { return static_cast<int>(v); };
    for (std::uint32_t v = 0; v < weight.size(); ++v)
        entries.emplace_back(at(v), at(v), cells.area[v] * (kNothing + weight[v]));
    for (const Side& side : cells.sides) {
        const double w = length * length * side.conductance;
        entries.emplace_back(at(side.a), at(side.a), w);
        entries.emplace_back(at(side.b), at(side.b), w);
        entries.emplace_back(at(side.b), at(side.a),
                             -w * transport(cells.normal[side.a], cells.normal[side.b])); // lower triangle
    }
    const auto n = static_cast<int>(weight.size());
    ComplexMatrix out(n, n);
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
}

} // namespace

Complex doubled(const Vec3& d, const Vec3& n) {
    const Vec3 x = across(n);
    const Complex z{dot(d, x), dot(d, cross(n, x))};
    return z * z;
}

Vec3 direction(const Complex& z, const Vec3& n) {
    if (!(std::abs(z) > 0)) return {};
    const double half = std::arg(z) / 2;
    const Vec3 x = across(n);
    return std::cos(half) * x + std::sin(half) * cross(n, x);
}

Complex transport(const Vec3& a, const Vec3& b) { return doubled(turned(across(a), a, b), b); }

std::vector<Complex> smoothed(const Cells& cells, std::span<const Complex> given, std::span<const double> weight,
                              double length) {
    Eigen::SimplicialLDLT<ComplexMatrix> factor(system(cells, weight, length));
    if (factor.info() != Eigen::Success)
        throw Error(Exit::failure, "cannot smooth the directions: the surface's triangles are too uneven; remesh it");
    Eigen::VectorXcd right(static_cast<Eigen::Index>(weight.size()));
    for (std::size_t v = 0; v < weight.size(); ++v)
        right[static_cast<Eigen::Index>(v)] = cells.area[v] * weight[v] * given[v];
    const Eigen::VectorXcd z = factor.solve(right);
    return {z.data(), z.data() + z.size()};
}

} // namespace filum::surface::directions
