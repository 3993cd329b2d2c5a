#include "core/session/check_text.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/io/error_text.h"
#include "core/session/section_names.h"
#include "core/session/stage_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

constexpr char16_t kThinSpace = u'\u202f';
// More names than this say less than a number does.
constexpr std::size_t kMaxNames = 4;

QString withUnit(const QString &number, const QString &unit)
{
    return number + QChar(kThinSpace) + unit;
}

/// One decimal, none where it says nothing.
QString decimal(double value)
{
    const double rounded = std::round(10.0 * value) / 10.0;
    return QLocale().toString(rounded, 'f', rounded == std::round(rounded) ? 0 : 1);
}

QString wholeDegrees(double angle)
{
    // Rounded down: what is promised must hold.
    return QLocale().toString(std::floor(degrees(angle + kSameDirection)), 'f', 0) +
           QStringLiteral("°");
}

QString namesOf(const Model &model, const std::vector<SectionRef> &refs)
{
    if (refs.size() > kMaxNames)
        return Words::tr("%n sections", nullptr, static_cast<int>(refs.size()));
    QStringList names;
    for (const SectionRef &ref : refs)
        names += sectionName(model, ref);
    return listed(names);
}

/// The one or two sections of a check, by their place in it.
QString nameAt(const Check &check, const Model &model, std::size_t index)
{
    return index < check.sections.size() ? sectionName(model, check.sections[index]) : QString();
}

QString connectedText(const Check &check)
{
    if (check.sectionCount == 1)
        return Words::tr("Connected. There is only one section.");
    return Words::tr("Connected. All %1 sections, by %2.")
        .arg(check.sectionCount)
        .arg(check.count == 1 ? Words::tr("1 joint")
                              : Words::tr("%n joints", nullptr, check.count));
}

QString notConnectedText(const Check &check, const Model &model, const CheckUnits &units)
{
    const bool isOne = check.sections.size() == 1;
    const QString names = namesOf(model, check.sections);
    if (!check.other || check.distance < 0.0)
        return isOne ? Words::tr("%1 is not joined to the rest.").arg(names)
                     : Words::tr("%1 are not joined to the rest.").arg(names);
    const QString other = sectionName(model, *check.other);
    // Below what anyone can see they touch.
    constexpr double kTouching = 0.05; // mm
    if (check.distance <= kTouching)
        return isOne ? Words::tr("%1 meets %2, but no joint holds them together.").arg(names, other)
                     : Words::tr("%1 meet %2, but no joint holds them together.").arg(names, other);
    const QString far = units.length(check.distance);
    return isOne ? Words::tr("%1 touches nothing. It is %2 away from %3.").arg(names, far, other)
                 : Words::tr("%1 touch nothing else. They are %2 away from %3.")
                       .arg(names, far, other);
}

QString topplesText(const Check &check, const CheckUnits &units)
{
    const QString far = units.length(-check.margin);
    switch (check.side) {
    case Towards::Front:
        return Words::tr("Falls over forwards. The centre of mass lies %1 in front of the feet.")
            .arg(far);
    case Towards::Back:
        return Words::tr("Falls over backwards. The centre of mass lies %1 behind the feet.")
            .arg(far);
    case Towards::Left:
        return Words::tr("Falls over to the left. The centre of mass lies %1 beside the feet.")
            .arg(far);
    case Towards::Right:
        return Words::tr("Falls over to the right. The centre of mass lies %1 beside the feet.")
            .arg(far);
    }
    return {}; // not reached: every side is above
}

/// What else could be a foot: a sentence after others, or nothing.
QString feetText(const Check &check, const Model &model, const CheckUnits &units)
{
    if (check.feet.empty())
        return {};
    std::vector<SectionRef> sections;
    double highest = 0.0;
    for (const HighFoot &foot : check.feet) {
        sections.push_back(foot.section);
        highest = std::max(highest, foot.height);
    }
    const QString names = namesOf(model, sections), high = units.length(highest);
    return u' ' +
           (sections.size() == 1
                ? Words::tr("The lowest point of %1 is %2 above the ground.").arg(names, high)
                : Words::tr("The lowest points of %1 are up to %2 above the ground.")
                      .arg(names, high));
}

