#include "ui/bench/check_words.h"

#include "core/session/check_text.h"
#include "core/session/section_names.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::CheckWords)
};

CheckUnits unitsInUse()
{
    const QLocale locale;
    CheckUnits units = metricUnits();
    units.length = [locale](double mm) { return lengthText(mm, 0, 1, locale); };
    units.width = [locale](double mm) { return lengthText(mm, 2, 3, locale); };
    units.size = [locale](const Vec2 &mm) { return sizeText({mm.x(), mm.y()}, 0, locale); };
    units.mass = [locale](double kg) { return massText(kg, locale); };
    return units;
}

} // namespace

CheckWords checkWords(const Check &check, const Model &model)
{
    const QString whole = checkText(check, model, unitsInUse());
    const qsizetype end = whole.indexOf(QStringLiteral(". "));
    if (end < 0)
        return {checkTitle(check), whole};
    // Its first sentence is the verdict.
    return {whole.left(end), whole.mid(end + 2)};
}

QString actionText(const CheckAction &action, const Check &check, const Model &model)
{
    const bool isOne = check.sections.size() == 1;
    switch (action.kind) {
    case CheckAction::Kind::MoveToOther: {
        const QString name = sectionName(model, action.section);
        //: %1 is the name of a section
        return isOne ? Words::tr("Move it to %1").arg(name)
                     //: %1 is the name of a section
                     : Words::tr("Move them to %1").arg(name);
    }
    case CheckAction::Kind::JoinAgain:
        //: %1 is the name of a section
        return check.code == CheckCode::NoSlit ? Words::tr("Join them")
               : isOne ? Words::tr("Join it with %1").arg(sectionName(model, action.section))
                       //: %1 is the name of a section
                       : Words::tr("Join them with %1").arg(sectionName(model, action.section));
    case CheckAction::Kind::JoinWithTabs:
        return Words::tr("Join with tabs");
    case CheckAction::Kind::Trim:
        //: %1 is the name of a section
        return Words::tr("Trim %1").arg(sectionName(model, action.section));
    case CheckAction::Kind::DeleteSections:
        return isOne ? Words::tr("Delete it") : Words::tr("Delete them");
    case CheckAction::Kind::MakeAssemblable:
        return Words::tr("Make assemblable");
    case CheckAction::Kind::StretchToGround:
        //: %1 is the name of a section
        return check.feet.size() == 1 ? Words::tr("Stretch %1 to the ground")
                                            .arg(sectionName(model, check.feet.front().section))
                                      : Words::tr("Stretch them to the ground");
    case CheckAction::Kind::DropToGround:
        return Words::tr("Drop it to the ground");
    case CheckAction::Kind::ShowSteps:
        return Words::tr("Show the steps");
    case CheckAction::Kind::ChooseSheet:
        return Words::tr("Choose a sheet");
    case CheckAction::Kind::WidenSlits:
        return Words::tr("Set the clearance");
    case CheckAction::Kind::TryAgain:
        return Words::tr("Try again");
    case CheckAction::Kind::ShowReport:
        return Words::tr("Show the copy for a report");
    }
    return {}; // not reached: every kind is above
}

QString checkGlyph(CheckSeverity severity)
{
    switch (severity) {
    case CheckSeverity::Good:
        return QStringLiteral("check");
    case CheckSeverity::Unknown:
    case CheckSeverity::Note:
        return QStringLiteral("unknown");
    case CheckSeverity::Warning:
        return QStringLiteral("warn");
    case CheckSeverity::Error:
        return QStringLiteral("err");
    }
    return {};
}

QColor checkColour(CheckSeverity severity)
{
    switch (severity) {
    case CheckSeverity::Good:
        return theme().good;
    case CheckSeverity::Unknown:
    case CheckSeverity::Note:
        return theme().muted;
    case CheckSeverity::Warning:
        return theme().warning;
    case CheckSeverity::Error:
        return theme().problem;
    }
    return {};
}

QString severityWord(CheckSeverity severity)
{
    switch (severity) {
    case CheckSeverity::Good:
        return Words::tr("Good");
    case CheckSeverity::Unknown:
        return Words::tr("Unknown");
    case CheckSeverity::Note:
        return Words::tr("Note");
    case CheckSeverity::Warning:
        return Words::tr("Warning");
    case CheckSeverity::Error:
        return Words::tr("Problem");
    }
    return {};
}

} // namespace fff::ui
