// What stands in the place of the view before there is a model: begin anew, go on with one of the
// last models, or look at a sample. Works without a network, and never covers a model.
#pragma once

#include "ui/cards/thumbnails.h"
#include "ui/files/unsaved_work.h"
#include "ui/view/view_style.h"

#include <QWidget>

#include <initializer_list>
#include <vector>

class QFrame;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fff::ui {

class CardGrid;
class ModelCard;

class StartPage : public QWidget
{
    Q_OBJECT
public:
    explicit StartPage(QWidget *parent = nullptr);

    void setRecovered(const std::vector<RecoveredWork> &works);
    void setUnreadable(const std::vector<UnreadableCopy> &copies);

Q_SIGNALS:
    void newWanted();
    void tourWanted();
    void openWanted();
    void fileChosen(const QString &path);
    void sampleChosen(const QString &path);
    void recoverWanted(const QString &id);
    void discardWanted(const QString &id);
    void folderWanted(const QString &path);
    void noteTaken(const QString &path);

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QWidget *makeLeft();
    QWidget *makeMiddle();
    QFrame *addRow(QVBoxLayout *rows, const QPixmap &icon, const QString &text,
                   std::initializer_list<QPushButton *> buttons);
    QLabel *makeHeading(const QString &text);
    void fillRecent();
    void fillSamples();
    void refreshColours();
    void requestPictures();
    void showPicture(const QString &path, const QImage &picture, int sectionCount);

    struct Shown
    {
        QString path;
        ModelCard *card = nullptr;
        QString note; // after the number of sections
    };

    Thumbnails m_thumbnails;
    QPushButton *m_new = nullptr;
    QVBoxLayout *m_unreadable = nullptr, *m_recovered = nullptr;
    QLabel *m_recentHeading = nullptr;
    CardGrid *m_recent = nullptr, *m_samples = nullptr;
    std::vector<Shown> m_shownRecent, m_shownSamples;
    ViewStyle m_shownStyle; // of the pictures
};

} // namespace fff::ui
