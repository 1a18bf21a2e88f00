#include "inspect/inspect_run.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "base/words.h"
#include "inspect/dilated_sightings.h"

namespace plateau {

namespace {

/// The complex shown at one step of a record.
class ShownComplex : public Inspected {
public:
    ShownComplex(const RunBasis& basis, const Timeline& timeline, Step step)
        : basis_(&basis), timeline_(&timeline), step_(step), track_(timeline.shown_track(step)) {}

    Step landmark_count() const override { return step_; }
    int max_dimension() const override { return static_cast<int>(timeline_->dimension); }
    bool has(std::span<const Step> simplex) const override {
        if (simplex.size() == 1) return is_vertex(simplex.front());
        if (static_cast<int>(simplex.size()) > max_dimension() + 1) return false;
        const SimplexTable& table = timeline_->table(static_cast<int>(simplex.size()) - 1);
        const SimplexIndex index = table.find(simplex);
        return index != kNoSimplex && table.lives(index, track_, step_);
    }

    Result<std::optional<DelaunayPlace>> delaunay(std::span<const Step> simplex) const override {
        if (!is_within_delaunay(timeline_->family)) return std::optional<DelaunayPlace>();
        auto place = delaunay_place(landmarks(), simplex);
        if (!place) return place.error();
        return std::optional(std::move(place).value());
    }

    std::optional<Error> look_at_witnesses(Inspection& inspection) const override {
        const std::span<const Step> about = inspection.about;
        if (timeline_->family == Family::Dilated) {
            inspection.is_dilated = true;
            inspection.zeta = basis_->dilation * timeline_->epsilon(step_);
            inspection.sightings = dilated_sightings(basis_->cloud, weighted_landmarks(), about, inspection.zeta);
            return std::nullopt;
        }
        const auto& nu = basis_->nu[static_cast<std::size_t>(track_)];
        inspection.allowed = about.size() <= nu.size() ? nu[about.size() - 1] : 0;
        if (basis_->metric.metric == Metric::Euclidean) {
            const PointCloud points = landmarks();
            look(TreeRanks(basis_->cloud, points), inspection);
            return std::nullopt;
        }
        const auto inserted = std::span(timeline_->landmarks).first(step_);
        const auto ranks = ListRanks::of(basis_->cloud, basis_->metric, inserted);
        if (!ranks) return ranks.error();
        look(ranks.value(), inspection);
        return std::nullopt;
    }

    void fill_in_lifespan(Inspection& inspection) const {
        const std::vector<Step>& simplex = inspection.simplex;
        if (inspection.verdict == Verdict::NotInserted) return;
        Step death = kNever;
        if (simplex.size() == 1) {
            const auto& hidden = timeline_->hidden;
            const auto end = std::find_if(hidden.begin(), hidden.end(), [&](const HiddenLandmark& landmark) {
                return landmark.landmark == simplex.front();
            });
            if (end != hidden.end()) death = end->from;
        } else {
            if (static_cast<int>(simplex.size()) > max_dimension() + 1) return;
            const SimplexTable& table = timeline_->table(static_cast<int>(simplex.size()) - 1);
            const SimplexIndex index = table.find(simplex);
            if (index == kNoSimplex) return;
            death = table.death[static_cast<std::size_t>(track_)][index];
        }
        if (death == simplex.back()) return;
        inspection.birth = simplex.back();
        // A step that is under way shows nowhere.
        inspection.death = death <= timeline_->step_count ? death : kNever;
    }

private:
    bool is_vertex(Step landmark) const {
        const auto& hidden = timeline_->hidden;
        return std::none_of(hidden.begin(), hidden.end(),
                            [&](const HiddenLandmark& one) { return one.landmark == landmark && one.from <= step_; });
    }
    static void look(const LandmarkRanks& ranks, Inspection& inspection) {
        inspection.horizon = ranks.horizon();
        inspection.sightings = sightings(ranks, inspection.about, inspection.allowed);
    }
    /// The landmarks so far, by step - 1.
    PointCloud landmarks() const {
        PointCloud points{basis_->cloud.dimension, {}};
        for (const std::uint32_t index : std::span(timeline_->landmarks).first(step_)) {
            const auto point = basis_->cloud.point(index);
            points.coordinates.insert(points.coordinates.end(), point.begin(), point.end());
        }
        return points;
    }
    WeightedLandmarks weighted_landmarks() const {
        WeightedLandmarks landmarks(basis_->cloud.dimension);
        for (Step step = 1; step <= step_; ++step) {
            landmarks.add(basis_->cloud.point(timeline_->landmarks[step - 1]), timeline_->weights_squared[step - 1]);
        }
        return landmarks;
    }

    const RunBasis* basis_;
    const Timeline* timeline_;
    Step step_;
    int track_;
};

}  // namespace

Result<Inspection> inspect_run(const RunBasis& basis, const Timeline& timeline, Step step, std::vector<Step> vertices) {
    if (step < 1 || step > timeline.step_count) {
        return Error{ErrorCode::InvalidOption, "Step " + std::to_string(step) +
                                                   " is not computed: there are steps 1 to " +
                                                   grouped(timeline.step_count) + "."};
    }
    const ShownComplex complex(basis, timeline, step);
    auto found = inspected(complex, std::move(vertices));
    if (!found) return found;
    Inspection inspection = std::move(found).value();
    inspection.step = step;
    complex.fill_in_lifespan(inspection);
    if (inspection.verdict == Verdict::Present) {
        const LandmarkPoints points{&basis.cloud, &timeline.landmarks};
        inspection.surface = surface_place(timeline, points, basis.rho, step, inspection.simplex);
    }
    return inspection;
}

}  // namespace plateau
