// A replay script as it stands: its viewport and its events one by one, each checked for itself.
// core/session/replay.h has the format, and runs it; ui/script_player.h plays it in the window.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"

#include <QByteArray>
#include <QJsonArray>
#include <QString>

#include <optional>

namespace fff {

struct ReplayEvent
{
    enum class Type { Press, Move, Release, Wheel, View, Wait, Command, Key };

    Type type = Type::Move;
    std::optional<double> time;   // ms since the script's start; none: the usual step later
    Vec2 position = Vec2::Zero(); // px of the script's viewport: Press, Move, Release, Wheel
    std::optional<Button> button; // Press, Release; none: as replay.h says
    Modifiers modifiers;          // of the same, and Key
    double amount = 0.0;          // steps of Wheel, ms of Wait
    QString name;                 // of View, Command, Key
    CommandParameters parameters; // Command
};

/// ms between two events that do not say when they are.
inline constexpr double kReplayStep = 8.0;

class ReplayScript
{
public:
    /// Errors  BadSyntax (JSON that cannot be read), BadValue (place: "viewport", "events")
    static Result<ReplayScript> read(const QByteArray &text);

    const Vec2 &viewport() const { return m_viewport; } // px
    int count() const { return static_cast<int>(m_events.size()); }
    /// Errors  BadEvent, place "events[7]", for one that makes no sense by itself
    Result<ReplayEvent> event(int index) const;
    /// How errors call an event: "events[7]".
    static std::string placeOf(int index);
    /// For what is wrong with it where it stands, such as a release without a press.
    static tl::unexpected<Error> wrong(int index, const QString &what, const QString &expected);

private:
    Vec2 m_viewport = Vec2::Zero();
    QJsonArray m_events;
};

/// What a key of a script is to a tool; none for other keys.
std::optional<ToolKey> toolKeyOf(const QString &key, const Modifiers &modifiers);
/// The command that a key of a script runs; empty for one that does nothing, and for Escape.
std::string commandOfKey(const QString &key, const Modifiers &modifiers);

} // namespace fff
