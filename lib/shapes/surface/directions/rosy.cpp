#include "surface/directions/rosy.hpp"

#include "base/error.hpp"

namespace filum::surface::directions {

namespace {

constexpr double kNothing = 1e-9; // keeps the system definite where no direction is known

using Entries = std::vector<Eigen::Triplet<double>>;

// Adds a complex factor of the unknown `column` in the equation `row` as a real 2 x 2 block; lower triangle only.
void add(std::uint32_t row, std::uint32_t column, const Complex& x, Entries& to) {
    const int r = 2 * static_cast<int>(row), c = 2 * static_cast<int>(column);
    to.emplace_back(r, c, x.real());
    to.emplace_back(r + 1, c, x.imag());
    to.emplace_back(r + 1, c + 1, x.real());
    if (row != column) to.emplace_back(r, c + 1, -x.imag());
}

sparse::Matrix system(const Cells& cells, std::span<const double> weight, double length) {
    Entries entries;
    entries.reserve(3 * weight.size() + 10 * cells.sides.size());
    for (std::uint32_t v = 0; v < weight.size(); ++v) add(v, v, cells.area[v] * (kNothing + weight[v]), entries);
    for (const CellBorder& side : cells.sides) {
        const double w = length * length * side.conductance;
        add(side.a, side.a, w, entries);
        add(side.b, side.b, w, entries);
        add(side.b, side.a, -w * transport(cells.normal[side.a], cells.normal[side.b]), entries);
    }
    const auto n = 2 * static_cast<int>(weight.size());
    sparse::Matrix out(n, n);
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

std::vector<Complex> Smoother::smoothed(std::span<const Complex> given, std::span<const double> weight) {
    const auto a = system(cells_, weight, length_);
    if (!factor_) factor_.emplace().analyse(a);
    if (!factor_->factorise(a))
        throw Error(Exit::failure, "cannot smooth the directions: the surface's triangles are too uneven; remesh it");
    Eigen::VectorXd right(a.rows());
    for (Eigen::Index v = 0; v < a.rows() / 2; ++v) {
        const auto i = static_cast<std::size_t>(v);
        const Complex r = cells_.area[i] * weight[i] * given[i];
        right[2 * v] = r.real();
        right[2 * v + 1] = r.imag();
    }
    const Eigen::VectorXd z = factor_->solve(right);
    std::vector<Complex> out;
    out.reserve(weight.size());
    for (Eigen::Index v = 0; v < z.size(); v += 2) out.emplace_back(z[v], z[v + 1]);
    return out;
}

} // namespace filum::surface::directions
