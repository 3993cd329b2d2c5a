// The sheets as they will be cut, under the view: how well parts lie there, whose they are, and how
// they are to lie. What lies here is what Export writes.
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "core/interaction/section_edit.h"
#include "core/model/section.h"
#include "ui/dialogs/cut_time.h"

#include <QString>

#include <optional>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;

namespace fff::ui {

class LayoutGroup;
class LinkRow;
class SegmentedBox;
class SheetsView;
class Workbench;

class SheetsDock : public QDockWidget
{
    Q_OBJECT
public:
    SheetsDock(Workbench &bench, QWidget *parent = nullptr);

    /// In the colours of the theme.
    void refreshColours();

    static constexpr int kLeastHeight = 210; // px: with 1024 × 640 there is no more beside the view

Q_SIGNALS:
    /// One of that stock is to be added.
    void offcutWanted(fff::StockId stock);
    void said(const QString &sentence);
    /// What the hand can do there; with marks, empty: it is elsewhere.
    void hinted(const QString &marked);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QWidget *makeHead();
    QWidget *makeFoot();
    void refresh();
    void refreshHead();
    void refreshFoot();
    void refreshTooLarge();
    void light(std::optional<SectionRef> section);
    void followView();
    void splitTooLarge();
    void edit(SectionEdit edit);
    void say(const QString &why);
    QString priceText() const;
    QString looseText() const;
    QString note() const;

    Workbench &m_bench;
    CuttingWork *m_work = nullptr;
    SegmentedBox *m_level = nullptr;
    QProgressBar *m_bar = nullptr;
    QLabel *m_state = nullptr;
    QPushButton *m_stop = nullptr;
    SheetsView *m_view = nullptr;
    LayoutGroup *m_layoutRows = nullptr;
    QWidget *m_tooLarge = nullptr; // that parts are, and what can be done
    QLabel *m_tooLargeText = nullptr;
    LinkRow *m_split = nullptr;
    QLabel *m_foot = nullptr;
    LinkRow *m_unpin = nullptr;
    QString m_said; // why a part is not where somebody wanted it
    CutTime m_time;
    const void *m_shown = nullptr; // what the view shows
    bool m_wasOlder = false;
    bool m_lights = false; // a section in the view
};

} // namespace fff::ui
