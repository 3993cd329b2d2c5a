// Sheets side by side as they will be cut, with whose part each is.
//
//   wheel          zooms to the cursor, + and − to the middle
//   middle drag    moves them, dragging the ground as well; a wheel across goes sideways
//   Home           all of them as large as they fit
//   click          selects the part's section; with Ctrl or Shift, more of them
//   Page Up, Down  the part before or after the selected one, by number
//   drag           puts a part elsewhere, where there is room for it; Esc puts it back
//   its handle     turns it, with Ctrl in steps of 15°
//   R, Shift+R     the same by 90° and 15°, as far as it may be turned
//   arrow keys     move the selected part by 1 mm; the sheets where none is selected
//   P              pins the selected parts, or lets them go
//   click on a pin lets its part go
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/sheets/part_hand.h"
#include "ui/sheets/placed_sheets.h"
#include "ui/sheets/sheets_content.h"

#include <QPixmap>
#include <QTransform>

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace fff::ui {

struct SheetPainting;

class SheetsView : public QWidget
{
    Q_OBJECT
public:
    explicit SheetsView(QWidget *parent = nullptr);

    void setContent(SheetsContent content);
    const SheetsContent &content() const { return m_content; }
    void setSelected(const std::vector<SectionRef> &sections);
    /// As if the cursor were on its parts, because it is on the section elsewhere.
    void setLit(std::optional<SectionRef> section);

    void fit();
    bool isFitted() const { return m_zoom == 1.0; }

    using Spot = SheetSpot;
    /// The part there, px.
    std::optional<Spot> partAt(const QPointF &place) const;
    std::optional<Spot> hovered() const { return m_hovered; }
    /// That whose pin is there, px.
    std::optional<Spot> pinAt(const QPointF &place) const;
    /// From the sheet's coordinates to the widget's, px.
    QTransform transform(std::size_t sheet) const;
    /// "26 Front arch · 487 × 184 mm · turned 0°"
    QString tipOf(const Spot &spot) const;
    /// The part that is in the hand, or was put down and is not laid yet; null: none.
    const PartHand *hand() const { return m_hand ? &*m_hand : nullptr; }
    /// Of the selected part that keys are for; null while there is none.
    std::optional<QPointF> handle() const; // px

    QSize sizeHint() const override { return {800, 300}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

Q_SIGNALS:
    /// The cursor came to a part of the section, or left all of them.
    void sectionHovered(std::optional<fff::SectionRef> section);
    void selected(const std::vector<fff::SectionRef> &sections);
    /// A part was put there; by a key, which may go on.
    void placed(const fff::PinnedPlace &place, bool isByKey);
    /// What the hand can do where it is; with marks (ui/base/sentence_label.h), empty: it left.
    void hinted(const QString &marked);
    /// There is no room for it, or it may not be turned so.
    void refused(const QString &why);
    void pinned(const std::vector<fff::PinnedPlace> &places);
    void letGo(const std::vector<fff::SectionRef> &sections);

protected:
    void paintEvent(QPaintEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;

private:
    QRectF room() const; // px
    void place();
    QRectF rectOf(const PlacedSheet &placed) const; // px, where it is seen
    void zoomAt(const QPointF &place, double factor);
    void moveBy(const QPointF &way);
    void setHovered(std::optional<Spot> spot);
    void hover(const QPointF &place);
    QString hintAt(const std::optional<Spot> &spot, bool isPin) const;
    void choose(std::optional<Spot> spot, Qt::KeyboardModifiers keys);
    void chooseNext(int by);
    void setContentNow(SheetsContent content);
    std::optional<Spot> partOfKeys() const;
    std::vector<Spot> selectedParts() const;
    bool beginHand();
    void moveHand(const QPointF &place);
    void turnHand(const QPointF &place, bool isInSteps);
    void endHand(bool isKept);
    void nudge(const Vec2 &way);
    void turnByKey(bool isFine);
    void togglePins();
    bool holdByKey();
    void putByKey(const HandPlace &before);
    std::optional<int> sheetAt(const QPointF &place) const;
    Vec2 onSheet(const QPointF &place, int sheet) const;
    bool handKey(const QKeyEvent &event);
    void paintHand(QPainter &painter) const;
    void paintHandle(QPainter &painter) const;
    SheetPainting paintingOf(const PlacedSheet &placed) const;
    bool isMarked(const Spot &spot) const;
    const PartOnSheet &factsOf(const Spot &spot) const;
    const PartPaths &pathsOf(const Spot &spot) const;
    void drawAgain();
    void paintAll();
    void paintCaption(const PlacedSheet &placed, QPainter &painter) const;
    void paintMarks(QPainter &painter) const;

    SheetsContent m_content;
    PlacedSheets m_placed;
    double m_zoom = 1.0; // of what fits
    QPointF m_shift;     // px
    QPointF m_pressed, m_last;
    std::optional<Spot> m_pressedAt;
    std::optional<SectionRef> m_pressedPin;  // whose
    Qt::MouseButton m_button = Qt::NoButton; // that is held
    bool m_isMoved = false;                  // by the button that is held
    enum class Hand { None, Drags, Turns };
    Hand m_doing = Hand::None;
    std::optional<PartHand> m_hand;
    std::optional<SheetsContent> m_next; // that came while a part was dragged
    Vec2 m_grabbed = Vec2::Zero();       // of the part, from its offset, mm
    double m_turnedAt = 0.0;             // where the handle was taken, degrees
    HandPlace m_turnedFrom;
    std::optional<std::pair<SectionRef, int>> m_keys; // the part that was clicked last
    std::optional<Spot> m_hovered;
    std::set<SectionRef> m_selected;
    std::optional<SectionRef> m_lit;
    QPixmap m_picture; // of all but marks; null: to be drawn
};

} // namespace fff::ui
