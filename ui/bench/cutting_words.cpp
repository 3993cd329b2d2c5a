#include "ui/bench/cutting_words.h"

#include "ui/base/lengths.h"
#include "ui/settings/settings.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct CuttingTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::Exporting)
};

constexpr double kMillimetresPerMetre = 1000.0, kMillimetresPerFoot = 304.8;

} // namespace

QString cutLengthText(double millimetres, const QLocale &locale)
{
    const bool isInches = settings().unit() == LengthUnit::Inch;
    const double length = millimetres / (isInches ? kMillimetresPerFoot : kMillimetresPerMetre);
    return QStringLiteral("%1 %2").arg(numberText(length, 1, 1, locale),
                                       isInches ? QStringLiteral("ft") : QStringLiteral("m"));
}

std::vector<CuttingRemark> cuttingRemarks(const Cutting &cutting)
{
    std::vector<CuttingRemark> remarks;
    const auto add = [&remarks](const std::vector<std::string> &sections, const QString &sentence) {
        for (const std::string &section : sections)
            remarks.push_back({sentence.arg(QString::fromStdString(section)), section});
    };
    add(cutting.withoutPart,
        CuttingTexts::tr("The slits of %1 leave nothing of it. It is not cut."));
    for (const MissingSheets &missing : cutting.missing)
        //: %1 is the name of a stock
        remarks.push_back(
            {CuttingTexts::tr("It takes %n more sheet(s) of %1 than there are.", nullptr,
                              missing.count)
                 .arg(QCoreApplication::translate("fff::ui::Stock", missing.stock.c_str())),
             {}});
    add(cutting.oversized,
        CuttingTexts::tr("%1 is larger than the sheet. It lies on a sheet of its own size."));
    add(cutting.unmarked, CuttingTexts::tr("%1 is too slim to carry its number."));
    add(cutting.uncut, CuttingTexts::tr("%1 has a hole or a notch that is narrower than the kerf "
                                        "and is not cut."));
    add(cutting.unmarkedJoints,
        CuttingTexts::tr("%1 has no room for the numbers of all its joints."));
    return remarks;
}

QString partCountText(int count)
{
    return CuttingTexts::tr("%n part(s)", nullptr, count);
}

QString sheetCountText(int count)
{
    return CuttingTexts::tr("%n sheet(s)", nullptr, count);
}

QString sectionCountText(int count)
{
    return CuttingTexts::tr("%n section(s)", nullptr, count);
}

} // namespace fff::ui
