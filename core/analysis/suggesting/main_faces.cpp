#include "core/analysis/suggesting/main_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

/// Radians: what turns by less is one flat face, and another face is turned by more than that.
constexpr double kFlat = 0.035, kOtherFace = 0.2;
/// Each so many-th normal is tried as that of a face.
constexpr std::size_t kTriedEach = 5;

/// Of the surface: what is less at one place is a step or a rib.
constexpr double kLeastPlace = 0.02;

std::vector<MainFace::Place> placesOf(const Vec3 &normal, const std::vector<Vec3> &points,
                                      const std::vector<Vec3> &normals, double near)
{
    std::vector<MainFace::Place> places;
    for (const bool looksAlong : {false, true}) {
        const double sign = looksAlong ? 1.0 : -1.0;
        std::vector<double> offsets;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (sign * normals[i].dot(normal) > std::cos(kFlat))
                offsets.push_back(normal.dot(points[i]));
        std::sort(offsets.begin(), offsets.end());
        for (std::size_t from = 0; from < offsets.size();) {
            std::size_t to = from + 1;
            while (to < offsets.size() && offsets[to] - offsets[to - 1] < near)
                ++to;
            if (static_cast<double>(to - from) >= kLeastPlace * static_cast<double>(points.size()))
                places.push_back({offsets[(from + to) / 2], looksAlong});
            from = to;
        }
    }
    return places;
}

} // namespace

std::vector<MainFace> mainFaces(const std::vector<Vec3> &points, const std::vector<Vec3> &normals,
                                double near)
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
                best = {normals[i], share, {}};
        }
        if (best.share < kLeastMainFace)
            return faces;
        for (std::size_t i = 0; i < normals.size(); ++i)
            if (std::abs(normals[i].dot(best.normal)) > isNear)
                isOut[i] = 1;
        best.places = placesOf(best.normal, points, normals, near);
        faces.push_back(std::move(best));
    }
}

} // namespace fff
