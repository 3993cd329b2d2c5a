#include "core/session/replay.h"

#include "core/session/session_commands.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace fff {

namespace {

/// ms between two events that do not say when they are.
constexpr double kDefaultStep = 8.0;
/// Largest viewport that a script may ask for, px.
constexpr double kLargestViewport = 32768.0;

/// What a key does, besides Escape. Ids and keys: ui/UI.md, section 5.
struct KeyBinding
{
    const char *key;
    bool control, shift;
    const char *command;
};
constexpr std::array<KeyBinding, 22> kKeys{{{"Delete", false, false, "edit.delete"},
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
                                            {"C", false, false, "view.clip"}}};

QString typeName(const QJsonValue &value)
{
    switch (value.type()) {
    case QJsonValue::Null:
        return QStringLiteral("null");
    case QJsonValue::Bool:
        return value.toBool() ? QStringLiteral("true") : QStringLiteral("false");
    case QJsonValue::Double:
        return QString::number(value.toDouble());
    case QJsonValue::String:
        return QLatin1Char('"') + value.toString() + QLatin1Char('"');
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
    EventReader(QJsonObject object, std::string place)
        : m_object(std::move(object)), m_place(std::move(place))
    {
    }

    tl::unexpected<Error> wrong(const QString &what, const QString &expected) const
    {
        return failure(ErrorCode::BadEvent, m_place, {what.toStdString(), expected.toStdString()});
    }
    tl::unexpected<Error> wrongField(const char *key, const QString &expected) const
    {
        const QString name = QLatin1String(key);
        return wrong(name + QStringLiteral(": ") + typeName(m_object.value(name)), expected);
    }
    bool has(const char *key) const { return m_object.contains(QLatin1String(key)); }

    Result<double> number(const char *key) const
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        if (!value.isDouble() || !std::isfinite(value.toDouble()))
            return wrongField(key, QStringLiteral("a number"));
        return value.toDouble();
    }
    Result<QString> text(const char *key) const
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        if (!value.isString())
            return wrongField(key, QStringLiteral("a text"));
        return value.toString();
    }
    Result<Vec2> position() const
    {
        const Result<double> x = number("x"), y = number("y");
        if (!x)
            return tl::unexpected(x.error());
        if (!y)
            return tl::unexpected(y.error());
        return Vec2(*x, *y);
    }
    Result<Modifiers> modifiers() const;
    Result<std::optional<Button>> button() const;
    Result<CommandParameters> parameters() const;

private:
    QJsonObject m_object;
    std::string m_place;
};

Result<Modifiers> EventReader::modifiers() const
{
    Modifiers modifiers;
    if (!has("modifiers"))
        return modifiers;
    const QString expected = QStringLiteral("an array of shift, control, space");
    const QJsonValue value = m_object.value(QLatin1String("modifiers"));
    if (!value.isArray())
        return wrongField("modifiers", expected);
    for (const QJsonValue &entry : value.toArray()) {
        const QString name = entry.toString();
        if (name == QLatin1String("shift"))
            modifiers.shift = true;
        else if (name == QLatin1String("control"))
            modifiers.control = true;
        else if (name == QLatin1String("space"))
            modifiers.space = true;
        else
            return wrong(QStringLiteral("modifiers: ") + typeName(entry), expected);
    }
    return modifiers;
}

Result<std::optional<Button>> EventReader::button() const
{
    if (!has("button"))
        return std::optional<Button>();
    const Result<QString> name = text("button");
    if (!name)
        return tl::unexpected(name.error());
    if (*name == QLatin1String("left"))
        return Button::Left;
    if (*name == QLatin1String("middle"))
        return Button::Middle;
    if (*name == QLatin1String("right"))
        return Button::Right;
    return wrongField("button", QStringLiteral("left, middle or right"));
}

Result<CommandParameters> EventReader::parameters() const
{
    CommandParameters result;
    if (!has("parameters"))
        return result;
    const QJsonValue value = m_object.value(QLatin1String("parameters"));
    if (!value.isObject())
        return wrongField("parameters", QStringLiteral("an object"));
    const QJsonObject object = value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        QString text;
        if (it->isString())
            text = it->toString();
        else if (it->isBool() || it->isDouble())
            text = it->toVariant().toString();
        else
            return wrong(QStringLiteral("parameters.") + it.key() + QStringLiteral(": ") +
                             typeName(*it),
                         QStringLiteral("a text, a number or a boolean"));
        result[it.key().toStdString()] = text.toStdString();
    }
    return result;
}

