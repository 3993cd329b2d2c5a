#include "core/assembly/locking.h"

#include "core/assembly/nonnegative_fit.h"

#include <algorithm>

namespace fff {

namespace {

/// How near to a unit push the contacts have to come.
constexpr double kBalanced = 1e-6;

} // namespace

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

/// A column a contact: how a push of 1 there works on each of the things. Below it is room for how
/// far they come, and behind it for what fills that up.
Eigen::MatrixXd Locking::columns() const
{
    const Eigen::Index rows = 6 * static_cast<Eigen::Index>(m_pivots.size());
    Eigen::MatrixXd columns =
        Eigen::MatrixXd::Zero(rows + 1, static_cast<Eigen::Index>(m_contacts.size()) + 1);
    for (std::size_t i = 0; i < m_contacts.size(); ++i) {
        const RigidContact &touch = m_contacts[i];
        auto column = columns.col(static_cast<Eigen::Index>(i));
        const auto push = [&](int thing, const Vec3 &along) {
            if (thing == RigidContact::kAtRest)
                return;
            const Pivot &pivot = m_pivots[static_cast<std::size_t>(thing)];
            column.segment<3>(6 * thing) = along;
            column.segment<3>(6 * thing + 3) =
                (touch.contact.at - pivot.at).cross(along) / pivot.radius;
        };
        push(touch.thing, touch.contact.normal);
        push(touch.other, -touch.contact.normal);
    }
    return columns;
}

std::optional<Motion> Locking::motionAlong(Eigen::Index number, double way,
                                           const Looseness &looseness) const
{
    Eigen::MatrixXd columns = this->columns();
    const Eigen::Index rows = columns.rows() - 1;
    for (std::size_t i = 0; i < m_contacts.size(); ++i)
        columns(rows, static_cast<Eigen::Index>(i)) =
            (std::max(m_contacts[i].contact.gap, 0.0) + looseness.play) / looseness.limit;
    columns(rows, columns.cols() - 1) = 1.0;
    Eigen::VectorXd target = Eigen::VectorXd::Zero(rows + 1);
    target[number] = -way;
    target[rows] = 1.0;
    const Eigen::VectorXd rest = restBeyondCone(columns, target);
    if (!(rest.norm() > kBalanced))
        return {};
    // No contact's push has to do with it but against it, by no more than the gap lets.
    return Motion(-rest.head(rows));
}

std::optional<Motion> Locking::nearestMotion(const Motion &wanted) const
{
    Eigen::MatrixXd columns = this->columns();
    const Eigen::Index rows = columns.rows() - 1;
    columns.conservativeResize(Eigen::NoChange, columns.cols() - 1);
    for (std::size_t i = 0; i < m_contacts.size(); ++i) {
        auto column = columns.col(static_cast<Eigen::Index>(i));
        column[rows] =
            -(m_contacts[i].contact.gap + m_contacts[i].give) - column.head(rows).dot(wanted);
    }
    // What is left of a unit beyond all of them has the change in its rows, and how much it is
    // multiplied by in the last one. Source: C. Lawson, R. Hanson 1974, 23.4, LDP.
    Eigen::VectorXd target = Eigen::VectorXd::Zero(rows + 1);
    target[rows] = 1.0;
    const Eigen::VectorXd rest = restBeyondCone(columns, target);
    if (!(rest[rows] > kBalanced))
        return {};
    return Motion(wanted - rest.head(rows) / rest[rows]);
}

} // namespace fff
