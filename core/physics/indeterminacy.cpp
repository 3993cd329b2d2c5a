#include "core/physics/indeterminacy.h"

#include "core/physics/balance.h"
#include "core/physics/block_system.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace fff {

namespace {

/// Contact rows that stand out of the others by less than this share are no rows (no unit).
constexpr double kSameRow = 1e-5;
constexpr int kHeldByFingers = 5; // all but the turn about their edge

} // namespace

int indeterminacy(const Structure &structure, const Component &component, bool areAllHeld)
{
    Vec3 about = Vec3::Zero();
    for (int i : component.feet)
        about += structure.feet[i].point / component.feet.size();
    double reach = 0.0;
    for (int i : component.feet)
        reach = std::max(reach, (structure.feet[i].point - about).norm());

    const std::array<Vec3, 2> axes = groundAxes(structure.up);
    Block6 gram = Block6::Zero();
    int rows = 0;
    const auto addRow = [&](const Vec3 &point, const Vec3 &direction) {
        Vec6 row;
        row << direction, (point - about).cross(direction) / std::max(reach, 1e-300);
        gram += row * row.transpose();
        ++rows;
    };
    for (int i : component.feet) {
        const Foot &foot = structure.feet[i];
        addRow(foot.point, structure.up);
        if (areAllHeld || foot.isPinned) {
            addRow(foot.point, axes[0]);
            addRow(foot.point, axes[1]);
        }
    }
    const Vec6 squares =
        Eigen::SelfAdjointEigenSolver<Block6>(gram, Eigen::EigenvaluesOnly).eigenvalues();
    const double least = kSameRow * kSameRow * squares.maxCoeff();
    const int rank = static_cast<int>((squares.array() > least).count());
    const auto fingers =
        static_cast<int>(std::count_if(component.links.begin(), component.links.end(), [&](int i) {
            return structure.links[i].kind == LinkKind::Fingers;
        }));
    const int held = 6 * (static_cast<int>(component.links.size()) - fingers) +
                     kHeldByFingers * (fingers / 2); // two links of each joint
    const int members = static_cast<int>(component.members.size());
    return held - 6 * (members - 1) + rows - (rows > 0 ? rank : 0);
}

} // namespace fff
