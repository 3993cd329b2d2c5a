// The window: puts view, docks, bars and actions together and hands their wishes on.
#pragma once

#include <QMainWindow>

class QPushButton;

namespace fff::ui {

class ActionSet;
class ChoiceBox;
class DocumentFiles;
class MessageBar;
class OutlineDock;
class PropertiesDock;
class StatusLine;
class Viewport;
class Workbench;

class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    Workbench &bench() { return *m_bench; }
    DocumentFiles &files() { return *m_files; }

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
    void makeToolBar();
    void addCommands();
    void run(const QString &id);
    void setDocksHidden(bool hidden);
    void showAbout();
    void refreshTheme();
    void foldToolBar();

    Workbench *m_bench = nullptr;
    ActionSet *m_actions = nullptr;
    MessageBar *m_messages = nullptr;
    QWidget *m_view = nullptr; // the viewport, or what stands there without OpenGL
    OutlineDock *m_outline = nullptr;
    PropertiesDock *m_properties = nullptr;
    StatusLine *m_status = nullptr;
    DocumentFiles *m_files = nullptr;
    QToolBar *m_toolBar = nullptr;
    ChoiceBox *m_stock = nullptr;
    QPushButton *m_export = nullptr;
    QByteArray m_beforeHiding; // where the docks were
    bool m_wasShown = false;
};

} // namespace fff::ui
