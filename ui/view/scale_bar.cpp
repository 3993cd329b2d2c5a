#include "ui/view/scale_bar.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

constexpr double kInch = 25.4, kFoot = 12.0 * kInch; // mm
constexpr double kMetresFrom = 10000.0, kFeetFrom = 10.0 * kFoot;
/// A step that is just reached counts as reached (part of the length).
constexpr double kRounding = 1e-9;

struct ScaleBarTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ScaleBar)
};

/// 1, 2 or 5 times a power of ten, at most `longest`.
double roundBelow(double longest)
{
    const double power = std::pow(10.0, std::floor(std::log10(longest) + kRounding));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= longest * (1.0 + kRounding))
            return step * power;
    }
    return power;
}

QString text(double number, const QString &unit, const QLocale &locale)
{
    return QStringLiteral("%1\u202f%2").arg(locale.toString(number, 'g', 6), unit);
}

ScaleBar inInches(double longest, const QLocale &locale)
{
    const QString inch = unitSign(LengthUnit::Inch);
    if (longest >= kFeetFrom) {
        const double feet = roundBelow(longest / kFoot);
        return {feet * kFoot, text(feet, ScaleBarTexts::tr("ft"), locale)};
    }
    const double inches = longest / kInch * (1.0 + kRounding);
    if (inches >= 1.0) {
        const double round = roundBelow(inches);
        return {round * kInch, text(round, inch, locale)};
    }
    for (int parts = 2; parts <= 64; parts *= 2) {
        if (1.0 / parts <= inches)
            return {kInch / parts, QStringLiteral("1/%1\u202f%2").arg(parts).arg(inch)};
    }
    const double round = roundBelow(inches);
    return {round * kInch, text(round, inch, locale)};
}

} // namespace

ScaleBar scaleBar(double longest, LengthUnit unit, const QLocale &locale)
{
    if (!(longest > 0.0 && std::isfinite(longest)))
        longest = millimetresPer(unit);
    if (unit == LengthUnit::Inch)
        return inInches(longest, locale);
    const double round = roundBelow(longest);
    if (round >= kMetresFrom)
        return {round, text(round / 1000.0, ScaleBarTexts::tr("m"), locale)};
    return {round, text(round / millimetresPer(unit), unitSign(unit), locale)};
}

} // namespace fff::ui
