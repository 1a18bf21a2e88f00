#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "complex/simplex_table.h"
#include "delaunay/delaunay.h"

namespace plateau {

class DelaunayFaces;

/// The link of the new landmark p in D(L): its vertices, edges and triangles stand for the edges, triangles and
/// tetrahedra with p, which are all that can be born at p's step. Rebuilt at every step.
class DelaunayLink {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
    /// Per track: 0-based place, among the entries of this step, of the first one that witnesses the simplex, or kNone.
    using FirstWitness = std::array<std::uint32_t, kMaxTracks>;

    struct Vertex {
        Step step = 0;
        FirstWitness first_witness{kNone, kNone};
        SimplexIndex born = kNoSimplex;  ///< the edge with p, once it is recorded
        /// Per track: bit b % 64 is set if an edge to place b may still lack a witness.
        std::array<std::uint64_t, kMaxTracks> waiting{};
    };
    struct Edge {
        std::uint32_t a = 0, b = 0;      ///< places of its vertices, a < b
        SimplexIndex base = kNoSimplex;  ///< itself in the record
        std::array<std::uint32_t, 2> triangle{kNone, kNone};
        FirstWitness first_witness{kNone, kNone};
        SimplexIndex born = kNoSimplex;  ///< the triangle with p
    };
    /// In a spatial D(L) one for each new cell, in their order; that of an infinite cell lacks a vertex and two edges.
    /// When D(L) has just become spatial, one for each finite cell.
    struct Triangle {
        std::array<std::uint32_t, 3> vertex{};  ///< places, ascending
        std::array<std::uint32_t, 3> edge{};    ///< places; edge j lacks vertex j
        std::array<std::uint8_t, 3> corner{};   ///< of the cell: where its vertices are
        std::uint8_t apex = 0;                  ///< of the cell: where p is
        SimplexIndex base = kNoSimplex;         ///< itself in the record
        FirstWitness first_witness{kNone, kNone};
        SimplexIndex born = kNoSimplex;  ///< the tetrahedron with p
    };

    /// The link after the insertion of `step`; `faces` and `tables` as before it.
    void build(Step step, const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
               const std::vector<SimplexTable>& tables);

    /// Places are in the order of the steps.
    std::vector<Vertex>& vertices() { return vertices_; }
    const std::vector<Vertex>& vertices() const { return vertices_; }
    std::vector<Edge>& edges() { return edges_; }
    const std::vector<Edge>& edges() const { return edges_; }
    std::vector<Triangle>& triangles() { return triangles_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }

    /// Place of a landmark in the link, or kNone.
    std::uint32_t vertex(Step landmark) const {
        return place_[landmark].step == step_ ? place_[landmark].place : kNone;
    }
    /// Place of the edge between two vertices given by place, in any order, or kNone; also where one of them is kNone.
    std::uint32_t edge(std::uint32_t a, std::uint32_t b) const {
        if (a > b) std::swap(a, b);
        if (b == kNone) return kNone;
        for (std::size_t slot = hash(a, b);; slot = (slot + 1) & mask_) {
            const std::uint32_t place = slots_[slot].step == step_ ? slots_[slot].place : kNone;
            if (place == kNone || (edges_[place].a == a && edges_[place].b == b)) return place;
        }
    }
    /// Whether there is an edge between two of the old landmarks, given by place or kNone. Before any edge is marked.
    bool has_edge(std::uint32_t a, std::uint32_t b) const {
        return a != kNone && b != kNone && may_wait(0, a, b) && edge(a, b) != kNone;
    }
    /// Whether there may be an edge between two vertices, given by place, without a witness in the track: spares most
    /// look-ups. Exact in a link of up to 64 vertices.
    bool may_wait(std::size_t track, std::uint32_t a, std::uint32_t b) const {
        return (vertices_[a].waiting[track] & bit(b)) != 0;
    }
    /// The same of a vertex and any one of others, given by their bits.
    bool may_wait_for_any(std::size_t track, std::uint32_t a, std::uint64_t others) const {
        return (vertices_[a].waiting[track] & others) != 0;
    }
    static std::uint64_t bit(std::uint32_t place) { return std::uint64_t{1} << (place % 64); }
    /// The entry at this place witnesses p and the edge.
    void mark_edge(std::size_t track, std::uint32_t edge, std::uint32_t entry) {
        Edge& marked = edges_[edge];
        if (marked.first_witness[track] != kNone) return;
        marked.first_witness[track] = entry;
        if (vertices_.size() > 64) return;
        vertices_[marked.a].waiting[track] &= ~bit(marked.b);
        vertices_[marked.b].waiting[track] &= ~bit(marked.a);
    }
    /// Place of the triangle of an edge with this third vertex, or kNone; also where one of them is kNone.
    std::uint32_t triangle(std::uint32_t edge, std::uint32_t third) const;

private:
    struct Stamped {
        Step step = 0;
        std::uint32_t place = 0;
    };

    std::size_t hash(std::uint32_t a, std::uint32_t b) const { return (a * 41u + b) & mask_; }
    std::uint32_t find_or_add_edge(std::uint32_t a, std::uint32_t b);
    void reserve_edges(std::size_t count);
    void collect_vertices(const Delaunay& delaunay, const DelaunayChange& change);
    void build_flat(const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                    const std::vector<SimplexTable>& tables);
    void build_spatial(const Delaunay& delaunay, const DelaunayChange& change, const DelaunayFaces& faces,
                       const std::vector<SimplexTable>& tables);

    Step step_ = 0;
    std::vector<Vertex> vertices_;
    std::vector<Edge> edges_;
    std::vector<Triangle> triangles_;
    std::vector<Stamped> place_ = std::vector<Stamped>(1);  // by landmark
    std::vector<Stamped> slots_;                            // of edges, open addressing
    std::size_t mask_ = 0;
    std::vector<Step> steps_;  // scratch of build
};

}  // namespace plateau
