// A hand at the desk whose events are kept as a replay script (core/session/replay.h).
#pragma once

#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/core/interaction/desk.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fff::test {

/// A hand whose events are kept.
class Recorder : public Desk
{
public:
    void pressAt(const Vec2 &p)
    {
        keep("press", p);
        press(p);
    }
    void moveBy(const Vec2 &to)
    {
        keep("move", to);
        send(Type::Move, to);
    }
    void releaseAt(const Vec2 &p)
    {
        keep("release", p);
        release(p);
    }
    void command(const std::string &id, const CommandParameters &parameters = {})
    {
        QJsonObject said;
        for (const auto &[key, value] : parameters)
            said.insert(QString::fromStdString(key), QString::fromStdString(value));
        m_events += QJsonObject{{QStringLiteral("type"), QStringLiteral("command")},
                                {QStringLiteral("name"), QString::fromStdString(id)},
                                {QStringLiteral("parameters"), said}};
        run(id, parameters);
    }
    void clickAt(const Vec2 &p)
    {
        pause(1000.0);
        moveBy(p);
        pressAt(p);
        releaseAt(p);
    }
    void dragAlong(const std::vector<Vec2> &way)
    {
        pause(1000.0);
        moveBy(way.front());
        pressAt(way.front());
        for (const Vec2 &p : way) {
            const Vec2 from = cursor;
            for (int i = 1; i <= 6; ++i)
                moveBy(from + (p - from) * (i / 6.0));
        }
        releaseAt(cursor);
    }
    void pause(double ms)
    {
        m_events += QJsonObject{{QStringLiteral("type"), QStringLiteral("wait")},
                                {QStringLiteral("ms"), ms}};
        wait(ms);
    }
    /// Along a line through these points, rounded as a hand does it, in steps of a few px.
    void stroke(const std::vector<Vec2> &corners, const Vec2 &start)
    {
        Vec2 at = start;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            // From the middle of an edge to that of the next, bent by the corner.
            const Vec2 &corner = corners[i];
            const Vec2 end =
                i + 1 < corners.size() ? Vec2(0.5 * (corner + corners[i + 1])) : corner;
            const int steps =
                std::max(2, static_cast<int>(((corner - at).norm() + (end - corner).norm()) / 5));
            for (int k = 1; k <= steps; ++k) {
                const double t = static_cast<double>(k) / steps, s = 1.0 - t;
                moveBy(s * s * at + 2.0 * s * t * corner + t * t * end);
            }
            at = end;
        }
    }
    /// An event a line.
    QByteArray script() const
    {
        QByteArray text = QStringLiteral("{\"viewport\": [%1, %2], \"events\": [")
                              .arg(kViewport.x())
                              .arg(kViewport.y())
                              .toUtf8();
        QByteArray before = "\n    ";
        for (const QJsonValue &event : m_events) {
            text += before + QJsonDocument(event.toObject()).toJson(QJsonDocument::Compact);
            before = ",\n    ";
        }
        return text + "\n]}\n";
    }

private:
    void keep(const char *type, const Vec2 &p)
    {
        const auto rounded = [](double v) { return std::round(10.0 * v) / 10.0; };
        m_events += QJsonObject{{QStringLiteral("type"), QLatin1String(type)},
                                {QStringLiteral("x"), rounded(p.x())},
                                {QStringLiteral("y"), rounded(p.y())}};
    }

    QJsonArray m_events;
};

} // namespace fff::test
