#include "core/session/replay_script.h"

#include "core/io/json_syntax.h"
#include "core/io/loaded_document.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

/// Largest viewport that a script may ask for, px.
constexpr double kLargestViewport = 32768.0;

/// What a key does, besides Escape. Ids and keys: ui/UI.md, section 5.
struct KeyBinding
{
    const char *key;
    bool control, shift;
    const char *command;
};
constexpr std::array<KeyBinding, 41> kKeys{{{"Delete", false, false, "edit.delete"},
                                            {"+", false, false, "point.insert"},
                                            {"-", false, false, "point.delete"},
                                            {"1", true, false, "point.smooth"},
                                            {"2", true, false, "point.corner"},
                                            {"3", true, false, "point.symmetric"},
                                            {"Left", false, false, "nudge.left"},
                                            {"Right", false, false, "nudge.right"},
                                            {"Up", false, false, "nudge.up"},
                                            {"Down", false, false, "nudge.down"},
                                            {"Z", true, false, "edit.undo"},
                                            {"Z", true, true, "edit.redo"},
                                            {"Y", true, false, "edit.redo"},
                                            {"A", true, false, "edit.selectAll"},
                                            {"N", true, false, "file.new"},
                                            {"N", false, false, "view.faceSelection"},
                                            {"F", false, false, "view.fitSelection"},
                                            {"Home", false, false, "view.fitAll"},
                                            {"0", false, false, "view.iso"},
                                            {"1", false, false, "view.front"},
                                            {"2", false, false, "view.top"},
                                            {"3", false, false, "view.right"},
                                            {"4", false, false, "view.back"},
                                            {"5", false, false, "view.bottom"},
                                            {"6", false, false, "view.left"},
                                            {"V", false, false, "view.perspective"},
                                            {"X", false, false, "view.xray"},
                                            {"I", false, false, "view.isolate"},
                                            {"H", false, false, "view.hide"},
                                            {"H", false, true, "view.showAll"},
                                            {"C", false, false, "view.clip"},
                                            {"P", false, false, "section.pen"},
                                            {"Q", false, false, "section.snap"},
                                            {"T", false, false, "section.transform"},
                                            {"C", true, false, "edit.copy"},
                                            {"X", true, false, "edit.cut"},
                                            {"V", true, false, "edit.paste"},
                                            {"D", true, false, "edit.duplicate"},
                                            {"A", true, true, "edit.selectConnected"},
                                            {"B", false, false, "section.takeOffer"},
                                            {"Enter", false, true, "section.takeGuide"}}};

/// What stands in the script, short and on one line.
QString found(const QJsonValue &value)
{
    switch (value.type()) {
    case QJsonValue::Null:
        return QStringLiteral("null");
    case QJsonValue::Bool:
        return value.toBool() ? QStringLiteral("true") : QStringLiteral("false");
    case QJsonValue::Double:
        return QString::number(value.toDouble());
    case QJsonValue::String:
        return QLatin1Char('"') +
               QString::fromStdString(io::quoted(value.toString().toStdString())) +
               QLatin1Char('"');
    case QJsonValue::Array:
        return QStringLiteral("an array");
    case QJsonValue::Object:
        return QStringLiteral("an object");
    case QJsonValue::Undefined:
        break;
    }
    return QStringLiteral("nothing");
}

/// Reads the fields of one event; the first that is wrong is remembered.
class EventReader
{
public:
    EventReader(QJsonObject object, int index) : m_object(std::move(object)), m_index(index) {}

    Result<ReplayEvent> read();

private:
    bool has(const char *key) const { return m_object.contains(QLatin1String(key)); }
    void wrong(const QString &what, const QString &expected);
    void wrongField(const char *key, const QString &expected);
    double number(const char *key);
    QString text(const char *key);
    Modifiers modifiers();
    std::optional<Button> button();
    CommandParameters parameters();
    QString lines(const QJsonArray &list);
    void readPointer(ReplayEvent &event);

    QJsonObject m_object;
    int m_index;
    std::optional<Error> m_error;
};

