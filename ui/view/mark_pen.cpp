#include "ui/view/mark_pen.h"

#include "ui/view/heading_weight.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kChipHeight = 22.0, kChipPadding = 16.0;     // px
constexpr double kWordsHeight = 16.0;                         // px, of bare ones
constexpr double kButtonHeight = 28.0, kButtonPadding = 24.0; // px
constexpr double kManyLines = 1e4;                            // px, more than words take
constexpr double kLeader = 1.4;                               // px
constexpr double kOffItsLine = 12.0; // px, from a line to the words beside it
/// What steps aside by no more is still beside what it names, px.
constexpr double kStepAside = 12.0;
/// So far off nobody sees what words are about, px.
constexpr double kFarthest = 180.0;

} // namespace

QPen roundPen(const QColor &colour, double width)
{
    return QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

QPen axisPen(const ViewStyle &style)
{
    constexpr double kWidth = 1.6; // px
    QPen dashDot(style.symmetry, kWidth);
    dashDot.setDashPattern({14.0 / kWidth, 4.0 / kWidth, 2.0 / kWidth, 4.0 / kWidth});
    return dashDot;
}

QColor faded(QColor colour, double alpha)
{
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

QPointF MarkPen::screen(const Vec3 &world) const
{
    const Vec2 p = m_camera.toScreen(world, m_viewport);
    return {p.x(), p.y()};
}

QPainterPath MarkPen::path(const std::vector<CubicBezier> &curves, const Frame &frame) const
{
    QPainterPath path;
    for (const CubicBezier &piece : curves) {
        const QPointF from = screen(frame.toWorld(piece.p0));
        if (path.elementCount() == 0)
            path.moveTo(from);
        if (m_camera.isPerspective()) {
            // A cubic is none any more in perspective: chords of it.
            constexpr int kChords = 12;
            for (int i = 1; i <= kChords; ++i)
                path.lineTo(screen(frame.toWorld(piece.at(double(i) / kChords))));
            continue;
        }
        path.cubicTo(screen(frame.toWorld(piece.p1)), screen(frame.toWorld(piece.p2)),
                     screen(frame.toWorld(piece.p3)));
    }
    return path;
}

QPainterPath MarkPen::path(const Contour &contour, const Frame &frame) const
{
    std::vector<CubicBezier> pieces;
    for (int i = 0; i < contour.segmentCount(); ++i)
        pieces.push_back(contour.segment(i));
    QPainterPath closed = path(pieces, frame);
    closed.closeSubpath();
    return closed;
}

void MarkPen::cased(const QPainterPath &line, const QPen &pen)
{
    m_painter.strokePath(line, roundPen(m_style.panel, pen.widthF() + 2.4));
    m_painter.strokePath(line, pen);
}

void MarkPen::ring(const QPointF &centre, double radius, const QColor &colour)
{
    m_painter.setBrush(m_style.panel);
    m_painter.setPen(QPen(colour, 2.0));
    m_painter.drawEllipse(centre, radius, radius);
}

void MarkPen::keepFree(const QRectF &box)
{
    m_room.take({{box.left(), box.top()}, {box.right(), box.bottom()}});
}

void MarkPen::keepFree(const QPointF &from, const QPointF &to, double halfWidth)
{
    m_room.takeLine({from.x(), from.y()}, {to.x(), to.y()}, halfWidth);
}

QFont MarkPen::fontOf(const Chip &chip) const
{
    QFont font = m_painter.font();
    font.setPixelSize(12);
    font.setWeight(chip.isFramed ? headingWeight() : QFont::Normal);
    return font;
}

Vec2 MarkPen::sizeOf(const Chip &chip) const
{
    const QFontMetricsF metrics(fontOf(chip));
    const double padding = chip.isButton ? kButtonPadding : chip.isFramed ? kChipPadding : 2.0;
    const double most = m_viewport.x() - 2.0 * LabelRoom::kEdge - padding;
    const double inOneLine = metrics.horizontalAdvance(chip.text);
    const double height = chip.isButton   ? kButtonHeight
                          : chip.isFramed ? kChipHeight
                                          : kWordsHeight;
    if (chip.longest <= 0.0 || inOneLine <= std::min(chip.longest, most))
        return {std::min(inOneLine, most) + padding, height};
    const QRectF room(0.0, 0.0, std::min(chip.longest, most), kManyLines);
    const QRectF words = metrics.boundingRect(room, Qt::AlignLeft | Qt::TextWordWrap, chip.text);
    return {std::min(std::ceil(words.width()), room.width()) + padding,
            height + std::ceil(words.height() - metrics.lineSpacing())};
}

/// Of its middle.
Vec2 MarkPen::wantedPlace(const Chip &chip, const Vec2 &size) const
{
    const double before = chip.anchor == Anchor::Left    ? -0.5
                          : chip.anchor == Anchor::Right ? 0.5
                                                         : 0.0;
    const Vec2 wanted(chip.place.x() - before * size.x(), chip.place.y());
    const double length = std::hypot(chip.along.x(), chip.along.y());
    if (!(length > 0.0))
        return wanted;
    // Above the line, or at its right where that is upright: just so far that it does not touch it.
    Vec2 across(chip.along.y() / length, -chip.along.x() / length);
    if (across.y() > 0.0 || (across.y() == 0.0 && across.x() < 0.0))
        across = -across;
    return wanted + (0.5 * across.cwiseAbs().dot(size) + kOffItsLine) * across;
}

std::vector<QRectF> MarkPen::paintChips()
{
    std::stable_sort(m_chips.begin(), m_chips.end(),
                     [](const Chip &a, const Chip &b) { return a.rank < b.rank; });
    std::vector<std::pair<const Chip *, QRectF>> placed;
    for (const Chip &chip : m_chips) {
        const Vec2 size = sizeOf(chip);
        const std::optional<Box2> box =
            m_room.placeFor(wantedPlace(chip, size), size,
                            chip.rank == Rank::InHand ? LabelRoom::kAnywhere : kFarthest);
        if (!box) {
            if (chip.told)
                *chip.told = {};
            continue;
        }
        m_room.take(*box);
        placed.emplace_back(&chip, QRectF(box->min.x(), box->min.y(), size.x(), size.y()));
        if (chip.told)
            *chip.told = placed.back().second;
    }
    m_painter.save();
    std::vector<QRectF> boxes;
    for (const auto &[chip, box] : placed)
        paintLeader(*chip, box);
    for (const auto &[chip, box] : placed) {
        paintChip(*chip, box);
        boxes.push_back(box);
    }
    m_painter.restore();
    m_chips.clear();
    return boxes;
}

/// From the chip's edge to what it names, where that is not beside it.
void MarkPen::paintLeader(const Chip &chip, const QRectF &box)
{
    const QPointF names = chip.names.value_or(chip.place);
    const QPointF end(std::clamp(names.x(), box.left(), box.right()),
                      std::clamp(names.y(), box.top(), box.bottom()));
    const double length = std::hypot(end.x() - names.x(), end.y() - names.y());
    const double usual =
        chip.names ? std::hypot(chip.place.x() - names.x(), chip.place.y() - names.y()) : 0.0;
    if (length < usual + kStepAside)
        return;
    QPainterPath leader(names);
    leader.lineTo(end);
    m_painter.setBrush(Qt::NoBrush);
    cased(leader, roundPen(chip.colour, kLeader));
}

void MarkPen::paintChip(const Chip &chip, const QRectF &box)
{
    const QFont font = fontOf(chip);
    m_painter.setFont(font);
    const QFontMetricsF metrics(font);
    const bool isWrapped = !chip.isButton && box.height() > kChipHeight;
    const QString text =
        isWrapped ? chip.text : metrics.elidedText(chip.text, Qt::ElideRight, box.width());
    if (!chip.isFramed) {
        QPainterPath words;
        words.addText(box.left() + 1.0, box.center().y() + 0.36 * metrics.ascent(), font, text);
        m_painter.strokePath(words, roundPen(m_style.panel, 3.0));
        m_painter.fillPath(words, chip.colour);
        return;
    }
    paintBox(chip, box);
    m_painter.setPen(chip.isLit ? m_style.panel : chip.colour);
    if (isWrapped)
        m_painter.drawText(box.adjusted(0.5 * kChipPadding, 0.0, -0.5 * kChipPadding + 1.0, 0.0),
                           Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, text);
    else
        m_painter.drawText(box, Qt::AlignCenter, text);
}

/// A button stands out from the view, and is filled while the cursor is on it.
void MarkPen::paintBox(const Chip &chip, const QRectF &box)
{
    const QColor &frame = chip.frame.isValid() ? chip.frame : chip.colour;
    const QRectF inside = QRectF(box.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5);
    if (!chip.isButton) {
        m_painter.setPen(QPen(frame, 1.0));
        m_painter.setBrush(faded(m_style.panel, 0.96));
        m_painter.drawRoundedRect(inside, 3.0, 3.0);
        return;
    }
    const QRectF face = inside.adjusted(0.5, 0.5, -0.5, -2.5);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(frame);
    m_painter.drawRoundedRect(face.translated(0.0, 2.0), 4.0, 4.0); // its lower edge
    m_painter.setPen(QPen(frame, 1.5));
    m_painter.setBrush(chip.isLit ? frame : m_style.panel);
    m_painter.drawRoundedRect(face, 4.0, 4.0);
}

} // namespace fff::ui
