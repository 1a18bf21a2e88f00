#include "dilated/cell_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/few.h"

namespace plateau {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Powers are rounded sums of a few squares; the tiny weights that break ties are mostly a thousand times as large.
constexpr double kPowerRounding = 0x1p-46;
// A normal is in the span of others when the sine of its angle to it is less.
constexpr double kDependent = 1e-10;
// Far more than any program has needed; rounding could make one go in circles.
constexpr int kMostChanges = 400;

template <std::size_t D>
double dot(const std::array<double, D>& a, const std::array<double, D>& b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) sum += a[axis] * b[axis];
    return sum;
}

}  // namespace

// min |y|^2 with normal . y <= bound for each constraint, relative to x. The normals of the active constraints are kept
// as an orthonormal basis and the triangle that leads back to them.
template <std::size_t D>
struct CellDistance::Program {
    using Vector = std::array<double, D>;
    struct Constraint {
        Step vertex = 0, other = 0;
        Vector normal{};
        double bound = 0;
        double multiplier = 0;
        bool operator<(const Constraint& other_one) const {
            return vertex != other_one.vertex ? vertex < other_one.vertex : other < other_one.other;
        }
    };
    struct Direction {
        Vector free{};        // part of a normal that no active one spans
        Vector multiples{};   // of the active normals in the rest
        double free_squared;  // squared length of `free`; 0: none is
    };

    Vector y{};
    std::size_t count = 0;
    std::array<Constraint, kMaxActive> active{};
    std::array<Vector, D> basis{};
    std::array<Vector, D> triangle{};  // [j][i]: part of normal j along basis i

    Direction direction(const Vector& normal) const {
        Direction result{normal, {}, 0};
        Vector along{};
        // Twice: what the first pass leaves along the basis is rounding of the normal, not of what is free.
        for (int pass = 0; pass < 2; ++pass) {
            for (std::size_t i = 0; i < count; ++i) {
                const double part = dot(basis[i], result.free);
                along[i] += part;
                for (std::size_t axis = 0; axis < D; ++axis) result.free[axis] -= part * basis[i][axis];
            }
        }
        for (std::size_t i = count; i-- > 0;) {
            double rest = along[i];
            for (std::size_t j = i + 1; j < count; ++j) rest -= triangle[j][i] * result.multiples[j];
            result.multiples[i] = rest / triangle[i][i];
        }
        const double squared = count == D ? 0 : dot(result.free, result.free);
        result.free_squared = squared > kDependent * kDependent * dot(normal, normal) ? squared : 0;
        return result;
    }

    void append(const Constraint& constraint) {
        Vector rest = constraint.normal;
        Vector along{};
        for (int pass = 0; pass < 2; ++pass) {
            for (std::size_t i = 0; i < count; ++i) {
                const double part = dot(basis[i], rest);
                along[i] += part;
                for (std::size_t axis = 0; axis < D; ++axis) rest[axis] -= part * basis[i][axis];
            }
        }
        const double length = std::sqrt(dot(rest, rest));
        along[count] = length;
        for (std::size_t axis = 0; axis < D; ++axis) basis[count][axis] = rest[axis] / length;
        triangle[count] = along;
        active[count] = constraint;
        ++count;
    }

    void rebuild(std::size_t kept) {
        count = 0;
        for (std::size_t i = 0; i < kept; ++i) append(active[i]);
    }

    void drop(std::size_t index) {
        for (std::size_t i = index; i + 1 < count; ++i) active[i] = active[i + 1];
        rebuild(count - 1);
    }

    // Makes the violated constraint hold; false where no point meets it together with the active ones.
    bool meet(Constraint constraint) {
        for (;;) {
            const double violation = dot(constraint.normal, y) - constraint.bound;
            if (!(violation > 0)) return true;  // rounding met it when another was dropped
            const Direction towards = direction(constraint.normal);
            const double whole = towards.free_squared > 0 ? violation / towards.free_squared : kInfinity;
            double part = kInfinity;
            std::size_t first = 0;
            for (std::size_t i = 0; i < count; ++i) {
                if (!(towards.multiples[i] > 0)) continue;
                const double ratio = active[i].multiplier / towards.multiples[i];
                if (ratio < part) {
                    part = ratio;
                    first = i;
                }
            }
            const double step = std::min(whole, part);
            if (step == kInfinity) return false;
            for (std::size_t i = 0; i < count; ++i) active[i].multiplier -= step * towards.multiples[i];
            constraint.multiplier += step;
            if (whole < kInfinity) {
                for (std::size_t axis = 0; axis < D; ++axis) y[axis] -= step * towards.free[axis];
            }
            if (whole <= part) {
                append(constraint);
                return true;
            }
            drop(first);
        }
    }

    // The point that the active constraints alone determine, in their sorted order.
    void settle() {
        sort_few(active.data(), count);
        rebuild(count);
        Vector along{};
        y = {};
        for (std::size_t j = 0; j < count; ++j) {
            double rest = active[j].bound;
            for (std::size_t i = 0; i < j; ++i) rest -= triangle[j][i] * along[i];
            along[j] = rest / triangle[j][j];
            for (std::size_t axis = 0; axis < D; ++axis) y[axis] += along[j] * basis[j][axis];
        }
    }
};

