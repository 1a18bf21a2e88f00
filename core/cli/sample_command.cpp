#include <algorithm>

#include "cli/commands.h"
#include "cli/files.h"
#include "io/writers.h"

namespace plateau::cli {

Result<int> sample(const SampleArguments& arguments) {
    constexpr std::uint32_t kPointsAtOnce = 100'000;
    const auto cloud = sample_shape(arguments.shape, arguments.options);
    if (!cloud) return cloud.error();
    const std::uint32_t size = cloud.value().size();
    for (std::uint32_t first = 0; first < size; first += kPointsAtOnce) {
        if (interrupted()) return kInterrupted;
        const std::uint32_t count = std::min(kPointsAtOnce, size - first);
        if (auto error = write_file("-", cloud_xyz(cloud.value(), first, count))) return std::move(*error);
    }
    return kDone;
}

}  // namespace plateau::cli
