// Sheets side by side as they will be cut, with whose part each is.
//
//   wheel          zooms to the cursor, + and − to the middle
//   middle drag    moves them, dragging the ground as well; a wheel across goes sideways
//   Home           all of them as large as they fit
//   click          selects the part's section; with Ctrl or Shift, more of them
//   Page Up, Down  the part before or after the selected one, by number
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/sheets/placed_sheets.h"
#include "ui/sheets/sheets_content.h"

#include <QPixmap>
#include <QTransform>

#include <optional>
#include <set>

namespace fff::ui {

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

    struct Spot
    {
        std::size_t sheet = 0, part = 0; // indices
        bool operator==(const Spot &) const = default;
    };
    /// The part there, px.
    std::optional<Spot> partAt(const QPointF &place) const;
    std::optional<Spot> hovered() const { return m_hovered; }
    /// From the sheet's coordinates to the widget's, px.
    QTransform transform(std::size_t sheet) const;
    /// "26 Front arch · 487 × 184 mm · turned 0°"
    QString tipOf(const Spot &spot) const;

    QSize sizeHint() const override { return {800, 300}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

Q_SIGNALS:
    /// The cursor came to a part of the section, or left all of them.
    void sectionHovered(std::optional<fff::SectionRef> section);
    void selected(const std::vector<fff::SectionRef> &sections);

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
    void choose(std::optional<Spot> spot, Qt::KeyboardModifiers keys);
    void chooseNext(int by);
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
    Qt::MouseButton m_button = Qt::NoButton; // that is held
    bool m_isMoved = false;                  // by the button that is held
    std::optional<Spot> m_hovered;
    std::set<SectionRef> m_selected;
    std::optional<SectionRef> m_lit;
    QPixmap m_picture; // of all but marks; null: to be drawn
};

} // namespace fff::ui
