// Every page, bar, dialog and menu in every language in the least window, in English and German in
// the usual one and on a screen of 200 %, too: all words can be read to their end.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/joint_ref.h"
#include "core/model/lettering.h"
#include "core/model/load_edits.h"
#include "core/model/marks.h"
#include "core/model/operation_edits.h"
#include "core/session/check_list.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"
#include "tests/ui/cut_text.h"
#include "tests/ui/dialogs/export_hand.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/field_style.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/properties/property_rows.h"
#include "ui/settings/languages.h"
#include "ui/window/main_tool_bar.h"

#include <QDockWidget>
#include <QJsonDocument>
#include <QLibraryInfo>
#include <QMenuBar>
#include <QProcess>
#include <QScreen>
#include <QTranslator>

#include <functional>
#include <string_view>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace fff::test {

/// The window speaks and counts in it for as long as this lives.
class SpokenLanguage
{
public:
    explicit SpokenLanguage(const QString &code)
    {
        QLocale::setDefault(code == QStringLiteral("en")
                                ? QLocale(QLocale::English, QLocale::UnitedKingdom)
                                : QLocale(code));
        m_isLoaded = m_ours.load(QStringLiteral(":/i18n/flatfitfab_") + code);
        if (m_qts.load(QStringLiteral("qtbase_") + code,
                       QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            QCoreApplication::installTranslator(&m_qts);
        QCoreApplication::installTranslator(&m_ours);
    }
    ~SpokenLanguage()
    {
        QCoreApplication::removeTranslator(&m_ours);
        QCoreApplication::removeTranslator(&m_qts);
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    }
    bool isLoaded() const { return m_isLoaded; }

private:
    QTranslator m_ours, m_qts;
    bool m_isLoaded = false;
};

} // namespace fff::test

namespace {

constexpr int kLowScreen = 600; // px that every dialog works in
constexpr int kPatience = 10;   // looks at what is still moved about

/// A body across which a plate stands, with a hole and engraved words, and what loads there are.
Document furnishedCross()
{
    Document document = newDocument();
    const SectionId body =
        add(document, "Body",
            shapeOf(*Contour::fromPolygon({{-60, 0}, {60, 0}, {60, 60}, {-60, 60}}),
                    {*Contour::fromPolygon({{-40, 20}, {-40, 30}, {-30, 30}, {-30, 20}})}),
            frontFrame());
    add(document, "Front legs",
        shapeOf(*Contour::fromPolygon({{-50, 0}, {50, 0}, {50, 60}, {-50, 60}})),
        sideFrame({20, 0, 0}));
    document =
        *addMark(document, body, *letteredMark({"Rex", 8.0, {0, 40}, 0.0}, Mark::Kind::Engraved));
    Load glass{{}, document.sections.front()->ref(), Vec2(-20, 50), 1.25};
    glass.preset = "glass";
    document = *addLoad(document, glass);
    Load push{{}, document.sections.back()->ref(), Vec2(0, 30)};
    push.kind = LoadKind::Push;
    push.push = Vec3(0, 12.5, 0);
    return *addLoad(document, push);
}

/// One of each kind, with the choice of this place for each that it has.
Document withOperation(const OperationKind &kind, std::size_t choice)
{
    FishBones bones;
    Operation made = newOperation(kind);
    made.name = kind.name;
    for (const InputSpec &input : kind.inputs) {
        made.inputs[input.role].push_back({SectionRef(bones.rib), {}});
        if (input.most > 1)
            made.inputs[input.role].push_back({SectionRef(bones.spine), {}});
    }
    for (const ParameterSpec &spec : kind.parameters)
        if (spec.unit == ParameterSpec::Unit::Choice)
            made.parameters[spec.key] =
                std::string(spec.choices[std::min(choice, spec.choices.size() - 1)].key);
    return addOperation(bones.document, made);
}

void unfold(QWidget &top)
{
    for (QWidget *widget : top.findChildren<QWidget *>())
        if (auto *group = dynamic_cast<PropertyGroup *>(widget))
            group->fold(false);
}

} // namespace

class TestNothingIsCut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void pages_data() { looks(true); }
    void pages();
    void operations_data() { looks(true); }
    void operations();
    void dialogs_data() { looks(true); }
    void dialogs();
    void menus_data() { looks(true); }
    void menus();
    void samples_data() { looks(false); }
    void samples();
    void theBarKeepsItsWords_data();
    void theBarKeepsItsWords();
    void twiceTheScale();

private:
    /// inAll  also in the languages beside English and German, in the least window, where words have
    /// least room
    static void looks(bool inAll);
    void open();
    void look(const QString &state) { look(state, *m_window); }
    void look(const QString &state, QWidget &top);
    void showDock(const char *name);
    void tell();
    Workbench &bench() { return m_window->bench(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SpokenLanguage> m_language;
    QFont m_font;
    MainWindow *m_window = nullptr;
    std::map<QString, QString> m_cuts; // what is cut, and where it was seen first
};

void TestNothingIsCut::looks(bool inAll)
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (const QString &language : languagesThere()) {
        const auto row = [&language](const QSize &size) {
            QTest::newRow(qPrintable(QStringLiteral("%1, %2 × %3")
                                         .arg(language)
                                         .arg(size.width())
                                         .arg(size.height())))
                << language << size;
        };
        const bool isMain = language == QStringLiteral("en") || language == QStringLiteral("de");
        if (isMain || (inAll && !qEnvironmentVariableIsSet("QT_SCALE_FACTOR")))
            row({1024, 640});
        if (isMain)
            row({1440, 900});
    }
}

void TestNothingIsCut::init()
{
    m_font = QApplication::font();
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_cuts.clear();
}

void TestNothingIsCut::cleanup()
{
    closeEverything();
    m_window = nullptr;
    m_language.reset();
    QApplication::setFont(m_font);
}

void TestNothingIsCut::open()
{
    QFETCH(QString, language);
    QFETCH(QSize, size);
    m_language = std::make_unique<SpokenLanguage>(language);
    QVERIFY(m_language->isLoaded());
    QFont font = m_font;
    font.setPointSizeF(10.0);
    QApplication::setFont(font);
    m_window = openWindow();
    m_window->resize(size);
    m_window->resetLayout();
    QTest::qWait(20);
    QCOMPARE(m_window->size(), size);
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

void TestNothingIsCut::showDock(const char *name)
{
    auto *dock = m_window->findChild<QDockWidget *>(QLatin1String(name));
    if (dock->isHidden())
        dock->toggleViewAction()->trigger();
    dock->raise();
}

void TestNothingIsCut::tell()
{
    // One by one: Qt Test cuts a long message itself.
    for (const auto &[cut, state] : m_cuts)
        qWarning("%s: %s", qPrintable(state), qPrintable(cut));
    QVERIFY2(m_cuts.empty(), qPrintable(QStringLiteral("%1 texts are cut").arg(m_cuts.size())));
}

// Wrong: a word of a dock, a bar or the status line ends at an edge.
void TestNothingIsCut::pages()
{
    open();
    look(QStringLiteral("empty"));
    bench().session().reset(furnishedCross());
    bench().session().currentAnalysis();
    m_window->findChild<CheckList *>()->finish();
    for (const char *dock : {"outlineDock", "historyDock", "libraryDock", "checksDock",
                             "physicsDock", "propertiesDock", "sheetsDock"}) {
        showDock(dock);
        look(QLatin1String(dock));
    }
    const Model &model = bench().session().committed();
    bench().select({model.ref(0)});
    look(QStringLiteral("a section"));
    bench().select({model.ref(0), model.ref(1)});
    look(QStringLiteral("two sections"));
    bench().selectJoint(JointRef(model.ref(0), model.ref(1)));
    look(QStringLiteral("a joint"));
    for (const Load &load : model.document.loads) {
        bench().selectLoad(load.id);
        look(QStringLiteral("a load"));
    }
    bench().select({model.ref(0)});
    for (const char *id : {"section.transform", "section.addCircle", "section.addStar",
                           "section.pen", "section.mark", "measure.ruler", "measure.dimension",
                           "edit.mirror", "physics.addWeight", "physics.addPush"}) {
        bench().run(QLatin1String(id));
        look(QLatin1String(id));
        bench().layDownTool();
    }
    m_window->resetLayout();
    bench().session().reset(newDocument());
    m_window->showStartPage();
    look(QStringLiteral("the start page"));
    tell();
}

void TestNothingIsCut::operations()
{
    open();
    showDock("propertiesDock");
    for (const OperationKind *kind : operationKinds()) {
        std::size_t most = 1;
        for (const ParameterSpec &spec : kind->parameters)
            most = std::max(most, spec.choices.size());
        for (std::size_t choice = 0; choice < most; ++choice) {
            bench().session().reset(withOperation(*kind, choice));
            bench().selectOperation(bench().session().committed().document.operations.front()->id);
            look(QStringLiteral("%1 %2").arg(QLatin1String(kind->key)).arg(choice));
        }
        bench().session().reset(FishBones().document);
        bench().run(QStringLiteral("operation.") + QLatin1String(kind->key));
        look(QStringLiteral("%1 asks").arg(QLatin1String(kind->key)));
        bench().layDownTool();
    }
    tell();
}

void TestNothingIsCut::dialogs()
{
    open();
    bench().session().reset(furnishedCross());
    using Page = SettingsDialog::Page;
    for (const Page page : {Page::General, Page::View, Page::Checks, Page::Files, Page::Keyboard}) {
        SettingsDialog dialog(listedActions(*m_window->menuBar()), m_window);
        dialog.showPage(page);
        dialog.show();
        look(QStringLiteral("settings %1").arg(static_cast<int>(page)), dialog);
        QVERIFY(dialog.height() <= kLowScreen);
    }
    for (const auto &[command, name] : {std::pair("fabricate.stocks", "stockEditor"),
                                        std::pair("help.firstSteps", "helpWindow")}) {
        actionOf(*m_window, command)->trigger();
        auto *dialog = m_window->findChild<QDialog *>(QLatin1String(name));
        QVERIFY2(dialog && dialog->isVisible(), name);
        look(QLatin1String(name), *dialog);
        QVERIFY2(dialog->minimumSizeHint().height() <= kLowScreen, name);
        QVERIFY2(dialog->height() <= kLowScreen || command != std::string_view("fabricate.stocks"),
                 "Stocks open higher than they need");
        dialog->close();
    }
    actionOf(*m_window, "edit.find")->trigger();
    look(QStringLiteral("search"));
    whenShown<QDialog>("aboutDialog",
                       [this](QDialog *dialog) { look(QStringLiteral("about"), *dialog); });
    actionOf(*m_window, "help.about")->trigger();
    inExportPanel(*m_window, [this](QDialog *dialog) {
        look(QStringLiteral("export"), *dialog);
        QVERIFY(dialog->minimumSizeHint().height() <= kLowScreen);
    });
    tell();
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

// Wrong: letters of a screen of 200 % are a little wider than twice those of 100 %.
void TestNothingIsCut::twiceTheScale()
{
    if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
        QSKIP("the scale is set from outside: this would start itself again");
    QProcess again;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("2"));
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

FFF_TEST_WITH(TestNothingIsCut, [](int argc, char *argv[]) {
    // The screen that the platform without a display has is too small for the windows here.
    const QTemporaryDir folder;
    QFile screen(folder.filePath(QStringLiteral("screen.json")));
    if (screen.open(QIODevice::WriteOnly)) {
        screen.write(R"({"screens": [{"name": "large", "x": 0, "y": 0, "width": 3840,
            "height": 2400, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})");
        screen.close();
    }
    if (qgetenv("QT_QPA_PLATFORM") == "offscreen")
        qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + QFile::encodeName(screen.fileName()));
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication::setStyle(new FieldStyle);
    TestNothingIsCut test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_nothing_is_cut.moc"
