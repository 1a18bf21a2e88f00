#pragma once

#include <map>
#include <string>

#include "reference/delaunay.h"
#include "reference/surface.h"
#include "reference/witness.h"

namespace plateau::reference {

enum class ShownFamily { Witness, Delaunay, Surface, Auto };

/// How Betti numbers of complexes within D(L) are found.
enum class Counting { Elimination, Duality };

struct Settings {
    ShownFamily family = ShownFamily::Auto;
    std::vector<int> nu;
    double rho = 0;
    int prime = 2;
    Counting counting = Counting::Elimination;
};

/// All that one step shows, computed from nothing but the cloud.
struct StepState {
    int landmark = 0;  ///< 0-based input index
    double epsilon_squared = 0;
    int delaunay_dimension = 0;   ///< 0 for family witness
    std::vector<Complex> tracks;  ///< two for family auto
    Surface surface;              ///< families surface and auto
    ShownFamily shown = ShownFamily::Witness;
    bool empty = false;  ///< the shown complex has no simplex
    std::vector<int> betti;
};

/// A cloud with its farthest-point order; triangulations are kept because they depend on the step alone.
class Reference {
public:
    explicit Reference(PointCloud cloud, int first = 0, int max_steps = kAllSteps);

    int step_count() const { return static_cast<int>(order_.landmarks.size()); }
    const FarthestOrder& order() const { return order_; }
    const ExactPoints& points() const { return points_; }
    const Triangulation& triangulation(int step);
    const std::vector<std::vector<int>>& lists(int step);
    StepState state(const Settings& settings, int step);

private:
    PointCloud cloud_;
    FarthestOrder order_;
    ExactPoints points_;
    std::map<int, Triangulation> triangulations_;
    std::map<int, std::vector<std::vector<int>>> lists_;
};

/// The nu of a family when none is given.
std::vector<int> default_nu(ShownFamily family, int dimension);

struct PlateauRun {
    int first_step = 0;
    int last_step = 0;
    double ratio = 1;
    ShownFamily family = ShownFamily::Witness;
    std::vector<int> betti;
};

/// Maximal runs of steps with one shown family and one Betti vector, the complex not empty. `states` are those of all
/// steps from the first on.
std::vector<PlateauRun> plateaus(const std::vector<StepState>& states);

}  // namespace plateau::reference
