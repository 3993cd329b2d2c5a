// The window: puts view, docks, bars and actions together and hands their wishes on.
#pragma once

#include <QMainWindow> // first: moc stumbles over some standard headers

#include "core/base/ids.h"

namespace fff {
class CheckList;
}

class QMenu;
class QStackedWidget;

namespace fff::ui {

class ActionSet;
class AdjustBar;
class WindowScope;
class Badges;
class ViewChips;
struct MeshImported;
class CanvasBar;
class ChecksDock;
class DocumentFiles;
class FirstSections;
class HelpWindow;
struct HelpTopic;
class HistoryDock;
class LibraryDock;
class TemplatesDock;
class MainToolBar;
class MessageBar;
class OutlineDock;
class PhysicsDock;
class PropertiesDock;
class SheetsDock;
class StatusLine;
class StepsExport;
class StepsView;
class StockEditor;
class TourGuide;
class UnsavedWork;
class ValuesDock;
class Viewport;
class WindowLayout;
class Workbench;

class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    Workbench &bench() { return *m_bench; }
    DocumentFiles &files() { return *m_files; }

    /// The document in the middle of the window, or in its place the start page, which is never
    /// over a model: with one, another window is opened for it.
    void showDocument();
    void showStartPage();
    /// What a crash left: rows of the start page where that is shown, else a message. Once, at
    /// start.
    void offerRecovered();
    /// What it left and cannot be read: the same as a message.
    void tellUnreadable();
    /// In this window while nothing was done in it, else in a new one.
    void recover(const QString &id);
    /// Closes without the question about unsaved changes, which was asked already.
    void closeUnasked();

    /// Opens models, and adds what other files hold to the model of this window.
    void take(const QStringList &paths, bool asCopy = false);

    /// Every panel where it is at first, for the window's present width.
    void resetLayout();

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool focusNextPrevChild(bool next) override;
    void showEvent(QShowEvent *event) override;
    bool event(QEvent *event) override;

private:
    void makeView();
    void makeDocks();
    void makeMenus();
    void addCommands();
    void importDrawing(const QString &command);
    void readDrawing(const QString &command, const QString &path);
    void addMesh();
    void readMesh(const QString &path);
    void refill(TemplateId id, const QString &path, bool isLinked);
    bool pastePicture();
    void tellImported(const MeshImported &imported);
    void connectTemplates();
    void makeScope();
    void makeTour();
    void startTour();
    bool isOnlyAdjusted();
    void run(const QString &id);
    void openFiles(const QStringList &paths);
    /// The stock editor with this stock; an invalid one: that of the next section.
    void showStocks(StockId stock, const QString &field = {});
    void showHelp(const HelpTopic &topic, QWidget *over = nullptr);
    void showHelpHere();
    void addHelpPages(QMenu *menu);
    void refreshTheme();

    Workbench *m_bench = nullptr;
    ActionSet *m_actions = nullptr;
    MessageBar *m_messages = nullptr;
    QWidget *m_view = nullptr; // the viewport, or what stands there without OpenGL
    CheckList *m_checkList = nullptr;
    FirstSections *m_firstSections = nullptr;
    OutlineDock *m_outline = nullptr;
    HistoryDock *m_history = nullptr;
    LibraryDock *m_library = nullptr;
    TemplatesDock *m_templates = nullptr;
    ChecksDock *m_checks = nullptr;
    PhysicsDock *m_physics = nullptr;
    PropertiesDock *m_properties = nullptr;
    SheetsDock *m_sheets = nullptr;
    ValuesDock *m_values = nullptr;
    Badges *m_badges = nullptr;
    ViewChips *m_viewChips = nullptr;
    CanvasBar *m_bar = nullptr;   // numbers for the tool in the hand
    StepsView *m_steps = nullptr; // of the assembly
    StepsExport *m_stepsExport = nullptr;
    TourGuide *m_tour = nullptr;
    // Once they were asked for.
    StockEditor *m_stocks = nullptr;
    HelpWindow *m_help = nullptr;
    StatusLine *m_status = nullptr;
    DocumentFiles *m_files = nullptr;
    MainToolBar *m_toolBar = nullptr;
    AdjustBar *m_adjustBar = nullptr;
    WindowScope *m_scope = nullptr;
    WindowLayout *m_layout = nullptr;
    QStackedWidget *m_middle = nullptr; // the view, or the start page
    UnsavedWork *m_unsaved = nullptr;
    bool m_wasShown = false;
    bool m_mayClose = false;
};

} // namespace fff::ui
