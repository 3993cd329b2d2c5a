// The steps of the assembly on paper: a title page with the finished model, then every step with
// its number, its picture, what is to be done, and the outlines of its parts, so that one finds
// them on the table.
#pragma once

#include "core/fabrication/layout.h"
#include "core/fabrication/part.h"
#include "ui/view/length_unit.h"
#include "ui/view/step_pictures.h"

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace fff::ui {

class StepsPaper
{
public:
    struct Options
    {
        QString title; // the model's name
        QPageSize::PageSizeId size = QPageSize::A4;
        LengthUnit unit = LengthUnit::Millimetre;
        /// What a stock is called for whoever reads it; none: as in the file.
        std::function<QString(const Stock &)> stockName;
        /// How parts lie on their sheets; none: as in a cutting file of which nothing was asked.
        std::shared_ptr<const Layout> layout;
    };
    /// "Birch plywood, 3.00 mm"
    static QString stockText(const Stock &stock, const Options &options);
    /// Of a part, width and height: "84 × 120 mm".
    static QString sizeText(const Vec2 &millimetres, LengthUnit unit);
    /// "38 parts, from 2 sheets, in 38 steps."
    static QString factsText(const AssemblySteps &steps, const Options &options);

    /// The pictures outlive it. To be used on their thread.
    StepsPaper(StepPictures &pictures, const Options &options);
    ~StepsPaper();

    /// A4, or Letter where that is what printers hold.
    static QPageSize::PageSizeId usualSize(const QLocale &locale);

    /// Of work: the title page and each step are one, and takes some tenths of a second.
    int pieceCount() const { return m_steps.playback.stepCount() + 1; }
    /// In their order. False when no picture could be made.
    bool makePiece(int index);
    /// The document, when all is made.
    QByteArray take();
    int pageCount() const { return m_page; }

private:
    double mm(double length) const;
    QFont font(double points, QFont::Weight weight = QFont::Normal) const;
    double text(const QRectF &box, const QString &text, const QFont &font, const QColor &colour,
                int flags = 0);
    void beginPage();
    bool titlePage();
    bool step(int index);
    void outlines(const QRectF &box, const std::vector<int> &parts);
    void outline(const QRectF &box, int part);

    StepPictures &m_pictures;
    const AssemblySteps &m_steps;
    Options m_options;
    std::vector<Part> m_parts;
    QBuffer m_bytes;
    std::unique_ptr<QPdfWriter> m_writer;
    QPainter m_painter;
    QRectF m_room; // of a page without its margins, mm
    int m_page = 0;
};

} // namespace fff::ui
