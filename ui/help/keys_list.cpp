#include "ui/help/keys_list.h"

#include "ui/view/heading_weight.h"
#include "ui/view/steps_paper.h"

#include <QAction>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>

#include <algorithm>

namespace fff::ui {

namespace {

struct KeysListTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::KeysList)
};

KeyGroup handGroup()
{
    return {KeysListTexts::tr("In the view"),
            {{KeysListTexts::tr("Draw the first section"), KeysListTexts::tr("drag in the middle")},
             {KeysListTexts::tr("Draw a section across another one"),
              KeysListTexts::tr("drag out of it, go on")},
             {KeysListTexts::tr("Turn the view"), KeysListTexts::tr("drag beside the model")},
             {KeysListTexts::tr("Come nearer"), KeysListTexts::tr("wheel")},
             {KeysListTexts::tr("Move the view"), KeysListTexts::tr("drag with the middle button")},
             {KeysListTexts::tr("Select"), KeysListTexts::tr("click")},
             {KeysListTexts::tr("Select a group"), KeysListTexts::tr("Shift and drag")},
             {KeysListTexts::tr("Do what can be done with it"), KeysListTexts::tr("right click")},
             {KeysListTexts::tr("Add a point"), KeysListTexts::tr("double click on the contour")},
             {KeysListTexts::tr("Draw without snapping"), KeysListTexts::tr("hold Ctrl")}}};
}

constexpr double kMargin = 12.0, kGutter = 6.0;      // mm
constexpr double kLargest = 10.0, kSmallest = 4.0;   // pt
constexpr double kFiner = 0.25;                      // pt
constexpr double kLineHeight = 1.28, kHeading = 1.9; // of the font's size
constexpr int kColumns = 4, kDotsPerInch = 1200;

/// Fills columns from above, as long as there is room.
class Sheet
{
public:
    Sheet(QPainter &painter, const QRectF &room, double points)
        : m_painter(painter), m_room(room), m_em(points * kDotsPerInch / 72.0),
          m_width((room.width() - (kColumns - 1) * mm(kGutter)) / kColumns)
    {
        m_plain = painter.font();
        m_plain.setPointSizeF(points);
        m_bold = m_plain;
        m_bold.setWeight(headingWeight());
    }

    static double mm(double length) { return length * kDotsPerInch / 25.4; }

    /// False: there is no room for all of it, or words are wider than a column.
    bool put(const QList<KeyGroup> &groups, bool isDrawn)
    {
        m_at = m_room.topLeft();
        for (const KeyGroup &group : groups) {
            if (m_at.y() > m_room.top())
                m_at.ry() += 0.5 * m_em;
            if (!hasRoom(kHeading * m_em + kLineHeight * m_em)) // a heading has a row below it
                return false;
            draw(group.title, m_bold, Qt::AlignLeft, kHeading * m_em, isDrawn);
            m_at.ry() += kHeading * m_em;
            for (const auto &[what, keys] : group.rows) {
                if (!hasRoom(kLineHeight * m_em))
                    return false;
                const double taken = QFontMetricsF(m_plain).horizontalAdvance(what) +
                                     QFontMetricsF(m_bold).horizontalAdvance(keys);
                if (taken + m_em > m_width)
                    return false;
                draw(what, m_plain, Qt::AlignLeft, kLineHeight * m_em, isDrawn);
                draw(keys, m_bold, Qt::AlignRight, kLineHeight * m_em, isDrawn);
                m_at.ry() += kLineHeight * m_em;
            }
        }
        return true;
    }

private:
    bool hasRoom(double height)
    {
        if (m_at.y() + height <= m_room.bottom())
            return true;
        m_at = {m_at.x() + m_width + mm(kGutter), m_room.top()};
        return m_at.x() + m_width <= m_room.right() + 1.0;
    }
    void draw(const QString &text, const QFont &font, Qt::Alignment side, double height,
              bool isDrawn)
    {
        if (!isDrawn)
            return;
        m_painter.setFont(font);
        m_painter.drawText(QRectF(m_at, QSizeF(m_width, height)), Qt::AlignBottom | side, text);
    }

    QPainter &m_painter;
    const QRectF m_room;
    const double m_em, m_width; // dots
    QFont m_plain, m_bold;
    QPointF m_at;
};

} // namespace

QList<KeyGroup> keyGroups(const QList<ListedAction> &actions)
{
    QList<KeyGroup> groups{handGroup()};
    for (const ListedAction &listed : actions) {
        if (!listed.action || listed.action->shortcut().isEmpty())
            continue;
        const QString title = listed.menuPath.section(QStringLiteral(" › "), 0, 0);
        auto group = std::find_if(groups.begin() + 1, groups.end(),
                                  [&title](const KeyGroup &one) { return one.title == title; });
        if (group == groups.end())
            group = groups.insert(groups.end(), {title, {}});
        const std::pair row(listed.name,
                            listed.action->shortcut().toString(QKeySequence::NativeText));
        if (!group->rows.contains(row)) // some stand in several places
            group->rows += row;
    }
    return groups;
}

QString keysHtml(const QList<KeyGroup> &groups)
{
    QString html =
        QStringLiteral("<h1>%1</h1><p><a href=\"action:cheat-sheet\">%2</a></p>")
            .arg(KeysListTexts::tr("Keys"), KeysListTexts::tr("Save them as a page to print…"));
    for (const KeyGroup &group : groups) {
        html += QStringLiteral("<h2>%1</h2><table width=\"100%\" cellpadding=\"2\">")
                    .arg(group.title.toHtmlEscaped());
        for (const auto &[what, keys] : group.rows)
            html += QStringLiteral("<tr><td width=\"65%\">%1</td><td><b>%2</b></td></tr>")
                        .arg(what.toHtmlEscaped(), keys.toHtmlEscaped());
        html += QStringLiteral("</table>");
    }
    return html;
}

bool writeCheatSheet(const QString &path, const QList<KeyGroup> &groups)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    QPdfWriter writer(&file);
    writer.setTitle(QStringLiteral("FlatFitFab"));
    writer.setCreator(QStringLiteral("FlatFitFab"));
    writer.setResolution(kDotsPerInch);
    writer.setPageLayout({QPageSize(StepsPaper::usualSize(QLocale())), QPageLayout::Landscape,
                          QMarginsF(kMargin, kMargin, kMargin, kMargin), QPageLayout::Millimeter});
    QPainter painter(&writer);
    QRectF room(0.0, 0.0, writer.width(), writer.height());
    QFont title = painter.font();
    title.setPointSizeF(16.0);
    title.setWeight(headingWeight());
    painter.setFont(title);
    const double head = Sheet::mm(10.0);
    painter.drawText(QRectF(0.0, 0.0, room.width(), head), Qt::AlignLeft | Qt::AlignTop,
                     QStringLiteral("FlatFitFab"));
    room.setTop(head);
    // As large as all of it has room.
    double points = kLargest;
    while (points > kSmallest && !Sheet(painter, room, points).put(groups, false))
        points -= kFiner;
    Sheet(painter, room, points).put(groups, true);
    painter.end();
    return file.commit();
}

} // namespace fff::ui
