// Presets and groups of values as a person uses them, in a window without its view.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/values/presets.h"
#include "tests/test_program.h"
#include "tests/ui/docks/values_hand.h"
#include "ui/base/translations.h"
#include "ui/properties/choice_box.h"

#include <QCheckBox>
#include <QPushButton>
#include <QUndoStack>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

Document withShown(Document document, const char *name, const char *group = "")
{
    Value value = *document.values.find(std::string_view(name));
    value.isShown = true;
    value.group = group;
    return changeValue(std::move(document), std::move(value)).value();
}

/// A width that is shown, and a half of it that is not.
Document shownWidth()
{
    return withShown(adjustable(), "width");
}

} // namespace

class TestValuePresets : public QObject, private ValuesHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { begin(); }
    void cleanup() { end(); }

    void keptByNameAndChosenAgain();
    void escapeKeepsNothing();
    void aBadNameIsRefused();
    void whoAdjustsChoosesOnly();
    void sumsAreOnlyRead();
    void groupsAreHeadings();
    void muchThatIsNotShownIsFolded();
    void aSwitchShowsToOthers();

private:
    template <class Widget>
    Widget *preset(const char *name)
    {
        return dock().findChild<Widget *>(QLatin1String(name));
    }
    void keep(const QString &name)
    {
        activate();
        const bool isFirst = preset<QPushButton>("presetFirst")->isVisible();
        QTest::mouseClick(isFirst ? static_cast<QWidget *>(preset<QPushButton>("presetFirst"))
                                  : preset<QToolButton>("presetKeep"),
                          Qt::LeftButton);
        QCOMPARE(m_window->focusWidget(), preset<QLineEdit>("presetName"));
        QTest::keyClicks(m_window->focusWidget(), name);
        QTest::keyClick(m_window->focusWidget(), Qt::Key_Return);
    }
    QStringList headings()
    {
        QStringList texts;
        for (const QWidget *group : dock().findChildren<QWidget *>(QStringLiteral("valueHeading")))
            texts += group->findChild<QPushButton *>(QStringLiteral("groupTitle"))->text();
        return texts;
    }
};

void TestValuePresets::keptByNameAndChosenAgain()
{
    open(shownWidth());
    keep(QStringLiteral("A5"));
    QCOMPARE(document().values.presets.size(), std::size_t(1));
    auto *box = preset<ChoiceBox>("presetBox");
    QVERIFY(box->isVisible());
    QCOMPARE(box->currentText(), QStringLiteral("A5"));
    QVERIFY(!preset<QToolButton>("presetKeep")->isEnabled());
    type(in<NumberEdit>("width"), QStringLiteral("60"));
    QCOMPARE(box->currentIndex(), -1);
    keep(QStringLiteral("A4"));
    QCOMPARE(thickness(), 6.0);
    const int steps = bench().session().history()->count();
    box->setFocus();
    Q_EMIT box->activated(0);
    QCOMPARE(thickness(), 4.0);
    QCOMPARE(box->currentText(), QStringLiteral("A5"));
    QCOMPARE(bench().session().history()->count(), steps + 1);
    bench().session().history()->undo();
    QCOMPARE(thickness(), 6.0);
    QCOMPARE(box->currentText(), QStringLiteral("A4"));
    QTest::mouseClick(preset<QToolButton>("presetDelete"), Qt::LeftButton);
    QCOMPARE(document().values.presets.size(), std::size_t(1));
    bench().session().history()->undo();
    QCOMPARE(document().values.presets.size(), std::size_t(2));
}

void TestValuePresets::escapeKeepsNothing()
{
    open(shownWidth());
    activate();
    QTest::mouseClick(preset<QPushButton>("presetFirst"), Qt::LeftButton);
    QTest::keyClicks(m_window->focusWidget(), QStringLiteral("A5"));
    QTest::keyClick(m_window->focusWidget(), Qt::Key_Escape);
    QVERIFY(document().values.presets.empty());
    QVERIFY(preset<QPushButton>("presetFirst")->isVisible());
    QVERIFY(!preset<QLineEdit>("presetName")->isVisible());
}

void TestValuePresets::aBadNameIsRefused()
{
    open(shownWidth());
    keep(QStringLiteral("a=b"));
    QVERIFY(document().values.presets.empty());
    QVERIFY(preset<QLabel>("presetProblem")->isVisible());
    QVERIFY(preset<QLineEdit>("presetName")->isVisible());
}

void TestValuePresets::whoAdjustsChoosesOnly()
{
    Document adjusted = shownWidth();
    adjusted.values = withPreset(adjusted.values, takenPreset(adjusted.values, "A5"));
    open(adjusted);
    dock().setAdjustsOnly(true);
    QVERIFY(preset<ChoiceBox>("presetBox")->isVisible());
    QVERIFY(!preset<QToolButton>("presetKeep")->isVisible());
    QVERIFY(!preset<QToolButton>("presetDelete")->isVisible());
    bench().session().reset(shownWidth());
    QVERIFY(!preset<ChoiceBox>("presetBox")->isVisible());
    QVERIFY(!preset<QPushButton>("presetFirst")->isVisible());
}

// Wrong: a friend who types over a sum ends it, and nothing follows any more.
void TestValuePresets::sumsAreOnlyRead()
{
    open(withShown(shownWidth(), "half"));
    QVERIFY(in<NumberEdit>("half")->isEnabled());
    dock().setAdjustsOnly(true);
    QVERIFY(!in<NumberEdit>("half")->isEnabled());
    QVERIFY(in<NumberEdit>("width")->isEnabled());
    dock().setAdjustsOnly(false);
    QVERIFY(in<NumberEdit>("half")->isEnabled());
}

void TestValuePresets::groupsAreHeadings()
{
    Document grouped = withValue(shownWidth(), "height", "3 mm");
    grouped = withShown(withValue(grouped, "depth", "4 mm"), "depth", "Size");
    open(withShown(grouped, "height", "Size"));
    QCOMPARE(headings(),
             (QStringList{QString(), QStringLiteral("Size"), QStringLiteral("Only for you")}));
    // What is typed for a group takes the row there, and the hand stays in it.
    auto *field = detail<QWidget>("width", "valueGroup");
    auto *line = qobject_cast<QLineEdit *>(field);
    QVERIFY(line);
    type(line, QStringLiteral("Size"));
    QCOMPARE(headings(), (QStringList{QStringLiteral("Size"), QStringLiteral("Only for you")}));
    QVERIFY(row("width")->isAncestorOf(m_window->focusWidget()));
    QCOMPARE(document().values.find(std::string_view("width"))->group, std::string("Size"));
}

void TestValuePresets::muchThatIsNotShownIsFolded()
{
    Document many = shownWidth();
    for (const char *name : {"a", "b", "c", "d"})
        many = withValue(many, name, "3 mm");
    open(many);
    QVERIFY(row("width")->isVisible());
    QVERIFY(!row("a")->isVisible());
    // What is wrong is not folded away.
    bench().session().reset(withValue(many, "e", "nobody + 1 mm"));
    QVERIFY(row("e")->isVisible());
}

void TestValuePresets::aSwitchShowsToOthers()
{
    open(adjustable());
    QVERIFY(!preset<QPushButton>("presetFirst")->isVisible()); // nothing to keep
    auto *shown = detail<QCheckBox>("width", "valueShown");
    QVERIFY(shown);
    shown->click();
    QVERIFY(document().values.find(std::string_view("width"))->isShown);
    QVERIFY(preset<QPushButton>("presetFirst")->isVisible());
}

FFF_TEST_WITH(TestValuePresets, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestValuePresets test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_value_presets.moc"
