#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/random.h"
#include "cloud/samples.h"
#include "session/session.h"

namespace plateau::bench {

/// A sample shape by its name, or `cube`: uniform in the unit cube. Ends the program when there is no such shape.
inline PointCloud make_cloud(std::string_view name, std::uint32_t size) {
    if (name != "cube") {
        auto sampled = sample_shape(name, {.size = size});
        if (!sampled) {
            std::fprintf(stderr, "%s\n", sampled.error().message.c_str());
            std::exit(2);
        }
        return std::move(sampled).value();
    }
    Random random(1);
    PointCloud cloud{3, {}};
    for (std::uint32_t i = 0; i < 3 * size; ++i) cloud.coordinates.push_back(random.next_unit());
    return cloud;
}

inline std::optional<Family> family_named(std::string_view name) {
    if (name == "delaunay") return Family::Delaunay;
    if (name == "surface") return Family::Surface;
    if (name == "auto") return Family::Auto;
    if (name == "witness") return Family::Witness;
    return std::nullopt;
}

/// A run of all landmarks, to its end. What it may take is the machine's limit, not the one that guards a page.
inline Session whole_run(const PointCloud& cloud, Family family) {
    RunOptions options;
    options.family = family;
    options.memory_limit = std::uint64_t{1} << 40;
    auto opened = Session::open(cloud, options);
    if (!opened) {
        std::fprintf(stderr, "%s\n", opened.error().message.c_str());
        std::exit(1);
    }
    Session session = std::move(opened).value();
    const Progress progress = session.run({});
    if (progress.state != RunState::Finished) {
        std::fprintf(stderr, "The run stopped at step %u.\n", progress.steps_done);
        std::exit(1);
    }
    return session;
}

struct Spent {
    double seconds;
    double processor_share;  ///< of these, how many the process had a processor: below 1 on a busy machine
};

inline Spent spent_on(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    work();
    const double busy = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {seconds, busy / seconds};
}

/// The largest resident size of this process so far, in MB (10^6 bytes); 0 where the system does not tell. Not
/// getrusage: its maximum begins with that of the process which started this one.
inline double peak_megabytes() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        double kibibytes = 0;
        if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024 / 1e6;
    }
    return 0;
}

}  // namespace plateau::bench
