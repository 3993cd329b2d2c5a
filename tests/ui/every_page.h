// Every page, bar and dialog of the window, one after the other, for whoever looks at all of them:
// what is in sight is handed to look().
#pragma once

#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/joint_ref.h"
#include "core/model/lettering.h"
#include "core/model/load_edits.h"
#include "core/model/marks.h"
#include "core/model/operation_edits.h"
#include "core/session/check_list.h"
#include "tests/core/operations/operation_models.h"
#include "tests/ui/dialogs/export_hand.h"
#include "tests/ui/window_fixture.h"
#include "ui/base/field_style.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/properties/property_rows.h"

#include <QDockWidget>
#include <QLibraryInfo>
#include <QMenuBar>
#include <QTranslator>

#include <string_view>

namespace fff::test {

using namespace fff::ui;

constexpr int kLowScreen = 600; // px that every dialog works in

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

/// A body across which a plate stands, with a hole and engraved words, and what loads there are.
inline Document furnishedCross()
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
inline Document withOperation(const OperationKind &kind, std::size_t choice)
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

inline void unfold(QWidget &top)
{
    for (QWidget *widget : top.findChildren<QWidget *>())
        if (auto *group = dynamic_cast<PropertyGroup *>(widget))
            group->fold(false);
}

class EveryPage
{
public:
    virtual ~EveryPage() = default;

protected:
    void openWith(const QString &language, const QSize &size);
    void closeAll();

    void showPages();
    void showOperations();
    void showDialogs();
    void showDock(const char *name);

    void look(const QString &state) { look(state, *m_window); }
    /// All groups in it are unfolded.
    virtual void look(const QString &state, QWidget &top) = 0;
    Workbench &bench() { return m_window->bench(); }

    MainWindow *m_window = nullptr;

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SpokenLanguage> m_language;
    QFont m_font;
};

/// With settings of its own.
inline void EveryPage::openWith(const QString &language, const QSize &size)
{
    m_font = QApplication::font();
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
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

inline void EveryPage::closeAll()
{
    closeEverything();
    m_window = nullptr;
    m_language.reset();
    QApplication::setFont(m_font);
}

inline void EveryPage::showDock(const char *name)
{
    auto *dock = m_window->findChild<QDockWidget *>(QLatin1String(name));
    if (dock->isHidden())
        dock->toggleViewAction()->trigger();
    dock->raise();
}

inline void EveryPage::showPages()
{
    look(QStringLiteral("empty"));
    bench().session().reset(furnishedCross());
    bench().session().currentAnalysis();
    m_window->findChild<CheckList *>()->finish();
    for (const char *dock :
         {"outlineDock", "historyDock", "libraryDock", "checksDock", "physicsDock",
          "propertiesDock", "templatesDock", "valuesDock", "sheetsDock"}) {
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
}

inline void EveryPage::showOperations()
{
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
}

inline void EveryPage::showDialogs()
{
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
}

/// A program with a screen that is large enough, since that of the platform without a display is
/// not.
template <class Test>
int runOnLargeScreen(int argc, char *argv[])
{
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
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace fff::test
