#include "ui/view/steps_paper.h"

#include "core/analysis/cutting.h"
#include "core/base/tolerances.h"
#include "core/fabrication/marks.h"
#include "ui/view/heading_weight.h"
#include "ui/view/steps_page_data.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

namespace fff::ui {

namespace {

struct StepsPaperTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::StepsPaper)
};

constexpr int kResolution = 1200; // dpi of the page's coordinates
constexpr double kMargin = 15.0;  // mm
constexpr double kFooter = 8.0;   // mm
constexpr int kStepsOnPage = 3;
constexpr double kPictureShare = 0.62; // of the page's width
constexpr double kGap = 6.0;           // mm, between pictures and words
constexpr double kPictureRatio = 1.7;  // pixels of a picture in print, of one on the screen
constexpr double kScreenPixels = 5.2;  // a mm of paper: line widths and digits follow from it
constexpr int kMostOutlines = 4;
constexpr double kLargestOutline = 0.5; // of its true size
const QColor kText(0x1b, 0x21, 0x27), kMuted(0x54, 0x5f, 0x6b), kRule(0xc6, 0xcc, 0xd4);
const QColor kAccent(0x1b, 0x62, 0xc9), kTone(0xf0, 0xf3, 0xf7);

// The command line has no plurals of its own.
QString partsText(int count)
{
    return count == 1 ? StepsPaperTexts::tr("1 part")
                      : StepsPaperTexts::tr("%n parts", nullptr, count);
}

QString sheetsText(int count)
{
    return count == 1 ? StepsPaperTexts::tr("1 sheet")
                      : StepsPaperTexts::tr("%n sheets", nullptr, count);
}

QString stepsText(int count)
{
    return count == 1 ? StepsPaperTexts::tr("1 step")
                      : StepsPaperTexts::tr("%n steps", nullptr, count);
}

QPolygonF polylineOf(std::span<const Vec2> points)
{
    QPolygonF line;
    for (const Vec2 &p : points)
        line += QPointF(p.x(), p.y());
    return line;
}

QPainterPath ringPath(const Polygon &ring)
{
    QPainterPath path;
    for (const Vec2 &p : ring) {
        if (path.elementCount() == 0)
            path.moveTo(p.x(), p.y());
        else
            path.lineTo(p.x(), p.y());
    }
    path.closeSubpath();
    return path;
}

} // namespace

QPageSize::PageSizeId StepsPaper::usualSize(const QLocale &locale)
{
    return locale.measurementSystem() == QLocale::ImperialUSSystem ? QPageSize::Letter
                                                                   : QPageSize::A4;
}

QString StepsPaper::stockText(const Stock &stock, const Options &options)
{
    const QString name =
        options.stockName ? options.stockName(stock) : QString::fromStdString(stock.name);
    return QStringLiteral("%1, %2").arg(name,
                                        lengthText(stock.thickness, options.unit, 2, 3, QLocale()));
}

QString StepsPaper::sizeText(const Vec2 &millimetres, LengthUnit unit)
{
    return QStringLiteral("%1 × %2").arg(lengthNumber(millimetres.x(), unit, 0, 0, QLocale()),
                                         lengthText(millimetres.y(), unit, 0, 0, QLocale()));
}

QString StepsPaper::factsText(const AssemblySteps &steps, const Options &options)
{
    const Analysis &analysis = *steps.analysis;
    const std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    const std::shared_ptr<const Layout> layout =
        options.layout ? options.layout : layoutFor(analysis, {});
    if (!layout)
        //: %1 is "38 parts", %2 "38 steps"
        return StepsPaperTexts::tr("%1, in %2.")
            .arg(partsText(static_cast<int>(parts.size())), stepsText(steps.playback.stepCount()));
    //: %1 is "38 parts", %2 "2 sheets", %3 "38 steps"
    return StepsPaperTexts::tr("%1, from %2, in %3.")
        .arg(partsText(static_cast<int>(parts.size())),
             sheetsText(static_cast<int>(layout->sheets.size())),
             stepsText(steps.playback.stepCount()));
}

