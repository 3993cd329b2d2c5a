// Settings, shortcuts, the search for actions, About and the start page, as a person uses them.
#include <QTest>

#include "core/base/units.h"
#include "core/session/check_list.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/actions/action_set.h"
#include "ui/actions/menu_table.h"
#include "ui/base/theme.h"
#include "ui/cards/model_card.h"
#include "ui/dialogs/command_search.h"
#include "ui/dialogs/libraries.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/dialogs/shortcut_keys.h"
#include "ui/start/start_page.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScreen>
#include <QSpinBox>
#include <QTreeWidget>

#include <functional>

using namespace fff;
using namespace fff::ui;

class TestDialogs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void settingsAreKept();
    void numbersAreKeptAsTheyAreShown_data();
    void numbersAreKeptAsTheyAreShown();
    void checksFollowTheSettingsAtOnce();
    void stocksOpenOnTheScreen();
    void theThemeIsFollowedAtOnce();
    void stressColoursAreChosenForTheColourBlind();
    void theTurnTimeIsFollowedAtOnce();
    void everyActionHasAnIconAndIsInAMenu();
    void aShortcutIsChangedInAllWindows();
    void aTakenShortcutIsNamedAndTaken();
    void aSingleKeyIsForTheViewOnly();
    void shortcutsAreReset();
    void everyEntryOfTheMenusIsACommand();
    void keysBelongToOneAction();
    void theSearchRunsWhatItFinds();
    void theSearchSaysWhyNot();
    void aboutNamesEveryLicence();
    void aboutIsCopied();
    void theStartPageOpensASampleAsACopy();
    void theStartPageNeverCoversAModel();
    void theStartPageListsRecentFiles();

private:
    void withSettings(SettingsDialog::Page page, const std::function<void(QDialog *)> &act);
    static QTreeWidgetItem *rowOf(QTreeWidget *tree, const char *id);

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestDialogs::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = openWindow();
}

void TestDialogs::cleanup()
{
    closeEverything();
}

void TestDialogs::withSettings(SettingsDialog::Page page, const std::function<void(QDialog *)> &act)
{
    SettingsDialog dialog(listedActions(*m_window->menuBar()), m_window);
    dialog.showPage(page);
    dialog.show();
    act(&dialog);
}

QTreeWidgetItem *TestDialogs::rowOf(QTreeWidget *tree, const char *id)
{
    for (int i = 0; i < tree->topLevelItemCount(); ++i) {
        for (int j = 0; j < tree->topLevelItem(i)->childCount(); ++j) {
            QTreeWidgetItem *row = tree->topLevelItem(i)->child(j);
            if (row->data(0, Qt::UserRole).toString() == QLatin1String(id))
                return row;
        }
    }
    return nullptr;
}

void TestDialogs::settingsAreKept()
{
    bool seen = false;
    whenShown<QDialog>("settingsDialog", [&seen](QDialog *dialog) {
        seen = true;
        const auto choose = [dialog](const char *name, int index) {
            auto *box = dialog->findChild<QComboBox *>(QLatin1String(name));
            box->setCurrentIndex(index);
            Q_EMIT box->activated(index);
        };
        choose("settingsUnit", 2);
        choose("settingsTheme", 2);
        choose("settingsLanguage", 1);
        auto *field = dialog->findChild<QDoubleSpinBox *>(QStringLiteral("settingsAutosave"));
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("17"));
        QTest::keyClick(field, Qt::Key_Return);
        dialog->findChild<QCheckBox *>(QStringLiteral("settingsStartPage"))->click();
        dialog->findChild<QCheckBox *>(QStringLiteral("settingsBackup"))->click();
    });
    actionOf(*m_window, "file.settings")->trigger();
    QVERIFY(seen);
    const Settings again(m_folder->filePath(QStringLiteral("settings.ini")));
    QCOMPARE(again.unit(), LengthUnit::Inch);
    QCOMPARE(again.colourScheme(), ColourScheme::Dark);
    QCOMPARE(again.language(), QStringLiteral("de"));
    QCOMPARE(again.autosaveInterval(), 17);
    QVERIFY(!again.showsStartPage());
    QVERIFY(!again.keepsBackup());
}

