// Finds words that cannot be read to their end: what needs more room than it has, is elided, or
// lies outside of what shows it. It asks Qt's own widgets and fonts only.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>

#include <algorithm>

namespace fff::test {

inline int widthOf(const QWidget &widget, const QString &text)
{
    return QFontMetrics(widget.font()).size(Qt::TextShowMnemonic, text).width();
}

inline QString tooNarrow(const QString &text, int needs, int has, const char *what = "wide")
{
    return needs <= has ? QString()
                        : QStringLiteral("\u201C%1\u201D needs %2 px, is %3 px %4")
                              .arg(text.left(60))
                              .arg(needs)
                              .arg(has)
                              .arg(QLatin1String(what));
}

/// A number whose narrow space before the unit has become one where a line may break.
inline QString tornNumber(const QLabel &label)
{
    constexpr QChar kNarrow(0x202f);
    if (label.textFormat() != Qt::RichText || !label.text().contains(kNarrow))
        return {};
    QTextDocument shown;
    shown.setHtml(label.text());
    return shown.toPlainText().count(kNarrow) == label.text().count(kNarrow)
               ? QString()
               : QStringLiteral("\u201C%1\u201D has units that may stand alone in a line")
                     .arg(shown.toPlainText().left(60));
}

/// Japanese and Chinese have no blanks between words.
inline bool breaksAnywhere(const QString &word)
{
    return std::any_of(word.begin(), word.end(), [](QChar c) {
        return c.script() == QChar::Script_Han || c.script() == QChar::Script_Hiragana ||
               c.script() == QChar::Script_Katakana;
    });
}

/// A label's words, in as many lines as it may have.
inline QString cutLabel(const QLabel &label)
{
    if (label.text().isEmpty())
        return {};
    // One that says by its least size that it is cut short has all of it in its tip.
    if (!label.wordWrap() && label.toolTip() == label.text())
        return {};
    if (const QString torn = tornNumber(label); !torn.isEmpty())
        return torn;
    const QSize room = label.size();
    if (!label.wordWrap()) {
        const QSize needs = label.sizeHint();
        const QString cut = tooNarrow(label.text(), needs.width(), room.width());
        return cut.isEmpty() ? tooNarrow(label.text(), needs.height(), room.height(), "high") : cut;
    }
    int word = 0; // the longest one has no place to break
    if (label.textFormat() != Qt::RichText && !label.text().contains(u'<'))
        for (const QString &one : label.text().split(u' '))
            if (!breaksAnywhere(one))
                word = std::max(word, widthOf(label, one));
    const QString cut = tooNarrow(label.text(), word, label.contentsRect().width());
    return cut.isEmpty()
               ? tooNarrow(label.text(), label.heightForWidth(room.width()), room.height(), "high")
               : cut;
}

inline QString cutButton(const QAbstractButton &button)
{
    const auto *tool = qobject_cast<const QToolButton *>(&button);
    if (button.text().isEmpty() || (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly))
        return {};
    const QSize needs = button.sizeHint();
    if (button.hasHeightForWidth())
        return tooNarrow(button.text(), button.heightForWidth(button.width()), button.height(),
                         "high");
    const QString cut = tooNarrow(button.text(), needs.width(), button.width());
    // Fusion's own air may be taken, the letters' height not.
    return cut.isEmpty() ? tooNarrow(button.text(), QFontMetrics(button.font()).height(),
                                     button.height(), "high")
                         : cut;
}

/// Whichever is chosen.
inline QString cutCombo(const QComboBox &box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.subControls = QStyle::SC_All;
    option.editable = box.isEditable();
    option.frame = box.hasFrame();
    const int room =
        box.style()
            ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
            .width();
    for (int i = 0; i < box.count(); ++i) {
        const int icon = box.itemIcon(i).isNull() ? 0 : box.iconSize().width() + 4;
        const QString cut =
            tooNarrow(box.itemText(i), icon + widthOf(box, box.itemText(i)), room - 1);
        if (!cut.isEmpty())
            return cut;
    }
    return {};
}

/// What stands in it, and the longest that usually does.
inline QString cutField(const QAbstractSpinBox &field)
{
    const auto *line = field.findChild<QLineEdit *>();
    QStringList texts{field.text()};
    if (const auto *number = qobject_cast<const QDoubleSpinBox *>(&field)) {
        for (const double usual : {1234.5, -1234.5})
            texts +=
                number->textFromValue(std::clamp(usual, number->minimum(), number->maximum())) +
                number->suffix();
    }
    for (const QString &text : texts) {
        const QString cut = tooNarrow(text, widthOf(*line, text), line->width() - 4);
        if (!cut.isEmpty())
            return cut;
    }
    return tooNarrow(field.text(), QFontMetrics(field.font()).height(), line->height(), "high");
}

/// One that is an icon until it is in front says its name in its tip.
inline QString cutTabs(const QTabBar &bar)
{
    for (int i = 0; i < bar.count(); ++i) {
        const bool isIcon = !bar.tabIcon(i).isNull() && i != bar.currentIndex() &&
                            bar.tabToolTip(i) == bar.tabText(i);
        const int needs = isIcon ? bar.iconSize().width() : widthOf(bar, bar.tabText(i));
        const QString cut = tooNarrow(bar.tabText(i), needs + 12, bar.tabRect(i).width());
        if (!cut.isEmpty())
            return cut;
        if (!bar.rect().contains(bar.tabRect(i).adjusted(2, 2, -2, -2)))
            return QStringLiteral("the tab \u201C%1\u201D is out of sight").arg(bar.tabText(i));
    }
    return {};
}

/// The rows that are in sight; names that a person gives may be cut, ours are not that long.
inline QString cutRows(const QAbstractItemView &view)
{
    if (view.horizontalScrollBar()->maximum() > 0)
        return QStringLiteral("scrolls aside");
    QModelIndex index = view.indexAt(view.viewport()->rect().topLeft() + QPoint(2, 2));
    const int columns = index.isValid() ? view.model()->columnCount(index.parent()) : 0;
    for (int row = 0; index.isValid() && row < 60; ++row) {
        for (int column = 0; column < columns; ++column) {
            const QModelIndex cell = index.siblingAtColumn(column);
            const QString text = cell.data().toString().trimmed(); // air at its end
            const QRect place = view.visualRect(cell);
            if (text.isEmpty() || place.isEmpty())
                continue;
            const bool hasIcon = !cell.data(Qt::DecorationRole).isNull();
            QFont font = view.font();
            if (const QVariant own = cell.data(Qt::FontRole); own.isValid())
                font = own.value<QFont>();
            const int needs = QFontMetrics(font).horizontalAdvance(text) +
                              (hasIcon ? view.iconSize().width() + 4 : 0) + 6;
            QString cut = tooNarrow(text, needs, place.width());
            if (cut.isEmpty())
                cut = tooNarrow(text, QFontMetrics(font).height(), place.height(), "high");
            if (!cut.isEmpty())
                return cut;
        }
        const QRect place = view.visualRect(index);
        index = view.indexAt({place.left() + 2, place.bottom() + 3});
    }
    return {};
}

inline QString cutHeader(const QHeaderView &header)
{
    for (int i = 0; i < header.count() && header.orientation() == Qt::Horizontal; ++i) {
        const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
        const QString cut = tooNarrow(text, widthOf(header, text) + 8, header.sectionSize(i));
        if (!header.isSectionHidden(i) && !cut.isEmpty())
            return cut;
    }
    return {};
}

/// By its own size.
inline QString cutByItself(const QWidget &widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        return cutLabel(*label);
    if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
        return cutButton(*button);
    if (const auto *box = qobject_cast<const QComboBox *>(&widget))
        return cutCombo(*box);
    if (const auto *field = qobject_cast<const QAbstractSpinBox *>(&widget))
        return cutField(*field);
    if (const auto *tabs = qobject_cast<const QTabBar *>(&widget))
        return cutTabs(*tabs);
    if (const auto *header = qobject_cast<const QHeaderView *>(&widget))
        return cutHeader(*header);
    if (const auto *view = qobject_cast<const QAbstractItemView *>(&widget))
        return cutRows(*view);
    if (const auto *group = qobject_cast<const QGroupBox *>(&widget))
        return tooNarrow(group->title(), widthOf(*group, group->title()) + 8, group->width());
    const auto *line = qobject_cast<const QLineEdit *>(&widget);
    if (line && line->text().isEmpty())
        return tooNarrow(line->placeholderText(), widthOf(*line, line->placeholderText()) + 8,
                         line->width());
    return {};
}

/// Whether what holds it shows all of it, at once or after scrolling up and down.
inline QString outOfSight(const QWidget &widget)
{
    bool isScrolled = false;
    for (const QWidget *of = widget.parentWidget(); of; of = of->parentWidget()) {
        const QRect place(widget.mapTo(of, QPoint()), widget.size());
        if (place.left() < 0 || place.right() >= of->width())
            return QStringLiteral("reaches %1 \u2026 %2 of %3 px across %4")
                .arg(place.left())
                .arg(place.right() + 1)
                .arg(of->width())
                .arg(of->objectName());
        const auto *area = qobject_cast<const QAbstractScrollArea *>(of->parentWidget());
        if (area && area->viewport() == of && area->verticalScrollBar()->maximum() > 0)
            isScrolled = true;
        if (!isScrolled && (place.top() < 0 || place.bottom() >= of->height()))
            return QStringLiteral("reaches %1 \u2026 %2 of %3 px down %4")
                .arg(place.top())
                .arg(place.bottom() + 1)
                .arg(of->height())
                .arg(of->objectName());
        if (of->isWindow())
            break;
    }
    return {};
}

inline bool hasWords(const QWidget &widget)
{
    const auto *label = qobject_cast<const QLabel *>(&widget);
    return (label && !label->text().isEmpty()) || qobject_cast<const QAbstractButton *>(&widget) ||
           qobject_cast<const QComboBox *>(&widget) ||
           qobject_cast<const QAbstractSpinBox *>(&widget) ||
           qobject_cast<const QTabBar *>(&widget);
}

/// What Qt keeps beside the window: docks behind the tabs of others, and tabs that nobody needs.
inline bool isPutAside(const QWidget &widget)
{
    const QWidget *window = widget.window();
    for (const QWidget *of = &widget; of != window; of = of->parentWidget())
        if (of->parentWidget() == window &&
            !window->rect().intersects(QRect(of->pos(), of->size())))
            return true;
    return false;
}

/// A line for each of what is in sight under `top`: its name and what is wrong.
inline QStringList cutTexts(const QWidget &top)
{
    QStringList cuts;
    for (const QWidget *widget : top.findChildren<QWidget *>()) {
        if (!widget->isVisible() || widget->window() != top.window() || isPutAside(*widget))
            continue;
        const QString name = widget->objectName();
        QString cut = cutByItself(*widget);
        if (cut.isEmpty() && hasWords(*widget) && !name.startsWith(QStringLiteral("qt_spinbox")))
            cut = outOfSight(*widget);
        // Qt's own button for what finds no place on a bar.
        if (name == QStringLiteral("qt_toolbar_ext_button") ||
            name == QStringLiteral("qt_menubar_ext_button"))
            cut = QStringLiteral("there is no place for all of the bar");
        if (cut.isEmpty())
            continue;
        const auto *dock = widget->parentWidget();
        while (dock && !qobject_cast<const QDockWidget *>(dock))
            dock = dock->parentWidget();
        QString owner = name;
        for (const QWidget *of = widget->parentWidget(); owner.isEmpty() && of;
             of = of->parentWidget())
            owner = of->objectName() + u'/';
        cuts += QStringLiteral("%1 %2 in %3: %4")
                    .arg(QLatin1String(widget->metaObject()->className()), owner,
                         dock ? dock->objectName() : top.objectName(), cut);
    }
    return cuts;
}

} // namespace fff::test
