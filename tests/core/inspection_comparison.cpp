#include "inspection_comparison.h"

#include <algorithm>
#include <tuple>

#include "comparison.h"

namespace plateau {

using reference::Simplex;

namespace {

Simplex as_simplex(const std::vector<Step>& steps) {
    return {steps.begin(), steps.end()};
}

Simplex smallest_missing(const DefinedComplex& expected, const Simplex& asked) {
    for (std::size_t size = 1; size <= asked.size(); ++size) {
        std::vector<Simplex> missing;
        for (const Simplex& face : reference::subsets(asked, static_cast<int>(size))) {
            if (expected.complex[size - 1].count(face) == 0) missing.push_back(face);
        }
        if (!missing.empty()) return *std::min_element(missing.begin(), missing.end());
    }
    return {};
}

bool is_face(const Simplex& simplex, const reference::Triangulation& triangulation) {
    const auto all = reference::closure(triangulation.cells);
    return all[simplex.size() - 1].count(simplex) > 0;
}

/// Ranks of the vertices at a witness, from 1 on.
std::vector<int> ranks_at(const std::vector<int>& list, const Simplex& simplex) {
    std::vector<int> ranks;
    for (const int vertex : simplex) {
        ranks.push_back(static_cast<int>(std::find(list.begin(), list.end(), vertex) - list.begin()) + 1);
    }
    return ranks;
}

std::string sightings_difference(const DefinedComplex& expected, const Simplex& about, const Inspection& found) {
    const int nu = about.size() <= expected.nu.size() ? expected.nu[about.size() - 1] : 0;
    if (static_cast<int>(found.allowed) != nu) return "allowed is " + std::to_string(found.allowed);
    std::vector<std::tuple<int, int>> all, witnesses;
    for (std::size_t w = 0; w < expected.lists.size(); ++w) {
        const auto ranks = ranks_at(expected.lists[w], about);
        all.emplace_back(*std::max_element(ranks.begin(), ranks.end()), static_cast<int>(w));
        if (std::get<0>(all.back()) <= nu) witnesses.push_back(all.back());
    }
    std::sort(all.begin(), all.end());
    std::sort(witnesses.begin(), witnesses.end());
    const Sightings& seen = found.sightings;
    if (seen.witness_count != witnesses.size()) return std::to_string(seen.witness_count) + " witnesses";
    if (seen.witnesses.size() != witnesses.size()) return "a witness is left out";
    for (std::size_t i = 0; i < witnesses.size(); ++i) {
        const Sighting& one = seen.witnesses[i];
        if (witnesses[i] != std::tuple(static_cast<int>(one.rank), static_cast<int>(one.witness))) {
            return "witness " + std::to_string(one.witness) + " at rank " + std::to_string(one.rank);
        }
    }
    const auto [rank, witness] = all.front();
    const bool is_known = rank <= static_cast<int>(found.horizon);
    if (is_known != seen.best.has_value()) return "the best witness is not what is known";
    if (!is_known) return "";
    if (std::tuple(static_cast<int>(seen.best->rank), static_cast<int>(seen.best->witness)) != all.front()) {
        return "best witness " + std::to_string(seen.best->witness) + " at rank " + std::to_string(seen.best->rank) +
               ", not " + std::to_string(witness) + " at " + std::to_string(rank);
    }
    const auto ranks = ranks_at(expected.lists[static_cast<std::size_t>(witness)], about);
    if (!std::equal(ranks.begin(), ranks.end(), seen.best_ranks.begin(), seen.best_ranks.end())) return "other ranks";
    return "";
}

/// The simplex is not in the triangulation of its vertices and the blockers, but is in it without any one of them.
std::string blockers_difference(const DefinedComplex& expected, const Simplex& about, const Inspection& found) {
    const Simplex blockers = as_simplex(found.delaunay.blockers);
    const auto triangulated = [&](int without) {
        std::vector<reference::LabeledPoint> points;
        for (const auto& point : expected.points) {
            const bool is_in = std::count(about.begin(), about.end(), point.label) > 0 ||
                               std::count(blockers.begin(), blockers.end(), point.label) > 0;
            if (is_in && point.label != without) points.push_back(point);
        }
        return reference::triangulate_space(points);
    };
    if (is_face(about, triangulated(0))) return "the blockers do not block";
    if (found.delaunay.is_flat) return blockers.empty() ? "" : "a flat simplex needs no blocker";
    if (blockers.empty()) return "not flat, and not blocked";
    for (const int blocker : blockers) {
        if (!is_face(about, triangulated(blocker))) return "blocker " + std::to_string(blocker) + " is not needed";
    }
    const int full = expected.triangulation->dimension;
    if (static_cast<int>(about.size()) == full + 1 && blockers.size() != 1) return "one landmark in the ball is enough";
    return "";
}

}  // namespace

std::string inspection_difference(const DefinedComplex& expected, Simplex asked, const Inspection& found) {
    std::sort(asked.begin(), asked.end());
    if (as_simplex(found.simplex) != asked) return "another simplex";
    const auto tell = [&](const std::string& what) {
        return what.empty() ? ""
                            : joined(asked) + ", verdict " + std::to_string(static_cast<int>(found.verdict)) +
                                  " about " + joined(found.about) + ": " + what;
    };
    Simplex later;
    for (const int vertex : asked) {
        if (vertex > expected.landmark_count) later.push_back(vertex);
    }
    if (!later.empty()) {
        const bool is_right = found.verdict == Verdict::NotInserted && as_simplex(found.about) == later;
        return tell(is_right ? "" : "vertices are missing");
    }
    const Simplex missing = smallest_missing(expected, asked);
    const Simplex about = missing.empty() ? asked : missing;
    if (as_simplex(found.about) != about) return tell("it should be about " + joined(about));
    if (missing.empty()) {
        if (found.verdict != Verdict::Present) return tell("it is present");
        return tell(sightings_difference(expected, about, found));
    }
    if (static_cast<int>(about.size()) > expected.max_dimension + 1) {
        return tell(found.verdict == Verdict::TooManyVertices ? "" : "it has too many vertices");
    }
    if (expected.triangulation && !is_face(about, *expected.triangulation)) {
        if (found.verdict != Verdict::NotDelaunay) return tell("it is not in D(L)");
        return tell(blockers_difference(expected, about, found));
    }
    if (found.verdict != Verdict::NotWitnessed) return tell("it lacks a witness");
    if (found.sightings.witness_count > 0) return tell("it has a witness");
    return tell(sightings_difference(expected, about, found));
}

}  // namespace plateau
