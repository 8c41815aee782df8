#include "plate/nest.hpp"

#define LIBNEST2D_GEOMETRIES_clipper
#define LIBNEST2D_OPTIMIZER_nlopt
#define LIBNEST2D_THREADING_std
#include <libnest2d/libnest2d.hpp>

#include <cmath>

namespace filum::plate {

namespace {

const double kQuarter = std::acos(0.0); // rad

} // namespace

Nesting nest(const std::vector<Corners>& polygons, double width, double depth, bool turn) {
    using namespace libnest2d;
    std::vector<Item> items;
    items.reserve(polygons.size());
    for (const Corners& p : polygons) {
        PolygonImpl shape; // closed and clockwise, as the library requires
        for (std::size_t i = p.x.size(); i-- > 0;) shape.Contour.push_back({mm(p.x[i]), mm(p.y[i])});
        shape.Contour.push_back(shape.Contour.front());
        items.emplace_back(std::move(shape));
    }
    NestConfig<> how;
    how.placer_config.rotations = {0.0};
    if (turn)
        for (int k = 1; k < 4; ++k) how.placer_config.rotations.emplace_back(k * kQuarter);
    how.placer_config.parallel = false; // threads would save only milliseconds
    libnest2d::nest(items, Box(mm(width), mm(depth), {0, 0}), 0, how);
    Nesting out;
    const auto to_mm = [](Coord c) { return static_cast<double>(c) / static_cast<double>(mm(1.0)); };
    for (const Item& item : items) {
        out.x.push_back(to_mm(item.translation().X));
        out.y.push_back(to_mm(item.translation().Y));
        out.quarters.push_back(static_cast<int>(std::lround(static_cast<double>(item.rotation()) / kQuarter)) & 3);
        out.on_bed.push_back(item.binId() < 0 ? items.size() : static_cast<std::size_t>(item.binId()));
    }
    return out;
}

} // namespace filum::plate
