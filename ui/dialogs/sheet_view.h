// One sheet as it will be cut: true to size, with the paths that the file has, the numbers that
// are engraved and the bar to measure. Sheets look the same in light and dark, as the material
// does.
//
//   wheel        zooms to the cursor, + and − to the middle
//   drag         moves the sheet, arrow keys as well
//   Home         the whole sheet
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "ui/dialogs/sheet_paths.h"

#include <QPixmap>
#include <QTransform>

#include <memory>

namespace fff::ui {

class SheetView : public QWidget
{
    Q_OBJECT
public:
    explicit SheetView(QWidget *parent = nullptr);

    struct Content
    {
        std::shared_ptr<const SheetPaths> sheet; // null: nothing to be seen
        double margin = 0.0;                     // mm, that is left free along its edges
        bool hasReference = false;               // the bar is in this sheet's file, below it
        bool isOlder = false;                    // than what is being worked out
        QString caption;                         // above it
        QString note;                            // in its place, where there is none
    };
    /// Another sheet, or one of another size, is shown as a whole.
    void setContent(const Content &content);
    const Content &content() const { return m_content; }

    /// The whole sheet, as large as it goes.
    void fit();
    bool isFitted() const { return m_zoom == 1.0; }
    /// From sheet coordinates to the widget's, px.
    QTransform transform() const;
    /// The part there, as an index of the sheet's; −1: none.
    int partAt(const QPointF &place) const;

    QSize sizeHint() const override { return {620, 460}; }
    QSize minimumSizeHint() const override { return {220, 140}; }

Q_SIGNALS:
    /// It is shown as a whole, or not any more.
    void fittedChanged();

protected:
    void paintEvent(QPaintEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;

private:
    QRectF room() const;   // what the sheet may take, px
    QRectF extent() const; // of sheet and bar, mm
    double fittingScale() const;
    void zoomAt(const QPointF &place, double factor);
    void moveBy(const QPointF &way);
    void setHovered(int part);
    void drawAgain();

    Content m_content;
    double m_zoom = 1.0; // of what fits
    QPointF m_shift;     // px, from where it fits
    QPointF m_pressed;   // last place of a drag
    bool m_isDragged = false;
    int m_hovered = -1;
    QPixmap m_picture; // of all but what is hovered; null: to be drawn
};

} // namespace fff::ui
