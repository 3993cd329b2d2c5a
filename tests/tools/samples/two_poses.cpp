#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

#include "core/base/units.h"

#include <cmath>

namespace fff::samples {

namespace {

/// A dancer on one leg, from the side: where limbs point, in degrees from straight ahead.
struct Pose
{
    double torso, head, arm, forearm, otherArm, otherForearm, thigh, shin;
};

Vec2 towards(double degrees)
{
    return {std::cos(radians(degrees)), std::sin(radians(degrees))};
}

/// One outline for every pose, limbs equally long: what belongs together is found again by the
/// way along it. Stands on a foot of its own at x = 0.
Contour dancer(const Pose &pose)
{
    const auto left = [](const Vec2 &way) { return Vec2(-way.y(), way.x()); };
    const Vec2 torso = towards(pose.torso), back = left(torso);
    const Vec2 hip(0, 70), shoulder = hip + 37.0 * torso,
                           head = shoulder + 19.0 * towards(pose.head);
    std::vector<Corner> corners = {{{22, 0}, true}, {{19, 5}}, {{8, 11}}, {{5.5, 24}}, {{6.5, 44}}};
    corners.push_back({hip - 8.5 * back - Vec2(0, 1)});
    corners.push_back({hip + 18.0 * torso - 7.0 * back});
    const auto limb = [&](const Vec2 &from, double first, double second, double a, double b,
                          double thick, double thin) {
        const Vec2 u = towards(first), v = towards(second), joint = from + a * u,
                   end = joint + b * v, middle = left((u + v).normalized());
        corners.push_back({joint - thick * middle});
        corners.push_back({end - 3.0 * v - thin * left(v)});
        corners.push_back({end + thin * v});
        corners.push_back({end - 3.0 * v + thin * left(v)});
        corners.push_back({joint + thick * middle});
    };
    corners.push_back({shoulder - 5.0 * torso - 8.0 * back}); // below the arm that is in front
    limb(shoulder - 5.0 * back, pose.arm, pose.forearm, 23, 22, 4.2, 3.8);
    const Vec2 face = towards(pose.head), nape = left(face);
    corners.push_back({shoulder + 6.0 * face - 4.5 * nape});
    for (const double turn : {-110.0, -55.0, 0.0, 55.0, 110.0})
        corners.push_back({head + 9.0 * towards(pose.head + turn)});
    corners.push_back({shoulder + 6.0 * face + 4.5 * nape});
    limb(shoulder + 5.0 * back, pose.otherArm, pose.otherForearm, 23, 22, 4.2, 3.8);
    corners.push_back({shoulder - 5.0 * torso + 8.0 * back});
    corners.push_back({hip + 18.0 * torso + 7.0 * back});
    corners.push_back({hip + 6.0 * torso + 9.0 * back});
    // The free leg's outline goes the other way about: its upper side comes first.
    const Vec2 u = towards(pose.thigh), v = towards(pose.shin), knee = hip + 32.0 * u,
               toe = knee + 34.0 * v, middle = left((u + v).normalized());
    corners.push_back({knee - 6.0 * middle});
    corners.push_back({toe - 8.0 * v - 4.2 * left(v)});
    corners.push_back({toe + 2.0 * v});
    corners.push_back({toe - 8.0 * v + 4.2 * left(v)});
    corners.push_back({knee + 6.0 * middle});
    corners.push_back({hip + Vec2(-7, -9)});
    corners.insert(corners.end(),
                   {{{-6.5, 44}}, {{-5.5, 24}}, {{-8, 11}}, {{-19, 5}}, {{-22, 0}, true}});
    return flowing(corners);
}

} // namespace

/// A dancer in two poses, with 1, 6 and 18 sections between them.
void twoPoses(const std::string &folder)
{
    Maker maker;
    const Pose upright{92, 90, 48, 62, 132, 120, 238, 232},
        leaning{50, 62, 12, 18, 160, 172, 176, 182};
    constexpr double ends = 86.0, apart = 104.0;
    const char *names[] = {"Near", "Middle", "Far"};
    int row = 0;
    for (const int count : {1, 6, 18}) {
        const double z = (1 - row) * apart;
        const std::string name = names[row++];
        const SectionRef base =
            maker.add(name + " base", facingFront(z), strip(-ends - 20, ends + 20, 18, 7));
        const auto place = [&](double x) {
            return Frame{{x, 0.0, z}, -Vec3::UnitZ(), Vec3::UnitY()};
        };
        const SectionRef first = maker.addOn(base, name + " dancer", place(-ends), dancer(upright));
        const SectionRef last =
            maker.addOn(base, name + " dancer, leaning", place(ends), dancer(leaning));
        maker.apply("blend", name + " dancers", {{"sections", {first, last}}, {"along", {base}}},
                    {{"count", static_cast<double>(count)}});
    }
    for (const double x : {-ends - 10, ends + 10})
        maker.add(x < 0 ? "Left strip" : "Right strip", facingRight(x),
                  strip(-apart - 20, apart + 20, 12, 5));
    maker.write(folder, "two_poses");
}

} // namespace fff::samples
