#include "geodesic/heat.hpp"

#include "base/error.hpp"
#include "geodesic/exact.hpp"

#include <cmath>
#include <limits>

namespace filum::geodesic {

using Eigen::VectorXd;
using sparse::Factor;
using sparse::Matrix;

namespace {

constexpr double kSliver = 1e-5;  // mean edges by which two sides must together be longer than the third
constexpr double kFaded = 1e-290; // smaller values of heat have lost digits
// most square roots of the time in the box's diagonal; heat falls by a factor e over each
constexpr double kReach = 420;
// Most times that the time is multiplied by four.
constexpr int kRaises = 12;
constexpr double kNear = 16; // mean edges up to which distances are computed exactly
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Cotangents {
    double c[3]; // per corner
};
Cotangents cotangents(double x1, double x2, double y2) {
    const double twice = x1 * y2;
    return {{x1 * x2 / twice, x1 * (x1 - x2) / twice, (x2 * (x2 - x1) + y2 * y2) / twice}};
}

double box_diagonal(const Surface& s) { return norm(geom::box_of(s.vertices).size()); }

std::uint32_t nearest_corner(const Surface& s, std::uint32_t triangle, const Vec3& p) {
    const auto& t = s.triangles[triangle];
    return *std::min_element(t.begin(), t.end(), [&](std::uint32_t a, std::uint32_t b) {
        return distance(s.vertices[a], p) < distance(s.vertices[b], p);
    });
}

} // namespace

Heat::Heat(const Surface& s, const Sources& sources, const HeatOptions& options) : surface_(s), options_(options) {
    const double h = surface::mean_edge(s);
    const double step = options.paper ? h : std::max(h, box_diagonal(s) / kReach);
    time_ = step * step;
    start(sources);
    assemble();
    factorise_flow();
    if (options.paper) keep_one_pinned();
    std::vector<char> known(s.vertices.size(), 0); // also vertices of components without a source
    for (std::size_t v = 0; v < known.size(); ++v)
        known[v] = reached_[s.component[s.outgoing[v] / 3]] == 0 || !std::isnan(pinned_[v]) ? 1 : 0;
    potential_ = poisson_factor(known);
}

// Factorises the Poisson system with Dirichlet rows: rows and columns of known values become those of the identity.
Factor Heat::poisson_factor(const std::vector<char>& known) const {
    Matrix a = stiffness_;
    for (int col = 0; col < a.outerSize(); ++col)
        for (Matrix::InnerIterator it(a, col); it; ++it)
            if (known[static_cast<std::size_t>(it.row())] != 0 || known[static_cast<std::size_t>(col)] != 0)
                it.valueRef() = it.row() == col ? 1 : 0;
    Factor out = flow_.same_order();
    if (!out.factorise(a))
        throw Error(Exit::failure, "cannot solve for the distances: the surface's matrix is not positive definite; "
                                   "remesh it, or use the exact method");
    return out;
}

// Sets the initial heat and the values known beforehand.
void Heat::start(const Sources& sources) {
    const Surface& s = surface_;
    pinned_.assign(s.vertices.size(), std::nan(""));
    initial_ = VectorXd::Zero(static_cast<Eigen::Index>(s.vertices.size()));
    reached_.assign(s.components, 0);
    for (const std::uint32_t v : sources.vertices) start_at(v);
    for (const Segment& e : sources.segments) {
        if (options_.paper) {
            start_at(nearest_corner(s, e.triangle, e.a));
            start_at(nearest_corner(s, e.triangle, e.b));
        } else
            start_on(e);
    }
    if (options_.paper) return;
    const auto near = exact_distances(s, sources, kNear * surface::mean_edge(s)).distance;
    for (std::size_t v = 0; v < near.size(); ++v)
        if (std::isfinite(near[v])) pinned_[v] = near[v];
}

void Heat::start_at(std::uint32_t v) {
    initial_[v] = 1;
    pinned_[v] = 0;
    reached_[surface_.component[surface_.outgoing[v] / 3]] = 1;
}

// Distributes the segment's length to the corners by the barycentric coordinates of its middle.
void Heat::start_on(const Segment& e) {
    const Surface& s = surface_;
    reached_[s.component[e.triangle]] = 1;
    const double share = e.a == e.b ? 1 : geom::distance(e.a, e.b);
    const auto& t = s.triangles[e.triangle];
    const Vec3 &a = s.vertices[t[0]], &b = s.vertices[t[1]], &c = s.vertices[t[2]];
    const Vec3 m = 0.5 * (e.a + e.b), n = cross(b - a, c - a);
    const auto part = [&](const Vec3& u, const Vec3& v) {
        return std::max(0.0, dot(cross(v - u, m - u), n) / dot(n, n));
    };
    initial_[t[0]] += share * part(b, c);
    initial_[t[1]] += share * part(c, a);
    initial_[t[2]] += share * part(a, b);
}

// Keeps one known vertex per component.
void Heat::keep_one_pinned() {
    std::vector<char> has(surface_.components, 0);
    for (std::size_t v = 0; v < pinned_.size(); ++v) {
        if (std::isnan(pinned_[v])) continue;
        char& one = has[surface_.component[surface_.outgoing[v] / 3]];
        if (one != 0) pinned_[v] = std::nan("");
        one = 1;
    }
}

// Shifts every component such that the mean over its sources is 0.
void Heat::shift(VectorXd& phi) const {
    std::vector<double> sum(surface_.components, 0), count(surface_.components, 0);
    const auto of = [&](Eigen::Index v) {
        return surface_.component[surface_.outgoing[static_cast<std::size_t>(v)] / 3];
    };
    for (Eigen::Index v = 0; v < phi.size(); ++v)
        if (initial_[v] > 0) {
            sum[of(v)] += phi[v];
            count[of(v)] += 1;
        }
    for (Eigen::Index v = 0; v < phi.size(); ++v)
        if (count[of(v)] > 0) phi[v] -= sum[of(v)] / count[of(v)];
}

void Heat::assemble() {
    const Surface& s = surface_;
    const auto n = static_cast<Eigen::Index>(s.vertices.size());
    std::vector<double> length(s.twin.size());
    double lack = 0;
    for (std::uint32_t h = 0; h < length.size(); ++h) length[h] = surface::side_length(s, h);
    const double least = kSliver * surface::mean_edge(s);
    for (std::uint32_t h = 0; h < length.size(); ++h)
        lack = std::max(lack, least + length[h] - length[surface::next(h)] - length[surface::prev(h)]);
    for (double& l : length) l += lack;
    mass_ = VectorXd::Zero(n);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(s.twin.size() * 3);
    flat_.resize(s.triangles.size());
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const double a = length[3 * t], b = length[3 * t + 1], c = length[3 * t + 2];
        const double x2 = (a * a + c * c - b * b) / (2 * a), y2 = std::sqrt(std::max(0.0, c * c - x2 * x2));
        flat_[t] = {a, x2, y2};
        const Cotangents cot = cotangents(a, x2, y2);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<int>(s.triangles[t][(k + 1) % 3]),
                       j = static_cast<int>(s.triangles[t][(k + 2) % 3]);
            const double w = cot.c[k] / 2;
            entries.emplace_back(std::max(i, j), std::min(i, j), -w);
            entries.emplace_back(i, i, w);
            entries.emplace_back(j, j, w);
            mass_[static_cast<Eigen::Index>(s.triangles[t][k])] += a * y2 / 6;
        }
    }
    stiffness_.resize(n, n);
    stiffness_.setFromTriplets(entries.begin(), entries.end());
}

