#include "geodesic/exact.hpp"

#include "geodesic/propagation.hpp"

#include <limits>
#include <numbers>

namespace filum::geodesic {

namespace {

constexpr double kFlatAngle = 1e-9; // rad: less excess makes no saddle
constexpr double kInLine = 1e-12;   // of the edge: sources nearer to its line cannot be seen across it
constexpr double kTouch = 1e-6;     // of the edge: windows that end nearer to a corner reach it

// Vertices that shortest paths may bend at: the angle around them is more than full, or at a rim more than half.
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

std::shared_ptr<const Ground> ground_of(const Surface& s) {
    Ground out;
    out.frame = frames(s);
    out.across = s.twin;
    out.lists = static_cast<std::uint32_t>(s.twin.size());
    for (auto& list : out.across)
        if (list == kNone) list = out.lists++;
    out.spreads = saddles(s, out.frame);
    out.mean_edge = surface::mean_edge(s);
    return std::make_shared<const Ground>(std::move(out));
}

} // namespace

Propagation::Propagation(const Surface& s, bool forgets, std::shared_ptr<const Ground> ground)
    : surface_(s), forgets_(forgets), ground_(ground ? std::move(ground) : ground_of(s)), spreads_(ground_->spreads),
      slack_(kSlack * ground_->mean_edge), queue_(s.twin.size() + s.vertices.size(), ground_->mean_edge) {
    field_.distance.assign(s.vertices.size(), std::numeric_limits<double>::infinity());
    field_.ground = ground_;
    field_.first.assign(ground_->lists, kNone);
}

void Propagation::reach(std::uint32_t vertex, double distance) {
    const double before = field_.distance[vertex];
    if (distance >= before) return;
    field_.distance[vertex] = distance;
    if (distance < before - slack_ && spreads_[vertex] != 0)
        queue_.push(static_cast<std::uint32_t>(surface_.twin.size()) + vertex, distance);
}

// The exit by side `h` of a triangle.  In the frame of what lies beyond, x runs the other way.
Propagation::Side Propagation::exit_across(std::uint32_t h, bool from_right) const {
    const Frame& f = ground_->frame[h];
    return {.list = ground_->across[h],
            .tail = surface_.head(h),
            .head = surface_.tail(h),
            .length = f.length,
            .third = surface_.tail(surface::prev(h)),
            .tx = f.length - f.cx,
            .ty = -f.cy,
            .from_right = from_right};
}

// Windows from a vertex to all around it.
void Propagation::leave_vertex(std::uint32_t vertex) {
    const double d = field_.distance[vertex];
    each_outgoing(surface_, vertex, [&](std::uint32_t h) {
        reach(surface_.head(h), d + ground_->frame[h].length);
        const std::uint32_t back = surface::prev(h);
        reach(surface_.tail(back), d + ground_->frame[back].length);
        Side exit = exit_across(surface::next(h), false);
        const double sx = exit.tx, sy = exit.ty;
        exit.third = kNone;
        offer(exit, 0, exit.length, sx, sy, d, false);
    });
}

// Takes the windows that wait at `h` across its triangle.
void Propagation::cross(std::uint32_t h) {
    if (!shut_.empty() && shut_[h / 3] != 0) return;
    const std::uint32_t hr = surface::next(h), hl = surface::prev(h);
    const Frame &f = ground_->frame[h], &fr = ground_->frame[hr], &fl = ground_->frame[hl];
    const double cx = f.cx, cy = f.cy;
    // The right exit leads from the third corner down to the head, the left one from the tail up to the third corner.
    const double rx = (f.length - cx) * fr.inverse_length, ry = -cy * fr.inverse_length;
    const double lx = cx * fl.inverse_length, ly = cy * fl.inverse_length;
    Side right = exit_across(hr, false), left = exit_across(hl, true);
    const std::uint32_t top = right.tail;
    for (std::uint32_t node = field_.first[h]; node != kNone; node = field_.windows[node].next) {
        if (!field_.windows[node].pending) continue;
        field_.windows[node].pending = false;
        const Window w = field_.windows[node];
        if (w.next != kNone) __builtin_prefetch(&field_.windows[w.next]);
        const bool line = w.is_line();
        // rays through both ends of the window, along (dx, dy); k > 0: the ray passes the third corner to its right
        const double dx0 = line ? w.sx : w.b0 - w.sx, dx1 = line ? w.sx : w.b1 - w.sx, dy = line ? w.sy : -w.sy;
        if (dy < kInLine * (line ? 1 : f.length)) continue;
        const double k0 = dx0 * cy - dy * (cx - w.b0), k1 = dx1 * cy - dy * (cx - w.b1);
        // Of a ray along the side itself no place can be told: all of the side is as good as any.
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

// Where windows end at a vertex by rounding, from both sides, none may have told it its distance.
void Propagation::reach_missed(std::uint32_t h) {
    double &tail = field_.distance[surface_.tail(h)], &head = field_.distance[surface_.head(h)];
    if (std::isfinite(tail) && std::isfinite(head)) return;
    for (std::uint32_t node = field_.first[h]; node != kNone; node = field_.windows[node].next) {
        const Window& w = field_.windows[node];
        tail = std::min(tail, w.at(w.b0) + w.b0);
        head = std::min(head, w.at(w.b1) + ground_->frame[h].length - w.b1);
    }
}

// Gives back the windows of a list.
void Propagation::forget(std::uint32_t list) {
    if (list < surface_.twin.size()) reach_missed(list);
    for (std::uint32_t node = field_.first[list]; node != kNone;) {
        const std::uint32_t next = field_.windows[node].next;
        field_.windows.drop(node);
        node = next;
    }
    field_.first[list] = kNone;
}

// Whatever comes while a row is at work is no nearer than where the row begins, but for half an edge: keys are
// distances at the ends of windows, which may be nearer between.  An edge is done with when all such is farther than
// the ways over its ends, since then offer() turns it down.
double Propagation::run(double farthest, std::uint64_t most) {
    const double row = ground_->mean_edge;
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
        if (std::isfinite(end)) done.push(id, end + ground_->frame[id].length + row);
        while ((id = done.pop(queue_.begin())) != kNone) forget(id);
    }
    for (std::uint32_t h = 0; h < surface_.twin.size(); ++h) reach_missed(h);
    for (double& d : field_.distance)
        if (d > std::min(farthest, known)) d = std::numeric_limits<double>::infinity();
    return std::min(known, farthest);
}

ExactField exact(const Surface& surface, const Sources& sources, double farthest, std::shared_ptr<const Ground> ground,
                 std::span<const char> shut) {
    Propagation p(surface, false, std::move(ground));
    p.shut(shut);
    p.add(sources);
    p.run(farthest, std::numeric_limits<std::uint64_t>::max());
    return p.take();
}

std::vector<char> beyond(const Surface& s, std::span<const double> distance, double level) {
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
