// JSON text: layout, numbers and characters. If this fails, files do not read back as written.
#include "core/io/json_writer.h"
#include "tests/test_program.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtTest/QtTest>
#include <bit>
#include <charconv>
#include <cmath>
#include <random>

using namespace fff;
using fff::io::JsonWriter;

class TestJsonWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void layoutIsReadable();
    void emptyContainersStayOnOneLine();
    void numbers_data();
    void numbers();
    void randomDoublesReadBackBitForBit();
    void texts_data();
    void texts();
    void invalidUtf8BecomesReplacementCharacter_data();
    void invalidUtf8BecomesReplacementCharacter();
    void nonFiniteIsNull();
};

namespace {

std::string written(double number)
{
    JsonWriter json;
    json.value(number);
    return json.take();
}

} // namespace

void TestJsonWriter::layoutIsReadable()
{
    JsonWriter json;
    json.beginObject();
    json.member("name", "fish");
    json.member("count", std::size_t(3));
    json.member("ok", true);
    json.key("none");
    json.null();
    json.member("at", Vec2(1, 2.5));
    json.key("points");
    json.beginArray(JsonWriter::Layout::Block, 3);
    for (int i = 0; i < 4; ++i)
        json.value(Vec2(i, -i));
    json.endArray();
    json.key("frame");
    json.beginObject(JsonWriter::Layout::Line);
    json.member("origin", Vec3(1, 2, 3));
    json.key("list");
    json.beginArray();
    json.value(1);
    json.value(2);
    json.endArray();
    json.endObject();
    json.endObject();
    QCOMPARE(json.take(), std::string("{\n"
                                      "  \"name\": \"fish\",\n"
                                      "  \"count\": 3,\n"
                                      "  \"ok\": true,\n"
                                      "  \"none\": null,\n"
                                      "  \"at\": [1, 2.5],\n"
                                      "  \"points\": [\n"
                                      "    [0, 0], [1, -1], [2, -2],\n"
                                      "    [3, -3]\n"
                                      "  ],\n"
                                      "  \"frame\": {\"origin\": [1, 2, 3], \"list\": [1, 2]}\n"
                                      "}\n"));
}

void TestJsonWriter::emptyContainersStayOnOneLine()
{
    JsonWriter json;
    json.beginArray();
    json.beginArray();
    json.endArray();
    json.beginObject();
    json.endObject();
    json.endArray();
    QCOMPARE(json.take(), std::string("[\n  [],\n  {}\n]\n"));
}

void TestJsonWriter::numbers_data()
{
    QTest::addColumn<double>("number");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("zero") << 0.0 << QByteArray("0");
    QTest::newRow("minus zero has no sign in JSON readers") << -0.0 << QByteArray("0");
    QTest::newRow("whole") << 42.0 << QByteArray("42");
    QTest::newRow("a tenth") << 0.1 << QByteArray("0.1");
    QTest::newRow("rounding shows") << 0.1 + 0.2 << QByteArray("0.30000000000000004");
    QTest::newRow("large") << 1e300 << QByteArray("1e+300");
    QTest::newRow("smallest") << 5e-324 << QByteArray("5e-324");
    QTest::newRow("negative") << -2.5e-7 << QByteArray("-2.5e-07");
}

void TestJsonWriter::numbers()
{
    QFETCH(double, number);
    QFETCH(QByteArray, text);
    QCOMPARE(QByteArray::fromStdString(written(number)).trimmed(), text);
}

void TestJsonWriter::randomDoublesReadBackBitForBit()
{
    const unsigned seed = 20240611;
    qInfo("seed %u", seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 20000; ++i) {
        const double number = std::bit_cast<double>(random());
        if (!std::isfinite(number))
            continue;
        const std::string text = "[" + written(number) + "]";
        const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(text));
        QVERIFY2(json.isArray(), text.c_str());
        QCOMPARE(std::bit_cast<std::uint64_t>(json.array().at(0).toDouble()),
                 std::bit_cast<std::uint64_t>(number));
    }
}

void TestJsonWriter::texts_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("json");
    QTest::newRow("quote and backslash") << QByteArray("a\"b\\c") << QByteArray(R"("a\"b\\c")");
    QTest::newRow("line ends and tab") << QByteArray("\r\n\t") << QByteArray(R"("\r\n\t")");
    QTest::newRow("control characters")
        << QByteArray("\x01\x1f\x7f", 3) << QByteArray(R"("\u0001\u001f\u007f")");
    QTest::newRow("zero byte") << QByteArray("a\0b", 3) << QByteArray(R"("a\u0000b")");
    QTest::newRow("UTF-8 stays") << QByteArray("Rückwand 肋骨 🐟")
                                 << QByteArray("\"Rückwand 肋骨 🐟\"");
    QTest::newRow("empty") << QByteArray() << QByteArray("\"\"");
}

void TestJsonWriter::texts()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, json);
    JsonWriter writer;
    writer.beginArray(JsonWriter::Layout::Line);
    writer.value(text.toStdString());
    writer.endArray();
    const QByteArray result = QByteArray::fromStdString(writer.take());
    QCOMPARE(result, "[" + json + "]\n");
    QCOMPARE(QJsonDocument::fromJson(result).array().at(0).toString().toUtf8(), text);
}

void TestJsonWriter::invalidUtf8BecomesReplacementCharacter_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("Latin-1") << QByteArray("R\xFC"
                                           "ck");
    QTest::newRow("cut off") << QByteArray("R\xC3");
    QTest::newRow("overlong slash") << QByteArray("\xC0\xAF");
    QTest::newRow("overlong of three") << QByteArray("\xE0\x80\x80");
    QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80");
    QTest::newRow("above U+10FFFF") << QByteArray("\xF4\x90\x80\x80");
    QTest::newRow("lone continuation") << QByteArray("a\x80z");
}

void TestJsonWriter::invalidUtf8BecomesReplacementCharacter()
{
    QFETCH(QByteArray, text);
    JsonWriter writer;
    writer.beginArray();
    writer.value(text.toStdString());
    writer.endArray();
    QJsonParseError error;
    const auto json = QJsonDocument::fromJson(QByteArray::fromStdString(writer.take()), &error);
    QCOMPARE(error.error, QJsonParseError::NoError);
    QVERIFY(json.array().at(0).toString().contains(QChar(QChar::ReplacementCharacter)));
}

void TestJsonWriter::nonFiniteIsNull()
{
#ifdef NDEBUG
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        JsonWriter json;
        json.value(bad);
        QVERIFY(json.sawNonFinite());
        QCOMPARE(json.take(), std::string("null\n"));
    }
#else
    QSKIP("asserted in this build");
#endif
}

FFF_TEST(TestJsonWriter)
#include "tst_json_writer.moc"
