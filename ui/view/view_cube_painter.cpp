#include "ui/view/view_cube_painter.h"

#include "ui/view/heading_weight.h"

#include <QCoreApplication>
#include <QPainterPath>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr double kHalf = 0.5 * kCubeEdge; // px, of a face seen straight
constexpr double kTextRoom = 0.80;        // of the face's width
constexpr double kShadedFace = 0.05;      // darker than the brightest

struct CubeText
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ViewCube)
};

QString faceText(const CubePart &face)
{
    if (face.y > 0)
        return CubeText::tr("TOP", "a face of the view cube: short");
    if (face.y < 0)
        return CubeText::tr("BOTTOM", "a face of the view cube: short");
    if (face.z > 0)
        return CubeText::tr("FRONT", "a face of the view cube: short");
    if (face.z < 0)
        return CubeText::tr("BACK", "a face of the view cube: short");
    return face.x > 0 ? CubeText::tr("RIGHT", "a face of the view cube: short")
                      : CubeText::tr("LEFT", "a face of the view cube: short");
}

QPointF point(const Vec2 &p)
{
    return {p.x(), p.y()};
}

QPolygonF outline(const std::array<Vec2, 4> &corners)
{
    QPolygonF polygon;
    for (const Vec2 &p : corners)
        polygon << point(p);
    return polygon;
}

QColor withAlpha(QColor colour, double alpha)
{
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

} // namespace

void paintViewCube(QPainter &painter, const Eigen::Quaterniond &orientation, const Vec2 &viewport,
                   const std::optional<CubePart> &lit, const ViewStyle &style)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const std::vector<CubeFace> faces = visibleFaces(orientation, viewport);
    for (const CubeFace &face : faces) {
        const QPolygonF square =
            outline({face.centre - face.right - face.up, face.centre + face.right - face.up,
                     face.centre + face.right + face.up, face.centre - face.right + face.up});
        // The more a face is turned away, the more of the ink mixes into its ground.
        const double seen = std::abs(cross(face.right, face.up)) / (kHalf * kHalf);
        painter.setPen(Qt::NoPen);
        painter.setBrush(withAlpha(style.panel, 0.94));
        painter.drawPolygon(square);
        painter.setBrush(withAlpha(style.text, kShadedFace * (1.0 - std::min(seen, 1.0))));
        painter.drawPolygon(square);
        if (const auto part = lit ? partOnFace(face, *lit) : std::nullopt) {
            painter.setBrush(withAlpha(style.accent, 0.30));
            painter.drawPolygon(outline(*part));
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(style.strong, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(square);
    }
    for (const CubeFace &face : faces) {
        painter.save();
        painter.setTransform(QTransform(face.right.x() / kHalf, face.right.y() / kHalf,
                                        -face.up.x() / kHalf, -face.up.y() / kHalf, face.centre.x(),
                                        face.centre.y()),
                             true);
        const QString text = faceText(face.part);
        QFont font = painter.font();
        font.setPixelSize(12);
        font.setWeight(headingWeight());
        const double width = QFontMetricsF(font).horizontalAdvance(text);
        const double scale = std::min(1.0, kTextRoom * kCubeEdge / std::max(width, 1.0));
        painter.scale(scale, scale);
        // As shapes: letters that are turned and squeezed have no hinting to suit them.
        QPainterPath letters;
        const QFontMetricsF metrics(font);
        letters.addText(QPointF(-0.5 * width, 0.5 * metrics.capHeight()), font, text);
        painter.fillPath(letters, lit == face.part ? style.text : style.muted);
        painter.restore();
    }
    painter.restore();
}

} // namespace fff::ui
