#include "geom/segment_grid.hpp"

#include "base/none.hpp"

namespace filum::geom {

namespace {

// The most entries of a grid: 4 million, or 24 for each segment.  A cell takes up to 36 bytes.
constexpr double kMostEntries = 4e6, kMostEach = 24;

constexpr double kCellsEach = 4; // the most cells for the mean length of a segment, see cell_for()

// The box of segments, and their length in all.
struct Extent {
    Box2 box;
    double length = 0;
    explicit Extent(std::span<const Segment> segments) {
        for (const Segment& s : segments) {
            box.add(s.a);
            box.add(s.b);
            length += distance(s.a, s.b);
        }
    }
    [[nodiscard]] Vec2 size() const { return box.hi - box.lo; }
};

// At most how many cells segments of this length in all lie in: each as many as it is long and a margin wide.
double entries(double segments, double length, double margin, double cell) {
    return (length / cell + 2 * segments) * (2 * margin / cell + 2);
}

std::vector<std::uint32_t> marked_numbers(std::span<const char> marked) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < marked.size(); ++i)
        if (marked[i] != 0) out.push_back(i);
    return out;
}

std::vector<Segment> chosen(std::span<const Segment> all, std::span<const std::uint32_t> numbers) {
    std::vector<Segment> out;
    out.reserve(numbers.size());
    for (const std::uint32_t i : numbers) out.push_back(all[i]);
    return out;
}

} // namespace

double cell_for(std::span<const Segment> segments, double least) {
    if (segments.empty()) return least;
    const Extent all(segments);
    if (!(all.length > 0)) return least;
    const Vec2 size = all.size();
    const double apart = size.x * size.y / all.length, mean = all.length / static_cast<double>(segments.size());
    return std::max(least, std::clamp(apart, mean / kCellsEach, mean));
}

CellBlocks::CellBlocks(std::span<const Segment> segments, double cell, double margin) : cell_(cell) {
    if (segments.empty()) return;
    const Extent all(segments);
    origin_ = all.box.lo;
    const Vec2 size = all.size();
    const double length = all.length;
    const auto n = static_cast<double>(segments.size());
    const double most = std::min(16e6, 64 + 8 * (n + length / cell));
    const auto blocks = [&](double mm) { return mm / (kSide * cell_) + 1; };
    while (blocks(size.x) * blocks(size.y) > most ||
           entries(n, length, margin, cell_) > std::max(kMostEntries, kMostEach * n))
        cell_ *= 1.5;
    per_mm_ = 1 / cell_;
    columns_ = static_cast<unsigned>(size.x * per_mm_) + 1;
    rows_ = static_cast<unsigned>(size.y * per_mm_) + 1;

    blocks_ = (columns_ - 1) / kSide + 1;
    first_.assign(blocks_ * ((rows_ - 1) / kSide + 1), 0);
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double cell, double margin)
    : CellBlocks(segments, cell, margin) {
    if (segments.empty()) return;
    start_.assign(kSide * kSide + 1, 0);

    // Counts the items of each cell, then sums to the end of each cell; inserting an item moves that down to the
    // cell's start.
    std::vector<std::uint32_t> found, first(segments.size()); // the cells of all segments; the first one of each
    found.reserve(3 * segments.size());                       // most segments are in two cells or three
    for (std::size_t i = 0; i < segments.size(); ++i) {
        first[i] = static_cast<std::uint32_t>(found.size());
        cells_of(segments[i], margin, [&](unsigned x, unsigned y) {
            const std::size_t c = number_in(start_, x, y);
            ++start_[c];
            found.push_back(static_cast<std::uint32_t>(c));
        });
    }
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    item_.resize(start_.back());
    for (auto i = static_cast<std::uint32_t>(segments.size()); i-- > 0;)
        for (; found.size() > first[i]; found.pop_back()) item_[--start_[found.back()]] = i;
}

SegmentPairs::SegmentPairs(std::span<const Segment> segments, double cell, double margin)
    : CellBlocks(segments, cell, margin), segments_(segments), margin_(margin), last_(kSide * kSide + 1, 0),
      entries_(1), met_(segments.size(), kNone) {
    entries_.reserve(3 * segments.size()); // most segments are in two cells or three
}

MarkedSegments::MarkedSegments(std::span<const Segment> all, std::span<const char> marked, double least, double margin)
    : all_(all), marked_(marked.begin(), marked.end()), number_(marked_numbers(marked)),
      segments_(chosen(all, number_)), grid_(segments_, cell_for(segments_, least), margin) {
    const double more = margin + 1e-9 * least; // as in cells_of()
    for (const Segment& s : segments_)
        for (const Vec2 p : {s.a, s.b}) {
            box_.add(p - Vec2{more, more});
            box_.add(p + Vec2{more, more});
        }
}

} // namespace filum::geom
