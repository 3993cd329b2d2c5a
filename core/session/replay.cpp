#include "core/session/replay.h"

#include "core/analysis/pulling.h"
#include "core/io/loaded_document.h"
#include "core/session/replay_script.h"
#include "core/session/scheduler.h"
#include "core/session/session_commands.h"
#include "core/session/view_commands.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace fff {

namespace {

QString shown(const QString &text)
{
    return QLatin1Char('"') + QString::fromStdString(io::quoted(text.toStdString())) +
           QLatin1Char('"');
}

/// Whether the place is in a file that is one of the parameters: its name, or that and a line.
bool isInFile(const std::string &place, const CommandParameters &parameters)
{
    return std::any_of(parameters.begin(), parameters.end(), [&place](const auto &parameter) {
        const std::string name =
            QFileInfo(QString::fromStdString(parameter.second)).fileName().toStdString();
        return !name.empty() && (place == name || place.starts_with(name + ":"));
    });
}

class Player
{
public:
    Player(Session &session, Interaction &interaction, const CommandRegistry &commands)
        : m_session(session), m_interaction(interaction), m_commands(commands)
    {
    }

    /// index: for errors
    Result<void> play(const ReplayEvent &event, int index);

private:
    tl::unexpected<Error> wrong(const QString &what, const QString &expected) const
    {
        return ReplayScript::wrong(m_index, what, expected);
    }
    Result<void> setTime(const ReplayEvent &event);
    Result<void> pointer(const ReplayEvent &event, PointerEvent::Type type);
    Result<void> view(const ReplayEvent &event);
    void wait(const ReplayEvent &event);
    Result<void> key(const ReplayEvent &event);
    Result<void> runCommand(const std::string &name, const CommandParameters &parameters);

