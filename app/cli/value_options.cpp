#include "app/cli/value_options.h"

#include "core/io/listing.h"
#include "core/operations/driven.h"
#include "core/session/message_text.h"
#include "core/values/presets.h"

#include <QRegularExpression>

#include <optional>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QString namesOf(const Values &values)
{
    QStringList names;
    for (const ValuePointer &known : values.list)
        names += QString::fromStdString(known->value.name);
    return io::enumerated(names, tr("%1 or %2"));
}

QString notASetting(const QString &setting, const Values &values)
{
    QStringList names;
    for (const PresetPointer &preset : values.presets)
        names += QString::fromStdString(preset->name);
    if (names.isEmpty())
        return tr("found \"%1\", expected NAME=VALUE, such as width=400.").arg(setting);
    //: %2 are names of presets of values: "A5 or A4"
    return tr("found \"%1\", expected NAME=VALUE, such as width=400, or a preset: %2.")
        .arg(setting, io::enumerated(names, tr("%1 or %2")));
}

/// A window knows whether its user writes decimals or thousands with a comma; here it may be
/// either, and a part that is a thousand times as large is found out at the machine. Nothing where
/// it is clear.
std::optional<QString> unclearNumber(const QString &typed)
{
    static const QRegularExpression eitherWay(
        QStringLiteral("(?<![\\w.,])([1-9]\\d{0,2}),(\\d{3})(?![\\d.,])"));
    const QRegularExpressionMatch match = eitherWay.match(typed);
    if (!match.hasMatch() || typed.contains(u'(')) // within parentheses it may divide
        return std::nullopt;
    //: all are ways to write numbers: "1,125", "1.125" and "1125"
    return tr("\"%1\" can be %2 or %3; please write one of these.")
        .arg(match.captured(0), match.captured(1) + u'.' + match.captured(2),
             match.captured(1) + match.captured(2));
}

} // namespace

Reading typedReading()
{
    Reading reading;
    reading.massUnit = 1.0;
    return reading;
}

QStringList notFollowing(const Document &document)
{
    const Driven model = driven(document);
    QStringList sentences;
    for (const ValueId id : model.values.wrong())
        sentences += messageText(sentenceOf(*document.values.find(id), *model.values.error(id)));
    for (const DrivingError &error : model.errors)
        sentences += messageText(error.sentence);
    return sentences;
}

tl::expected<Document, QString> withValues(const Document &document, const QStringList &settings)
{
    Document next = document;
    for (const QString &setting : settings) {
        if (const Preset *preset = findPreset(next.values, setting.trimmed().toStdString())) {
            next.values = setByPreset(next.values, *preset);
            continue;
        }
        const qsizetype equals = setting.indexOf(u'=');
        if (equals < 1)
            return tl::unexpected(notASetting(setting, next.values));
        const QString name = setting.left(equals).trimmed();
        const Value *value = next.values.find(std::string_view(name.toStdString()));
        if (!value && next.values.list.empty())
            return tl::unexpected(tr("the model has no values with names."));
        if (!value)
            return tl::unexpected(
                tr("there is no value \"%1\"; expected %2.").arg(name, namesOf(next.values)));
        const ValueId id = value->id;
        const QString text = setting.mid(equals + 1).trimmed();
        if (value->kind != ValueKind::Text && value->kind != ValueKind::Choice)
            if (const std::optional<QString> unclear = unclearNumber(text))
                return tl::unexpected(*unclear);
        Understood<Document> typed =
            typeValue(std::move(next), id, text.toStdString(), typedReading());
        if (!typed)
            return tl::unexpected(messageText(typed.error().message));
        next = *std::move(typed);
    }
    // All are there first: their order says nothing.
    if (const std::optional<Message> wrong = newlyWrong(document, next))
        return tl::unexpected(messageText(*wrong));
    return driven(std::move(next)).document;
}

} // namespace fff::cli
