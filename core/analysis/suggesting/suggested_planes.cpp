#include "core/analysis/suggesting/suggested_planes.h"

#include "core/operations/seeded.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fff {

namespace {

/// Planes across one direction.
struct PlaneFamily
{
    Vec3 normal = Vec3::UnitX();
    int count = 0;
    double preference = 1.0;
    double symmetryPreference = 1.0; // of the plane of symmetry in it
};

constexpr double kSymmetryPreference = 1.3, kAxisPreference = 1.08;
/// What planes count that are parallel to no main face, by the share of the surface that these are:
/// of a cube the diagonals are planes of symmetry, too, and larger, but say little about it.
double shareAskew(double ofFaces)
{
    constexpr double kLoss = 0.5, kLossOfBoxes = 0.4;
    return 1.0 - kLoss * ofFaces - kLossOfBoxes * ofFaces * ofFaces;
}
/// Of directions between the axes, seen from above.
constexpr double kAngleStep = std::numbers::pi / 12.0;
/// By so much, radians, the seed turns these to either side.
constexpr double kAngleShift = std::numbers::pi / 40.0;
/// Directions nearer than this, radians, are one.
constexpr double kSameFamily = 0.12;
constexpr int kAcrossAxis = 30, kAcrossForm = 20, kBetween = 14, kAcrossHeight = 16;

Vec3 middleOf(const std::vector<Vec3> &points)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3 &p : points)
        sum += p;
    return sum / static_cast<double>(points.size());
}

/// The main axes of the points, as far as these spread along them by other lengths: those of what
/// is round would follow from rounding alone.
std::vector<Vec3> formAxes(const std::vector<Vec3> &points, bool isSeenFromAbove)
{
    const Vec3 middle = middleOf(points);
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3 &p : points) {
        Vec3 way = p - middle;
        if (isSeenFromAbove)
            way.y() = 0.0;
        spread += way * way.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Vec3 &along = solver.eigenvalues(); // ascending
    constexpr double kOther = 1.1;
    std::vector<Vec3> axes;
    for (int i = isSeenFromAbove ? 1 : 0; i < 3; ++i) {
        const bool isAboveLast = i == 0 || along[i] > kOther * along[i - 1];
        const bool isBelowNext = i == 2 || along[i + 1] > kOther * along[i];
        if (isAboveLast && isBelowNext)
            axes.push_back(solver.eigenvectors().col(i));
    }
    return axes;
}

class FamilyList
{
public:
    FamilyList(const std::vector<MainFace> &faces, bool allowsAskew) : m_allowsAskew(allowsAskew)
    {
        constexpr double kLies = 0.7; // sine of what rather lies than stands
        double ofFaces = 0.0;
        for (const MainFace &face : faces) {
            const bool lies = std::abs(face.normal.y()) > kLies;
            add(face.normal, lies ? kAcrossHeight : kAcrossAxis, kAxisPreference);
            ofFaces += face.share;
        }
        m_askew = shareAskew(ofFaces);
        m_areFaces = false;
    }
    /// Unless there is one across nearly that direction.
    void add(const Vec3 &normal, int count, double preference)
    {
        for (const PlaneFamily &known : m_all)
            if (known.normal.cross(normal).norm() < std::sin(kSameFamily))
                return;
        constexpr double kLeastAskew = 0.3; // else it is a box
        if (!m_areFaces && !m_allowsAskew && m_askew < kLeastAskew)
            return;
        const double share = m_areFaces ? 1.0 : m_askew;
        m_all.push_back({normal, count, share * preference, share * kSymmetryPreference});
    }
    const std::vector<PlaneFamily> &all() const { return m_all; }

private:
    std::vector<PlaneFamily> m_all;
    bool m_allowsAskew;
    bool m_areFaces = true; // that are added
    double m_askew = 1.0;   // what planes count that are parallel to none
};

