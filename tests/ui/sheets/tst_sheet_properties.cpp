// What Properties says of the selected part on its sheet, and how a pinned one is told there. If
// this fails, one does not know why a part stays where it is, or that it does.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/sheet_edits.h"
#include "core/session/sheet_nesting.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "ui/base/theme.h"
#include "ui/base/translations.h"
#include "ui/dialogs/sheet_painting.h"
#include "ui/sheets/sheets_dock.h"
#include "ui/sheets/sheets_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QTemporaryDir>

#include <memory>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestSheetProperties : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void theSelectedPartIsTold();
    void eachPinnedPartHasItsPin();

private:
    template <class Kind>
    Kind *find(const char *name)
    {
        return m_window->findChild<Kind *>(QLatin1String(name));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestSheetProperties::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = openWindow();
    m_window->resize(1440, 900);
    m_window->show();
    m_window->showDocument();
}

void TestSheetProperties::cleanup()
{
    closeEverything();
    m_window = nullptr;
}

void TestSheetProperties::theSelectedPartIsTold()
{
    Workbench &bench = m_window->bench();
    bench.session().reset(combModel(4));
    const SectionRef section = bench.session().model().ref(1);
    bench.select({section});
    auto *pinned = find<QCheckBox>("sectionPinned");
    QVERIFY(pinned);
    QVERIFY(!pinned->isVisible()); // nobody looks at sheets
    actionOf(*m_window, "fabricate.sheets")->trigger();
    auto &view = *m_window->findChild<SheetsView *>();
    QTRY_VERIFY_WITH_TIMEOUT(bench.nesting().isCurrent() && !view.content().isOlder, 30000);
    QTRY_VERIFY(pinned->isVisible() && !pinned->isChecked());
    const auto said = [this](const char *name) { return find<QLabel>(name)->text(); };
    QVERIFY2(said("sectionSheet").contains(QStringLiteral("1 of 1")),
             qPrintable(said("sectionSheet")));
    // As the sheet shows it: the lower left corner of the part's box.
    const SheetPaths &sheet = view.content().sheets().front();
    const std::vector<PartOnSheet> &parts = view.content().facts.front().parts;
    QRectF box;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].section == section)
            box = sheet.parts[i].cuts.controlPointRect();
    const QString place =
        QStringLiteral("%1 × %2").arg(box.left(), 0, 'f', 1).arg(box.top(), 0, 'f', 1);
    QVERIFY2(said("sectionSheetPlace").contains(place),
             qPrintable(said("sectionSheetPlace") + QStringLiteral(" is not ") + place));
    QTest::mouseClick(pinned, Qt::LeftButton, {}, {8, 8});
    QVERIFY(pinOf(bench.session().committed().document, section, 0));
    QTRY_VERIFY(pinned->isChecked());
    QTest::mouseClick(pinned, Qt::LeftButton, {}, {8, 8});
    QVERIFY(bench.session().committed().document.pins.empty());
}

// Wrong: a slim part that is pinned and looks like all others.
void TestSheetProperties::eachPinnedPartHasItsPin()
{
    SheetPaths sheet;
    sheet.size = {200.0, 100.0};
    for (const QRectF &box :
         {QRectF(10, 10, 60, 60), QRectF(80, 10, 4, 80), QRectF(120, 40, 60, 3)}) {
        PartPaths part;
        part.number = 1 + static_cast<int>(sheet.parts.size());
        part.cuts.addRect(box);
        part.roomiest = box.center();
        part.hasNumber = box.width() > 20.0 && box.height() > 20.0;
        sheet.parts.push_back(part);
    }
    const auto painted = [&](std::size_t pinned) {
        QImage image(420, 240, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        SheetPainting how{QTransform(2.0, 0.0, 0.0, -2.0, 10.0, 220.0), 0.0};
        how.looks.resize(sheet.parts.size());
        if (pinned < how.looks.size())
            how.looks[pinned].isPinned = true;
        paintSheet(sheet, how, painter);
        painter.end();
        return image;
    };
    const QImage plain = painted(sheet.parts.size());
    for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
        const QImage pinned = painted(i);
        int marked = 0; // as dark as the pin itself, where nothing was
        for (int y = 0; y < pinned.height(); ++y)
            for (int x = 0; x < pinned.width(); ++x)
                marked +=
                    pinned.pixel(x, y) != plain.pixel(x, y) && qGray(pinned.pixel(x, y)) < 110;
        QVERIFY2(marked > 8, qPrintable(QStringLiteral("part %1: %2").arg(i).arg(marked)));
    }
}

FFF_TEST_WITH(TestSheetProperties, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestSheetProperties test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_sheet_properties.moc"
