// The lists of windows: each is the lower envelope of all windows that reached its half-edge.
#include "base/error.hpp"
#include "geodesic/propagation.hpp"

namespace filum::geodesic {

namespace {

constexpr double kNarrow = 1e-9;      // edges, and rad as seen from the source: narrower windows are dropped
constexpr double kRounding = 1e-15;   // edges: below the width of any window and any real difference
constexpr double kLevelSlope = 1e-12; // slope: flatter lines never cross an edge
constexpr std::uint32_t kNew = 0;

// Whether both windows have the same source on [b0, b1], or the same linear distance, up to rounding.
bool same_source(const Window& a, const Window& b, double b0, double b1, double slack) {
    if (a.is_line() != b.is_line() || a.pending != b.pending) return false;
    if (a.is_line()) return std::abs(a.at(b0) - b.at(b0)) <= slack && std::abs(a.at(b1) - b.at(b1)) <= slack;
    return std::abs(a.sigma - b.sigma) <= slack && std::abs(a.sx - b.sx) <= slack && std::abs(a.sy - b.sy) <= slack;
}

// Whether the part [b0, b1] of a window is kept. Near its source it may be narrow, because it widens. False for NaN.
bool wide(const Window& w, double b0, double b1, double length) {
    const double width = b1 - b0;
    if (width > kNarrow * length) return true;                      // the usual case, without a square root
    if (!(width > kRounding * length) || w.is_line()) return false; // a line source is about as far as the edge is long
    const double x = (b0 + b1) / 2 - w.sx;
    if (width < kNarrow * 0.9 * std::max(std::abs(x), std::abs(w.sy))) return false; // decided without a square root
    return width > kNarrow * std::hypot(x, w.sy);
}

} // namespace

// mm: differences of distances of about this size that count as equal. Near sources even the smallest differences
// decide which windows survive.
double Propagation::slack(double distance, double length) const {
    return std::min(slack_, kSlack * distance) + kRounding * length;
}

std::uint32_t Propagation::fresh() {
    if (!free_.empty()) {
        const std::uint32_t node = free_.back();
        free_.pop_back();
        return node;
    }
    if (field_.windows.size() >= (std::size_t{1} << 31))
        throw Error(Exit::failure, "cannot compute exact distances: the surface needs too many windows; remesh it "
                                   "coarser, or use the heat method");
    field_.windows.add();
    return static_cast<std::uint32_t>(field_.windows.size() - 1);
}

void Propagation::add_piece(std::uint32_t owner, double b0, double b1, double length) {
    const bool kept = wide(owners_[owner], b0, b1, length);
    changed_ = changed_ || (owner == kNew && kept);
    if (!pieces_.empty()) {
        EnvelopePiece& last = pieces_.back();
        if (b0 - last.b1 <= kNarrow * length &&
            (last.owner == owner || same_source(owners_[last.owner], owners_[owner], last.b0, b1,
                                                10 * slack(owners_[owner].at(b1), length)))) {
            last.b1 = b1;
            return;
        }
    }
    if (kept) pieces_.push_back({owner, b0, b1});
}

// Splits the overlap of the new window with an old one: each gets where it is nearer; ties go to the old one.
void Propagation::add_overlap(std::uint32_t old, double lo, double hi, double length) {
    const Window &w = owners_[kNew], &o = owners_[old];
    const double ahead_lo = o.at(lo) - w.at(lo), ahead_hi = o.at(hi) - w.at(hi);
    const double least = slack(std::min(w.at(lo), w.at(hi)), length);
    const bool better_lo = ahead_lo > least, better_hi = ahead_hi > least;
    // They may be equal at two places inside, except if they differ by more than their slopes allow; with equal sigma,
    // at one place.
    const bool far = std::abs(ahead_lo) + std::abs(ahead_hi) > 2 * (hi - lo);
    if (better_lo == better_hi && (far || (w.sigma == o.sigma && !w.is_line() && !o.is_line()))) {
        add_piece(better_lo ? kNew : old, lo, hi, length);
        return;
    }
    const Crossings c = crossings(w, o, lo, hi);
    double from = lo;
    for (int i = 0; i <= c.count; ++i) {
        const double to = i < c.count ? c.x[i] : hi, m = (from + to) / 2;
        add_piece(w.at(m) < o.at(m) - slack(w.at(m), length) ? kNew : old, from, to, length);
        from = to;
    }
}

// Replaces the list by the lower envelope of itself and `w`.
void Propagation::insert(ExitSide& exit, const Window& w) {
    const Windows& windows = field_.windows;
    const double length = exit.length;
    // Windows from different sources may arrive in another order than along the edge.
    std::uint32_t before = exit.cursor;
    if (before != kNone && windows[before].b1 > w.b0) before = kNone;
    std::uint32_t first = before == kNone ? field_.first[exit.list] : windows[before].next;
    const auto continued = [&](const Window& o) { // whether `w` continues `o`
        return o.b1 >= w.b0 - kNarrow * length && same_source(o, w, w.b0, w.b1, 10 * slack(w.at(w.b0), length));
    };
    while (first != kNone && windows[first].b1 <= w.b0 && !continued(windows[first])) {
        before = first;
        first = windows[first].next;
    }
    exit.cursor = before;
    owners_.assign(1, w);
    pieces_.clear();
    changed_ = false;
    double x = w.b0; // everything before this is decided
    std::uint32_t o = first;
    for (; o != kNone && windows[o].b0 < w.b1; o = windows[o].next) {
        const auto old = static_cast<std::uint32_t>(owners_.size());
        owners_.push_back(windows[o]);
        const Window& was = windows[o];
        if (was.b0 < w.b0)
            add_piece(old, was.b0, std::min(was.b1, w.b0), length);
        else if (was.b0 > x)
            add_piece(kNew, x, was.b0, length);
        const double lo = std::max(was.b0, w.b0), hi = std::min(was.b1, w.b1);
        if (hi > lo) add_overlap(old, lo, hi, length);
        if (was.b1 > w.b1) add_piece(old, w.b1, was.b1, length);
        x = std::max(x, was.b1);
    }
    if (x < w.b1) add_piece(kNew, x, w.b1, length);
    if (changed_) rewrite(exit, before, first, o);
}

// Replaces the windows from `first` up to, but not including, `after` by the pieces.
void Propagation::rewrite(ExitSide& exit, std::uint32_t before, std::uint32_t first, std::uint32_t after) {
    std::uint32_t spare = first;
    for (const EnvelopePiece& p : pieces_) {
        std::uint32_t node = spare;
        if (node != after)
            spare = field_.windows[node].next;
        else
            node = fresh();
        Window& n = field_.windows[node];
        n = owners_[p.owner];
        n.b0 = p.b0;
        n.b1 = p.b1;
        (before == kNone ? field_.first[exit.list] : field_.windows[before].next) = node;
        before = node;
    }
    (before == kNone ? field_.first[exit.list] : field_.windows[before].next) = after;
    while (spare != after) {
        const std::uint32_t next = field_.windows[spare].next;
        if (forgets_)
            field_.windows.drop(spare);
        else
            free_.push_back(spare);
        spare = next;
    }
}

// Offers a window to an exit. If `line`, (sx, sy) is the direction of a line source.
void Propagation::offer(ExitSide& exit, double b0, double b1, double sx, double sy, double sigma, bool line) {
    if (line && sy < kLevelSlope) return;
    if (!line) sy = std::min(sy, 0.0);
    Window w{b0, b1, sx, sy, sigma, kNone, exit.list < surface_.twin.size()};
    if (!wide(w, b0, b1, exit.length)) return; // also if it is NaN: the source lies on the exit's line
    const double at0 = w.at(b0), at1 = w.at(b1);
    // If a path via a corner is shorter at the window's far end, it is shorter on the whole window (Xin, Wang 2009).
    const auto& d = field_.distance;
    const double least = slack(std::min(at0, at1), exit.length);
    if (d[exit.tail] + b1 < at1 - least || d[exit.head] + (exit.length - b0) < at0 - least) return;
    if (exit.third != kNone) {
        const double q = exit.from_right ? b0 : b1, dx = q - exit.tx;
        if (d[exit.third] + std::sqrt(dx * dx + exit.ty * exit.ty) < (exit.from_right ? at0 : at1) - least) return;
    }
    ++field_.propagated;
    insert(exit, w);
    const bool foot = !line && sx > b0 && sx < b1; // whether the least distance is inside the window, not at an end
    if (w.pending) queue_.push(exit.list, foot ? sigma - sy : std::min(at0, at1));
}

} // namespace filum::geodesic