std::vector<PlaneFamily> planeFamilies(const FormSamples &samples, bool allowsAskew, Seeded &dice)
{
    FamilyList families(samples.faces(), allowsAskew);
    families.add(Vec3::UnitX(), kAcrossAxis, kAxisPreference);
    families.add(Vec3::UnitZ(), kAcrossAxis, kAxisPreference);
    families.add(Vec3::UnitY(), kAcrossHeight, kAxisPreference);
    for (const Vec3 &axis : formAxes(samples.surface(), true))
        families.add(axis, kAcrossForm, kAxisPreference);
    for (const Vec3 &axis : formAxes(samples.surface(), false))
        families.add(axis, kAcrossHeight, 1.0);
    for (double angle = kAngleStep; angle < std::numbers::pi - 0.5 * kAngleStep;
         angle += kAngleStep) {
        const double turned = angle + kAngleShift * dice.symmetric();
        families.add({std::cos(turned), 0.0, std::sin(turned)}, kBetween, 1.0);
    }
    return families.all();
}

std::pair<double, double> extentAlong(const Vec3 &normal, const std::vector<Vec3> &positions)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3 &p : positions) {
        low = std::min(low, normal.dot(p));
        high = std::max(high, normal.dot(p));
    }
    return {low, high};
}

} // namespace

bool isSymmetricAbout(const Vec3 &normal, double offset, const FormSamples &samples)
{
    // Samples of a surface are no mirror images of each other: where it is symmetric there is one
    // within their distance, but for few.
    constexpr double kNear = 1.6, kFew = 0.03;
    constexpr std::size_t kEach = 5;
    const double reach = kNear * samples.spacing();
    const PointBuckets surface(samples.surface(), reach);
    std::size_t looked = 0, lonely = 0;
    for (std::size_t i = 0; i < surface.points().size(); i += kEach) {
        const Vec3 &p = surface.points()[i];
        const Vec3 image = p - 2.0 * (normal.dot(p) - offset) * normal;
        bool isThere = false;
        surface.visitNear(image, [&](std::uint32_t k) {
            isThere = isThere || (surface.points()[k] - image).squaredNorm() <= reach * reach;
        });
        ++looked;
        lonely += isThere ? 0 : 1;
    }
    return looked > 0 && static_cast<double>(lonely) <= kFew * static_cast<double>(looked);
}

std::vector<SuggestedPlane> planesAcross(const Vec3 &normal, const std::vector<Vec3> &positions,
                                         double step, double share, double preference)
{
    const auto [low, high] = extentAlong(normal, positions);
    std::vector<SuggestedPlane> planes;
    for (double at = low + share * step; at < high; at += step)
        planes.push_back({normal, at, preference});
    return planes;
}

std::vector<SuggestedPlane> suggestedPlanes(const std::vector<Vec3> &positions,
                                            const FormSamples &samples, double within,
                                            bool allowsAskew, std::uint64_t seed)
{
    Seeded dice(seed, "planes");
    const Vec3 middle = middleOf(samples.surface());
    std::vector<SuggestedPlane> planes;
    for (const PlaneFamily &family : planeFamilies(samples, allowsAskew, dice)) {
        const auto [low, high] = extentAlong(family.normal, positions);
        const double step = (high - low) / family.count;
        const double shift = 0.5 + 0.4 * dice.symmetric();
        for (int i = 0; i < family.count; ++i)
            planes.push_back({family.normal, low + (i + shift) * step, family.preference});
        const double through = family.normal.dot(middle), half = 0.5 * (low + high);
        for (const double offset : {through, half})
            if (isSymmetricAbout(family.normal, offset, samples)) {
                planes.push_back({family.normal, offset, family.symmetryPreference});
                break;
            }
    }
    for (const MainFace &face : samples.faces())
        for (const MainFace::Place &place : face.places)
            planes.push_back({face.normal, place.offset + (place.looksAlong ? -within : within),
                              kAxisPreference});
    return planes;
}

} // namespace fff
