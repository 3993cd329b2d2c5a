// Which sheets there are of a stock, in the Stocks window by real events, and what lies on them. If
// this fails, somebody who has an offcut buys a new sheet.
#include <QTest>

#include "core/analysis/findings/few_sheets.h"
#include "core/analysis/nested.h"
#include "core/session/check_list.h"
#include "core/session/message_text.h"
#include "core/session/scheduler.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "ui/base/translations.h"
#include "ui/properties/link_row.h"

#include <QCheckBox>
#include <QFile>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUndoStack>

using namespace fff;
using namespace fff::ui;

class TestStockSheets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void anOffcutIsAddedChangedAndTakenAway();
    void fromADrawing();
    void partsLieOnIt();
    void moreSheetsThanThereAre();
    void soldAsAndMeasured();
    void aMeasuredThicknessIsNotWhatItIsSoldAs();

private:
    Session &session() { return m_window->bench().session(); }
    const Stock &stock() { return *session().committed().document.stocks.front(); }
    QDialog *editor()
    {
        actionOf(*m_window, "fabricate.stocks")->trigger();
        return m_window->findChild<QDialog *>(QStringLiteral("stockEditor"));
    }
    static void press(QDialog *dialog, const char *name)
    {
        auto *button = dialog->findChild<QToolButton *>(QLatin1String(name));
        QVERIFY2(button, name);
        QTest::mouseClick(button, Qt::LeftButton);
    }

    QString file(const char *name) const { return m_folder->filePath(QLatin1String(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestStockSheets::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(file("settings.ini"));
    m_window = openWindow();
    m_window->show();
    m_window->showDocument();
    session().commit(QStringLiteral("draw"), squareDocument());
}

void TestStockSheets::cleanup()
{
    closeEverything();
}

/// Each change is a step that can be taken back.
void TestStockSheets::anOffcutIsAddedChangedAndTakenAway()
{
    QDialog *dialog = editor();
    QVERIFY(stock().spares.empty());
    press(dialog, "offcutAdd");
    QCOMPARE(stock().spares.size(), std::size_t(1));
    typeInto(dialog, "offcutWidth1", QStringLiteral("450"));
    typeInto(dialog, "offcutHeight1", QStringLiteral("130"));
    typeInto(dialog, "offcutCount1", QStringLiteral("3"));
    QCOMPARE(rectangleOf(stock().spares.front()), std::optional(Vec2(450, 130)));
    QCOMPARE(stock().spares.front().count, 3);
    press(dialog, "offcutAdd");
    QCOMPARE(stock().spares.size(), std::size_t(2));
    session().history()->undo();
    session().history()->undo(); // how many
    QCOMPARE(stock().spares.front().count, 1);
    QCOMPARE(dialog->findChild<QDoubleSpinBox *>(QStringLiteral("offcutCount1"))->value(), 1.0);
    press(dialog, "offcutRemove1");
    QVERIFY(stock().spares.empty());
    QVERIFY(!dialog->findChild<QDoubleSpinBox *>(QStringLiteral("offcutWidth1"))->isVisible());
}

void TestStockSheets::fromADrawing()
{
    const QString path = file("rest.svg");
    QFile drawing(path);
    QVERIFY(drawing.open(QIODevice::WriteOnly));
    drawing.write("<svg xmlns='http://www.w3.org/2000/svg' width='400mm' height='300mm' "
                  "viewBox='0 0 400 300'><path d='M50 250 H350 V150 H200 V50 H50 Z'/></svg>");
    drawing.close();
    QDialog *dialog = editor();
    nameTheFile(path);
    press(dialog, "offcutDrawing");
    QCOMPARE(stock().spares.size(), std::size_t(1));
    QVERIFY(!rectangleOf(stock().spares.front()));
    QVERIFY((stock().spares.front().size() - Vec2(300, 200)).norm() < 1e-6);
    QVERIFY(!dialog->findChild<QDoubleSpinBox *>(QStringLiteral("offcutWidth1"))->isVisible());
}

/// What is added from the Sheets dock is what parts lie on then, in the dock and in the file.
void TestStockSheets::partsLieOnIt()
{
    actionOf(*m_window, "fabricate.sheets")->trigger();
    auto *link = m_window->findChild<LinkRow *>(QStringLiteral("sheetsOffcut"));
    QVERIFY(link);
    QTest::mouseClick(link->findChild<QAbstractButton *>(), Qt::LeftButton);
    auto *dialog = m_window->findChild<QDialog *>(QStringLiteral("stockEditor"));
    QVERIFY(dialog && dialog->isVisible());
    press(dialog, "offcutAdd");
    typeInto(dialog, "offcutWidth1", QStringLiteral("350"));
    dialog->close();
    const auto layout = [this]() -> const Layout * {
        session().scheduler().finish(kNested.name);
        const auto nested = session().scheduler().result(kNested);
        return nested ? nested->layout.get() : nullptr;
    };
    QTRY_VERIFY(layout() && layout()->sheets.front().index == -1);
    QVERIFY(layout()->sheets.front().size == Vec2(350, 200));
    inExportPanel(*m_window, [&](QDialog *panel) {
        QVERIFY(textOf(panel, "exportOffcuts").contains(QStringLiteral("1 offcut")));
        exportTo(panel, file("a.svg"));
    });
    QVERIFY(io::readFile(file("a.svg")).value_or("").find("width=\"350mm\"") != std::string::npos);
}

void TestStockSheets::moreSheetsThanThereAre()
{
    Document document = squareDocument(280);
    for (const double at : {100.0, 200.0, 300.0})
        document = test::withSection(document, test::plateOf(0, 0, 280, 280), test::front(at));
    session().commit(QStringLiteral("draw"), document);
    typeInto(editor(), "stockSheetCount", QStringLiteral("1"));
    QCOMPARE(stock().sheetCount, std::optional(1));
    inExportPanel(*m_window, [&](QDialog *panel) {
        QStringList said;
        for (const QLabel *label : panel->findChildren<QLabel *>())
            said += label->text();
        QVERIFY2(said.join(u' ').contains(QStringLiteral("1 more sheet")),
                 qPrintable(said.join(u'\n')));
        QVERIFY2(!said.join(u' ').contains(QStringLiteral("Fits the sheet")), // nor beside it
                 qPrintable(said.join(u'\n')));
    });
    auto *checks = m_window->findChild<CheckList *>();
    const auto sizeIs = [checks](Severity severity) {
        return checks->age() == CheckList::Age::Current &&
               worst(checks->all(), Subject::Size) == severity;
    };
    QTRY_VERIFY(sizeIs(Severity::Warning));
    const auto few = std::find_if(checks->all().begin(), checks->all().end(),
                                  [](const Finding &finding) { return finding.is(kFewSheets); });
    QVERIFY(few != checks->all().end());
    QCOMPARE(messageText(few->kind->sentence(*few, checks->model())),
             QStringLiteral("May run out of sheets. It takes up to 2 sheets of %1, and you have 1.")
                 .arg(QString::fromStdString(stock().name)));
    typeInto(editor(), "stockSheetCount", QStringLiteral("0"));
    QVERIFY(!stock().sheetCount);
    QTRY_VERIFY(sizeIs(Severity::Good));
}

void TestStockSheets::soldAsAndMeasured()
{
    QDialog *dialog = editor();
    typeInto(dialog, "stockNominal", QStringLiteral("4"));
    QCOMPARE(stock().nominalThickness, std::optional(4.0));
    QCOMPARE(stock().thickness, 3.0);
    typeInto(dialog, "stockNominal", QStringLiteral("3"));
    QVERIFY(!stock().nominalThickness);
    auto *box = dialog->findChild<QCheckBox *>(QStringLiteral("stockMeasured"));
    QVERIFY(box);
    QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
    QVERIFY(stock().isMeasured);
}

/// Wrong: what the calipers say becomes what the sheet is sold as.
void TestStockSheets::aMeasuredThicknessIsNotWhatItIsSoldAs()
{
    session().commit(QStringLiteral("draw"), squareDocument());
    QDialog *dialog = editor();
    typeInto(dialog, "thicknessEdit", QStringLiteral("2.85"));
    QCOMPARE(stock().thickness, 2.85);
    QCOMPARE(stock().nominalThickness, std::optional(3.0));
    QCOMPARE(dialog->findChild<QDoubleSpinBox *>(QStringLiteral("stockNominal"))->value(), 3.0);
    typeInto(dialog, "thicknessEdit", QStringLiteral("3"));
    QVERIFY(!stock().nominalThickness);
    // Another sheet.
    typeInto(dialog, "thicknessEdit", QStringLiteral("6"));
    QVERIFY(!stock().nominalThickness);
    // As it was measured for Export, however far off.
    inExportPanel(*m_window, [&](QDialog *panel) {
        typeInto(panel, "exportThickness", QStringLiteral("4.9"));
        exportTo(panel, file("a.svg"));
    });
    QCOMPARE(stock().thickness, 4.9);
    QCOMPARE(stock().nominalThickness, std::optional(6.0));
}

FFF_TEST_WITH(TestStockSheets, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestStockSheets test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_stock_sheets.moc"
