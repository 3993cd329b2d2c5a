// The pages of the Properties dock: short, and nothing of them cut off.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/properties/property_rows.h"

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QScrollArea>

#include <algorithm>

using namespace fff;
using namespace fff::ui;

class TestPropertyPages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
        m_window = openWindow();
        m_window->resize(1440, 900);
        bench().session().commit(QStringLiteral("draw"), squareDocument(1234.5));
        QCoreApplication::processEvents();
    }
    void cleanup() { closeEverything(); }

    void nothingSelectedIsCalm();
    void aSectionIsShort();
    void noPageIsCut_data();
    void noPageIsCut();
    void aPlaceHasTwoDecimals();

private:
    Workbench &bench() { return m_window->bench(); }
    QDockWidget *dock() const
    {
        return m_window->findChild<QDockWidget *>(QStringLiteral("propertiesDock"));
    }
    /// Without those in folded groups.
    int rows() const
    {
        int count = 0;
        for (QWidget *widget : dock()->findChildren<QWidget *>())
            count += dynamic_cast<PropertyRow *>(widget) && widget->isVisible() ? 1 : 0;
        return count;
    }
    void selectFirst() { bench().select({bench().session().committed().ref(0)}); }

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

// Wrong: who selects nothing looks at a wall of settings.
void TestPropertyPages::nothingSelectedIsCalm()
{
    qInfo("nothing selected: %d rows", rows());
    QVERIFY(rows() > 0 && rows() <= 4);
}

// Wrong: a section's numbers are three screens long, one coordinate a row.
void TestPropertyPages::aSectionIsShort()
{
    selectFirst();
    qInfo("section: %d rows", rows());
    QVERIFY(rows() > 8 && rows() <= 16);
    const auto place = [this](const char *name) {
        auto *field = dock()->findChild<QDoubleSpinBox *>(QLatin1String(name));
        return field->mapTo(dock(), QPoint());
    };
    QCOMPARE(place("positionX").y(), place("positionZ").y());
    QCOMPARE(place("normalX").y(), place("normalZ").y());
}

void TestPropertyPages::noPageIsCut_data()
{
    QTest::addColumn<QString>("command");
    QTest::newRow("model") << QString();
    QTest::newRow("section") << QStringLiteral("select");
    for (const char *kind : {"mirror", "rotational", "array", "grid", "radial"})
        QTest::newRow(kind) << QStringLiteral("operation.") + QLatin1String(kind);
}

// Wrong: the buttons at the right end of a row lie beyond the window's edge.
void TestPropertyPages::noPageIsCut()
{
    QFETCH(QString, command);
    if (!command.isEmpty())
        selectFirst();
    if (command.startsWith(QStringLiteral("operation")))
        bench().run(command);
    QCoreApplication::processEvents();
    const auto *area = dock()->findChild<QScrollArea *>();
    const int needs = area->widget()->minimumSizeHint().width();
    QVERIFY2(needs <= area->viewport()->width(),
             qPrintable(QStringLiteral("%1 of %2 px").arg(needs).arg(area->viewport()->width())));
}

// Wrong: −1.445 mm, as if anyone could cut that; and what is exact is rounded by looking at it.
void TestPropertyPages::aPlaceHasTwoDecimals()
{
    selectFirst();
    bench().run(QStringLiteral("section.move"), {{"x", "0.12345"}});
    auto *field = dock()->findChild<QDoubleSpinBox *>(QStringLiteral("positionX"));
    QCOMPARE(field->text(), QStringLiteral("617.37"));
    const double exact = bench().session().committed().section(0)->frame.origin.x();
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(bench().session().committed().section(0)->frame.origin.x(), exact);
}

FFF_TEST_WITH(TestPropertyPages, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    TestPropertyPages test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_property_pages.moc"