/// Which sections a sentence about standing is about, where it is not the whole model.
QString ofThese(const Check &check, const Model &model, const QString &sentence)
{
    if (check.sections.empty())
        return sentence;
    //: %1 names sections, %2 is a sentence about them such as "Falls over forwards."
    return Words::tr("%1: %2").arg(namesOf(model, check.sections), sentence);
}

QString belowGroundText(const Check &check, const Model &model, const CheckUnits &units)
{
    const QString names = namesOf(model, check.sections), deep = units.length(check.distance);
    return check.sections.size() == 1
               ? Words::tr("Not on the ground. %1 reaches %2 below it.").arg(names, deep)
               : Words::tr("Not on the ground. %1 reach up to %2 below it.").arg(names, deep);
}

QString stabilityText(const Check &check, const Model &model, const CheckUnits &units)
{
    switch (check.code) {
    case CheckCode::Stands:
        return ofThese(check, model,
                       Words::tr("Stands. Tips only past %1. Margin %2.")
                           .arg(wholeDegrees(check.tipAngle), units.length(check.margin)));
    case CheckCode::Unsteady:
        return ofThese(
            check, model,
            Words::tr("Stands, but not firmly: it tips past %1. The centre of mass is only %2 "
                      "inside the feet.")
                .arg(wholeDegrees(check.tipAngle), units.length(check.margin)));
    case CheckCode::Topples:
        return ofThese(check, model, topplesText(check, units) + feetText(check, model, units));
    case CheckCode::LineSupport:
        return ofThese(check, model,
                       Words::tr("Falls over. Its feet are all on one line, so nothing holds it "
                                 "upright.") +
                           feetText(check, model, units));
    case CheckCode::NoContact:
        return ofThese(check, model,
                       Words::tr("Not on the ground. Its lowest point is %1 above it.")
                           .arg(units.length(check.distance)));
    default:
        return belowGroundText(check, model, units);
    }
}

QString sizeText(const Check &check, const Model &model, const CheckUnits &units)
{
    if (check.code == CheckCode::TooLarge) {
        const QString name = nameAt(check, model, 0);
        const QString sheet = units.size(check.sheet), margin = units.length(check.margin);
        if (check.count > 1)
            return Words::tr("%1 parts of %2 fit no sheet of %3 with a margin of %4, however they "
                             "are turned.")
                .arg(QString::number(check.count), name, sheet, margin);
        return Words::tr("%1 measures %2 and fits no sheet of %3 with a margin of %4, however it "
                         "is turned.")
            .arg(name, units.size(check.size), sheet, margin);
    }
    const QString used = QLocale().toString(std::round(100.0 * check.share), 'f', 0);
    const QString sheets =
        check.count == 1 ? Words::tr("1 sheet") : Words::tr("%n sheets", nullptr, check.count);
    if (check.sheet.isZero())
        return Words::tr("Fits the sheet. %1, %2 % used.").arg(sheets, used);
    return Words::tr("Fits the sheet. %1 of %2, %3 % used.")
        .arg(sheets, units.size(check.sheet), used);
}

/// Why there is no slit and what to do about it.
QString whyText(NoSlit why)
{
    switch (why) {
    case NoSlit::Wanted:
        return Words::tr("Their joint is set to have none.");
    case NoSlit::NoWidth:
        return Words::tr("No slit lets them slide together: the negative clearance leaves it no "
                         "width. Make the clearance larger.");
    case NoSlit::OppositeWays:
        return Words::tr("No slits let them slide together: where they meet here they could only "
                         "slide one way, there only the other way. Shorten one of them.");
    case NoSlit::NothingHolds:
        return Words::tr(
            "Nothing would hold them: holes are where slits would begin. Make the holes "
            "smaller, or let one of them end inside the other.");
    case NoSlit::Enclosed:
        return Words::tr("No slit lets them slide together: neither of them reaches the edge. Open "
                         "a hole to the outside, or let one of them pass through.");
    }
    return {}; // not reached: every reason is above
}

