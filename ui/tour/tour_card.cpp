#include "ui/tour/tour_card.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kWidest = 460, kBeside = 16; // px

} // namespace

TourCard::TourCard(QWidget *view, int top)
    : QFrame(view), m_top(top), m_dots(new QLabel(this)), m_words(new QLabel(this)),
      m_skip(new QPushButton(tr("Skip this step"), this)), m_end(new QToolButton(this))
{
    setObjectName(QStringLiteral("tourCard"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    setCursor(Qt::ArrowCursor);
    m_dots->setObjectName(QStringLiteral("tourDots"));
    m_dots->setTextFormat(Qt::RichText);
    m_words->setObjectName(QStringLiteral("tourWords"));
    m_words->setTextFormat(Qt::RichText);
    m_words->setWordWrap(true);
    m_skip->setObjectName(QStringLiteral("tourSkip"));
    m_skip->setAutoDefault(false);
    m_end->setObjectName(QStringLiteral("tourEnd"));
    m_end->setAutoRaise(true);
    for (QWidget *button : {static_cast<QWidget *>(m_skip), static_cast<QWidget *>(m_end)})
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the focus where the hand draws
    auto *head = new QHBoxLayout;
    head->addWidget(m_dots, 1);
    head->addWidget(m_skip);
    head->addWidget(m_end);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(14, 8, 8, 12);
    column->setSpacing(6);
    column->addLayout(head);
    column->addWidget(m_words);
    connect(m_skip, &QPushButton::clicked, this, &TourCard::skipWanted);
    connect(m_end, &QToolButton::clicked, this, &TourCard::endWanted);
    view->installEventFilter(this);
    hide();
    refreshColours();
}

void TourCard::say(int number, int count, const QString &marked)
{
    m_number = number;
    m_count = count;
    const bool isLast = number == count;
    m_skip->setVisible(!isLast);
    m_end->setToolTip(isLast ? tr("Close") : tr("End the tour"));
    m_end->setAccessibleName(m_end->toolTip());
    m_words->setText(marked);
    //: %1 is the number of a step, %2 how many there are
    setAccessibleName(isLast ? tr("Tour") : tr("Tour, step %1 of %2").arg(number + 1).arg(count));
    setAccessibleDescription(m_words->text().remove(QRegularExpression(QStringLiteral("<[^>]*>"))));
    refreshColours();
    show();
    place();
    QAccessibleEvent said(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&said);
}

void TourCard::refreshColours()
{
    setPalette(theme().palette());
    m_end->setIcon(themedIcon(QStringLiteral("close")));
    QString dots;
    for (int i = 0; i < m_count; ++i)
        dots += QStringLiteral("<span style='color:%1'>%2</span> ")
                    .arg((i <= m_number ? theme().accent : theme().strong).name(),
                         i < m_number ? QStringLiteral("●") : QStringLiteral("○"));
    m_dots->setText(dots);
}

void TourCard::place()
{
    const int room = parentWidget()->width() - 2 * kBeside;
    const int width = std::min(kWidest, room);
    layout()->activate();
    setGeometry((parentWidget()->width() - width) / 2, m_top, width, heightForWidth(width));
    raise();
}

bool TourCard::eventFilter(QObject *object, QEvent *event)
{
    if (event->type() == QEvent::Resize && !isHidden())
        place();
    return QFrame::eventFilter(object, event);
}

} // namespace fff::ui
