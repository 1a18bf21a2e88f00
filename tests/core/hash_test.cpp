// The hash of a run, computed again from the record's lifespans alone.

#include "base/hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <tuple>

#include "clouds.h"
#include "session/session.h"

namespace plateau {
namespace {

using Words = std::vector<std::uint32_t>;

/// FNV-1a as published: each byte by xor, then a product with the prime 2^40 + 0x1b3.
class Bytes {
public:
    void add(std::uint64_t word, int count) {
        for (int i = 0; i < count; ++i) {
            value_ ^= (word >> (8 * i)) & 0xff;
            value_ = (value_ << 40) + value_ * 0x1b3;
        }
    }
    void add(std::span<const std::uint32_t> words) {
        for (const std::uint32_t word : words) add(word, 4);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037u;
};

/// What one step adds: step, landmark, epsilon, births, deaths, rows that begin and end, family, Betti numbers.
void add_step(const Timeline& timeline, Step step, Bytes& bytes) {
    bytes.add(step, 4);
    bytes.add(timeline.landmarks[step - 1], 4);
    const double epsilon = timeline.epsilon(step);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &epsilon, sizeof bits);
    bytes.add(bits, 8);

    std::vector<std::tuple<int, Words, Words>> births;
    std::vector<std::tuple<int, int, Words>> deaths;
    for (const SimplexTable& table : timeline.simplices) {
        for (SimplexIndex s = 0; s < table.size(); ++s) {
            const auto tuple = table.tuple(s);
            const Words vertices(tuple.begin(), tuple.end());
            Words lives;
            for (int track = 0; track < timeline.track_count; ++track) {
                const Step death = table.death[static_cast<std::size_t>(track)][s];
                lives.push_back(death > step ? 1 : 0);
                if (death == step && vertices.back() < step) deaths.emplace_back(track, table.dimension, vertices);
            }
            if (vertices.back() == step) births.emplace_back(table.dimension, vertices, lives);
        }
    }
    std::sort(births.begin(), births.end());
    std::sort(deaths.begin(), deaths.end());
    for (const auto& [dimension, vertices, lives] : births) {
        bytes.add(vertices);
        for (const std::uint32_t one : lives) bytes.add(one, 1);
    }
    for (const auto& [track, dimension, vertices] : deaths) {
        bytes.add(static_cast<std::uint64_t>(track), 1);
        bytes.add(vertices);
    }

    // By births of the triangles, as the table has them.
    std::vector<std::pair<SimplexIndex, std::uint8_t>> begun;
    std::vector<std::pair<SimplexIndex, std::uint8_t>> ended;
    for (const SurfaceRow& row : timeline.surface) {
        if (row.from == step) begun.emplace_back(row.triangle, row.side);
        if (row.to == step) ended.emplace_back(row.triangle, row.side);
    }
    for (auto* rows : {&begun, &ended}) {
        std::sort(rows->begin(), rows->end());
        for (const auto& [triangle, side] : *rows) {
            bytes.add(timeline.table(2).tuple(triangle));
            bytes.add(side, 1);
        }
    }
    bytes.add(static_cast<std::uint64_t>(timeline.shown_family[step - 1]), 1);
    bytes.add(timeline.betti_at(step));
}

TEST(Hash, IsThePublishedFnv1a) {
    const auto of = [](std::string_view text) {
        Fnv1a64 hash;
        for (const char c : text) hash.add_byte(static_cast<std::uint8_t>(c));
        return hash.value();
    };
    EXPECT_EQ(of(""), 0xcbf29ce484222325u);
    EXPECT_EQ(of("a"), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(of("foobar"), 0x85944171f73967e8u);
}

TEST(Hash, LeavesNothingOfTheRecordOut) {
    const struct {
        const char* cloud;
        Family family;
    } runs[] = {{"torus_dense", Family::Auto},
                {"torus_with_disk_dense", Family::Surface},
                {"grid_tenth", Family::Delaunay},
                {"plane_two_circles", Family::Delaunay},
                {"lattice", Family::Witness}};
    for (const auto& run : runs) {
        const TestCloud cloud = test_cloud(run.cloud);
        RunOptions options;
        options.family = run.family;
        options.max_steps = static_cast<std::uint32_t>(cloud.max_steps);
        Session session = Session::open(cloud.cloud, options).value();
        session.run({});
        const Timeline& timeline = session.timeline();
        Bytes bytes;
        for (Step step = 1; step <= timeline.step_count; ++step) add_step(timeline, step, bytes);
        EXPECT_EQ(session.hash(), bytes.value()) << run.cloud;
        EXPECT_GT(timeline.step_count, 40u) << run.cloud;
    }
}

}  // namespace
}  // namespace plateau
