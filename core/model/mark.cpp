#include "core/model/mark.h"

#include <cmath>

namespace fff {

namespace {

/// Of a matrix's entries, what rounding leaves of an even, upright one (no unit).
constexpr double kEven = 1e-9;

std::optional<Lettering> mapped(const Lettering &lettering, const Eigen::Matrix2d &matrix,
                                const Vec2 &about)
{
    const double scale = std::hypot(matrix(0, 0), matrix(1, 0));
    const bool isEven = std::abs(matrix(0, 0) - matrix(1, 1)) <= kEven * scale &&
                        std::abs(matrix(0, 1) + matrix(1, 0)) <= kEven * scale;
    if (!isEven)
        return std::nullopt;
    Lettering next = lettering;
    next.height *= scale;
    next.at = about + matrix * (lettering.at - about);
    next.turn += std::atan2(matrix(1, 0), matrix(0, 0));
    return next;
}

} // namespace

Result<MarkPointer> mapped(const MarkPointer &mark, const Eigen::Matrix2d &matrix,
                           const Vec2 &about)
{
    if (matrix == Eigen::Matrix2d::Identity())
        return mark;
    Mark next;
    next.kind = mark->kind;
    for (const CurvePath &path : mark->paths) {
        Result<CurvePath> moved = path.mapped(matrix, about);
        if (!moved)
            return tl::unexpected(moved.error());
        next.paths.push_back(*std::move(moved));
    }
    if (mark->lettering)
        next.lettering = mapped(*mark->lettering, matrix, about);
    return std::make_shared<const Mark>(std::move(next));
}

std::vector<MarkPointer> mapped(const std::vector<MarkPointer> &marks,
                                const Eigen::Matrix2d &matrix, const Vec2 &about)
{
    std::vector<MarkPointer> next;
    for (const MarkPointer &mark : marks)
        if (Result<MarkPointer> moved = mapped(mark, matrix, about))
            next.push_back(*std::move(moved));
    return next;
}

} // namespace fff