void CellDistance::begin(std::span<const Step> simplex) {
    std::copy(simplex.begin(), simplex.end(), simplex_.begin());
    vertices_ = simplex.size();
    pool_.clear();
    seen_.resize(landmarks_->size() + std::size_t{1}, 0);
    ++stamp_;
    for (const Step vertex : simplex) seen_[vertex] = stamp_;
}

void CellDistance::consider(Step landmark) {
    if (seen_[landmark] == stamp_) return;
    seen_[landmark] = stamp_;
    pool_.push_back(landmark);
}

bool CellDistance::has_vertex(Step landmark) const {
    for (std::size_t i = 0; i < vertices_; ++i) {
        if (simplex_[i] == landmark) return true;
    }
    return false;
}

template <std::size_t D>
double CellDistance::solve(const double* x, double near, double far) {
    using Vector = std::array<double, D>;
    struct Site {  // a landmark seen from x
        Vector place{};
        double power = 0;
        double at(const Vector& y) const { return power - 2 * dot(place, y); }
    };
    const auto site_of = [&](Step landmark) {
        Site site;
        const double* p = landmarks_->point(landmark);
        for (std::size_t axis = 0; axis < D; ++axis) site.place[axis] = p[axis] - x[axis];
        site.power = dot(site.place, site.place) - landmarks_->weight_squared(landmark);
        return site;
    };
    std::array<Site, kMaxVertices> inside;
    double reach_squared = 0;
    for (std::size_t i = 0; i < vertices_; ++i) {
        inside[i] = site_of(simplex_[i]);
        reach_squared = std::max(reach_squared, dot(inside[i].place, inside[i].place));
    }
    relative_.clear();
    const auto load = [&](const Site& site) {
        relative_.insert(relative_.end(), site.place.begin(), site.place.end());
        relative_.push_back(site.power);
    };
    for (const Step landmark : pool_) load(site_of(landmark));

    Program<D> program;
    for (int changes = 0;; ++changes) {
        if (changes == kMostChanges) return std::numeric_limits<double>::quiet_NaN();
        // The vertex of a hidden landmark can lie at x itself, and y far away.
        const double rounding = kPowerRounding * (reach_squared + dot(program.y, program.y));
        std::size_t worst = 0;
        double largest = inside[0].at(program.y);
        for (std::size_t i = 1; i < vertices_; ++i) {
            const double power = inside[i].at(program.y);
            if (power > largest) {
                largest = power;
                worst = i;
            }
        }
        Step other = 0;
        Site outside;
        double smallest = kInfinity;
        std::size_t place = 0;
        for (std::size_t i = 0; i < pool_.size(); ++i) {
            const double* row = relative_.data() + i * (D + 1);
            double along = 0;
            for (std::size_t axis = 0; axis < D; ++axis) along += row[axis] * program.y[axis];
            const double power = row[D] - 2 * along;
            if (power < smallest) {
                smallest = power;
                place = i;
            }
        }
        if (smallest < kInfinity) {
            other = pool_[place];
            const double* row = relative_.data() + place * (D + 1);
            for (std::size_t axis = 0; axis < D; ++axis) outside.place[axis] = row[axis];
            outside.power = row[D];
        }
        if (!(largest - smallest > rounding)) {
            if (dot(program.y, program.y) > near * near) break;
            other = 0;
            for (Step landmark = 1; landmark <= landmarks_->size(); ++landmark) {
                if (seen_[landmark] == stamp_) continue;
                const Site site = site_of(landmark);
                const double power = site.at(program.y);
                if (power < smallest) {
                    smallest = power;
                    outside = site;
                    other = landmark;
                }
            }
            if (other == 0 || !(largest - smallest > rounding)) break;
            consider(other);
            load(outside);
        }
        typename Program<D>::Constraint constraint{simplex_[worst], other, {}, outside.power - inside[worst].power, 0};
        for (std::size_t axis = 0; axis < D; ++axis) {
            constraint.normal[axis] = 2 * (outside.place[axis] - inside[worst].place[axis]);
        }
        if (!program.meet(constraint)) return kInfinity;
        if (const double squared = dot(program.y, program.y); squared > far * far) return squared;
    }
    program.settle();
    for (std::size_t axis = 0; axis < D; ++axis) nearest_[axis] = x[axis] + program.y[axis];
    power_ = -kInfinity;
    for (std::size_t i = 0; i < vertices_; ++i) {
        power_ = std::max(power_, landmarks_->power(simplex_[i], nearest_.data()));
    }
    return dot(program.y, program.y);
}

double CellDistance::from(const double* x, double near, double far) {
    switch (landmarks_->dimension()) {
        case 2:
            return solve<2>(x, near, far);
        case 3:
            return solve<3>(x, near, far);
        case 4:
            return solve<4>(x, near, far);
        default:
            return solve<5>(x, near, far);
    }
}

}  // namespace plateau
