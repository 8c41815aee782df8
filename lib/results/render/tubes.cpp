#include "render/tubes.hpp"

#include "base/error.hpp"
#include "render/camera.hpp"
#include "render/hidden.hpp"
#include "render/simplify.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cstring>
#include <thread>

namespace filum::render {

namespace {

using geom::Vec3;

// Beads are drawn wider by this factor; otherwise light shines through where they just touch.
constexpr double kOverlap = 1.03;

struct Box {
    Vec3 lo{INFINITY, INFINITY, INFINITY}, hi{-INFINITY, -INFINITY, -INFINITY};
    void add(Vec3 p, double r, double up) {
        lo = {std::min(lo.x, p.x - r), std::min(lo.y, p.y - r), std::min(lo.z, p.z - up)};
        hi = {std::max(hi.x, p.x + r), std::max(hi.y, p.y + r), std::max(hi.z, p.z + up)};
    }
};

bool drawn(const toolpath::Span& s, bool travels) { return toolpath::extrudes(s.role) || travels; }

double width_of(const toolpath::Span& s, std::size_t i, double thread) {
    return toolpath::extrudes(s.role) ? s.width_at(i) : thread;
}

using PointIndices = std::vector<std::uint32_t>;

// The median of v; `otherwise` if it is empty.
double median(std::vector<double>& v, double otherwise) {
    if (v.empty()) return otherwise;
    const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
    std::nth_element(v.begin(), middle, v.end());
    return *middle;
}

} // namespace

struct Tubes::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<Srgb8> colour; // per segment
    std::vector<Rgb> things;   // colours of the meshes
    unsigned first_thing = 0;  // Embree's number of the first mesh; the others follow
    Vec3 centre, half;
    double stretch = 1;               // z in Embree's space divided by z of the part
    double thickness = 0;             // mm
    double width = 0.4, height = 0.2; // mm, size of a typical bead
    double lift = 0;                  // mm from the top of a bead, where the nozzle was, down to its axis
    bool tilted = false;              // whether beads lie on curved surfaces

    ~State() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
    void measure(const Scene& s, bool travels);
    void fill(const Scene& s, const Tint& tint, bool travels);
    void stand(const Thing& thing);
    // The radius of the round rod that stands for a bead. Beads on curved surfaces lie flat in all directions. There
    // the rod rises over the chord of the bead's width by the bead's height. So its crest, where the nozzle was, and
    // its edges are true, and the part or the neighbours hide the rest. The radius is at most the bead's width,
    // otherwise the rod would appear behind a thin wall.
    [[nodiscard]] double radius(const toolpath::Span& s, std::size_t i) const {
        const double w = width_of(s, i, 0.3 * 2 * thickness);
        if (!tilted || !toolpath::extrudes(s.role)) return w / 2;
        const double h = std::min(s.height_at(i), w / 2);
        return std::min((w * w / 4 + h * h) / (2 * h), w);
    }
    [[nodiscard]] Vec3 axis(const toolpath::Span& s, std::size_t i, double radius) const {
        const Vec3 p = s.points[i];
        if (!tilted) return {p.x, p.y, p.z - lift};
        if (!toolpath::extrudes(s.role)) return p;
        return p - radius * (s.normals.empty() ? Vec3{0, 0, 1} : s.normals[i]);
    }
    [[nodiscard]] RTCRay ray(Vec3 from, Vec3 d, float reach) const {
        return {static_cast<float>(from.x),
                static_cast<float>(from.y),
                static_cast<float>(from.z * stretch),
                0,
                static_cast<float>(d.x),
                static_cast<float>(d.y),
                static_cast<float>(d.z * stretch),
                0,
                reach,
                0xffffffff,
                0,
                0};
    }
};

