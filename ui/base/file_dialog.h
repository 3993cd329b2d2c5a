// A file dialog in the theme's colours, with all its parts. Where the desktop has one of its own,
// that is shown instead.
#pragma once

#include <QFileDialog>

namespace fff::ui {

/// Where people keep what they make: their documents, or their home where there is no such folder.
QString documentsFolder();

class FileDialog : public QFileDialog
{
public:
    FileDialog(QWidget *parent, const QString &title, const QString &folder,
               const QString &filter = {});

protected:
    void showEvent(QShowEvent *event) override;
};

} // namespace fff::ui
