// The help by real keys: it opens where it tells about what is under the cursor, its headings are
// found by their words, and all keys fit on a page. If this fails, F1 is a guess.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/model/told_names.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "tests/ui/work_folder.h"
#include "ui/actions/action_set.h"
#include "ui/base/theme.h"
#include "ui/base/translations.h"
#include "ui/dialogs/command_search.h"
#include "ui/docks/checks_dock.h"
#include "ui/docks/joint_page.h"
#include "ui/docks/operation_page.h"
#include "ui/docks/physics_dock.h"
#include "ui/docks/templates_dock.h"
#include "ui/help/help_window.h"
#include "ui/help/keys_list.h"
#include "ui/start/sample_texts.h"
#include "ui/window/main_tool_bar.h"
#include "ui/window/windows.h"

#include <QDir>
#include <QListWidget>
#include <QMenuBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>

using namespace fff;
using namespace fff::ui;

namespace {

/// Links of a page that begin so.
QStringList linksOf(const QTextDocument &page, const QString &begin)
{
    QStringList links;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
        for (auto it = block.begin(); !it.atEnd(); ++it)
            if (const QString link = it.fragment().charFormat().anchorHref();
                link.startsWith(begin))
                links += link;
    return links;
}

} // namespace

class TestHelp : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void everyPageHasATitle();
    void topicsAreThere();
    void partsOfTheWindowHaveTheirPages();
    void aHeadingIsScrolledTo();
    void linksHaveTheThemesColour();
    void theKeyOpensIt();
    void theKeyWorksOverADialog();
    void headingsAreFoundByTheirWords();
    void aLessonOpensAsACopy();
    void lessonsCanBeToldInEachLanguage();
    void allKeysAreListed();
    void theKeysFitOnAPage_data();
    void theKeysFitOnAPage();

private:
    QList<ListedAction> actions() const { return listedActions(*m_window->menuBar()); }
    HelpWindow *help() const { return m_window->findChild<HelpWindow *>(); }
    static QString pageOf(const QWidget *help)
    {
        return help->findChild<QTextBrowser *>()->source().fileName();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestHelp::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    workIn(m_folder->path());
    m_window = openWindow();
    m_window->show();
    m_window->bench().session().commit(QStringLiteral("draw"), squareDocument());
}

void TestHelp::cleanup()
{
    closeEverything();
}

void TestHelp::everyPageHasATitle()
{
    for (const QString &page : helpPages()) {
        QVERIFY2(!helpTitle(page).isEmpty(), qPrintable(page));
        QVERIFY2(page == kKeysPage || page == QStringLiteral("more") ||
                     helpHeadings(page).size() >= 4,
                 qPrintable(page));
    }
    QCOMPARE(helpTitle(QStringLiteral("cutting")), QStringLiteral("Cutting"));
}

// Wrong: a page is told to begin at a heading that it has not.
void TestHelp::topicsAreThere()
{
    int told = 0;
    for (const ListedAction &listed : actions()) {
        const HelpTopic topic = topicOf(listed.id.toStdString());
        QVERIFY2(helpPages().contains(topic.page), qPrintable(listed.id));
        QVERIFY2(topic.heading < static_cast<int>(helpHeadings(topic.page).size()),
                 qPrintable(listed.id));
        told += topic.heading >= 0 ? 1 : 0;
    }
    QVERIFY(told > 20);
    // An operation is told about under its own name.
    const auto headingOf = [](const char *command) {
        const HelpTopic topic = topicOf(command);
        return helpHeadings(topic.page).value(topic.heading);
    };
    for (const char *id :
         {"operation.linear", "operation.revolve", "operation.blend", "operation.branch",
          "operation.grid", "operation.radial", "operation.mirror", "operation.rotational",
          "operation.array", "operation.slices"}) {
        const QString name = m_window->findChild<QAction *>(QLatin1String(id))->text().remove(u'&');
        QCOMPARE(headingOf(id), name);
    }
    QCOMPARE(headingOf("fabricate.coupon"), QStringLiteral("The fit coupon"));
    QCOMPARE(headingOf("check.stress"), QStringLiteral("Stress"));
}

