#pragma once

#include <string>
#include <vector>

#include "cloud/kd_tree.h"
#include "metrics/distance_rows.h"

namespace plateau {

/// Shortest paths in the graph that joins every point to its `neighbors` nearest others, Euclidean, ties to the lowest
/// input index; an edge counts for both of its ends [Tenenbaum, de Silva and Langford, A global geometric framework for
/// nonlinear dimensionality reduction, 2000].
///
/// A length is summed along its path from the witness that the row is for. Rounded sums are monotone, so the shortest
/// ones are the same whatever the order of the search, and a search need not go on behind a witness that it reaches
/// only beyond the limit: whoever is nearer to that witness is at least as near to all behind it.
///
/// Failure: a graph in several pieces. Joining them by force would make shapes that the points do not have.
/// Cost of a row: O(n), and O(log n) an edge in reach.
class GeodesicRows : public DistanceRows {
public:
    /// `cloud` must outlive this; neighbors >= 1.
    GeodesicRows(const PointCloud& cloud, std::uint32_t neighbors);

    bool prepare(const Deadline& deadline) override;
    std::optional<Error> failure() const override { return failure_; }
    void fill(std::uint32_t witness, const Limits& limits, std::span<double> row) override;
    /// No path is shorter than the shortest edge that it can begin with.
    double nearest_other(std::uint32_t witness, std::span<double> row) override;
    double distance(double comparable) const override { return comparable; }
    std::uint64_t memory() const override;

private:
    struct Edge {
        std::uint32_t to;
        double length;
    };
    struct Reached {
        double distance;
        std::uint32_t witness;
        bool operator<(const Reached& other) const {  // a heap's top is the nearest
            return distance > other.distance || (distance == other.distance && witness > other.witness);
        }
    };

    std::span<const Edge> chosen(std::uint32_t witness) const {
        return {nearest_.data() + static_cast<std::size_t>(witness) * neighbors_, neighbors_};
    }
    bool chose(std::uint32_t witness, std::uint32_t other) const;
    void join();
    void look_for_pieces();

    std::uint32_t neighbors_;  // at most n - 1
    KdTree tree_;
    std::vector<Edge> nearest_;            // `neighbors_` a witness, while the graph is built
    std::vector<std::size_t> first_edge_;  // by witness, and one more
    std::vector<Edge> edges_;
    std::optional<Error> failure_;
    std::vector<Reached> heap_;
};

}  // namespace plateau