StepsPaper::StepsPaper(StepPictures &pictures, const Options &options)
    : m_pictures(pictures), m_steps(pictures.steps()), m_options(options)
{
    const Analysis &analysis = *m_steps.analysis;
    m_parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    m_bytes.open(QIODevice::WriteOnly);
    m_writer = std::make_unique<QPdfWriter>(&m_bytes);
    m_writer->setResolution(kResolution);
    m_writer->setPageSize(QPageSize(options.size));
    m_writer->setPageMargins(QMarginsF(kMargin, kMargin, kMargin, kMargin),
                             QPageLayout::Millimeter);
    m_writer->setTitle(options.title);
    m_writer->setCreator(QStringLiteral("FlatFitFab"));
    const QRectF room = m_writer->pageLayout().paintRect(QPageLayout::Millimeter);
    m_room = QRectF(0.0, 0.0, room.width(), room.height());
}

StepsPaper::~StepsPaper()
{
    if (m_painter.isActive())
        m_painter.end();
}

double StepsPaper::mm(double length) const
{
    return length * kResolution / 25.4;
}

QFont StepsPaper::font(double points, QFont::Weight weight) const
{
    QFont font;
    font.setPointSizeF(points);
    font.setWeight(weight);
    return font;
}

/// In a box of mm; gives the height that it took, mm.
double StepsPaper::text(const QRectF &box, const QString &text, const QFont &font,
                        const QColor &colour, int flags)
{
    m_painter.setFont(font);
    m_painter.setPen(colour);
    QRectF taken;
    m_painter.drawText(QRectF(mm(box.x()), mm(box.y()), mm(box.width()), mm(box.height())),
                       flags | Qt::TextWordWrap, text, &taken);
    return taken.height() * 25.4 / kResolution;
}

void StepsPaper::beginPage()
{
    if (m_page == 0) {
        m_painter.begin(m_writer.get());
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
    } else {
        m_writer->newPage();
    }
    ++m_page;
    const int pages = 1 + (m_steps.playback.stepCount() + kStepsOnPage - 1) / kStepsOnPage;
    const QRectF foot(0.0, m_room.height() - kFooter, m_room.width(), kFooter);
    text(foot, m_options.title, font(8.0), kMuted, Qt::AlignLeft | Qt::AlignBottom);
    text(foot, StepsPaperTexts::tr("Page %1 of %2").arg(m_page).arg(pages), font(8.0), kMuted,
         Qt::AlignRight | Qt::AlignBottom);
}

bool StepsPaper::makePiece(int index)
{
    return index == 0 ? titlePage() : step(index - 1);
}

bool StepsPaper::titlePage()
{
    beginPage();
    double y = text(m_room, m_options.title, font(26.0, headingWeight()), kText) + 2.0;
    const QRectF below(0.0, y, m_room.width(), 20.0);
    y += text(below, StepsPaperTexts::tr("How it goes together"), font(14.0), kMuted) + 6.0;

    const double width = m_room.width(),
                 height = std::min(width * 0.85, m_room.height() - y - 60.0);
    const QImage picture = m_pictures.finished(kScreenPixels * Vec2(width, height), kPictureRatio);
    if (picture.isNull())
        return false;
    m_painter.drawImage(QRectF(0.0, mm(y), mm(width), mm(height)), picture);
    y += height + 6.0;

    const Model &model = m_steps.analysis->model;
    y += text(QRectF(0.0, y, width, 20.0), factsText(m_steps, m_options),
              font(12.0, headingWeight()), kText) +
         2.0;
    std::set<StockId> stocks;
    for (const Part &part : m_parts) {
        if (!stocks.insert(part.stock).second)
            continue;
        const Stock &stock = *model.document.find(part.stock);
        y +=
            text(QRectF(0.0, y, width, 20.0), stockText(stock, m_options), font(11.0), kText) + 1.0;
    }
    text(QRectF(0.0, y + 2.0, width, 30.0),
         StepsPaperTexts::tr(
             "The numbers are those engraved on the parts. At every slit there is the number of "
             "its joint after a short bar, the same on both of its parts."),
         font(11.0), kMuted);
    return true;
}