void EventReader::wrong(const QString &what, const QString &expected)
{
    if (!m_error)
        m_error = ReplayScript::wrong(m_index, what, expected).value();
}

void EventReader::wrongField(const char *key, const QString &expected)
{
    const QString name = QLatin1String(key);
    wrong(name + QStringLiteral(": ") + found(m_object.value(name)), expected);
}

double EventReader::number(const char *key)
{
    const QJsonValue value = m_object.value(QLatin1String(key));
    if (!value.isDouble() || !std::isfinite(value.toDouble()))
        wrongField(key, QStringLiteral("a number"));
    return value.toDouble();
}

QString EventReader::text(const char *key)
{
    const QJsonValue value = m_object.value(QLatin1String(key));
    if (!value.isString())
        wrongField(key, QStringLiteral("a text"));
    return value.toString();
}

Modifiers EventReader::modifiers()
{
    Modifiers modifiers;
    if (!has("modifiers"))
        return modifiers;
    const QString expected = QStringLiteral("an array of shift, control, space");
    const QJsonValue value = m_object.value(QLatin1String("modifiers"));
    if (!value.isArray())
        wrongField("modifiers", expected);
    for (const QJsonValue &entry : value.toArray()) {
        const QString name = entry.toString();
        if (name == QLatin1String("shift"))
            modifiers.shift = true;
        else if (name == QLatin1String("control"))
            modifiers.control = true;
        else if (name == QLatin1String("space"))
            modifiers.space = true;
        else
            wrong(QStringLiteral("modifiers: ") + found(entry), expected);
    }
    return modifiers;
}

std::optional<Button> EventReader::button()
{
    if (!has("button"))
        return std::nullopt;
    const QString name = text("button");
    if (name == QLatin1String("left"))
        return Button::Left;
    if (name == QLatin1String("middle"))
        return Button::Middle;
    if (name == QLatin1String("right"))
        return Button::Right;
    wrongField("button", QStringLiteral("left, middle or right"));
    return std::nullopt;
}

/// A list of texts has one on a line.
QString EventReader::lines(const QJsonArray &list)
{
    QStringList texts;
    for (const QJsonValue &item : list) {
        if (!item.isString())
            wrong(QStringLiteral("parameters: ") + found(item), QStringLiteral("a text"));
        texts += item.toString();
    }
    return texts.join(u'\n');
}

CommandParameters EventReader::parameters()
{
    CommandParameters result;
    if (!has("parameters"))
        return result;
    const QJsonValue value = m_object.value(QLatin1String("parameters"));
    if (!value.isObject())
        wrongField("parameters", QStringLiteral("an object"));
    const QJsonObject object = value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        const QString name = QString::fromStdString(io::quoted(it.key().toStdString()));
        if (it->isString() || it->isBool() || it->isDouble())
            result[it.key().toStdString()] = it->toVariant().toString().toStdString();
        else if (it->isArray())
            result[it.key().toStdString()] = lines(it->toArray()).toStdString();
        else
            wrong(QStringLiteral("parameters.") + name + QStringLiteral(": ") + found(*it),
                  QStringLiteral("a text, a number, a boolean or a list of texts"));
    }
    return result;
}

void EventReader::readPointer(ReplayEvent &event)
{
    event.position.x() = number("x");
    event.position.y() = number("y");
    event.modifiers = modifiers();
    event.button = button();
}

