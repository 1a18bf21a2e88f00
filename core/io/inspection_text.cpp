#include "io/inspection_text.h"

#include <array>
#include <span>
#include <string_view>

#include "base/words.h"

namespace plateau {

namespace {

std::string listed(std::span<const std::uint32_t> numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0) text += i + 1 == numbers.size() ? " and " : ", ";
        text += grouped(numbers[i]);
    }
    return text;
}

std::string landmarks(std::span<const Step> steps) {
    return (steps.size() == 1 ? "landmark " : "landmarks ") + listed(steps);
}

std::string_view shape(std::size_t vertices) {
    constexpr std::array<std::string_view, 5> kNames = {"", "vertex", "edge", "triangle", "tetrahedron"};
    return vertices < kNames.size() ? kNames[vertices] : "simplex";
}

/// "the edge of landmarks 3 and 7"
std::string named(std::span<const Step> simplex) {
    if (simplex.size() == 1) return landmarks(simplex);
    return "the " + std::string(shape(simplex.size())) + " of " + landmarks(simplex);
}

std::string capitalized(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string point(const Sighting& sighting) {
    return "point " + grouped(sighting.witness);
}

std::string away(const Sighting& sighting) {
    return short_number(sighting.distance) + " away";
}

/// "both of them", what a witness must have near
std::string all_of(std::size_t vertices) {
    if (vertices == 1) return "it";
    return vertices == 2 ? "both of them" : "all " + std::to_string(vertices) + " of them";
}

std::string first_landmarks(std::uint32_t count, bool of_one = true) {
    if (count == 0) return "among no landmarks, as nu asks";
    const std::string whose = of_one ? "its " : "their ";
    return count == 1 ? "as " + whose + "nearest landmark" : "among " + whose + grouped(count) + " nearest landmarks";
}

std::string lifespan(const Inspection& inspection) {
    if (inspection.birth == 0) return "";
    const bool has_ended = inspection.death != kNever && inspection.death <= inspection.step;
    std::string text = has_ended ? " It was there from step " : " It is there from step ";
    text += grouped(inspection.birth);
    if (inspection.death == kNever) return text + " to the last step so far.";
    return text + " to step " + grouped(inspection.death - 1) + ".";
}

std::string_view on_surface(SurfacePlace place) {
    switch (place) {
        case SurfacePlace::On:
            return " It is on the surface.";
        case SurfacePlace::Inside:
            return " It is not on the surface: what is around it shuts it off from outside.";
        case SurfacePlace::Peeled:
            return " It is not on the surface: it hangs on a sharp edge only, and was peeled off.";
        case SurfacePlace::TooLong:
            return " It is not on the surface: the radius-edge ratio of its triangles exceeds rho.";
        case SurfacePlace::Bare:
            return " It is not on the surface: it has no triangle.";
        case SurfacePlace::Solid:
            return " It is not on the surface, which has triangles only.";
        default:
            return "";
    }
}

/// " at step 9"; a picture in the plane has no steps.
std::string at_step(const Inspection& inspection) {
    return inspection.step == 0 ? "" : " at step " + grouped(inspection.step);
}

std::string present(const Inspection& inspection) {
    const Sightings& seen = inspection.sightings;
    std::string text = capitalized(named(inspection.simplex)) + " is in the complex" + at_step(inspection) + ". ";
    const bool is_one = seen.witness_count == 1;
    text += grouped(seen.witness_count);
    if (inspection.is_dilated) {
        text += (is_one ? " witness is" : " witnesses are") + (" within zeta = " + short_number(inspection.zeta)) +
                " of its cell";
        if (seen.best && !is_one) text += ", the nearest is " + point(*seen.best) + ", " + away(*seen.best);
        if (seen.best && is_one) text += ", " + point(*seen.best) + ", " + away(*seen.best);
    } else {
        text += (is_one ? " witness has " : " witnesses have ") + all_of(inspection.simplex.size()) + " " +
                first_landmarks(inspection.allowed, is_one);
        if (seen.best && is_one) text += ", " + point(*seen.best);
        if (seen.best && !is_one) text += ", the best is " + point(*seen.best);
        if (seen.best && inspection.simplex.size() > 1) {
            text += ", for which the last of them is number " + grouped(seen.best->rank);
        }
    }
    return text + "." + lifespan(inspection) + std::string(on_surface(inspection.surface));
}

std::string not_delaunay(const Inspection& inspection) {
    const DelaunayPlace& place = inspection.delaunay;
    const std::size_t vertices = inspection.about.size();
    std::string text = "is not in the Delaunay triangulation: ";
    if (place.is_flat) return text + "its landmarks lie in " + (vertices == 3 ? "a line." : "a plane.");
    if (place.blockers.size() == 1) {
        return text + "every ball with its landmarks on the boundary has landmark " + grouped(place.blockers.front()) +
               " inside.";
    }
    return text + "every ball with its landmarks on the boundary has one of the landmarks " + listed(place.blockers) +
           " inside.";
}

std::string not_witnessed(const Inspection& inspection) {
    const auto& best = inspection.sightings.best;
    const std::size_t vertices = inspection.about.size();
    if (inspection.is_dilated) {
        std::string text = "has no witness within zeta = " + short_number(inspection.zeta) + " of its cell";
        if (!best) return text + ": the cell is empty.";
        return text + ": the nearest, " + point(*best) + ", is " + away(*best) + ".";
    }
    std::string text = "has no witness: none has " + all_of(vertices) + " " + first_landmarks(inspection.allowed);
    if (!best) return text + ", nor among its " + grouped(inspection.horizon) + " nearest.";
    return text + ". The closest miss is " + point(*best) + ", for which " +
           (vertices == 1 ? "it" : "the last of them") + " is number " + grouped(best->rank) + ".";
}

}  // namespace

std::string inspection_text(const Inspection& inspection) {
    const std::span<const Step> about = inspection.about;
    if (inspection.verdict == Verdict::Present) return present(inspection);
    std::string text = capitalized(named(inspection.simplex)) + " is not in the complex" + at_step(inspection) + ". ";
    const bool is_itself = inspection.about == inspection.simplex;
    const std::string subject =
        is_itself ? "It " : "Its " + std::string(shape(about.size())) + " of " + landmarks(about) + " ";
    switch (inspection.verdict) {
        case Verdict::NotInserted:
            text += capitalized(landmarks(about)) + (about.size() == 1 ? " comes later." : " come later.");
            break;
        case Verdict::TooManyVertices:
            text += subject + "has more vertices than a simplex of this complex can have.";
            break;
        case Verdict::NotDelaunay:
            text += subject + not_delaunay(inspection);
            break;
        default:
            text += subject + not_witnessed(inspection);
    }
    return text + lifespan(inspection);
}

}  // namespace plateau
