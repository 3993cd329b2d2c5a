#include "ui/properties/choice_box.h"

#include "ui/base/theme.h"

#include <QAbstractItemView>
#include <QCoreApplication>
#include <QHelpEvent>
#include <QPainter>
#include <QPixmapCache>
#include <QStandardItemModel>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolTip>
#include <QWheelEvent>

namespace fff::ui {

namespace {

/// What Fusion leaves free beside the icon, px.
constexpr int kBesideChip = 4;
/// The hint of QComboBox for its size is so much short of what its text takes, and Fusion begins
/// the text so far in, px.
constexpr int kShort = 3, kInset = 1;

/// One for all rows of a colour: a list of sections has hundreds of them.
QPixmap chipPixmap(const QColor &colour, int scale)
{
    constexpr int kSize = 14; // px
    const QString key = QStringLiteral("fff/chip/%1/%2").arg(colour.rgba(), 8, 16).arg(scale);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap))
        return pixmap;
    pixmap = QPixmap(kSize * scale, kSize * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour.darker(160), 1.0));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(1.5, 1.5, kSize - 3.0, kSize - 3.0), 2.0, 2.0);
    painter.end();
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

} // namespace

QIcon colourChip(const QColor &colour)
{
    QIcon icon;
    for (const int scale : {1, 2, 3}) {
        const QPixmap pixmap = chipPixmap(colour, scale);
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

QSize ChoiceBox::sizeHint() const
{
    return QComboBox::sizeHint() + QSize(kShort, 0);
}

void ChoiceBox::showPopup()
{
    for (QWidget *list : {static_cast<QWidget *>(view()), view()->parentWidget()})
        list->setPalette(theme().palette());
    QComboBox::showPopup();
}

/// What is chosen, so much of it as there is room for.
QString ChoiceBox::shownText(const QStyleOptionComboBox &option) const
{
    const QRect field =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    const int chip = option.currentIcon.isNull() ? 0 : option.iconSize.width() + kBesideChip;
    return fontMetrics().elidedText(option.currentText, Qt::ElideRight,
                                    field.width() - chip - kInset);
}

bool ChoiceBox::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip && toolTip().isEmpty()) {
        QStyleOptionComboBox option;
        initStyleOption(&option);
        if (shownText(option) != option.currentText) {
            QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), option.currentText,
                               this);
            return true;
        }
    }
    return QComboBox::event(event);
}

int ChoiceBox::widthForShown() const
{
    ensurePolished();
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const int room =
        style()
            ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this)
            .width();
    const int chip = option.currentIcon.isNull() ? 0 : option.iconSize.width() + kBesideChip;
    return width() - room + chip + 2 * kInset + kShort +
           fontMetrics().horizontalAdvance(option.currentText);
}

/// As QComboBox does it, which cuts a long text off in the middle of a letter.
void ChoiceBox::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    painter.setPen(palette().color(QPalette::Text));
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    if (currentIndex() < 0) {
        option.palette.setBrush(QPalette::ButtonText, option.palette.placeholderText());
        option.currentText = placeholderText();
    }
    option.currentText = shownText(option);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
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