Result<ReplayEvent> EventReader::read()
{
    using Type = ReplayEvent::Type;
    struct Kind
    {
        const char *name;
        Type type;
    };
    constexpr std::array<Kind, 8> kinds{{{"press", Type::Press},
                                         {"move", Type::Move},
                                         {"release", Type::Release},
                                         {"wheel", Type::Wheel},
                                         {"view", Type::View},
                                         {"wait", Type::Wait},
                                         {"command", Type::Command},
                                         {"key", Type::Key}}};
    ReplayEvent event;
    const QString type = text("type");
    if (has("t"))
        event.time = number("t");
    const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                   [&](const Kind &k) { return type == QLatin1String(k.name); });
    if (kind == kinds.end()) {
        wrongField("type",
                   QStringLiteral("view, press, move, release, wheel, wait, command or key"));
        return tl::unexpected(*m_error);
    }
    event.type = kind->type;
    switch (event.type) {
    case Type::Press:
    case Type::Move:
    case Type::Release:
        readPointer(event);
        break;
    case Type::Wheel:
        readPointer(event);
        event.amount = number("steps");
        break;
    case Type::View:
        event.name = text("name");
        break;
    case Type::Wait:
        event.amount = number("ms");
        if (event.amount < 0.0)
            wrongField("ms", QStringLiteral("a number not below 0"));
        break;
    case Type::Command:
        event.name = text("name");
        event.parameters = parameters();
        break;
    case Type::Key:
        event.name = text("key");
        event.modifiers = modifiers();
        break;
    }
    if (m_error)
        return tl::unexpected(*m_error);
    return event;
}

Result<Vec2> readViewport(const QJsonObject &script)
{
    const QJsonArray size = script.value(QLatin1String("viewport")).toArray();
    const auto isSize = [](const QJsonValue &v) {
        return v.isDouble() && v.toDouble() >= 1.0 && v.toDouble() <= kLargestViewport;
    };
    if (size.size() != 2 || !isSize(size[0]) || !isSize(size[1]))
        return failure(ErrorCode::BadValue, "viewport",
                       {found(script.value(QLatin1String("viewport"))).toStdString(),
                        "[width, height] in pixels"});
    return Vec2(size[0].toDouble(), size[1].toDouble());
}

Result<QJsonObject> readScript(const QByteArray &script)
{
    const QByteArray text = script.mid(script.startsWith("\xEF\xBB\xBF") ? 3 : 0);
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError) {
        const auto line = text.left(error.offset).count('\n') + 1;
        return failure(ErrorCode::BadSyntax, std::to_string(line),
                       {error.errorString().toStdString(), "JSON"});
    }
    io::Problems problems;
    if (!io::checkCharacters({text.constData(), static_cast<std::size_t>(text.size())}, problems))
        return tl::unexpected(*problems.error);
    if (!document.isObject())
        return failure(ErrorCode::BadSyntax, "1", {"an array", "an object"});
    return document.object();
}

} // namespace

Result<ReplayScript> ReplayScript::read(const QByteArray &text)
{
    const Result<QJsonObject> object = readScript(text);
    if (!object)
        return tl::unexpected(object.error());
    const Result<Vec2> viewport = readViewport(*object);
    if (!viewport)
        return tl::unexpected(viewport.error());
    const QJsonValue events = object->value(QLatin1String("events"));
    if (!events.isArray())
        return failure(ErrorCode::BadValue, "events",
                       {found(events).toStdString(), "an array of events"});
    ReplayScript script;
    script.m_viewport = *viewport;
    script.m_events = events.toArray();
    return script;
}

std::string ReplayScript::placeOf(int index)
{
    return "events[" + std::to_string(index) + "]";
}

tl::unexpected<Error> ReplayScript::wrong(int index, const QString &what, const QString &expected)
{
    return failure(ErrorCode::BadEvent, placeOf(index),
                   {what.toStdString(), expected.toStdString()});
}

Result<ReplayEvent> ReplayScript::event(int index) const
{
    const QJsonValue value = m_events.at(index);
    if (!value.isObject())
        return wrong(index, found(value), QStringLiteral("an object"));
    return EventReader(value.toObject(), index).read();
}

std::optional<ToolKey> toolKeyOf(const QString &key, const Modifiers &modifiers)
{
    if (modifiers.control || modifiers.shift)
        return {};
    if (key == QLatin1String("Enter"))
        return ToolKey::Enter;
    if (key == QLatin1String("Backspace"))
        return ToolKey::Backspace;
    return {};
}

std::string commandOfKey(const QString &key, const Modifiers &modifiers)
{
    for (const KeyBinding &binding : kKeys) {
        if (key == QLatin1String(binding.key) && modifiers.control == binding.control &&
            modifiers.shift == binding.shift)
            return binding.command;
    }
    return {};
}

} // namespace fff
