// A folder of one's own parts, as cards with pictures: a click adds one to the model. What is
// selected can be put there.
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "ui/cards/thumbnails.h"

#include <QFileSystemWatcher>

#include <map>

class QLabel;

namespace fff::ui {

class CardGrid;
class ModelCard;
class Workbench;

class LibraryDock : public QDockWidget
{
    Q_OBJECT
public:
    explicit LibraryDock(Workbench &bench, QWidget *parent = nullptr);

    /// What is selected, else the whole model, as a file of the folder, under a name that is free.
    void addSelection();
    QString folder() const;
    void setFolder(const QString &folder);

Q_SIGNALS:
    void insertWanted(const QString &path);
    /// What became of it, for the status bar.
    void said(const QString &sentence);
    void failed(const QString &sentence);

protected:
    void showEvent(QShowEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void chooseFolder();
    void fill();
    void requestPictures();
    void remove(const QString &path);

    Workbench &m_bench;
    Thumbnails m_thumbnails;
    QFileSystemWatcher m_watcher;
    CardGrid *m_grid = nullptr;
    QLabel *m_empty = nullptr;
    std::map<QString, ModelCard *> m_cards; // by their paths
};

} // namespace fff::ui
