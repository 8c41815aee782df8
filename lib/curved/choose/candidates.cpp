#include "choose/candidates.hpp"

#include "choose/rim_sides.hpp"
#include "geodesic/exact.hpp"

#include <Eigen/Eigenvalues>

#include <numbers>

namespace filum::choose {

namespace {

using surfpath::Algorithm;

constexpr int kDirections = 8;       // over 180 degrees
constexpr double kAlike = 0.9962;    // cosine of 5 degrees: nearer directions are the same
constexpr double kUpright = 0.99985; // cosine of a degree
constexpr double kFlat = 0.3;        // length of the mean normal below which the patch faces all directions
constexpr std::size_t kSides = 6;    // most sides of rims

struct PatchFrame {
    Vec3 centre, normal, axis; // axis: of the greatest extent in the plane perpendicular to the normal
    Vec3 pull;                 // in that plane; 0: none
};

Vec3 unit(const Vec3& v) { return geom::unit(v, v); }
Vec3 of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

// The one of the two signs of a direction with a positive greatest component.
Vec3 signed_way(const Vec3& d) {
    const double most = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const double lead = std::abs(d.x) > 0.999 * most ? d.x : std::abs(d.y) > 0.999 * most ? d.y : d.z;
    return lead < 0 ? -1 * d : d;
}

// The principal axis of a symmetric matrix in the plane perpendicular to `n`.
Vec3 main_axis(const Eigen::Matrix3d& m, const Vec3& n) {
    const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - eigen(n) * eigen(n).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(flat * m * flat);
    const bool clear = solved.eigenvalues()(2) - solved.eigenvalues()(1) > 1e-6 * solved.eigenvalues()(2);
    return clear ? signed_way(of(solved.eigenvectors().col(2))) : Vec3{};
}

PatchFrame frame(const Sheet& sheet, const std::vector<Vec3>& pull) {
    const Surface& s = sheet.surface;
    Vec3 centre{}, normal{};
    double area = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto [a, b, c] = s.triangles[t];
        const Vec3 n = 0.5 * cross(s.vertices[b] - s.vertices[a], s.vertices[c] - s.vertices[a]);
        centre = centre + norm(n) / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
        normal = normal + n;
        area += norm(n);
    }
    PatchFrame out{1 / area * centre, {}, {}, {}};
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero(), pulled = Eigen::Matrix3d::Zero();
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        for (const std::uint32_t v : s.triangles[t]) {
            const Vec3 a = s.vertices[s.triangles[t][0]];
            const double share = norm(cross(s.vertices[s.triangles[t][1]] - a, s.vertices[s.triangles[t][2]] - a));
            const Eigen::Vector3d e = eigen(s.vertices[v] - out.centre);
            spread += share * e * e.transpose();
            if (!pull.empty()) pulled += share * eigen(pull[v]) * eigen(pull[v]).transpose();
        }
    if (norm(normal) > kFlat * area)
        out.normal = unit(normal);
    else
        out.normal = of(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0));
    out.axis = main_axis(spread, out.normal);
    if (!(norm(out.axis) > 0)) { // a disc: any direction
        const Vec3 any = std::abs(out.normal.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        out.axis = unit(any - dot(any, out.normal) * out.normal);
    }
    if (!pull.empty()) out.pull = main_axis(pulled, out.normal);
    return out;
}

std::vector<Vec3> directions(const PatchFrame& f) {
    std::vector<Vec3> out;
    const auto add = [&](const Vec3& d) {
        const bool there =
            std::any_of(out.begin(), out.end(), [&](const Vec3& o) { return std::abs(dot(o, d)) > kAlike; });
        if (!there) out.push_back(signed_way(d));
    };
    const Vec3 lead = norm(f.pull) > 0 ? f.pull : f.axis, side = cross(f.normal, lead);
    for (int k = 0; k < kDirections; ++k) {
        const double a = std::numbers::pi * k / kDirections;
        add(std::cos(a) * lead + std::sin(a) * side);
    }
    add(f.axis);
    add(cross(f.normal, f.axis));
    return out;
}

// The plane perpendicular to `normal` at this fraction of the patch's extent; 0 is the centre. It is aligned with a
// coordinate axis within a degree, and with a round position within a thousandth of the extent, as parts are often
// symmetric about such planes.
Seed plane(const Surface& s, const Vec3& centre, const Vec3& normal, double part) {
    Seed out;
    out.kind = Seed::Kind::plane;
    Vec3 n = normal;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        if (std::abs(dot(n, axis)) > kUpright) n = axis;
    double low = dot(n, centre), high = low;
    for (const Vec3& p : s.vertices) {
        low = std::min(low, dot(n, p));
        high = std::max(high, dot(n, p));
    }
    const double offset = part > 0 ? low + part * (high - low) : dot(n, centre), grain = (high - low) / 1000;
    out.plane = {n, grain > 0 ? std::round(offset / grain) * grain : offset};
    return out;
}

void add_given(const Sheet& sheet, std::vector<Candidate>& out) {
    const auto& given = sheet.sources;
    Seed seed;
    seed.kind = Seed::Kind::given;
    if (surfpath::algorithm(sheet.algorithm) == Algorithm::field) out.push_back({Algorithm::field, seed});
    if (given.empty()) return;
    const bool lines =
        std::any_of(given.segments.begin(), given.segments.end(), [](const surface::Segment& s) { return s.a != s.b; });
    if (const auto planned = surfpath::algorithm(sheet.algorithm); planned && planned != Algorithm::field)
        out.push_back({*planned, seed});
    else if (lines)
        for (const Algorithm algorithm : {Algorithm::fina, Algorithm::fexa, Algorithm::ortheo})
            out.push_back({algorithm, seed});
    else
        for (const Algorithm algorithm : {Algorithm::geo_spiral, Algorithm::ortheo}) out.push_back({algorithm, seed});
}

std::vector<Vec3> places(const Sheet& sheet, const Vec3& centre) {
    const Surface& s = sheet.surface;
    std::vector<Vec3> out{surface::nearest(s, centre).a};
    if (s.rims.empty()) return out;
    const auto distance = geodesic::exact_distances(s, sources(sheet, {}, {})).distance;
    std::size_t far = 0;
    for (std::size_t v = 0; v < distance.size(); ++v)
        if (std::isfinite(distance[v]) && distance[v] > distance[far]) far = v;
    out.push_back(s.vertices[far]);
    return out;
}

} // namespace

