// What dialogs and sentences say of formats. If this fails, a format that was added cannot be
// chosen, or what people read has changed.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/io/added_format.h"
#include "tests/test_program.h"
#include "ui/files/failures.h"
#include "ui/files/file_drop.h"
#include "ui/files/format_filters.h"

#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTranslator>
#include <QUrl>
#include <QWidget>

using namespace fff;

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
    QCOMPARE(
        exported(),
        QStringLiteral("SVG, true to size (*.svg)|SVG, one for each sheet (*.svg)|OBJ, solids "
                       "in place (*.obj)|OBJ, skin as a mesh (*.obj)|STL, skin as a mesh (*.stl)"));
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
    QCOMPARE(kinds, QStringLiteral(
                        "SVG in Originalgröße (*.svg)|SVG, eine je Platte (*.svg)|OBJ, "
                        "Körper an ihrem Platz (*.obj)|OBJ, Haut als Netz (*.obj)|STL, Haut als "
                        "Netz (*.stl)"));
    QCOMPARE(said,
             QStringLiteral("b.png ist kein Modell. FlatFitFab öffnet .fff und .txt von FlatFab."));
}

void TestFormatFilters::anAddedFormat()
{
    const io::AddedFormat added(test::addedFormat());
    QCOMPARE(ui::modelFilter(), QStringLiteral("Models (*.fff *.txt *.knots);;All files (*)"));
    QCOMPARE(ui::drawingFilter(), QStringLiteral("Drawings (*.svg *.svgz *.knots);;All files (*)"));
    QCOMPARE(ui::saveFilter(), QStringLiteral("FlatFitFab models (*.fff)"));
    QCOMPARE(
        exported(),
        QStringLiteral("SVG, true to size (*.svg)|SVG, one for each sheet (*.svg)|Knots "
                       "(*.knots)|Knots, one file for each sheet (*.knots)|OBJ, solids in "
                       "place (*.obj)|OBJ, skin as a mesh (*.obj)|STL, skin as a mesh (*.stl)"));
    QCOMPARE(notAModel(), QStringLiteral("b.png is not a model. FlatFitFab opens .fff, FlatFab’s "
                                         ".txt and Knots’s .knots."));
}

void TestFormatFilters::whatIsDropped()
{
    QWidget window;
    ui::FileDrop drop(window);
    QSignalSpy models(&drop, &ui::FileDrop::dropped),
        drawings(&drop, &ui::FileDrop::drawingDropped);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QStringLiteral("/a/one.SVG")),
                  QUrl::fromLocalFile(QStringLiteral("/a/two.fff")),
                  QUrl::fromLocalFile(QStringLiteral("/a/three.knots"))});
    const auto let = [&] {
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &event);
    };
    let();
    QTRY_COMPARE(models.size(), 1);
    QCOMPARE(models.front().front().toStringList().join(u'|'),
             QStringLiteral("/a/two.fff|/a/three.knots"));
    QCOMPARE(drawings.size(), 1);
    const io::AddedFormat added(test::addedFormat());
    let();
    QTRY_COMPARE(models.size(), 2);
    QCOMPARE(models.back().front().toStringList().join(u'|'), QStringLiteral("/a/two.fff"));
    QCOMPARE(drawings.size(), 3);
}

FFF_TEST_WITH(TestFormatFilters, fff::testing::runWithin<TestFormatFilters, QApplication>)
#include "tst_format_filters.moc"
