#include "stressfield/samples.hpp"

namespace filum::stressfield {

Tensor about(const Vec3& direction, const Principal& principal) {
    const double s1 = principal[0];
    const double across = std::isfinite(principal[1]) && std::isfinite(principal[2]) ? (principal[1] + principal[2]) / 2
                                                                                     : s1 - std::abs(s1);
    const Vec3 d = (1 / norm(direction)) * direction;
    const double along = s1 - across;
    return {across + along * d.x * d.x, across + along * d.y * d.y, across + along * d.z * d.z,
            along * d.x * d.y,          along * d.y * d.z,          along * d.z * d.x};
}

} // namespace filum::stressfield
