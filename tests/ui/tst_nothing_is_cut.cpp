// Every page, bar, dialog and menu in every language in the least window, in English and German in
// the usual one and on screens of 200 % and 300 %, too: all words can be read to their end.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/cut_text.h"
#include "tests/ui/every_page.h"
#include "ui/settings/languages.h"
#include "ui/window/main_tool_bar.h"

#include <QProcess>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

constexpr int kPatience = 10; // looks at what is still moved about

} // namespace

class TestNothingIsCut : public QObject, private EveryPage
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_cuts.clear(); }
    void cleanup() { closeAll(); }

    void pages_data() { looks(true); }
    /// Wrong: a word of a dock, a bar or the status line ends at an edge.
    void pages() { openAnd(&TestNothingIsCut::showPages); }
    void operations_data() { looks(true); }
    void operations() { openAnd(&TestNothingIsCut::showOperations); }
    void dialogs_data() { looks(true); }
    void dialogs() { openAnd(&TestNothingIsCut::showDialogs); }
    void menus_data() { looks(true); }
    void menus();
    void samples_data() { looks(false); }
    void samples();
    void theBarKeepsItsWords_data();
    void theBarKeepsItsWords();
    void scaled_data();
    void scaled();

private:
    /// inAll  also in the languages beside English and German, in the least window, where words
    /// have least room
    static void looks(bool inAll);
    void open();
    void openAnd(void (TestNothingIsCut::*show)())
    {
        open();
        (this->*show)();
        tell();
    }
    using EveryPage::look;
    void look(const QString &state, QWidget &top) override;
    void tell();

    std::map<QString, QString> m_cuts; // what is cut, and where it was seen first
};

void TestNothingIsCut::looks(bool inAll)
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (const QString &language : languagesThere()) {
        const auto row = [&language](const QSize &size) {
            QTest::newRow(qPrintable(
                QStringLiteral("%1, %2 × %3").arg(language).arg(size.width()).arg(size.height())))
                << language << size;
        };
        const bool isMain = language == QStringLiteral("en") || language == QStringLiteral("de");
        if (isMain || (inAll && !qEnvironmentVariableIsSet("QT_SCALE_FACTOR")))
            row({1024, 640});
        if (isMain && qgetenv("QT_SCALE_FACTOR") != "3") // of 4K 1280 × 720 are left then
            row({1440, 900});
    }
}

void TestNothingIsCut::open()
{
    QFETCH(QString, language);
    QFETCH(QSize, size);
    openWith(language, size);
}

void TestNothingIsCut::look(const QString &state, QWidget &top)
{
    unfold(top);
    // What came in is laid out by and by.
    QStringList cuts;
    for (int i = 0; i < kPatience && (i == 0 || !cuts.isEmpty()); ++i) {
        QTest::qWait(20);
        cuts = cutTexts(top);
    }
    for (const QString &cut : std::as_const(cuts))
        m_cuts.emplace(cut, state);
}

void TestNothingIsCut::tell()
{
    // One by one: Qt Test cuts a long message itself.
    for (const auto &[cut, state] : m_cuts)
        qWarning("%s: %s", qPrintable(state), qPrintable(cut));
    QVERIFY2(m_cuts.empty(), qPrintable(QStringLiteral("%1 texts are cut").arg(m_cuts.size())));
}

// Wrong: a menu that is longer than the window, or whose heads find no place beside each other.
void TestNothingIsCut::menus()
{
    open();
    QFETCH(QSize, size);
    for (QMenu *menu : m_window->menuBar()->findChildren<QMenu *>()) {
        if (!menu->menuAction()->isVisible())
            continue; // one that is only searched
        const QSize needs = menu->sizeHint();
        if (needs.width() > size.width() || needs.height() > size.height() - 40)
            m_cuts.emplace(menu->title(),
                           QStringLiteral("%1 × %2").arg(needs.width()).arg(needs.height()));
    }
    int right = 0;
    for (const QAction *action : m_window->menuBar()->actions())
        right = std::max(
            right, m_window->menuBar()->actionGeometry(const_cast<QAction *>(action)).right());
    QVERIFY(right < size.width());
    tell();
}

// Wrong: a real model's names, numbers and verdicts do not fit where a made one's do.
void TestNothingIsCut::samples()
{
    open();
    for (const char *sample : {"cutlery_man", "acrylic_thin_three", "bridge"}) {
        const QString path =
            QStringLiteral(FFF_SAMPLES "/") + QLatin1String(sample) + QStringLiteral(".fff");
        QVERIFY(m_window->files().openFile(path));
        bench().session().currentAnalysis();
        m_window->findChild<CheckList *>()->finish();
        for (const char *dock : {"outlineDock", "checksDock", "physicsDock", "propertiesDock"}) {
            showDock(dock);
            look(QLatin1String(sample) + QStringLiteral(", ") + QLatin1String(dock));
        }
        bench().select({bench().session().committed().ref(0)});
        look(QLatin1String(sample) + QStringLiteral(", a section"));
    }
    tell();
}

void TestNothingIsCut::theBarKeepsItsWords_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (const QString &language : languagesThere())
        QTest::newRow(qPrintable(language)) << language << QSize(1440, 900);
}

// Wrong: a row of signs that only those know who do not need their words.
void TestNothingIsCut::theBarKeepsItsWords()
{
    open();
    const auto *bar = m_window->findChild<MainToolBar *>();
    QVERIFY(bar->toolButtonStyle() == Qt::ToolButtonTextUnderIcon);
    bench().session().reset(furnishedCross());
    bench().select({bench().session().committed().ref(0)});
    QTest::qWait(20);
    QVERIFY(bar->toolButtonStyle() == Qt::ToolButtonTextUnderIcon);
    look(QStringLiteral("with a section"));
    tell();
}

void TestNothingIsCut::scaled_data()
{
    QTest::addColumn<QString>("scale");
    for (const char *scale : {"2", "3"})
        QTest::newRow(scale) << QString::fromLatin1(scale);
}

// Wrong: letters of a screen of 200 % are a little wider than twice those of 100 %.
void TestNothingIsCut::scaled()
{
    QFETCH(QString, scale);
    if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
        QSKIP("the scale is set from outside: this would start itself again");
    QProcess again;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), scale);
    again.setProcessEnvironment(environment);
    again.setProcessChannelMode(QProcess::MergedChannels);
    // The program's arguments are the test's name and what is asked of it.
    again.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("tst_nothing_is_cut"), QStringLiteral("-maxwarnings"),
                 QStringLiteral("0"), QStringLiteral("pages"), QStringLiteral("operations"),
                 QStringLiteral("dialogs"), QStringLiteral("samples")});
    QVERIFY2(again.waitForFinished(-1), qPrintable(again.errorString()));
    QVERIFY2(again.exitCode() == 0, again.readAll().constData());
}

FFF_TEST_WITH(TestNothingIsCut, runOnLargeScreen<TestNothingIsCut>)
#include "tst_nothing_is_cut.moc"