void Tubes::State::measure(const Scene& s, bool travels) {
    std::vector<double> widths, heights;
    for (const auto& span : s.spans) {
        if (!toolpath::extrudes(span.role)) continue;
        widths.push_back(span.width_at(0));
        heights.push_back(span.height_at(0));
    }
    width = median(widths, 0.4);
    height = median(heights, 0.2);
    tilted = std::any_of(s.spans.begin(), s.spans.end(), [](const auto& x) { return !x.normals.empty(); });
    if (tilted) height = width;
    stretch = width / height;
    thickness = std::max(width, height) / 2;
    lift = height / 2;
    Box box;
    for (const auto& span : s.spans)
        for (std::size_t i = 0; drawn(span, travels) && i < span.points.size(); ++i) {
            const double r = radius(span, i);
            box.add(axis(span, i, r), r, r / stretch);
        }
    for (const Thing& thing : s.meshes)
        for (const Vec3& p : thing.mesh.vertices) box.add(p, 0, 0);
    if (box.lo.x > box.hi.x) return;
    centre = 0.5 * (box.lo + box.hi);
    half = 0.5 * (box.hi - box.lo);
}

void Tubes::State::fill(const Scene& s, const Tint& tint, bool travels) {
    std::vector<PointIndices> kept;
    std::vector<bool> shown; // per segment between kept points: whether it is drawn
    std::size_t points = 0, segments = 0;
    const HiddenBeads hidden(s, width, height);
    for (const auto& span : s.spans) {
        kept.push_back(drawn(span, travels) ? visible_points(span, 0.04 * thickness) : PointIndices{});
        points += kept.back().size();
        for (std::size_t m = 0; m + 1 < kept.back().size(); ++m) {
            const bool bead = toolpath::extrudes(span.role);
            shown.push_back(!bead || !hidden(span.points[kept.back()[m]], span.points[kept.back()[m + 1]]));
            segments += shown.back() ? 1 : 0;
        }
    }
    if (segments == 0) return;
    if (points >= UINT32_MAX) throw Error(Exit::failure, "cannot draw more than 4 billion points; choose fewer layers");
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
    auto* vertex = static_cast<float*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), points));
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(unsigned), segments));
    auto* flags = static_cast<unsigned char*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, 1, segments));
    if (vertex == nullptr || index == nullptr || flags == nullptr) throw std::bad_alloc();
    colour.reserve(segments);
    unsigned at = 0;
    std::size_t next = 0; // index in `shown`
    for (std::size_t k = 0; k < s.spans.size(); ++k) {
        const auto& span = s.spans[k];
        const double fat = toolpath::extrudes(span.role) ? kOverlap / 2 : 0.5;
        double along = 0;
        for (std::size_t m = 0; m < kept[k].size(); ++m, ++at) {
            const std::size_t i = kept[k][m];
            const double r = radius(span, i);
            const Vec3 p = axis(span, i, r) - centre;
            const float v[4] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z * stretch),
                                static_cast<float>(2 * fat * r)};
            std::memcpy(vertex + 4 * std::size_t{at}, v, sizeof v);
            if (m + 1 == kept[k].size()) continue;
            if (shown[next]) {
                const std::size_t n = colour.size();
                index[n] = at;
                const bool left = m > 0 && shown[next - 1], right = m + 2 < kept[k].size() && shown[next + 1];
                flags[n] = static_cast<unsigned char>((left ? RTC_CURVE_FLAG_NEIGHBOR_LEFT : 0) |
                                                      (right ? RTC_CURVE_FLAG_NEIGHBOR_RIGHT : 0));
                colour.push_back(render::colour(tint, s, k, i, along));
            }
            ++next;
            if (tint.by == ColourBy::progress) along += geom::distance(span.points[i], span.points[kept[k][m + 1]]);
        }
    }
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene, g);
    rtcReleaseGeometry(g);
    first_thing = 1;
}

