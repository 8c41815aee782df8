#include "geodesic/exact.hpp"

#include "geodesic/propagation.hpp"

#include <limits>
#include <numbers>

namespace filum::geodesic {

namespace {

constexpr double kFlatAngle = 1e-9; // rad: a smaller excess angle makes no saddle vertex
constexpr double kInLine = 1e-12;   // edges: a source nearer to the line of the edge cannot be seen across it
constexpr double kTouch = 1e-6;     // edges: windows that end nearer to a corner reach it

// Saddle vertices, at which shortest paths may bend: the angle around them exceeds a full turn, or half a turn at a
// rim.
std::vector<char> saddles(const Surface& s, const std::vector<Frame>& frame) {
    std::vector<double> angle(s.vertices.size(), 0);
    for (std::uint32_t h = 0; h < frame.size(); ++h) angle[s.tail(h)] += std::atan2(frame[h].cy, frame[h].cx);
    std::vector<char> out(s.vertices.size());
    for (std::uint32_t v = 0; v < out.size(); ++v)
        out[v] = angle[v] > (s.on_rim(v) ? 1 : 2) * std::numbers::pi + kFlatAngle ? 1 : 0;
    return out;
}

double length(double x, double y) { return std::sqrt(x * x + y * y); }

} // namespace

std::vector<Frame> frames(const Surface& s) {
    std::vector<Frame> out(s.twin.size());
    for (std::uint32_t h = 0; h < out.size(); ++h) {
        const Vec3 u = s.vertices[s.head(h)] - s.vertices[s.tail(h)];
        const Vec3 w = s.vertices[s.tail(surface::prev(h))] - s.vertices[s.tail(h)];
        const double l = norm(u);
        out[h] = {l, dot(u, w) / l, norm(geom::cross(u, w)) / l, 1 / l};
    }
    return out;
}

geom::Vec2 flatten(const Surface& s, const Frame& f, std::uint32_t h, const Vec3& p) {
    const Vec3 &a = s.vertices[s.tail(h)], &b = s.vertices[s.head(h)], &c = s.vertices[s.tail(surface::prev(h))];
    const Vec3 x = f.inverse_length * (b - a), up = (c - a) - f.cx * x;
    return {dot(p - a, x), dot(p - a, up) / f.cy};
}

namespace {

std::shared_ptr<const Unfolding> unfold(const Surface& s) {
    Unfolding out;
    out.frame = frames(s);
    out.across = s.twin;
    out.lists = static_cast<std::uint32_t>(s.twin.size());
    for (auto& list : out.across)
        if (list == kNone) list = out.lists++;
    out.saddle = saddles(s, out.frame);
    out.mean_edge = surface::mean_edge(s);
    return std::make_shared<const Unfolding>(std::move(out));
}

} // namespace

Propagation::Propagation(const Surface& s, bool forgets, std::shared_ptr<const Unfolding> unfolding)
    : surface_(s), forgets_(forgets), unfolding_(unfolding ? std::move(unfolding) : unfold(s)),
      bends_(unfolding_->saddle), slack_(kSlack * unfolding_->mean_edge),
      queue_(s.twin.size() + s.vertices.size(), unfolding_->mean_edge) {
    field_.distance.assign(s.vertices.size(), std::numeric_limits<double>::infinity());
    field_.unfolding = unfolding_;
    field_.first.assign(unfolding_->lists, kNone);
}

void Propagation::reach(std::uint32_t vertex, double distance) {
    const double before = field_.distance[vertex];
    if (distance >= before) return;
    field_.distance[vertex] = distance;
    if (distance < before - slack_ && bends_[vertex] != 0)
        queue_.push(static_cast<std::uint32_t>(surface_.twin.size()) + vertex, distance);
}

// The exit across side `h` of a triangle. In the frame of the triangle beyond, x runs in the opposite direction.
Propagation::ExitSide Propagation::exit_across(std::uint32_t h, bool from_right) const {
    const Frame& f = unfolding_->frame[h];
    return {.list = unfolding_->across[h],
            .tail = surface_.head(h),
            .head = surface_.tail(h),
            .length = f.length,
            .third = surface_.tail(surface::prev(h)),
            .tx = f.length - f.cx,
            .ty = -f.cy,
            .from_right = from_right};
}

// Sends windows from a vertex in all directions.
void Propagation::leave_vertex(std::uint32_t vertex) {
    const double d = field_.distance[vertex];
    each_outgoing(surface_, vertex, [&](std::uint32_t h) {
        reach(surface_.head(h), d + unfolding_->frame[h].length);
        const std::uint32_t back = surface::prev(h);
        reach(surface_.tail(back), d + unfolding_->frame[back].length);
        ExitSide exit = exit_across(surface::next(h), false);
        const double sx = exit.tx, sy = exit.ty;
        exit.third = kNone;
        offer(exit, 0, exit.length, sx, sy, d, false);
    });
}

// Propagates the pending windows of `h` across its triangle.
void Propagation::cross(std::uint32_t h) {
    if (!shut_.empty() && shut_[h / 3] != 0) return;
    const std::uint32_t hr = surface::next(h), hl = surface::prev(h);
    const Frame &f = unfolding_->frame[h], &fr = unfolding_->frame[hr], &fl = unfolding_->frame[hl];
    const double cx = f.cx, cy = f.cy;
    // The right exit leads from the third corner down to the head; the left one from the tail up to the third corner.
    const double rx = (f.length - cx) * fr.inverse_length, ry = -cy * fr.inverse_length;
    const double lx = cx * fl.inverse_length, ly = cy * fl.inverse_length;
    ExitSide right = exit_across(hr, false), left = exit_across(hl, true);
    const std::uint32_t top = right.tail;
    for (std::uint32_t node = field_.first[h]; node != kNone; node = field_.windows[node].next) {
        if (!field_.windows[node].pending) continue;
        field_.windows[node].pending = false;
        const Window w = field_.windows[node];
        if (w.next != kNone) __builtin_prefetch(&field_.windows[w.next]);
        const bool line = w.is_line();
        // Rays through both ends of the window, along (dx, dy). k > 0: the ray passes right of the third corner.
        const double dx0 = line ? w.sx : w.b0 - w.sx, dx1 = line ? w.sx : w.b1 - w.sx, dy = line ? w.sy : -w.sy;
        if (dy < kInLine * (line ? 1 : f.length)) continue;
        const double k0 = dx0 * cy - dy * (cx - w.b0), k1 = dx1 * cy - dy * (cx - w.b1);
        // A ray along the side itself meets it everywhere; then the whole side is taken.
        const auto within = [](double x, double length) { return x > 0 ? std::min(x, length) : 0; };
        const auto on_left = [&](double b, double dx) { return within(dy * b / (dy * lx - dx * ly), fl.length); };
        const auto on_right = [&](double k, double dx) { return within(k / (dy * rx - dx * ry), fr.length); };
        const bool goes_left = k0<0, goes_right = k1> 0;
        if (goes_left && goes_right)
            reach(top, line ? w.sigma + w.sx * cx + w.sy * cy : w.sigma + length(cx - w.sx, cy - w.sy));
        if (goes_left) {
            const double from = on_left(w.b0, dx0), to = goes_right ? fl.length : on_left(w.b1, dx1);
            const double sx = w.sx * lx + w.sy * ly, sy = lx * w.sy - ly * w.sx;
            offer(left, from, to, sx, sy, w.sigma, line);
            if (!goes_right && fl.length - to < kTouch * fl.length) reach(top, w.at(w.b1) + length(cx - w.b1, cy));
        }
        if (goes_right) {
            const double from = goes_left ? 0 : on_right(k0, dx0), to = on_right(k1, dx1);
            const double px = line ? w.sx : w.sx - cx, py = line ? w.sy : w.sy - cy;
            const double sigma = line ? w.sigma + w.sx * cx + w.sy * cy : w.sigma;
            offer(right, from, to, px * rx + py * ry, rx * py - ry * px, sigma, line);
            if (!goes_left && from < kTouch * fr.length) reach(top, w.at(w.b0) + length(cx - w.b0, cy));
        }
    }
}

// Where windows end at a vertex by rounding, on both sides, none may have reached it; this computes its distance.
void Propagation::reach_missed(std::uint32_t h) {
    double &tail = field_.distance[surface_.tail(h)], &head = field_.distance[surface_.head(h)];
    if (std::isfinite(tail) && std::isfinite(head)) return;
    for (std::uint32_t node = field_.first[h]; node != kNone; node = field_.windows[node].next) {
        const Window& w = field_.windows[node];
        tail = std::min(tail, w.at(w.b0) + w.b0);
        head = std::min(head, w.at(w.b1) + unfolding_->frame[h].length - w.b1);
    }
}

// Frees the windows of a list.
void Propagation::forget(std::uint32_t list) {
    if (list < surface_.twin.size()) reach_missed(list);
    for (std::uint32_t node = field_.first[list]; node != kNone;) {
        const std::uint32_t next = field_.windows[node].next;
        field_.windows.drop(node);
        node = next;
    }
    field_.first[list] = kNone;
}

// Windows created while a bucket is processed have distances no smaller than the bucket's lower bound, up to half an
// edge: keys are distances at the ends of windows, which may be nearer in between. An edge is finished when that bound
// exceeds the paths via its ends, since offer() then rejects every window.
double Propagation::run(double farthest, std::uint64_t most) {
    const double row = unfolding_->mean_edge;
    BucketQueue done(forgets_ ? surface_.twin.size() : 0, row);
    double known = std::numeric_limits<double>::infinity();
    for (std::uint32_t id = queue_.pop(farthest); id != kNone; id = queue_.pop(farthest)) {
        if (field_.propagated > most) {
            known = queue_.begin();
            break;
        }
        if (id >= surface_.twin.size()) {
            leave_vertex(id - static_cast<std::uint32_t>(surface_.twin.size()));
            continue;
        }
        cross(id);
        if (!forgets_) continue;
        const double end = std::min(field_.distance[surface_.tail(id)], field_.distance[surface_.head(id)]);
        if (std::isfinite(end)) done.push(id, end + unfolding_->frame[id].length + row);
        while ((id = done.pop(queue_.begin())) != kNone) forget(id);
    }
    for (std::uint32_t h = 0; h < surface_.twin.size(); ++h) reach_missed(h);
    for (double& d : field_.distance)
        if (d > std::min(farthest, known)) d = std::numeric_limits<double>::infinity();
    return std::min(known, farthest);
}

ExactField exact(const Surface& surface, const Sources& sources, double farthest,
                 std::shared_ptr<const Unfolding> unfolding, std::span<const char> shut) {
    Propagation p(surface, false, std::move(unfolding));
    p.shut(shut);
    p.add(sources);
    p.run(farthest, std::numeric_limits<std::uint64_t>::max());
    return p.take();
}

std::vector<char> triangles_beyond(const Surface& s, std::span<const double> distance, double level) {
    std::vector<char> out;
    out.reserve(s.triangles.size());
    for (const auto& [a, b, c] : s.triangles)
        out.push_back(distance[a] > level && distance[b] > level && distance[c] > level ? 1 : 0);
    return out;
}

ExactDistances exact_distances(const Surface& surface, const Sources& sources, double farthest, std::uint64_t most) {
    Propagation p(surface, true, nullptr);
    p.add(sources);
    ExactDistances out;
    out.known = p.run(farthest, most);
    ExactField field = p.take();
    out.distance = std::move(field.distance);
    out.propagated = field.propagated;
    return out;
}

} // namespace filum::geodesic
