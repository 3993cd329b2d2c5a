#include "ui/docks/two_lines.h"

#include "ui/base/theme.h"

#include <QApplication>
#include <QPainter>

#include <utility>

namespace fff::ui {

namespace {

constexpr int kSecondFont = 12, kLineGap = 1, kEditorMargin = 4; // px

struct Lines
{
    QRect name, second;
};

/// Both as high as their fonts, in the middle of the row.
Lines linesIn(const QRect &room, const QFontMetrics &name, const QFontMetrics &second)
{
    const int height = name.height() + kLineGap + second.height();
    const int top = room.top() + (room.height() - height) / 2;
    return {{room.left(), top, room.width(), name.height()},
            {room.left(), top + name.height() + kLineGap, room.width(), second.height()}};
}

QFont secondFont(QFont font)
{
    font.setPixelSize(kSecondFont);
    return font;
}

} // namespace

void TwoLines::paint(QPainter *painter, const QStyleOptionViewItem &option,
                     const QModelIndex &index) const
{
    const QString second = index.data(kSecondLineRole).toString();
    if (second.isEmpty()) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    const QStyle *style = row.widget ? row.widget->style() : QApplication::style();
    const QRect room = style->subElementRect(QStyle::SE_ItemViewItemText, &row, row.widget);
    const QString name = std::exchange(row.text, QString());
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);

    const bool isChosen = row.state.testFlag(QStyle::State_Selected);
    const QFont small = secondFont(row.font);
    const QFontMetrics ofName(row.font), ofSecond(small);
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &row, row.widget) + 1;
    const Lines lines = linesIn(room.adjusted(margin, 0, -margin, 0), ofName, ofSecond);
    painter->save();
    painter->setFont(row.font);
    painter->setPen(row.palette.color(isChosen ? QPalette::HighlightedText : QPalette::Text));
    painter->drawText(lines.name, Qt::AlignLeft | Qt::AlignVCenter,
                      ofName.elidedText(name, Qt::ElideRight, lines.name.width()));
    painter->setFont(small);
    if (!isChosen)
        painter->setPen(theme().muted);
    painter->drawText(lines.second, Qt::AlignLeft | Qt::AlignVCenter,
                      ofSecond.elidedText(second, Qt::ElideRight, lines.second.width()));
    painter->restore();
}

void TwoLines::updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                                    const QModelIndex &index) const
{
    QStyledItemDelegate::updateEditorGeometry(editor, option, index);
    if (index.data(kSecondLineRole).toString().isEmpty())
        return;
    const QRect room = editor->geometry();
    const Lines lines =
        linesIn(room, QFontMetrics(option.font), QFontMetrics(secondFont(option.font)));
    editor->setGeometry(lines.name.adjusted(0, -kEditorMargin, 0, kEditorMargin));
}

} // namespace fff::ui
