#include "complex/nu_complex.h"

#include <algorithm>
#include <array>

#include "base/few.h"

namespace plateau {

namespace {

constexpr std::uint32_t kNone = DelaunayLink::kNone;

// Calls use(tuple) for every ascending k-subset of the ascending `from`.
template <class Use>
void for_each_subset(std::span<const Step> from, std::size_t k, std::array<Step, 8>& tuple, std::size_t chosen,
                     std::size_t next, const Use& use) {
    if (chosen == k) {
        use(tuple.data());
        return;
    }
    for (; next + (k - chosen) <= from.size(); ++next) {
        tuple[chosen] = from[next];
        for_each_subset(from, k, tuple, chosen + 1, next + 1, use);
    }
}

template <class Use>
void for_each_subset(std::span<const Step> from, std::size_t k, const Use& use) {
    std::array<Step, 8> tuple{};
    for_each_subset(from, k, tuple, 0, 0, use);
}

bool witnessed(const DelaunayLink::FirstWitness& first_witness) {
    return first_witness[0] != kNone || first_witness[1] != kNone;
}

}  // namespace

NuComplex::NuComplex(std::vector<std::vector<std::uint32_t>> nu, int max_dimension, std::uint32_t witness_count)
    : nu_(std::move(nu)),
      books_(max_dimension),
      watches_(nu_.size(), static_cast<std::size_t>(max_dimension), witness_count) {
    for (int k = 1; k <= max_dimension; ++k) candidates_.emplace_back(k);
}

std::uint32_t NuComplex::nu(int track, int k) const {
    const auto& sequence = nu_[static_cast<std::size_t>(track)];
    return static_cast<std::size_t>(k) < sequence.size() ? sequence[static_cast<std::size_t>(k)] : 0;
}

void NuComplex::insert(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries,
                       std::vector<SimplexTable>& of_dimension) {
    Tables tables{step, of_dimension};
    begin_step(entries);
    lose_witnesses(lists, entries, tables);
    fill_tables(lists, entries);
    for (int k = 1; k <= max_dimension(); ++k) bear_tables(k, tables);
    end_step(tables);
}

void NuComplex::insert(Step step, const LandmarkLists& lists, std::span<const ListEntry> entries,
                       const Delaunay& delaunay, const DelaunayChange& change,
                       std::vector<SimplexTable>& of_dimension) {
    Tables tables{step, of_dimension};
    begin_step(entries);
    link_.build(step, delaunay, change, faces_, of_dimension);
    lose_in_delaunay(delaunay, change, tables);
    lose_witnesses(lists, entries, tables);
    mark_link(lists, entries);
    bear_link(tables);
    end_step(tables);
    faces_.update(step, delaunay, change, link_, of_dimension);
}

void NuComplex::begin_step(std::span<const ListEntry> entries) {
    deaths_.clear();
    watches_.begin_step(entries);
}

void NuComplex::end_step(Tables& tables) {
    for (SimplexTable& table : tables.of_dimension) {
        table.first_of_step.resize(tables.step + std::size_t{2}, 0);
        table.first_of_step[tables.step + 1] = table.size();
    }
    std::sort(deaths_.begin(), deaths_.end(), [&](const Death& a, const Death& b) {
        if (a.track != b.track) return a.track < b.track;
        if (a.dimension != b.dimension) return a.dimension < b.dimension;
        const SimplexTable& table = tables[a.dimension];
        const auto x = table.tuple(a.simplex);
        const auto y = table.tuple(b.simplex);
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    });
}

void NuComplex::lose_witnesses(const LandmarkLists& lists, std::span<const ListEntry> entries, Tables& tables) {
    for (const ListEntry& entry : entries) {
        const auto list = lists.list(entry.witness);
        for (int track = 0; track < track_count(); ++track) {
            const auto dropped = [&](int k) -> Step {
                const std::uint32_t count = nu(track, k);
                if (entry.rank >= count) return 0;
                return count < list.size() ? list[count] : entry.dropped;
            };
            watches_.release(track, entry.witness, tables.of_dimension, dropped, [&](int k, SimplexIndex simplex) {
                const auto tuple = tables[k].tuple(simplex);
                if (!watches_.move_on(track, k, simplex, tuple, nu(track, k), lists)) {
                    kill(track, k, simplex, tables);
                }
            });
        }
    }
}

// A face of a dead cell is still in D(L) exactly if it is in the link of p.
void NuComplex::lose_in_delaunay(const Delaunay& delaunay, const DelaunayChange& change, Tables& tables) {
    if (change.dimension_rose) return;  // D(L) became a cone over itself
    const auto die = [&](int k, SimplexIndex simplex) {
        if (simplex == kNoSimplex) return;
        for (int track = 0; track < track_count(); ++track) kill(track, k, simplex, tables);
    };
    const auto corners = static_cast<std::size_t>(change.dimension) + 1;
    for (const CellId id : change.died) {
        const DelaunayCell& cell = delaunay.cell(id);
        std::array<std::uint32_t, 4> place{};
        for (std::size_t i = 0; i < corners; ++i) place[i] = link_.vertex(cell.vertex[i]);
        for (std::size_t i = 0; i < corners; ++i) {
            for (std::size_t j = i + 1; j < corners; ++j) {
                const SimplexIndex edge = faces_.edge(id, i, j);
                if (edge == kNoSimplex) continue;
                if (!link_.has_edge(place[i], place[j])) die(1, edge);
            }
        }
        if (corners == 3) die(2, faces_.triangle(id, 3));
        if (corners < 4) continue;
        for (std::size_t i = 0; i < 4; ++i) {
            if (!delaunay.cell(cell.neighbor[i]).alive) die(2, faces_.triangle(id, static_cast<int>(i)));
        }
        die(3, faces_.tetrahedron(id));
    }
}

// For every simplex of the link the first entry whose witness nu_k-witnesses it together with p, per track.
void NuComplex::mark_link(const LandmarkLists& lists, std::span<const ListEntry> entries) {
    auto& vertices = link_.vertices();
    auto& triangles = link_.triangles();
    for (std::uint32_t at = 0; at < entries.size(); ++at) {
        // The list as far as it is in the link, in its order, and how much of it that is up to each rank; p is not in
        // it.
        const auto list = lists.list(entries[at].witness);
        places_.resize(list.size());
        reach_.resize(list.size() + 1);
        std::uint32_t known = 0;
        std::uint64_t bits = 0;
        for (std::size_t rank = 0; rank < list.size(); ++rank) {
            const std::uint32_t place = link_.vertex(list[rank]);
            places_[known] = place;
            known += place != kNone ? 1 : 0;
            reach_[rank + 1] = known;
            bits |= DelaunayLink::bit(place);
        }
        for (std::size_t track = 0; track < nu_.size(); ++track) {
            const auto reach = [&](int k) {
                const std::uint32_t count = nu(static_cast<int>(track), k);
                return entries[at].rank < count ? reach_[count] : 0;
            };
            for (std::uint32_t i = 0; i < reach(1); ++i) {
                std::uint32_t& first = vertices[places_[i]].first_witness[track];
                first = std::min(first, at);
            }
            const std::uint32_t for_edges = reach(2);
            for (std::uint32_t j = 1; j < for_edges; ++j) {
                if (!link_.may_wait_for_any(track, places_[j], bits)) continue;
                for (std::uint32_t i = 0; i < j; ++i) {
                    if (!link_.may_wait(track, places_[j], places_[i])) continue;
                    const std::uint32_t edge = link_.edge(places_[i], places_[j]);
                    if (edge != kNone) link_.mark_edge(track, edge, at);
                }
            }
            const std::uint32_t for_triangles = triangles.empty() ? 0 : reach(3);
            for (std::uint32_t j = 2; j < for_triangles; ++j) {
                for (std::uint32_t i = 1; i < j; ++i) {
                    const std::uint32_t edge = link_.edge(places_[i], places_[j]);
                    if (edge == kNone) continue;
                    for (std::uint32_t h = 0; h < i; ++h) {
                        const std::uint32_t triangle = link_.triangle(edge, places_[h]);
                        if (triangle == kNone) continue;
                        std::uint32_t& first = triangles[triangle].first_witness[track];
                        first = std::min(first, at);
                    }
                }
            }
        }
    }
}

// Births in the order of their tuples, which is that of the places in the link.
void NuComplex::bear_link(Tables& tables) {
    auto& vertices = link_.vertices();
    auto& edges = link_.edges();
    auto& triangles = link_.triangles();
    for (auto& vertex : vertices) {
        if (witnessed(vertex.first_witness)) {
            vertex.born = bear(1, {&vertex.step, 1}, {}, vertex.first_witness, tables);
        }
    }
    order_.clear();
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (witnessed(edges[i].first_witness)) order_.push_back(i);
    }
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t x, std::uint32_t y) {
        return edges[x].a != edges[y].a ? edges[x].a < edges[y].a : edges[x].b < edges[y].b;
    });
    for (const std::uint32_t i : order_) {
        auto& edge = edges[i];
        const auto& a = vertices[edge.a];
        const auto& b = vertices[edge.b];
        edge.born =
            bear(2, std::array{a.step, b.step}, std::array{b.born, a.born, edge.base}, edge.first_witness, tables);
    }
    order_.clear();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (witnessed(triangles[i].first_witness)) order_.push_back(i);
    }
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t x, std::uint32_t y) { return triangles[x].vertex < triangles[y].vertex; });
    for (const std::uint32_t i : order_) {
        auto& triangle = triangles[i];
        const auto [a, b, c] = triangle.vertex;
        const auto [bc, ac, ab] = triangle.edge;
        triangle.born = bear(3, std::array{vertices[a].step, vertices[b].step, vertices[c].step},
                             std::array{edges[bc].born, edges[ac].born, edges[ab].born, triangle.base},
                             triangle.first_witness, tables);
    }
}

