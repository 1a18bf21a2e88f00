#pragma once

#include <string>

#include "cloud/point_cloud.h"
#include "reference/exact.h"
#include "reference/triangulation.h"

namespace plateau::reference {

/// The order in which the landmarks of a step enter a fresh triangulation.
enum class InsertionOrder { Reversed, Lexicographic, Shuffled };

/// D(L) of steps 1 .. step.
Triangulation delaunay(const PointCloud& cloud, const std::vector<int>& landmarks, int step, InsertionOrder order);
/// The same of a cloud in the plane, by the triangulation of the plane.
Triangulation delaunay_in_plane(const PointCloud& cloud, const std::vector<int>& landmarks, int step);

/// All simplices of the dimension of the affine hull, by brute force over tuples.
struct EmptySpheres {
    int dimension = 0;
    std::set<Simplex> empty;  ///< no landmark inside or on the circumsphere: certainly in D(L)
    std::set<Simplex> tied;   ///< none inside, others on it: D(L) has some of these
};
EmptySpheres empty_spheres(const ExactPoints& points, int step);

/// Compares a triangulation with the empty spheres, without a tie by equality. Empty if all is well.
std::string complaint_about(const Triangulation& triangulation, const EmptySpheres& spheres);

/// Checks only that no landmark lies inside the circumsphere of a cell: for steps with too many tuples.
std::string complaint_about_cells(const Triangulation& triangulation, const ExactPoints& points, int step);

std::string print(const Simplex& simplex);

}  // namespace plateau::reference
