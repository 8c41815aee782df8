#include "surfpath/field/frequencies.hpp"

#include "sparse/factor.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::surfpath::field {

namespace {

using sparse::Matrix;
using surface::directions::turned;
using Vector = Eigen::VectorXd;

// Finds the logarithms of frequencies within limits (primal-dual active set: Hintermueller, Ito, Kunisch 2002).
class FrequencyFitter {
  public:
    FrequencyFitter(const Surface& s, const Cells& cells, std::span<const Vec3> along)
        : matrix_(size(s), size(s)), right_(Vector::Zero(size(s))) {
        std::vector<Eigen::Triplet<double>> entries;
        const std::vector<double> unit(s.vertices.size(), 1);
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t) add(s, cells, along, unit, t, entries);
        // where nothing else decides, the spacing is kept
        for (std::uint32_t v = 0; v < s.vertices.size(); ++v) entries.emplace_back(v, v, cells.area[v] / cells.total);
        matrix_.setFromTriplets(entries.begin(), entries.end());
    }

    [[nodiscard]] Vector within(double low, double high) const {
        const Eigen::Index n = right_.size();
        const double held = matrix_.diagonal().maxCoeff() / rules::kTiny; // the weight of a frequency at its limit
        std::vector<signed char> limit(static_cast<std::size_t>(n), 0);   // -1 or 1: the value is held at low or high
        Vector x = Vector::Zero(n);
        sparse::Factor factor;
        factor.analyse(matrix_);
        for (int round = 0; round < rules::kMostRounds; ++round) {
            Matrix matrix = matrix_;
            Vector right = right_;
            for (Eigen::Index v = 0; v < n; ++v)
                if (const auto l = limit[static_cast<std::size_t>(v)]; l != 0) {
                    matrix.coeffRef(v, v) += held;
                    right[v] += held * (l > 0 ? high : low);
                }
            if (!factor.factorise(matrix)) break;
            x = factor.solve(right);
            const Vector force = right_ - matrix_.selfadjointView<Eigen::Lower>() * x;
            if (change_sides(x, force, low, high, limit) <= rules::kNegligible * static_cast<double>(n)) break;
        }
        return x.cwiseMax(low).cwiseMin(high);
    }

  private:
    static Eigen::Index size(const Surface& s) { return static_cast<Eigen::Index>(s.vertices.size()); }

    // Adds the squared curl over a triangle.
    void add(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> unit,
             std::uint32_t t, std::vector<Eigen::Triplet<double>>& to) {
        const auto& c = s.triangles[t];
        const Vec3 n = surface::normal(s, t), d = mean_direction(cells, along, c, n);
        const double area = surface::area(s, t);
        double around = 0, sign = 1; // mm: growth around the triangle as counted by its first corner
        for (std::size_t k = 0; k < 3; ++k) {
            const EdgeGrowth g = edge_growth(s, cells, along, unit, c[k], c[(k + 1) % 3]);
            around += sign * g.growth;
            sign = g.flipped ? -sign : sign;
        }
        // without a common sign of the corners' directions, a line begins here for all frequencies
        const double weight = sign < 0 ? 0 : area;
        // Slopes across the lines cost no birth, so their weight is negligible. Without it, frequencies beside each
        // other would be independent, and lines would bend.
        std::array<Vec3, 3> slope; // of the hat function of each corner
        for (std::size_t k = 0; k < 3; ++k)
            slope[k] = 1 / (2 * area) * cross(n, s.vertices[c[(k + 2) % 3]] - s.vertices[c[(k + 1) % 3]]);
        for (std::size_t i = 0; i < 3; ++i) {
            right_[c[i]] -= weight / area * dot(slope[i], d) * around;
            for (std::size_t j = 0; j < 3; ++j)
                if (c[i] >= c[j])
                    to.emplace_back(c[i], c[j],
                                    weight * dot(slope[i], d) * dot(slope[j], d) +
                                        rules::kNegligible * area * dot(slope[i], slope[j]));
        }
    }

    // Values beyond a limit are held there, and those that would leave it to the inside are let go. Returns how many.
    static std::size_t change_sides(const Vector& x, const Vector& force, double low, double high,
                                    std::vector<signed char>& limit) {
        std::size_t out = 0;
        for (Eigen::Index v = 0; v < x.size(); ++v) {
            signed char& now = limit[static_cast<std::size_t>(v)];
            signed char next = 0;
            if (now != 0)
                next = (now > 0) == (force[v] > 0) ? now : static_cast<signed char>(0);
            else if (x[v] > high || x[v] < low)
                next = x[v] > high ? 1 : -1;
            out += next != now ? 1 : 0;
            now = next;
        }
        return out;
    }

    Matrix matrix_;
    Vector right_;
};

} // namespace

EdgeGrowth edge_growth(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> w,
                       std::uint32_t a, std::uint32_t b) {
    const Vec3 e = s.vertices[b] - s.vertices[a];
    const Vec3 &na = cells.normal[a], &nb = cells.normal[b];
    const bool flipped = dot(turned(along[a], na, nb), along[b]) < 0;
    const double from = dot(cross(na, along[a]), e), to = dot(cross(nb, along[b]), e);
    return {(w[a] + w[b]) / 2 * (from + (flipped ? -to : to)) / 2, flipped};
}

Vec3 mean_direction(const Cells& cells, std::span<const Vec3> along, const surface::Triangle& c, const Vec3& n) {
    Vec3 sum;
    for (const std::uint32_t v : c) {
        const Vec3 d = turned(along[v], cells.normal[v], n);
        sum = sum + (dot(d, sum) < 0 ? -1.0 : 1.0) * d;
    }
    return geom::unit(sum - dot(sum, n) * n, {});
}

std::vector<double> frequencies(const Surface& s, const Cells& cells, std::span<const Vec3> along, double change) {
    std::vector<double> out(s.vertices.size(), 1);
    if (!(change > 0)) return out;
    const Vector log = FrequencyFitter(s, cells, along).within(-std::log(1 + change), -std::log(1 - change));
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = std::exp(log[static_cast<Eigen::Index>(v)]);
    return out;
}

} // namespace filum::surfpath::field
