// A place in a JSON document that knows its path ("$.sections[3].frame"), and reads values there
// with every doubt written down. Internal to the readers of core/io.
#pragma once

#include "core/geometry/vector.h"
#include "core/io/problems.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonObject>
#include <QtCore/QJsonValue>

namespace fff::io {

/// Where a value is missing or of the wrong kind or range, BadValue goes into `problems` and a
/// harmless one comes back. `problems` must outlive the cursor.
class JsonCursor
{
public:
    JsonCursor(QJsonValue value, std::string path, Problems &problems)
        : m_value(std::move(value)), m_path(std::move(path)), m_problems(&problems)
    {
    }

    const std::string &path() const { return m_path; }
    bool exists() const { return !m_value.isUndefined(); }
    bool isNull() const { return m_value.isNull(); }
    bool isObject() const { return m_value.isObject(); }
    bool isBool() const { return m_value.isBool(); }
    bool isText() const { return m_value.isString(); }
    /// What stands here, short, for a sentence.
    std::string shown() const;

    /// Of an object; a member that is not there is a cursor that does not exist.
    JsonCursor member(const char *key) const;
    /// Of an object: all that are there, by name.
    std::vector<std::pair<std::string, JsonCursor>> members() const;
    /// Of a list.
    std::vector<JsonCursor> items() const;

    bool truth() const;

    double number() const;
    double positive() const;
    double notNegative() const;
    /// Not beyond ±kMaxCoordinate.
    double coordinate() const;
    /// A whole number in [least, most].
    std::int64_t integer(std::int64_t least, std::int64_t most) const;
    std::string text() const;
    /// [x, y] and [x, y, z], within ±kMaxCoordinate.
    Vec2 point2() const;
    Vec3 point3() const;
    /// [[x, y], ...]
    std::vector<Vec2> points() const;

    void fail(ErrorCode code, std::vector<std::string> args = {}) const;
    /// BadValue with what stands here.
    void failExpected(const char *expected) const;

private:
    bool readArray(int size, const char *expected, double *out) const;

    QJsonValue m_value;
    std::string m_path;
    Problems *m_problems;
};

} // namespace fff::io
