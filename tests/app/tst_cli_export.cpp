// Files that the program writes, as a person or a script asks for them.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/app/cli_run.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <cmath>
#include <memory>

using namespace fff;
using namespace fff::test;

namespace {

/// d attributes of all paths that carry the cutting colour.
QStringList cutPaths(const QString &file, QString *viewBox = nullptr, QString *width = nullptr)
{
    QFile svg(file);
    QStringList paths;
    if (!svg.open(QIODevice::ReadOnly))
        return paths;
    QXmlStreamReader xml(&svg);
    QStringList strokes; // inherited
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        if (token == QXmlStreamReader::StartElement) {
            const auto attributes = xml.attributes();
            strokes.push_back(attributes.hasAttribute(QLatin1String("stroke"))
                                  ? attributes.value(QLatin1String("stroke")).toString()
                                  : strokes.value(strokes.size() - 1));
            if (xml.name() == QLatin1String("svg") && viewBox) {
                *viewBox = attributes.value(QLatin1String("viewBox")).toString();
                *width = attributes.value(QLatin1String("width")).toString();
            }
            if (xml.name() == QLatin1String("path") && strokes.last() == QLatin1String("#ff0000"))
                paths += attributes.value(QLatin1String("d")).toString();
        } else if (token == QXmlStreamReader::EndElement) {
            strokes.pop_back();
        }
    }
    return xml.hasError() ? QStringList() : paths;
}

/// Narrower than two slits, which reach into it from both ends and beyond its middle.
Document withAStripOfSlits()
{
    Document document = withSection(newDocument(), polygonShape(rectangle(-1, 10, 1, 40)), side(0));
    for (const double way : {-1.0, 1.0}) {
        document = withSection(std::move(document), polygonShape(rectangle(-30, 5, 30, 45)),
                               front(0.1 * way));
        JointOverride wanted;
        wanted.a = document.sections.front()->ref();
        wanted.b = document.sections.back()->ref();
        wanted.opens = Vec2(0, way);
        wanted.shares = {{{0.1 * way, 25}, 0.6}};
        document = setJointOverride(std::move(document), wanted).value();
    }
    return document;
}

} // namespace

class TestCliExport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void partsAreCutAndClosed();
    void partsComeInTheirOrder();
    void exportIsTrueToSize();
    void kerfThatClosesSlitsIsRefused();
    void jointsWithoutANumberAreSaid();
    void exportKeepsTheOldFileWhenItCannotWrite();
    void nativeExportReadsBackEqual();
    void optionsOverrideTheDocument();
    void sheetsAsFiles();
    void whatCannotBeMadeIsSaid();
    void whatIsWrongIsSaid();
    void solidsAreExported();

private:
    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCliExport::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    const Model pair =
        twoSections(polygonShape(rectangle(-50, 0, 50, 50), {rectangle(-40, 10, -20, 30)}), front(),
                    polygonShape(rectangle(-50, 20, 50, 90)), side());
    QVERIFY(io::writeDocument(path("pair.fff"), pair.document));
}

