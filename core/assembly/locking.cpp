#include "core/assembly/locking.h"

#include "core/assembly/nonnegative_fit.h"

namespace fff {

namespace {

/// How near to a unit push the contacts have to come.
constexpr double kBalanced = 1e-6;

/// Where a thing touches, about which it turns.
struct Pivot
{
    Vec3 at = Vec3::Zero();
    double radius = 1.0; // mm
};

std::vector<Pivot> pivotsOf(const std::vector<RigidContact> &contacts, int things)
{
    std::vector<Box3> boxes(static_cast<std::size_t>(things));
    for (const RigidContact &touch : contacts)
        for (const int thing : {touch.thing, touch.other})
            if (thing != RigidContact::kAtRest)
                boxes[static_cast<std::size_t>(thing)].extend(touch.contact.at);
    std::vector<Pivot> pivots(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].isEmpty() && boxes[i].size().norm() > 0.0)
            pivots[i] = {boxes[i].center(), 0.5 * boxes[i].size().norm()};
    return pivots;
}

} // namespace

std::vector<char> movable(const std::vector<RigidContact> &contacts, int things,
                          const Looseness &looseness)
{
    const std::vector<Pivot> pivots = pivotsOf(contacts, things);
    const Eigen::Index rows = 6 * static_cast<Eigen::Index>(pivots.size());
    // A column a contact: how a push of 1 there works on each of the things, and below it how far
    // they come for that. The last one fills that up to the limit.
    Eigen::MatrixXd columns =
        Eigen::MatrixXd::Zero(rows + 1, static_cast<Eigen::Index>(contacts.size()) + 1);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const RigidContact &touch = contacts[i];
        auto column = columns.col(static_cast<Eigen::Index>(i));
        const auto push = [&](int thing, const Vec3 &along) {
            if (thing == RigidContact::kAtRest)
                return;
            const Pivot &pivot = pivots[static_cast<std::size_t>(thing)];
            column.segment<3>(6 * thing) = along;
            column.segment<3>(6 * thing + 3) =
                (touch.contact.at - pivot.at).cross(along) / pivot.radius;
        };
        push(touch.thing, touch.contact.normal);
        push(touch.other, -touch.contact.normal);
        column[rows] = (touch.contact.gap + looseness.play) / looseness.limit;
    }
    columns(rows, columns.cols() - 1) = 1.0;
    const auto isFree = [&](Eigen::Index row, double way) {
        Eigen::VectorXd target = Eigen::VectorXd::Zero(rows + 1);
        target[row] = -way;
        target[rows] = 1.0;
        return distanceFromCone(columns, target) > kBalanced;
    };
    std::vector<char> movable(pivots.size(), 0);
    for (Eigen::Index row = 0; row < rows; ++row) {
        char &isMovable = movable[static_cast<std::size_t>(row / 6)];
        isMovable = isMovable || isFree(row, 1.0) || isFree(row, -1.0);
    }
    return movable;
}

} // namespace fff