class Player
{
public:
    Player(Session &session, Interaction &interaction, const CommandRegistry &commands)
        : m_session(session), m_interaction(interaction), m_commands(commands)
    {
    }

    Result<void> play(const EventReader &event);

private:
    Result<void> setTime(const EventReader &event);
    Result<void> pointer(const EventReader &event, PointerEvent::Type type);
    Result<void> view(const EventReader &event);
    Result<void> wait(const EventReader &event);
    Result<void> command(const EventReader &event);
    Result<void> key(const EventReader &event);
    Result<void> runCommand(const EventReader &event, const std::string &name,
                            const CommandParameters &parameters);

    Session &m_session;
    Interaction &m_interaction;
    const CommandRegistry &m_commands;
    double m_time = -kDefaultStep; // ms
    Button m_pressed = Button::None;
};

Result<void> Player::play(const EventReader &event)
{
    const Result<QString> type = event.text("type");
    if (!type)
        return tl::unexpected(type.error());
    if (const Result<void> timed = setTime(event); !timed)
        return timed;
    if (*type == QLatin1String("press"))
        return pointer(event, PointerEvent::Type::Press);
    if (*type == QLatin1String("move"))
        return pointer(event, PointerEvent::Type::Move);
    if (*type == QLatin1String("release"))
        return pointer(event, PointerEvent::Type::Release);
    if (*type == QLatin1String("wheel"))
        return pointer(event, PointerEvent::Type::Wheel);
    if (*type == QLatin1String("view"))
        return view(event);
    if (*type == QLatin1String("wait"))
        return wait(event);
    if (*type == QLatin1String("command"))
        return command(event);
    if (*type == QLatin1String("key"))
        return key(event);
    return event.wrongField(
        "type", QStringLiteral("view, press, move, release, wheel, wait, command or key"));
}

Result<void> Player::setTime(const EventReader &event)
{
    if (!event.has("t")) {
        m_time += kDefaultStep;
        return {};
    }
    const Result<double> time = event.number("t");
    if (!time)
        return tl::unexpected(time.error());
    if (*time < std::max(0.0, m_time))
        return event.wrongField(
            "t", QStringLiteral("a time not before %1 ms").arg(std::max(0.0, m_time)));
    m_time = *time;
    return {};
}

Result<void> Player::pointer(const EventReader &event, PointerEvent::Type type)
{
    const Result<Vec2> position = event.position();
    if (!position)
        return tl::unexpected(position.error());
    const Result<Modifiers> modifiers = event.modifiers();
    if (!modifiers)
        return tl::unexpected(modifiers.error());
    const Result<std::optional<Button>> button = event.button();
    if (!button)
        return tl::unexpected(button.error());

    PointerEvent pointer;
    pointer.type = type;
    pointer.position = *position;
    pointer.modifiers = *modifiers;
    pointer.time = m_time;
    if (type == PointerEvent::Type::Press) {
        if (m_pressed != Button::None)
            return event.wrong(QStringLiteral("press"), QStringLiteral("a release first"));
        pointer.button = m_pressed = button->value_or(Button::Left);
    } else if (type == PointerEvent::Type::Release) {
        if (m_pressed == Button::None)
            return event.wrong(QStringLiteral("release"), QStringLiteral("a press first"));
        if (button->value_or(m_pressed) != m_pressed)
            return event.wrongField("button", QStringLiteral("the button that was pressed"));
        pointer.button = std::exchange(m_pressed, Button::None);
    } else if (type == PointerEvent::Type::Wheel) {
        const Result<double> steps = event.number("steps");
        if (!steps)
            return tl::unexpected(steps.error());
        pointer.wheelSteps = *steps;
    }
    m_interaction.handle(pointer);
    return {};
}

Result<void> Player::view(const EventReader &event)
{
    const Result<QString> name = event.text("name");
    if (!name)
        return tl::unexpected(name.error());
    if (*name == QLatin1String("fit")) {
        m_interaction.setCamera(fitted(m_interaction.targetCamera(), m_session.committed().bounds(),
                                       m_interaction.viewport()));
        return {};
    }
    Eigen::Quaterniond orientation;
    if (!orientationOfView(name->toStdString(), orientation))
        return event.wrongField(
            "name", QStringLiteral("front, right, back, left, top, bottom, iso1 to iso4, or fit"));
    m_interaction.setCamera(turnedTo(orientation, m_session, m_interaction));
    return {};
}

