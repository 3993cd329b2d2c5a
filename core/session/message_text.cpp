#include "core/session/message_text.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/io/error_text.h"
#include "core/session/section_names.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace fff {

namespace {

struct MessageTexts
{
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

constexpr double kLeastAngle = 0.01; // degrees: less is said to be none
constexpr char16_t kThinSpace = u'\u202f';
// More names than this say less than a number does.
constexpr qsizetype kMaxNames = 4;

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

/// What stands in one place of a message.
struct ArgumentText
{
    const UnitWords &units;
    NameStyle style;

    QString operator()(int number) const { return QString::number(number); }
    QString operator()(const Decimal &decimal) const
    {
        return QLocale().toString(decimal.value, 'f',
                                  decimal.digits.value_or(QLocale::FloatingPointShortest));
    }
    QString operator()(const Named &named) const
    {
        return styled(QString::fromStdString(named.name));
    }
    QString operator()(const Text &text) const { return messageText(text); }
    QString operator()(const Message &message) const { return messageText(message, units, style); }
    QString operator()(const Error &error) const { return io::errorSentence(error); }
    QString operator()(const WidthAndHeight &extent) const
    {
        return units.size(Vec2(extent.width, extent.height));
    }
    QString operator()(const NamedSections &sections) const
    {
        QStringList names;
        for (const std::string &name : sections.names)
            names += QString::fromStdString(name);
        names = inRuns(names);
        if (names.size() > kMaxNames)
            return MessageTexts::tr("%n sections", nullptr,
                                    static_cast<int>(sections.names.size()));
        for (QString &name : names)
            name = styled(name);
        return listed(names);
    }
    QString operator()(const Quantity &quantity) const
    {
        switch (quantity.kind) {
        case Quantity::Kind::Length:
            return units.length(quantity.value);
        case Quantity::Kind::Width:
            return units.width(quantity.value);
        case Quantity::Kind::Mass:
            return units.mass(quantity.value);
        case Quantity::Kind::Force:
            return MessageTexts::tr("%1\u202fN").arg(QLocale().toString(quantity.value, 'g', 3));
        case Quantity::Kind::Angle:
            return angle(degrees(quantity.value));
        case Quantity::Kind::Percent:
            return QLocale().toString(std::round(100.0 * quantity.value), 'f', 0);
        }
        return {}; // not reached: every kind is above
    }

private:
    /// Whole degrees; of less than one, what is not nothing.
    static QString angle(double degrees)
    {
        const double whole = std::floor(degrees + fff::degrees(kSameDirection));
        return (whole == 0.0 && degrees >= kLeastAngle ? QLocale().toString(degrees, 'g', 1)
                                                       : QLocale().toString(whole, 'f', 0)) +
               QStringLiteral("°");
    }
    QString styled(const QString &plain) const
    {
        return style == NameStyle::Plain ? plain
                                         : QStringLiteral("<b>%1</b>").arg(plain.toHtmlEscaped());
    }
};

/// A space and a percent sign that stands for nothing else, from there on.
bool isPercentSign(const QString &sentence, qsizetype from)
{
    return sentence.mid(from, 2) == u" %" &&
           !(from + 2 < sentence.size() && sentence[from + 2].isDigit());
}

/// All places at once: what stands in one may itself have the sign of another.
QString filled(const QString &sentence, const QStringList &arguments)
{
    QString whole;
    for (qsizetype i = 0; i < sentence.size(); ++i) {
        const qsizetype place =
            sentence[i] == u'%' && i + 1 < sentence.size() ? sentence[i + 1].digitValue() : -1;
        if (place < 1 || place > arguments.size()) {
            whole += sentence[i];
            continue;
        }
        whole += arguments[place - 1];
        ++i;
        if (isPercentSign(sentence, i + 1)) { // stays with its number
            whole += QChar(kThinSpace);
            ++i;
        }
    }
    return whole;
}

} // namespace

UnitWords metricUnits()
{
    UnitWords units;
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

QString messageText(const Message &message, const UnitWords &units, NameStyle names)
{
    if (message.isEmpty())
        return {};
    const QString sentence =
        message.text.context
            ? QCoreApplication::translate(message.text.context, message.text.source, nullptr,
                                          message.count.value_or(-1))
            : QString::fromUtf8(message.text.source);
    QStringList arguments;
    for (const Argument &argument : message.arguments)
        arguments += argumentText(argument, units, names);
    return filled(sentence, arguments);
}

QString argumentText(const Argument &argument, const UnitWords &units, NameStyle names)
{
    return std::visit(ArgumentText{units, names}, static_cast<const Argument::variant &>(argument));
}

QString messageText(const Text &text)
{
    return messageText(Message{text, {}});
}

} // namespace fff