QString jointText(const Check &check, const Model &model, const CheckUnits &units)
{
    const QString first = nameAt(check, model, 0), second = nameAt(check, model, 1);
    switch (check.code) {
    case CheckCode::NoSlit:
        return Words::tr("%1 and %2 cut into each other, %3 long. %4")
            .arg(first, second, units.length(check.distance), whyText(check.noSlit));
    case CheckCode::Interference: {
        constexpr double kSmall = 0.1; // mm
        const QString deep = check.distance < kSmall
                                 ? Words::tr("less than %1").arg(units.length(kSmall))
                                 : units.length(check.distance);
        return check.count == 0
                   ? Words::tr("%1 and %2 cut into each other, %3, but are not joined.")
                         .arg(first, second, deep)
                   : Words::tr("%1 and %2 cut into each other, %3, outside of their slits.")
                         .arg(first, second, deep);
    }
    case CheckCode::ShallowAngle:
        if (check.angle < kMinJointAngle)
            return Words::tr("%1 meets %2 at %3; below %4 no slit can hold it.")
                .arg(first, second, wholeDegrees(check.angle), wholeDegrees(kMinJointAngle));
        return Words::tr("%1 meets %2 at %3; slits get wide below %4.")
            .arg(first, second, wholeDegrees(check.angle), wholeDegrees(check.leastAngle));
    case CheckCode::Cycle:
        if (check.count == 1)
            return Words::tr("%1 form a ring of joints that slide in different directions.")
                .arg(namesOf(model, check.sections));
        return Words::tr("%n rings of sections have joints that slide in different directions.",
                         nullptr, check.count);
    case CheckCode::SlitsMeet:
        return Words::tr("%1: its slits for %2 run into each other.")
            .arg(first, namesOf(model, check.guests));
    case CheckCode::ThinWeb: {
        const QString stays = units.length(check.distance), guests = namesOf(model, check.guests);
        if (check.guests.size() > 1)
            return Words::tr("%1: only %2 stay between its slits for %3.")
                .arg(first, stays, guests);
        return check.count > 0 ? Words::tr("%1: only %2 stay between its slit for %3 and a hole.")
                                     .arg(first, stays, guests)
                               : Words::tr("%1: only %2 stay between its slit for %3 and its edge.")
                                     .arg(first, stays, guests);
    }
    case CheckCode::NarrowSlit:
        if (check.severity == CheckSeverity::Error)
            return Words::tr("Slit %1 is closed by the kerf of %2. Give the stock's slits more "
                             "clearance, or less kerf.")
                .arg(units.width(check.distance), units.width(check.tool));
        return Words::tr("Slit %1 is narrower than the %2 tool. Give the stock's slits more "
                         "clearance, or choose a thinner tool.")
            .arg(units.width(check.distance), units.width(check.tool));
    case CheckCode::Divided:
        return Words::tr("The slits of %1 divide it into %2.")
            .arg(first, Words::tr("%n parts", nullptr, check.count));
    case CheckCode::NotCutOut:
        return Words::tr("%1 could not be cut out: what its slits leave of it could not be worked "
                         "out. Nothing can be exported; its mass counts without slits.")
            .arg(first);
    case CheckCode::NotMade:
        //: %1 is the name of an operation
        return Words::tr("%1 could not be worked out: sections of it are missing. Nothing can be "
                         "exported.")
            .arg(QString::fromStdString(check.failure->args.front()));
    default:
        return Words::tr("The slits of %1 leave nothing of it.").arg(first);
    }
}

