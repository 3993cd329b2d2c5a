#include "core/geometry/round_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr std::size_t kFewestPoints = 5;
/// Half axes in extents of the line from which on it is none: an arc that passes for a line.
constexpr double kLargest = 4.0;

/// The points about their middle, in extents, and what each counts.
struct Weighed
{
    Vec2 middle = Vec2::Zero();
    double scale = 0.0; // mm
    std::vector<Vec2> points;
    std::vector<double> weights; // 1 in all
};

std::optional<Weighed> weighed(const std::vector<Vec2> &loop)
{
    if (loop.size() < kFewestPoints)
        return {};
    Weighed result;
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &before = loop[i > 0 ? i - 1 : loop.size() - 1];
        const Vec2 &after = loop[(i + 1) % loop.size()];
        result.weights.push_back(0.5 * ((loop[i] - before).norm() + (after - loop[i]).norm()));
        length += result.weights.back();
    }
    if (!(length > 0.0))
        return {};
    for (std::size_t i = 0; i < loop.size(); ++i) {
        result.weights[i] /= length;
        result.middle += result.weights[i] * loop[i];
    }
    Box2 box;
    for (const Vec2 &p : loop)
        box.extend(p);
    result.scale = 0.5 * box.size().maxCoeff();
    if (!(result.scale > 0.0))
        return {};
    for (const Vec2 &p : loop)
        result.points.push_back((p - result.middle) / result.scale);
    return result;
}

/// mm
RoundFit judged(RoundFit fit, const Weighed &line)
{
    const Vec2 axis(std::cos(fit.turn), std::sin(fit.turn));
    double sum = 0.0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec2 off = line.points[i] - fit.centre;
        const double x = axis.dot(off) / fit.major, y = cross(axis, off) / fit.minor;
        const double radius = std::hypot(x, y), slope = std::hypot(x / fit.major, y / fit.minor);
        const double distance = slope > 0.0 ? std::abs(radius - 1.0) * radius / slope : fit.minor;
        sum += line.weights[i] * distance * distance;
        fit.most = std::max(fit.most, distance);
    }
    fit.mean = std::sqrt(sum) * line.scale;
    fit.most *= line.scale;
    fit.centre = line.middle + line.scale * fit.centre;
    fit.major *= line.scale;
    fit.minor *= line.scale;
    return fit;
}

/// a x² + b x y + c y² + d x + e y + f = 0
std::optional<RoundFit> fromConic(const Eigen::Vector3d &square, const Eigen::Vector3d &linear)
{
    const double a = square[0], b = square[1], c = square[2];
    const double determinant = 4.0 * a * c - b * b;
    if (!(determinant > 0.0))
        return {};
    RoundFit fit;
    fit.centre = {(b * linear[1] - 2.0 * c * linear[0]) / determinant,
                  (b * linear[0] - 2.0 * a * linear[1]) / determinant};
    const double value =
        0.5 * (linear[0] * fit.centre.x() + linear[1] * fit.centre.y()) + linear[2];
    Eigen::Matrix2d form;
    form << a, 0.5 * b, 0.5 * b, c;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(form / -value);
    const double least = axes.eigenvalues()[0], most = axes.eigenvalues()[1];
    if (!(least > 0.0) || !std::isfinite(most))
        return {};
    fit.major = 1.0 / std::sqrt(least);
    fit.minor = 1.0 / std::sqrt(most);
    if (fit.major > kLargest)
        return {};
    const Vec2 along = axes.eigenvectors().col(0);
    fit.turn = std::atan2(along.y(), along.x());
    return fit;
}

} // namespace

std::optional<RoundFit> fitEllipse(const std::vector<Vec2> &loop)
{
    const std::optional<Weighed> line = weighed(loop);
    if (!line)
        return {};
    using Matrix = Eigen::Matrix3d;
    Matrix squares = Matrix::Zero(), mixed = Matrix::Zero(), linears = Matrix::Zero();
    for (std::size_t i = 0; i < line->points.size(); ++i) {
        const Vec2 &p = line->points[i];
        const Eigen::Vector3d square(p.x() * p.x(), p.x() * p.y(), p.y() * p.y()),
            linear(p.x(), p.y(), 1.0);
        squares += line->weights[i] * square * square.transpose();
        mixed += line->weights[i] * square * linear.transpose();
        linears += line->weights[i] * linear * linear.transpose();
    }
    const Eigen::FullPivLU<Matrix> solver(linears);
    if (!solver.isInvertible())
        return {};
    const Matrix toLinear = -solver.solve(mixed.transpose());
    const Matrix reduced = squares + mixed * toLinear;
    Matrix system;
    system.row(0) = 0.5 * reduced.row(2);
    system.row(1) = -reduced.row(1);
    system.row(2) = 0.5 * reduced.row(0);
    const Eigen::EigenSolver<Matrix> solved(system);
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d square = solved.eigenvectors().col(k).real();
        if (4.0 * square[0] * square[2] - square[1] * square[1] <= 0.0)
            continue;
        if (const std::optional<RoundFit> fit = fromConic(square, toLinear * square))
            return judged(*fit, *line);
    }
    return {};
}

std::optional<RoundFit> fitCircle(const std::vector<Vec2> &loop)
{
    const std::optional<Weighed> line = weighed(loop);
    if (!line)
        return {};
    // |p|² = 2 c p + r² − c²
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < line->points.size(); ++i) {
        const Vec2 &p = line->points[i];
        const Eigen::Vector3d row(2.0 * p.x(), 2.0 * p.y(), 1.0);
        matrix += line->weights[i] * row * row.transpose();
        right += line->weights[i] * p.squaredNorm() * row;
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> solver(matrix);
    if (!solver.isInvertible())
        return {};
    const Eigen::Vector3d x = solver.solve(right);
    RoundFit fit;
    fit.centre = {x[0], x[1]};
    fit.major = fit.minor = std::sqrt(std::max(0.0, x[2] + fit.centre.squaredNorm()));
    if (!(fit.major > 0.0) || fit.major > kLargest)
        return {};
    return judged(fit, *line);
}

} // namespace fff
