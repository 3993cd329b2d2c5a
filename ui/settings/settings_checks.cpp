// What the checks go by and how they show it.
#include "ui/settings/settings.h"

#include "ui/settings/stored_values.h"

#include <algorithm>

namespace fff::ui {

namespace {

const QString kShallow = QStringLiteral("checks/shallowAngle");
const QString kNotch = QStringLiteral("checks/notchFactor");
const QString kLasting = QStringLiteral("checks/loadLasting");
const QString kStressShown = QStringLiteral("checks/stressShown");
const QString kSafety = QStringLiteral("checks/safetyFactor");
const QString kColourSafe = QStringLiteral("display/colourSafeStress");
const QString kBends = QStringLiteral("checks/bendsSections");
const QString kTouching = QStringLiteral("checks/touching");
const QString kPlanning = QStringLiteral("checks/planningTime");

constexpr int kShallowDefault = 30;    // degrees
constexpr int kTouchingDefault = 300;  // µm
constexpr int kSafetyDefault = 20;     // tenths
constexpr int kPlanningDefault = 1000; // ms

} // namespace

int Settings::shallowAngle() const
{
    return numberOf(m_store.value(kShallow), kMinShallowAngle, kMaxShallowAngle, kShallowDefault);
}

void Settings::setShallowAngle(int degrees)
{
    degrees = std::clamp(degrees, kMinShallowAngle, kMaxShallowAngle);
    if (degrees == shallowAngle())
        return;
    store(kShallow, degrees);
    Q_EMIT checksChanged();
}

int Settings::touching() const
{
    return numberOf(m_store.value(kTouching), kMinTouching, kMaxTouching, kTouchingDefault);
}

void Settings::setTouching(int micrometres)
{
    micrometres = std::clamp(micrometres, kMinTouching, kMaxTouching);
    if (micrometres == touching())
        return;
    store(kTouching, micrometres);
    Q_EMIT checksChanged();
}

int Settings::safetyFactor() const
{
    return numberOf(m_store.value(kSafety), kMinSafety, kMaxSafety, kSafetyDefault);
}

void Settings::setSafetyFactor(int tenths)
{
    tenths = std::clamp(tenths, kMinSafety, kMaxSafety);
    if (tenths == safetyFactor())
        return;
    store(kSafety, tenths);
    Q_EMIT checksChanged();
}

int Settings::notchFactor() const
{
    return numberOf(m_store.value(kNotch), kMinNotch, kMaxNotch, kMaxNotch);
}

void Settings::setNotchFactor(int tenths)
{
    tenths = std::clamp(tenths, kMinNotch, kMaxNotch);
    if (tenths == notchFactor())
        return;
    store(kNotch, tenths);
    Q_EMIT checksChanged();
}

bool Settings::isLoadLasting() const
{
    return truthOf(m_store.value(kLasting), false);
}

void Settings::setLoadLasting(bool isLasting)
{
    if (isLasting == isLoadLasting())
        return;
    store(kLasting, isLasting);
    Q_EMIT checksChanged();
}

int Settings::stressShown() const
{
    constexpr int kUsual = 20; // as in the paper, section 4
    return numberOf(m_store.value(kStressShown), kMinStressShown, kMaxStressShown, kUsual);
}

void Settings::setStressShown(int percent)
{
    percent = std::clamp(percent, kMinStressShown, kMaxStressShown);
    if (percent == stressShown())
        return;
    store(kStressShown, percent);
    Q_EMIT checksChanged();
}

bool Settings::isStressColourSafe() const
{
    return truthOf(m_store.value(kColourSafe), false);
}

void Settings::setStressColourSafe(bool isSafe)
{
    if (isSafe == isStressColourSafe())
        return;
    store(kColourSafe, isSafe);
    Q_EMIT colourSchemeChanged();
}

bool Settings::bendsSections() const
{
    return truthOf(m_store.value(kBends), false);
}

void Settings::setBendsSections(bool bends)
{
    if (bends == bendsSections())
        return;
    store(kBends, bends);
    Q_EMIT checksChanged();
}

int Settings::planningTime() const
{
    return numberOf(m_store.value(kPlanning), kMinPlanningTime, kMaxPlanningTime, kPlanningDefault);
}

void Settings::setPlanningTime(int milliseconds)
{
    milliseconds = std::clamp(milliseconds, kMinPlanningTime, kMaxPlanningTime);
    if (milliseconds == planningTime())
        return;
    store(kPlanning, milliseconds);
    Q_EMIT checksChanged();
}

} // namespace fff::ui
