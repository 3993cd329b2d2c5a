#include "ui/properties/joint_words.h"

#include "core/assembly/joint_measures.h"

#include <QCoreApplication>

#include <array>

namespace fff::ui {

namespace {

struct JointTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::JointWords)
};

} // namespace

QString jointKindText(JointKind kind)
{
    switch (kind) {
    case JointKind::CrossLap:
        return JointTexts::tr("cross lap");
    case JointKind::ExtendedCrossLap:
        return JointTexts::tr("extended cross lap");
    case JointKind::Mortise:
        return JointTexts::tr("mortise");
    case JointKind::Tabs:
        return JointTexts::tr("tabs");
    case JointKind::None:
        return JointTexts::tr("no joint");
    }
    return {};
}

QString jointKindName(JointKind kind)
{
    switch (kind) {
    case JointKind::CrossLap:
        return JointTexts::tr("Cross lap");
    case JointKind::ExtendedCrossLap:
        return JointTexts::tr("Extended cross lap");
    case JointKind::Mortise:
        return JointTexts::tr("Mortise");
    case JointKind::Tabs:
        return JointTexts::tr("Tabs");
    case JointKind::None:
        return JointTexts::tr("None");
    }
    return {};
}

QString jointObstacleText(JointObstacle obstacle)
{
    switch (obstacle) {
    case JointObstacle::None:
        return {};
    case JointObstacle::NoWidth:
        return JointTexts::tr("The clearance of their stock leaves a slit no width");
    case JointObstacle::EndsOnHole:
        return JointTexts::tr("Slits cannot open to the outside: a hole is in the way");
    case JointObstacle::OppositeWays:
        return JointTexts::tr(
            "In one place they could only slide one way, in another only the other");
    case JointObstacle::NothingHolds:
        return JointTexts::tr("Nothing would hold them: holes are where slits would begin");
    case JointObstacle::ReachesBeyond:
        return JointTexts::tr("One section reaches beyond the other, whichever way they slide");
    case JointObstacle::EndsWithin:
        return JointTexts::tr("Neither section reaches beyond the other");
    case JointObstacle::SeveralPlaces:
        return JointTexts::tr("They meet in more than one place");
    case JointObstacle::DoesNotFit:
        return JointTexts::tr("Neither section fits through a closed slit in the other");
    case JointObstacle::DoNotCross:
        return JointTexts::tr("One section only ends on the other");
    case JointObstacle::EndsNowhere:
        return JointTexts::tr("Neither section ends on the other's face");
    case JointObstacle::NoRoom:
        return JointTexts::tr("There is no room for tabs and their slits");
    case JointObstacle::TooOblique:
        return JointTexts::tr("They meet at less than 30°");
    }
    return {};
}

QString directionName(const Vec3 &direction)
{
    const std::array names{JointTexts::tr("Right"), JointTexts::tr("Left"),
                           JointTexts::tr("Up"),    JointTexts::tr("Down"),
                           JointTexts::tr("Front"), JointTexts::tr("Back")};
    const NearestAxis nearest = nearestAxis(direction);
    return names[static_cast<std::size_t>(2 * nearest.axis + (nearest.isPositive ? 0 : 1))];
}

} // namespace fff::ui
