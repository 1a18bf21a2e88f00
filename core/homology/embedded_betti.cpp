#include "homology/embedded_betti.h"

namespace plateau {

namespace {
constexpr std::uint32_t kNone = TemporalGraph::kNone;
}

EmbeddedBetti::EmbeddedBetti(int track, int ambient_dimension) : track_(track), ambient_dimension_(ambient_dimension) {}

void EmbeddedBetti::record(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                           const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces) {
    record_skeleton(step, tables, deaths);
    if (change.dimension == 3) record_complement(step, tables, deaths, delaunay, change, faces);
    euler_.push_back(euler_now_);
    dimension_.push_back(change.dimension);
}

void EmbeddedBetti::record_skeleton(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths) {
    const auto track = static_cast<std::size_t>(track_);
    skeleton_.add_node(step);  // landmarks stay, so the node of a landmark is its step - 1
    ++euler_now_;
    for (const Death& death : deaths) {
        if (death.track != track_) continue;
        euler_now_ -= death.dimension % 2 == 0 ? 1 : -1;
        if (death.dimension == 1) skeleton_.end_edge(skeleton_edge_[death.simplex], step);
    }
    for (const SimplexTable& table : tables) {
        for (SimplexIndex simplex = table.first_of_step[step]; simplex < table.size(); ++simplex) {
            const bool lives = table.death[track][simplex] > step;
            if (lives) euler_now_ += table.dimension % 2 == 0 ? 1 : -1;
            if (table.dimension != 1) continue;
            const auto ends = table.tuple(simplex);
            skeleton_edge_.push_back(lives ? skeleton_.add_edge(ends[0] - 1, ends[1] - 1, step) : kNone);
        }
    }
}

// Nodes: cells whose tetrahedron is not kept, all infinite cells being one. Edges: facets that are not kept.
void EmbeddedBetti::record_complement(Step step, const std::vector<SimplexTable>& tables, std::span<const Death> deaths,
                                      const Delaunay& delaunay, const DelaunayChange& change,
                                      const DelaunayFaces& faces) {
    const auto track = static_cast<std::size_t>(track_);
    const auto lives = [&](int dimension, SimplexIndex simplex) {
        return simplex != kNoSimplex && tables[static_cast<std::size_t>(dimension - 1)].death[track][simplex] > step;
    };
    if (outside_ == kNone) outside_ = complement_.add_node(step);
    cell_node_.resize(delaunay.cell_capacity(), kNone);
    facet_edge_.resize(delaunay.cell_capacity(), {kNone, kNone, kNone, kNone});

    if (!change.dimension_rose) {
        for (const CellId cell : change.died) {
            for (const auto edge : facet_edge_[cell]) complement_.end_edge(edge, step);
            if (cell_node_[cell] != kNone && cell_node_[cell] != outside_) complement_.end_node(cell_node_[cell], step);
        }
    }
    for (const CellId cell : change.born) {
        if (!delaunay.cell(cell).finite(3)) {
            cell_node_[cell] = outside_;
        } else {
            cell_node_[cell] = lives(3, faces.tetrahedron(cell)) ? kNone : complement_.add_node(step);
        }
        facet_edge_[cell] = {kNone, kNone, kNone, kNone};
    }
    // What lost its last witness but is still in D(L) opens: first the cells, then the facets between them.
    for (const Death& death : deaths) {
        if (death.track != track_ || death.dimension != 3) continue;
        const CellId cell = faces.cell(death.simplex);
        if (faces.tetrahedron(cell) == death.simplex && delaunay.cell(cell).alive) {
            cell_node_[cell] = complement_.add_node(step);
        }
    }
    for (const CellId cell : change.born) {
        for (int i = 0; i < 4; ++i) {
            const CellId neighbor = delaunay.cell(cell).neighbor[static_cast<std::size_t>(i)];
            const int mirror = delaunay.cell(neighbor).index_of_neighbor(cell);
            const bool contains_new = delaunay.cell(cell).vertex[static_cast<std::size_t>(i)] != step;
            if ((contains_new || change.dimension_rose) && neighbor < cell) continue;  // its other side is new as well
            if (lives(2, faces.triangle(cell, i))) {
                facet_edge_[neighbor][static_cast<std::size_t>(mirror)] = kNone;
            } else {
                open_facet(step, cell, i, delaunay);
            }
        }
    }
    for (const Death& death : deaths) {
        if (death.track != track_ || death.dimension != 2) continue;
        const auto facet = faces.facet(death.simplex);
        const bool still_there =
            delaunay.cell(facet.cell).alive && faces.triangle(facet.cell, facet.index) == death.simplex;
        if (!still_there) continue;
        const CellId neighbor = delaunay.cell(facet.cell).neighbor[static_cast<std::size_t>(facet.index)];
        const auto mirror = static_cast<std::size_t>(delaunay.cell(neighbor).index_of_neighbor(facet.cell));
        if (facet_edge_[neighbor][mirror] == kNone) open_facet(step, facet.cell, facet.index, delaunay);
    }
}

void EmbeddedBetti::open_facet(Step step, CellId cell, int index, const Delaunay& delaunay) {
    const CellId neighbor = delaunay.cell(cell).neighbor[static_cast<std::size_t>(index)];
    const int mirror = delaunay.cell(neighbor).index_of_neighbor(cell);
    const auto edge = complement_.add_edge(cell_node_[cell], cell_node_[neighbor], step);
    facet_edge_[cell][static_cast<std::size_t>(index)] = edge;
    facet_edge_[neighbor][static_cast<std::size_t>(mirror)] = edge;
}

bool EmbeddedBetti::evaluate(const Deadline& deadline, std::vector<std::uint32_t>& betti) {
    if (euler_.empty()) return true;
    const Step last = first_pending_ + static_cast<Step>(euler_.size()) - 1;
    if (!skeleton_count_) {
        skeleton_count_.emplace(skeleton_, first_pending_, last);
        if (outside_ != kNone) complement_count_.emplace(complement_, first_pending_, last);
    }
    if (!skeleton_count_->advance(deadline)) return false;
    if (complement_count_ && !complement_count_->advance(deadline)) return false;

    for (std::size_t i = 0; i < euler_.size(); ++i) {
        const std::int64_t beta0 = skeleton_count_->components()[i];
        const std::int64_t beta2 = dimension_[i] == 3 ? std::int64_t{complement_count_->components()[i]} - 1 : 0;
        betti.push_back(static_cast<std::uint32_t>(beta0));
        betti.push_back(static_cast<std::uint32_t>(beta0 + beta2 - euler_[i]));
        if (ambient_dimension_ == 3) betti.push_back(static_cast<std::uint32_t>(beta2));
    }
    skeleton_count_.reset();
    complement_count_.reset();
    skeleton_.forget_ended();
    complement_.forget_ended();
    first_pending_ = last + 1;
    euler_.clear();
    dimension_.clear();
    return true;
}

std::uint64_t EmbeddedBetti::memory() const {
    return skeleton_.memory() + complement_.memory() +
           (skeleton_edge_.capacity() + cell_node_.capacity() + 4 * facet_edge_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace plateau
