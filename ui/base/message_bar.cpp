#include "ui/base/message_bar.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <initializer_list>
#include <memory>
#include <utility>

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
    m_details = new QLabel(this);
    m_details->setObjectName(QStringLiteral("messageDetails"));
    m_details->setTextFormat(Qt::PlainText);
    m_details->setWordWrap(true);
    m_details->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_unfold = new QPushButton(tr("Details"), this);
    m_unfold->setObjectName(QStringLiteral("messageUnfold"));
    m_unfold->setCheckable(true);
    connect(m_unfold, &QPushButton::toggled, m_details, &QWidget::setVisible);
    m_close = new QToolButton(this);
    m_close->setObjectName(QStringLiteral("closeMessage"));
    m_close->setIcon(themedIcon(QStringLiteral("close")));
    m_close->setIconSize({16, 16});
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(tr("Close this message"));
    connect(m_close, &QToolButton::clicked, this, &MessageBar::close);

    auto *words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(m_text);
    words->addWidget(m_details);
    words->addStretch();
    m_verbRow = new QHBoxLayout;
    m_verbRow->setSpacing(8);
    m_verbRow->addWidget(m_unfold);
    auto *verbs = new QVBoxLayout;
    verbs->addLayout(m_verbRow);
    verbs->addStretch();
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 12, 8);
    row->setSpacing(12);
    row->addWidget(m_icon, 0, Qt::AlignTop);
    row->addLayout(words, 1);
    row->addLayout(verbs);
    row->addWidget(m_close, 0, Qt::AlignTop);
    hide();
}

void MessageBar::show(Severity severity, const QStringList &lines, std::vector<Verb> verbs,
                      const QString &details)
{
    if (lines.isEmpty())
        return dismiss();
    if (m_offer && !isHidden())
        m_next.insert(m_next.begin(), std::move(m_offer));
    m_offer = nullptr;
    m_severity = severity;
    QStringList shown = lines.mid(0, lines.size() > kMaxLines ? kMaxLines - 1 : kMaxLines);
    if (shown.size() < lines.size())
        shown += tr("And %n more.", nullptr, static_cast<int>(lines.size() - shown.size()));
    m_text->setText(shown.join(QLatin1Char('\n')));
    m_text->setToolTip(shown.size() < lines.size() ? lines.join(QLatin1Char('\n')) : QString());
    m_details->setText(shortened(details));
    m_details->hide();
    m_unfold->setChecked(false);
    m_unfold->setVisible(!details.isEmpty());
    setVerbs(std::move(verbs));
    refresh();
    setVisible(true);
}

QString MessageBar::shortened(const QString &details)
{
    const QStringList lines = details.split(u'\n');
    if (lines.size() <= kMaxDetails)
        return details;
    const auto left = static_cast<int>(lines.size() - kMaxDetails + 1);
    return (lines.mid(0, kMaxDetails - 1) << tr("And %n more.", nullptr, left)).join(u'\n');
}

void MessageBar::showNext(Severity severity, const QStringList &lines, std::vector<Verb> verbs)
{
    // Itself again where it comes back.
    const auto offer = std::make_shared<std::function<void()>>();
    *offer = [this, severity, lines, verbs = std::move(verbs), again = std::weak_ptr(offer)] {
        const auto itself = again.lock();
        show(severity, lines, verbs);
        m_offer = [itself] { (*itself)(); };
    };
    if (isHidden())
        (*offer)();
    else
        m_next.push_back([offer] { (*offer)(); });
}

void MessageBar::dismiss()
{
    if (!m_offer)
        close();
}

void MessageBar::close()
{
    hide();
    m_offer = nullptr;
    if (m_next.empty())
        return;
    const std::function<void()> next = std::move(m_next.front());
    m_next.erase(m_next.begin());
    next();
}

void MessageBar::setVerbs(std::vector<Verb> verbs)
{
    for (QPushButton *old : m_verbs) {
        old->hide();
        old->deleteLater(); // it may be the one that was pressed
    }
    m_verbs.clear();
    int place = 0;
    for (Verb &verb : verbs) {
        auto *button = new QPushButton(verb.text, this);
        button->setObjectName(QStringLiteral("messageVerb"));
        connect(button, &QPushButton::clicked, this, [this, act = std::move(verb.act)] {
            const auto does = act; // outlives the button
            close();
            does();
        });
        m_verbRow->insertWidget(place++, button);
        button->show();
        m_verbs.push_back(button);
    }
}

void MessageBar::refresh()
{
    // A single line stands level with the buttons beside it.
    for (QWidget *inFirstLine : std::initializer_list<QWidget *>{m_icon, m_text, m_close})
        inFirstLine->setMinimumHeight(m_unfold->sizeHint().height());
    struct Look
    {
        QString name, icon;
        QColor colour;
    };
    const auto look = [this]() -> Look {
        switch (m_severity) {
        case Severity::Info:
            return {QStringLiteral("info"), QStringLiteral("about"), theme().accent};
        case Severity::Warning:
            return {QStringLiteral("warning"), QStringLiteral("warn"), theme().warning};
        case Severity::Error:
            break;
        }
        return {QStringLiteral("error"), QStringLiteral("err"), theme().problem};
    }();
    setProperty("severity", look.name);
    m_icon->setPixmap(tintedPixmap(look.icon, 18, look.colour, devicePixelRatioF()));
    style()->unpolish(this);
    style()->polish(this);
}

QString MessageBar::text() const
{
    return m_text->text();
}

QString MessageBar::details() const
{
    return m_details->text();
}

} // namespace fff::ui
