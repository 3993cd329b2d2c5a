#include "core/io/json_cursor.h"

#include "core/base/tolerances.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QJsonDocument>
#include <cmath>

namespace fff::io {

namespace {

/// What stands in the file, short. Empty when nothing does.
std::string found(const QJsonValue &value)
{
    switch (value.type()) {
    case QJsonValue::Null:
        return "null";
    case QJsonValue::Bool:
        return value.toBool() ? "true" : "false";
    case QJsonValue::Double:
        return quoted(
            QString::number(value.toDouble(), 'g', QLocale::FloatingPointShortest).toStdString());
    case QJsonValue::String:
        return quoted(value.toString().toStdString());
    case QJsonValue::Array: {
        const QJsonArray array = value.toArray();
        // A long list would be written out only to be cut off.
        return array.size() > 8
                   ? std::string("[…]")
                   : quoted(QJsonDocument(array).toJson(QJsonDocument::Compact).toStdString());
    }
    case QJsonValue::Object:
        return "{…}";
    case QJsonValue::Undefined:
        break;
    }
    return {};
}

std::string indexed(const std::string &path, qsizetype index)
{
    return path + "[" + std::to_string(index) + "]";
}

} // namespace

JsonCursor JsonCursor::member(const char *key) const
{
    if (!m_value.isObject())
        failExpected(QT_TRANSLATE_NOOP("Error", "an object"));
    return {m_value.toObject().value(QLatin1String(key)), m_path + "." + key, *m_problems};
}

std::string JsonCursor::shown() const
{
    return found(m_value);
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const
{
    std::vector<std::pair<std::string, JsonCursor>> result;
    if (!m_value.isObject())
        failExpected(QT_TRANSLATE_NOOP("Error", "an object"));
    const QJsonObject object = m_value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        std::string name = it.key().toStdString();
        JsonCursor value(it.value(), m_path + "." + name, *m_problems);
        result.emplace_back(std::move(name), std::move(value));
    }
    return result;
}

bool JsonCursor::truth() const
{
    if (!m_value.isBool())
        failExpected(QT_TRANSLATE_NOOP("Error", "true or false"));
    return m_value.toBool();
}

std::vector<JsonCursor> JsonCursor::items() const
{
    std::vector<JsonCursor> result;
    if (!m_value.isArray()) {
        failExpected(QT_TRANSLATE_NOOP("Error", "a list"));
        return result;
    }
    const QJsonArray array = m_value.toArray();
    result.reserve(static_cast<std::size_t>(array.size()));
    for (qsizetype i = 0; i < array.size(); ++i)
        result.emplace_back(array.at(i), indexed(m_path, i), *m_problems);
    return result;
}

double JsonCursor::number() const
{
    if (!m_value.isDouble())
        failExpected(QT_TRANSLATE_NOOP("Error", "a number"));
    return m_value.toDouble();
}

double JsonCursor::positive() const
{
    if (!(m_value.toDouble() > 0.0 && m_value.toDouble() <= kMaxCoordinate))
        failExpected(QT_TRANSLATE_NOOP("Error", "a number above 0, at most 1000000"));
    return m_value.toDouble();
}

double JsonCursor::notNegative() const
{
    if (!(m_value.toDouble(-1.0) >= 0.0 && m_value.toDouble() <= kMaxCoordinate))
        failExpected(QT_TRANSLATE_NOOP("Error", "a number from 0 to 1000000"));
    return m_value.toDouble();
}

double JsonCursor::coordinate() const
{
    const double value = number();
    if (std::abs(value) > kMaxCoordinate)
        failExpected(QT_TRANSLATE_NOOP("Error", "a length of at most 1000000 mm"));
    return value;
}

std::int64_t JsonCursor::integer(std::int64_t least, std::int64_t most) const
{
    const double value = m_value.toDouble(0.5);
    if (value != std::floor(value) || value < static_cast<double>(least) ||
        value > static_cast<double>(most)) {
        failExpected(QT_TRANSLATE_NOOP("Error", "a whole number in its range"));
        return least;
    }
    return m_value.toInteger();
}

std::string JsonCursor::text() const
{
    if (!m_value.isString())
        failExpected(QT_TRANSLATE_NOOP("Error", "a text"));
    return m_value.toString().toStdString();
}

bool JsonCursor::readArray(int size, const char *expected, double *out) const
{
    const QJsonArray array = m_value.toArray();
    if (!m_value.isArray() || array.size() != size) {
        failExpected(expected);
        return false;
    }
    for (int i = 0; i < size; ++i) {
        const QJsonValue value = array.at(i);
        // The path is made only when it is needed: there are many points in a file.
        if (!value.isDouble() || std::abs(value.toDouble()) > kMaxCoordinate) {
            JsonCursor(value, indexed(m_path, i), *m_problems).coordinate();
            return false;
        }
        out[i] = value.toDouble();
    }
    return true;
}

Vec2 JsonCursor::point2() const
{
    Vec2 point = Vec2::Zero();
    if (!readArray(2, QT_TRANSLATE_NOOP("Error", "a point [x, y]"), point.data()))
        return Vec2::Zero();
    return point;
}

Vec3 JsonCursor::point3() const
{
    Vec3 point = Vec3::Zero();
    if (!readArray(3, QT_TRANSLATE_NOOP("Error", "a point [x, y, z]"), point.data()))
        return Vec3::Zero();
    return point;
}

std::vector<Vec2> JsonCursor::points() const
{
    std::vector<Vec2> result;
    if (!m_value.isArray()) {
        failExpected(QT_TRANSLATE_NOOP("Error", "a list of points"));
        return result;
    }
    const QJsonArray array = m_value.toArray();
    result.reserve(static_cast<std::size_t>(array.size()));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QJsonValue value = array.at(i);
        const QJsonArray pair = value.toArray();
        const double x = pair.at(0).toDouble(2.0 * kMaxCoordinate);
        const double y = pair.at(1).toDouble(2.0 * kMaxCoordinate);
        if (pair.size() != 2 || std::abs(x) > kMaxCoordinate || std::abs(y) > kMaxCoordinate) {
            JsonCursor(value, indexed(m_path, i), *m_problems).point2();
            return {};
        }
        result.emplace_back(x, y);
    }
    return result;
}

void JsonCursor::fail(ErrorCode code, std::vector<std::string> args) const
{
    m_problems->fail(code, m_path, std::move(args));
}

void JsonCursor::failExpected(const char *expected) const
{
    fail(ErrorCode::BadValue, {found(m_value), expected});
}

} // namespace fff::io
