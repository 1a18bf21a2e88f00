#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/deadline.h"
#include "cloud/kd_tree.h"
#include "cloud/point_cloud.h"
#include "metrics/distance_rows.h"

namespace plateau {

/// Position of a witness in the order of the tree, 0-based. Not the input index: see LandmarkLists::input_index.
using WitnessId = std::uint32_t;

/// A landmark entered a witness's list.
struct ListEntry {
    WitnessId witness = 0;
    std::uint32_t rank = 0;     ///< 0-based place in the list
    std::uint32_t dropped = 0;  ///< step of the landmark that left the list for it; 0: none did
};

/// The landmark list of every witness: its min(i, kappa) nearest landmarks by (distance, step), and the farthest
/// witness, kept under insertion of landmarks [GO 4.1, 4.2].
///
/// Euclidean distances: a static k-d tree over the witnesses whose nodes hold the largest first and the largest
/// kappa-th distance below them. The root names the farthest witness, and an insertion descends only where the box is
/// nearer than the largest kappa-th distance. About 5.5 n ln n list changes in all, each O(kappa), plus O(log n) nodes
/// around them.
///
/// Any other distances: one row of them a landmark, which is scanned as one leaf of such a tree. O(n) an insertion.
///
/// Distances are kept and compared as comparable ones (see DistanceRows), squared in the tree.
/// Ties: equal distances keep the earlier landmark in front; of equally far witnesses the lowest input index is
/// farthest.
class LandmarkLists {
public:
    /// Euclidean, by the tree. `cloud` must outlive the lists; kappa >= 1. The tree is built by prepare().
    LandmarkLists(const PointCloud& cloud, std::uint32_t kappa);
    /// By the rows of `witnesses` witnesses; kappa >= 1.
    LandmarkLists(std::unique_ptr<DistanceRows> rows, std::uint32_t witnesses, std::uint32_t kappa);

    /// Builds until the deadline passes, at least a small part; true when nothing is left to do. Cost in all: O(n log
    /// n) for the tree.
    bool prepare(const Deadline& deadline);
    /// Why there are no distances, once prepared; then nothing can be inserted.
    std::optional<Error> failure() const { return rows_ ? rows_->failure() : std::nullopt; }

    /// Inserts the landmark with this input index at the given step (1-based, consecutive). The entries name the
    /// witnesses whose list it entered, in tree order; valid until the next call.
    std::span<const ListEntry> insert(std::uint32_t input_index, std::uint32_t step);

    /// Input index of the witness farthest from its nearest landmark. After the first insertion.
    std::uint32_t farthest() const { return extremes_.front().farthest; }
    /// How far it is, comparable; distance() of it is epsilon.
    double farthest_comparable() const { return extremes_.front().largest_first; }
    /// The distance of a comparable one, in input units.
    double distance(double comparable) const;

    /// Comparable distance of a witness to the nearest other witness, landmark or not; infinity where there is none.
    /// Once prepared. Cost: O(log n) on the average by the tree, else a row.
    double nearest_other_comparable(WitnessId witness) const;

    /// The tree over the witnesses, where distances are Euclidean.
    const KdTree& tree() const { return *tree_; }
    std::uint32_t kappa() const { return kappa_; }
    std::uint32_t size() const { return size_; }
    std::uint32_t input_index(WitnessId witness) const { return tree_ ? tree_->input_index(witness) : witness; }
    /// Tree position of the point with this input index.
    WitnessId witness(std::uint32_t input_index) const { return tree_ ? tree_->position(input_index) : input_index; }
    /// Steps of the witness's nearest landmarks, nearest first; kappa of them, 0 beyond the landmarks so far.
    std::span<const std::uint32_t> list(WitnessId witness) const {
        return {steps_.data() + static_cast<std::size_t>(witness) * kappa_, kappa_};
    }
    /// Comparable distances of the same landmarks; infinity beyond the landmarks so far.
    std::span<const double> comparable_distances(WitnessId witness) const {
        return {comparable_.data() + static_cast<std::size_t>(witness) * kappa_, kappa_};
    }
    /// Bytes held for the distances: tree or rows, and lists.
    std::uint64_t memory() const;

private:
    /// Of the witnesses below a node.
    struct Extremes {
        double largest_first;
        double largest_last;  // of the kappa-th distances
        std::uint32_t farthest;
    };

    template <class Axes>
    bool visit(std::uint32_t node_index, const double* p, std::uint32_t step, Axes axes);
    template <class Comparable, class InputIndex>
    void visit_leaf(WitnessId begin, WitnessId end, Extremes& extremes, std::uint32_t step,
                    const Comparable& comparable, const InputIndex& index_of);

    std::uint32_t size_;
    std::uint32_t kappa_;
    std::optional<KdTree> tree_;  // one of these two
    std::unique_ptr<DistanceRows> rows_;
    mutable std::vector<double> row_;  // scratch
    std::vector<double> comparable_;
    std::vector<std::uint32_t> steps_;
    std::vector<Extremes> extremes_;  // by node; the scan has one
    std::vector<ListEntry> entries_;
};

}  // namespace plateau
