#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "complex/simplex_table.h"
#include "inspect/inspection.h"

namespace plateau {

/// Witnesses and landmarks of a picture in the plane. Landmarks are any points, not witnesses that were chosen; they
/// come in an order of their own, which decides ties: landmark p of 1, 2, ... is row p - 1.
struct PlaneScene {
    PointCloud witnesses{2, {}};
    PointCloud landmarks{2, {}};
    std::vector<std::uint32_t> nu = {1, 2, 3};  ///< nu_0, nu_1, nu_2; entries beyond the given ones are 0
    bool within_delaunay = true;                ///< C_nu^W(L) within D(L), else the whole complex
};

/// Why the scene cannot be drawn: coordinates that are no numbers, two landmarks in one place, nu out of range.
std::optional<Error> objection_to(const PlaneScene& scene);

/// D(L), and the nu-witness complex C_nu^W(L) [GO Def. 3.6] up to triangles, alone or within D(L), of a picture in the
/// plane: the lists, the triangulation and the complex of the big runs, with the landmarks inserted in their order.
///
/// In a run every landmark is a witness, so it has one. Here a landmark may be nobody's first: then it is no vertex,
/// nor is anything that has it.
/// Cost: O(|W| |L|) distances, and what NuComplex takes.
class PlaneComplex : public Inspected {
public:
    using Edge = std::array<Step, 2>;
    using Triangle = std::array<Step, 3>;

    /// `scene` must outlive this. Errors: objection_to(scene), those of Delaunay::insert().
    static Result<PlaneComplex> of(const PlaneScene& scene);

    /// D(L), in lexicographic order.
    const std::vector<Edge>& delaunay_edges() const { return delaunay_edges_; }
    const std::vector<Triangle>& delaunay_triangles() const { return delaunay_triangles_; }
    /// The first landmarks of a witness's list, as many as the largest nu, at least 3, at most |L|.
    std::uint32_t list_length() const { return list_length_; }
    const std::vector<Step>& lists() const { return lists_; }  ///< list_length() a witness
    /// The complex, in lexicographic order.
    const std::vector<Step>& vertices() const { return vertices_; }
    const std::vector<Edge>& edges() const { return edges_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// beta_0 and beta_1 over Z/2. Cost: a reduction of the boundaries.
    std::array<std::uint32_t, 2> betti() const;

    Step landmark_count() const override { return scene_->landmarks.size(); }
    int max_dimension() const override { return 2; }
    bool has(std::span<const Step> simplex) const override;
    Result<std::optional<DelaunayPlace>> delaunay(std::span<const Step> simplex) const override;
    std::optional<Error> look_at_witnesses(Inspection& inspection) const override;

    /// nu_k.
    std::uint32_t nu(std::size_t k) const { return k < scene_->nu.size() ? scene_->nu[k] : 0; }

private:
    explicit PlaneComplex(const PlaneScene& scene) : scene_(&scene) {}
    std::optional<Error> insert_landmarks();
    void keep_witnessed(const std::vector<SimplexTable>& tables);

    const PlaneScene* scene_;
    std::uint32_t list_length_ = 0;
    std::vector<Step> lists_;
    std::vector<Edge> delaunay_edges_;
    std::vector<Triangle> delaunay_triangles_;
    std::vector<Step> vertices_;
    std::vector<Edge> edges_;
    std::vector<Triangle> triangles_;
};

}  // namespace plateau
