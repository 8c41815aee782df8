// Geodesic distance by the heat method: approximate, but its time does not grow with distance as that of windows
// (docs/algorithms/geodesic.md#distances-by-heat).
#pragma once

#include "geodesic/sources.hpp"
#include "sparse/factor.hpp"

#include <span>

namespace filum::geodesic {

struct HeatOptions {
    // As in Kipping et al. 2022: sources are the vertices nearest to the ends of segments, the time is the square of
    // the mean edge, and the result is shifted such that the mean over the sources is 0.
    bool paper = false;
};

// The heat method (Crane, Weischedel, Wardetzky 2013) on intrinsic edge lengths, which are all increased by the same
// amount if triangles are slivers (Sharp, Crane 2020). The time is the square of the mean edge, or of 1/420 of the
// box's diagonal if that is greater; it is multiplied by four while heat underflows on its way.
class Heat {
  public:
    // Assembles and factorises both systems, the second with the distances known near the sources.
    // Throws Error(failure) if they are singular or too large.
    Heat(const Surface& surface, const Sources& sources, const HeatOptions& options = {});

    // Distance per vertex, mm; infinite on components without a source. Exact within 16 mean edges of the sources,
    // where the potential is pinned; so line sources act as lines.
    [[nodiscard]] std::vector<double> distance();

    [[nodiscard]] double time() const { return time_; }  // mm2: the time used
    [[nodiscard]] int raised() const { return raised_; } // how often it was multiplied by four

  private:
    struct FlatTriangle { // intrinsic; corner 0 at the origin, 1 on the x axis
        double x1, x2, y2;
    };
    void start(const Sources& sources);
    void start_at(std::uint32_t vertex);
    void start_on(const Segment& segment);
    void keep_one_pinned();
    void shift(Eigen::VectorXd& phi) const;
    void assemble();
    void factorise_flow();
    [[nodiscard]] sparse::Factor poisson_factor(const std::vector<char>& known) const;
    [[nodiscard]] Eigen::VectorXd flow();
    [[nodiscard]] std::vector<double> finished(const Eigen::VectorXd& phi) const;
    [[nodiscard]] bool faded(const Eigen::VectorXd& u) const;
    [[nodiscard]] Eigen::VectorXd divergence(const Eigen::VectorXd& u) const;

    const Surface& surface_;
    HeatOptions options_;
    std::vector<FlatTriangle> flat_; // per triangle
    std::vector<double> pinned_;     // per vertex: its distance if known, otherwise NaN
    std::vector<char> reached_;      // per component: whether it has a source
    Eigen::VectorXd initial_, mass_;
    sparse::Matrix stiffness_;
    sparse::Factor flow_, potential_;
    double time_ = 0;
    int raised_ = 0;
};

} // namespace filum::geodesic
