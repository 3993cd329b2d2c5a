// The window: puts view, docks, bars and actions together and hands their wishes on.
#pragma once

#include <QMainWindow>

class QStackedWidget;

namespace fff::ui {

class ActionSet;
class DocumentFiles;
class MainToolBar;
class MessageBar;
class OutlineDock;
class PropertiesDock;
class StatusLine;
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
    /// Closes without the question about unsaved changes, which was asked already.
    void closeUnasked();

    /// Every panel where it is at first, for the window's present width.
    void resetLayout();

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    bool event(QEvent *event) override;

private:
    void makeView();
    void makeMenus();
    void addCommands();
    void run(const QString &id);
    void openFiles(const QStringList &paths);
    void refreshTheme();

    Workbench *m_bench = nullptr;
    ActionSet *m_actions = nullptr;
    MessageBar *m_messages = nullptr;
    QWidget *m_view = nullptr; // the viewport, or what stands there without OpenGL
    OutlineDock *m_outline = nullptr;
    PropertiesDock *m_properties = nullptr;
    StatusLine *m_status = nullptr;
    DocumentFiles *m_files = nullptr;
    MainToolBar *m_toolBar = nullptr;
    WindowLayout *m_layout = nullptr;
    QStackedWidget *m_middle = nullptr; // the view, or the start page
    bool m_wasShown = false;
    bool m_mayClose = false;
};

} // namespace fff::ui
