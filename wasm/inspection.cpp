#include "inspection.h"

#include <span>
#include <string>
#include <vector>

#include "io/inspection_text.h"
#include "marshal.h"

namespace plateau::marshal {

using emscripten::val;

namespace {

constexpr const char* kVerdicts[] = {"present", "notInserted", "tooManyVertices", "notDelaunay", "notWitnessed"};
constexpr const char* kPlaces[] = {"none", "on", "inside", "peeled", "tooLong", "bare", "solid"};

val numbered(std::span<const Step> landmarks, Step first_landmark) {
    std::vector<Step> numbers(landmarks.begin(), landmarks.end());
    for (Step& number : numbers) number = number - 1 + first_landmark;
    return copied(std::span<const Step>(numbers));
}

}  // namespace

val inspection_of(const Inspection& inspection, Step first_landmark) {
    std::vector<std::uint32_t> witnesses, ranks;
    std::vector<double> distances;
    for (const Sighting& sighting : inspection.sightings.witnesses) {
        witnesses.push_back(sighting.witness);
        ranks.push_back(sighting.rank);
        distances.push_back(sighting.distance);
    }
    val out = val::object();
    out.set("step", inspection.step);
    out.set("simplex", numbered(inspection.simplex, first_landmark));
    out.set("verdict", std::string(kVerdicts[static_cast<std::size_t>(inspection.verdict)]));
    out.set("about", numbered(inspection.about, first_landmark));
    out.set("birth", inspection.birth);
    out.set("death", inspection.death);
    out.set("allowed", inspection.allowed);
    out.set("horizon", inspection.horizon);
    if (inspection.is_dilated) out.set("zeta", inspection.zeta);
    out.set("witnessCount", inspection.sightings.witness_count);
    out.set("witnesses", copied(std::span<const std::uint32_t>(witnesses)));
    out.set("ranks", copied(std::span<const std::uint32_t>(ranks)));
    out.set("distances", copied(std::span<const double>(distances)));
    if (const auto& best = inspection.sightings.best) {
        val sighting = val::object();
        sighting.set("witness", best->witness);
        sighting.set("rank", best->rank);
        sighting.set("distance", best->distance);
        sighting.set("ranks", copied(std::span<const std::uint32_t>(inspection.sightings.best_ranks)));
        out.set("best", sighting);
    }
    out.set("blockers", numbered(inspection.delaunay.blockers, first_landmark));
    out.set("flat", inspection.delaunay.is_flat);
    out.set("surface", std::string(kPlaces[static_cast<std::size_t>(inspection.surface)]));
    out.set("text", inspection_text(inspection));
    return out;
}

}  // namespace plateau::marshal
