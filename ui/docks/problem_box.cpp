#include "ui/docks/problem_box.h"

#include "ui/base/icon.h"
#include "ui/base/rich_text.h"
#include "ui/base/theme.h"
#include "ui/bench/check_words.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

namespace fff::ui {

namespace {

constexpr int kGlyphSize = 16, kBelow = 12; // px; to what comes after it
constexpr double kCorner = 3.0;             // px

} // namespace

ProblemBox::ProblemBox(const char *labelName, QWidget *parent) : QWidget(parent)
{
    m_glyph = new QLabel(this);
    m_glyph->setFixedSize(kGlyphSize, kGlyphSize);
    m_text = new QLabel(this);
    m_text->setObjectName(QLatin1String(labelName));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::RichText);
    m_text->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_text, &QLabel::linkActivated, this, &ProblemBox::linkActivated);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(10, 9, 10, 9 + kBelow);
    row->setSpacing(8);
    row->addWidget(m_glyph, 0, Qt::AlignTop);
    row->addWidget(m_text, 1);
    hide();
}

void ProblemBox::tell(Severity severity, const QString &html)
{
    m_severity = severity;
    m_glyph->setPixmap(
        tintedPixmap(checkGlyph(severity), kGlyphSize, checkColour(severity), devicePixelRatioF()));
    m_text->setText(keepingUnits(html));
    // The Tab key stops where there is something to do.
    m_text->setFocusPolicy(html.contains(QLatin1String("<a ")) ? Qt::StrongFocus : Qt::NoFocus);
    show();
    update();
}

void ProblemBox::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(checkColour(m_severity), 1.0));
    painter.setBrush(m_severity == Severity::Error ? theme().problemSoft : theme().warningSoft);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5 - kBelow), kCorner,
                            kCorner);
}

QString linkTo(const QString &name, const QString &target)
{
    // Links in a text have the application's colour, not that of the palette here.
    return QStringLiteral("<a href=\"%1\" style=\"color:%2\">%3</a>")
        .arg(target, theme().accent.name(), name.toHtmlEscaped());
}

} // namespace fff::ui