QString assemblyText(const Check &check, const Model &model, const CheckUnits &units)
{
    switch (check.code) {
    case CheckCode::CanAssemble:
        return check.count == 1 ? Words::tr("Can be assembled. There is only one part.")
                                : Words::tr("Can be assembled. %n steps.", nullptr, check.count);
    case CheckCode::CannotAssemble:
        break;
    default:
        if (check.failure)
            //: %1 is a sentence such as "the solid of "Rib" could not be worked out"
            return Words::tr("Order not found: %1.").arg(io::errorSentence(*check.failure));
        return Words::tr("Order not found. The search took too long; that says nothing about the "
                         "model.");
    }
    const QString names = namesOf(model, check.sections);
    if (check.directions > 1)
        return Words::tr("Sections block each other. %1 meet in %2 that slide in %3 different "
                         "directions.")
            .arg(names, Words::tr("%n joints", nullptr, check.count),
                 QString::number(check.directions));
    if (check.distance > 0.0)
        return Words::tr("Sections block each other. %1 comes only %2 out of its slit in %3, then "
                         "it runs into it.")
            .arg(nameAt(check, model, 0), units.length(check.distance), nameAt(check, model, 1));
    return Words::tr("Sections block each other. Of %1 none comes off the others on a straight "
                     "way.")
        .arg(names);
}

} // namespace

QString checkName(CheckCode code)
{
    switch (code) {
    case CheckCode::Connected:
        return QStringLiteral("connected");
    case CheckCode::NotConnected:
        return QStringLiteral("notConnected");
    case CheckCode::Stands:
        return QStringLiteral("stands");
    case CheckCode::Unsteady:
        return QStringLiteral("unsteady");
    case CheckCode::Topples:
        return QStringLiteral("topples");
    case CheckCode::LineSupport:
        return QStringLiteral("lineSupport");
    case CheckCode::NoContact:
        return QStringLiteral("noContact");
    case CheckCode::BelowGround:
        return QStringLiteral("belowGround");
    case CheckCode::FitsSheet:
        return QStringLiteral("fitsSheet");
    case CheckCode::TooLarge:
        return QStringLiteral("tooLarge");
    case CheckCode::Mass:
        return QStringLiteral("mass");
    case CheckCode::CanAssemble:
        return QStringLiteral("canAssemble");
    case CheckCode::CannotAssemble:
        return QStringLiteral("cannotAssemble");
    case CheckCode::OrderUnknown:
        return QStringLiteral("orderUnknown");
    case CheckCode::NoSlit:
    case CheckCode::Interference:
        return QStringLiteral("interference");
    case CheckCode::ShallowAngle:
        return QStringLiteral("shallowAngle");
    case CheckCode::Cycle:
        return QStringLiteral("cycle");
    case CheckCode::SlitsMeet:
        return QStringLiteral("slitsMeet");
    case CheckCode::ThinWeb:
        return QStringLiteral("thinWeb");
    case CheckCode::NarrowSlit:
        return QStringLiteral("narrowSlit");
    case CheckCode::Divided:
        return QStringLiteral("divided");
    case CheckCode::NothingLeft:
        return QStringLiteral("nothingLeft");
    case CheckCode::NotCutOut:
        return QStringLiteral("notCutOut");
    case CheckCode::NotMade:
        return QStringLiteral("notMade");
    case CheckCode::NotWorkedOut:
        return QStringLiteral("notWorkedOut");
    }
    return {}; // not reached: every code is above
}

QString severityName(CheckSeverity severity)
{
    switch (severity) {
    case CheckSeverity::Good:
        return QStringLiteral("good");
    case CheckSeverity::Unknown:
        return QStringLiteral("unknown");
    case CheckSeverity::Note:
        return QStringLiteral("note");
    case CheckSeverity::Warning:
        return QStringLiteral("warning");
    case CheckSeverity::Error:
        return QStringLiteral("error");
    }
    return {}; // not reached: every severity is above
}

