// The help: pages with pictures that are part of the program, read beside the model, with a list of
// them at the left.
#pragma once

#include "ui/actions/action_finder.h"
#include "ui/help/help_pages.h"

#include <QDialog>

#include <functional>

class QListWidget;
class QTextBrowser;

namespace fff::ui {

class HelpWindow : public QDialog
{
    Q_OBJECT
public:
    /// What there is to be done, with its keys.
    using Actions = std::function<QList<ListedAction>()>;

    HelpWindow(Actions actions, QWidget *parent);

    /// In the window's language where there is such a page.
    void open(const HelpTopic &topic);

Q_SIGNALS:
    /// A link to a lesson's file was followed: :/lessons/…
    void lessonChosen(const QString &path);

private:
    void show(const HelpTopic &topic);
    void follow(const QUrl &link);
    void markPage(const QUrl &address);
    void saveCheatSheet();

    const Actions m_actions;
    QListWidget *m_pages = nullptr;
    QTextBrowser *m_text = nullptr;
};

} // namespace fff::ui