void TestDialogs::numbersAreKeptAsTheyAreShown_data()
{
    using Page = SettingsDialog::Page;
    QTest::addColumn<int>("page");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("shown");
    QTest::addColumn<std::function<int()>>("kept");
    QTest::addColumn<int>("expected");
    const auto row = [](const char *title, Page page, const char *name, const char *typed,
                        const char *shown, int (Settings::*kept)() const, int expected) {
        QTest::newRow(title) << static_cast<int>(page) << QString::fromLatin1(name)
                             << QString::fromLatin1(typed) << QString::fromLatin1(shown)
                             << std::function([kept] { return (settings().*kept)(); }) << expected;
    };
    row("the turn time to whole ms", Page::View, "settingsTurnTime", "250.7", "251",
        &Settings::turnTime, 251);
    row("the turn angle to whole degrees", Page::View, "settingsTurnAngle", "75.6", "76",
        &Settings::turnAngle, 76);
    row("the shallow angle to whole degrees", Page::Checks, "settingsShallowAngle", "25.7", "26",
        &Settings::shallowAngle, 26);
    row("the shallow angle of a sum", Page::Checks, "settingsShallowAngle", "100/3", "33",
        &Settings::shallowAngle, 33);
    row("the planning time to ms", Page::Checks, "settingsPlanningTime", "1.256", "1.256",
        &Settings::planningTime, 1256);
    row("the safety factor to tenths", Page::Checks, "settingsSafety", "2.56", "2.6",
        &Settings::safetyFactor, 26);
    row("the notch factor to tenths", Page::Checks, "settingsNotch", "3.5", "3.5",
        &Settings::notchFactor, 35);
    row("the time between copies to whole s", Page::Files, "settingsAutosave", "17.5", "18",
        &Settings::autosaveInterval, 18);
}

// Wrong: a field shows 26 and the program goes by 25.
void TestDialogs::numbersAreKeptAsTheyAreShown()
{
    QFETCH(int, page);
    QFETCH(QString, name);
    QFETCH(QString, typed);
    QFETCH(QString, shown);
    QFETCH(std::function<int()>, kept);
    QFETCH(int, expected);
    withSettings(static_cast<SettingsDialog::Page>(page), [&](QDialog *dialog) {
        auto *field = dialog->findChild<QDoubleSpinBox *>(name);
        QVERIFY(field && field->isVisible());
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, typed);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(field->text().remove(field->suffix()), shown);
        QCOMPARE(kept(), expected);
    });
}

// Wrong: a joint is said to be too flat, or not to be, until the model changes.
void TestDialogs::checksFollowTheSettingsAtOnce()
{
    const ShapePointer plate = test::polygonShape(test::rectangle(-50, 0, 50, 60));
    Session &session = m_window->bench().session();
    session.reset(test::withSection(test::withSection(newDocument(), plate, test::front()), plate,
                                    test::turned(radians(40.0))));
    session.currentAnalysis();
    auto *list = m_window->findChild<CheckList *>();
    const auto isFlat = [list] {
        list->finish();
        return std::any_of(list->all().begin(), list->all().end(),
                           [](const Finding &c) { return c.is(kShallowAngle); });
    };
    QVERIFY(!isFlat());
    settings().setShallowAngle(41);
    QVERIFY(isFlat());
    settings().setShallowAngle(39);
    QVERIFY(!isFlat());
}

// Wrong: its Close button, and the last rows, are below the screen.
void TestDialogs::stocksOpenOnTheScreen()
{
    const QRect free = m_window->screen()->availableGeometry();
    m_window->resize(1024, 640);
    m_window->move(free.right() - 900, free.bottom() - 500);
    actionOf(*m_window, "fabricate.stocks")->trigger();
    auto *stocks = m_window->findChild<QDialog *>(QStringLiteral("stockEditor"));
    QVERIFY(stocks && stocks->isVisible());
    QVERIFY(stocks->height() > 420);
    QVERIFY2(free.contains(stocks->frameGeometry()),
             qPrintable(QString::number(stocks->frameGeometry().bottom())));
}

void TestDialogs::theThemeIsFollowedAtOnce()
{
    settings().setColourScheme(ColourScheme::Dark);
    QVERIFY(theme().isDark);
    QVERIFY(m_window->palette().color(QPalette::Window).lightness() < 128);
    settings().setColourScheme(ColourScheme::Light);
    QVERIFY(!theme().isDark);
    QVERIFY(m_window->palette().color(QPalette::Window).lightness() > 128);
    settings().setColourScheme(ColourScheme::HighContrast);
    QVERIFY(theme().isHighContrast);
    QCOMPARE(m_window->palette().color(QPalette::Window), theme().window);
}

