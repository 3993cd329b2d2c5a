#include "ui/properties/choice_box.h"

#include "ui/theme.h"

#include <QAbstractItemView>
#include <QCoreApplication>
#include <QPainter>
#include <QStandardItemModel>
#include <QWheelEvent>

namespace fff::ui {

QIcon colourChip(const QColor &colour)
{
    constexpr int kSize = 14; // px
    QIcon icon;
    for (int scale : {1, 2, 3}) {
        QPixmap pixmap(kSize * scale, kSize * scale);
        pixmap.setDevicePixelRatio(scale);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(colour.darker(160), 1.0));
        painter.setBrush(colour);
        painter.drawRoundedRect(QRectF(1.5, 1.5, kSize - 3.0, kSize - 3.0), 2.0, 2.0);
        painter.end();
        icon.addPixmap(pixmap);
        icon.addPixmap(pixmap, QIcon::Selected); // not tinted
    }
    return icon;
}

ChoiceBox::ChoiceBox(QWidget *parent) : QComboBox(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setPlaceholderText(QCoreApplication::translate("fff::ui::NumberEdit", "mixed"));
    setIconSize({14, 14});
}

void ChoiceBox::setChoices(const Choices &choices)
{
    if (m_shown != choices.all) {
        m_shown = choices.all;
        clear();
        for (const Choice &choice : choices.all) {
            addItem(choice.colour.isValid() ? colourChip(choice.colour) : QIcon(), choice.text);
            if (choice.whyNot.isEmpty())
                continue;
            setItemData(count() - 1, choice.whyNot, Qt::ToolTipRole);
            setItemData(count() - 1, choice.whyNot, Qt::AccessibleDescriptionRole);
            if (auto *items = qobject_cast<QStandardItemModel *>(model()))
                items->item(count() - 1)->setEnabled(false);
        }
    }
    if (currentIndex() != choices.current)
        setCurrentIndex(choices.current);
    QFont words = font();
    if (words.italic() != (choices.current < 0)) { // "mixed" is a word about the box
        words.setItalic(choices.current < 0);
        setFont(words);
    }
}

void ChoiceBox::showPopup()
{
    for (QWidget *list : {static_cast<QWidget *>(view()), view()->parentWidget()})
        list->setPalette(theme().palette());
    QComboBox::showPopup();
}

void ChoiceBox::wheelEvent(QWheelEvent *event)
{
    // Scrolling a panel must not change what is chosen on the way.
    if (hasFocus())
        QComboBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace fff::ui