Result<void> Player::wait(const EventReader &event)
{
    const Result<double> duration = event.number("ms");
    if (!duration)
        return tl::unexpected(duration.error());
    if (*duration < 0.0)
        return event.wrongField("ms", QStringLiteral("a number not below 0"));
    // It begins with the event before it, unless it says when.
    if (!event.has("t"))
        m_time = std::max(0.0, m_time - kDefaultStep);
    m_time += *duration;
    m_interaction.advance(m_time);
    return {};
}

Result<void> Player::command(const EventReader &event)
{
    const Result<QString> name = event.text("name");
    if (!name)
        return tl::unexpected(name.error());
    const Result<CommandParameters> parameters = event.parameters();
    if (!parameters)
        return tl::unexpected(parameters.error());
    return runCommand(event, name->toStdString(), *parameters);
}

Result<void> Player::key(const EventReader &event)
{
    const Result<QString> name = event.text("key");
    if (!name)
        return tl::unexpected(name.error());
    const Result<Modifiers> modifiers = event.modifiers();
    if (!modifiers)
        return tl::unexpected(modifiers.error());
    if (*name == QLatin1String("Escape")) {
        m_interaction.escape(m_time);
        return {};
    }
    for (const KeyBinding &binding : kKeys) {
        if (*name == QLatin1String(binding.key) && modifiers->control == binding.control &&
            modifiers->shift == binding.shift)
            return runCommand(event, binding.command, {});
    }
    return event.wrongField("key", QStringLiteral("a key that does something"));
}

Result<void> Player::runCommand(const EventReader &event, const std::string &name,
                                const CommandParameters &parameters)
{
    m_interaction.advance(m_time);
    const Result<void> run = m_commands.run(name, parameters, m_time);
    if (run)
        return {};
    if (run.error().code == ErrorCode::UnknownCommand)
        return event.wrongField("name", QStringLiteral("a command"));
    return event.wrong(QString::fromStdString(name),
                       run.error().args.empty()
                           ? QStringLiteral("a command that can be carried out")
                           : QString::fromStdString(run.error().args.back()));
}

Result<Vec2> readViewport(const QJsonObject &script)
{
    const QJsonArray size = script.value(QLatin1String("viewport")).toArray();
    const auto isSize = [](const QJsonValue &v) {
        return v.isDouble() && v.toDouble() >= 1.0 && v.toDouble() <= kLargestViewport;
    };
    if (size.size() != 2 || !isSize(size[0]) || !isSize(size[1]))
        return failure(ErrorCode::BadValue, "viewport",
                       {typeName(script.value(QLatin1String("viewport"))).toStdString(),
                        "[width, height] in pixels"});
    return Vec2(size[0].toDouble(), size[1].toDouble());
}

Result<QJsonObject> readScript(const QByteArray &script)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(script, &error);
    if (error.error != QJsonParseError::NoError) {
        const auto line = script.left(error.offset).count('\n') + 1;
        return failure(ErrorCode::BadSyntax, std::to_string(line),
                       {error.errorString().toStdString(), "JSON"});
    }
    if (!document.isObject())
        return failure(ErrorCode::BadSyntax, "1", {"an array", "an object"});
    return document.object();
}

} // namespace

Result<void> replay(const QByteArray &script, Session &session, Interaction &interaction)
{
    CommandRegistry commands;
    registerSessionCommands(commands, session, interaction);
    return replay(script, session, interaction, commands);
}

Result<void> replay(const QByteArray &script, Session &session, Interaction &interaction,
                    const CommandRegistry &commands)
{
    const Result<QJsonObject> object = readScript(script);
    if (!object)
        return tl::unexpected(object.error());
    const Result<Vec2> viewport = readViewport(*object);
    if (!viewport)
        return tl::unexpected(viewport.error());
    const QJsonValue events = object->value(QLatin1String("events"));
    if (!events.isArray())
        return failure(ErrorCode::BadValue, "events",
                       {typeName(events).toStdString(), "an array of events"});

    QObject listener;
    QObject::connect(&session, &Session::modelChanged, &listener,
                     [&interaction] { interaction.modelChanged(); });
    interaction.modelChanged();
    interaction.setViewport(*viewport);

    Player player(session, interaction, commands);
    int index = 0;
    for (const QJsonValue &event : events.toArray()) {
        const std::string place = "events[" + std::to_string(index++) + "]";
        if (!event.isObject())
            return failure(ErrorCode::BadEvent, place,
                           {typeName(event).toStdString(), "an object"});
        if (const Result<void> played = player.play({event.toObject(), place}); !played)
            return played;
    }
    return {};
}

} // namespace fff
