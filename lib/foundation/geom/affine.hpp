// Affine maps of space.
#pragma once

#include "geom/vec.hpp"

namespace filum::geom {

// Acts on row vectors, as in 3MF: p' = p * a + t.
struct Affine {
    double a[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double t[3] = {0, 0, 0};

    [[nodiscard]] Vec3 operator()(const Vec3& p) const {
        double q[3];
        for (int j = 0; j < 3; ++j) q[j] = p.x * a[0][j] + p.y * a[1][j] + p.z * a[2][j] + t[j];
        return {q[0], q[1], q[2]};
    }
    // Factor by which volumes change; negative if the map mirrors.
    [[nodiscard]] double determinant() const {
        const Vec3 x{a[0][0], a[0][1], a[0][2]}, y{a[1][0], a[1][1], a[1][2]}, z{a[2][0], a[2][1], a[2][2]};
        return dot(cross(x, y), z);
    }
    [[nodiscard]] bool mirrors() const { return determinant() < 0; }
    // Whether it maps all of space into a plane.
    [[nodiscard]] bool flattens() const { return determinant() == 0; }
};

// The map that applies `inner`, then `outer`.
inline Affine then(const Affine& inner, const Affine& outer) {
    Affine out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            out.a[i][j] = 0;
            for (int k = 0; k < 3; ++k) out.a[i][j] += inner.a[i][k] * outer.a[k][j];
        }
    const Vec3 t = outer({inner.t[0], inner.t[1], inner.t[2]});
    out.t[0] = t.x;
    out.t[1] = t.y;
    out.t[2] = t.z;
    return out;
}

} // namespace filum::geom
