#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plateau {

/// What a session file says beside its cloud, as it stands there; io/saved_options.h makes options of it.
struct SavedRun {
    /// Named as on the command line.
    struct Option {
        std::string name;
        std::string value;
        friend bool operator==(const Option& a, const Option& b) { return a.name == b.name && a.value == b.value; }
    };
    std::vector<Option> options;
    std::uint32_t reached = 0;  ///< steps that were complete when it was saved
    std::uint64_t hash = 0;     ///< of these steps
    std::uint32_t shown = 0;    ///< the step that was looked at; 0: none
    std::string view;           ///< what the page wants to find again: JSON, or empty; nobody here reads it
};

}  // namespace plateau
