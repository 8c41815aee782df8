#include "stressfield/samples.hpp"

namespace filum::stressfield {

Tensor about(const Vec3& direction, const Principal& principal) {
    const auto [s1, s2, s3] = principal;
    const double length = norm(direction);
    if (length == 0) return {s1, s1, s1, 0, 0, 0};
    const Vec3 d = (1 / length) * direction;
    const double round = std::isfinite(s2) && std::isfinite(s3) ? (s2 + s3) / 2 : s1 - std::abs(s1);
    const double along = s1 - round;
    return {round + along * d.x * d.x, round + along * d.y * d.y, round + along * d.z * d.z,
            along * d.x * d.y,         along * d.y * d.z,         along * d.z * d.x};
}

} // namespace filum::stressfield
