#pragma once

#include <string>

#include "inspect/inspection.h"

namespace plateau {

/// The answer in plain words: one to four sentences in one line. Landmarks are named by their steps, witnesses as
/// points of the input by index, from 0.
std::string inspection_text(const Inspection& inspection);

}  // namespace plateau
