#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "base/result.h"
#include "cloud/kd_tree.h"
#include "cloud/point_cloud.h"
#include "complex/simplex_table.h"
#include "landmarks/landmark_lists.h"
#include "metrics/metric.h"

namespace plateau {

/// Where landmarks stand among the nearest ones of every witness, with so many landmarks as there were at one step:
/// rank r is the r-th place of its landmark list, were the list that long. Ties: the earlier landmark in front.
class LandmarkRanks {
public:
    virtual ~LandmarkRanks() = default;

    /// Witnesses are named by input index.
    virtual std::uint32_t witness_count() const = 0;
    /// Ranks beyond this one are not told.
    virtual std::uint32_t horizon() const = 0;
    /// The rank of the landmark at the witness, or any number above `limit` if it is larger. limit <= horizon().
    virtual std::uint32_t rank(std::uint32_t witness, Step landmark, std::uint32_t limit) const = 0;
    /// The largest rank of a vertex, likewise.
    virtual std::uint32_t largest_rank(std::uint32_t witness, std::span<const Step> simplex,
                                       std::uint32_t limit) const = 0;
    /// The comparable distance of the farthest vertex, where it costs little: a witness for which it is small is likely
    /// to have the vertices at small ranks. Else 0.
    virtual double reach(std::uint32_t witness, std::span<const Step> simplex) const = 0;
};

/// Of straight distances: how many landmarks are nearer is counted in a tree over the landmarks, whose parts within or
/// beyond the distance are counted as a whole. Cost: O(i log i) once; a rank O(log i) and more, as many nodes as the
/// sphere meets, at most O(limit + log i).
class TreeRanks : public LandmarkRanks {
public:
    /// Rows of `landmarks` by step - 1; both clouds of the same dimension, and they must outlive this.
    TreeRanks(const PointCloud& witnesses, const PointCloud& landmarks);

    std::uint32_t witness_count() const override { return witnesses_->size(); }
    std::uint32_t horizon() const override { return landmarks_->size(); }
    std::uint32_t rank(std::uint32_t witness, Step landmark, std::uint32_t limit) const override;
    std::uint32_t largest_rank(std::uint32_t witness, std::span<const Step> simplex,
                               std::uint32_t limit) const override;
    double reach(std::uint32_t witness, std::span<const Step> simplex) const override;

private:
    struct Farthest {
        double distance_squared = -1;
        Step landmark = 0;
    };
    Farthest farthest(std::uint32_t witness, std::span<const Step> simplex) const;
    std::uint32_t rank(std::uint32_t witness, const Farthest& of, std::uint32_t limit) const;
    template <class Axes>
    void count(std::uint32_t node, const double* witness, const Farthest& of, std::uint32_t limit, Axes axes,
               std::uint32_t& nearer) const;

    const PointCloud* witnesses_;
    const PointCloud* landmarks_;
    KdTree tree_;
};

/// Of any other distances: lists as the run has them, only longer, so that ranks beyond kHorizon are not told.
/// Cost: as a run up to the step, O(n) a landmark for the distances, geodesic ones O(n log n) at worst.
class ListRanks : public LandmarkRanks {
public:
    static constexpr std::uint32_t kHorizon = 64;

    /// `landmarks`: input indices by step - 1. Error: that of the metric.
    static Result<ListRanks> of(const PointCloud& cloud, const MetricOptions& metric,
                                std::span<const std::uint32_t> landmarks);

    std::uint32_t witness_count() const override { return lists_.size(); }
    std::uint32_t horizon() const override { return horizon_; }
    std::uint32_t rank(std::uint32_t witness, Step landmark, std::uint32_t limit) const override;
    std::uint32_t largest_rank(std::uint32_t witness, std::span<const Step> simplex,
                               std::uint32_t limit) const override;
    double reach(std::uint32_t, std::span<const Step>) const override { return 0; }

private:
    ListRanks(LandmarkLists lists, std::uint32_t horizon) : lists_(std::move(lists)), horizon_(horizon) {}

    LandmarkLists lists_;
    std::uint32_t horizon_;
};

}  // namespace plateau
