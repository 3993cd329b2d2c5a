// About: what this is, what it is built with and under which licences, and the versions that a bug
// report needs, ready to be copied.
#pragma once

#include <QDialog>

class QPlainTextEdit;

namespace fff::ui {

class AboutDialog : public QDialog
{
    Q_OBJECT
public:
    explicit AboutDialog(QWidget *parent);

private:
    QWidget *makeHead();
    QWidget *makeVersions();
    QWidget *makeLicences();
    QPlainTextEdit *makeText(const char *name, const QString &accessibleName);
};

} // namespace fff::ui
