#include "core/io/png_writer.h"

#include "core/fabrication/cutting_order.h"
#include "core/fabrication/joint_colours.h"
#include "core/io/stacked_sheets.h"

#include <QtCore/QBuffer>
#include <QtCore/QCoreApplication>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>
#include <cmath>

namespace fff::io {

namespace {

constexpr double kFinest = 8.0, kLongestSide = 8192.0; // pixels a mm, pixels
constexpr double kLineInPixels = 1.5;
constexpr double kMillimetresOfMetre = 1000.0;
constexpr QRgb kFrame = 0xFFB0B0B0;

QPainterPath pathOf(const ToolLine &line)
{
    const auto at = [](const Vec2 &p) { return QPointF(p.x(), p.y()); };
    QPainterPath path(at(line.start()));
    for (const CubicBezier &curve : line.curves)
        path.cubicTo(at(curve.p1), at(curve.p2), at(curve.p3));
    return path;
}

void paint(const CuttingDrawing &drawing, const StackedSheets &stack, QPainter &painter)
{
    const auto pen = [&painter](QRgb colour) {
        QPen line{QColor::fromRgb(colour), kLineInPixels};
        line.setCosmetic(true);
        painter.setPen(line);
    };
    for (std::size_t i = 0; i < drawing.sheets.size(); ++i) {
        const Vec2 &corner = stack.corners[i];
        painter.save();
        painter.translate(corner.x(), corner.y());
        pen(kFrame);
        for (const Polygon &ring : edgesOf(drawing.sheets[i])) {
            QPolygonF edge;
            for (const Vec2 &p : ring)
                edge << QPointF(p.x(), p.y());
            painter.drawPolygon(edge);
        }
        for (const ToolLine &line : toolLines(drawing.sheets[i])) {
            pen(colourOf(line.purpose, line.joint, drawing));
            painter.drawPath(pathOf(line));
        }
        painter.restore();
    }
}

} // namespace

Result<std::string> writePng(const CuttingDrawing &drawing)
{
    CuttingDrawing sheets = drawing;
    sheets.hasReference = false; // who measures a picture
    const StackedSheets stack = stacked(sheets);
    const Vec2 size = stack.box.isEmpty() ? Vec2(1.0, 1.0) : stack.box.size();
    const double scale = std::min(kFinest, kLongestSide / size.maxCoeff());
    const auto pixels = [scale](double length) {
        return std::max(1, static_cast<int>(std::ceil(length * scale)) + 1);
    };
    QImage image(pixels(size.x()), pixels(size.y()), QImage::Format_RGB32);
    if (image.isNull())
        return failure(ErrorCode::NotWorkedOut);
    image.fill(Qt::white);
    const int perMetre = static_cast<int>(std::lround(scale * kMillimetresOfMetre));
    image.setDotsPerMeterX(perMetre);
    image.setDotsPerMeterY(perMetre);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0.5, image.height() - 0.5);
    painter.scale(scale, -scale);
    paint(sheets, stack, painter);
    painter.end();
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    if (!image.save(&bytes, "PNG"))
        return failure(ErrorCode::NotWorkedOut);
    return bytes.data().toStdString();
}

const Format &pngFormat()
{
    static const Format format = {
        .key = "png",
        .suffixes = {"png"},
        .title = QT_TRANSLATE_NOOP("Format", "Picture of the sheets"),
        .titleOfSheets = QT_TRANSLATE_NOOP("Format", "Pictures, one for each sheet"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "a picture of the sheets"),
        .use = FileUse::Paper,
        .isColoured = true,
        .writeCutting = [](const CuttingDrawing &drawing, const FormatValues &) {
            return writePng(drawing);
        }};
    return format;
}

} // namespace fff::io
