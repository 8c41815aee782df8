#include "surface/flange.hpp"

#include "surface/rim_room.hpp"

#include <array>

namespace filum::surface {

namespace {

constexpr double kLeastDepth = 0.01; // of the depth: less is no flange
constexpr std::size_t kBands = 2;

class Builder {
  public:
    Builder(const Surface& s, double near, double depth)
        : s_(s), share_{near / depth, 1}, depth_(depth), room_(s, depth), vertices_(s.vertices), least_(depth) {
        for (std::uint32_t v = 0; v < s.vertices.size(); ++v) root_.push_back(v);
    }

    Flanged built() {
        for (const Rim& rim : s_.rims) add(rim);
        Flanged out;
        out.surface = grown(s_, std::move(vertices_), triangles_);
        out.root = std::move(root_);
        out.far.assign(s_.triangles.size(), 0);
        out.far.insert(out.far.end(), far_.begin(), far_.end());
        out.least = least_;
        out.least_at = least_at_;
        return out;
    }

  private:
    using Column = std::array<std::uint32_t, kBands + 1>; // vertices from the rim outwards

    void add(const Rim& rim) {
        std::vector<Column> columns;
        for (const Station& now : stations(s_, rim)) columns.push_back(column(now));
        for (std::size_t i = 0; i < columns.size(); ++i) strip(columns[i], columns[(i + 1) % columns.size()]);
    }

    Column column(const Station& from) {
        const Vec3& p = s_.vertices[from.vertex];
        double deep = room_.at(from);
        if (deep < kLeastDepth * depth_) deep = 0;
        if (deep < least_) {
            least_ = deep;
            least_at_ = p;
        }
        Column out{};
        out.fill(from.vertex);
        for (std::size_t k = 0; deep > 0 && k < kBands; ++k) {
            out[k + 1] = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back(p + share_[k] * deep * from.out);
            root_.push_back(from.vertex);
        }
        return out;
    }

    // Between two columns, the first of which lies behind along the rim.
    void strip(const Column& a, const Column& b) {
        for (std::size_t k = 0; k < kBands; ++k) {
            triangle({b[k], a[k], a[k + 1]}, k);
            triangle({b[k], a[k + 1], b[k + 1]}, k);
        }
    }

    void triangle(const Triangle& t, std::size_t band) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
        triangles_.push_back(t);
        far_.push_back(band > 0 ? 1 : 0);
    }

    const Surface& s_;
    std::array<double, kBands> share_; // of the depth, where bands end
    double depth_;
    RimRoom room_;
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> root_;
    std::vector<char> far_; // per triangle of the flange
    double least_;
    Vec3 least_at_;
};

} // namespace

Flanged flanged(const Surface& s, double near, double depth) {
    Closed whole = with_lids(s, depth);
    Flanged out = Builder(whole.surface, near, depth).built();
    out.part = static_cast<std::uint32_t>(s.triangles.size());
    out.lids = std::move(whole.lids);
    return out;
}

} // namespace filum::surface
