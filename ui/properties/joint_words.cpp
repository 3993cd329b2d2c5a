#include "ui/properties/joint_words.h"

#include "core/assembly/joint_measures.h"

#include <QCoreApplication>

#include <array>

namespace fff::ui {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::JointWords)
};

} // namespace

QString jointKindText(JointKind kind)
{
    switch (kind) {
    case JointKind::CrossLap:
        return Texts::tr("cross lap");
    case JointKind::ExtendedCrossLap:
        return Texts::tr("extended cross lap");
    case JointKind::Mortise:
        return Texts::tr("mortise");
    case JointKind::Tabs:
        return Texts::tr("tabs");
    case JointKind::None:
        return Texts::tr("no joint");
    }
    return {};
}

QString jointKindName(JointKind kind)
{
    switch (kind) {
    case JointKind::CrossLap:
        return Texts::tr("Cross lap");
    case JointKind::ExtendedCrossLap:
        return Texts::tr("Extended cross lap");
    case JointKind::Mortise:
        return Texts::tr("Mortise");
    case JointKind::Tabs:
        return Texts::tr("Tabs");
    case JointKind::None:
        return Texts::tr("None");
    }
    return {};
}

QString jointObstacleText(JointObstacle obstacle)
{
    switch (obstacle) {
    case JointObstacle::None:
        return {};
    case JointObstacle::NoWidth:
        return Texts::tr("The clearance of their stock leaves a slit no width");
    case JointObstacle::EndsOnHole:
        return Texts::tr("Slits cannot open to the outside: a hole is in the way");
    case JointObstacle::OppositeWays:
        return Texts::tr("Here they could only slide one way, there only the other");
    case JointObstacle::NothingHolds:
        return Texts::tr("Nothing would hold them: holes are where slits would begin");
    case JointObstacle::ReachesBeyond:
        return Texts::tr("One section reaches beyond the other, whichever way they slide");
    case JointObstacle::EndsWithin:
        return Texts::tr("Neither section reaches beyond the other");
    case JointObstacle::SeveralPlaces:
        return Texts::tr("They meet in more than one place");
    case JointObstacle::DoesNotFit:
        return Texts::tr("Neither section fits through a slot in the other");
    case JointObstacle::DoNotCross:
        return Texts::tr("One section only ends on the other");
    case JointObstacle::EndsNowhere:
        return Texts::tr("Neither section ends on the other's face");
    case JointObstacle::NoRoom:
        return Texts::tr("There is no room for tabs and their slots");
    case JointObstacle::TooOblique:
        return Texts::tr("They meet at less than 30°");
    }
    return {};
}

QString directionName(const Vec3 &direction)
{
    const std::array names{Texts::tr("Right"), Texts::tr("Left"),  Texts::tr("Up"),
                           Texts::tr("Down"),  Texts::tr("Front"), Texts::tr("Back")};
    const NearestAxis nearest = nearestAxis(direction);
    return names[static_cast<std::size_t>(2 * nearest.axis + (nearest.isPositive ? 0 : 1))];
}

} // namespace fff::ui