std::vector<Candidate> candidates(const Sheet& sheet, const std::vector<Vec3>& pull) {
    const Surface& s = sheet.surface;
    const PatchFrame f = frame(sheet, pull);
    std::vector<Candidate> out;
    add_given(sheet, out);
    if (!pull.empty()) out.push_back({Algorithm::field, {Seed::Kind::stress, {}, {}, {}}});
    for (const Algorithm a : {Algorithm::geo_contour, Algorithm::geo_fiso, Algorithm::hybrid}) out.push_back({a, {}});
    const auto spots = places(sheet, f.centre);
    const auto through = [](Seed::Kind kind, const Vec3& p) { return Seed{kind, {}, p, {}}; };
    for (const Vec3& p : spots) out.push_back({Algorithm::geo_spiral, through(Seed::Kind::point, p)});
    if (!pull.empty())
        for (const Vec3& p : spots) {
            out.push_back({Algorithm::fina, through(Seed::Kind::along, p)});
            out.push_back({Algorithm::ortheo, through(Seed::Kind::across, p)});
        }
    for (const Vec3& d : directions(f)) {
        out.push_back({Algorithm::field, {Seed::Kind::direction, {}, d, {}}});
        const Vec3 across = signed_way(unit(cross(d, f.normal)));
        out.push_back({Algorithm::fexa, plane(s, f.centre, across, 0)});
        for (const double part : {0.0, 0.2, 0.8}) out.push_back({Algorithm::fina, plane(s, f.centre, across, part)});
        for (const double part : {0.0, 0.05, 0.95}) out.push_back({Algorithm::ortheo, plane(s, f.centre, d, part)});
    }
    for (const RimSide& side : longest_sides(s, kSides))
        for (const Algorithm algorithm : {Algorithm::fina, Algorithm::ortheo})
            out.push_back({algorithm, {Seed::Kind::side, {}, side.from, side.to}});
    return out;
}

} // namespace filum::choose