void TestHelp::partsOfTheWindowHaveTheirPages()
{
    const auto pageAt = [this](const QWidget *part) { return topicAt(part).page; };
    QCOMPARE(pageAt(m_window->findChild<ChecksDock *>()), QStringLiteral("strength"));
    QCOMPARE(pageAt(m_window->findChild<PhysicsDock *>()), QStringLiteral("strength"));
    QCOMPARE(pageAt(m_window->findChild<TemplatesDock *>()), QStringLiteral("templates"));
    QCOMPARE(pageAt(m_window->findChild<JointPage *>()), QStringLiteral("joints"));
    QCOMPARE(pageAt(m_window->findChild<OperationPage *>()), QStringLiteral("operations"));
    // What lies in them, too; what nobody knows of begins at the beginning.
    const auto *inside = m_window->findChild<PhysicsDock *>()->findChildren<QWidget *>().last();
    QCOMPARE(pageAt(inside), QStringLiteral("strength"));
    QCOMPARE(topicAt(m_window), HelpTopic{QStringLiteral("first_steps")});
    QCOMPARE(topicAt(nullptr), HelpTopic{QStringLiteral("first_steps")});
    const auto *bar = m_window->findChild<MainToolBar *>();
    const auto *grid =
        bar->widgetForAction(m_window->findChild<QAction *>(QStringLiteral("operation.grid")));
    if (grid)
        QCOMPARE(topicAt(grid), (HelpTopic{QStringLiteral("operations"), 4}));
    QCOMPARE(pageAt(bar->findChild<QWidget *>(QStringLiteral("exportButton"))),
             QStringLiteral("cutting"));
    QCOMPARE(topicAt(bar->findChild<QWidget *>(QStringLiteral("toolStock"))),
             (HelpTopic{QStringLiteral("joints"), 1}));
}

void TestHelp::aHeadingIsScrolledTo()
{
    HelpWindow window([this] { return actions(); }, nullptr);
    window.open({QStringLiteral("operations"), 4});
    auto *text = window.findChild<QTextBrowser *>();
    const QString first = text->cursorForPosition({20, 24}).block().text();
    QCOMPARE(first, QStringLiteral("Grid with connectors"));
    QCOMPARE(window.findChild<QListWidget *>()->currentRow(), 1);
    window.open({QStringLiteral("joints")});
    QVERIFY(text->toPlainText().startsWith(QStringLiteral("Joints and fit")));
    QCOMPARE(text->cursorForPosition({20, 24}).block().text(), QStringLiteral("Joints and fit"));
}

// Wrong: blue on black, as the system has links.
void TestHelp::linksHaveTheThemesColour()
{
    settings().setColourScheme(ColourScheme::Dark);
    HelpWindow window([this] { return actions(); }, nullptr);
    const auto *text = window.findChild<QTextBrowser *>();
    const auto check = [&] {
        int links = 0;
        for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next())
            for (auto it = block.begin(); !it.atEnd(); ++it)
                if (it.fragment().charFormat().isAnchor()) {
                    QCOMPARE(it.fragment().charFormat().foreground().color(), theme().accent);
                    ++links;
                }
        QVERIFY(links > 0);
    };
    for (const char *page : {"cutting", "keys", "more"}) {
        window.open({QLatin1String(page)});
        check();
    }
    window.resize(window.width() - 100, window.height()); // the page is read anew
    QTest::qWait(0);
    check();
    QTest::mouseClick(window.findChild<QPushButton *>(QStringLiteral("helpBack")), Qt::LeftButton);
    check();
    settings().setColourScheme(ColourScheme::System);
}

void TestHelp::theKeyOpensIt()
{
    QVERIFY(!help());
    QCursor::setPos({-100, -100}); // over nothing
    m_window->findChild<ChecksDock *>()->setFocus();
    QCOMPARE(actionOf(*m_window, "help.here")->shortcut(), QKeySequence(Qt::Key_F1));
    actionOf(*m_window, "help.here")->trigger();
    QTRY_VERIFY(help() && help()->isVisible());
    QVERIFY(helpPages().contains(QString(pageOf(help())).remove(QStringLiteral(".md"))));
    help()->close();
    actionOf(*m_window, "help.firstSteps")->trigger();
    QCOMPARE(pageOf(help()), QStringLiteral("first_steps.md"));
}

// Wrong: nobody can read what kerf is while the panel asks for it.
void TestHelp::theKeyWorksOverADialog()
{
    inExportPanel(*m_window, [&](QDialog *dialog) {
        QCursor::setPos({-100, -100});
        exportButton(dialog)->setFocus();
        QTest::keyClick(exportButton(dialog), Qt::Key_F1);
        auto *over = dialog->findChild<HelpWindow *>();
        QVERIFY(over && over->isVisible());
        QCOMPARE(pageOf(over), QStringLiteral("cutting.md"));
        // What the dialog is about stays where it is.
        Q_EMIT over->findChild<QTextBrowser *>()->anchorClicked(
            QUrl(QStringLiteral("lesson:2_shelf_start")));
        QCOMPARE(mainWindows().size(), 2);
        QCOMPARE(m_window->bench().session().model().sectionCount(), std::size_t(1));
        over->close();
        QVERIFY(dialog->isVisible());
    });
}

