#include "inspect/delaunay_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "delaunay/delaunay.h"

namespace plateau {

namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double determinant(const std::array<Vector, 3>& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

struct Ball {
    Vector center{};
    double radius = 0;
    bool is_trusted = false;  ///< it is off by far less than kMargin of its radius
};

constexpr double kMargin = 0x1p-10;

// The smallest ball with the points on its boundary. The center c solves 2 (c - a) . u = u . u for the edges u from the
// first point a: with c - a = sum x_j u_j, G x = b / 2, G their Gram matrix. Where det G is at least 2^-20 of the
// product of its diagonal, the solution is off by less than 2^-26 of its size.
Ball smallest_ball(std::span<const Vector> points) {
    constexpr double kWellConditioned = 0x1p-20;
    const std::size_t count = points.size() - 1;
    std::array<Vector, 3> edges{};
    std::array<Vector, 3> gram = {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
    Vector half{};
    double diagonal = 1;
    for (std::size_t i = 0; i < count; ++i) edges[i] = minus(points[i + 1], points[0]);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) gram[i][j] = dot(edges[i], edges[j]);
        half[i] = gram[i][i] / 2;
        diagonal *= gram[i][i];
    }
    const double whole = determinant(gram);
    Ball ball{points[0], 0, whole > kWellConditioned * diagonal};
    if (!(whole > 0)) return ball;
    for (std::size_t j = 0; j < count; ++j) {
        auto replaced = gram;
        for (std::size_t i = 0; i < 3; ++i) replaced[i][j] = half[i];
        const double multiple = determinant(replaced) / whole;
        for (std::size_t axis = 0; axis < 3; ++axis) ball.center[axis] += multiple * edges[j][axis];
    }
    const Vector out = minus(ball.center, points[0]);
    ball.radius = std::sqrt(dot(out, out));
    if (!std::isfinite(ball.radius)) ball = {points[0], 0, false};
    return ball;
}

// Landmarks seen from the first vertex of the simplex, so that none of it is lost in clouds far from the origin.
class Surroundings {
public:
    Surroundings(const PointCloud& landmarks, std::span<const Step> simplex)
        : landmarks_(&landmarks), origin_(simplex[0]) {
        std::vector<Vector> vertices;
        for (const Step vertex : simplex) vertices.push_back(place(vertex));
        const Vector center = smallest_ball(vertices).center;
        for (Step landmark = 1; landmark <= landmarks.size(); ++landmark) {
            if (std::find(simplex.begin(), simplex.end(), landmark) != simplex.end()) continue;
            const Vector away = minus(place(landmark), center);
            others_.emplace_back(dot(away, away), landmark);
        }
        std::sort(others_.begin(), others_.end());
        center_ = center;
    }

    /// All but the vertices, nearest to the center of the smallest ball first.
    const std::vector<std::pair<double, Step>>& others() const { return others_; }
    std::span<const double> point(Step landmark) const { return landmarks_->point(landmark - 1); }
    Vector place(Step landmark) const {
        Vector place{};
        for (std::size_t axis = 0; axis < landmarks_->dimension; ++axis) {
            place[axis] = point(landmark)[axis] - point(origin_)[axis];
        }
        return place;
    }
    /// Whether the ball holds none of the others but the `count` nearest ones.
    bool is_clear(const Ball& ball, std::size_t count) const {
        const Vector away = minus(ball.center, center_);
        const double far = (std::sqrt(dot(away, away)) + ball.radius) * (1 + kMargin);
        return ball.is_trusted && far < std::sqrt(others_[count].first);
    }

private:
    const PointCloud* landmarks_;
    Step origin_;
    Vector center_{};
    std::vector<std::pair<double, Step>> others_;  // by (squared distance, step)
};

// The cells with all vertices of a simplex in a triangulation that grows. Its labels are 1, 2, ... in the order in
// which landmarks come; the vertices come first.
class Star {
public:
    Star(const Surroundings& around, std::span<const Step> simplex)
        : around_(&around), width_(static_cast<std::uint32_t>(simplex.size())), delaunay_(dimension(around)) {
        for (const Step vertex : simplex) insert(vertex);
    }

