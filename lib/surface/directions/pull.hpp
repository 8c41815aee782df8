// Along what, and how strongly, a surface is pulled.
#pragma once

#include "surface/directions/cells.hpp"
#include "surface/sheet.hpp"

#include <string>

namespace filum::surface::directions {

struct Pull {
    std::vector<Vec3> along;   // per vertex, unit, in the tangent plane, without a sign; (0, 0, 0): not known
    std::vector<double> load;  // per vertex, MPa (or the vector's length): 0 where pressed, or pulled outwards only
    std::vector<double> trust; // per vertex, 0 to 1: how much the direction says
    [[nodiscard]] bool known(std::size_t vertex) const { return norm(along[vertex]) > 0; }
};

struct PullOptions {
    enum class By : std::uint8_t { either, stress, shape };
    By by = By::either;             // shape: not pulled anywhere; either: by stress if there is one, else shape
    std::vector<std::string> cases; // none: all
    std::string field;              // of vectors, taken instead of stresses; none: stresses
};

// Of every load case stress.CASE the greatest principal stress s1 along d1 has the share s1 (d1 . p)^2 in the tangent
// plane, p being d1's direction in it; at each vertex the case with the greatest counts (the first of equals).  Trust
// is the load's share of what nine tenths of the surface stay below.
// Throws Error(usage) if a field or case is not there, or none at all by "stress"; bad_input if it is of another kind.
Pull pull(const surface::Sheet& sheet, const Cells& cells, const PullOptions& options);

// The directions made smooth and continued to where none are known: z, the direction with its angle doubled in the
// tangent plane, with the least sum over area of trust |z - given|^2 + length^2 |grad z|^2, where neighbours compare
// after turning one tangent plane into the other.  Trust becomes that in the result: |z| times at least a fifth.
// Components without any direction stay so.  (After Knoppel, Crane, Pinkall, Schroeder 2013, "Globally optimal
// direction fields", with a data term.)
void smooth(Pull& pull, const Cells& cells, double length);

} // namespace filum::surface::directions
