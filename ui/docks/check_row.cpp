#include "ui/docks/check_row.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/properties/link_row.h"
#include "ui/view/heading_weight.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>

#include <utility>

namespace fff::ui {

namespace {

constexpr int kGlyphSize = 16; // px

QLabel *label(QWidget *parent)
{
    auto *made = new QLabel(parent);
    made->setWordWrap(true);
    made->setContentsMargins(LinkRow::kAround, 0, 0, 0); // links stand below the words
    made->setAttribute(Qt::WA_TransparentForMouseEvents);
    return made;
}

} // namespace

CheckRow::CheckRow(QWidget *parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    m_glyph = new QLabel(this);
    m_glyph->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_glyph->setFixedSize(kGlyphSize + 2, kGlyphSize + 2);
    m_title = label(this);
    QFont bold = font();
    bold.setWeight(headingWeight());
    m_title->setFont(bold);
    m_title->setObjectName(QStringLiteral("checkTitle"));
    m_text = label(this);
    m_text->setObjectName(QStringLiteral("checkText")); // muted by the style sheet
    QFont small = font();
    if (small.pointSizeF() > 0)
        small.setPointSizeF(small.pointSizeF() * 0.93);
    m_text->setFont(small);
    m_links = new LinkRow(this);
    m_links->setFont(small);
    connect(m_links, &LinkRow::clicked, this, [this](int index, bool isByKey) {
        m_isPressed = false;
        Q_EMIT linkClicked(index, isByKey);
    });
    connect(m_links, &LinkRow::hovered, this, &CheckRow::linkHovered);

    auto *words = new QVBoxLayout;
    words->setContentsMargins(0, 0, 0, 0);
    words->setSpacing(1);
    words->addWidget(m_title);
    words->addWidget(m_text);
    words->addWidget(m_links);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(11, 7, 10, 8);
    row->setSpacing(8 - LinkRow::kAround);
    row->addWidget(m_glyph, 0, Qt::AlignTop);
    row->addLayout(words, 1);
    m_links->hide();
}

void CheckRow::setContent(const Content &content)
{
    if (content == m_content)
        return;
    m_isPressed =
        m_isPressed && content.glyph == m_content.glyph && content.title == m_content.title;
    m_content = content;
    m_title->setText(content.number == 0
                         ? content.title
                         : QStringLiteral("%1  %2").arg(content.number).arg(content.title));
    m_text->setText(content.text);
    m_text->setVisible(!content.text.isEmpty());
    m_links->setTexts(content.links);
    m_links->setVisible(!content.links.isEmpty());
    for (QLabel *words : {m_title, m_text}) {
        QFont f = words->font();
        f.setItalic(content.isOlder);
        words->setFont(f);
    }
    const QString kind = content.number == 0
                             ? content.kind
                             : QStringLiteral("%1 %2").arg(content.kind).arg(content.number);
    setAccessibleName(QStringLiteral("%1: %2. %3").arg(kind, content.title, content.text));
    setAccessibleDescription(content.isOlder ? tr("Older than the drawing") : QString());
    refresh();
    updateGeometry();
}

void CheckRow::refresh()
{
    m_glyph->setPixmap(
        tintedPixmap(m_content.glyph, kGlyphSize, m_content.colour, devicePixelRatioF()));
    update();
}

QSize CheckRow::sizeHint() const
{
    return layout()->sizeHint();
}

int CheckRow::heightForWidth(int width) const
{
    return layout()->heightForWidth(width);
}

void CheckRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const Theme &t = theme();
    painter.fillRect(rect(), isChecked() ? t.soft : underMouse() || m_isLit ? t.hover : t.panel);
    painter.fillRect(0, height() - 1, width(), 1, t.border);
    if (hasFocus()) {
        painter.setPen(QPen(t.accent, 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -2));
    }
}

void CheckRow::setLit(bool lit)
{
    if (std::exchange(m_isLit, lit) != lit)
        update();
}

void CheckRow::mousePressEvent(QMouseEvent *event)
{
    m_isPressed = true;
    QAbstractButton::mousePressEvent(event);
}

/// What the first press was on may be mended and gone by now, and this is what came there.
void CheckRow::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (m_isPressed)
        QAbstractButton::mouseDoubleClickEvent(event);
    else
        event->accept();
}

void CheckRow::moveEvent(QMoveEvent *event)
{
    m_isPressed = false;
    QAbstractButton::moveEvent(event);
}

void CheckRow::enterEvent(QEnterEvent *event)
{
    QAbstractButton::enterEvent(event);
    Q_EMIT hovered(true);
}

void CheckRow::leaveEvent(QEvent *event)
{
    QAbstractButton::leaveEvent(event);
    Q_EMIT hovered(false);
}

void CheckRow::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Up:
        focusPreviousChild();
        break;
    case Qt::Key_Down:
        focusNextChild();
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        click();
        break;
    default:
        QAbstractButton::keyPressEvent(event);
    }
}

} // namespace fff::ui
