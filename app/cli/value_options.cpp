#include "app/cli/value_options.h"

#include "core/operations/driven.h"
#include "core/session/message_text.h"
#include "core/values/presets.h"

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
        Understood<Document> typed = typeValue(
            std::move(next), id, setting.mid(equals + 1).trimmed().toStdString(), typedReading());
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