void TestCliExport::partsAreCutAndClosed()
{
    const Run result = run({QStringLiteral("parts"), path("pair.fff"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonArray parts = object(result.out)[QLatin1String("parts")].toArray();
    QCOMPARE(parts.size(), 2);
    const auto areaOf = [](const QJsonArray &ring) {
        double sum = 0.0;
        for (int i = 0; i < ring.size(); ++i) {
            const QJsonArray a = ring[i].toArray(), b = ring[(i + 1) % ring.size()].toArray();
            sum += 0.5 * (a[0].toDouble() * b[1].toDouble() - a[1].toDouble() * b[0].toDouble());
        }
        return sum;
    };
    const QJsonObject first = parts[0].toObject();
    QVERIFY(std::abs(areaOf(first[QLatin1String("outer")].toArray()) - (5000.0 - 45.0)) < 1e-6);
    QVERIFY(std::abs(areaOf(first[QLatin1String("holes")].toArray().at(0).toArray()) + 400.0) <
            1e-6);
    QVERIFY(std::abs(areaOf(parts[1].toObject()[QLatin1String("outer")].toArray()) -
                     (7000.0 - 45.0)) < 1e-6);
}

// An order that leaves a part out, or moves one into place from nowhere, is no order.
void TestCliExport::partsComeInTheirOrder()
{
    const Run result = run({QStringLiteral("parts"), path("pair.fff"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonArray steps = object(result.out)[QLatin1String("assembly")].toArray();
    QCOMPARE(steps.size(), 2);
    QCOMPARE(steps[0][QLatin1String("parts")].toArray(), QJsonArray{1});
    QCOMPARE(steps[0][QLatin1String("distance")].toDouble(), 0.0);
    QCOMPARE(steps[1][QLatin1String("parts")].toArray(), QJsonArray{2});
    QVERIFY(steps[1][QLatin1String("distance")].toDouble() > 0.0);
    const QJsonObject info =
        object(run({QStringLiteral("info"), path("pair.fff"), QStringLiteral("--json")}).out);
    QCOMPARE(info[QLatin1String("assemblable")], QJsonValue(true));
    QCOMPARE(info[QLatin1String("assemblyOrder")].toArray().size(), 2);
    QVERIFY(info[QLatin1String("blocked")].toArray().isEmpty());
}

// A file that comes out at another scale is a sheet wasted.
void TestCliExport::exportIsTrueToSize()
{
    const Run result = run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"),
                            path("pair.svg"), QStringLiteral("--kerf"), QStringLiteral("0")});
    QCOMPARE(result.status, 0);
    QString viewBox, width;
    const QStringList paths = cutPaths(path("pair.svg"), &viewBox, &width);
    QVERIFY(!paths.isEmpty());
    for (const QString &d : paths)
        QVERIFY(d.trimmed().endsWith(u'Z'));
    QCOMPARE(viewBox.split(u' ').value(2) + QStringLiteral("mm"), width);
}

// Parts whose slits the kerf swallows fit nowhere; saying nothing wastes the sheet.
void TestCliExport::kerfThatClosesSlitsIsRefused()
{
    const Run result = run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"),
                            path("thin.svg"), QStringLiteral("--kerf"), QStringLiteral("3")});
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("Section 1"), result.err);
    QVERIFY(!QFile::exists(path("thin.svg")));
}

// Who looks for a joint's number that is not there thinks that the part is the wrong one.
void TestCliExport::jointsWithoutANumberAreSaid()
{
    Document document = withSection(newDocument(), polygonShape(rectangle(0, 0, 7, 3.5)), front());
    document =
        withSection(std::move(document), polygonShape(rectangle(-3.5, 0, 3.5, 3.5)), side(3.5));
    QVERIFY(io::writeDocument(path("tiny.fff"), document));
    const Run result =
        run({QStringLiteral("export"), path("tiny.fff"), QStringLiteral("-o"), path("tiny.svg")});
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("No room for the numbers of all joints: Section 1, Section 2"),
             result.err);
}

void TestCliExport::exportKeepsTheOldFileWhenItCannotWrite()
{
    const QString target = m_folder->filePath(QStringLiteral("no/such/folder.svg"));
    const Run result =
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), target});
    QCOMPARE(result.status, 4);
    QVERIFY(!QFile::exists(target));
    // Bad input must not touch an output that is there.
    QFile old(path("old.svg"));
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("old");
    old.close();
    QCOMPARE(
        run({QStringLiteral("export"), path("absent.fff"), QStringLiteral("-o"), path("old.svg")})
            .status,
        2);
    QVERIFY(old.open(QIODevice::ReadOnly));
    QCOMPARE(old.readAll(), QByteArray("old"));
}

