// Five hundred damaged meshes and more: what is printed of them, against the mesh before.
#include "mesh/place.hpp"
#include "mutate.hpp"
#include "polygon/clip.hpp"
#include "slice/slice.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

using namespace filum;

namespace {

struct Printed {
    double volume = 0;
    Notes notes;
};

Printed printed(const mesh::Mesh& m, double h) {
    Printed out;
    const auto part = slice::make_part(m, out.notes);
    for (const auto& l : slice::slice(part, {.layer_height = h}, out.notes, 1))
        out.volume += l.height * polygon::signed_area(l.contours);
    return out;
}

} // namespace

TEST(Mutants, probe) {
    std::vector<std::pair<const char*, mesh::Mesh>> parts = {
        {"box", shapes::box({0, 0, 0}, {12, 7, 5})},
        {"sphere", shapes::sphere(6, 4)},
        {"torus", shapes::torus(9, 3, 60, 30)},
        {"hollow", shapes::together(shapes::sphere(8, 4), shapes::inverted(shapes::sphere(5, 3)))},
    };
    const char* only = std::getenv("KIND");
    for (auto& [name, m] : parts) {
        const double v0 = printed(m, 0.05).volume;
        for (const auto& k : mutate::kinds()) {
            if (only && !std::strstr(k.name, only)) continue;
            for (double s : {0.1, 0.5, 1.0}) {
                mutate::Dice dice{42};
                mesh::Mesh x = mutate::welded(k.make(m, s, dice));
                if (x.triangles.empty()) continue;
                try {
                    const auto p = printed(x, 0.2);
                    const double dev = p.volume / v0 - 1;
                    if (std::abs(dev) > 0.02) {
                        std::printf("%-7s %-36s %.1f %+7.2f %%", name, k.name, s, 100 * dev);
                        std::map<std::string, double> sums;
                        for (const auto& n : p.notes) sums[n.what] += n.amount;
                        for (const auto& [w, a] : sums) std::printf(" | %s %.3g", w.substr(0, 40).c_str(), a);
                        std::printf("\n");
                    }
                } catch (const std::exception& e) {
                    std::printf("%-7s %-36s %.1f  %s\n", name, k.name, s, e.what());
                }
            }
        }
    }
}
