// The settings, in groups. Whatever can be followed at once is; there is nothing to confirm.
#pragma once

#include "ui/actions/action_finder.h"

#include <QDialog>

class QFormLayout;
class QListWidget;
class QStackedWidget;

namespace fff::ui {

class SettingsForm;

class SettingsDialog : public QDialog
{
    Q_OBJECT
public:
    enum class Page { General, View, Checks, Files, Keyboard };

    /// actions  those that the page of the shortcuts lists
    SettingsDialog(const QList<ListedAction> &actions, QWidget *parent);

    void showPage(Page page);

private:
    void addPage(const QString &name, const QString &icon, QWidget *content);
    QWidget *makeGeneral();
    QWidget *makeView();
    QWidget *makeChecks();
    void addStrength(SettingsForm &form);
    QWidget *makeFiles();

    QListWidget *m_groups = nullptr;
    QStackedWidget *m_pages = nullptr;
};

} // namespace fff::ui