    void insert(Step landmark) {
        if (failure_) return;
        labels_.push_back(landmark);
        const auto label = static_cast<std::uint32_t>(labels_.size());
        const auto inserted = delaunay_.insert(label, around_->point(landmark), 1);
        if (!inserted) {
            failure_ = inserted.error();
            return;
        }
        for (const CellId dead : inserted.value()->died) std::erase(cells_, dead);
        for (const CellId born : inserted.value()->born) {
            if (has_simplex(delaunay_.cell(born))) cells_.push_back(born);
        }
    }
    bool is_empty() const { return cells_.empty(); }
    const std::optional<Error>& failure() const { return failure_; }

    /// Whether one of its balls holds none of the others but those inserted, the nearest ones.
    bool is_settled() const {
        const std::size_t inserted = labels_.size() - width_;
        for (const CellId id : cells_) {
            const DelaunayCell& cell = delaunay_.cell(id);
            if (!cell.finite(delaunay_.dimension())) continue;
            std::vector<Vector> corners;
            for (int i = 0; i <= delaunay_.dimension(); ++i) {
                corners.push_back(around_->place(labels_[cell.vertex[static_cast<std::size_t>(i)] - 1]));
            }
            if (around_->is_clear(smallest_ball(corners), inserted)) return true;
        }
        return false;
    }

private:
    static std::uint32_t dimension(const Surroundings& around) {
        return static_cast<std::uint32_t>(around.point(1).size());
    }
    bool has_simplex(const DelaunayCell& cell) const {
        const auto vertices = std::count_if(cell.vertex.begin(), cell.vertex.end(), [&](std::uint32_t label) {
            return label != kInfiniteVertex && label <= width_;
        });
        return static_cast<std::uint32_t>(vertices) == width_;
    }

    const Surroundings* around_;
    std::uint32_t width_;
    Delaunay delaunay_;
    std::vector<Step> labels_;  // [label - 1] = landmark
    std::vector<CellId> cells_;
    std::optional<Error> failure_;
};

// The last of the nearest `count` others completes what keeps the simplex out. With it in from the start, so does
// another one, sooner; and so on until nothing more is needed.
Result<std::vector<Step>> blockers_among(std::size_t count, const Surroundings& around, std::span<const Step> simplex) {
    std::vector<Step> blockers;
    for (;;) {
        Star star(around, simplex);
        for (const Step blocker : blockers) star.insert(blocker);
        std::size_t inserted = 0;
        for (; inserted < count && !star.is_empty() && !star.failure(); ++inserted) {
            const Step other = around.others()[inserted].second;
            if (std::find(blockers.begin(), blockers.end(), other) == blockers.end()) star.insert(other);
        }
        if (star.failure()) return *star.failure();
        if (inserted == 0 || !star.is_empty()) break;
        count = inserted;
        blockers.push_back(around.others()[inserted - 1].second);
    }
    std::reverse(blockers.begin(), blockers.end());
    return blockers;
}

}  // namespace

Result<DelaunayPlace> delaunay_place(const PointCloud& landmarks, std::span<const Step> simplex) {
    constexpr std::size_t kFirstLook = 16;
    DelaunayPlace place;
    const Surroundings around(landmarks, simplex);
    Star star(around, simplex);
    place.is_flat = star.is_empty();
    const std::size_t count = around.others().size();
    std::size_t look = kFirstLook;
    std::size_t inserted = 0;
    while (inserted < count && !star.is_empty() && !star.failure()) {
        star.insert(around.others()[inserted++].second);
        if (inserted != look) continue;
        if (inserted < count && star.is_settled()) break;
        look *= 2;
    }
    if (star.failure()) return *star.failure();
    place.is_in = !star.is_empty();
    if (place.is_in || place.is_flat) return place;
    auto blockers = blockers_among(inserted, around, simplex);
    if (!blockers) return blockers.error();
    place.blockers = std::move(blockers).value();
    return place;
}

}  // namespace plateau