// Wrong: who cannot tell red from green has to have all of the window in high contrast.
void TestDialogs::stressColoursAreChosenForTheColourBlind()
{
    const auto press = [](QDialog *dialog) {
        dialog->findChild<QCheckBox *>(QStringLiteral("settingsColourSafe"))->click();
    };
    QVERIFY(!theme().viewStyle().isForColourBlind);
    withSettings(SettingsDialog::Page::View, press);
    QVERIFY(theme().viewStyle().isForColourBlind);
    QVERIFY(!theme().isHighContrast);
    withSettings(SettingsDialog::Page::View, press);
    QVERIFY(!theme().viewStyle().isForColourBlind);
    settings().setColourScheme(ColourScheme::HighContrast);
    QVERIFY(theme().viewStyle().isForColourBlind);
    settings().setColourScheme(ColourScheme::Light);
}

void TestDialogs::theTurnTimeIsFollowedAtOnce()
{
    settings().setMotion(Motion::Full);
    settings().setTurnTime(250);
    QCOMPARE(m_window->bench().interaction().settings().turnTime, 250.0);
    settings().setMotion(Motion::Reduced);
    QCOMPARE(m_window->bench().interaction().settings().turnTime, 0.0);
}

void TestDialogs::everyActionHasAnIconAndIsInAMenu()
{
    QStringList inMenus;
    for (const ListedAction &listed : listedActions(*m_window->menuBar()))
        inMenus += listed.id;
    for (const QAction *action : m_window->findChildren<QAction *>()) {
        const QString id = action->objectName();
        if (!m_window->bench().commands().contains(id.toStdString()))
            continue;
        QVERIFY2(!action->icon().pixmap(24).isNull(), qPrintable(id));
        QVERIFY2(inMenus.contains(id), qPrintable(id));
    }
    QVERIFY(inMenus.contains(QStringLiteral("edit.undo")));
}

void TestDialogs::aShortcutIsChangedInAllWindows()
{
    MainWindow *other = openWindow();
    withSettings(SettingsDialog::Page::Keyboard, [](QDialog *dialog) {
        auto *tree = dialog->findChild<QTreeWidget *>(QStringLiteral("shortcutTree"));
        tree->setCurrentItem(rowOf(tree, "edit.selectAll"));
        QTest::keyClick(dialog->findChild<QLineEdit *>(QStringLiteral("shortcutRecorder")),
                        Qt::Key_J, Qt::ControlModifier);
    });
    const QKeySequence keys(QStringLiteral("Ctrl+J"));
    for (MainWindow *window : {m_window, other}) {
        QCOMPARE(actionOf(*window, "edit.selectAll")->shortcut(), keys);
        QVERIFY(actionOf(*window, "edit.selectAll")
                    ->toolTip()
                    .contains(keys.toString(QKeySequence::NativeText)));
    }
    QCOMPARE(actionOf(*openWindow(), "edit.selectAll")->shortcut(), keys);
}

void TestDialogs::aTakenShortcutIsNamedAndTaken()
{
    withSettings(SettingsDialog::Page::Keyboard, [this](QDialog *dialog) {
        auto *tree = dialog->findChild<QTreeWidget *>(QStringLiteral("shortcutTree"));
        auto *note = dialog->findChild<QLabel *>(QStringLiteral("shortcutNote"));
        auto *take = dialog->findChild<QPushButton *>(QStringLiteral("shortcutTake"));
        tree->setCurrentItem(rowOf(tree, "edit.selectAll"));
        QTest::keyClick(dialog->findChild<QLineEdit *>(QStringLiteral("shortcutRecorder")),
                        Qt::Key_S, Qt::ControlModifier);
        QVERIFY2(note->text().contains(QStringLiteral("Save")), qPrintable(note->text()));
        QVERIFY(take->isVisible());
        // Nothing is taken before it was said.
        QCOMPARE(actionOf(*m_window, "file.save")->shortcuts(),
                 QList<QKeySequence>{QKeySequence(QStringLiteral("Ctrl+S"))});
        take->click();
        QVERIFY(!take->isVisible());
    });
    QVERIFY(actionOf(*m_window, "file.save")->shortcuts().isEmpty());
    QCOMPARE(actionOf(*m_window, "edit.selectAll")->shortcut(),
             QKeySequence(QStringLiteral("Ctrl+S")));
    QVERIFY(actionOf(*m_window, "file.save")->shortcut().isEmpty());
}

