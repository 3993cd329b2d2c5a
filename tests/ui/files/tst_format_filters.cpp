// What dialogs and sentences say of formats. If this fails, a format that was added cannot be
// chosen, or what people read has changed.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/io/added_format.h"
#include "tests/test_program.h"
#include "ui/files/failures.h"
#include "ui/files/file_drop.h"
#include "ui/files/format_filters.h"
#include "ui/files/given_files.h"

#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTranslator>
#include <QUrl>
#include <QWidget>

#include <map>

using namespace fff;
using namespace Qt::Literals::StringLiterals;

namespace {

QString exported()
{
    QStringList filters;
    for (const ui::ExportKind &kind : ui::exportKinds())
        filters += kind.filter;
    return filters.join(u'|');
}

QString notAModel()
{
    return ui::openFailure(QStringLiteral("/a/b.png"), {ErrorCode::NotAModel, "b.png", {}});
}

} // namespace

class TestFormatFilters : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void inEnglish();
    void inGerman();
    void anAddedFormat();
    void eachKindHasItsUse();
    void whatIsDropped();
    void whatHasNoNameIsNotNamed();
};

// Wrong: " could not be opened: it is not in  any more", of a file that nobody named.
void TestFormatFilters::whatHasNoNameIsNotNamed()
{
    const Error error{ErrorCode::CannotOpen, {}, {}};
    for (const char *path : {"", " "})
        QCOMPARE(ui::openFailure(QString::fromLatin1(path), error),
                 QStringLiteral("Nothing was opened: no file was named."));
    const QString folder = QDir::tempPath() + u'/'; // its last name is empty
    const QString said = ui::openFailure(folder, error);
    QVERIFY2(said.startsWith(QDir::toNativeSeparators(folder)), qPrintable(said));
    QCOMPARE(ui::openFailure(QStringLiteral("/nowhere/fish.txt"), error),
             QStringLiteral("fish.txt could not be opened: it is not in /nowhere any more. Nothing "
                            "was changed."));
}

void TestFormatFilters::inEnglish()
{
    QCOMPARE(ui::modelFilter(), QStringLiteral("Models (*.fff *.txt);;All files (*)"));
    QCOMPARE(ui::drawingFilter(), QStringLiteral("Drawings (*.svg *.svgz);;All files (*)"));
    QCOMPARE(ui::saveFilter(), QStringLiteral("FlatFitFab models (*.fff)"));
    const QStringList expected{u"SVG, true to size (*.svg)"_s,
                               u"SVG, one for each sheet (*.svg)"_s,
                               u"DXF, true to size (*.dxf)"_s,
                               u"DXF, one for each sheet (*.dxf)"_s,
                               u"DXF for old programs, R12 (*.dxf)"_s,
                               u"PDF, a page for each sheet (*.pdf)"_s,
                               u"PDF, tiled on A4 (*.pdf)"_s,
                               u"PDF, tiled on Letter (*.pdf)"_s,
                               u"LightBurn project (*.lbrn2)"_s,
                               u"LightBurn, one for each sheet (*.lbrn2)"_s,
                               u"G-code for GRBL lasers (*.gcode)"_s,
                               u"G-code, one for each sheet (*.gcode)"_s,
                               u"Parts list for spreadsheets (*.csv)"_s,
                               u"Picture of the sheets (*.png)"_s,
                               u"Pictures, one for each sheet (*.png)"_s,
                               u"All for the workshop, packed (*.zip)"_s,
                               u"All for the workshop, in a folder"_s,
                               u"OBJ, solids in place (*.obj)"_s,
                               u"STL, solids in place (*.stl)"_s,
                               u"STL, solids lying flat (*.stl)"_s,
                               u"3MF, solids in place (*.3mf)"_s,
                               u"3MF, solids lying flat (*.3mf)"_s,
                               u"OBJ, skin as a mesh (*.obj)"_s,
                               u"STL, skin as a mesh (*.stl)"_s};
    QCOMPARE(exported(), expected.join(u'|'));
    QCOMPARE(notAModel(),
             QStringLiteral("b.png is not a model. FlatFitFab opens .fff and FlatFab’s .txt."));
}

