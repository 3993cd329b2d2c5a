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

    /// What is to be written, asked for until it is said; empty where nothing is. Its name ends as
    /// one of the filters says, or else in the default suffix.
    QString target();

protected:
    /// Asks whether to replace what has the name that is then written, not the one that was typed.
    void accept() override;
    void showEvent(QShowEvent *event) override;

private:
    bool isOfItsKinds(const QString &path) const;
};

} // namespace fff::ui
