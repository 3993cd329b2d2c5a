#include "ui/properties/link_row.h"

#include "ui/base/theme.h"

#include <QAbstractButton>
#include <QCursor>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kBetween = 16; // px, with the dot in the middle
constexpr int kAround = LinkRow::kAround;

/// Where a link was clicked last, on the screen. What comes under a cursor that rests there was not
/// pointed at: other links take the place of those that have done what they say.
QPoint &lastClick()
{
    static QPoint place(-1, -1);
    return place;
}

/// Words to be clicked, in several lines where they are long. A word longer than a line is cut
/// short; the tip says all of them.
class Link : public QAbstractButton
{
public:
    explicit Link(QWidget *parent, std::function<void(bool)> hovered)
        : QAbstractButton(parent), m_hovered(std::move(hovered))
    {
        setFocusPolicy(Qt::StrongFocus);
        setCursor(Qt::PointingHandCursor);
        setAttribute(Qt::WA_Hover);
    }

    QSize sizeHint() const override
    {
        // The font that the style sheet gives comes with the polish, at the first show otherwise.
        ensurePolished();
        // Rounded up: a fraction of a pixel too little, and the text would be cut short.
        const QFontMetricsF metrics(font());
        return {static_cast<int>(std::ceil(metrics.horizontalAdvance(text()))) + 2 * kAround,
                static_cast<int>(std::ceil(metrics.height())) + 2 * kAround};
    }
    bool hasHeightForWidth() const override { return true; }
    /// It was a key that clicked it last.
    bool isByKey() const { return m_isByKey; }
    int heightForWidth(int width) const override
    {
        ensurePolished();
        return wrapped(width).height() + 2 * kAround;
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        const Theme &t = theme();
        QFont underlined = font();
        underlined.setUnderline(true);
        painter.setFont(underlined);
        painter.setPen(underMouse() || isDown() ? t.text : t.accent);
        const QRect words = rect().adjusted(kAround, kAround, -kAround, -kAround);
        if (isCutShort())
            painter.drawText(words, kFlags,
                             fontMetrics().elidedText(text(), Qt::ElideMiddle, words.width()));
        else
            // Words that just fit into a line would still break in it, for a fraction of a pixel.
            painter.drawText(words, isOneLine(width()) ? kFlags : kFlags | Qt::TextWordWrap,
                             text());
        if (hasFocus()) {
            painter.setPen(QPen(t.accent, 1.0));
            painter.drawRect(rect().adjusted(0, 0, -1, -1));
        }
    }
    void mousePressEvent(QMouseEvent *event) override
    {
        m_isByKey = false;
        lastClick() = QCursor::pos();
        QAbstractButton::mousePressEvent(event);
    }
    /// Once is enough, and what is under the cursor by then may be another link.
    void mouseDoubleClickEvent(QMouseEvent *event) override { event->accept(); }
    void keyPressEvent(QKeyEvent *event) override
    {
        m_isByKey = true;
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
            click();
        else
            QAbstractButton::keyPressEvent(event);
    }
    void changeEvent(QEvent *event) override
    {
        if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
            updateGeometry();
        QAbstractButton::changeEvent(event);
    }
    bool event(QEvent *event) override
    {
        if (event->type() == QEvent::Enter)
            m_isPassedOver = QCursor::pos() == lastClick();
        const bool isPointedAt =
            event->type() == QEvent::HoverMove && std::exchange(m_isPassedOver, false);
        if ((event->type() == QEvent::Enter && !m_isPassedOver) || isPointedAt ||
            event->type() == QEvent::FocusIn)
            m_hovered(true);
        else if (event->type() == QEvent::Leave || event->type() == QEvent::FocusOut ||
                 event->type() == QEvent::Hide)
            m_hovered(false);
        if (event->type() == QEvent::ToolTip) {
            QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(),
                               isCutShort() ? text() : QString(), this);
            return true;
        }
        return QAbstractButton::event(event);
    }

