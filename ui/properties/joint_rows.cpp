#include "ui/properties/joint_rows.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kRowHeight = 26, kGlyph = 16, kGap = 8; // px

} // namespace

class JointRow : public QAbstractButton
{
public:
    explicit JointRow(JointRows *rows) : QAbstractButton(rows), m_rows(rows)
    {
        setFocusPolicy(Qt::StrongFocus);
        setAttribute(Qt::WA_Hover);
        setFixedHeight(kRowHeight);
    }

    void setEntry(const JointRows::Entry &entry)
    {
        m_entry = entry;
        setAccessibleName(QStringLiteral("%1, %2").arg(entry.name, entry.text));
        setToolTip(QStringLiteral("%1\n%2").arg(
            JointRows::tr("Select the joint with %1").arg(entry.name), entry.text));
        update();
    }

    QSize sizeHint() const override { return {100, kRowHeight}; }

protected:
    void enterEvent(QEnterEvent *event) override
    {
        QAbstractButton::enterEvent(event);
        Q_EMIT m_rows->hovered(m_entry.other);
    }
    void leaveEvent(QEvent *event) override
    {
        QAbstractButton::leaveEvent(event);
        Q_EMIT m_rows->hovered({});
    }
    void keyPressEvent(QKeyEvent *event) override
    {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
            click();
        else
            QAbstractButton::keyPressEvent(event);
    }
    void paintEvent(QPaintEvent *) override
    {
        const Theme &t = theme();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        if (underMouse() || isDown()) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(isDown() ? t.soft : t.hover);
            painter.drawRoundedRect(rect(), 3.0, 3.0);
        }
        if (hasFocus()) {
            painter.setPen(QPen(t.accent, 2.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3.0, 3.0);
        }
        const QString icon = m_entry.isProblem ? QStringLiteral("warn") : QStringLiteral("section");
        painter.drawPixmap(4, (height() - kGlyph) / 2,
                           tintedPixmap(icon, kGlyph, m_entry.isProblem ? t.warning : t.muted,
                                        devicePixelRatioF()));
        const QRect words = rect().adjusted(kGlyph + 12, 0, -6, 0);
        const QFontMetrics metrics(font());
        // The name says which joint it is: it keeps half of the row before the kind is cut short.
        const int name = std::min(metrics.horizontalAdvance(m_entry.name), words.width() / 2);
        const int room = words.width() - name - kGap;
        const bool isWhole = metrics.horizontalAdvance(m_entry.text) <= room;
        const QString text =
            metrics.elidedText(isWhole || m_entry.brief.isEmpty() ? m_entry.text : m_entry.brief,
                               Qt::ElideMiddle, room);
        const int right = metrics.horizontalAdvance(text);
        painter.setPen(t.muted);
        painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, text);
        painter.setPen(t.text);
        painter.drawText(
            words, Qt::AlignLeft | Qt::AlignVCenter,
            metrics.elidedText(m_entry.name, Qt::ElideRight, words.width() - right - kGap));
    }

private:
    JointRows *m_rows;
    JointRows::Entry m_entry;
};

JointRows::JointRows(QWidget *parent) : QWidget(parent), m_empty(new QLabel(tr("None yet"), this))
{
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_empty);
    addRow(); // has the place where the Tab key comes to all of them
}

void JointRows::addRow()
{
    auto *row = new JointRow(this);
    const std::size_t index = m_rows.size();
    connect(row, &QAbstractButton::clicked, this,
            [this, index] { Q_EMIT chosen(SectionRef(m_entries[index].other)); });
    layout()->addWidget(row);
    row->hide();
    if (!m_rows.empty())
        setTabOrder(m_rows.back(), row);
    m_rows.push_back(row);
}

void JointRows::setEntries(const std::vector<Entry> &entries)
{
    if (entries == m_entries)
        return;
    m_entries = entries;
    while (m_rows.size() < entries.size())
        addRow();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i]->setVisible(i < entries.size());
        if (i < entries.size())
            m_rows[i]->setEntry(entries[i]);
    }
    m_empty->setVisible(entries.empty());
}

void JointRows::focusRow(const SectionRef &other)
{
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        if (m_entries[i].other == other)
            m_rows[i]->setFocus();
}

} // namespace fff::ui
