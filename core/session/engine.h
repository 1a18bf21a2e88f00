#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/hash.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "complex/nu_complex.h"
#include "delaunay/delaunay.h"
#include "dilated/dilated_complex.h"
#include "homology/embedded_betti.h"
#include "homology/general_betti.h"
#include "homology/surface_betti.h"
#include "landmarks/landmark_lists.h"
#include "metrics/metric.h"
#include "surface/surface_tracker.h"
#include "timeline/timeline.h"

namespace plateau {

/// What a run follows, with all defaults filled in.
struct EngineOptions {
    Family family = Family::Auto;
    MetricOptions metric;
    std::uint32_t dimension = 0;                 ///< largest dimension of a simplex
    std::vector<std::vector<std::uint32_t>> nu;  ///< one sequence a track
    double rho = 0;
    std::uint32_t field = 2;        ///< a prime; that of the Betti numbers
    std::uint32_t other_field = 3;  ///< another one, to tell torsion
    DilatedOptions dilated = {};
};

/// One insertion after the other, through every room: lists, D(L), complex, surface, Betti numbers, and the record of
/// it all.
class Engine {
public:
    /// `cloud` must outlive the engine.
    Engine(const PointCloud& cloud, const EngineOptions& options);

    /// Builds what distances come from until the deadline; true when done, also after a failure.
    bool prepare(const Deadline& deadline) { return lists_.prepare(deadline); }
    std::optional<Error> failure() const { return lists_.failure(); }

    /// Begins a step, which inserts the landmark with this input index. An error leaves the steps before it intact.
    std::optional<Error> begin_step(std::uint32_t input_index);
    /// Whether a step is begun and not complete.
    bool in_step() const { return timeline_.landmarks.size() > timeline_.step_count; }
    /// Goes on with the step until the deadline; true when it is complete. The surface, family dilated and cycles of
    /// complexes that are not embedded can make a step long enough to be cut.
    bool finish_step(const Deadline& deadline);
    /// The next landmark, farthest first, after the first insertion.
    std::uint32_t farthest() const { return lists_.farthest(); }

    const Timeline& timeline() const { return timeline_; }
    /// Of the steps up to this one. Cost: the records since the step of the last call, or all if that was later.
    std::uint64_t hash_at(Step step);
    const LandmarkLists& lists() const { return lists_; }
    /// Bytes of the large tables.
    std::uint64_t memory() const;

private:
    void expect(const DelaunayChange& change) const;
    bool follow_dilated(Step step, Slice& slice);
    void record_dilated(Step step);
    bool count_cycles(Step step, Slice& slice);
    void record_deaths(std::span<const Death> deaths);
    void record_numbers();
    void extend_hash(Step step);

    const PointCloud* cloud_;
    EngineOptions options_;
    Timeline timeline_;
    LandmarkLists lists_;
    std::optional<Delaunay> delaunay_;
    const DelaunayChange* change_ = nullptr;  // of the last step; none without D(L)
    std::optional<NuComplex> complex_;        // one of these two
    std::optional<DilatedComplex> dilated_;
    bool is_followed_ = false;  // it has followed the step that is not complete
    std::optional<SurfaceTracker> surface_;
    std::optional<EmbeddedBetti> embedded_;
    std::optional<SurfaceBetti> surface_betti_;
    std::optional<GeneralBetti> general_;
    Step hashed_ = 0;  // steps in the hash
    std::size_t hashed_hidden_ = 0;
    Fnv1a64 hash_;
};

}  // namespace plateau
