#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "inspect/delaunay_place.h"
#include "inspect/sightings.h"
#include "inspect/surface_place.h"

namespace plateau {

/// Why a simplex is in a complex or not, the first that is true. The numbers cross the module's boundary: append only.
enum class Verdict : std::uint8_t {
    Present = 0,
    NotInserted = 1,      ///< a vertex is no landmark yet
    TooManyVertices = 2,  ///< no simplex of the complex has as many
    NotDelaunay = 3,      ///< it is not in D(L)
    NotWitnessed = 4,     ///< no witness has its vertices near enough
};

/// The answer to "why is this simplex in the complex, why is that one not?" at one step.
struct Inspection {
    Step step = 0;              ///< 0: of a complex without steps
    std::vector<Step> simplex;  ///< vertices asked for, ascending
    Verdict verdict = Verdict::Present;
    /// What the verdict is about: the simplex itself, or where a proper face is missing a smallest missing one, the
    /// first in lexicographic order; with NotInserted the vertices that are no landmarks.
    std::vector<Step> about;
    /// The simplex is in the complex from `birth` on and before `death` (kNever: still at the last step computed);
    /// both 0: at no step so far.
    Step birth = 0, death = 0;
    /// Verdicts Present and NotWitnessed: a witness needs all vertices of `about` among its first `allowed` landmarks,
    /// nu_k. Ranks beyond `horizon` are not known.
    std::uint32_t allowed = 0;
    std::uint32_t horizon = 0;
    bool is_dilated = false;  ///< instead a witness may be as far as `zeta`, input units, from the cell of `about`
    double zeta = 0;
    Sightings sightings;                             ///< of `about`
    DelaunayPlace delaunay;                          ///< verdict NotDelaunay: what keeps `about` out
    SurfacePlace surface = SurfacePlace::NoSurface;  ///< verdict Present
};

/// A complex that can be asked about, at one step. Simplices are given by ascending landmarks 1 .. landmark_count().
class Inspected {
public:
    virtual ~Inspected() = default;

    virtual Step landmark_count() const = 0;
    /// The largest dimension of a simplex.
    virtual int max_dimension() const = 0;
    /// Whether the simplex, vertices included, is in the complex.
    virtual bool has(std::span<const Step> simplex) const = 0;
    /// Whether the complex is within D(L), and where the simplex is in it; nothing for a complex without D(L).
    virtual Result<std::optional<DelaunayPlace>> delaunay(std::span<const Step> simplex) const = 0;
    /// Fills in who sees `about`: from `allowed` to `sightings`.
    virtual std::optional<Error> look_at_witnesses(Inspection& inspection) const = 0;
};

/// The most vertices that can be asked about.
inline constexpr std::size_t kMaxInspected = 8;

/// Finds the verdict and fills in what belongs to it; step, lifespan and surface are left to the caller.
/// Vertices in any order. Errors: InvalidOption (no vertex, more than kMaxInspected, 0, one twice), those of the
/// complex, Internal where it is without a reason.
Result<Inspection> inspected(const Inspected& complex, std::vector<Step> vertices);

}  // namespace plateau