// Without D(L): every simplex with p that an entry's witness nu_k-witnesses, with the first such entry, per track.
void NuComplex::fill_tables(const LandmarkLists& lists, std::span<const ListEntry> entries) {
    for (LinkTable& table : candidates_) table.clear();
    for (std::uint32_t at = 0; at < entries.size(); ++at) {
        const auto list = lists.list(entries[at].witness);
        for (std::size_t track = 0; track < nu_.size(); ++track) {
            for (int k = 1; k <= max_dimension(); ++k) {
                const std::uint32_t count = nu(static_cast<int>(track), k);
                if (entries[at].rank >= count) continue;
                places_.clear();
                for (std::uint32_t rank = 0; rank < count && list[rank] != 0; ++rank) {
                    if (rank != entries[at].rank) places_.push_back(list[rank]);
                }
                sort_few(places_.data(), places_.size());
                LinkTable& table = candidates_[static_cast<std::size_t>(k - 1)];
                for_each_subset(places_, static_cast<std::size_t>(k), [&](const Step* tuple) {
                    std::uint32_t& first = table[table.insert(tuple)].first_witness[track];
                    if (first == kNone) first = at;
                });
            }
        }
    }
}

void NuComplex::bear_tables(int k, Tables& tables) {
    LinkTable& table = candidates_[static_cast<std::size_t>(k - 1)];
    const auto width = static_cast<std::size_t>(k);
    order_.clear();
    for (std::uint32_t index = 0; index < table.size(); ++index) order_.push_back(index);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto x = table.tuple(a);
        const auto y = table.tuple(b);
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    });
    for (const std::uint32_t index : order_) {
        const auto others = table.tuple(index);
        std::array<SimplexIndex, 8> facets{};
        if (k >= 2) {
            facets[width] = tables[k - 1].find(others);
            for (std::size_t j = 0; j < width; ++j) {
                std::array<Step, 8> rest{};
                std::copy(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(j), rest.begin());
                std::copy(others.begin() + static_cast<std::ptrdiff_t>(j) + 1, others.end(),
                          rest.begin() + static_cast<std::ptrdiff_t>(j));
                const LinkTable& below = candidates_[width - 2];
                const std::uint32_t candidate = below.find(rest.data());
                facets[j] = candidate == kNoSimplex ? kNoSimplex : below[candidate].simplex;
            }
        }
        table[index].simplex =
            bear(k, others, {facets.data(), k >= 2 ? width + 1 : 0}, table[index].first_witness, tables);
    }
}

