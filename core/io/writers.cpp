#include "io/writers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "io/exact_text.h"
#include "io/family_name.h"

namespace plateau {
namespace {

std::string three_digits(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", number);
    return text.data();
}

std::string in_words(const Plateau& plateau, std::uint32_t other_field) {
    std::string numbers = "(" + joined(plateau.betti, ", ") + ")";
    if (plateau.torsion.empty()) return numbers;
    return numbers + ", torsion: (" + joined(plateau.torsion, ", ") + ") over Z/" + std::to_string(other_field);
}

}  // namespace

std::string betti_csv(const Session& session) {
    const Timeline& timeline = session.timeline();
    std::string text = "step,landmark,epsilon,family";
    for (std::uint32_t k = 0; k < timeline.dimension; ++k) text += ",beta" + std::to_string(k);
    text += '\n';
    for (Step step = 1; step <= timeline.step_count; ++step) {
        text += std::to_string(step) + ',' + std::to_string(timeline.landmarks[step - 1]) + ',' +
                exact(timeline.epsilon(step)) + ',';
        text += family_name(timeline.shown_family[step - 1]);
        text += ',' + joined(timeline.betti_at(step), ",") + '\n';
    }
    return text;
}

std::string pumps_csv(const Session& session) {
    const Timeline& timeline = session.timeline();
    std::string text = "step,landmark,omega,sliver_before,sliver_after,thresholds,amplitude,hidden\n";
    std::size_t hidden = 0;
    for (Step step = 1; step <= timeline.pumps.size(); ++step) {
        const Pump& pump = timeline.pumps[step - 1];
        while (hidden < timeline.hidden.size() && timeline.hidden[hidden].from <= step) ++hidden;
        text += std::to_string(step) + ',' + std::to_string(timeline.landmarks[step - 1]) + ',' +
                exact(std::sqrt(pump.weight_squared)) + ',' + exact(pump.before) + ',' + exact(pump.after) + ',' +
                std::to_string(pump.thresholds) + ',' + exact(pump.amplitude) + ',' + std::to_string(hidden) + '\n';
    }
    return text;
}

std::string plateaus_json(const Session& session) {
    std::string text = "{\"plateaus\":[";
    const char* separator = "\n";
    for (const Plateau& plateau : session.plateaus()) {
        text += separator;
        text += "{\"first_step\":" + std::to_string(plateau.first_step) +
                ",\"last_step\":" + std::to_string(plateau.last_step) +
                ",\"epsilon_first\":" + exact(plateau.epsilon_first) +
                ",\"epsilon_last\":" + exact(plateau.epsilon_last) + ",\"betti\":[" + joined(plateau.betti, ",") +
                "],\"family\":\"";
        text += family_name(plateau.family);
        text += "\",\"length\":" + exact(plateau.length());
        if (!plateau.torsion.empty()) {
            text += ",\"torsion\":{\"field\":" + std::to_string(session.timeline().other_field) + ",\"betti\":[" +
                    joined(plateau.torsion, ",") + "]}";
        }
        text += "}";
        separator = ",\n";
    }
    return text + "\n]}\n";
}

std::string cloud_xyz(const PointCloud& cloud, std::uint32_t first, std::uint32_t count) {
    std::string text;
    for (std::uint32_t k = first; k < first + count; ++k) {
        const auto point = cloud.point(k);
        for (std::size_t axis = 0; axis < point.size(); ++axis) {
            text += exact(point[axis]);
            text += axis + 1 < point.size() ? ' ' : '\n';
        }
    }
    return text;
}

std::string plateau_table(const Session& session) {
    const Timeline& timeline = session.timeline();
    constexpr std::size_t kMostRows = 20;
    const std::vector<Plateau> plateaus = session.plateaus();
    const std::vector<std::uint32_t> order = ranked(plateaus);
    const std::size_t shown = std::min(order.size(), kMostRows);
    if (shown == 0) return "No plateau: no step has a complex.\n";
    constexpr std::size_t kColumns = 6;
    using Row = std::array<std::string, kColumns>;
    const std::uint32_t field = session.options().field;
    const std::string over = field == 2 ? "" : " over Z/" + std::to_string(field);
    std::vector<Row> rows = {{"length", "epsilon", "1/epsilon", "steps", "family", "Betti numbers" + over}};
    for (std::size_t k = 0; k < shown; ++k) {
        const Plateau& plateau = plateaus[order[k]];
        const auto range = [](const std::string& from, const std::string& to) { return from + " to " + to; };
        const auto inverse = [](double epsilon) { return epsilon > 0 ? three_digits(1 / epsilon) : "beyond"; };
        rows.push_back({three_digits(plateau.length()),
                        range(three_digits(plateau.epsilon_first), three_digits(plateau.epsilon_last)),
                        range(inverse(plateau.epsilon_first), inverse(plateau.epsilon_last)),
                        range(std::to_string(plateau.first_step), std::to_string(plateau.last_step)),
                        std::string(family_name(plateau.family)), in_words(plateau, timeline.other_field)});
    }
    std::array<std::size_t, kColumns> widths{};
    for (const Row& row : rows) {
        for (std::size_t column = 0; column < kColumns; ++column) {
            widths[column] = std::max(widths[column], row[column].size());
        }
    }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t column = 0; column + 1 < kColumns; ++column) {
            text += row[column] + std::string(widths[column] - row[column].size() + 2, ' ');
        }
        text += row.back() + '\n';
    }
    if (shown < order.size()) text += "and " + std::to_string(order.size() - shown) + " shorter ones\n";
    return text;
}

}  // namespace plateau
