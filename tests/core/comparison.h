#pragma once

#include <iosfwd>
#include <sstream>
#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "clouds.h"
#include "reference/run.h"
#include "timeline/timeline.h"

namespace plateau {

/// Runs the engine and compares what it recorded with the slow references: landmarks, epsilon bit by bit, complexes of
/// all tracks, surface rows and how they are glued, shown families, Betti numbers, plateaus, and the laws. Runs of up
/// to 60 steps at every step, longer ones at the first 12, every `stride`-th and the last. `expected` is the reference
/// of the same cloud, first landmark and number of steps. Empty, or the first difference with its step.
std::string run_difference(const PointCloud& cloud, reference::Reference& expected, const reference::Settings& settings,
                           int first = 0, int max_steps = reference::kAllSteps, int stride = 9);

Family family_of(reference::ShownFamily family);
std::string name_of(reference::ShownFamily family);

/// A test cloud and a family that it can be followed with.
struct FamilyCase {
    TestCloud cloud;
    reference::ShownFamily family;
};

std::ostream& operator<<(std::ostream& out, const FamilyCase& value);
/// For the names of tests.
std::string name_of(const FamilyCase& value);
/// Every test cloud with every family that it can be followed with.
std::vector<FamilyCase> family_cases();

/// Numbers in parentheses, for messages.
template <class Numbers>
std::string joined(const Numbers& numbers) {
    std::ostringstream text;
    text.precision(17);
    for (const auto& number : numbers) text << (text.tellp() > 0 ? " " : "") << number;
    return "(" + text.str() + ")";
}

}  // namespace plateau