void Tubes::State::stand(const Thing& thing) {
    const auto& m = thing.mesh;
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), m.vertices.size()));
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), m.triangles.size()));
    if (vertex == nullptr || index == nullptr) throw std::bad_alloc();
    for (const Vec3& at : m.vertices) {
        const Vec3 p = at - centre;
        *vertex++ = static_cast<float>(p.x);
        *vertex++ = static_cast<float>(p.y);
        *vertex++ = static_cast<float>(p.z * stretch);
    }
    for (const auto& t : m.triangles) index = std::copy(t.begin(), t.end(), index);
    rtcCommitGeometry(g);
    rtcAttachGeometryByID(scene, g, first_thing + static_cast<unsigned>(things.size()));
    rtcReleaseGeometry(g);
    things.push_back(thing.colour);
}

Tubes::Tubes(const Scene& scene, const Tint& tint, bool travels, int threads) : state_(std::make_unique<State>()) {
    // The limit on threads holds for the whole process. TBB complains if more threads are requested than there are, so
    // no limit is set for all cores.
    const bool fewer = threads > 0 && static_cast<unsigned>(threads) < std::thread::hardware_concurrency();
    // SSE2 runs on any x86-64 processor. Newer instructions would round some pixels differently.
    const std::string config = "isa=sse2" + (fewer ? ",threads=" + std::to_string(threads) : "");
    state_->device = rtcNewDevice(config.c_str());
    if (state_->device == nullptr) throw Error(Exit::failure, "cannot draw in perspective: Embree does not start");
    state_->scene = rtcNewScene(state_->device);
    state_->measure(scene, travels);
    state_->fill(scene, tint, travels);
    for (const Thing& thing : scene.meshes)
        if (!thing.mesh.triangles.empty()) state_->stand(thing);
    rtcCommitScene(state_->scene);
    if (rtcGetDeviceError(state_->device) != RTC_ERROR_NONE)
        throw Error(Exit::failure, "cannot draw in perspective: Embree has no memory left; choose fewer layers");
}

Tubes::~Tubes() = default;

std::array<Hit, 4> Tubes::shoot(Vec3 from, const std::array<Vec3, 4>& direction) const {
    alignas(16) RTCRayHit4 rh{};
    alignas(16) const int all[4] = {-1, -1, -1, -1};
    for (std::size_t k = 0; k < 4; ++k) {
        const RTCRay r = state_->ray(from, direction[k], INFINITY);
        rh.ray.org_x[k] = r.org_x;
        rh.ray.org_y[k] = r.org_y;
        rh.ray.org_z[k] = r.org_z;
        rh.ray.dir_x[k] = r.dir_x;
        rh.ray.dir_y[k] = r.dir_y;
        rh.ray.dir_z[k] = r.dir_z;
        rh.ray.tfar[k] = r.tfar;
        rh.ray.mask[k] = r.mask;
        rh.hit.geomID[k] = rh.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments how;
    rtcInitIntersectArguments(&how);
    how.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect4(all, state_->scene, &rh, &how);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect4(all, state_->scene, &context, &rh);
#endif
    std::array<Hit, 4> out;
    for (std::size_t k = 0; k < 4; ++k) {
        if (rh.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) continue;
        Vec3 n = unit({rh.hit.Ng_x[k], rh.hit.Ng_y[k], rh.hit.Ng_z[k] * state_->stretch});
        if (dot(n, direction[k]) > 0) n = -1.0 * n;
        const bool bead = rh.hit.geomID[k] < state_->first_thing;
        out[k] = {true, rh.ray.tfar[k], n,
                  bead ? from_srgb8(state_->colour[rh.hit.primID[k]])
                       : state_->things[rh.hit.geomID[k] - state_->first_thing]};
    }
    return out;
}

bool Tubes::blocked(Vec3 from, Vec3 direction, float reach) const {
    RTCRay r = state_->ray(from, direction, reach);
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(state_->scene, &r);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(state_->scene, &context, &r);
#endif
    return r.tfar < 0;
}

bool Tubes::empty() const { return state_->colour.empty() && state_->things.empty(); }
Vec3 Tubes::centre() const { return state_->centre; }
Vec3 Tubes::half() const { return state_->half; }
double Tubes::thickness() const { return state_->thickness; }

} // namespace filum::render
