// Real models of FlatFab, read in place. If this fails, models that people have do not open as they
// were drawn.
// First: moc cannot read <numbers> before another header of the standard library.
#include <QtTest/QtTest>

#include "core/base/tolerances.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/fff_format.h"
#include "core/io/flatfab_format.h"
#include "core/io/flatfab_text.h"
#include "tests/test_program.h"

#include <QtCore/QDir>

using namespace fff;

class TestFlatfabModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void everyModelReads_data();
    void everyModelReads();
    void nativeFormatKeepsEveryModel_data() { everyModelReads_data(); }
    void nativeFormatKeepsEveryModel();
    void cutOffModelsAreErrors();
    void largestModelLoadsQuickly();
};

namespace {

constexpr double kSamePoint = 1e-6; // mm
constexpr double kUnit = 25.4;      // mm

QDir models()
{
    return QDir(QStringLiteral(FFF_SHARED_MODELS));
}

std::string bytesOf(const QString &name)
{
    return io::readFile(models().filePath(name)).value_or(std::string());
}

bool isWarned(const io::LoadedDocument &loaded, WarningCode code, int line)
{
    return std::any_of(loaded.warnings.begin(), loaded.warnings.end(), [&](const Warning &w) {
        return w.code == code && w.place == std::to_string(line);
    });
}

/// Largest distance of the section's control points from P + uT + vB. The contour may run the other
/// way round than in the file.
double deviation(const io::FlatfabSection &source, const io::FlatfabCurve &curve,
                 const Frame &frame, const Contour &contour)
{
    const auto distance = [&](const std::vector<Vec2> &points) {
        double worst = points.size() + 1 == curve.points.size() ? 0.0 : HUGE_VAL;
        for (std::size_t i = 0; i < points.size() && worst < HUGE_VAL; ++i) {
            const Vec2 &uv = curve.points[i];
            const Vec3 world = kUnit * (source.p + uv.x() * source.t + uv.y() * source.b);
            worst = std::max(worst, (frame.toWorld(points[i]) - world).norm());
        }
        return worst;
    };
    return std::min(distance(contour.points()), distance(contour.reversed().points()));
}

} // namespace

void TestFlatfabModels::initTestCase()
{
    if (!models().exists())
        FFF_WITHOUT_SHARED();
}

void TestFlatfabModels::everyModelReads_data()
{
    QTest::addColumn<QString>("file");
    for (const QString &name : models().entryList({QStringLiteral("*.txt")}, QDir::Files))
        QTest::newRow(qPrintable(name)) << name;
}

void TestFlatfabModels::everyModelReads()
{
    QFETCH(QString, file);
    const std::string bytes = bytesOf(file);
    const auto loaded = io::readFlatfab(bytes);
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    for (const Warning &warning : loaded->warnings)
        qInfo("line %s", qPrintable(io::warningText(warning)));

    // The number in the second line, looked at without the reader.
    const QByteArray header = QByteArray::fromStdString(bytes).split('\n').at(1).trimmed();
    QCOMPARE(static_cast<int>(loaded->document.sections.size()), header.split(' ').at(1).toInt());

    io::Problems problems;
    const std::vector<io::FlatfabSection> sources = io::parseFlatfab(bytes, problems);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Section &section = *loaded->document.sections[i];
        const Frame &frame = section.frame;
        QVERIFY(std::abs(frame.x.dot(frame.y)) < 1e-15);
        std::size_t hole = 0;
        for (std::size_t c = 0; c < sources[i].curves.size(); ++c) {
            const io::FlatfabCurve &curve = sources[i].curves[c];
            const bool isLeftOut = isWarned(*loaded, WarningCode::HoleOutside, curve.line) ||
                                   isWarned(*loaded, WarningCode::DegenerateHole, curve.line);
            if (isLeftOut)
                continue;
            const Contour &contour =
                c == 0 ? section.shape->contour() : section.shape->holes().at(hole++);
            if (!isWarned(*loaded, WarningCode::SelfCrossingContour, curve.line))
                QVERIFY(deviation(sources[i], curve, frame, contour) < kSamePoint);
        }
        QCOMPARE(section.shape->holes().size(), hole);
    }
}

void TestFlatfabModels::nativeFormatKeepsEveryModel()
{
    QFETCH(QString, file);
    const Document document = io::readFlatfab(bytesOf(file)).value().document;
    const std::string bytes = io::writeFff(document).value();
    const auto again = io::readFff(bytes);
    QVERIFY2(again, qPrintable(again ? QString() : io::errorText(again.error())));
    QVERIFY(again->warnings.empty());
    QVERIFY(again->document == document);
    QCOMPARE(io::writeFff(again->document).value(), bytes);
}

/// Cut anywhere but in its last number, a model is an error and no smaller model.
void TestFlatfabModels::cutOffModelsAreErrors()
{
    const std::string bytes = bytesOf(QStringLiteral("physics_shape1.txt"));
    const std::size_t lastNumber = bytes.find_last_of(" \n", bytes.size() - 2);
    for (std::size_t length = 0; length < lastNumber; length += 7) {
        const auto loaded = io::readFlatfab(std::string_view(bytes).substr(0, length));
        QVERIFY2(!loaded, std::to_string(length).c_str());
    }
}

void TestFlatfabModels::largestModelLoadsQuickly()
{
    const std::string bytes = bytesOf(QStringLiteral("bridge.txt"));
    QBENCHMARK
    {
        QVERIFY(io::readFlatfab(bytes));
    }
}

FFF_TEST(TestFlatfabModels)
#include "tst_flatfab_models.moc"