private:
    static constexpr int kFlags = Qt::AlignLeft | Qt::AlignVCenter;
    std::function<void(bool)> m_hovered; // also by the focus
    bool m_isByKey = false;
    bool m_isPassedOver = false; // it came under the cursor by itself

    bool isCutShort() const { return wrapped(width()).width() > width() - 2 * kAround; }
    bool isOneLine(int width) const { return width >= sizeHint().width(); }

    /// Size of the words in a link so wide; wider than that where they do not break.
    QSize wrapped(int width) const
    {
        if (isOneLine(width))
            return sizeHint() - QSize(2 * kAround, 2 * kAround);
        const QRectF room(0.0, 0.0, width - 2 * kAround, QWIDGETSIZE_MAX);
        const QRectF words =
            QFontMetricsF(font()).boundingRect(room, kFlags | Qt::TextWordWrap, text());
        return {static_cast<int>(std::ceil(words.width())),
                static_cast<int>(std::ceil(words.height()))};
    }
};

} // namespace

LinkRow::LinkRow(QWidget *parent) : QWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void LinkRow::setTexts(const QStringList &texts)
{
    if (texts == m_texts)
        return;
    m_texts = texts;
    const auto count = static_cast<std::size_t>(texts.size());
    while (m_links.size() < count) {
        const int index = static_cast<int>(m_links.size());
        auto *link = new Link(this, [this, index](bool isOver) { Q_EMIT hovered(index, isOver); });
        link->setObjectName(QStringLiteral("checkLink%1").arg(index));
        // It comes after all rows otherwise: those are there first.
        QWidget::setTabOrder(m_links.empty() ? parentWidget() : m_links.back(), link);
        connect(link, &QAbstractButton::clicked, this,
                [this, index, link] { Q_EMIT clicked(index, link->isByKey()); });
        m_links.push_back(link);
    }
    for (std::size_t i = 0; i < m_links.size(); ++i) {
        // It would go on to whatever is next in the window, such as the name of something.
        if (i >= count && m_links[i]->hasFocus() && count > 0)
            m_links.front()->setFocus(Qt::OtherFocusReason);
        m_links[i]->setVisible(i < count);
        if (i >= count)
            continue;
        // An ampersand in a name is none of a mnemonic: the link paints its text itself.
        m_links[i]->setText(texts[static_cast<qsizetype>(i)]);
        m_links[i]->setAccessibleName(texts[static_cast<qsizetype>(i)]);
    }
    updateGeometry();
    place();
    update();
}

std::vector<QRect> LinkRow::places(int width) const
{
    std::vector<QRect> places;
    int x = 0, y = 0;
    for (qsizetype i = 0; i < m_texts.size(); ++i) {
        const QAbstractButton *link = m_links[static_cast<std::size_t>(i)];
        QSize size = link->sizeHint();
        if (size.width() > width)
            size.setHeight(link->heightForWidth(width));
        if (x > 0 && x + size.width() > width) {
            x = 0;
            y += size.height();
        }
        places.emplace_back(x, y, std::min(size.width(), width), size.height());
        x += size.width() + kBetween - 2 * kAround;
    }
    return places;
}

void LinkRow::place()
{
    const std::vector<QRect> at = places(width());
    for (std::size_t i = 0; i < at.size(); ++i)
        m_links[i]->setGeometry(at[i]);
}

QSize LinkRow::sizeHint() const
{
    int width = 0;
    for (const QRect &place : places(QWIDGETSIZE_MAX))
        width = std::max(width, place.right() + 1);
    return {width, heightForWidth(width)};
}

QSize LinkRow::minimumSizeHint() const
{
    return {0, 0};
}

int LinkRow::heightForWidth(int width) const
{
    int height = 0;
    for (const QRect &place : places(width))
        height = std::max(height, place.bottom() + 1);
    return height;
}

bool LinkRow::event(QEvent *event)
{
    // A link's font changed, and with it its size.
    if (event->type() == QEvent::LayoutRequest) {
        updateGeometry();
        place();
        update();
    }
    return QWidget::event(event);
}

void LinkRow::resizeEvent(QResizeEvent *)
{
    place();
}

/// The dots between links of one line.
void LinkRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(theme().muted);
    const std::vector<QRect> at = places(width());
    for (std::size_t i = 1; i < at.size(); ++i)
        if (at[i].top() == at[i - 1].top())
            painter.drawText(QRect(at[i - 1].right() + 1, at[i].top(),
                                   at[i].left() - at[i - 1].right() - 1, at[i].height()),
                             Qt::AlignCenter, QStringLiteral("·"));
}

} // namespace fff::ui