void TestDialogs::aSingleKeyIsForTheViewOnly()
{
    withSettings(SettingsDialog::Page::Keyboard, [](QDialog *dialog) {
        auto *tree = dialog->findChild<QTreeWidget *>(QStringLiteral("shortcutTree"));
        auto *recorder = dialog->findChild<QLineEdit *>(QStringLiteral("shortcutRecorder"));
        tree->setCurrentItem(rowOf(tree, "edit.selectAll"));
        QTest::keyClick(recorder, Qt::Key_J);
        QVERIFY(!dialog->findChild<QLabel *>(QStringLiteral("shortcutNote"))->text().isEmpty());
        tree->setCurrentItem(rowOf(tree, "view.front"));
        QTest::keyClick(recorder, Qt::Key_J);
    });
    QCOMPARE(actionOf(*m_window, "edit.selectAll")->shortcut(),
             QKeySequence(QStringLiteral("Ctrl+A")));
    QCOMPARE(actionOf(*m_window, "view.front")->shortcut(), QKeySequence(QStringLiteral("J")));
}

void TestDialogs::shortcutsAreReset()
{
    settings().setShortcuts(QStringLiteral("edit.undo"),
                            QList<QKeySequence>{QKeySequence(QStringLiteral("Ctrl+J"))});
    settings().setShortcuts(QStringLiteral("edit.delete"), QList<QKeySequence>());
    withSettings(SettingsDialog::Page::Keyboard, [](QDialog *dialog) {
        auto *tree = dialog->findChild<QTreeWidget *>(QStringLiteral("shortcutTree"));
        tree->setCurrentItem(rowOf(tree, "edit.undo"));
        dialog->findChild<QPushButton *>(QStringLiteral("shortcutReset"))->click();
        QVERIFY(!settings().shortcuts(QStringLiteral("edit.undo")));
        QVERIFY(settings().shortcuts(QStringLiteral("edit.delete")));
        dialog->findChild<QPushButton *>(QStringLiteral("shortcutResetAll"))->click();
        QVERIFY(!settings().shortcuts(QStringLiteral("edit.delete")));
    });
    QCOMPARE(actionOf(*m_window, "edit.undo")->shortcut(), QKeySequence(QStringLiteral("Ctrl+Z")));
}

// Wrong: an entry that is misspelt in the table is missing from its menu without a word.
void TestDialogs::everyEntryOfTheMenusIsACommand()
{
    for (const MenuRow &row : menuTable())
        for (const QString &id : QString::fromLatin1(row.ids).split(u' ', Qt::SkipEmptyParts))
            if (id != QStringLiteral("|") && !id.startsWith(u'@') && !id.startsWith(u'>'))
                QVERIFY2(actionOf(*m_window, id.toLatin1().constData()), qPrintable(id));
}

void TestDialogs::keysBelongToOneAction()
{
    // As the program has them: two actions with the same keys would both do nothing.
    QHash<QKeySequence, QString> owners;
    for (const QAction *action : m_window->findChildren<QAction *>()) {
        for (const QKeySequence &keys : action->shortcuts()) {
            QVERIFY2(!owners.contains(keys), qPrintable(keys.toString()));
            owners.insert(keys, action->objectName());
        }
    }
    ShortcutKeys table(listedActions(*m_window->menuBar()));
    const QKeySequence save(QStringLiteral("Ctrl+S"));
    table.assign(QStringLiteral("edit.undo"), {save});
    QCOMPARE(table.ownerOf(save, {}), QStringLiteral("edit.undo"));
    QVERIFY(table.of(QStringLiteral("file.save")).isEmpty());
    // The beginning of a longer sequence is taken too.
    QCOMPARE(table.ownerOf(QKeySequence(QStringLiteral("Ctrl+S, Ctrl+J")), {}),
             QStringLiteral("edit.undo"));
}

void TestDialogs::theSearchRunsWhatItFinds()
{
    actionOf(*m_window, "edit.find")->trigger();
    auto *search = m_window->findChild<CommandSearch *>();
    QVERIFY(search && search->isVisible());
    auto *field = search->findChild<QLineEdit *>();
    auto *list = search->findChild<QListWidget *>();
    const int all = list->count();
    QTest::keyClicks(field, QStringLiteral("hide docks"));
    QVERIFY(list->count() > 0 && list->count() < all);
    QVERIFY(list->currentRow() == 0);
    QVERIFY(!actionOf(*m_window, "view.docks")->isChecked());
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY(actionOf(*m_window, "view.docks")->isChecked());
    QTRY_VERIFY(!m_window->findChild<CommandSearch *>());
}

