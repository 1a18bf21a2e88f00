#include "reference/run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/duality.h"
#include "reference/elimination.h"

namespace plateau::reference {

Reference::Reference(PointCloud cloud, int first, int max_steps)
    : cloud_(std::move(cloud)),
      order_(farthest_point_order(cloud_, first, max_steps)),
      points_(exact_points(cloud_, order_.landmarks)) {}

const Triangulation& Reference::triangulation(int step) {
    const auto known = triangulations_.find(step);
    if (known != triangulations_.end()) return known->second;
    const auto insertion = static_cast<InsertionOrder>(step % 3);
    return triangulations_[step] = delaunay(cloud_, order_.landmarks, step, insertion);
}

const std::vector<std::vector<int>>& Reference::lists(int step) {
    const auto known = lists_.find(step);
    if (known != lists_.end()) return known->second;
    return lists_[step] = landmark_lists(cloud_, order_, step);
}

StepState Reference::state(const Settings& settings, int step) {
    const int dimension = static_cast<int>(cloud_.dimension);
    const auto index = static_cast<std::size_t>(step - 1);
    StepState state;
    state.landmark = order_.landmarks[index];
    state.epsilon_squared = order_.epsilon_squared[index];
    state.shown = settings.family;

    Complex first = witness_complex(lists(step), settings.nu, dimension);
    if (settings.family == ShownFamily::Witness) {
        state.tracks = {first};
        state.betti = betti_numbers(first, dimension, settings.prime);
        return state;
    }
    const Triangulation& triangulation = this->triangulation(step);
    const Complex delaunay = closure(triangulation.cells);
    state.delaunay_dimension = triangulation.dimension;
    state.tracks = {intersection(first, delaunay)};
    if (settings.family == ShownFamily::Auto) {
        state.tracks.push_back(intersection(witness_complex(lists(step), {1, 2, 3, 4}, dimension), delaunay));
    }
    if (settings.family != ShownFamily::Delaunay && triangulation.dimension == 3) {
        const std::set<Simplex> kept = without_sharp_edges(state.tracks[0][2], points_, settings.rho);
        state.surface = outer_boundary(kept, triangulation, points_);
    }
    if (settings.family == ShownFamily::Auto) {
        state.shown = state.surface.rows.empty() ? ShownFamily::Delaunay : ShownFamily::Surface;
    }
    if (state.shown == ShownFamily::Surface) {
        state.empty = state.surface.rows.empty();
        state.betti = state.surface.betti();
    } else if (settings.counting == Counting::Duality && triangulation.dimension == 3) {
        state.betti = betti_by_duality(state.tracks.back(), triangulation);
    } else {
        state.betti = betti_numbers(state.tracks.back(), dimension, settings.prime);
    }
    return state;
}

std::vector<int> default_nu(ShownFamily family, int dimension) {
    if (family == ShownFamily::Witness) return dimension == 2 ? std::vector{1, 2, 3} : std::vector{1, 2, 3, 4};
    return dimension == 2 ? std::vector{1, 2, 3} : std::vector{1, 6, 6, 4};
}

std::vector<PlateauRun> plateaus(const std::vector<StepState>& states) {
    double last_positive = 0;
    for (const StepState& state : states) {
        if (state.epsilon_squared > 0) last_positive = std::sqrt(state.epsilon_squared);
    }
    const auto epsilon_plus = [&](std::size_t step) {
        const bool known = step <= states.size() && states[step - 1].epsilon_squared > 0;
        return known ? std::sqrt(states[step - 1].epsilon_squared) : last_positive;
    };
    std::vector<PlateauRun> result;
    std::size_t first = 1;
    while (first <= states.size()) {
        const StepState& state = states[first - 1];
        std::size_t last = first;
        while (last < states.size() && states[last].shown == state.shown && states[last].empty == state.empty &&
               states[last].betti == state.betti) {
            ++last;
        }
        if (!state.empty) {
            const double ratio = last_positive > 0 ? epsilon_plus(first) / epsilon_plus(last + 1) : 1;
            result.push_back({static_cast<int>(first), static_cast<int>(last), ratio, state.shown, state.betti});
        }
        first = last + 1;
    }
    return result;
}

}  // namespace plateau::reference
