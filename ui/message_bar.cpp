#include "ui/message_bar.h"

#include "ui/icon.h"
#include "ui/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

namespace fff::ui {

MessageBar::MessageBar(QWidget *parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("messageBar"));
    setAccessibleName(tr("Message"));
    m_icon = new QLabel(this);
    m_text = new QLabel(this);
    m_text->setObjectName(QStringLiteral("messageText"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *close = new QToolButton(this);
    close->setObjectName(QStringLiteral("closeMessage"));
    close->setIcon(themedIcon(QStringLiteral("close")));
    close->setIconSize({16, 16});
    close->setToolTip(tr("Close this message"));
    close->setAccessibleName(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 12, 8);
    row->setSpacing(12);
    row->addWidget(m_icon, 0, Qt::AlignTop);
    row->addWidget(m_text, 1);
    row->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void MessageBar::show(Severity severity, const QStringList &lines)
{
    m_severity = severity;
    QStringList shown = lines.mid(0, lines.size() > kMaxLines ? kMaxLines - 1 : kMaxLines);
    if (shown.size() < lines.size())
        shown += tr("And %n more.", nullptr, static_cast<int>(lines.size() - shown.size()));
    m_text->setText(shown.join(QLatin1Char('\n')));
    m_text->setToolTip(shown.size() < lines.size() ? lines.join(QLatin1Char('\n')) : QString());
    refresh();
    setVisible(!lines.isEmpty());
}

void MessageBar::refresh()
{
    const bool isError = m_severity == Severity::Error;
    setProperty("severity", isError ? QStringLiteral("error") : QStringLiteral("warning"));
    m_icon->setPixmap(tintedPixmap(isError ? QStringLiteral("err") : QStringLiteral("warn"), 18,
                                   isError ? theme().problem : theme().warning,
                                   devicePixelRatioF()));
    style()->unpolish(this);
    style()->polish(this);
}

QString MessageBar::text() const
{
    return m_text->text();
}

} // namespace fff::ui