void TestDialogs::theSearchSaysWhyNot()
{
    actionOf(*m_window, "edit.find")->trigger();
    auto *search = m_window->findChild<CommandSearch *>();
    auto *field = search->findChild<QLineEdit *>();
    auto *list = search->findChild<QListWidget *>();
    QTest::keyClicks(field, QStringLiteral("edit.delete"));
    QCOMPARE(list->count(), 1);
    QVERIFY(list->currentItem()
                ->data(Qt::AccessibleTextRole)
                .toString()
                .contains(QStringLiteral("No section is selected")));
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(search->isVisible());
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_VERIFY(!m_window->findChild<CommandSearch *>());
}

void TestDialogs::aboutNamesEveryLicence()
{
    QStringList names;
    bool allHaveTexts = true;
    whenShown<QDialog>("aboutDialog", [&](QDialog *dialog) {
        auto *list = dialog->findChild<QListWidget *>(QStringLiteral("aboutLibraries"));
        auto *text = dialog->findChild<QPlainTextEdit *>(QStringLiteral("aboutLicence"));
        for (int i = 0; i < list->count(); ++i) {
            list->setCurrentRow(i);
            names += list->item(i)->text().section(u' ', 0, 0);
            allHaveTexts = allHaveTexts && text->toPlainText().size() > 500;
        }
    });
    actionOf(*m_window, "help.about")->trigger();
    QVERIFY(allHaveTexts);
    for (const char *name : {"FlatFitFab", "Qt", "CGAL", "Eigen", "Clipper", "expected", "GMP"})
        QVERIFY2(names.contains(QLatin1String(name)), name);
}

void TestDialogs::aboutIsCopied()
{
    whenShown<QDialog>("aboutDialog", [](QDialog *dialog) {
        dialog->findChild<QPushButton *>(QStringLiteral("aboutCopy"))->click();
    });
    actionOf(*m_window, "help.about")->trigger();
    const QString copied = QGuiApplication::clipboard()->text();
    QVERIFY(copied.contains(QStringLiteral("FlatFitFab " FFF_VERSION)));
    QVERIFY(copied.contains(QLatin1String(qVersion())));
}

void TestDialogs::theStartPageOpensASampleAsACopy()
{
    m_window->showStartPage();
    auto *page = m_window->findChild<StartPage *>();
    QVERIFY(page && page->isVisible());
    auto *card = page->findChild<ModelCard *>(QStringLiteral("sampleCard"));
    QVERIFY(card);
    QTest::keyClick(card, Qt::Key_Return);
    QVERIFY(m_window->bench().session().committed().sectionCount() > 0);
    QVERIFY(!page->isVisible());
    QVERIFY(m_window->files().path().isEmpty()); // saving asks for a name
    QVERIFY(settings().recentFiles().isEmpty());
    QCOMPARE(mainWindows().size(), 1);
}

void TestDialogs::theStartPageNeverCoversAModel()
{
    m_window->bench().session().commit(QStringLiteral("draw"), squareDocument());
    actionOf(*m_window, "help.start")->trigger();
    QCOMPARE(mainWindows().size(), 2);
    QVERIFY(!m_window->findChild<StartPage *>());
}

void TestDialogs::theStartPageListsRecentFiles()
{
    const QString path = m_folder->filePath(QStringLiteral("plate.fff"));
    QVERIFY(io::writeDocument(path, squareDocument()));
    settings().addRecentFile(path);
    settings().addRecentFile(m_folder->filePath(QStringLiteral("gone.fff")));
    m_window->showStartPage();
    auto *page = m_window->findChild<StartPage *>();
    const auto cards = [page] {
        QList<ModelCard *> shown;
        for (auto *card : page->findChildren<ModelCard *>(QStringLiteral("recentCard"))) {
            if (card->isVisible())
                shown += card;
        }
        return shown;
    };
    QTRY_COMPARE(cards().size(), 2);
    QVERIFY(cards()[0]->accessibleName().contains(QStringLiteral("missing")));
    QTest::keyClick(cards()[0], Qt::Key_Delete);
    QTRY_COMPARE(cards().size(), 1);
    QCOMPARE(cards()[0]->text(), QStringLiteral("plate"));
    // Its number of sections comes from a worker, with or without a picture.
    QTRY_VERIFY(cards()[0]->accessibleName().contains(u'1'));
    QTest::mouseClick(cards()[0], Qt::LeftButton);
    QCOMPARE(m_window->files().path(), path);
}

FFF_TEST_WITH(TestDialogs, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    TestDialogs test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_dialogs.moc"
