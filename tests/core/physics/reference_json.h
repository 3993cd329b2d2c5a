// Small readers of what reference cases are written in. What is absent reads as nothing: zero, an
// empty list.
#pragma once

#include "core/geometry/polygon.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include <string>

namespace fff::test {

inline QString key(const char *name)
{
    return QString::fromLatin1(name);
}

inline std::string textOf(const QJsonValue &value)
{
    return value.toString().toStdString();
}

inline Vec2 pointOf(const QJsonValue &value)
{
    const QJsonArray array = value.toArray();
    return {array.at(0).toDouble(), array.at(1).toDouble()};
}

inline Vec3 vectorOf(const QJsonValue &value)
{
    const QJsonArray array = value.toArray();
    return {array.at(0).toDouble(), array.at(1).toDouble(), array.at(2).toDouble()};
}

/// Unit; `otherwise` where it is absent or has no length.
inline Vec3 directionOf(const QJsonValue &value, const Vec3 &otherwise)
{
    const Vec3 given = vectorOf(value);
    return given.norm() > 0.0 ? Vec3(given.normalized()) : otherwise;
}

inline Polygon polygonOf(const QJsonValue &value)
{
    Polygon polygon;
    for (const QJsonValue &point : value.toArray())
        polygon.push_back(pointOf(point));
    return polygon;
}

} // namespace fff::test