void TestCliExport::nativeExportReadsBackEqual()
{
    QCOMPARE(
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), path("copy.fff")})
            .status,
        0);
    const auto before = io::readDocument(path("pair.fff")),
               after = io::readDocument(path("copy.fff"));
    QVERIFY(before && after);
    QVERIFY(before->document == after->document);
    const Run standard =
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), QStringLiteral("-"),
             QStringLiteral("--format"), QStringLiteral("fff")});
    QFile copy(path("copy.fff"));
    QVERIFY(copy.open(QIODevice::ReadOnly));
    QCOMPARE(standard.out, copy.readAll());
}

void TestCliExport::optionsOverrideTheDocument()
{
    const auto widthOf = [&](const QStringList &options) {
        const Run result =
            run(QStringList{QStringLiteral("info"), path("pair.fff"), QStringLiteral("--json")} +
                options);
        return object(result.out)[QLatin1String("sectionList")]
            .toArray()
            .at(0)
            .toObject()[QLatin1String("slits")]
            .toArray()
            .at(0)
            .toObject()[QLatin1String("width")]
            .toDouble();
    };
    QCOMPARE(widthOf({}), 3.0);
    QCOMPARE(widthOf({QStringLiteral("--thickness"), QStringLiteral("6")}), 6.0);
    QCOMPARE(widthOf({QStringLiteral("--clearance"), QStringLiteral("-0.1")}), 2.9);
    QCOMPARE(widthOf({QStringLiteral("--stock"), QStringLiteral("acrylic")}), 3.175);
}

void TestCliExport::sheetsAsFiles()
{
    const QStringList common{QStringLiteral("export"),   path("pair.fff"),
                             QStringLiteral("--sheet"),  QStringLiteral("112x100"),
                             QStringLiteral("--sheets"), QStringLiteral("files"),
                             QStringLiteral("-o")};
    const Run written = run(common + QStringList{path("cut.svg")});
    QCOMPARE(written.status, 0);
    QVERIFY(written.err.contains("sheets: 2"));
    QVERIFY(QFile::exists(path("cut-1.svg")) && QFile::exists(path("cut-2.svg")));
    QVERIFY(!QFile::exists(path("cut.svg")));
    QString viewBox, width;
    QCOMPARE(cutPaths(path("cut-1.svg"), &viewBox, &width).size() +
                 cutPaths(path("cut-2.svg")).size(),
             3); // two parts, one of them with a hole
    QCOMPARE(width, QStringLiteral("112mm"));

    QVERIFY(!written.err.contains("earlier"));
    // Wrong: who cuts all files that are there cuts sheets of another model.
    for (const char *name : {"cut-3.svg", "cut-12.svg", "cut-2024.svg", "cut-4.obj", "cut-x.svg"})
        QVERIFY(io::writeFile(path(name), "old"));
    const Run fewer = run(common + QStringList{path("cut.svg")});
    QCOMPARE(fewer.status, 0);
    QVERIFY2(
        fewer.err.contains("Sheets of an earlier export are still there: cut-3.svg, cut-12.svg\n"),
        fewer.err);
    QCOMPARE(*io::readFile(path("cut-3.svg")), std::string("old"));

    // A folder in the way of the second: the first keeps what it had.
    QVERIFY(QFile::remove(path("cut-2.svg")));
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("cut-2.svg")));
    QVERIFY(io::writeFile(path("cut-1.svg"), "old"));
    QCOMPARE(run(common + QStringList{path("cut.svg")}).status, 4);
    QCOMPARE(*io::readFile(path("cut-1.svg")), std::string("old"));

    QCOMPARE(run(common + QStringList{QStringLiteral("-"), QStringLiteral("--format"),
                                      QStringLiteral("svg")})
                 .status,
             1);
}