bool StepsPaper::step(int index)
{
    const int row = index % kStepsOnPage;
    if (row == 0)
        beginPage();
    const double height = (m_room.height() - kFooter) / kStepsOnPage;
    const double top = row * height;
    if (row > 0) {
        m_painter.setPen(QPen(kRule, mm(0.2)));
        m_painter.drawLine(QPointF(0.0, mm(top)), QPointF(mm(m_room.width()), mm(top)));
    }
    const QRectF picture(0.0, top + 3.0, kPictureShare * m_room.width(), height - 6.0);
    const QImage image =
        m_pictures.step(index, StepPictures::Fit::Step,
                        kScreenPixels * Vec2(picture.width(), picture.height()), kPictureRatio);
    if (image.isNull())
        return false;
    m_painter.drawImage(
        QRectF(mm(picture.x()), mm(picture.y()), mm(picture.width()), mm(picture.height())), image);

    QRectF words(picture.right() + kGap, top + 4.0, m_room.width() - picture.right() - kGap,
                 height - 8.0);
    words.setTop(words.top() +
                 text(words, QLocale().toString(index + 1), font(22.0, headingWeight()), kAccent) +
                 1.0);
    words.setTop(words.top() + text(words, stepSentence(m_steps, index), font(10.5), kText) + 3.0);
    outlines(words, m_steps.playback.plan().steps[static_cast<std::size_t>(index)].parts);
    return true;
}

/// Side by side, two in a row.
void StepsPaper::outlines(const QRectF &box, const std::vector<int> &parts)
{
    const int count = std::min(kMostOutlines, static_cast<int>(parts.size()));
    const int columns = count > 1 ? 2 : 1, rows = (count + 1) / 2;
    const double more = static_cast<int>(parts.size()) > count ? 5.0 : 0.0;
    const double width = (box.width() - 2.0 * (columns - 1)) / columns;
    const double height = (box.height() - more) / rows;
    for (int i = 0; i < count; ++i)
        outline(QRectF(box.x() + (i % columns) * (width + 2.0), box.y() + (i / columns) * height,
                       width, height - 1.0),
                parts[static_cast<std::size_t>(i)]);
    if (more > 0.0)
        text(QRectF(box.x(), box.bottom() - more, box.width(), more),
             StepsPaperTexts::tr("and %n more", nullptr, static_cast<int>(parts.size()) - count),
             font(8.0), kMuted);
}

/// The part as it lies on the sheet, with what is engraved on it, and its number and size.
void StepsPaper::outline(const QRectF &box, int index)
{
    constexpr double kLine = 6.0; // mm, of the number
    const Part &part = m_parts[static_cast<std::size_t>(index)];
    Box2 bounds;
    for (const Vec2 &p : part.outline.region.outer)
        bounds.extend(p);
    const Vec2 size = bounds.size();
    const double scale =
        std::min({kLargestOutline, box.width() / size.x(), (box.height() - kLine) / size.y()});
    if (!(scale > 0.0))
        return;
    QPainterPath path = ringPath(part.outline.region.outer);
    for (const Polygon &hole : part.outline.region.holes)
        path.addPath(ringPath(hole));

    m_painter.save();
    m_painter.translate(mm(box.x()), mm(box.y() + scale * size.y()));
    m_painter.scale(mm(scale), -mm(scale));
    m_painter.translate(-bounds.min.x(), -bounds.min.y());
    const auto pen = [&](const QColor &colour, double width) {
        return QPen(colour, width / scale, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    m_painter.setBrush(kTone);
    m_painter.setPen(pen(kText, 0.25));
    m_painter.drawPath(path);
    m_painter.setPen(pen(kAccent, 0.2));
    const Engraving engraving = engrave(part, m_steps.sectionOf(index).marks);
    for (const auto *lines : {&engraving.lines.engraved, &engraving.lines.scored})
        for (const CurvePath &line : *lines)
            m_painter.drawPolyline(polylineOf(line.flatten(kDrawChord)));
    for (std::size_t i = 0; i < engraving.strokes.size(); ++i) {
        m_painter.drawPolyline(polylineOf(engraving.strokes[i]));
    }
    m_painter.restore();

    const QRectF line(box.x(), box.y() + scale * size.y() + 0.5, box.width(), kLine - 0.5);
    const QString number = QLocale().toString(part.number);
    text(line, number, font(11.0, QFont::Bold), kAccent, Qt::AlignLeft | Qt::AlignVCenter);
    const double shift =
        QFontMetricsF(font(11.0, QFont::Bold), m_writer.get()).horizontalAdvance(number) * 25.4 /
            kResolution +
        2.0;
    text(line.adjusted(shift, 0.0, 0.0, 0.0), sizeText(size, m_options.unit), font(8.0), kMuted,
         Qt::AlignLeft | Qt::AlignVCenter);
}

QByteArray StepsPaper::take()
{
    m_painter.end();
    m_writer.reset();
    m_bytes.close();
    return m_bytes.data();
}

} // namespace fff::ui