void TestFormatFilters::inGerman()
{
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/i18n/flatfitfab_de")));
    QCoreApplication::installTranslator(&translator);
    const QString models = ui::modelFilter(), drawings = ui::drawingFilter(),
                  saved = ui::saveFilter(), said = notAModel();
    const QString kinds = exported();
    QCoreApplication::removeTranslator(&translator);
    QCOMPARE(models, QStringLiteral("Modelle (*.fff *.txt);;Alle Dateien (*)"));
    QCOMPARE(drawings, QStringLiteral("Zeichnungen (*.svg *.svgz);;Alle Dateien (*)"));
    QCOMPARE(saved, QStringLiteral("FlatFitFab-Modelle (*.fff)"));
    const QStringList expected{u"SVG in Originalgröße (*.svg)"_s,
                               u"SVG, eine je Platte (*.svg)"_s,
                               u"DXF in Originalgröße (*.dxf)"_s,
                               u"DXF, eine je Platte (*.dxf)"_s,
                               u"DXF für alte Programme, R12 (*.dxf)"_s,
                               u"PDF, eine Seite je Platte (*.pdf)"_s,
                               u"PDF, auf A4 verteilt (*.pdf)"_s,
                               u"PDF, auf Letter verteilt (*.pdf)"_s,
                               u"LightBurn-Projekt (*.lbrn2)"_s,
                               u"LightBurn, eins je Platte (*.lbrn2)"_s,
                               u"G-Code für GRBL-Laser (*.gcode)"_s,
                               u"G-Code, einer je Platte (*.gcode)"_s,
                               u"Stückliste für Tabellen (*.csv)"_s,
                               u"Bild der Platten (*.png)"_s,
                               u"Bilder, eins je Platte (*.png)"_s,
                               u"Alles für die Werkstatt, gepackt (*.zip)"_s,
                               u"Alles für die Werkstatt, in einem Ordner"_s,
                               u"OBJ, Körper an ihrem Platz (*.obj)"_s,
                               u"STL, Körper an ihrem Platz (*.stl)"_s,
                               u"STL, Körper flach liegend (*.stl)"_s,
                               u"3MF, Körper an ihrem Platz (*.3mf)"_s,
                               u"3MF, Körper flach liegend (*.3mf)"_s,
                               u"OBJ, Haut als Netz (*.obj)"_s,
                               u"STL, Haut als Netz (*.stl)"_s};
    QCOMPARE(kinds, expected.join(u'|'));
    QCOMPARE(said,
             QStringLiteral("b.png ist kein Modell. FlatFitFab öffnet .fff und .txt von FlatFab."));
}

void TestFormatFilters::anAddedFormat()
{
    const io::AddedFormat added(test::addedFormat());
    QCOMPARE(ui::modelFilter(), QStringLiteral("Models (*.fff *.txt *.knots);;All files (*)"));
    QCOMPARE(ui::drawingFilter(), QStringLiteral("Drawings (*.svg *.svgz *.knots);;All files (*)"));
    QCOMPARE(ui::saveFilter(), QStringLiteral("FlatFitFab models (*.fff)"));
    const QString all = exported();
    QVERIFY2(all.contains(u"in a folder|Knots (*.knots)|Knots, one file for each sheet "
                          "(*.knots)|OBJ, solids in place (*.obj)|"_s),
             qPrintable(all));
    QCOMPARE(notAModel(), QStringLiteral("b.png is not a model. FlatFitFab opens .fff, FlatFab’s "
                                         ".txt and Knots’s .knots."));
}

// Few things to choose from, though there are many kinds: Export asks for the use first.
void TestFormatFilters::eachKindHasItsUse()
{
    const std::vector<ui::ExportKind> kinds = ui::exportKinds();
    std::map<io::FileUse, QStringList> keys;
    for (const ui::ExportKind &kind : kinds)
        if (!kind.isFilePerSheet)
            keys[kind.use] += kind.key;
    QCOMPARE(keys[io::FileUse::Cutting].join(u' '), u"svg dxf dxf/r12 pdf lbrn2 gcode"_s);
    QCOMPARE(keys[io::FileUse::Paper].join(u' '), u"pdf/a4 pdf/letter png"_s);
    QCOMPARE(keys[io::FileUse::Solids].join(u' '),
             u"obj stl stl/flat 3mf 3mf/flat obj/skin stl/skin"_s);
    QCOMPARE(keys[io::FileUse::Parts].join(u' '), u"csv"_s);
    QCOMPARE(keys[io::FileUse::Workshop].join(u' '), u"zip zip/folder"_s);
    // What has a file for each sheet is a box to check beside the same with all of them.
    for (const ui::ExportKind &kind : kinds)
        if (kind.isFilePerSheet)
            QVERIFY2(kind.key.endsWith(u"/sheets"_s) &&
                         keys[kind.use].contains(kind.key.chopped(QStringView(u"/sheets").size())),
                     qPrintable(kind.key));
}

void TestFormatFilters::whatIsDropped()
{
    QWidget window;
    ui::FileDrop drop(window);
    QSignalSpy dropped(&drop, &ui::FileDrop::dropped);
    const QStringList paths{QStringLiteral("/a/one.SVG"), QStringLiteral("/a/two.fff"),
                            QStringLiteral("/a/three.knots"), QStringLiteral("/a/four.Stl"),
                            QStringLiteral("/a/five")};
    QList<QUrl> urls;
    for (const QString &path : paths)
        urls += QUrl::fromLocalFile(path);
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
    QTRY_COMPARE(dropped.size(), 1);
    QCOMPARE(dropped.front().front().toStringList(), paths);

    ui::GivenFiles given = ui::givenFiles(paths);
    QCOMPARE(given.models.join(u'|'), QStringLiteral("/a/two.fff|/a/three.knots|/a/five"));
    QCOMPARE(given.drawings.join(u'|'), QStringLiteral("/a/one.SVG"));
    QCOMPARE(given.meshes.join(u'|'), QStringLiteral("/a/four.Stl"));
    const io::AddedFormat added(test::addedFormat());
    given = ui::givenFiles(paths);
    QCOMPARE(given.models.join(u'|'), QStringLiteral("/a/two.fff|/a/five"));
    QCOMPARE(given.drawings.size(), 2);
}

FFF_TEST_WITH(TestFormatFilters, fff::testing::runWithin<TestFormatFilters, QApplication>)
#include "tst_format_filters.moc"