void TestHelp::headingsAreFoundByTheirWords()
{
    const auto found = [this](const char *words) {
        return foundActions(QLatin1String(words), actions());
    };
    const auto has = [](const QList<ListedAction> &list, const char *name) {
        return std::any_of(list.begin(), list.end(), [name](const ListedAction &one) {
            return one.name == QLatin1String(name);
        });
    };
    QVERIFY(has(found("kerf"), "Help: Kerf"));
    QVERIFY(has(found("pull mesh"), "Help: Pull the mesh in"));
    // A command of that name comes before what is told about it.
    QCOMPARE(found("linear").front().id, QStringLiteral("operation.linear"));
    for (const ListedAction &one : found("help: kerf"))
        if (one.name == QStringLiteral("Help: Kerf")) {
            one.action->trigger();
            break;
        }
    QVERIFY(help() && help()->isVisible());
    QCOMPARE(pageOf(help()), QStringLiteral("cutting.md"));
}

// Wrong: a teacher clicks on the starting file, and the page is empty or the model is the
// program's own.
void TestHelp::aLessonOpensAsACopy()
{
    actionOf(*m_window, "help.firstSteps")->trigger();
    help()->open({QStringLiteral("lessons")});
    auto *text = help()->findChild<QTextBrowser *>();
    const QStringList links = linksOf(*text->document(), QStringLiteral("lesson:"));
    QCOMPARE(links.size(), 6);
    for (const QString &link : links)
        QVERIFY2(QFile::exists(QStringLiteral(":/lessons/%1.fff").arg(link.section(u':', 1))),
                 qPrintable(link));
    const qsizetype before = mainWindows().size();
    Q_EMIT text->anchorClicked(QUrl(links.front()));
    QCOMPARE(mainWindows().size(), before + 1); // beside what was being done
    MainWindow *opened = nullptr;
    for (MainWindow *window : mainWindows())
        if (window != m_window)
            opened = window;
    QVERIFY(opened);
    QCOMPARE(opened->bench().session().model().sectionCount(), std::size_t(1));
    QVERIFY(opened->files().path().isEmpty()); // saved by whoever opened it, as a file of their own
    QCOMPARE(opened->files().name(), QStringLiteral("1_toy_animal_start.fff"));
    QCOMPARE(pageOf(help()), QStringLiteral("lessons.md")); // it is read beside the model
}

// Wrong: a window in Japanese with "Front legs" in it.
void TestHelp::lessonsCanBeToldInEachLanguage()
{
    const QStringList known = sampleTexts();
    for (const QString &file : QDir(QStringLiteral(":/lessons")).entryList()) {
        const auto loaded = io::readDocument(QStringLiteral(":/lessons/") + file);
        QVERIFY2(loaded, qPrintable(file));
        withNamesTold(loaded->document, [&](const std::string &name) {
            if (!known.contains(QString::fromStdString(name)))
                QTest::qFail(name.c_str(), __FILE__, __LINE__);
            return name;
        });
    }
}

void TestHelp::allKeysAreListed()
{
    const QList<KeyGroup> groups = keyGroups(actions());
    QStringList keys;
    for (const KeyGroup &group : groups)
        for (const auto &[what, key] : group.rows)
            keys += key;
    for (const ListedAction &listed : actions())
        if (!listed.action->shortcut().isEmpty())
            QVERIFY2(keys.contains(listed.action->shortcut().toString(QKeySequence::NativeText)),
                     qPrintable(listed.name));
    QVERIFY(keysHtml(groups).contains(QStringLiteral("Ctrl+Z")));
    HelpWindow window([this] { return actions(); }, nullptr);
    window.open({kKeysPage});
    auto *text = window.findChild<QTextBrowser *>();
    QVERIFY(text->toPlainText().contains(QStringLiteral("Ctrl+Z")));
    QCOMPARE(window.findChild<QListWidget *>()->currentRow(),
             static_cast<int>(helpPages().size()) - 1);
}

void TestHelp::theKeysFitOnAPage_data()
{
    QTest::addColumn<int>("more");
    QTest::newRow("as they are") << 0;
    QTest::newRow("many more") << 60;
}

void TestHelp::theKeysFitOnAPage()
{
    QFETCH(int, more);
    QList<KeyGroup> groups = keyGroups(actions());
    for (int i = 0; i < more; ++i)
        groups.back().rows += {QStringLiteral("Another thing that can be done %1").arg(i),
                               QStringLiteral("Ctrl+Alt+%1").arg(i)};
    const QString path = m_folder->filePath(QStringLiteral("keys.pdf"));
    QVERIFY(writeCheatSheet(path, groups));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.startsWith("%PDF"));
    QCOMPARE(bytes.count("/Type /Page\n"), 1);
    QVERIFY(!writeCheatSheet(m_folder->filePath(QStringLiteral("nowhere/keys.pdf")), groups));
}

FFF_TEST_WITH(TestHelp, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestHelp test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_help.moc"