void Heat::factorise_flow() {
    Matrix a = stiffness_;
    a *= time_;
    a.diagonal() += mass_;
    if (raised_ == 0) flow_.analyse(a);
    if (!flow_.factorise(a))
        throw Error(Exit::failure, "cannot let heat flow: the surface's matrix is not positive definite; remesh it, or "
                                   "use the exact method");
}

bool Heat::faded(const VectorXd& u) const {
    for (std::uint32_t v = 0; v < surface_.vertices.size(); ++v)
        if (reached_[surface_.component[surface_.outgoing[v] / 3]] != 0 && !(std::abs(u[v]) > kFaded)) return true;
    return false;
}

// Integrated divergence, per vertex, of the unit field that points away from heat.
VectorXd Heat::divergence(const VectorXd& u) const {
    const Surface& s = surface_;
    VectorXd out = VectorXd::Zero(u.size());
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        const double scale = std::max({std::abs(u[a]), std::abs(u[b]), std::abs(u[c])});
        if (!(scale > 0)) continue;
        const auto [x1, x2, y2] = flat_[t];
        const double ub = (u[b] - u[a]) / scale, uc = (u[c] - u[a]) / scale;
        double gx = ub / x1, gy = (uc - gx * x2) / y2;
        const double l = std::sqrt(gx * gx + gy * gy);
        if (!(l > 0)) continue;
        gx /= -l;
        gy /= -l;
        const Cotangents cot = cotangents(x1, x2, y2);
        // components along the sides
        const double ab = gx * x1, bc = gx * (x2 - x1) + gy * y2, ca = -(gx * x2 + gy * y2);
        out[a] += (cot.c[2] * ab - cot.c[1] * ca) / 2;
        out[b] += (cot.c[0] * bc - cot.c[2] * ab) / 2;
        out[c] += (cot.c[1] * ca - cot.c[0] * bc) / 2;
    }
    return out;
}

VectorXd Heat::flow() {
    VectorXd u = flow_.solve(initial_);
    while (!options_.paper && raised_ < kRaises && faded(u)) {
        time_ *= 4;
        ++raised_;
        factorise_flow();
        u = flow_.solve(initial_);
    }
    return u;
}

std::vector<double> Heat::distance() {
    const Surface& s = surface_;
    VectorXd right = -divergence(flow());
    // Known values move to the right-hand side.
    const auto value = [&](std::size_t v) { return reached_[s.component[s.outgoing[v] / 3]] == 0 ? 0.0 : pinned_[v]; };
    for (int col = 0; col < stiffness_.outerSize(); ++col)
        for (Matrix::InnerIterator it(stiffness_, col); it; ++it) {
            if (it.row() == col) continue;
            const double x = value(static_cast<std::size_t>(it.row())), y = value(static_cast<std::size_t>(col));
            if (!std::isnan(x) && std::isnan(y)) right[col] -= it.value() * x;
            if (!std::isnan(y) && std::isnan(x)) right[it.row()] -= it.value() * y;
        }
    for (std::size_t v = 0; v < pinned_.size(); ++v)
        if (!std::isnan(value(v))) right[static_cast<Eigen::Index>(v)] = value(v);
    VectorXd phi = potential_.solve(right);
    if (options_.paper) shift(phi);
    return finished(phi);
}

// Infinite on components without a source; at least 0 elsewhere.
std::vector<double> Heat::finished(const VectorXd& phi) const {
    const Surface& s = surface_;
    std::vector<double> out(phi.data(), phi.data() + phi.size());
    for (std::size_t v = 0; v < out.size(); ++v) {
        if (reached_[s.component[s.outgoing[v] / 3]] == 0) out[v] = kInfinity;
        out[v] = std::max(0.0, out[v]);
    }
    return out;
}

} // namespace filum::geodesic
