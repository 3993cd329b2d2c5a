#include "ui/dialogs/remark_rows.h"

#include "ui/base/icon.h"
#include "ui/base/rich_text.h"
#include "ui/base/theme.h"
#include "ui/bench/check_words.h"
#include "ui/properties/link_row.h"

#include <QAbstractButton>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kFrame = 1;        // px, by the style sheet
constexpr int kRemarkGlyph = 16; // px
constexpr int kMostHeight = 118; // px, of all rows: what lies above is why one is here

QString sentenceOf(const ExportRemark &remark)
{
    const QString text = remark.text.toHtmlEscaped();
    if (remark.title.isEmpty())
        return text;
    return QStringLiteral("<b>%1.</b> %2").arg(remark.title.toHtmlEscaped(), text);
}

} // namespace

RemarkRows::RemarkRows(QWidget *before, QWidget *parent) : QScrollArea(parent), m_before(before)
{
    setObjectName(QStringLiteral("exportRemarks"));
    setAccessibleName(tr("What to look out for"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus); // its links have it
    m_rows = new QWidget(this);
    m_rows->setBackgroundRole(QPalette::Base);
    m_rows->setAutoFillBackground(true);
    m_column = new QVBoxLayout(m_rows);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    setWidget(m_rows);
}

void RemarkRows::setRemarks(std::vector<ExportRemark> remarks)
{
    if (remarks == m_remarks)
        return;
    m_remarks = std::move(remarks);
    rebuild();
}

void RemarkRows::rebuild()
{
    while (QLayoutItem *item = m_column->takeAt(0)) {
        if (QWidget *row = item->widget()) {
            row->hide();
            row->deleteLater();
        }
        delete item;
    }
    for (std::size_t i = 0; i < m_remarks.size(); ++i)
        m_column->addWidget(makeRow(m_remarks[i], static_cast<int>(i)));
    m_column->addStretch(1);
    orderLinks();
    takeHeight();
}

/// New widgets come last otherwise, behind the buttons of the dialog.
void RemarkRows::orderLinks()
{
    QWidget *before = m_before;
    for (int i = 0; i + 1 < m_column->count(); ++i) // the last one is a stretch
        for (auto *link : m_column->itemAt(i)->widget()->findChildren<QAbstractButton *>()) {
            setTabOrder(before, link);
            before = link;
        }
}

QWidget *RemarkRows::makeRow(const ExportRemark &remark, int index)
{
    auto *row = new QWidget(m_rows);
    row->setObjectName(QStringLiteral("remark%1").arg(index));
    auto *glyph = new QLabel(row);
    glyph->setPixmap(tintedPixmap(checkGlyph(remark.severity), kRemarkGlyph,
                                  checkColour(remark.severity), devicePixelRatioF()));
    glyph->setAccessibleName(severityWord(remark.severity));
    auto *words = new QLabel(keepingUnits(sentenceOf(remark)), row);
    words->setObjectName(QStringLiteral("remarkText"));
    words->setTextFormat(Qt::RichText);
    words->setWordWrap(true);
    words->setAccessibleName(
        QStringLiteral("%1: %2 %3").arg(severityWord(remark.severity), remark.title, remark.text));
    auto *line = new QHBoxLayout(row);
    line->setContentsMargins(10, 5, 10, 5);
    line->setSpacing(8);
    line->addWidget(glyph, 0, Qt::AlignTop);
    line->addWidget(words, 1);
    if (remark.canBeShown()) {
        auto *show = new LinkRow(row);
        show->setTexts({tr("Show")});
        show->setToolTip(tr("Closes this and selects it in the model"));
        connect(show, &LinkRow::clicked, this, [this, index] { Q_EMIT showWanted(index); });
        line->addWidget(show, 0, Qt::AlignTop);
    }
    row->show();
    return row;
}

/// As high as they are, up to some rows.
void RemarkRows::takeHeight()
{
    m_column->invalidate(); // it may know heights for another width
    m_rows->updateGeometry();
    const int frame = 2 * kFrame;
    const int width = viewport()->width();
    const int height = m_column->hasHeightForWidth() ? m_column->heightForWidth(width)
                                                     : m_column->sizeHint().height();
    setFixedHeight(std::min(height + frame, kMostHeight));
}

void RemarkRows::resizeEvent(QResizeEvent *event)
{
    QScrollArea::resizeEvent(event);
    // What is laid out now is laid out for this width first.
    QMetaObject::invokeMethod(this, &RemarkRows::takeHeight, Qt::QueuedConnection);
}

void RemarkRows::changeEvent(QEvent *event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_rows)
        rebuild(); // glyphs are of the theme's colours
}

} // namespace fff::ui