void TestCliExport::whatCannotBeMadeIsSaid()
{
    const auto exported = [&](const Document &document) {
        QFile::remove(path("out.svg"));
        if (!io::writeDocument(path("some.fff"), document))
            return Run();
        return run({QStringLiteral("export"), path("some.fff"), QStringLiteral("-o"),
                    path("out.svg"), QStringLiteral("--kerf"), QStringLiteral("0")});
    };
    const Run some = exported(withAStripOfSlits());
    QCOMPARE(some.status, 0);
    QVERIFY2(some.err.contains("Cut away completely by slits, so there is no part: Section 1\n"),
             some.err);
    QVERIFY(QFile::exists(path("out.svg")));

    const Run locked = exported(triangle());
    QCOMPARE(locked.status, 0);
    QVERIFY2(locked.err.contains("\nSections block each other. "), locked.err);
    QVERIFY(QFile::exists(path("out.svg")));

    const Run plain = run({QStringLiteral("export"), QStringLiteral(FFF_SAMPLES "/bear.fff"),
                           QStringLiteral("-o"), path("out.svg")});
    QCOMPARE(plain.status, 0);
    QCOMPARE(plain.err.count('\n'), 1);
}

// Wrong: `check` speaks of it, and who only exports cuts a sheet for nothing.
void TestCliExport::whatIsWrongIsSaid()
{
    Document necked = withSection(newDocument(),
                                  polygonShape({{-50, 0},
                                                {-5, 0},
                                                {-5, 20},
                                                {5, 20},
                                                {5, 0},
                                                {50, 0},
                                                {50, 40},
                                                {5, 40},
                                                {5, 20.3},
                                                {-5, 20.3},
                                                {-5, 40},
                                                {-50, 40}}),
                                  front());
    necked = *renameSection(std::move(necked), necked.sections.front()->id, "Neck");
    Document round = io::readDocument(path("pair.fff"))->document;
    Stock milled = *round.stocks.front();
    milled.slitEnd = SlitEnd::Dogbone;
    milled.toolDiameter = 4.0;
    round = *setStock(std::move(round), milled);
    const std::pair<Document, QByteArray> cases[] = {
        {necked, "Too little material. Neck is only 0.30"}, {round, "is narrower than the 4.00"}};
    for (const auto &[document, says] : cases) {
        QVERIFY(io::writeDocument(path("wrong.fff"), document));
        for (const QStringList &verb :
             {QStringList{QStringLiteral("export"), path("wrong.fff"), QStringLiteral("-o"),
                          path("out.svg")},
              QStringList{QStringLiteral("export"), path("wrong.fff"), QStringLiteral("-o"),
                          path("out.stl")},
              QStringList{QStringLiteral("nest"), path("wrong.fff"), QStringLiteral("--seconds"),
                          QStringLiteral("0")}}) {
            const Run told = run(verb);
            QCOMPARE(told.status, 0);
            QVERIFY2(told.err.contains(says), told.err);
        }
    }
    // What the kerf closes is refused by both.
    for (const char *verb : {"export", "nest"}) {
        QStringList arguments{QLatin1String(verb), path("pair.fff"), QStringLiteral("--kerf"),
                              QStringLiteral("3.5")};
        if (arguments.front() == QStringLiteral("export"))
            arguments += {QStringLiteral("-o"), path("closed.svg")};
        const Run told = run(arguments);
        QCOMPARE(told.status, 2);
        QVERIFY2(told.err.contains("Section 1"), told.err);
    }
    QVERIFY(!QFile::exists(path("closed.svg")));
}

void TestCliExport::solidsAreExported()
{
    QCOMPARE(
        run({QStringLiteral("export"), path("pair.fff"), QStringLiteral("-o"), path("out.obj")})
            .status,
        0);
    const QByteArray obj = QByteArray::fromStdString(*io::readFile(path("out.obj")));
    QCOMPARE(obj.count("\no "), 2);
    QVERIFY(obj.contains("\nf "));
    QVERIFY(io::writeDocument(path("empty.fff"), newDocument()));
    QCOMPARE(
        run({QStringLiteral("export"), path("empty.fff"), QStringLiteral("-o"), path("no.obj")})
            .status,
        2);
    QVERIFY(!QFile::exists(path("no.obj")));
}

FFF_TEST(TestCliExport)
#include "tst_cli_export.moc"
