// The help: pages with pictures that are part of the program, read beside the model.
#pragma once

#include <QDialog>

class QTextBrowser;

namespace fff::ui {

class HelpWindow : public QDialog
{
    Q_OBJECT
public:
    explicit HelpWindow(QWidget *parent);

    /// In the window's language where there is such a page.
    /// page   its name, such as "first_steps"
    void open(const QString &page);

private:
    QTextBrowser *m_text = nullptr;
};

} // namespace fff::ui
