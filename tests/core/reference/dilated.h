#pragma once

#include <vector>

#include "cloud/point_cloud.h"
#include "reference/complex.h"

namespace plateau::reference {

/// What says how the complex of family dilated looks at a step.
struct DilatedSettings {
    std::vector<int> landmarks;           ///< input indices, by step
    std::vector<double> weights_squared;  ///< omega(p)^2, by step
    double zeta = 0;
    double doubt = 0;  ///< a simplex whose distance is that near to zeta is in doubt
};

struct DilatedState {
    Complex complex;
    bool in_doubt = false;  ///< some simplex is
};

/// The weighted witness complex with dilated witnesses from its definition: every witness, every landmark, a least
/// distance program by non-negative least squares for each pair of witness and simplex that no single constraint keeps
/// apart.
DilatedState dilated_complex(const PointCloud& cloud, const DilatedSettings& settings);

/// What of it is spanned by the youngest landmark and those that share an edge with it: its star, and more.
DilatedState dilated_complex_around_youngest(const PointCloud& cloud, const DilatedSettings& settings);

/// The distance of every witness, by input index, to the cell of a simplex; infinity where it is more than `limit` or
/// the cell is empty. zeta and doubt do not matter.
std::vector<double> distances_to_cell(const PointCloud& cloud, const DilatedSettings& settings, const Simplex& simplex,
                                      double limit);

/// Volume by the shortest edge to the power k of a simplex of dimension k, from the Gram determinant; the k-th root of
/// k! times it if `normalized`. 1 for vertices and edges.
double sliver_measure(const PointCloud& cloud, const std::vector<int>& landmarks, const Simplex& simplex,
                      bool normalized);

}  // namespace plateau::reference