// Records the simplex of p and `others` if it lives in a track: witnessed there, with all its facets. Its index, or
// kNoSimplex.
SimplexIndex NuComplex::bear(int k, std::span<const Step> others, std::span<const SimplexIndex> facets,
                             const FirstWitness& first_witness, Tables& tables) {
    std::array<bool, kMaxTracks> lives{};
    for (std::size_t track = 0; track < nu_.size(); ++track) {
        lives[track] = first_witness[track] != kNone;
        for (const SimplexIndex facet : facets) {
            lives[track] = lives[track] && facet != kNoSimplex && tables[k - 1].death[track][facet] == kNever;
        }
    }
    if (!lives[0] && !lives[1]) return kNoSimplex;

    SimplexTable& table = tables[k];
    const SimplexIndex simplex = table.size();
    table.vertices.insert(table.vertices.end(), others.begin(), others.end());
    table.vertices.push_back(tables.step);
    books_.add(k, facets);
    watches_.add(k);
    for (std::size_t track = 0; track < nu_.size(); ++track) {
        table.death[track].push_back(lives[track] ? kNever : tables.step);
        if (lives[track]) watches_.watch(static_cast<int>(track), k, simplex, tables.step, first_witness[track]);
    }
    return simplex;
}

void NuComplex::kill(int track, int k, SimplexIndex simplex, Tables& tables) {
    Step& death = tables[k].death[static_cast<std::size_t>(track)][simplex];
    if (death != kNever) return;
    death = tables.step;
    watches_.forget(track, k, simplex);
    deaths_.push_back({static_cast<std::uint8_t>(track), static_cast<std::uint8_t>(k), simplex});
    if (k == max_dimension()) return;
    books_.for_each_coface(k, simplex, [&](SimplexIndex coface) { kill(track, k + 1, coface, tables); });
}

std::uint64_t NuComplex::memory() const {
    return books_.memory() + watches_.memory() + faces_.memory();
}

}  // namespace plateau
