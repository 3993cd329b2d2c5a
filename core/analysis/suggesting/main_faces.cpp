#include "core/analysis/suggesting/main_faces.h"

#include <cmath>

namespace fff {

namespace {

/// Radians: what turns by less is one flat face, and another face is turned by more than that.
constexpr double kFlat = 0.035, kOtherFace = 0.2;
/// Each so many-th normal is tried as that of a face.
constexpr std::size_t kTriedEach = 5;

} // namespace

std::vector<MainFace> mainFaces(const std::vector<Vec3> &normals)
{
    const double isSame = std::cos(kFlat), isNear = std::cos(kOtherFace);
    std::vector<MainFace> faces;
    std::vector<char> isOut(normals.size(), 0);
    for (;;) {
        MainFace best;
        for (std::size_t i = 0; i < normals.size(); i += kTriedEach) {
            if (isOut[i])
                continue;
            std::size_t count = 0;
            for (const Vec3 &normal : normals)
                count += std::abs(normal.dot(normals[i])) > isSame ? 1 : 0;
            const double share = static_cast<double>(count) / static_cast<double>(normals.size());
            if (share > best.share)
                best = {normals[i], share};
        }
        if (best.share < kLeastMainFace)
            return faces;
        for (std::size_t i = 0; i < normals.size(); ++i)
            if (std::abs(normals[i].dot(best.normal)) > isNear)
                isOut[i] = 1;
        faces.push_back(best);
    }
}

} // namespace fff
