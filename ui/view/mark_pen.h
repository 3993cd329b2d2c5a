// What all that is painted over the view has in common: where world points are on it, lines with a
// casing, rings and chips with words.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/frame.h"
#include "core/interaction/camera.h"
#include "core/interaction/label_room.h"
#include "ui/view/view_style.h"

#include <QPainter>
#include <QPainterPath>

#include <optional>
#include <utility>
#include <vector>

namespace fff::ui {

QPen roundPen(const QColor &colour, double width);
QColor faded(QColor colour, double alpha);
/// For axes of symmetry: dash-dot, as drawings have it.
QPen axisPen(const ViewStyle &style);

/// Leaves the painter's state changed. Painter, camera and style outlive it.
class MarkPen
{
public:
    MarkPen(QPainter &painter, const Camera &camera, const Vec2 &viewport, const ViewStyle &style)
        : m_painter(painter), m_camera(camera), m_viewport(viewport), m_style(style),
          m_room(viewport)
    {
    }

    QPainter &painter() { return m_painter; }
    const ViewStyle &style() const { return m_style; }
    const Vec2 &viewport() const { return m_viewport; }
    const Camera &camera() const { return m_camera; }

    QPointF screen(const Vec3 &world) const;
    /// A chain of curves in a frame's plane; in perspective chords of them.
    QPainterPath path(const std::vector<CubicBezier> &curves, const Frame &frame) const;
    QPainterPath path(const Contour &contour, const Frame &frame) const;

    /// The line on a wider one in the panels' colour, so that it is seen on every stock.
    void cased(const QPainterPath &line, const QPen &pen);
    void ring(const QPointF &centre, double radius, const QColor &colour);

    /// Which point of a chip is given.
    enum class Anchor { Left, Right, Middle };
    /// Who gets the better place.
    enum class Rank { InHand, OfModel, Besides };
    struct Chip
    {
        QPointF place; // of the middle of that side, px
        Anchor anchor = Anchor::Middle;
        QString text;
        QColor colour;
        Rank rank = Rank::Besides;
        std::optional<QPointF> names = {}; // what it is about; none: what is at its place
        QPointF along = {};                // a line through its place that it stands beside; null:
                                           // it stands there
        QColor frame = {};                 // invalid: as its words
        bool isFramed = true;              // else bare words on a casing
        double longest = 0.0;              // of its lines, px; 0: it is one line
        bool isButton = false;             // it can be clicked, and looks like it
        bool isLit = false;                // the cursor is on that
        QRectF *told = nullptr;            // where it came to be, px; empty: nowhere
    };
    /// Words in a box with a frame in their colour. They are placed and painted by paintChips(), so
    /// that none lies on another one, or on what is kept free by then.
    void chip(Chip chip) { m_chips.push_back(std::move(chip)); }
    void chip(const QPointF &place, Anchor anchor, const QString &text, const QColor &colour,
              Rank rank = Rank::Besides)
    {
        chip(Chip{place, anchor, text, colour, rank});
    }
    /// One that has to step aside gets a line to what it names; one that finds no place near enough
    /// is left out. Says where they are, px.
    std::vector<QRectF> paintChips();

    /// No words come there.
    void keepFree(const QRectF &box);
    /// Nor so near to that line.
    void keepFree(const QPointF &from, const QPointF &to, double halfWidth);
    /// What is kept free so far.
    const LabelRoom &room() const { return m_room; }

private:
    QFont fontOf(const Chip &chip) const;
    Vec2 sizeOf(const Chip &chip) const;
    Vec2 wantedPlace(const Chip &chip, const Vec2 &size) const;
    void paintLeader(const Chip &chip, const QRectF &box);
    void paintChip(const Chip &chip, const QRectF &box);
    void paintBox(const Chip &chip, const QRectF &box);

    QPainter &m_painter;
    const Camera &m_camera;
    const Vec2 m_viewport;
    const ViewStyle &m_style;
    LabelRoom m_room;
    std::vector<Chip> m_chips; // not painted yet
};

} // namespace fff::ui
