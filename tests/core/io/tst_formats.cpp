// The table of formats. If this fails, a format that was added is missing somewhere, or one has
// changed what is said of it.
#include "tests/core/io/added_format.h"
#include "core/io/listing.h"
#include "tests/test_program.h"

#include "core/analysis/analysis.h"
#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/formats.h"
#include "core/io/svg_reader.h"
#include "core/operations/evaluate.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QtTest>

using namespace fff;
using namespace Qt::Literals::StringLiterals;
using io::Format;

class TestFormats : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatThereIs();
    void suffixesNameFormats();
    void eachSaysAllThatIsAskedOfIt();
    void anAddedFormatIsKnown();
    void anAddedFormatReadsAndWrites();
};

namespace {

QString keysOf(io::Ability ability)
{
    QStringList keys;
    for (const Format *format : io::formatsThat(ability))
        keys += QLatin1String(format->key);
    return keys.join(u' ');
}

QString put(const QTemporaryDir &folder, const char *name, const std::string &bytes)
{
    const QString path = folder.filePath(QLatin1String(name));
    return io::writeFile(path, bytes) ? path : QString();
}

} // namespace

void TestFormats::whatThereIs()
{
    QCOMPARE(keysOf(&Format::readsModels), QStringLiteral("fff flatfab"));
    QCOMPARE(keysOf(&Format::readsDrawings), QStringLiteral("svg"));
    QCOMPARE(keysOf(&Format::isWritten),
             QStringLiteral("svg dxf pdf lbrn2 gcode csv png zip obj stl 3mf fff"));
    QCOMPARE(keysOf(&Format::isExported),
             QStringLiteral("svg dxf pdf lbrn2 gcode csv png zip obj stl 3mf"));
    QCOMPARE(io::patternsRead(&Format::readsModels), QStringLiteral("*.fff *.txt"));
    QCOMPARE(io::patternsRead(&Format::readsDrawings), QStringLiteral("*.svg *.svgz"));
    QCOMPARE(QString(QLatin1String(io::nativeFormat().key)), QStringLiteral("fff"));
}

void TestFormats::suffixesNameFormats()
{
    const auto read = [](const char *path) {
        return io::formatRead(QLatin1String(path), &Format::readsDrawings);
    };
    QVERIFY(read("/a.b/Fisch.SVGZ") == read("a.svg") && read("a.svg"));
    QVERIFY(!read("a.fff") && !read("svg") && !read(""));
    const auto written = [](const char *suffix) {
        return io::formatWritten(QLatin1String(suffix));
    };
    QVERIFY(written("SVG") && written("obj") && written("fff"));
    QVERIFY2(!written("svgz") && !written("txt"), "these are read only");
    QVERIFY(!io::formatWritten(QStringLiteral("fff"), &Format::isExported));
    QCOMPARE(io::enumerated({u"a"_s, u"b"_s, u"c"_s}, u"%1 or %2"_s), QStringLiteral("a, b or c"));
    QCOMPARE(io::enumerated({u"a"_s}, u"%1 or %2"_s), QStringLiteral("a"));
}

void TestFormats::eachSaysAllThatIsAskedOfIt()
{
    for (const Format *format : io::formats()) {
        QVERIFY(*format->key && !format->suffixes.empty());
        QVERIFY2(format->recognises || !(format->readModel || format->readDrawing), format->key);
        QVERIFY2(*format->title != '\0' || !format->isWritten(), format->key);
        QVERIFY2(*format->titleOfSkin != '\0' || !format->writesSkins(), format->key);
        for (const io::FormatOption &option : format->options)
            QVERIFY2(*option.name && *option.help &&
                         (option.choices.size() > 1 || option.least < option.most),
                     format->key);
        QVERIFY2(*format->help != '\0' || !format->isWritten(), format->key);
    }
}

void TestFormats::anAddedFormatIsKnown()
{
    const Error error{ErrorCode::NotAModel, "a.png", {}};
    const QString before = io::errorText(error);
    {
        const io::AddedFormat added(test::addedFormat());
        QCOMPARE(io::errorText(error), QStringLiteral("a.png: not a model, expected a .fff file, a "
                                                      ".txt file of FlatFab or a .knots file of "
                                                      "Knots"));
        QCOMPARE(io::patternsRead(&Format::readsModels), QStringLiteral("*.fff *.txt *.knots"));
        QCOMPARE(keysOf(&Format::isExported),
                 QStringLiteral("svg dxf pdf lbrn2 gcode csv png zip obj stl 3mf knots"));
        QVERIFY2(QLatin1String(io::nativeFormat().key) == QLatin1String("fff"), "Save stays");
    }
    QCOMPARE(io::errorText(error), before);
}

void TestFormats::anAddedFormatReadsAndWrites()
{
    const io::AddedFormat added(test::addedFormat());
    const QTemporaryDir folder;
    const auto loaded = io::readDocument(put(folder, "a.fff", "knots 3"));
    QVERIFY2(loaded, loaded ? "" : qPrintable(io::errorText(loaded.error())));
    QVERIFY(loaded->format == &test::addedFormat());
    QCOMPARE(loaded->document.sections.size(), 3u);
    const auto drawing = io::readDrawing(put(folder, "a.svg", "knots 2"));
    QVERIFY(drawing);
    QCOMPARE(drawing->texts, 2);
    QVERIFY2(!io::readDrawing(put(folder, "b.svg", "nothing")), "as an SVG, which it is not");

    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(loaded->document), caches);
    io::CuttingFileOptions options;
    options.format = &test::addedFormat();
    options.values["knots-in-a-row"] = 4;
    const auto file = io::makeCuttingFile(analysis, options);
    QVERIFY(file);
    QCOMPARE(file->whole, std::string("3 parts in rows of 4\n"));
    options.isFilePerSheet = true;
    QCOMPARE(io::makeCuttingFile(analysis, options)->sheets.size(),
             static_cast<std::size_t>(file->sheetCount()));
}

FFF_TEST(TestFormats)
#include "tst_formats.moc"
