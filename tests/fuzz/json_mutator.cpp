#include "tests/fuzz/json_mutator.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <array>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t maxSize);

namespace fff::fuzz {

namespace {

using Random = std::minstd_rand;

std::size_t below(Random &random, qsizetype count)
{
    return random() % static_cast<std::size_t>(count);
}

QJsonValue otherNumber(double number, Random &random)
{
    constexpr std::array<double, 14> special = {
        0, -0.0, 1, -1, 2, 0.5, 1e-9, 1e-300, 1e6, -1e6, 1e9, 1e300, 9007199254740993.0, 1e18};
    switch (random() % 6) {
    case 0:
        return special[below(random, special.size())];
    case 1:
        return -number;
    case 2:
        return number + 1;
    case 3:
        return number - 1;
    case 4:
        return number * (0.5 + 0.001 * static_cast<double>(random() % 1001));
    default:
        return number + 1e-3 * static_cast<double>(random() % 2001) - 1;
    }
}

QJsonValue otherKind(Random &random)
{
    switch (random() % 8) {
    case 0:
        return QJsonValue::Null;
    case 1:
        return true;
    case 2:
        return QStringLiteral("text");
    case 3:
        return QString();
    case 4:
        return QJsonArray{0, 0};
    case 5:
        return QJsonObject{};
    case 6:
        return QJsonArray{};
    default:
        return otherNumber(1, random);
    }
}

QJsonValue mutated(const QJsonValue &value, Random &random);

QJsonValue mutatedArray(QJsonArray array, Random &random)
{
    if (array.isEmpty())
        return QJsonArray{otherKind(random)};
    const auto index = static_cast<qsizetype>(below(random, array.size()));
    const auto other = static_cast<qsizetype>(below(random, array.size()));
    switch (random() % 24) {
    case 0:
        array.removeAt(index);
        break;
    case 1:
        array.insert(other, array.at(index));
        break;
    case 2: {
        const QJsonValue moved = array.takeAt(index);
        array.insert(std::min(other, array.size()), moved);
        break;
    }
    case 3: {
        const QJsonArray half = array;
        for (qsizetype i = 0; i < half.size() / 2; ++i)
            array.removeFirst();
        break;
    }
    default:
        array.replace(index, mutated(array.at(index), random));
    }
    return array;
}

QJsonValue mutatedObject(QJsonObject object, Random &random)
{
    if (object.isEmpty())
        return otherKind(random);
    const QStringList keys = object.keys();
    const QString &key = keys[static_cast<qsizetype>(below(random, keys.size()))];
    const QString &other = keys[static_cast<qsizetype>(below(random, keys.size()))];
    switch (random() % 24) {
    case 0:
        object.remove(key);
        break;
    case 1:
        object.insert(key, object.value(other));
        break;
    default:
        object.insert(key, mutated(object.value(key), random));
    }
    return object;
}

/// One value somewhere below becomes another one.
QJsonValue mutated(const QJsonValue &value, Random &random)
{
    if (random() % 64 == 0)
        return otherKind(random);
    if (value.isArray())
        return mutatedArray(value.toArray(), random);
    if (value.isObject())
        return mutatedObject(value.toObject(), random);
    if (value.isDouble())
        return otherNumber(value.toDouble(), random);
    return otherKind(random);
}

} // namespace

std::size_t mutateJson(std::uint8_t *data, std::size_t size, std::size_t maxSize, unsigned int seed)
{
    Random random(seed);
    random.discard(4); // its first numbers follow the seed
    const QJsonDocument json =
        random() % 4 == 0 ? QJsonDocument()
                          : QJsonDocument::fromJson(QByteArray(reinterpret_cast<const char *>(data),
                                                               static_cast<qsizetype>(size)));
    if (json.isNull())
        return LLVMFuzzerMutate(data, size, maxSize);
    QJsonValue value = json.isArray() ? QJsonValue(json.array()) : QJsonValue(json.object());
    for (std::size_t i = 0, count = 1 + random() % 3; i < count; ++i)
        value = mutated(value, random);
    const QJsonDocument changed =
        value.isArray() ? QJsonDocument(value.toArray()) : QJsonDocument(value.toObject());
    const QByteArray text = changed.toJson(QJsonDocument::Compact);
    if (static_cast<std::size_t>(text.size()) > maxSize)
        return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data, text.constData(), static_cast<std::size_t>(text.size()));
    return static_cast<std::size_t>(text.size());
}

} // namespace fff::fuzz
