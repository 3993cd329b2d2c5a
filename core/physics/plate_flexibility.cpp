#include "core/physics/plate_flexibility.h"

namespace fff {

namespace {

/// Which of the six parts of a wrench act in the plane, and which across the plate.
constexpr std::array<int, 3> kInPlaneParts{0, 1, 5}, kAcrossParts{2, 3, 4};

/// Fills rows and columns of `parts` of every attachment.
void setParts(PlateFlexibility &result, const std::array<int, 3> &parts,
              const Eigen::MatrixXd &unit, const Eigen::MatrixXd &moved)
{
    const Eigen::Index n = unit.cols() / 3;
    const Eigen::MatrixXd work = unit.transpose() * moved;
    const auto row = [&](Eigen::Index i) {
        return 6 * (i / 3) + parts[static_cast<std::size_t>(i % 3)];
    };
    for (Eigen::Index i = 0; i < 3 * n; ++i) {
        for (Eigen::Index j = 0; j < 3 * n; ++j)
            result.compliance(row(i), row(j)) = 0.5 * (work(i, j) + work(j, i));
        result.deflection[row(i)] = work(i, 3 * n);
    }
}

Eigen::MatrixXd joinedColumns(const Eigen::MatrixXd &left, const Eigen::VectorXd &right)
{
    Eigen::MatrixXd joined(left.rows(), left.cols() + 1);
    joined << left, right;
    return joined;
}

} // namespace

PlateFlexibility PlateFlexibility::inWorld(const Frame &frame) const
{
    Eigen::Matrix3d turn;
    turn << frame.x, frame.y, frame.normal();
    const Eigen::Index thirds = deflection.size() / 3;
    PlateFlexibility world{compliance, deflection};
    for (Eigen::Index i = 0; i < thirds; ++i) {
        world.deflection.segment<3>(3 * i) = turn * deflection.segment<3>(3 * i);
        for (Eigen::Index j = 0; j < thirds; ++j)
            world.compliance.block<3, 3>(3 * i, 3 * j) =
                turn * compliance.block<3, 3>(3 * i, 3 * j) * turn.transpose();
    }
    return world;
}

Result<PlateFlexibility> plateFlexibility(const PlateModel &model,
                                          const std::vector<PlateAttachment> &attachments,
                                          const PlateField &forces, const LongWork &work)
{
    const auto n = static_cast<Eigen::Index>(attachments.size());
    Eigen::MatrixXd membrane = Eigen::MatrixXd::Zero(forces.membrane.size(), 3 * n);
    Eigen::MatrixXd bending = Eigen::MatrixXd::Zero(forces.bending.size(), 3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        for (std::size_t k = 0; k < 3; ++k) {
            PlateField unit = model.noField();
            const PlateAttachment &attachment = attachments[static_cast<std::size_t>(i)];
            addWrench(unit, model, attachment, WrenchVector::Unit(kInPlaneParts[k]));
            addWrench(unit, model, attachment, WrenchVector::Unit(kAcrossParts[k]));
            membrane.col(3 * i + static_cast<Eigen::Index>(k)) = unit.membrane;
            bending.col(3 * i + static_cast<Eigen::Index>(k)) = unit.bending;
        }
    }
    PlateFlexibility result{Eigen::MatrixXd::Zero(6 * n, 6 * n), Eigen::VectorXd::Zero(6 * n)};
    setParts(result, kInPlaneParts, membrane,
             model.solveMembrane(joinedColumns(membrane, forces.membrane)));
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    setParts(result, kAcrossParts, bending,
             model.solveBending(joinedColumns(bending, forces.bending)));
    return result;
}

} // namespace fff
