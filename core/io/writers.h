#pragma once

#include <string>

#include "session/session.h"

namespace plateau {

/// Comma-separated values, a line a complete step under a line of names:
/// step (1-based), landmark (0-based input index), epsilon (17 digits), family as shown, beta0, beta1, ...
std::string betti_csv(const Session& session);

/// `{"plateaus":[{"first_step","last_step","epsilon_first","epsilon_last","betti","family","length"}]}` in step order;
/// length = ln(ratio). Ends with a line end.
std::string plateaus_json(const Session& session);

/// Comma-separated values of family dilated with pumping, a line a complete step under a line of names: step, landmark
/// (0-based input index), omega (the weight, input units), the smallest sliver measure in its star before and after,
/// thresholds (see Pump), the relative amplitude of all weights so far, and how many landmarks are hidden.
std::string pumps_csv(const Session& session);

/// The plateaus for a person, longest first, three significant digits; at most 20 lines of them.
std::string plateau_table(const Session& session);

/// `count` points from the 0-based index `first` as text, a line a point, 17 digits: reading it gives the same bits.
/// Precondition: first + count <= size.
std::string cloud_xyz(const PointCloud& cloud, std::uint32_t first, std::uint32_t count);

}  // namespace plateau