CheckUnits metricUnits()
{
    CheckUnits units;
    units.length = [](double mm) { return withUnit(decimal(mm), QStringLiteral("mm")); };
    units.width = [](double mm) {
        return withUnit(QLocale().toString(mm, 'f', 2), QStringLiteral("mm"));
    };
    units.size = [](const Vec2 &mm) {
        return withUnit(QStringLiteral("%1 × %2").arg(decimal(mm.x()), decimal(mm.y())),
                        QStringLiteral("mm"));
    };
    units.mass = [](double kg) {
        constexpr double kGrams = 1000.0;
        return kg < 1.0 ? withUnit(decimal(kGrams * kg), QStringLiteral("g"))
                        : withUnit(QLocale().toString(kg, 'f', 2), QStringLiteral("kg"));
    };
    return units;
}

QString checkTitle(const Check &check)
{
    switch (check.code) {
    case CheckCode::Connected:
        return Words::tr("Connected");
    case CheckCode::NotConnected:
        return Words::tr("Not connected");
    case CheckCode::Stands:
        return Words::tr("Stands");
    case CheckCode::Unsteady:
        return Words::tr("Tips easily");
    case CheckCode::Topples:
    case CheckCode::LineSupport:
        return Words::tr("Falls over");
    case CheckCode::NoContact:
    case CheckCode::BelowGround:
        return Words::tr("Not on the ground");
    case CheckCode::FitsSheet:
        return Words::tr("Fits the sheet");
    case CheckCode::TooLarge:
        return Words::tr("Too large for the sheet");
    case CheckCode::Mass:
        return Words::tr("Mass");
    case CheckCode::CanAssemble:
        return Words::tr("Can be assembled");
    case CheckCode::CannotAssemble:
        return Words::tr("Cannot be assembled");
    case CheckCode::OrderUnknown:
        return Words::tr("Order not found");
    case CheckCode::NoSlit:
    case CheckCode::Interference:
        return Words::tr("Cut into each other");
    case CheckCode::ShallowAngle:
        return Words::tr("Shallow angle");
    case CheckCode::Cycle:
        return Words::tr("Rings of joints");
    case CheckCode::SlitsMeet:
        return Words::tr("Slits run into each other");
    case CheckCode::ThinWeb:
        return Words::tr("Thin web");
    case CheckCode::NarrowSlit:
        return Words::tr("Slit narrower than the tool");
    case CheckCode::Divided:
        return Words::tr("Divided by slits");
    case CheckCode::NothingLeft:
        return Words::tr("Nothing left");
    case CheckCode::NotCutOut:
        return Words::tr("Not cut out");
    case CheckCode::NotMade:
        return Words::tr("Operation failed");
    case CheckCode::NotWorkedOut:
        return Words::tr("Not worked out");
    }
    return {}; // not reached: every code is above
}

QString checkText(const Check &check, const Model &model, const CheckUnits &units)
{
    if (check.code == CheckCode::NotWorkedOut)
        return stageFailure(check.stage, *check.failure);
    switch (subjectOf(check.code)) {
    case CheckSubject::Connection:
        return check.code == CheckCode::Connected ? connectedText(check)
                                                  : notConnectedText(check, model, units);
    case CheckSubject::Stability:
        return stabilityText(check, model, units);
    case CheckSubject::Size:
        return sizeText(check, model, units);
    case CheckSubject::Mass:
        return Words::tr("Mass %1. The centre of mass lies %2 above the ground.")
            .arg(units.mass(check.mass.mass), units.length(check.mass.centre.y()));
    case CheckSubject::Assembly:
        return assemblyText(check, model, units);
    case CheckSubject::Joints:
        return jointText(check, model, units);
    }
    return {}; // not reached: every subject is above
}

} // namespace fff