    Session &m_session;
    Interaction &m_interaction;
    const CommandRegistry &m_commands;
    int m_index = 0;
    double m_time = -kReplayStep; // ms
    Button m_pressed = Button::None;
};

Result<void> Player::play(const ReplayEvent &event, int index)
{
    m_index = index;
    if (const Result<void> timed = setTime(event); !timed)
        return timed;
    switch (event.type) {
    case ReplayEvent::Type::Press:
        return pointer(event, PointerEvent::Type::Press);
    case ReplayEvent::Type::Move:
        return pointer(event, PointerEvent::Type::Move);
    case ReplayEvent::Type::Release:
        return pointer(event, PointerEvent::Type::Release);
    case ReplayEvent::Type::Wheel:
        return pointer(event, PointerEvent::Type::Wheel);
    case ReplayEvent::Type::View:
        return view(event);
    case ReplayEvent::Type::Wait:
        wait(event);
        return {};
    case ReplayEvent::Type::Command:
        return runCommand(event.name.toStdString(), event.parameters);
    case ReplayEvent::Type::Key:
        return key(event);
    }
    return {};
}

Result<void> Player::setTime(const ReplayEvent &event)
{
    if (!event.time) {
        m_time += kReplayStep;
        return {};
    }
    if (*event.time < std::max(0.0, m_time))
        return wrong(QStringLiteral("t: %1").arg(*event.time),
                     QStringLiteral("a time not before %1 ms").arg(std::max(0.0, m_time)));
    m_time = *event.time;
    return {};
}

Result<void> Player::pointer(const ReplayEvent &event, PointerEvent::Type type)
{
    PointerEvent pointer;
    pointer.type = type;
    pointer.position = event.position;
    pointer.modifiers = event.modifiers;
    pointer.time = m_time;
    if (type == PointerEvent::Type::Press) {
        if (m_pressed != Button::None)
            return wrong(QStringLiteral("press"), QStringLiteral("a release first"));
        pointer.button = m_pressed = event.button.value_or(Button::Left);
    } else if (type == PointerEvent::Type::Release) {
        if (m_pressed == Button::None)
            return wrong(QStringLiteral("release"), QStringLiteral("a press first"));
        if (event.button.value_or(m_pressed) != m_pressed)
            return wrong(QStringLiteral("release"), QStringLiteral("the button that was pressed"));
        pointer.button = std::exchange(m_pressed, Button::None);
    } else if (type == PointerEvent::Type::Wheel) {
        pointer.wheelSteps = event.amount;
    }
    // What a stroke follows does not hang on how fast the machine is.
    if (pointer.isPress())
        m_session.scheduler().finish(kPulled.name);
    m_interaction.handle(pointer);
    return {};
}

Result<void> Player::view(const ReplayEvent &event)
{
    if (event.name == QLatin1String("fit")) {
        m_interaction.fitAll(m_interaction.targetCamera(), m_time, 0.0);
        return {};
    }
    Eigen::Quaterniond orientation;
    if (!orientationOfView(event.name.toStdString(), orientation))
        return wrong(QStringLiteral("name: ") + shown(event.name),
                     QStringLiteral("front, right, back, left, top, bottom, iso1 to iso4, or fit"));
    m_interaction.setCamera(turnedTo(orientation, m_session, m_interaction));
    return {};
}

void Player::wait(const ReplayEvent &event)
{
    // It begins with the event before it, unless it says when.
    if (!event.time)
        m_time = std::max(0.0, m_time - kReplayStep);
    m_time += event.amount;
    m_interaction.advance(m_time);
}

Result<void> Player::key(const ReplayEvent &event)
{
    if (event.name == QLatin1String("Escape")) {
        m_interaction.escape(m_time);
        return {};
    }
    if (const std::optional<ToolKey> key = toolKeyOf(event.name, event.modifiers)) {
        m_interaction.key(*key, m_time);
        return {};
    }
    const std::string command = commandOfKey(event.name, event.modifiers);
    if (command.empty())
        return wrong(QStringLiteral("key: ") + shown(event.name),
                     QStringLiteral("a key that does something"));
    return runCommand(command, {});
}

Result<void> Player::runCommand(const std::string &name, const CommandParameters &parameters)
{
    m_interaction.advance(m_time);
    const Result<void> run = m_commands.run(name, parameters, m_time);
    if (run)
        return {};
    // In a file that the event names, what is wrong stands there.
    if (isInFile(run.error().place, parameters)) {
        Error error = run.error();
        error.place = ReplayScript::placeOf(m_index) + ": " + error.place;
        return tl::unexpected(std::move(error));
    }
    const QString quotedName = QString::fromStdString(io::quoted(name));
    if (run.error().code == ErrorCode::UnknownCommand)
        return wrong(QStringLiteral("name: \"") + quotedName + QLatin1Char('"'),
                     QStringLiteral("a command"));
    return wrong(quotedName, run.error().args.empty()
                                 ? QStringLiteral("a command that can be carried out")
                                 : QString::fromStdString(run.error().args.back()));
}

} // namespace

Result<void> replay(const QByteArray &script, Session &session, Interaction &interaction)
{
    CommandRegistry commands;
    registerSessionCommands(commands, session, interaction);
    return replay(script, session, interaction, commands);
}

Result<void> replay(const QByteArray &text, Session &session, Interaction &interaction,
                    const CommandRegistry &commands,
                    const std::function<void(const ReplayEvent &)> &afterEach)
{
    const Result<ReplayScript> script = ReplayScript::read(text);
    if (!script)
        return tl::unexpected(script.error());

    QObject listener;
    QObject::connect(&session, &Session::modelChanged, &listener,
                     [&interaction] { interaction.modelChanged(); });
    interaction.modelChanged();
    interaction.setViewport(script->viewport());

    Player player(session, interaction, commands);
    for (int index = 0; index < script->count(); ++index) {
        const Result<ReplayEvent> event = script->event(index);
        if (!event)
            return tl::unexpected(event.error());
        if (const Result<void> played = player.play(*event, index); !played)
            return played;
        if (afterEach)
            afterEach(*event);
    }
    return {};
}

} // namespace fff
