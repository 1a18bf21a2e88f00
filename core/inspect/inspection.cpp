#include "inspect/inspection.h"

#include <algorithm>
#include <string>
#include <utility>

namespace plateau {

namespace {

std::optional<Error> objection_to(const std::vector<Step>& ascending) {
    const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
    if (ascending.empty()) return invalid("Name at least one landmark by the step that inserted it.");
    if (ascending.size() > kMaxInspected) {
        return invalid("At most " + std::to_string(kMaxInspected) + " landmarks can be asked about at once; got " +
                       std::to_string(ascending.size()) + ".");
    }
    if (ascending.front() == 0) return invalid("Landmarks are named by their steps, from 1 on; got 0.");
    const auto twice = std::adjacent_find(ascending.begin(), ascending.end());
    if (twice == ascending.end()) return std::nullopt;
    return invalid("Landmark " + std::to_string(*twice) + " is named twice.");
}

// Smaller faces first, in lexicographic order; empty if the simplex and all its faces are there.
std::vector<Step> smallest_missing(const Inspected& complex, const std::vector<Step>& simplex) {
    for (std::size_t size = 1; size <= simplex.size(); ++size) {
        std::vector<bool> chosen(simplex.size(), false);
        std::fill_n(chosen.begin(), size, true);
        do {
            std::vector<Step> face;
            for (std::size_t i = 0; i < simplex.size(); ++i) {
                if (chosen[i]) face.push_back(simplex[i]);
            }
            if (!complex.has(face)) return face;
        } while (std::prev_permutation(chosen.begin(), chosen.end()));
    }
    return {};
}

std::optional<Error> find_reason(const Inspected& complex, Inspection& inspection) {
    if (static_cast<int>(inspection.about.size()) > complex.max_dimension() + 1) {
        inspection.verdict = Verdict::TooManyVertices;
        return std::nullopt;
    }
    auto place = complex.delaunay(inspection.about);
    if (!place) return place.error();
    if (place.value() && !place.value()->is_in) {
        inspection.verdict = Verdict::NotDelaunay;
        inspection.delaunay = std::move(*place.value());
        return std::nullopt;
    }
    inspection.verdict = Verdict::NotWitnessed;
    if (auto error = complex.look_at_witnesses(inspection)) return error;
    // Ranks are compared exactly; the distances of family dilated may differ from those of the run by a rounding.
    if (inspection.sightings.witness_count == 0 || inspection.is_dilated) return std::nullopt;
    return Error{ErrorCode::Internal, "A simplex with witnesses is not on record."};
}

}  // namespace

Result<Inspection> inspected(const Inspected& complex, std::vector<Step> vertices) {
    std::sort(vertices.begin(), vertices.end());
    if (auto error = objection_to(vertices)) return std::move(*error);
    Inspection inspection;
    inspection.simplex = vertices;
    const auto is_missing = [&](Step vertex) { return vertex > complex.landmark_count(); };
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(inspection.about), is_missing);
    if (!inspection.about.empty()) {
        inspection.verdict = Verdict::NotInserted;
        return inspection;
    }
    inspection.about = smallest_missing(complex, vertices);
    if (inspection.about.empty()) {
        inspection.about = vertices;
        if (auto error = complex.look_at_witnesses(inspection)) return std::move(*error);
    } else if (auto error = find_reason(complex, inspection)) {
        return std::move(*error);
    }
    return inspection;
}

}  // namespace plateau
