#include "ui/base/sentence_label.h"

#include "ui/base/theme.h"
#include "ui/view/heading_weight.h"

#include <QPainter>

namespace fff::ui {

namespace {

constexpr int kKeyMargin = 5; // px, inside a key's border
constexpr int kKeyGap = 2;    // px, outside of it

QString unescaped(const QString &text)
{
    if (!text.contains(u'&'))
        return text;
    QString plain = text;
    return plain.replace(QStringLiteral("&lt;"), QStringLiteral("<"))
        .replace(QStringLiteral("&gt;"), QStringLiteral(">"))
        .replace(QStringLiteral("&quot;"), QStringLiteral("\""))
        .replace(QStringLiteral("&amp;"), QStringLiteral("&"));
}

} // namespace

SentenceLabel::SentenceLabel(QWidget *parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void SentenceLabel::setSentence(const QString &marked)
{
    m_runs.clear();
    QString whole;
    Kind kind = Kind::Plain;
    qsizetype at = 0;
    while (at < marked.size()) {
        qsizetype mark = marked.indexOf(u'<', at);
        if (mark < 0)
            mark = marked.size();
        if (mark > at) {
            m_runs.push_back({unescaped(marked.mid(at, mark - at)), kind});
            whole += m_runs.back().text;
        }
        const qsizetype end = marked.indexOf(u'>', mark);
        if (mark == marked.size() || end < 0)
            break;
        const QStringView tag = QStringView(marked).mid(mark + 1, end - mark - 1);
        kind = tag == QStringLiteral("b")     ? Kind::Bold
               : tag == QStringLiteral("kbd") ? Kind::Key
                                              : Kind::Plain;
        at = end + 1;
    }
    QLabel::setText(whole);
    refreshTip();
    update();
}

QFont SentenceLabel::fontOf(Kind kind) const
{
    QFont f = font();
    if (kind != Kind::Plain)
        f.setWeight(headingWeight());
    if (kind == Kind::Key && f.pointSizeF() > 0)
        f.setPointSizeF(f.pointSizeF() * 0.85);
    return f;
}

int SentenceLabel::widthOf(const Run &run) const
{
    const int words = QFontMetrics(fontOf(run.kind)).horizontalAdvance(run.text);
    return run.kind == Kind::Key ? words + 2 * (kKeyMargin + kKeyGap) : words;
}

bool SentenceLabel::isCutShort() const
{
    int sum = 0;
    for (const Run &run : m_runs)
        sum += widthOf(run);
    return sum > contentsRect().width();
}

void SentenceLabel::refreshTip()
{
    setToolTip(isCutShort() ? text() : QString());
}

QSize SentenceLabel::minimumSizeHint() const
{
    return {0, QLabel::minimumSizeHint().height()};
}

void SentenceLabel::resizeEvent(QResizeEvent *event)
{
    QLabel::resizeEvent(event);
    refreshTip();
}

void SentenceLabel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(foregroundRole()));
    const QRect all = contentsRect();
    const bool cut = isCutShort();
    const int ellipsis = cut ? fontMetrics().horizontalAdvance(QChar(0x2026)) : 0;
    int x = all.left();
    for (const Run &run : m_runs) {
        const int width = widthOf(run), room = all.right() + 1 - x - ellipsis;
        const QFont f = fontOf(run.kind);
        painter.setFont(f);
        QRect place(x, all.top(), width, all.height());
        if (cut && width > room) {
            place.setRight(all.right());
            const QString part = run.kind == Kind::Key
                                     ? QString(QChar(0x2026))
                                     : QFontMetrics(f).elidedText(run.text + QChar(0x2026),
                                                                  Qt::ElideRight, room + ellipsis);
            painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, part);
            return;
        }
        if (run.kind == Kind::Key) {
            const int height = QFontMetrics(f).height() + 2;
            QRectF cap(x + kKeyGap, all.center().y() - height / 2.0 + 0.5, width - 2 * kKeyGap,
                       height);
            painter.setPen(QPen(theme().strong, 1.0));
            painter.setBrush(theme().panel);
            painter.drawRoundedRect(cap.adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
            painter.setPen(palette().color(foregroundRole()));
            painter.drawText(cap, Qt::AlignCenter, run.text);
        } else {
            painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                             run.text);
        }
        x += width;
    }
}

} // namespace fff::ui
